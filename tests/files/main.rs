//! Project files as a user meets them: opened, refused, edited, saved.

mod grid;
mod opening;
mod property;
mod refused;
mod rendering;
mod samples;
mod saving;

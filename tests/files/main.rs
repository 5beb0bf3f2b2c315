//! Project files as a user meets them: opened, refused, edited, saved.

mod opening;
mod property;
mod refused;
mod rendering;
mod samples;
mod saving;

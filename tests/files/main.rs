//! Project files as a user meets them: opened, refused, edited, saved.

mod saving;

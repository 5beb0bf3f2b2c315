//! Screens by styled snapshot, and edits by key script.

mod adopting;
mod canned;
mod checks;
mod desk;
mod empty;
mod grid;
mod harness;
mod job;
mod new_user;
mod readme;
mod scripts;
mod snapshots;
mod studies;

//! Screens by styled snapshot, and edits by key script.

mod harness;
mod scripts;
mod snapshots;
mod traffic;

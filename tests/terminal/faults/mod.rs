//! Faults that were found in use or by attack, each in a file of its own: what was seen, why, and the
//! test that fails where it comes back.

mod aborts;
mod bad_start;
mod bursts;
mod cases;
mod cursor;
mod disk_faults;
mod empty_project;
mod home;
mod late_answers;
mod more_signals;
mod old_edits;
mod pastes;
mod pictures;
mod reload;
mod resize_in_paste;
mod split_sequences;
mod stopped_from_outside;
mod two_sessions;

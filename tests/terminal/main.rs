//! The program in a real pseudo-terminal: what it sends, and how it leaves the terminal behind.
#![cfg(unix)]

mod attack;
mod cost;
mod desk;
mod drawing;
mod endings;
mod faults;
mod new_user;
mod program;
mod projects;
mod pty;
mod stopping;
mod toy;

//! Seen: `:w ~/t.ron` was refused, because there is no directory of that name.
//!
//! Cause: a `~` that no shell has seen was taken as a name.

use crate::program::with_sample;

#[test]
fn a_typed_tilde_is_the_home_directory() {
    let (launch, _) = with_sample();
    let home = launch.home();
    let elsewhere = tempfile::tempdir().unwrap();
    let launch = launch.env("HOME", elsewhere.path());
    let pty = launch.start();
    pty.wait_for("bench 1");
    pty.send(":w ~/t.ron\r");
    pty.wait_for("saved");
    assert!(elsewhere.path().join("t.ron").is_file());
    pty.send(":export table ~/t.csv\r");
    pty.wait_for("written");
    assert!(elsewhere.path().join("t.csv").is_file());
    pty.send(":open ~/t.ron\r");
    pty.wait_for("opened");
    assert!(!home.join("~").exists());
}

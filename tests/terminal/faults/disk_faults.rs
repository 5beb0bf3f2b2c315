//! Seen: a save said "saved" though the directory could not be brought to the disk after the rename, so
//! that the file could be gone with the power.
//!
//! Cause: that error was passed over, with those of disks that cannot do it at all.

use crate::pty::{Launch, PATIENCE, Pty};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};
use tempfile::TempDir;

const SAMPLE: &str = include_str!("../../../projects/road-cut.ron");

/// System calls of a program's threads that fail, each thread's counted by itself, until this is dropped.
struct Fault(Child);

impl Fault {
    /// Nothing where the machine has no strace or does not let it look.
    fn on(pty: &Pty, fault: &str) -> Option<Fault> {
        let id = pty.id().to_string();
        let arguments = ["-f", "-q", "-o", "/dev/null", "-e", fault, "-p", &id];
        let strace = Command::new("strace").args(arguments).stderr(Stdio::null()).spawn();
        let mut fault = Fault(strace.ok()?);
        let mut gone = false;
        wait_until("strace looks", || {
            gone = fault.0.try_wait().unwrap().is_some();
            gone || looked_at(&id)
        });
        if gone {
            println!("skipped: system calls cannot be made to fail here");
        }
        (!gone).then_some(fault)
    }
}

impl Drop for Fault {
    fn drop(&mut self) {
        // The system lets go of the program then, which goes on.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Whether something looks at every thread of a process.
fn looked_at(id: &str) -> bool {
    let Ok(threads) = fs::read_dir(format!("/proc/{id}/task")) else { return false };
    threads.flatten().all(|thread| {
        let status = fs::read_to_string(thread.path().join("status")).unwrap_or_default();
        !status.contains("TracerPid:\t0\n")
    })
}

fn wait_until(what: &str, mut is_so: impl FnMut() -> bool) {
    let start = Instant::now();
    while !is_so() {
        assert!(start.elapsed() < PATIENCE, "waited until {what}");
        thread::sleep(Duration::from_millis(5));
    }
}

/// The program on a project with an edit.
fn edited() -> (TempDir, PathBuf, Pty) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    let launch = Launch::meshcast().env("MESHCAST_DATA_DIR", dir.path().join("data")).arg(&path);
    let pty = launch.size(160, 30).start();
    pty.wait_for("bench 1");
    pty.send("\x1b[B");
    pty.settle();
    pty.send("2.61\r");
    pty.wait_for("site.ron *");
    // The edits are kept first, so that it is the save alone that fails.
    wait_until("the edits are kept", || path.with_file_name(".site.ron.recovery").exists());
    (dir, path, pty)
}

/// What a save has left beside the project.
fn drafts(path: &Path) -> Vec<String> {
    let names = fs::read_dir(path.parent().unwrap()).unwrap();
    names
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.starts_with(".site.ron.") && name.ends_with(".saving"))
        .collect()
}

#[test]
fn a_directory_that_does_not_reach_the_disk_is_told() {
    let (_dir, path, pty) = edited();
    // The first one is that of the file, the second that of its directory.
    let Some(_fault) = Fault::on(&pty, "inject=fsync:error=EIO:when=2") else { return };
    pty.send("\x13");
    pty.wait_for("the disk did not confirm it");
    assert!(fs::read_to_string(&path).unwrap().contains("L: 2.61"));
}

/// Seen: of a save to a network drive that had gone nothing was said, and the session could not go on.
#[test]
fn a_save_that_takes_long_is_told_and_keeps_neither_keys_nor_the_end_waiting() {
    let (dir, path, mut pty) = edited();
    // Far longer than the test; its threads end with the program.
    let slow = "inject=rename,renameat,renameat2:delay_enter=300000000";
    let Some(fault) = Fault::on(&pty, slow) else { return };
    pty.send("\x13");
    pty.wait_for("still saving, ");
    pty.send("i");
    pty.wait_for("inputs ");
    pty.send("\x1b");
    pty.wait_for("s; the edits are kept, quitting is possible");
    pty.send("q");
    pty.wait_for("asked again it quits at once");
    pty.send("q");
    // What strace keeps waiting ends with strace alone.
    let status = format!("/proc/{}/status", pty.id());
    wait_until("the program ends", || {
        fs::read_to_string(&status).is_ok_and(|status| status.contains("State:\tZ"))
    });
    drop(fault);
    pty.wait_exit();
    pty.assert_restored();
    // It was not known to be saved, and is offered.
    assert_eq!(fs::read_to_string(&path).unwrap(), SAMPLE);
    let again = Launch::meshcast().env("MESHCAST_DATA_DIR", dir.path().join("data")).arg(&path);
    again.size(160, 30).start().wait_for("2.61");
}

#[test]
fn a_save_that_fails_leaves_the_old_file_and_no_draft() {
    for (fault, said) in [
        ("inject=fsync:error=ENOSPC:when=1", "the disk is full; nothing was changed"),
        ("inject=renameat,renameat2,rename:error=EIO:when=1", "nothing was changed"),
    ] {
        let (_dir, path, pty) = edited();
        let Some(fault) = Fault::on(&pty, fault) else { return };
        pty.send("\x13");
        pty.wait_for(said);
        assert_eq!(fs::read_to_string(&path).unwrap(), SAMPLE);
        assert_eq!(drafts(&path), Vec::<String>::new());
        drop(fault);
        // The next one works.
        pty.send("\x13");
        pty.wait_for("saved ");
        assert!(fs::read_to_string(&path).unwrap().contains("L: 2.61"));
    }
}

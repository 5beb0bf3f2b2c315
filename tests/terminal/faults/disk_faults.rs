//! Seen: a save said "saved" though the directory could not be brought to the disk after the rename, so
//! that the file could be gone with the power.
//!
//! Cause: that error was passed over, with those of disks that cannot do it at all.

use crate::pty::{Launch, Pty};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

const SAMPLE: &str = include_str!("../../../projects/road-cut.ron");

/// The program on a project, with a system call of each of its threads failing once. Nothing where the
/// machine has no strace or does not let it look.
fn with_fault(fault: &str) -> Option<(TempDir, PathBuf, Pty)> {
    let allowed = Command::new("strace").args(["-f", "-o", "/dev/null", "true"]).status();
    if !allowed.is_ok_and(|status| status.success()) {
        println!("skipped: system calls cannot be made to fail here");
        return None;
    }
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    let launch = Launch::program("strace").env("MESHCAST_DATA_DIR", dir.path().join("data"));
    let launch = ["-f", "-o", "/dev/null", "-e", fault].into_iter().fold(launch, Launch::arg);
    let pty = launch.arg(env!("CARGO_BIN_EXE_meshcast")).arg("--no-tour").arg(&path);
    let pty = pty.size(160, 30).start();
    pty.wait_for("bench 1");
    pty.send("\x1b[B");
    pty.settle();
    pty.send("2.61\r");
    pty.wait_for("site.ron *");
    pty.send("\x13");
    Some((dir, path, pty))
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
    // The first one is that of the file, the second that of its directory.
    let Some((_dir, path, pty)) = with_fault("inject=fsync:error=EIO:when=2") else { return };
    pty.wait_for("the disk did not confirm it");
    assert!(fs::read_to_string(&path).unwrap().contains("L: 2.61"));
}

#[test]
fn a_save_that_fails_leaves_the_old_file_and_no_draft() {
    for (fault, said) in [
        ("inject=fsync:error=ENOSPC:when=1", "the disk is full; nothing was changed"),
        ("inject=renameat,renameat2,rename:error=EIO:when=1", "nothing was changed"),
    ] {
        let Some((_dir, path, pty)) = with_fault(fault) else { return };
        pty.wait_for(said);
        assert_eq!(fs::read_to_string(&path).unwrap(), SAMPLE);
        assert_eq!(drafts(&path), Vec::<String>::new());
        // The next one works.
        pty.send("\x13");
        pty.wait_for("saved ");
        assert!(fs::read_to_string(&path).unwrap().contains("L: 2.61"));
    }
}

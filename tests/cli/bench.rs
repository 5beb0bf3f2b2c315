//! `meshcast bench`: early end, and what cannot be asked together.

use crate::{command, ran, refused};
use std::io::{BufRead, BufReader, Read};
use std::process::Stdio;

#[test]
fn what_cannot_be_asked_together_is_refused() {
    assert!(refused(&["bench", "--size", "--scene", "A"]).contains("--scene"));
    assert!(refused(&["bench", "--size", "--convergence"]).contains("--convergence"));
    assert!(refused(&["bench", "--scene", "Z"]).contains("A, B, C"));
}

/// Ctrl+C once something is being run, as a person would press it.
#[cfg(unix)]
#[test]
fn an_early_end_leaves_valid_json_and_its_exit_code() {
    for (mode, key) in
        [(None, None), (Some("--convergence"), Some("rows")), (Some("--size"), Some("rows"))]
    {
        let mut arguments = vec!["bench", "--format", "json"];
        arguments.extend(mode);
        let mut child = command(&arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the binary starts");
        let mut err = BufReader::new(child.stderr.take().expect("it is piped"));
        let mut line = String::new();
        err.read_line(&mut line).expect("it says what it runs");
        assert!(line.starts_with("progress: "), "{line}");
        // SAFETY: a signal to a child of this process that has not been waited for.
        assert_eq!(unsafe { libc::kill(child.id() as libc::pid_t, libc::SIGINT) }, 0);
        err.read_to_string(&mut line).expect("it ends");
        let ran = ran(child.wait_with_output().expect("it ends"));
        assert_eq!(ran.code, 130, "{mode:?}: {line}");
        let value: serde_json::Value = serde_json::from_str(&ran.out).expect("it is JSON");
        let rows = key.map_or(&value, |key| &value[key]);
        assert!(rows.is_array(), "{mode:?}: {value}");
        if key.is_some() {
            assert_eq!(value["part"], true);
            assert!(value["version"].is_string() && value["fingerprint"].is_string());
        }
    }
}

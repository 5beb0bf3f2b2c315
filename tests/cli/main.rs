//! The built binary without a screen: results, errors, exit codes.

mod adopt;
mod bench;
mod calibrate;
mod campaign;
mod cases;
mod check;
mod errors;
mod exporting;
mod forecast_csv_and_text;
mod forecast_json;
mod grid;
mod inputs;
mod program;
mod readme;
mod studies;
mod study_checks;
mod tables;
mod verdict;

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// The binary with these arguments, and nothing of our environment.
fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_meshcast"));
    command.args(arguments).env_clear().stdin(Stdio::null());
    command
}

/// What came out.
struct Ran {
    code: i32,
    out: String,
    err: String,
}

fn ran(output: Output) -> Ran {
    let text = |bytes| String::from_utf8(bytes).expect("output is UTF-8");
    Ran {
        code: output.status.code().expect("no signal ended it"),
        out: text(output.stdout),
        err: text(output.stderr),
    }
}

fn run(arguments: &[&str]) -> Ran {
    ran(command(arguments).output().expect("the binary starts"))
}

/// Standard output of a run that went well and had nothing to remark but how far it is.
fn good(arguments: &[&str]) -> String {
    let ran = run(arguments);
    assert_eq!(ran.code, 0, "{arguments:?}: {}", ran.err);
    assert!(ran.err.lines().all(|l| l.starts_with("progress: ")), "{arguments:?}: {}", ran.err);
    ran.out
}

/// The same as JSON.
fn json(arguments: &[&str]) -> Value {
    let mut all = arguments.to_vec();
    all.extend(["--format", "json"]);
    serde_json::from_str(&good(&all)).expect("standard output is JSON")
}

/// Standard error of a run that was refused: nothing on standard output, exit code 2.
fn refused(arguments: &[&str]) -> String {
    let ran = run(arguments);
    assert_eq!((ran.code, ran.out.as_str()), (2, ""), "{arguments:?}: {}", ran.err);
    assert!(ran.err.starts_with("error: "), "{}", ran.err);
    assert!(!ran.err.contains("panicked"), "{}", ran.err);
    ran.err
}

/// A project of Table 1's rows 1 and 4 and a punch on a plate.
const PROJECT: &str = r#"(
    version: 1,
    name: "road cut",
    layouts: [
        (name: "bench 2", d: 0.25, L: 2.5, D: 0.6, design_force: 15.0, allowable_deflection: 0.45, gamma_load: 1.5),
        (name: "portal, east", d: 0.40, L: 4.0, D: "1200 mm", ex: 2.0, ey: 0.2),
        (name: "corner", d: 0.32, L: 3.0, D: 1.0, ex: 1.5, ey: 1.5, branch: conservative),
    ],
)
"#;

/// A directory that goes away, with a file in it.
fn file(name: &str, text: &str) -> (TempDir, PathBuf) {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = directory.path().join(name);
    std::fs::write(&path, text).expect("the temporary directory can be written");
    (directory, path)
}

fn shown(path: &Path) -> &str {
    path.to_str().expect("a temporary path is UTF-8")
}

//! Every output that needs no screen, byte for byte as it was: a scaffold for changes that must change
//! nothing.
//!
//! It is kept for what no better test holds, by this rule:
//!
//! - Each form in which a command answers (text, JSON, CSV, millimetres, HTML, Markdown, SVG) is here once,
//!   with the case that has the most in it: the whole text with its order, wrapping and digits is held nowhere
//!   else. What an input changes in JSON and CSV is held field by field in `tests/cli` and `tests/export`,
//!   and is not here again; the texts of a few states are, which no test there reads as a text.
//! - A refusal is here only where no other test names its words; helps are here as the list of commands and
//!   as one command's, for `tests/cli/readme` and the manual pages hold the flags.
//!
//! It guards the program's own former output and proves nothing right: that is for `tests/published`,
//! `tests/physics`, `tests/cli` and `tests/export`.
//!
//! `MESHCAST_GOLDEN=write` writes the expected files instead of comparing with them, and
//! `MESHCAST_GOLDEN_BINARY` names another binary to run. Expected files come from the binary of before
//! a change; to write them anew with that of after it would prove nothing.

// A case sees the project through symbolic links, so that it can leave nothing behind in it.
#![cfg(unix)]

mod cases;
mod difference;
mod errors;
mod mask;
mod run;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// One run of the binary.
struct Case {
    /// Its expected file, without the ending.
    name: String,
    arguments: Vec<String>,
}

/// More would only slow each other down on a small machine, and the slow cases have threads.
const THREADS: usize = 2;

fn expected_directory() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/expected")
}

/// What all cases give, in their order.
fn all_outputs(cases: &[Case]) -> Vec<String> {
    let next = AtomicUsize::new(0);
    let outputs = Mutex::new(vec![String::new(); cases.len()]);
    std::thread::scope(|scope| {
        for _ in 0..THREADS {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(case) = cases.get(index) else { break };
                    let output = run::output(case);
                    outputs.lock().unwrap()[index] = output;
                }
            });
        }
    });
    outputs.into_inner().unwrap()
}

/// Names of the files that are there.
fn present(directory: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(directory).into_iter().flatten();
    entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect()
}

#[test]
fn nothing_has_changed() {
    let cases = cases::all();
    let names: BTreeSet<String> = cases.iter().map(|c| format!("{}.txt", c.name)).collect();
    assert_eq!(names.len(), cases.len(), "two cases have the same name");

    let outputs = all_outputs(&cases);
    let directory = expected_directory();
    if std::env::var("MESHCAST_GOLDEN").is_ok_and(|v| v == "write") {
        fs::create_dir_all(&directory).unwrap();
        for name in present(&directory).difference(&names) {
            fs::remove_file(directory.join(name)).unwrap();
        }
        for (case, output) in cases.iter().zip(&outputs) {
            fs::write(directory.join(format!("{}.txt", case.name)), output).unwrap();
        }
        return;
    }

    let mut said = Vec::new();
    for (case, output) in cases.iter().zip(&outputs) {
        let arguments = case.arguments.join(" ");
        match fs::read_to_string(directory.join(format!("{}.txt", case.name))) {
            Err(e) => said.push(format!("== {}: no expected file: {e}", case.name)),
            Ok(expected) => said.extend(
                difference::first(&expected, output)
                    .map(|d| format!("== {}: meshcast {arguments}\n{d}", case.name)),
            ),
        }
    }
    said.extend(present(&directory).difference(&names).map(|n| format!("== {n}: of no case")));
    assert!(
        said.is_empty(),
        "{} of {} cases differ\n\n{}",
        said.len(),
        cases.len(),
        said.join("\n\n")
    );
}

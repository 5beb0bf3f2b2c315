//! One run of the binary, and what came of it as a text.

use super::{Case, mask};
use std::ffi::OsString;
use std::fs;
use std::os::unix::fs::symlink;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};

/// Folders of the project that arguments name.
const SEEN: [&str; 2] = ["projects", "tests"];

fn binary() -> OsString {
    std::env::var_os("MESHCAST_GOLDEN_BINARY")
        .unwrap_or_else(|| env!("CARGO_BIN_EXE_meshcast").into())
}

/// Exit code, both streams and the files it left, without what differs from run to run.
pub(crate) fn output(case: &Case) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let keep = tempfile::tempdir().unwrap();
    let top = keep.path().canonicalize().unwrap();
    let (here, data) = (top.join("here"), top.join("data"));
    fs::create_dir(&here).unwrap();
    fs::create_dir(&data).unwrap();
    for folder in SEEN {
        symlink(root.join(folder), here.join(folder)).unwrap();
    }
    let ran = Command::new(binary())
        // Help shows the name that the program was called by, and the binary may have any.
        .arg0("meshcast")
        .args(&case.arguments)
        .current_dir(&here)
        .env_clear()
        .env("MESHCAST_DATA_DIR", &data)
        .stdin(Stdio::null())
        .output()
        .unwrap_or_else(|e| panic!("{:?} does not start: {e}", binary()));

    let mut text = format!("exit {:?}\n", ran.status.code());
    let places = [(here.as_path(), "HERE"), (data.as_path(), "DATA"), (root, "ROOT")];
    let mut part = |title: &str, bytes: &[u8], masked: fn(&str) -> String| {
        let mut bytes = masked(&String::from_utf8_lossy(bytes));
        for (path, word) in places {
            bytes = bytes.replace(path.to_str().unwrap(), word);
        }
        text.push_str(&format!("--- {title}\n{bytes}"));
        if !bytes.is_empty() && !bytes.ends_with('\n') {
            text.push_str("\n(no line end)\n");
        }
    };
    part("stdout", &ran.stdout, mask::output);
    part("stderr", &ran.stderr, mask::errors);
    for (folder, word) in [(&here, "HERE"), (&data, "DATA")] {
        let mut files = Vec::new();
        gather(folder, &mut files);
        files.sort();
        for file in files {
            let name = file.strip_prefix(folder).unwrap().display();
            part(&format!("file {word}/{name}"), &fs::read(&file).unwrap(), mask::output);
        }
    }
    text
}

/// The files below a folder that the run made, so not through links.
fn gather(folder: &Path, found: &mut Vec<std::path::PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        let kind = entry.file_type().unwrap();
        if kind.is_dir() {
            gather(&entry.path(), found);
        } else if kind.is_file() {
            found.push(entry.path());
        }
    }
}

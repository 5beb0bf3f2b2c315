//! Names the commit that the program is built from in `MESHCAST_COMMIT`.
//!
//! A build without git, or from an archive, says `commit unknown`; a packager may set the variable.

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-changed=src/build.rs");
    println!("cargo:rerun-if-env-changed=MESHCAST_COMMIT");
    let given = std::env::var("MESHCAST_COMMIT").ok().filter(|text| is_commit(text));
    let commit = given.or_else(commit_of_this_tree).unwrap_or_else(|| "commit unknown".into());
    println!("cargo:rustc-env=MESHCAST_COMMIT={commit}");
}

/// The first twelve digits of the commit of the repository whose top is this package.
fn commit_of_this_tree() -> Option<String> {
    // An archive unpacked inside another repository must not take that one's commit.
    let top = git(&["rev-parse", "--show-toplevel"])?;
    let here = std::env::var("CARGO_MANIFEST_DIR").ok()?;
    if Path::new(&top).canonicalize().ok()? != Path::new(&here).canonicalize().ok()? {
        return None;
    }
    watch_head();
    git(&["rev-parse", "--short=12", "HEAD"]).filter(|text| is_commit(text))
}

/// Builds again when the checked out commit changes. Only files that exist are named: cargo would
/// build every time for one that does not. The log of HEAD covers a branch whose reference is packed.
fn watch_head() {
    let mut names = vec!["HEAD".to_string(), "logs/HEAD".into(), "packed-refs".into()];
    names.extend(git(&["symbolic-ref", "--quiet", "HEAD"]));
    for name in names {
        if let Some(path) = git(&["rev-parse", "--git-path", &name])
            && Path::new(&path).exists()
        {
            println!("cargo:rerun-if-changed={path}");
        }
    }
}

fn is_commit(text: &str) -> bool {
    (7..=40).contains(&text.len()) && text.chars().all(|c| c.is_ascii_hexdigit())
}

/// What git prints, if there is a git and it agrees.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    let text = text.trim().to_string();
    (output.status.success() && !text.is_empty()).then_some(text)
}

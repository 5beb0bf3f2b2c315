//! Takes out what two runs of one binary, or two builds of one source, do not share: the commit, times
//! and how often progress was said. Fingerprints stay.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

/// Standard output, or a file.
pub(crate) fn output(text: &str) -> String {
    let mut text = version(text);
    for field in ["\"wall_ms\":", "\"times_faster_than_plain\":"] {
        text = number_after(&text, field);
    }
    cost(&pictures(&text))
}

/// Pictures as data, by their digest alone: the same ones are in the other form of a report as they
/// are, and in this one they would be most of all expected files.
fn pictures(text: &str) -> String {
    let start = "base64,";
    let mut pieces = text.split(start);
    let mut masked = pieces.next().unwrap_or("").to_string();
    for piece in pieces {
        let is_data = |c: char| c.is_ascii_alphanumeric() || "+/=".contains(c);
        let rest = piece.trim_start_matches(is_data);
        let data = &piece[..piece.len() - rest.len()];
        // A picture names the commit too.
        let picture = STANDARD.decode(data).unwrap();
        let picture = version(&String::from_utf8_lossy(&picture));
        let digest: String =
            Sha256::digest(&picture).iter().take(8).map(|byte| format!("{byte:02x}")).collect();
        masked.push_str(&format!("{start}({} bytes, {digest}){rest}", picture.len()));
    }
    masked
}

/// Standard error: of progress only the last word, and that without its time.
pub(crate) fn errors(text: &str) -> String {
    let mut masked = String::new();
    for line in version(text).split_inclusive('\n') {
        match line.strip_prefix("progress: ") {
            // How many of these there are depends on the machine.
            Some(said) if !said.starts_with("done: ") => {}
            Some(said) => {
                let (what, _time) = said.rsplit_once(", ").unwrap_or((said, ""));
                masked.push_str(&format!("progress: {what}, TIME\n"));
            }
            None => masked.push_str(line),
        }
    }
    masked
}

/// The commit, or that it is unknown.
fn version(text: &str) -> String {
    let start = concat!(env!("CARGO_PKG_VERSION"), " (");
    let mut pieces = text.split(start);
    let mut masked = pieces.next().unwrap_or("").to_string();
    for piece in pieces {
        match piece.split_once(')') {
            Some((commit, rest))
                if commit == "commit unknown" || commit.chars().all(|c| c.is_ascii_hexdigit()) =>
            {
                masked.push_str("VERSION");
                masked.push_str(rest);
            }
            _ => {
                masked.push_str(start);
                masked.push_str(piece);
            }
        }
    }
    masked
}

/// The numbers behind a field of JSON.
fn number_after(text: &str, field: &str) -> String {
    let mut pieces = text.split(field);
    let mut masked = pieces.next().unwrap_or("").to_string();
    for piece in pieces {
        masked.push_str(field);
        masked.push_str("TIME");
        masked
            .push_str(piece.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.e".contains(c)));
    }
    masked
}

/// The time among the costs of a check. It is in a filled paragraph, whose lines its length moves, so
/// that paragraph is put on one line.
fn cost(text: &str) -> String {
    let mut masked = String::new();
    let mut lines = text.split_inclusive('\n').peekable();
    while let Some(line) = lines.next() {
        if !(line.starts_with("cost  ") && line.contains(" nodes ")) {
            masked.push_str(line);
            continue;
        }
        let mut paragraph = line.trim_end().to_string();
        while let Some(more) = lines.next_if(|l| l.starts_with("  ")) {
            paragraph.push(' ');
            paragraph.push_str(more.trim());
        }
        let words: Vec<&str> = paragraph.split(' ').collect();
        let timed = words
            .iter()
            .enumerate()
            .map(|(index, word)| if words.get(index + 1) == Some(&"ms") { "TIME" } else { word });
        masked.push_str(&timed.collect::<Vec<_>>().join(" "));
        masked.push('\n');
    }
    masked
}

#[test]
fn only_what_differs_from_run_to_run_is_masked() {
    let version = format!("a {} (0123abc), {0} (x)", env!("CARGO_PKG_VERSION"));
    assert_eq!(output(&version), format!("a VERSION, {} (x)", env!("CARGO_PKG_VERSION")));
    assert_eq!(output("{\"wall_ms\":1.5e-3,\"steps\":7}"), "{\"wall_ms\":TIME,\"steps\":7}");
    assert_eq!(
        output("cost    2 runs of 6 nodes and 8 bonds; 12 ms to\n        its end\nnext  1 ms\n"),
        "cost    2 runs of 6 nodes and 8 bonds; TIME ms to its end\nnext  1 ms\n"
    );
    assert_eq!(
        errors("progress: A: run 1 of 2\nerror: x\nprogress: done: 2 runs, 0.1 s\n"),
        "error: x\nprogress: done: 2 runs, TIME\n"
    );
}

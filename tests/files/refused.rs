//! The collection of bad files: each is refused with a message that fits one screen and says what
//! the first lines of the file, `//! ...`, demand.

use super::samples::files;
use meshcast::project;
use std::fs;

#[test]
fn every_bad_file_is_refused_in_plain_words() {
    let all = files("tests/files/invalid");
    assert!(all.len() > 30, "only {} files", all.len());
    let mut wrong = Vec::new();
    for path in all {
        let bytes = fs::read(&path).unwrap();
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let said = match project::load(&path) {
            Ok(_) => {
                wrong.push(format!("{name}: was opened"));
                continue;
            }
            Err(error) => error.to_string(),
        };
        if std::env::var_os("SHOW_MESSAGES").is_some() {
            println!("{}\n", said.replace(&path.display().to_string(), &name));
        }
        let demands: Vec<&str> = text
            .lines()
            .filter_map(|l| l.trim_start_matches('\u{feff}').strip_prefix("//! "))
            .collect();
        let flat = said.split_whitespace().collect::<Vec<_>>().join(" ");
        for demand in &demands {
            if !flat.contains(demand) {
                wrong.push(format!("{name}: {demand:?} is not in\n{said}"));
            }
        }
        if demands.is_empty() {
            wrong.push(format!("{name}: demands nothing"));
        }
        let fits = said.lines().count() <= 15 && said.lines().all(|l| l.chars().count() <= 78);
        if !fits {
            wrong.push(format!("{name}: does not fit the screen\n{said}"));
        }
        for term in ["serde", "std identifier", "struct", "RON value", "enum", "Expected"] {
            if flat.contains(term) {
                wrong.push(format!("{name}: speaks of {term:?}\n{said}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

//! What the README says of the command line is so.

use super::{good, run};
use std::fs;
use std::path::Path;

fn readme() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")).unwrap()
}

/// The words of the subcommands that the program's help lists.
fn commands() -> Vec<String> {
    let help = good(&["--help"]);
    let list = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    // A line that goes on is further in.
    let entries = list.lines().filter_map(|line| line.strip_prefix("  "));
    let entries = entries.filter(|line| !line.starts_with(' '));
    let words = entries.filter_map(|line| line.split_whitespace().next());
    words.filter(|word| *word != "help").map(str::to_string).collect()
}

#[test]
fn every_command_is_in_the_table_and_takes_the_flags_that_stand_there() {
    let readme = readme();
    let table = readme.split("## Commands").nth(1).unwrap().split("\n## ").next().unwrap();
    let commands = commands();
    assert!(commands.len() > 10, "{commands:?}");
    for command in &commands {
        assert!(table.contains(&format!("`meshcast {command}")), "{command}");
    }
    for row in table.lines().filter(|line| line.starts_with("| `meshcast ")) {
        let command = row.split_whitespace().nth(2).unwrap().trim_end_matches(['`', ',']);
        if command.starts_with('[') {
            continue;
        }
        let help = good(&["help", command]);
        for flag in row.split([' ', '`']).filter(|word| word.starts_with("--")) {
            assert!(help.contains(flag), "{flag} of {command}");
        }
    }
}

#[test]
fn the_flags_of_the_whole_program_are_those_of_its_help() {
    let help = good(&["--help"]);
    let readme = readme();
    let settings = readme.split("**Settings.**").nth(1).unwrap().split("\n\n").next().unwrap();
    let flags: Vec<&str> =
        settings.split([' ', '\n', '(', ')', '`']).filter(|w| w.starts_with("--")).collect();
    assert!(flags.len() > 5, "{flags:?}");
    for flag in flags {
        assert!(help.contains(flag), "{flag}");
    }
}

#[test]
fn the_project_that_is_printed_opens() {
    let readme = readme();
    let text = readme.split("```ron\n").nth(1).unwrap().split("```").next().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("printed.ron");
    fs::write(&path, text).unwrap();
    let ran = run(&["compare", path.to_str().unwrap()]);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    assert!(ran.out.contains("bench 2") && ran.out.contains("gully"), "{}", ran.out);
}

//! A mesh adopted from its own test: in the project, with forecasts and verdicts of its own.

use super::{command, good, refused, run, shown};
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

/// A made-up double-twist mesh 6x8 of 2.2 mm wire on a small panel, so that it is soon done.
const EXAMPLE: [&str; 18] = [
    "--name",
    "Example 6x8, 2.2",
    "--force",
    "20",
    "--deflection",
    "0.32",
    "--panel",
    "1.6",
    "--punch",
    "0.5",
    "--opening",
    "0.06",
    "--diameter",
    "0.0022",
    "--example",
    "--runs",
    "60",
    "--threads",
];

fn example<'a>(project: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["adopt", project], &EXAMPLE[..], &["2"], more].concat()
}

const PROJECT: &str = "// my site\n(version: 2, name: \"site\", meshes: [\"dt-8x10-2.7\"], layouts: [\n    \
    (name: \"old\", d: 0.3, L: 3, D: 1), // stays\n])\n";

/// Starts it and kills it when the file has so many lines.
fn killed(arguments: &[&str], file: &Path, lines: usize) {
    let mut child = command(arguments).stderr(Stdio::null()).spawn().unwrap();
    let begun = Instant::now();
    let there = || fs::read(file).map_or(0, |text| text.iter().filter(|b| **b == b'\n').count());
    while there() < lines {
        assert!(child.try_wait().unwrap().is_none(), "it ended before {lines} lines");
        assert!(begun.elapsed() < Duration::from_secs(600), "{} of {lines} lines", there());
        std::thread::sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
}

/// Cuts so many bytes off the end of a file, as a crash of the machine may.
fn torn(file: &Path, bytes: usize) {
    let text = fs::read(file).unwrap();
    fs::write(file, &text[..text.len() - bytes]).unwrap();
}

#[test]
fn an_example_mesh_is_adopted_into_a_project_that_needs_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.ron");
    fs::write(&path, PROJECT).unwrap();
    let file = shown(&path);
    let arguments = example(file, &[]);
    let ran = run(&arguments);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.out.contains("one test and prior") && ran.out.contains("alpha_F"), "{}", ran.out);
    assert!(ran.err.contains("laws ") && ran.err.contains("campaign and method "), "{}", ran.err);

    // What stood there stands there still; mesh, wires and method came to it.
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.starts_with("// my site\n") && text.contains("// stays"), "{text}");
    for part in
        ["example-6x8-2.2", "opening: 0.06", "diameter: 0.0022", "adopted: (", "example: true"]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
    let again = refused(&arguments);
    assert!(again.contains("has a mesh \"example-6x8-2.2\" already"), "{again}");
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
    let left: Vec<_> =
        fs::read_dir(folder.path()).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert_eq!(left, ["site.ron"], "what was kept on the way is gone");

    // Killed among the laws and among the runs, and with torn ends, it comes to the same bytes.
    let other = folder.path().join("other");
    fs::create_dir(&other).unwrap();
    let again = other.join("site.ron");
    fs::write(&again, PROJECT).unwrap();
    let on_the_way = other.join("site.adopt-example-6x8-2.2");
    let (laws, runs) =
        (on_the_way.join("laws.txt"), on_the_way.join("repeated").join("campaign.jsonl"));
    killed(&example(shown(&again), &[]), &laws, 12);
    let e = refused(&example(shown(&again), &[]));
    assert!(e.contains("--resume goes on with it") || e.contains("give --resume"), "{e}");
    torn(&laws, 7);
    let resumed = example(shown(&again), &["--resume"]);
    killed(&resumed, &runs, 20);
    torn(&runs, 30);
    assert_eq!(fs::read_to_string(&again).unwrap(), PROJECT, "nothing is written before the end");
    // Other values are not mixed with what is there.
    let mut others = resumed.clone();
    others[5] = "21";
    assert!(refused(&others).contains("begun with other values"));
    // On request it comes into the user's own catalogue too, never in place of another one.
    let home = folder.path().join("home");
    let with_home = |arguments: &[&str]| {
        let mut command = command(arguments);
        super::ran(command.env("MESHCAST_DATA_DIR", &home).output().unwrap())
    };
    let resumed = [&resumed[..], &["--catalogue"]].concat();
    let ended = with_home(&resumed);
    assert_eq!(ended.code, 0, "{}", ended.err);
    assert!(ended.err.contains("kept in your catalogue too"), "{}", ended.err);
    assert!(with_home(&["mesh", "list"]).out.contains("example-6x8-2.2"));
    assert!(with_home(&["mesh", "show", "example-6x8-2.2"]).out.contains("single wire"));
    let own = fs::read(home.join("meshes.ron")).unwrap();
    let third = folder.path().join("third.ron");
    let refused = with_home(&example(shown(&third), &["--catalogue"]));
    assert_eq!(refused.code, 2, "{}", refused.err);
    assert!(refused.err.contains("already, which stays"), "{}", refused.err);
    assert!(fs::read(home.join("meshes.ron")).unwrap() == own && !third.exists());
    assert!(fs::read_to_string(&again).unwrap() == text, "other bytes");
    assert!(!on_the_way.exists());

    // A layout takes it; a copy elsewhere, without any catalogue of its user, says the same.
    let layout = "(name: \"new\", d: 0.3, L: 3, D: 1, ex: 0.4, ey: 0.5, mesh: \"example-6x8-2.2\", \
        method: derived, blocks: mirrored, design_force: 2), (name: \"old\"";
    fs::write(&path, text.replacen("(name: \"old\"", layout, 1)).unwrap();
    let copy = folder.path().join("copy.ron");
    fs::copy(&path, &copy).unwrap();
    let forecast = |file: &str| run(&["forecast", file, "--layout", "new"]);
    let (here, there) = (forecast(file), forecast(shown(&copy)));
    assert!(here.code == 0 && here.out == there.out, "{}", here.err);
    // Its ratios are its own; what an offset of facing blocks does is another mesh's, said.
    let said = format!("{}{}", here.out, here.err);
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("(the mesh's own)"), "{said}");
    assert!(said.contains("simulations of repeated blocks"), "{said}");
    let told = run(&["forecast", file, "--layout", "new", "--format", "json"]).out;
    assert!(told.contains("borrowed_map") && !told.contains("default_ratios"), "{told}");
    assert!(good(&["mesh", "list"]).lines().all(|line| !line.contains("example-6x8")));
}

#[test]
fn what_cannot_be_adopted_is_said_before_anything_is_computed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new.ron");
    let with = |more: &[&str]| {
        refused(&[&["adopt", shown(&path), "--deflection", "0.5", "--force", "60"], more].concat())
    };
    assert!(with(&["--name", "dt 8x10 2.7"]).contains("has a mesh \"dt-8x10-2.7\" already"));
    assert!(with(&["--name", "..."]).contains("letters or digits"));
    let e = with(&["--name", "m", "--panel", "0.9"]);
    assert!(e.contains("--punch") && e.contains("below the panel"), "{e}");
    assert!(!path.exists());
}

/// As wide as the terminal, and no line that ends in the middle of it.
#[test]
fn the_help_is_wrapped_at_any_width() {
    for columns in [80, 100] {
        let mut help = command(&["adopt", "--help"]);
        let text = help.env("COLUMNS", columns.to_string()).output().unwrap().stdout;
        let text = String::from_utf8(text).unwrap();
        assert!(text.lines().all(|line| line.chars().count() <= columns), "{columns}: {text}");
        let last = text.trim_end().rsplit("\n\n").next().unwrap();
        let lines: Vec<&str> = last.lines().collect();
        assert!(lines.len() > 2 && last.contains("--resume goes on with it"), "{columns}: {last}");
        for line in &lines[..lines.len() - 1] {
            assert!(line.chars().count() + 20 > columns, "{columns}: {line}");
        }
    }
}

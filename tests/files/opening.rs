//! Trouble with the file itself, and what stands there when nothing is named.

use meshcast::project::{self, Cause, Home, Overwrite, OwnRecovery};
use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn a_path_that_leads_nowhere_is_told_how_to_make_a_project() {
    let dir = tempfile::tempdir().unwrap();
    let error = project::load(&dir.path().join("my site.ron")).unwrap_err();
    assert_eq!(error.cause, Cause::NotFound);
    assert!(error.is_bad_input());
    let said = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("there is no such file meshcast new '"), "{said}");
    assert!(said.contains("my site.ron' makes a project there"), "{said}");
}

#[test]
fn directories_large_files_and_empty_ones_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let said = |path: &Path| project::load(path).unwrap_err().to_string();
    assert!(said(dir.path()).contains("this is a directory"));
    let path = dir.path().join("p.ron");
    fs::write(&path, "").unwrap();
    assert!(said(&path).contains("the file is empty"));
    fs::write(&path, "\u{feff} \r\n\t").unwrap();
    assert!(said(&path).contains("the file is empty"));
    fs::write(&path, vec![b' '; 4 * 1024 * 1024 + 1]).unwrap();
    assert!(said(&path).contains("larger than 4 MiB"));
    assert!(said(&dir.path().join("p.ron/x")).contains("there is no such file"));
}

/// The largest project that is allowed still opens quickly enough to be used in a test.
#[test]
fn a_thousand_layouts_open_and_one_more_is_refused() {
    let text = |count: usize| {
        let layouts: String =
            (0..count).map(|k| format!("(name: \"{k}\", d: 0.3, L: 3, D: 1),\n")).collect();
        format!("(version: 1, name: \"p\", layouts: [{layouts}])")
    };
    assert_eq!(project::parse(&text(1000), "many").unwrap().project.layouts.len(), 1000);
    let said = project::parse(&text(1001), "many").unwrap_err().to_string();
    assert!(said.contains("up to 1000"), "{said}");
}

fn sample() -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("projects/road-cut.ron")).unwrap()
}

#[test]
fn the_first_start_opens_a_copy_of_the_sample_and_the_next_one_the_last_project() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().join("not/yet/there");
    let home = Home::at(Some(data.clone()));
    assert!(home.recent().is_empty());
    let mut start = home.start_project().unwrap();
    assert_eq!(start.note, None);
    let copy = data.join("road-cut.ron");
    assert_eq!(start.opened.document.path(), Some(copy.as_path()));
    assert_eq!(fs::read_to_string(&copy).unwrap(), sample());
    // What the user made of the copy stays.
    start.opened.project.site = "ours".into();
    start.opened.document.save(&start.opened.project, Overwrite::No).unwrap();
    assert_eq!(home.start_project().unwrap().opened.project.site, "ours");

    let other = dir.path().join("other.ron");
    project::create(&other, &project::new_project("other")).unwrap();
    assert!(home.remember(&copy).unwrap());
    assert!(home.remember(&other).unwrap());
    assert_eq!(home.start_project().unwrap().opened.project.name, "other");
    assert_eq!(home.recent(), [other.clone(), copy.clone()]);
    assert!(home.remember(&copy).unwrap());
    assert_eq!(home.recent(), [copy, other.clone()]);

    // A last project that is gone is passed over and named.
    home.remember(&other).unwrap();
    fs::remove_file(&other).unwrap();
    let start = home.start_project().unwrap();
    assert_eq!(start.opened.project.site, "ours");
    assert!(start.note.unwrap().contains("other.ron: there is no such file"));
}

#[test]
fn the_recent_list_is_short_and_a_damaged_state_is_no_trouble() {
    let dir = tempfile::tempdir().unwrap();
    let home = Home::at(Some(dir.path().to_path_buf()));
    for k in 0..30 {
        home.remember(&dir.path().join(format!("{k}.ron"))).unwrap();
    }
    assert_eq!(home.recent().len(), 20);
    assert!(home.recent()[0].ends_with("29.ron"));
    for damage in ["", "(recent: 7)", "\u{0}", "(recent: [], newer_field: 3)"] {
        fs::write(dir.path().join("state.ron"), damage).unwrap();
        assert!(home.recent().is_empty());
        assert!(home.start_project().is_ok());
    }
}

#[test]
fn without_a_data_directory_the_sample_stands_in_no_file() {
    let dir = tempfile::tempdir().unwrap();
    // A file where the directory should be cannot be written into, not even by root.
    let blocked = dir.path().join("file");
    fs::write(&blocked, "").unwrap();
    for home in [Home::at(None), Home::at(Some(blocked.join("data")))] {
        let start = home.start_project().unwrap();
        assert_eq!(start.opened.document.path(), None);
        assert_eq!(start.opened.project.layouts.len(), 5);
        let note = start.note.unwrap();
        assert!(note.contains("kept nowhere until you save it"), "{note}");
        assert!(home.remember(Path::new("x.ron")).map_or(true, |kept| !kept));
    }
}

fn open_copy(dir: &Path) -> (PathBuf, project::Opened) {
    let path = dir.join("p.ron");
    fs::write(&path, sample()).unwrap();
    let opened = project::load(&path).unwrap();
    (path, opened)
}

#[test]
fn unsaved_work_is_kept_found_recovered_and_thrown_away() {
    let dir = tempfile::tempdir().unwrap();
    let home = Home::at(Some(dir.path().join("data")));
    let (path, opened) = open_copy(dir.path());
    assert!(opened.document.find_recovery(&home).is_none());
    let mut edited = opened.project.clone();
    edited.layouts.swap(0, 1);
    edited.layouts[0].layout.plate = 0.2;
    let mut own = None;
    let kept = opened.document.keep(&edited, &home, &mut own).unwrap();
    assert_eq!(kept, dir.path().join(".p.ron.recovery"));
    assert_eq!(fs::read_to_string(&path).unwrap(), sample(), "the file itself changed");

    let mut next = project::load(&path).unwrap();
    // A living session's is offered to nobody.
    assert!(next.document.find_recovery(&home).is_none());
    drop(own);
    let found = next.document.find_recovery(&home).unwrap();
    assert!(found.written.is_some());
    let project = next.document.recover(&found).unwrap();
    assert_eq!(project, edited);
    // Saving it keeps the comments of the file.
    assert!(next.document.save(&project, Overwrite::No).unwrap().comments_kept);
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.find("Test 2").unwrap() < text.find("Table 1, test 1").unwrap(), "{text}");
    // What is saved needs no recovery, and is swept away.
    drop(found);
    assert!(next.document.find_recovery(&home).is_none());
    assert!(!kept.exists());
}

#[test]
fn work_is_kept_in_the_data_directory_where_there_is_no_better_place() {
    let dir = tempfile::tempdir().unwrap();
    let data = dir.path().join("data");
    let home = Home::at(Some(data.clone()));
    let opened = project::parse(&sample(), "sample").unwrap();
    let mut edited = opened.project.clone();
    edited.site = "unsaved".into();
    let kept = opened.document.keep(&edited, &home, &mut None).unwrap();
    assert!(kept.starts_with(data.join("recovery")));
    let found = opened.document.find_recovery(&home).unwrap();
    assert_eq!(opened.document.recover(&found).unwrap().site, "unsaved");
    OwnRecovery::adopt(found, &opened.document).discard();
    assert!(opened.document.find_recovery(&home).is_none());

    // The directory of the file is gone, as on a disk that was pulled out.
    let gone = dir.path().join("gone");
    fs::create_dir(&gone).unwrap();
    let (_, opened) = open_copy(&gone);
    fs::remove_dir_all(&gone).unwrap();
    let kept = opened.document.keep(&edited, &home, &mut None).unwrap();
    assert!(kept.starts_with(data.join("recovery")));
    assert_eq!(opened.document.find_recovery(&home).unwrap().path, kept);
    assert!(opened.document.keep(&edited, &Home::at(None), &mut None).is_err());
}

#[test]
fn each_session_of_a_file_keeps_its_work_in_a_file_of_its_own() {
    let dir = tempfile::tempdir().unwrap();
    let home = Home::at(Some(dir.path().join("data")));
    let (_, opened) = open_copy(dir.path());
    let with = |site: &str| project::Project { site: site.into(), ..opened.project.clone() };
    let (mut first, mut second) = (None, None);
    let of_first = opened.document.keep(&with("first"), &home, &mut first).unwrap();
    let of_second = opened.document.keep(&with("second"), &home, &mut second).unwrap();
    assert_eq!(of_second, dir.path().join(".p.ron.2.recovery"));
    assert_eq!(opened.document.keep(&with("first again"), &home, &mut first).unwrap(), of_first);
    assert!(fs::read_to_string(&of_first).unwrap().contains("first again"));
    // The end of one leaves the other's alone.
    second.take().unwrap().discard();
    assert!(of_first.exists() && !of_second.exists());
    // What has gone is made again.
    fs::remove_file(&of_first).unwrap();
    assert!(!first.as_ref().unwrap().stands());
    assert_eq!(opened.document.keep(&with("first"), &home, &mut first).unwrap(), of_first);
    assert!(first.as_ref().unwrap().stands());
    // Lost ones are offered one at a time, to one session.
    opened.document.keep(&with("second"), &home, &mut second).unwrap();
    drop((first, second));
    let offered = opened.document.find_recovery(&home).unwrap();
    let other = opened.document.find_recovery(&home).unwrap();
    assert_ne!(offered.path, other.path);
    assert!(opened.document.find_recovery(&home).is_none());
    // Who takes it back writes into it from then on.
    let mut own = Some(OwnRecovery::adopt(offered, &opened.document));
    let kept = opened.document.keep(&with("third"), &home, &mut own).unwrap();
    assert!(fs::read_to_string(kept).unwrap().contains("third"));
}

#[cfg(unix)]
#[test]
fn kept_work_is_as_private_as_the_project() {
    use std::os::unix::fs::PermissionsExt;
    let dir = tempfile::tempdir().unwrap();
    let home = Home::at(Some(dir.path().join("data")));
    let (path, opened) = open_copy(dir.path());
    let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode() & 0o777;
    for wanted in [0o600, 0o640, 0o664] {
        fs::set_permissions(&path, fs::Permissions::from_mode(wanted)).unwrap();
        let kept = opened.document.keep(&opened.project, &home, &mut None).unwrap();
        assert_eq!(mode(&kept), wanted, "{wanted:o}");
        fs::remove_file(kept).unwrap();
    }
    // Of a project in no file it is the user's alone.
    let nowhere = project::parse(&sample(), "sample").unwrap();
    let kept = nowhere.document.keep(&nowhere.project, &home, &mut None).unwrap();
    assert_eq!(mode(&kept), 0o600);
}

#[test]
fn damaged_recovery_is_refused_in_plain_words() {
    let dir = tempfile::tempdir().unwrap();
    let home = Home::at(None);
    let (_, opened) = open_copy(dir.path());
    fs::write(dir.path().join(".p.ron.recovery"), "(version: 1, name").unwrap();
    let found = opened.document.find_recovery(&home).unwrap();
    let said = opened.document.recover(&found).unwrap_err().to_string();
    assert!(said.contains(".p.ron.recovery cannot be opened"), "{said}");
}

/// Brackets of every kind, and comments, each in the other's place: none may end the program for
/// want of stack.
#[test]
fn deep_nesting_is_refused_wherever_it_stands() {
    let openings = ["{", "[", "(", "{1:", "(a:", "Some(", "{(", "{Some([", "{{1:2}:", "/*"];
    let places = [
        ("", ""),
        ("(version: 1, name: \"p\", layouts: [", ")"),
        ("(version: 1, name: \"p\", layouts: [(name: \"a\", d: 0.3, L: 3, D: 1, check: (", ")"),
        ("(version: 1, name: \"p\", layouts: [], meshes: [(id: \"m\", wire: ", ")"),
        ("(version: 1, name: \"p\", layouts: [], display: (", ")"),
    ];
    for opening in openings {
        for (before, behind) in places {
            let text = format!("{before}{}{behind}", opening.repeat(50_000));
            let said = project::parse(&text, "deep").unwrap_err().to_string();
            let known = ["nested too deep", "name is expected", "a colon is missing"];
            assert!(known.iter().any(|k| said.contains(k)), "{opening} behind {before}: {said}");
        }
    }
    let dir = tempfile::tempdir().unwrap();
    let home = Home::at(Some(dir.path().to_path_buf()));
    let (_, opened) = open_copy(dir.path());
    let deep = "{".repeat(50_000);
    fs::write(dir.path().join("state.ron"), format!("(recent: {deep}")).unwrap();
    assert!(home.recent().is_empty() && home.start_project().is_ok());
    fs::write(dir.path().join(".p.ron.recovery"), &deep).unwrap();
    let found = opened.document.find_recovery(&home).unwrap();
    assert!(opened.document.recover(&found).is_err());
}

/// A hostile file must not keep the program busy: the time grows with the size and no faster.
#[test]
fn large_nonsense_is_refused_soon() {
    let started = std::time::Instant::now();
    let many = |piece: &str| {
        let count = 1_000_000 / piece.len();
        format!("(version: 1, name: \"p\", layouts: [{}])", piece.repeat(count))
    };
    for text in [
        many("(a: 1),"),
        many("1,"),
        many("(name: \"x\", d: 1, L: 3, D: 1),"),
        many("/**/x,"),
        many("(name: \"a\", d: 1, d: 1, d: 1, d: 1),"),
        format!("(version: 1, name: \"p\", {})", "x: 1,".repeat(200_000)),
        format!("(version: 1, name: \"p\", layouts: [(name: \"a\", {})])", "d: 1,".repeat(200_000)),
        format!("(version: 1, name: \"p\", meshes: [{}], layouts: [])", "\"a\",".repeat(200_000)),
        "(".repeat(1_000_000),
        "/*".repeat(500_000),
    ] {
        assert!(project::parse(&text, "large").is_err());
    }
    // One second alone on two cores; a step that grows with the square would take minutes.
    assert!(started.elapsed().as_secs() < 60, "{:?}", started.elapsed());
}

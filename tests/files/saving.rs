//! Saving to a real disk: atomic, in its place, never over somebody else's changes.

use meshcast::project::{self, Opened, Overwrite, Project, SaveError};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A project file in a directory of its own, with comments, as opened.
fn open() -> (TempDir, PathBuf, Opened) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("p.ron");
    fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join("projects/road-cut.ron"), &path).unwrap();
    let opened = project::load(&path).unwrap_or_else(|e| panic!("{e}"));
    (dir, path, opened)
}

fn edited(project: &Project) -> Project {
    let mut edited = project.clone();
    edited.layouts[0].layout.plate = 0.3;
    edited
}

/// Names of the files in a directory.
fn names(dir: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(dir)
        .unwrap()
        .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

/// Whether permission bits hold this process back; they do not for root.
#[cfg(unix)]
fn permissions_count(dir: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    let closed = dir.join("closed");
    fs::create_dir(&closed).unwrap();
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o500)).unwrap();
    let held = fs::write(closed.join("x"), "").is_err();
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o700)).unwrap();
    fs::remove_dir_all(&closed).unwrap();
    held
}

#[test]
fn a_new_project_opens_and_is_saved_unchanged() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("new.ron");
    let text = project::new_project("North \"face\"");
    project::create(&path, &text).unwrap();
    let mut opened = project::load(&path).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(opened.project.name, "North \"face\"");
    assert_eq!(opened.project.layouts[0].layout, meshcast::layout::NEW);
    opened.document.save(&opened.project, Overwrite::No).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
    assert!(matches!(project::create(&path, "other"), Err(SaveError::Exists(_))));
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn an_unedited_project_is_saved_byte_for_byte() {
    let (_dir, path, mut opened) = open();
    let before = fs::read(&path).unwrap();
    opened.document.save(&opened.project, Overwrite::No).unwrap();
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn an_edit_is_saved_and_read_back_again_and_again() {
    let (dir, path, mut opened) = open();
    let before = fs::read_to_string(&path).unwrap();
    let mut project = edited(&opened.project);
    assert!(opened.document.is_edited(&project));
    let report = opened.document.save(&project, Overwrite::No).unwrap();
    assert!(report.comments_kept && !report.recreated);
    assert_eq!(fs::read_to_string(&path).unwrap(), before.replacen("d: 0.25", "d: 0.3", 1));
    assert!(!opened.document.is_edited(&project));
    project.layouts[0].layout.plate = 0.25;
    opened.document.save(&project, Overwrite::No).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), before);
    assert_eq!(names(dir.path()), ["p.ron"], "something is left over");
}

#[test]
fn a_file_that_changed_on_disk_is_not_overwritten_unless_told() {
    let (_dir, path, mut opened) = open();
    let theirs = fs::read_to_string(&path).unwrap().replace("Km 12.4", "Km 12.5");
    fs::write(&path, &theirs).unwrap();
    let project = edited(&opened.project);
    let refused = opened.document.save(&project, Overwrite::No).unwrap_err();
    assert!(matches!(refused, SaveError::ChangedOnDisk(_)));
    assert!(refused.to_string().contains("changed by something else"));
    assert_eq!(fs::read_to_string(&path).unwrap(), theirs);
    assert!(opened.document.is_edited(&project), "a refused save must not count as saved");
    opened.document.save(&project, Overwrite::Yes).unwrap();
    assert_eq!(project::load(&path).unwrap().project, project);
}

#[test]
fn a_file_written_anew_with_the_same_text_is_no_change() {
    let (_dir, path, mut opened) = open();
    let text = fs::read(&path).unwrap();
    fs::remove_file(&path).unwrap();
    fs::write(&path, text).unwrap();
    opened.document.save(&edited(&opened.project), Overwrite::No).unwrap();
}

#[test]
fn a_deleted_file_is_made_again() {
    let (_dir, path, mut opened) = open();
    fs::remove_file(&path).unwrap();
    let project = edited(&opened.project);
    assert!(opened.document.save(&project, Overwrite::No).unwrap().recreated);
    assert_eq!(project::load(&path).unwrap().project, project);
}

#[test]
fn save_as_asks_before_it_overwrites_and_moves_the_project_there() {
    let (dir, path, mut opened) = open();
    let before = fs::read(&path).unwrap();
    let other = dir.path().join("other.ron");
    fs::write(&other, "precious").unwrap();
    let project = edited(&opened.project);
    let refused = opened.document.save_as(&other, &project, Overwrite::No).unwrap_err();
    assert!(matches!(refused, SaveError::Exists(_)));
    assert_eq!(fs::read_to_string(&other).unwrap(), "precious");
    opened.document.save_as(&other, &project, Overwrite::Yes).unwrap();
    assert_eq!(opened.document.path(), Some(other.as_path()));
    assert_eq!(fs::read(&path).unwrap(), before, "the old file changed");
    // The next save goes to the new place.
    opened.document.save(&project, Overwrite::No).unwrap();
    assert_eq!(project::load(&other).unwrap().project, project);
}

#[test]
fn a_project_without_a_file_needs_a_name() {
    let mut opened = project::parse(&project::new_project("p"), "new").unwrap();
    let refused = opened.document.save(&opened.project, Overwrite::No).unwrap_err();
    assert!(matches!(refused, SaveError::NoPath));
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("p.ron");
    opened.document.save_as(&path, &opened.project, Overwrite::No).unwrap();
    assert!(project::load(&path).is_ok());
    let nowhere = dir.path().join("no/such/dir/p.ron");
    let refused = opened.document.save_as(&nowhere, &opened.project, Overwrite::No).unwrap_err();
    assert!(refused.to_string().contains("its directory does not exist"), "{refused}");
    assert_eq!(opened.document.path(), Some(path.as_path()));
    let refused = opened.document.save_as(dir.path(), &opened.project, Overwrite::Yes).unwrap_err();
    assert!(matches!(refused, SaveError::NotAFile(_)));
}

#[test]
fn a_project_that_makes_no_sense_is_not_saved() {
    let (_dir, path, mut opened) = open();
    let before = fs::read(&path).unwrap();
    let mut project = opened.project.clone();
    project.layouts[1].name = project.layouts[0].name.clone();
    project.layouts[2].layout.spacing = f64::NAN;
    let refused = opened.document.save(&project, Overwrite::Yes).unwrap_err().to_string();
    assert!(refused.contains("layouts[1].name") && refused.contains("more"), "{refused}");
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn an_older_file_is_brought_up_to_date_only_when_it_is_saved() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("old.ron");
    let old = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/files/valid/version_0.ron");
    fs::copy(old, &path).unwrap();
    let before = fs::read_to_string(&path).unwrap();
    let mut opened = project::load(&path).unwrap();
    let forces: Vec<_> = opened.project.layouts.iter().map(|l| l.question.force).collect();
    assert_eq!(forces, [Some(25_000.0), Some(25_000.0), Some(12_500.5)]);
    assert!(opened.project.layouts.iter().all(|l| l.layout == meshcast::layout::REFERENCE));
    assert_eq!(opened.document.migrated_from(), Some(0));
    assert!(!opened.document.is_edited(&opened.project));
    assert_eq!(fs::read_to_string(&path).unwrap(), before, "opening wrote to the file");
    let report = opened.document.save(&opened.project, Overwrite::No).unwrap();
    assert_eq!(report.migrated_from, Some(0));
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains("version: 2") && text.contains("design_force: 25.0"), "{text}");
    assert!(text.contains("// the block") && text.contains("// Written before"), "{text}");
    let again = project::load(&path).unwrap();
    assert_eq!(again.document.migrated_from(), None);
    assert_eq!(again.project, opened.project);
}

#[test]
fn a_version_1_file_is_saved_as_version_2_with_its_comments() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("one.ron");
    let before = "// Ours.\n(version: 1, /* of spring */ name: \"p\", layouts: [\n    \
                  (name: \"a\", d: 0.25, L: 3, D: 1), // wet\n])\n";
    fs::write(&path, before).unwrap();
    let mut opened = project::load(&path).unwrap();
    assert_eq!(opened.document.migrated_from(), Some(1));
    assert!(!opened.document.is_edited(&opened.project));
    let mut project = opened.project.clone();
    project.layouts[0].layout.plate = 0.3;
    let report = opened.document.save(&project, Overwrite::No).unwrap();
    assert!(report.comments_kept && report.migrated_from == Some(1));
    let after = before.replace("version: 1", "version: 2").replace("d: 0.25", "d: 0.3");
    assert_eq!(fs::read_to_string(&path).unwrap(), after);
    assert_eq!(project::load(&path).unwrap().document.migrated_from(), None);
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().mode() & 0o7777
    }

    #[test]
    fn the_mode_stays() {
        for bits in [0o600, 0o640, 0o664] {
            let (_dir, path, mut opened) = open();
            fs::set_permissions(&path, fs::Permissions::from_mode(bits)).unwrap();
            opened.document.save(&edited(&opened.project), Overwrite::No).unwrap();
            assert_eq!(mode(&path), bits);
        }
    }

    #[test]
    fn links_stay_and_the_file_behind_them_is_saved() {
        let (dir, path, _) = open();
        let middle = dir.path().join("middle.ron");
        let link = dir.path().join("link.ron");
        symlink("p.ron", &middle).unwrap();
        symlink(&middle, &link).unwrap();
        let mut opened = project::load(&link).unwrap();
        let project = edited(&opened.project);
        opened.document.save(&project, Overwrite::No).unwrap();
        for l in [&middle, &link] {
            assert!(fs::symlink_metadata(l).unwrap().is_symlink());
        }
        assert!(!fs::symlink_metadata(&path).unwrap().is_symlink());
        assert_eq!(project::load(&path).unwrap().project, project);
        // A link to a file that is not there yet stays a link too.
        let ahead = dir.path().join("ahead.ron");
        symlink("later.ron", &ahead).unwrap();
        opened.document.save_as(&ahead, &project, Overwrite::No).unwrap();
        assert!(fs::symlink_metadata(&ahead).unwrap().is_symlink());
        assert!(dir.path().join("later.ron").is_file());
        // A link that leads to itself is an error and not an endless loop.
        let ring = dir.path().join("ring.ron");
        symlink("ring.ron", &ring).unwrap();
        assert!(opened.document.save_as(&ring, &project, Overwrite::Yes).is_err());
        assert!(project::load(&ring).is_err());
    }

    #[test]
    fn a_read_only_file_is_not_replaced() {
        let (dir, path, mut opened) = open();
        let before = fs::read(&path).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).unwrap();
        for overwrite in [Overwrite::No, Overwrite::Yes] {
            let refused = opened.document.save(&edited(&opened.project), overwrite).unwrap_err();
            assert!(matches!(refused, SaveError::ReadOnly(_)), "{refused}");
        }
        assert_eq!(fs::read(&path).unwrap(), before);
        assert_eq!(mode(&path), 0o444);
        assert_eq!(names(dir.path()), ["p.ron"]);
    }

    #[test]
    fn a_directory_that_cannot_be_written_is_a_clear_error() {
        let (dir, path, mut opened) = open();
        if !permissions_count(dir.path()) {
            return;
        }
        let before = fs::read(&path).unwrap();
        fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o500)).unwrap();
        let refused = opened.document.save(&edited(&opened.project), Overwrite::No).unwrap_err();
        fs::set_permissions(dir.path(), fs::Permissions::from_mode(0o700)).unwrap();
        assert!(refused.to_string().contains("you may not write in its directory"), "{refused}");
        assert_eq!(fs::read(&path).unwrap(), before);
    }

    #[test]
    fn a_file_that_cannot_be_read_is_a_clear_error() {
        let (dir, path, _) = open();
        if !permissions_count(dir.path()) {
            return;
        }
        fs::set_permissions(&path, fs::Permissions::from_mode(0o000)).unwrap();
        let error = project::load(&path).unwrap_err();
        assert!(error.to_string().contains("no permission to read"), "{error}");
        assert!(!error.is_bad_input());
    }

    /// A file of the system to which nothing can be written stands for a full disk.
    #[test]
    fn a_device_is_no_place_for_a_project() {
        let (_dir, _, mut opened) = open();
        let full = Path::new("/dev/full");
        if full.exists() {
            let refused =
                opened.document.save_as(full, &opened.project, Overwrite::Yes).unwrap_err();
            assert!(matches!(refused, SaveError::NotAFile(_)), "{refused}");
            assert!(project::load(full).unwrap_err().to_string().contains("no ordinary file"));
        }
    }
}

#[test]
fn of_two_saves_at_one_moment_the_second_finds_the_first() {
    for _ in 0..200 {
        let (_dir, path, opened) = open();
        let other = project::load(&path).unwrap();
        let start = std::sync::Barrier::new(2);
        let save = |opened: &Opened, plate: f64| {
            let mut document = opened.document.clone();
            let mut project = opened.project.clone();
            project.layouts[0].layout.plate = plate;
            start.wait();
            document.save(&project, Overwrite::No)
        };
        let (one, two) = std::thread::scope(|scope| {
            let one = scope.spawn(|| save(&opened, 0.31));
            (save(&other, 0.33), one.join().unwrap())
        });
        let saved = [&one, &two].iter().filter(|result| result.is_ok()).count();
        assert_eq!(saved, 1, "{one:?} {two:?}");
        let refused = one.err().or(two.err()).unwrap();
        assert!(matches!(refused, SaveError::ChangedOnDisk(_)), "{refused}");
    }
}

#[test]
fn of_two_new_files_of_one_name_the_second_finds_the_first() {
    for _ in 0..200 {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("new.ron");
        let start = std::sync::Barrier::new(2);
        let make = || {
            start.wait();
            project::create(&path, &project::new_project("x"))
        };
        let (one, two) = std::thread::scope(|scope| {
            let one = scope.spawn(make);
            (make(), one.join().unwrap())
        });
        assert!(one.is_ok() != two.is_ok(), "{one:?} {two:?}");
    }
}

#[cfg(unix)]
#[test]
fn what_a_save_would_lose_is_said_before() {
    let (dir, path, mut opened) = open();
    let other = dir.path().join("other.ron");
    fs::hard_link(&path, &other).unwrap();
    let before = fs::read(&path).unwrap();
    let edited = edited(&opened.project);
    let refused = opened.document.save(&edited, Overwrite::No).unwrap_err();
    assert!(refused.to_string().contains("2 hard links"), "{refused}");
    assert_eq!(fs::read(&path).unwrap(), before);
    assert_eq!(names(dir.path()), ["other.ron", "p.ron"]);
    opened.document.save(&edited, Overwrite::Yes).unwrap();
    assert_eq!(fs::read(&other).unwrap(), before);
    // It has one name now.
    opened.document.save(&opened.project, Overwrite::No).unwrap();
}

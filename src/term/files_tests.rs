//! Saving and keeping through the host, in a directory of its own.

use super::*;
use crate::forecast::derived::{Arranged, shipped};
use crate::mesh::adopted::{Adopted, AdoptedQuality, KeptMethod};
use crate::mesh::catalogue;
use crate::project;
use std::fs;
use tempfile::TempDir;

/// A saved project, its files, and the directory that holds both it and the data directory.
fn open() -> (TempDir, PathBuf, FileHost, Project) {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("road.ron");
    project::create(&path, &project::new_project("Road")).unwrap();
    let opened = project::load(&path).unwrap();
    let home = Home::at(Some(dir.path().join("data")));
    let host = FileHost::new(opened.document, home).0;
    (dir, path, host, opened.project)
}

fn edited(project: &Project, name: &str) -> Arc<Project> {
    Arc::new(Project { name: name.to_owned(), ..project.clone() })
}

#[test]
fn a_save_goes_to_the_file_and_leaves_the_recovery_file_to_the_loop() {
    let (_dir, path, files, project) = open();
    let edited = edited(&project, "Road, north");
    let kept = files.recover(&edited).unwrap();
    assert!(kept.exists());
    let saved = files.save(&edited, None, false).unwrap();
    assert_eq!(saved.path, path);
    // It may hold edits that were made while the save ran.
    assert!(kept.exists());
    files.forget_recovery().unwrap();
    assert!(!kept.exists());
    assert_eq!(project::load(&path).unwrap().project, *edited);
    assert_eq!(files.home.recent(), [path]);
}

#[test]
fn what_was_kept_of_an_adoption_goes_when_its_mesh_is_written_and_not_before() {
    let (_dir, path, files, project) = open();
    let mut mesh = (*catalogue::reference()).clone();
    (mesh.id, mesh.reference) = ("mine".into(), false);
    mesh.adopted = Some(Adopted {
        quality: AdoptedQuality::TwoTests,
        low: 24e3,
        middle: 27e3,
        high: 30e3,
        methods: vec![KeptMethod::keep(shipped(Arranged::Repeated).clone())],
    });
    let kept = path.with_file_name("road.adopt-mine");
    fs::create_dir(&kept).unwrap();
    fs::write(kept.join("laws.txt"), "a line").unwrap();
    files.save(&edited(&project, "without it"), None, false).unwrap();
    assert!(kept.exists());
    let mut with = project.clone();
    with.meshes.push(project::MeshUse::Inline(Arc::new(mesh)));
    files.save(&Arc::new(with), None, false).unwrap();
    assert!(!kept.exists());
}

#[test]
fn a_mesh_is_kept_in_the_users_own_catalogue_once() {
    let (_dir, _path, files, _project) = open();
    let mut mesh = (*catalogue::reference()).clone();
    (mesh.id, mesh.reference) = ("mine".into(), false);
    let mesh = Arc::new(mesh);
    assert!(files.keep_mesh(&mesh).unwrap().starts_with("mine is in your own catalogue too: "));
    assert_eq!(files.home.own_meshes().unwrap(), std::slice::from_ref(&mesh));
    assert!(files.keep_mesh(&mesh).unwrap_err().contains("already, which stays"));
}

#[test]
fn another_name_is_the_projects_own_from_then_on() {
    let (dir, path, files, project) = open();
    let other = dir.path().join("other.ron");
    let first = edited(&project, "one");
    let kept = files.recover(&first).unwrap();
    assert_eq!(files.save(&first, Some(&other), false).unwrap().path, other);
    assert!(!kept.exists());
    let second = edited(&project, "two");
    assert_eq!(files.save(&second, None, false).unwrap().path, other);
    assert_eq!(project::load(&other).unwrap().project, *second);
    assert_eq!(project::load(&path).unwrap().project, project);
}

#[test]
fn a_file_changed_by_others_is_replaced_only_when_told_to() {
    let (dir, path, files, project) = open();
    fs::write(&path, project::new_project("somebody else's")).unwrap();
    let edited = edited(&project, "mine");
    let failure = files.save(&edited, None, false).unwrap_err();
    assert!(failure.overwrite_helps, "{}", failure.message);
    assert_eq!(failure.path, None);
    files.save(&edited, None, true).unwrap();
    let taken = dir.path().join("taken.ron");
    fs::write(&taken, "something").unwrap();
    let failure = files.save(&edited, Some(&taken), false).unwrap_err();
    assert!(failure.overwrite_helps);
    assert_eq!(failure.path, Some(taken));
    let nowhere = dir.path().join("no/such/place.ron");
    assert!(!files.save(&edited, Some(&nowhere), false).unwrap_err().overwrite_helps);
}

#[test]
fn a_file_that_was_deleted_is_made_again_and_said_so() {
    let (_dir, path, files, project) = open();
    fs::remove_file(&path).unwrap();
    let saved = files.save(&edited(&project, "again"), None, false).unwrap();
    assert!(saved.note.unwrap().contains("deleted"));
}

#[test]
fn forgetting_what_is_not_there_is_fine() {
    let (_dir, _path, files, project) = open();
    files.forget_recovery().unwrap();
    let kept = files.recover(&project).unwrap();
    files.forget_recovery().unwrap();
    assert!(!kept.exists());
}

#[test]
fn another_project_takes_the_place_of_the_former_and_its_recovery_file_is_its_own() {
    let (dir, path, files, project) = open();
    let former = files.recover(&edited(&project, "unsaved")).unwrap();
    let other = dir.path().join("other.ron");
    project::create(&other, &project::new_project("Other")).unwrap();
    let failure = files.open(&dir.path().join("none.ron")).unwrap_err();
    assert!(failure.message.contains("none.ron"), "{}", failure.message);
    assert!(former.exists());
    // Edits of the other project that a lost session left.
    let (lost, _) = FileHost::new(project::load(&other).unwrap().document, files.home.clone());
    let left = lost.recover(&edited(&project, "left behind")).unwrap();
    drop(lost);

    let opened = files.open(&other).unwrap();
    assert_eq!((opened.project.name.as_str(), opened.path.as_path()), ("Other", other.as_path()));
    assert_eq!(opened.kept.unwrap().project.name, "left behind");
    // Until it takes over, what is kept and saved is the former's.
    assert!(former.exists());
    assert_eq!(files.recover(&edited(&project, "unsaved")).unwrap(), former);
    files.take_over();
    assert!(!former.exists());
    assert!(left.exists());
    assert_eq!(files.home.recent(), std::slice::from_ref(&other));
    assert_eq!(files.save(&edited(&project, "x"), None, false).unwrap().path, other);
    let found = files.list();
    let row = found.iter().find(|f| f.path == other).unwrap();
    assert!(row.current && row.recent);
    assert!(found.iter().any(|f| f.path == path && !f.recent));
}

#[test]
fn edits_of_several_lost_sessions_are_offered_in_turn() {
    let (_dir, path, files, project) = open();
    drop(files);
    let home = Home::at(Some(path.with_file_name("data")));
    let session = || FileHost::new(project::load(&path).unwrap().document, home.clone());
    let (first, second, third) = (session().0, session().0, session().0);
    first.recover(&edited(&project, "first")).unwrap();
    let broken = second.recover(&edited(&project, "second")).unwrap();
    third.recover(&edited(&project, "third")).unwrap();
    drop((first, second, third));
    std::fs::write(&broken, "(version: 2, name: ").unwrap();

    let (asked, beginning) = session();
    let names = [beginning.kept, asked.drop_kept(), asked.drop_kept()];
    let mut names = names.map(|kept| kept.map(|kept| kept.project.name.clone()));
    // Of equal age either may come first.
    names[..2].sort();
    assert_eq!(names, [Some("first".into()), Some("third".into()), None]);
    assert!(broken.exists(), "what cannot be read is not thrown away");
}

#[test]
fn a_project_opened_again_does_not_offer_the_edits_of_this_session() {
    let (_dir, path, files, project) = open();
    let kept = files.recover(&edited(&project, "let go")).unwrap();
    let again = files.open(&path).unwrap();
    assert!(again.kept.is_none());
    files.take_over();
    assert!(!kept.exists());
}

/// Short, so that a test need not wait.
const SHORT: Patience = Patience {
    saving: Duration::from_millis(100),
    looking: Duration::from_millis(50),
    keeping: Duration::from_millis(50),
    leaving: Duration::from_millis(50),
};

/// Seen: a save to a network drive that had gone kept all later ones waiting, also those to another disk,
/// for as long as it was gone.
#[test]
fn a_save_that_its_disk_does_not_answer_is_given_up_and_another_place_is_free() {
    let (dir, path, files, project) = open();
    let files = FileHost { patience: SHORT, ..files };
    let (first, second) = (edited(&project, "one"), edited(&project, "two"));
    let elsewhere = tempfile::tempdir().unwrap();
    let other = elsewhere.path().join("other.ron");
    let silent = project::silent::falls(dir.path());
    let failure = files.save(&first, None, false).unwrap_err();
    assert!(failure.message.starts_with("not known to be saved"), "{}", failure.message);
    let files = FileHost { patience: Patience::default(), ..files };
    assert_eq!(files.save(&second, Some(&other), false).unwrap().path, other);
    // The first one may still come to pass. The session goes on with the other file all the same.
    drop(silent);
    let written = || project::load(&path).unwrap().project == *first;
    while !written() {
        std::thread::sleep(Duration::from_millis(5));
    }
    let third = edited(&project, "three");
    assert_eq!(files.save(&third, None, false).unwrap().path, other);
    assert_eq!(project::load(&other).unwrap().project, *third);
    assert!(written());
}

/// Seen: a start waited without end for a drive that had gone, with the project read, and the watch kept
/// what the loop takes.
#[test]
fn who_holds_a_file_on_a_silent_disk_is_not_waited_for_and_asked_again() {
    let (dir, path, files, _) = open();
    files.leave();
    let silent = project::silent::falls(dir.path());
    let opened = project::load(&path).unwrap();
    let (files, beginning) = FileHost::with(opened.document, files.home.clone(), SHORT);
    let note = beginning.note.expect("it is told");
    assert!(note.contains("has not said whether another session holds"), "{note}");
    // One look is left to the disk, and no other one is begun.
    assert!(files.watch().is_empty() && Arc::strong_count(&files.looking) == 2);
    assert!(files.watch().is_empty() && Arc::strong_count(&files.looking) == 2);
    files.take_over();
    drop(silent);
    while Arc::strong_count(&files.looking) > 1 {
        std::thread::sleep(Duration::from_millis(5));
    }
    let files = FileHost { patience: Patience::default(), ..files };
    while !matches!(*files.claim(), Claimed::Mine(_)) {
        files.watch();
    }
    assert!(dir.path().join(".road.ron.lock").exists());
    files.leave();
    assert!(!dir.path().join(".road.ron.lock").exists());
}

/// Seen: the end of a session whose project was on a drive that had gone waited for it, to keep the edits.
#[test]
fn edits_that_cannot_be_kept_beside_a_file_on_a_silent_disk_are_kept_in_the_data_directory() {
    let place = tempfile::tempdir().unwrap();
    let (dir, path, files, project) = open();
    let data = place.path().join("data");
    // The other disk has to answer in this time.
    let patience = Patience { keeping: Duration::from_secs(3), ..SHORT };
    let files = FileHost { patience, home: Home::at(Some(data.clone())), ..files };
    let silent = project::silent::falls(dir.path());
    let edits = edited(&project, "one");
    for _ in 0..3 {
        let kept = files.recover(&edits).unwrap();
        assert!(kept.starts_with(&data), "{}", kept.display());
    }
    // One file, and the start after that offers it.
    assert_eq!(fs::read_dir(data.join("recovery")).unwrap().count(), 1);
    drop(files);
    drop(silent);
    let opened = project::load(&path).unwrap();
    let (_, beginning) = FileHost::new(opened.document, Home::at(Some(data)));
    assert_eq!(beginning.kept.unwrap().project.name, "one");
}

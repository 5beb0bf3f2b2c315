use super::super::FileHost;
use super::super::exports::ExportWanted;
use super::super::program::Host;
use crate::export::ExportKind;
use crate::project::{self, Home};
use crate::units::Units;
use std::fs;

const SAMPLE: &str = include_str!("../../projects/road-cut.ron");

#[test]
fn files_go_beside_the_project_and_replace_nothing_by_chance() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.ron");
    fs::write(&path, SAMPLE).unwrap();
    let opened = project::load(&path).unwrap();
    let project = opened.project;
    let (host, _) = FileHost::new(opened.document, Home::at(Some(folder.path().join("home"))));
    let wanted = |kind| ExportWanted {
        kind,
        project: &project,
        edited: false,
        layout: 2,
        unit: Units::METRES,
        path: None,
        overwrite: false,
    };
    for kind in ExportKind::ALL {
        let first = host.export(wanted(kind)).unwrap();
        assert_eq!(first.path.parent(), Some(folder.path()));
        assert!(first.note.is_none());
        // The name of the first is taken: the second gets another.
        let second = host.export(wanted(kind)).unwrap();
        assert_ne!(first.path, second.path);
        assert_eq!(fs::read(&first.path).unwrap(), fs::read(&second.path).unwrap());
    }
    let chart = folder.path().join("site-portal-chart.svg");
    assert!(fs::read_to_string(chart).unwrap().contains("portal"));
    // A path that was typed is not replaced either, and the project itself never is.
    let taken = folder.path().join("taken.html");
    fs::write(&taken, "mine").unwrap();
    let at = |path, overwrite| ExportWanted { path, overwrite, ..wanted(ExportKind::ReportHtml) };
    let refused = host.export(at(Some(&taken), false)).unwrap_err();
    assert!(refused.contains("exists; :export! replaces it"), "{refused}");
    assert_eq!(fs::read_to_string(&taken).unwrap(), "mine");
    host.export(at(Some(&taken), true)).unwrap();
    assert!(fs::read_to_string(&taken).unwrap().contains("<!DOCTYPE html>"));
    let refused = host.export(at(Some(&path), true)).unwrap_err();
    assert!(refused.contains("never overwritten"), "{refused}");
    assert_eq!(fs::read_to_string(&path).unwrap(), SAMPLE);
    let edited = ExportWanted { edited: true, ..wanted(ExportKind::Table) };
    assert!(host.export(edited).unwrap().note.is_some());
}

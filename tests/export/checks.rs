//! Kept checks in what is exported: the same numbers, how to make them again, and whether they are stale.

use meshcast::dem::Flow;
use meshcast::export::{ExportKind, ReportSource};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::REFERENCE_ID;
use meshcast::project::{NamedLayout, Project};
use meshcast::study::exactness::Exactness;
use meshcast::study::remark::CheckFlag;
use meshcast::study::result::Wanted;
use meshcast::study::result::make::make;
use meshcast::units::{Units, significant, to_kn};
use std::sync::Arc;

/// A project with a small cell that was checked, twice, and one that was not.
fn checked() -> Project {
    let layout = Layout { plate: 0.25, spacing: 1.3, punch: 0.4, ex: 0.0, ey: 0.0, ..REFERENCE };
    let mut project = Project::starter("Small");
    project.layouts = vec![
        NamedLayout::new("one", layout, REFERENCE_ID),
        NamedLayout::new("two", layout, REFERENCE_ID),
    ];
    let mesh = project.mesh(&project.layouts[0]).unwrap();
    let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(2), seed: 5 };
    let made = make(&layout, &mesh, &wanted, 1, &|_| Flow::Continue).unwrap();
    project.layouts[0].check = Some(Arc::new(made.result));
    project
}

fn text(kind: ExportKind, project: &Project) -> String {
    let source = ReportSource { file_name: "small.ron", text: None, edited: false };
    kind.text(project, 0, source, Units::METRES).unwrap()
}

#[test]
fn a_kept_check_is_in_every_export_that_can_show_it() {
    let project = checked();
    let result = project.layouts[0].check.clone().unwrap();
    let force = significant(to_kn(result.force.mean), 3);
    for kind in [ExportKind::ReportHtml, ExportKind::ReportMarkdown] {
        let report = text(kind, &project);
        let small = report.to_lowercase();
        assert!(small.contains("check by simulation, 2 runs, quick"), "{kind:?}");
        assert!(report.contains(&force) && report.contains(&result.inputs.to_string()));
        assert!(report.contains("--fidelity quick --runs 2 --seed 5"), "how to make it again");
        assert!(report.contains("estimated error of the curve"));
        assert!(!report.contains("stale"));
    }
    assert!(text(ExportKind::Chart, &project).contains("check by simulation"));
    let table = text(ExportKind::Table, &project);
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    let column = |name: &str| rows[0].iter().position(|c| *c == name).unwrap();
    let number: f64 = rows[1][column("check_F_kN")].parse().unwrap();
    assert_eq!(number, to_kn(result.force.mean));
    assert_eq!((rows[1][column("check_runs")], rows[1][column("check_stale")]), ("2", "false"));
    assert_eq!((rows[2][column("check_F_kN")], rows[2][column("check_stale")]), ("", ""));
}

#[test]
fn a_single_block_that_has_not_converged_is_so_in_the_report() {
    let mut project = checked();
    let kept = Arc::make_mut(project.layouts[0].check.as_mut().unwrap());
    kept.flags.push(CheckFlag::from_code("not_converged"));
    kept.field.arrangement = Some("single in 7 x 7 cells, not converged, last change 8.6 %".into());
    for kind in [ExportKind::ReportHtml, ExportKind::ReportMarkdown] {
        let report = text(kind, &project);
        assert!(report.contains("7 x 7 cells, not converged, last change 8.6 %"), "{report}");
        assert!(report.contains("in a still larger field"), "{report}");
    }
}

#[test]
fn a_check_of_other_inputs_is_marked_stale_everywhere() {
    let mut project = checked();
    project.layouts[0].layout.spacing = 1.35;
    for kind in [ExportKind::ReportHtml, ExportKind::ReportMarkdown, ExportKind::Chart] {
        assert!(text(kind, &project).contains("stale"), "{kind:?}");
    }
    let table = text(ExportKind::Table, &project);
    assert!(table.lines().nth(1).unwrap().contains(",true,"), "{table}");
}

#[test]
fn a_project_with_a_check_is_saved_and_read_back_and_loses_it_when_it_is_taken_out() {
    let project = checked();
    let file = tempfile::NamedTempFile::with_suffix(".ron").unwrap();
    let (mut document, _) = {
        let text = meshcast::project::new_project("Small");
        std::fs::write(file.path(), text).unwrap();
        let opened = meshcast::project::load(file.path()).unwrap();
        (opened.document, opened.project)
    };
    document.save(&Arc::new(project.clone()), meshcast::project::Overwrite::Yes).unwrap();
    let back = meshcast::project::load(file.path()).unwrap().project;
    assert_eq!(back, project);
    assert!(back.layouts[0].check.is_some());
    let without: String = std::fs::read_to_string(file.path())
        .unwrap()
        .lines()
        .filter(|line| !line.trim_start().starts_with("check: ("))
        .map(|line| format!("{line}\n"))
        .collect();
    let without = meshcast::project::parse(&without, "taken out").unwrap().project;
    assert!(without.layouts[0].check.is_none());
}

//! The steps of the README's tour, each with its screen: a check, the governing layout, the spacing that
//! meets the design force, the report.

use crate::harness::*;
use meshcast::app::App;
use meshcast::app::message::{Command, Exported, Message};
use meshcast::export::ExportKind;
use std::path::PathBuf;

/// The sample as it is opened, at 80x24.
fn sample() -> App {
    let text = include_str!("../../projects/road-cut.ron");
    let project = meshcast::project::parse(text, "road-cut.ron").unwrap().project;
    let mut app = start(project, (80, 24), COLOR);
    // Two quick runs are enough to see the screens, and take a tenth of a second.
    press(&mut app, ":set fidelity quick<Enter>:set runs 2<Enter>");
    app
}

/// Presses keys and does the work that they ask for.
fn press_and_work(app: &mut App, script: &str) {
    let effects = press(app, script);
    work(app, effects);
}

#[test]
fn a_check_of_the_first_layout() {
    let mut app = sample();
    press_and_work(&mut app, "c");
    insta::assert_snapshot!("new_user_check", text(&app));
    assert!(app.layout().check.is_some() && app.edited());
}

#[test]
fn the_governing_layout() {
    let mut app = sample();
    press(&mut app, "v");
    insta::assert_snapshot!("new_user_compare", text(&app));
    press(&mut app, "<Down><Down><Enter>");
    assert_eq!(app.layout().name, "portal");
}

#[test]
fn the_plate_that_meets_the_design_force() {
    let mut app = sample();
    press(&mut app, "<Tab><Tab>g<Left><Left>");
    insta::assert_snapshot!("new_user_design", text(&app));
    let before = app.layout().layout;
    // Wider anchors would do by the numbers and are no cure: they are shown and not taken.
    press(&mut app, "<Down><Enter>");
    assert_eq!(app.layout().layout, before);
    assert!(text(&app).contains("wider anchors are no cure"), "{}", text(&app));
    press(&mut app, "<Up><Enter>");
    // The least plate at which F_a / 1.25 reaches 1.3 x 20 kN.
    assert!(app.layout().layout.plate > before.plate);
    let use_of = app.result().answer().unwrap().at_force.unwrap().utilisation;
    assert!(use_of <= 1.0 && use_of > 0.99, "{use_of}");
    press(&mut app, "qu");
    assert_eq!(app.layout().layout, before);
}

#[test]
fn the_report() {
    let mut app = sample();
    press(&mut app, "e");
    insta::assert_snapshot!("new_user_export", text(&app));
    let effects = press(&mut app, "<Enter>");
    let [Command::Export { kind: ExportKind::ReportHtml, path: None, .. }] = &effects[..] else {
        panic!("{effects:?}")
    };
    let path = PathBuf::from("/site/road-cut-report.html");
    app.update(Message::Exported(Ok(Exported { path, note: None })));
    assert!(text(&app).contains("written: /site/road-cut-report.html"));
}

//! Whole edits by key script: keys in, project and screen out.

use crate::harness::*;
use meshcast::app::App;
use meshcast::app::message::{Command, KeptEdits, Message, SaveFailure, Saved};
use meshcast::app::settings::Preferences;
use meshcast::layout::BranchRule;
use meshcast::units::{ChosenUnits, LengthUnit, Units};
use std::path::PathBuf;
use std::sync::Arc;

fn app() -> App {
    start(road_cut(), (80, 24), COLOR)
}

/// Answers a save effect as if the file had been written.
fn saved(app: &mut App, effects: Vec<Command>) -> Vec<Command> {
    let [Command::Save { project, path, .. }] = &effects[..] else { panic!("{effects:?}") };
    let path = path.clone().unwrap_or_else(|| PathBuf::from("/site/road-cut.ron"));
    app.update(Message::Saved(Ok(Saved { project: project.clone(), path, note: None })))
}

#[test]
fn arrows_step_finely_and_coarsely() {
    let mut app = app();
    press(&mut app, "<Right>");
    assert_eq!(app.layout().layout.plate, 0.26);
    press(&mut app, "<lt><S-Left>");
    assert_eq!(app.layout().layout.plate, 0.16);
    press(&mut app, "<Down>>");
    assert_eq!(app.layout().layout.spacing, 3.0);
    // Many steps leave no rounding behind.
    press(&mut app, &"<Right>".repeat(7));
    assert_eq!(app.layout().layout.spacing, 3.35);
}

#[test]
fn values_are_typed_with_and_without_a_unit() {
    let mut app = app();
    press(&mut app, "310mm<Enter>");
    assert_eq!(app.layout().layout.plate, 0.31);
    press(&mut app, "<Enter><C-u>0.2 m<Enter>");
    assert_eq!(app.layout().layout.plate, 0.2);
    press(&mut app, "t250<Enter>");
    assert_eq!(app.layout().layout.plate, 0.25);
    assert_eq!(app.units(), Units::MILLIMETRES);
    press(&mut app, "<Down><Down><Down>-500<Enter>");
    assert_eq!(app.layout().layout.ex, -0.5);
}

#[test]
fn escape_and_control_g_drop_what_was_typed() {
    let mut app = app();
    press(&mut app, "0.3<Esc>0.4<C-g>");
    assert_eq!(app.layout().layout.plate, 0.25);
    assert!(!app.edited());
}

#[test]
fn a_refused_value_stays_with_the_reason() {
    let mut app = app();
    press(&mut app, "9<Enter>");
    assert_eq!(app.layout().layout.plate, 0.25);
    let shown = text(&app);
    assert!(shown.contains("! d must be above 0, below L = 2.50 m"), "{shown}");
    assert!(shown.contains(" d  plate    9") || shown.contains(">d  plate    9"), "{shown}");
    // The text can be mended instead of typed again.
    press(&mut app, "<Home>0.<Del>4<Enter>");
    assert_eq!(app.layout().layout.plate, 0.4);
    // Stepping is refused in the same words and changes nothing.
    press(&mut app, "<Down><Down>2.45<Enter><Right>");
    assert_eq!(app.layout().layout.punch, 2.45);
    assert!(text(&app).contains("D must be above 0, below L = 2.50 m"));
}

#[test]
fn a_thousand_edits_can_be_undone_and_redone() {
    let mut app = app();
    press(&mut app, "<Down>");
    let before = app.project().clone();
    for _ in 0..600 {
        press(&mut app, "<Right><Left>");
    }
    press(&mut app, "<Right>");
    let after = app.project().clone();
    assert!(app.edited());
    press(&mut app, &"u".repeat(1201));
    assert_eq!(**app.project(), *before);
    assert!(!app.edited());
    press(&mut app, &"U".repeat(1201));
    assert_eq!(**app.project(), *after);
    // A new edit forgets what was undone.
    press(&mut app, "u<Right>U");
    assert!(text(&app).contains("nothing to redo"));
}

#[test]
fn undo_returns_to_the_place_of_the_edit() {
    let mut app = app();
    press(&mut app, "<Tab><Down><Right><Tab><Up>u");
    assert_eq!(app.selected(), 1);
    assert_eq!(app.field().word(), "L");
    assert!(text(&app).contains("undone: L of shelf"));
}

#[test]
fn layouts_are_added_copied_renamed_moved_and_deleted() {
    let mut app = app();
    let names = |app: &App| -> Vec<String> {
        app.project().layouts.iter().map(|l| l.name.clone()).collect()
    };
    press(&mut app, "a");
    assert_eq!(names(&app)[..2], ["bench 2", "layout"]);
    assert_eq!(app.selected(), 1);
    press(&mut app, "r<C-u>portal<Enter>");
    assert!(text(&app).contains("another layout is already called"));
    press(&mut app, "<C-u>new slope<Enter>A");
    assert_eq!(names(&app)[1..3], ["new slope", "new slope (2)"]);
    press(&mut app, "JJ");
    assert_eq!(names(&app)[4], "new slope (2)");
    assert_eq!(app.layout().name, "new slope (2)");
    press(&mut app, "x");
    assert!(!names(&app).contains(&"new slope (2)".to_string()));
    press(&mut app, "uuuuuu");
    assert_eq!(names(&app), ["bench 2", "shelf", "bench 3", "portal", "gully"]);
    assert!(!app.edited());
}

#[test]
fn keys_that_are_symbols_go_to_their_input_and_run_together_in_undo() {
    let mut app = app();
    for (key, word) in [("d", "d"), ("L", "L"), ("D", "D"), ("<End>", "gR"), ("<Home>", "d")] {
        press(&mut app, key);
        assert_eq!(app.field().word(), word, "{key}");
    }
    press(&mut app, "j");
    assert_eq!(app.field().word(), "L");
    press(&mut app, "k");
    assert_eq!(app.field().word(), "d");
    assert!(!app.edited());
    // Who meant to duplicate is told how.
    press(&mut app, "d");
    assert!(text(&app).contains("A duplicates the layout"), "{}", text(&app));
    // A key held down is one undo, the way back another.
    let before = app.layout().layout.plate;
    press(&mut app, &"<Right>".repeat(8));
    press(&mut app, "<Left><Left>");
    assert_eq!(app.history().undo_depth(), 2);
    press(&mut app, "u");
    assert!(
        (app.layout().layout.plate - before - 0.08).abs() < 1e-9,
        "{}",
        app.layout().layout.plate
    );
    press(&mut app, "u");
    assert_eq!(app.layout().layout.plate, before);
    press(&mut app, "U<Right>");
    // After an undo a new run begins.
    assert_eq!(app.history().undo_depth(), 2);
}

#[test]
fn a_layout_and_a_text_are_found_by_a_part() {
    let mut app = app();
    press(&mut app, "/GUL<Enter>");
    assert_eq!(app.layout().name, "gully");
    press(&mut app, "/bench<Enter>");
    assert_eq!(app.layout().name, "bench 2");
    press(&mut app, "/<Enter>");
    assert_eq!(app.layout().name, "bench 3");
    press(&mut app, "/nowhere<Enter>");
    assert!(text(&app).contains("\"nowhere\" is not here") && app.layout().name == "bench 3");
    press(&mut app, "v/shelf<Enter><Enter>");
    assert_eq!(app.layout().name, "shelf");
    // In the help: its last words, the glossary among them, and back to the beginning.
    press(&mut app, "?/gamma_R<Enter>");
    assert!(text(&app).contains("partial factor on the resistance"), "{}", text(&app));
    press(&mut app, "g");
    assert!(text(&app).contains("next input"), "{}", text(&app));
    press(&mut app, "G");
    assert!(text(&app).contains("The method"), "{}", text(&app));
    press(&mut app, "/nothing of that<Enter>q");
    assert!(!app.edited() && text(&app).contains("spacing"));
}

#[test]
fn the_last_layout_can_go_and_come_back() {
    let mut app = app();
    press(&mut app, "xxxxx");
    assert!(app.project().layouts.is_empty());
    assert!(text(&app).contains("no layouts yet"), "{}", text(&app));
    press(&mut app, "u");
    assert_eq!(app.layout().name, "gully");
}

#[test]
fn a_unit_from_the_command_line_is_not_saved() {
    let mut app = App::new(meshcast::app::Start {
        project: Arc::new(road_cut()),
        path: None,
        note: None,
        kept: None,
        holder: None,
        look: COLOR,
        units: ChosenUnits { length: Some(LengthUnit::Millimetre), force: None },
        size: (80, 24),
        preferences: Preferences::default(),
    });
    assert!(text(&app).contains("250 mm"));
    press(&mut app, "260<Enter>");
    assert_eq!(app.layout().layout.plate, 0.26);
    assert_eq!(app.project().display.units, Units::METRES);
    // The key sets the project's own unit.
    press(&mut app, "tt");
    assert!(text(&app).contains("260 mm"));
    assert_eq!(app.project().display.units, Units::MILLIMETRES);
}

/// What is typed without a unit is in the unit shown: 12 kip is 12 x 4.4482216 kN.
#[test]
fn feet_and_kips_are_shown_and_typed() {
    let mut app = app();
    press(&mut app, ":units ft,kip<Enter>10<Enter>");
    assert!(text(&app).contains("above 0, below L = 8.2021 ft"), "{}", text(&app));
    press(&mut app, "<Esc>0.82<Enter>");
    assert!((app.layout().layout.plate - 0.82 * 0.3048).abs() < 1e-9);
    press(&mut app, "<Down><Down><Down><Down><Down>12<Enter>");
    let force = app.layout().question.force.unwrap();
    assert!((force - 12.0 * 4_448.221_615_260_5).abs() < 1e-6, "{force}");
    assert!(text(&app).contains("F (kip) over delta (ft)"), "{}", text(&app));
    press(&mut app, "t");
    assert!(text(&app).contains("F (kip) over delta (in)"), "{}", text(&app));
    press(&mut app, ":units yd<Enter>");
    assert!(text(&app).contains("m, mm, ft or in"), "{}", text(&app));
}

#[test]
fn at_most_four_overlays() {
    let mut app = app();
    press(&mut app, "o<Tab>o<Tab>o<Tab>o<Tab>o");
    assert_eq!(app.project().layouts.iter().filter(|l| l.overlay).count(), 4);
    assert!(text(&app).contains("at most 4 curves"));
    let shown = text(&app);
    for (letter, name) in [('A', "bench 2"), ('B', "shelf"), ('C', "bench 3"), ('D', "portal")] {
        assert!(shown.contains(&format!("{letter}{name}")), "{shown}");
    }
}

#[test]
fn the_branch_can_be_conservative() {
    let mut app = app();
    // d = 0.25, D = 0.3: the published branch gives more than the small-punch one.
    press(&mut app, "<Down><Down>0.3<Enter>");
    let published = app.result().forecast().unwrap().field.unwrap().values.force;
    press(&mut app, "b");
    assert_eq!(app.layout().branch, BranchRule::Conservative);
    let conservative = app.result().forecast().unwrap().field.unwrap().values.force;
    assert!(conservative < published);
}

#[test]
fn design_values_are_set_and_cleared() {
    let mut app = app();
    press(&mut app, "<Down><Down><Down><Down><Down>20<Enter>");
    assert_eq!(app.layout().question.force, Some(20_000.0));
    // By hand: 20 over 0.88485 F_a, F_a = 22.8 kN (Table 1, test 1).
    assert!(text(&app).contains("PASSES: strength 99.1 %"), "{}", text(&app));
    press(&mut app, "<Del>");
    assert_eq!(app.layout().question.force, None);
    press(&mut app, "<Right>");
    assert_eq!(app.layout().question.force, Some(17_000.0));
    press(&mut app, "<Enter><C-u><Enter>");
    assert_eq!(app.layout().question.force, None);
}

#[test]
fn saving_by_key_and_by_command() {
    let mut app = app();
    press(&mut app, "<Right>");
    assert!(text(&app).contains("road-cut.ron *"));
    let effects = press(&mut app, "<C-s>");
    saved(&mut app, effects);
    assert!(!app.edited());
    assert!(text(&app).contains("saved /site/road-cut.ron"));
    press(&mut app, "<Right>");
    let effects = press(&mut app, ":w<Enter>");
    saved(&mut app, effects);
    assert!(!app.edited());
    let effects = press(&mut app, ":w other name.ron<Enter>");
    saved(&mut app, effects);
    assert_eq!(app.path(), Some(PathBuf::from("other name.ron").as_path()));
}

#[test]
fn quitting_asks_only_when_edits_are_unsaved() {
    let mut app = app();
    assert!(matches!(press(&mut app, "q")[..], [Command::Quit]));
    press(&mut app, "<Right>");
    assert!(press(&mut app, "q").is_empty());
    assert!(text(&app).contains("not saved"));
    assert!(press(&mut app, "<Esc>").is_empty());
    let effects = press(&mut app, "qs");
    assert!(matches!(saved(&mut app, effects)[..], [Command::Quit]));
    press(&mut app, "<Right>");
    assert!(matches!(press(&mut app, "qd")[..], [Command::ForgetRecovery, Command::Quit]));
    assert!(matches!(press(&mut app, ":q!<Enter>")[..], [Command::ForgetRecovery, Command::Quit]));
}

#[test]
fn quitting_waits_for_a_save_that_runs_and_says_so() {
    let mut app = app();
    let effects = press(&mut app, "<Right><C-s>");
    assert!(press(&mut app, "q").is_empty());
    assert!(text(&app).contains("still writing, then it quits"));
    assert!(matches!(saved(&mut app, effects)[..], [Command::Quit]));

    // Asked again it quits at once; what no file is known to hold is kept for the next start.
    press(&mut app, "<Right><C-s>q");
    assert!(matches!(press(&mut app, "q")[..], [Command::Recover { .. }, Command::Quit]));
}

/// What the room below tells each second of a disk that does not answer.
#[test]
fn a_save_that_takes_long_says_how_long_and_that_quitting_is_possible() {
    let mut app = app();
    let effects = press(&mut app, "<Right><C-s>");
    app.update(Message::StillAtFiles { seconds: 7 });
    assert!(text(&app).contains("still saving, 7 s; the edits are kept, quitting is possible"));
    press(&mut app, "q");
    app.update(Message::StillAtFiles { seconds: 8 });
    assert!(text(&app).contains("still saving, 8 s; asked again it quits at once"));
    // One that was on its way when the save had ended is passed over.
    press(&mut app, "<Esc>");
    saved(&mut app, effects);
    app.update(Message::StillAtFiles { seconds: 9 });
    assert!(!text(&app).contains("still saving"));
}

#[test]
fn edits_let_go_still_wait_for_what_was_asked_to_be_written() {
    let mut app = app();
    let effects = press(&mut app, "<Right>:w other.ron<Enter>");
    press(&mut app, "<Right>");
    assert!(press(&mut app, ":q!<Enter>").is_empty());
    assert!(matches!(saved(&mut app, effects)[..], [Command::ForgetRecovery, Command::Quit]));
    // So do reports, and one that fails is read before the program goes.
    press(&mut app, ":export chart x.svg<Enter>");
    assert!(press(&mut app, ":q!<Enter>").is_empty());
    assert!(app.update(Message::Exported(Err("the disk is full".into()))).is_empty());
    assert!(text(&app).contains("! the disk is full"));
}

#[test]
fn edits_made_while_a_save_runs_are_not_saved() {
    let mut app = app();
    let effects = press(&mut app, "<Right><C-s>");
    press(&mut app, "<Right>");
    saved(&mut app, effects);
    assert!(app.edited());
    assert!(app.unsaved().is_some());
    // Nor do they go with the program that was asked to quit before.
    let effects = press(&mut app, ":wq<Enter>");
    press(&mut app, "<Right>");
    assert!(saved(&mut app, effects).is_empty());
    assert!(text(&app).contains("Unsaved edits"));
}

#[test]
fn a_failed_save_keeps_the_program_open_and_says_why() {
    let mut app = app();
    press(&mut app, "<Right>");
    press(&mut app, ":wq<Enter>");
    let effects = app.update(Message::Saved(Err(SaveFailure {
        message: "the disk is full".into(),
        overwrite_helps: false,
        holder: None,
        path: None,
    })));
    assert!(effects.is_empty());
    assert!(text(&app).contains("! the disk is full"));
    assert!(app.edited());
}

#[test]
fn a_file_that_changed_on_disk_is_overwritten_only_when_told() {
    let mut app = app();
    press(&mut app, "<Right><C-s>");
    app.update(Message::Saved(Err(SaveFailure {
        message: "the file changed on disk since it was opened".into(),
        overwrite_helps: true,
        holder: None,
        path: None,
    })));
    assert!(text(&app).contains("replace the file on disk"), "{}", text(&app));
    let effects = press(&mut app, "o");
    assert!(matches!(effects[..], [Command::Save { overwrite: true, .. }]));
}

#[test]
fn kept_edits_are_offered_and_can_be_taken_back() {
    let mut kept = road_cut();
    kept.layouts[0].layout.plate = 0.3;
    let open = || {
        App::new(meshcast::app::Start {
            project: Arc::new(road_cut()),
            path: Some(PathBuf::from("/site/road-cut.ron")),
            note: None,
            kept: Some(KeptEdits { project: Arc::new(kept.clone()), about: Vec::new() }),
            holder: None,
            look: COLOR,
            units: ChosenUnits::default(),
            size: (80, 24),
            preferences: Preferences::default(),
        })
    };
    let mut app = open();
    assert!(text(&app).contains("cut off"));
    assert!(matches!(press(&mut app, "r")[..], [Command::TakeKept]));
    assert_eq!(app.layout().layout.plate, 0.3);
    assert!(app.edited());
    press(&mut app, "u");
    assert_eq!(app.layout().layout.plate, 0.25);
    let mut app = open();
    assert!(matches!(press(&mut app, "d")[..], [Command::DropKept]));
    assert!(!app.edited());
    // Of another lost session there is more: that is asked about too.
    app.update(Message::Kept(KeptEdits { project: Arc::new(kept.clone()), about: Vec::new() }));
    assert!(text(&app).contains("cut off"));
    press(&mut app, "r");
    assert_eq!(app.layout().layout.plate, 0.3);
}

#[test]
fn hanging_up_keeps_unsaved_edits() {
    let mut app = app();
    assert!(matches!(app.update(Message::HangUp)[..], [Command::Quit]));
    press(&mut app, "<Right>");
    assert!(matches!(app.update(Message::HangUp)[..], [Command::Recover { .. }, Command::Quit]));
}

#[test]
fn commands_of_the_help_are_known() {
    for command in meshcast::app::keymap::COMMANDS {
        for form in command.form.split(" / ") {
            let form =
                form.replace("PATH", "x.ron").replace("TEXT", "text").replace("ID", "dt-8x10-2.7");
            let form = form.replace("KIND", "chart");
            let form = form.split('|').next().unwrap().replace('N', "2");
            let mut app = app();
            press(&mut app, &format!(":{form}<Enter>"));
            let refused = matches!(app.mode(), meshcast::app::Mode::Entry(_));
            assert!(!refused, "{form}: {}", text(&app));
        }
    }
}

#[test]
fn pasted_text_goes_into_the_line_and_nowhere_else() {
    let mut app = app();
    app.update(Message::Paste("xxxx".into()));
    assert_eq!(app.project().layouts.len(), 5);
    press(&mut app, "r<C-u>");
    app.update(Message::Paste("upper\nbench\n".into()));
    press(&mut app, "<Enter>");
    assert_eq!(app.layout().name, "upper bench");
}

#[test]
fn an_unknown_key_says_where_the_keys_are() {
    let mut app = app();
    press(&mut app, "Q");
    assert!(text(&app).contains("Q does nothing here; ? shows the keys"));
    assert!(!app.edited());
}

#[test]
fn every_size_is_drawn_without_panic_and_within_the_screen() {
    let mut app = app();
    for script in [
        "",
        "o<Tab>",
        "?",
        "<Esc>i",
        "<Esc>m",
        "<Esc>r",
        "<Esc><Right>q",
        "<Esc>:w",
        "<Esc>:set<Enter>",
        "<Esc>O",
        "<Esc>:tour<Enter>",
    ] {
        press(&mut app, script);
        for width in [1, 20, 39, 40, 41, 63, 64, 79, 80, 81, 109, 110, 140, 300] {
            for height in [1, 5, 11, 12, 13, 23, 24, 25, 33, 34, 60, 100] {
                app.update(Message::Resize { width, height });
                text(&app);
            }
        }
    }
}

#[test]
fn what_is_written_is_chosen_from_a_list_or_named() {
    use meshcast::app::message::Exported;
    use meshcast::export::ExportKind;
    let mut app = app();
    press(&mut app, "<Tab><Tab>e");
    insta::assert_snapshot!("export_list", text(&app));
    let effects = press(&mut app, "<Down><Down><Enter>");
    let [
        Command::Export {
            kind: ExportKind::Chart, layout: 2, path: None, overwrite: false, ..
        },
    ] = &effects[..]
    else {
        panic!("{effects:?}")
    };
    let path = PathBuf::from("/site/road-cut-bench-3-chart.svg");
    app.update(Message::Exported(Ok(Exported { path, note: None })));
    assert_eq!(app.status().unwrap().text, "written: /site/road-cut-bench-3-chart.svg");
    let effects = press(&mut app, ":export! report /tmp/r.html<Enter>");
    let [Command::Export { kind: ExportKind::ReportHtml, path: Some(path), overwrite: true, .. }] =
        &effects[..]
    else {
        panic!("{effects:?}")
    };
    assert_eq!(path, &PathBuf::from("/tmp/r.html"));
    press(&mut app, ":export poem<Enter>");
    assert!(text(&app).contains("export one of: report"), "{}", text(&app));
}

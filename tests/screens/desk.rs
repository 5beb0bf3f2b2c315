//! The screens around the work, by key script: settings, opening another project.

use crate::harness::*;
use meshcast::app::message::{
    Command, FoundProject, KeptEdits, Message, OpenFailure, OpenedProject, Saved,
};
use meshcast::app::settings::{Preferences, SettingItem};
use meshcast::app::{App, Level, Mode, Start};
use meshcast::export::{csv, exported};
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::{REFERENCE_ID, Statistic};
use meshcast::project::schema::{NamedLayout, Project};
use meshcast::project::{self, Overwrite};
use meshcast::study::exactness::Exactness;
use meshcast::units::{ChosenUnits, Units};
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn app() -> App {
    start(road_cut(), (80, 24), MONO)
}

fn with(preferences: Preferences) -> App {
    App::new(Start {
        project: Arc::new(road_cut()),
        path: Some(PathBuf::from("/site/road-cut.ron")),
        note: None,
        kept: None,
        holder: None,
        look: preferences.look(&preferences.effective()),
        units: preferences.effective().chosen_units(),
        size: (80, 24),
        preferences,
    })
}

fn snapshot(name: &str, app: &App) {
    insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!(name, styled(app));
    });
}

#[test]
fn settings_hold_at_once_and_are_kept() {
    let mut app = app();
    let effects = press(&mut app, ":set fidelity quick<Enter>");
    assert!(
        matches!(&effects[..], [Command::KeepSettings { settings, .. }] if settings.fidelity == Exactness::Quick)
    );
    assert_eq!(app.settings().fidelity, Exactness::Quick);
    press(&mut app, ":set units mm<Enter>");
    assert_eq!(app.units(), Units::MILLIMETRES);
    press(&mut app, ":set runs=12<Enter>:set live on<Enter>:set glyphs ascii<Enter>");
    assert_eq!(app.settings().runs, Some(12));
    assert!(app.settings().live);
    assert!(text(&app).is_ascii());
    assert!(!app.edited());
    press(&mut app, ":set runs 0<Enter>");
    assert!(text(&app).contains("runs: auto or 1 to 10000"), "{}", text(&app));
    press(&mut app, "<Esc>:set colours none<Enter>");
    assert!(text(&app).contains("settings: units, forces, glyphs, color"), "{}", text(&app));
}

#[test]
fn the_screen_of_settings() {
    let preferences = Preferences {
        flags: vec![(SettingItem::Fidelity, "fine".into())],
        file: Some("/home/anna/.config/meshcast/settings.ron".into()),
        auto: MONO,
        ..Preferences::default()
    };
    let mut app = with(preferences);
    assert_eq!(app.settings().fidelity, Exactness::Fine);
    press(&mut app, ":set<Enter><Right><Down><Down><Down><Down>");
    snapshot("settings", &app);
    // The arrow goes on from what the flag says; the flag is gone then.
    let effects = press(&mut app, "<Left>");
    assert!(
        matches!(&effects[..], [Command::KeepSettings { settings, .. }] if settings.fidelity == Exactness::Standard)
    );
    assert!(!app.preferences().is_flag(SettingItem::Fidelity));
    press(&mut app, "jj<Right>q");
    assert!(app.settings().live);
    assert!(matches!(app.mode(), Mode::Main));
}

#[test]
fn a_flag_is_never_kept() {
    let flags = vec![(SettingItem::Units, "mm".into()), (SettingItem::Runs, "3".into())];
    let mut app = with(Preferences { flags, ..Preferences::default() });
    assert_eq!((app.units(), app.settings().runs), (Units::MILLIMETRES, Some(3)));
    let effects = press(&mut app, ":set live on<Enter>");
    let [Command::KeepSettings { settings, .. }, ..] = &effects[..] else { panic!("{effects:?}") };
    assert_eq!((settings.units, settings.runs, settings.live), (None, None, true));
    assert_eq!(app.settings().runs, Some(3));
}

#[test]
fn a_bad_file_of_settings_is_told_in_full() {
    let trouble = "/home/anna/.config/meshcast/settings.ron cannot be opened\n  line 5, column 15: \
                   fidelity = fast\n    this word is not known here\n    allowed: quick, standard, \
                   fine";
    let preferences = Preferences {
        file: Some("/home/anna/.config/meshcast/settings.ron".into()),
        trouble: Some(trouble.into()),
        auto: MONO,
        ..Preferences::default()
    };
    let mut app = App::new(Start {
        project: Arc::new(road_cut()),
        path: None,
        note: Some("settings.ron line 5, fidelity: fast is none of ...".into()),
        kept: None,
        holder: None,
        look: MONO,
        units: ChosenUnits::default(),
        size: (80, 24),
        preferences,
    });
    assert_eq!(app.status().unwrap().level, Level::Error);
    press(&mut app, ":set<Enter>");
    snapshot("settings_trouble", &app);
    app.update(Message::KeptAtHome(Ok(Some("settings kept; the file ...".into()))));
    assert!(text(&app).contains("settings kept"));
    app.update(Message::KeptAtHome(Err("no room".into())));
    assert!(text(&app).contains("! no room"));
}

fn found(shown: &str, recent: bool, missing: bool, current: bool) -> FoundProject {
    let path = PathBuf::from("/site").join(shown);
    FoundProject { path, shown: shown.into(), recent, missing, current }
}

/// The list of projects, open, with its answer.
fn with_list(app: &mut App) {
    assert!(matches!(press(app, "O")[..], [Command::ListProjects]));
    app.update(Message::Projects(vec![
        found("road-cut.ron", true, false, true),
        found("old/gone.ron", true, true, false),
        found("~/slopes/portal-east.ron", true, false, false),
        found("north/north-side.ron", false, false, false),
        found("north/minor-works.ron", false, false, false),
    ]));
}

fn opens(effects: &[Command]) -> &Path {
    let [Command::OpenProject { path }] = effects else { panic!("{effects:?}") };
    path
}

fn other() -> OpenedProject {
    OpenedProject {
        project: Arc::new(Project::starter("North side")),
        path: "/site/north/north-side.ron".into(),
        note: None,
        kept: None,
        holder: None,
    }
}

#[test]
fn projects_are_found_by_letters_and_opened() {
    let mut app = app();
    with_list(&mut app);
    snapshot("open_list", &app);
    // The open one is not offered first; what is gone is passed over on the way up.
    assert!(opens(&press(&mut app, "<Enter>")).ends_with("portal-east.ron"));
    press(&mut app, "<Up>");
    assert!(opens(&press(&mut app, "<Enter>")).ends_with("road-cut.ron"));
    press(&mut app, "nor");
    snapshot("open_filtered", &app);
    assert!(opens(&press(&mut app, "<Enter>")).ends_with("north-side.ron"));
    // The answers to the first two come too late to matter.
    for _ in 0..2 {
        assert!(app.update(Message::Opened(Ok(other()))).is_empty());
        assert!(matches!(app.mode(), Mode::Open(_)));
    }
    let effects = app.update(Message::Opened(Ok(other())));
    assert!(matches!(effects[..], [Command::TakeOver]), "{effects:?}");
    assert!(matches!(app.mode(), Mode::Main));
    assert_eq!(app.project().name, "North side");
    assert_eq!(app.path().unwrap(), Path::new("/site/north/north-side.ron"));
    assert!(!app.edited());
    assert_eq!((app.history().undo_depth(), app.selected()), (0, 0));
    assert!(text(&app).contains("opened /site/north/north-side.ron"));
}

#[test]
fn nothing_of_the_former_project_is_left() {
    let mut app = app();
    press(&mut app, "<Tab><Down><Right><Right>");
    assert!(app.edited());
    // A path by command; the edits are asked about.
    assert!(press(&mut app, ":open north.ron<Enter>").is_empty());
    snapshot("confirm_open", &app);
    press(&mut app, "<Esc>");
    assert!(app.edited());
    press(&mut app, ":e north.ron<Enter>");
    assert_eq!(opens(&press(&mut app, "d")), Path::new("north.ron"));
    app.update(Message::Opened(Ok(other())));
    assert!(!app.edited());
    assert!(app.unsaved().is_none());
    press(&mut app, "u");
    assert!(text(&app).contains("nothing to undo"));
    assert_eq!(app.project().name, "North side");
}

#[test]
fn saving_first_and_then_opening() {
    let mut app = app();
    press(&mut app, "<Right>:open north.ron<Enter>");
    let effects = press(&mut app, "s");
    let [Command::Save { project, path: None, overwrite: false }] = &effects[..] else {
        panic!("{effects:?}")
    };
    let saved = meshcast::app::message::Saved {
        project: project.clone(),
        path: "/site/road-cut.ron".into(),
        note: None,
    };
    let effects = app.update(Message::Saved(Ok(saved)));
    assert_eq!(opens(&effects), Path::new("north.ron"));
    // A file that changed on disk is asked about in between; the answer goes on, or ends it.
    for (answer, goes_on) in [("o", true), ("<Esc><C-s>", false)] {
        let mut app = self::app();
        press(&mut app, "<Right>:open north.ron<Enter>s");
        let failure = meshcast::app::message::SaveFailure {
            message: "changed by something else".into(),
            overwrite_helps: true,
            holder: None,
            path: None,
        };
        app.update(Message::Saved(Err(failure)));
        let effects = press(&mut app, answer);
        let [Command::Save { project, .. }] = &effects[..] else { panic!("{effects:?}") };
        let saved = meshcast::app::message::Saved {
            project: project.clone(),
            path: "/site/road-cut.ron".into(),
            note: None,
        };
        let effects = app.update(Message::Saved(Ok(saved)));
        assert_eq!(matches!(effects[..], [Command::OpenProject { .. }]), goes_on, "{answer}");
    }
    // A save that fails opens nothing, then and later.
    let mut app = self::app();
    press(&mut app, "<Right>:open north.ron<Enter>s");
    let failure = meshcast::app::message::SaveFailure {
        message: "the disk is full".into(),
        overwrite_helps: false,
        holder: None,
        path: None,
    };
    assert!(app.update(Message::Saved(Err(failure))).is_empty());
    assert!(text(&app).contains("! the disk is full"));
    let effects = press(&mut app, "<C-s>");
    let [Command::Save { project, .. }] = &effects[..] else { panic!("{effects:?}") };
    let saved = meshcast::app::message::Saved {
        project: project.clone(),
        path: "/site/road-cut.ron".into(),
        note: None,
    };
    assert!(app.update(Message::Saved(Ok(saved))).is_empty());
}

#[test]
fn a_project_that_cannot_be_opened_leaves_the_present_one() {
    let mut app = app();
    press(&mut app, "<Right>");
    with_list(&mut app);
    press(&mut app, "nor<Enter>d");
    let message = "north/north-side.ron cannot be opened\n  line 7, column 34: layouts[1].L = 2,5 \
                   (layout \"gully\")\n    a decimal point is expected, not a comma\n    allowed: \
                   above 0, below 100 m"
        .to_string();
    let effects = app.update(Message::Opened(Err(OpenFailure { message })));
    assert!(matches!(effects[..], [Command::ListProjects]));
    app.update(Message::Projects(vec![found("north/minor-works.ron", false, false, false)]));
    snapshot("open_failed", &app);
    press(&mut app, "<Esc>");
    assert!(app.edited());
    assert_eq!(app.project().name, "Road cut");
}

#[test]
fn text_that_fits_nothing_is_a_path() {
    let mut app = app();
    with_list(&mut app);
    app.update(Message::Paste("/far/away site.ron\n".into()));
    assert!(text(&app).contains("Enter takes the text as a path"), "{}", text(&app));
    assert_eq!(opens(&press(&mut app, "<Enter>")), Path::new("/far/away site.ron"));
    // Letters are letters there, q too; Ctrl+G leaves.
    press(&mut app, "<C-u>q<C-g>");
    assert!(matches!(app.mode(), Mode::Main));
    // Without anything to open, Enter does nothing.
    press(&mut app, "O");
    app.update(Message::Projects(Vec::new()));
    assert!(press(&mut app, "<Enter>").is_empty());
}

#[test]
fn edits_kept_of_the_opened_project_are_offered() {
    let mut app = app();
    press(&mut app, ":open north.ron<Enter>");
    let project = Arc::new(Project::starter("North side, mended"));
    let kept = Some(KeptEdits { project, about: vec!["They are of yesterday.".into()] });
    app.update(Message::Opened(Ok(OpenedProject { kept, ..other() })));
    assert!(text(&app).contains("was cut off"));
    press(&mut app, "r");
    assert_eq!(app.project().name, "North side, mended");
    assert!(app.edited());
}

#[test]
fn help_lies_over_every_screen_and_gives_it_back() {
    for (screen, first) in [
        ("", "Main screen"),
        ("i", "Help and details"),
        ("m", "Mesh list"),
        ("<Right>q", "Unsaved edits"),
        (":set<Enter><Down>", "Settings"),
        ("O", "List of projects"),
        ("<Right>:open x.ron<Enter>", "Unsaved edits before opening"),
        (":tour<Enter><Right>", "Tour"),
        ("r<C-u>new name", "While typing"),
    ] {
        let mut app = app();
        press(&mut app, screen);
        let before = text(&app);
        let help = if first == "While typing" { "<F1>" } else { "?" };
        for back in ["q", "<Esc>", "?", "<F1>"] {
            press(&mut app, help);
            let shown = text(&app);
            assert!(shown.lines().nth(2).unwrap().trim() == first, "{screen}: {shown}");
            press(&mut app, "<Down> ");
            press(&mut app, back);
            assert_eq!(text(&app), before, "{screen} {back}");
        }
    }
    let mut app = app();
    press(&mut app, ":set<Enter>?");
    snapshot("help_on_settings", &app);
}

#[test]
fn the_answer_the_table_and_the_page_are_copied() {
    let mut app = app();
    let copied = |effects: Vec<Command>| {
        let [Command::Copy { text }] = &effects[..] else { panic!("{effects:?}") };
        text.clone()
    };
    press(&mut app, "<Down><Down><Down><Down><Down>20<Enter>");
    // Table 1, test 1: 22.8 kN; 20 over 0.88485 of it is 99.1 %.
    let line = copied(press(&mut app, "y"));
    assert!(line.starts_with("bench 2: F_a 22.8 kN, delta_a 0."), "{line}");
    assert!(line.contains("PASSES: strength 99.1 %"), "{line}");
    assert!(line.contains("d 0.25 m, L 2.5"), "{line}");
    assert!(line.ends_with("mesh dt-8x10-2.7") && !line.contains('\n'), "{line}");
    assert!(text(&app).contains("copied, if the terminal takes OSC 52"));

    press(&mut app, "r<C-u>a\tb<Enter>");
    let table = copied(press(&mut app, "Y"));
    let rows: Vec<Vec<&str>> = table.lines().map(|l| l.split('\t').collect()).collect();
    assert_eq!(rows.len(), 6);
    assert!(rows.iter().all(|row| row.len() == rows[0].len()), "{table}");
    let column = |name: &str| rows[0].iter().position(|c| *c == name).unwrap();
    assert_eq!(rows[1][column("d_m")], "0.25");
    assert!(rows[1][column("F_kN")].starts_with("22.8"), "{table}");
    assert_eq!(rows[1][column("design_F_kN")], "20");
    assert_eq!(rows[2][column("design_F_kN")], "");
    // Each column is called as in an exported table, and holds the same.
    let exported = csv::table(&exported(app.project()).unwrap());
    let lines: Vec<Vec<&str>> = exported.lines().map(|l| l.split(',').collect()).collect();
    for (place, name) in rows[0].iter().enumerate().skip(1) {
        let there = lines[0].iter().position(|c| c == name).unwrap_or_else(|| panic!("{name}"));
        for (copied, exported) in rows.iter().zip(&lines) {
            assert_eq!(copied[place], exported[there], "{name}");
        }
    }

    let page = copied(press(&mut app, "iY"));
    assert!(page.contains("Laboratory to field") && page.contains("Curve (Eq. 3)"), "{page}");
    assert!(matches!(app.mode(), Mode::Details { .. }));
}

#[test]
fn the_tour_is_shown_once_in_at_most_five_screens() {
    let first_run = || with(Preferences { tour: true, auto: MONO, ..Preferences::default() });
    let count = meshcast::app::tour::stops().len();
    let mut app = first_run();
    for stop in 1..=count {
        assert!(text(&app).contains(&format!("{stop} of {count}")), "{}", text(&app));
        snapshot(&format!("tour_{stop}"), &app);
        if stop < count {
            assert!(press(&mut app, ["<Enter>", " ", "<Right>"][stop % 3]).is_empty());
        }
    }
    press(&mut app, "<Left><Right>");
    let effects = press(&mut app, "<Enter>");
    assert!(matches!(&effects[..], [Command::KeepSettings { settings, .. }] if settings.tour_seen));
    assert!(matches!(app.mode(), Mode::Main));
    // Shown again when asked for; seen once is seen.
    press(&mut app, ":tour<Enter>");
    assert!(text(&app).contains(&format!("1 of {count}")));
    assert!(press(&mut app, "q").is_empty());
    // It can be left at once, and keys of the main screen do nothing below it.
    for end in ["q", "<Esc>"] {
        let mut app = first_run();
        press(&mut app, "ax<Down>");
        assert_eq!(app.project().layouts.len(), 5);
        assert!(matches!(press(&mut app, end)[..], [Command::KeepSettings { .. }]));
        assert!(matches!(app.mode(), Mode::Main));
    }
}

#[test]
fn the_tour_can_be_read_on_the_smallest_screen() {
    for (width, height) in [(40, 12), (64, 18), (80, 24), (200, 60)] {
        let mut app = app();
        app.update(Message::Resize { width, height });
        press(&mut app, ":tour<Enter>");
        for stop in meshcast::app::tour::stops() {
            let shown = text(&app);
            let last = stop.lines.last().unwrap().split_whitespace().last().unwrap();
            assert!(shown.contains(last), "{width}x{height}, {}: {shown}", stop.title);
            press(&mut app, "<Right>");
        }
    }
}

#[test]
fn a_check_of_the_former_project_ends_when_another_is_opened() {
    let mut app = app();
    assert!(matches!(press(&mut app, "c")[..], [Command::Work(_)]));
    press(&mut app, ":open north.ron<Enter>");
    let effects = app.update(Message::Opened(Ok(other())));
    assert!(effects.iter().any(|e| matches!(e, Command::StopWork)), "{effects:?}");
    assert!(app.running().is_none());
    // Live mode switched off in the settings ends what it runs, too.
    let effects = press(&mut app, "l");
    assert!(effects.iter().any(|e| matches!(e, Command::Work(_))), "{effects:?}");
    let effects = press(&mut app, ":set live off<Enter>");
    assert!(effects.iter().any(|e| matches!(e, Command::StopWork)), "{effects:?}");
}

#[test]
fn while_another_project_is_read_the_present_one_goes_on() {
    let mut app = app();
    press(&mut app, ":open north.ron<Enter><Right>");
    assert!(press(&mut app, "<C-s>").is_empty());
    assert!(text(&app).contains("north.ron is being opened; wait for it"));
    // The edit was made after it was asked for, and is asked about.
    let effects = app.update(Message::Opened(Ok(other())));
    assert!(matches!(effects[..], [Command::LetGo]), "{effects:?}");
    assert!(app.edited() && app.project().name == "Road cut");
    assert_eq!(opens(&press(&mut app, "d")), Path::new("north.ron"));
    let effects = app.update(Message::Opened(Ok(other())));
    assert!(matches!(effects[..], [Command::TakeOver]), "{effects:?}");
    assert_eq!(app.project().name, "North side");
}

#[test]
fn a_project_that_was_left_again_is_not_opened() {
    let mut app = app();
    with_list(&mut app);
    press(&mut app, "nor<Enter><Esc>");
    let effects = app.update(Message::Opened(Ok(other())));
    assert!(matches!(effects[..], [Command::LetGo]), "{effects:?}");
    assert_eq!(app.project().name, "Road cut");
}

#[test]
fn opening_waits_for_a_save_that_runs() {
    let mut app = app();
    let Command::Save { project, .. } = press(&mut app, "<Right><C-s>").remove(0) else { panic!() };
    assert!(press(&mut app, ":open north.ron<Enter>").is_empty());
    assert!(matches!(app.mode(), Mode::Main));
    let saved = Saved { project, path: "/site/road-cut.ron".into(), note: None };
    assert_eq!(opens(&app.update(Message::Saved(Ok(saved)))), Path::new("north.ron"));
}

/// Fault: a layout that is strong enough and gives way too far looked fine everywhere but in the report.
/// By hand, d 0.25, L 3, D 0.6 m at 20 kN: some 0.63 m, where 0.40 m are allowed.
#[test]
fn too_large_a_deflection_is_said_in_answer_details_and_comparison() {
    let layout = |allowed| {
        let geometry =
            Layout { plate: 0.25, spacing: 3.0, punch: 0.6, ex: 0.0, ey: 0.0, ..REFERENCE };
        let mut layout = NamedLayout::new("cut", geometry, REFERENCE_ID);
        layout.question.force = Some(20_000.0);
        layout.question.deflection = Some(allowed);
        layout
    };
    let mut shown = Vec::new();
    for allowed in [0.4, 0.7] {
        let mut project = Project::starter("Cut");
        project.layouts = vec![layout(allowed)];
        // High enough for the whole page of details.
        let mut app = start(project, (120, 90), MONO);
        let answer = text(&app);
        press(&mut app, "i");
        let details = text(&app);
        press(&mut app, "<Esc>v");
        shown.push([answer, details, text(&app)]);
    }
    // One wording in all places; 0.629 m are 157 % of 0.4 m and 90 % of 0.7 m.
    let word = "FAILS: deflection 157 %";
    for (bad, good) in shown[0].iter().zip(&shown[1]) {
        assert!(bad.contains(word), "{word} is missing in\n{bad}");
        assert!(!good.contains("FAILS") && good.contains("PASSES"), "\n{good}");
    }
}

/// Home and End in the lists that go round overflowed.
#[test]
fn lists_that_go_round_have_ends_too() {
    let mut app = app();
    press(&mut app, "e<End>");
    assert!(matches!(app.mode(), Mode::Export { index: 6.. }), "{:?}", app.mode());
    press(&mut app, "<Down>");
    assert!(matches!(app.mode(), Mode::Export { index: 0 }), "{:?}", app.mode());
    press(&mut app, "<End><Home>");
    assert!(matches!(app.mode(), Mode::Export { index: 0 }), "{:?}", app.mode());
    press(&mut app, "<Esc>m<End><Home>");
    assert!(matches!(app.mode(), Mode::MeshPicker { index: 0 }), "{:?}", app.mode());
}

#[test]
fn a_mesh_is_added_by_a_form_and_saved_with_the_project() {
    let mut app = app();
    let before = app.layout().mesh.clone();
    press(&mut app, "ma");
    assert!(text(&app).contains("a mesh for this project"), "{}", text(&app));
    // Help lies over it and gives it back; a q is text here, and Enter goes through the rows.
    press(&mut app, "ht?<Esc>q<Enter>High tensile<Enter>180<Enter>450 mm<Enter>");
    press(&mut app, "<Enter><Enter><Enter>the maker's sheet<Enter>");
    assert!(text(&app).contains("mean, characteristic or minimum?"), "{}", text(&app));
    assert_eq!(app.layout().mesh, before);
    press(&mut app, "c<Enter><Enter><Enter><Enter>");
    assert_eq!(app.layout().mesh, "htq");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.ron");
    project::create(&path, &project::new_project("x")).unwrap();
    project::load(&path).unwrap().document.save(app.project(), Overwrite::No).unwrap();
    let again = project::load(&path).unwrap().project;
    let mesh = again.mesh(&again.layouts[0]).expect("it is in the file");
    assert_eq!((mesh.name.as_str(), mesh.laboratory.force), ("High tensile", 180_000.0));
    assert_eq!(mesh.laboratory.deflection, Some(0.45));
    assert_eq!(mesh.laboratory.statistic, Statistic::Characteristic);
    assert_eq!(
        (mesh.laboratory.panel, mesh.laboratory.source.as_str()),
        (3.0, "the maker's sheet")
    );
    // One edit, which can be undone.
    press(&mut app, "u");
    assert_eq!(app.layout().mesh, before);
    // A second one of that identifier, a force without a number, a panel smaller than the punch.
    let tried = |app: &mut App, keys: &str| {
        press(app, "ma");
        press(app, keys);
        let said = crate::harness::text(app);
        press(app, "<Esc><Esc>");
        said
    };
    let same = format!("{before}<Enter><Enter>1<Enter><Enter>m<Enter><Enter><Enter>s<Enter>");
    assert!(tried(&mut app, &same).contains("already; take another identifier"));
    let said = tried(&mut app, "a<Enter><Enter>x<Enter>");
    assert!(said.contains(r#""x" is not a number"#), "{said}");
    let said = tried(&mut app, "a<Enter><Enter>1<Enter><Enter>m<Enter>0.5<Enter>");
    assert!(said.contains("no punch fits into a panel"), "{said}");
    // The lists are looked through too.
    press(&mut app, "e/table<Enter>");
    assert!(matches!(app.mode(), Mode::Export { index: 1.. }), "{:?}", app.mode());
}

#[test]
fn the_envelope_of_the_curves_is_drawn_around_a_derived_forecast_only() {
    let mut app = start(road_cut(), (80, 24), ASCII);
    // The sign that its lines have in plain characters; the plan and the chart have no other commas.
    let dots = |app: &App| {
        let all = text(app);
        let chart = all.lines().filter(|line| line.contains('|')).collect::<String>();
        chart.matches(',').count()
    };
    let without = dots(&app);
    press(&mut app, "M");
    assert!(dots(&app) > without + 5, "{} {without}: {}", dots(&app), text(&app));
    press(&mut app, "u");
    assert_eq!(dots(&app), without);
}

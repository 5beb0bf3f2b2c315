//! Checks by simulation through the program's state: news of invented results are given to the state.
//! One test, and those of `tests/terminal`, let the solver make them.

use crate::canned::{self, news};
use crate::harness::*;
use meshcast::app::App;
use meshcast::app::message::{Command, Message};
use meshcast::app::work::shown::Standing;
use meshcast::curve::Point;
use meshcast::job::news::{Progress, What};
use meshcast::job::order::Task;
use meshcast::job::{News, Ticket};
use meshcast::layout::Blocks;
use meshcast::study::exactness::Exactness;
use meshcast::study::remark::CheckFlag;
use meshcast::study::result::{Revisions, Wanted};
use std::sync::{Arc, Mutex};

fn app() -> App {
    let mut app = start(small(), (80, 24), COLOR);
    press(&mut app, ":runs 2<Enter>:fidelity quick<Enter>");
    app
}

fn check(app: &mut App, script: &str) -> usize {
    let effects = press(app, script);
    work(app, effects).len()
}

#[test]
fn a_check_is_kept_goes_stale_and_comes_back() {
    let mut app = app();
    assert_eq!(check(&mut app, "c"), 1);
    assert!(app.edited(), "a check that was asked for is kept with the project");
    let shown = app.shown_check().unwrap();
    assert_eq!(shown.standing, Standing::Current);
    assert_eq!(shown.result.runs, 2);
    let force = shown.result.force.mean;
    assert!(shown.relief.is_some());
    press(&mut app, "<Down><Right>");
    assert!(app.shown_check().unwrap().stale());
    assert!(text(&app).contains("stale"), "{}", text(&app));
    press(&mut app, "u");
    assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
    // A check is undone like an edit: the one before it comes back, and then its inputs.
    press(&mut app, "<Right>");
    check(&mut app, "c");
    assert_ne!(app.shown_check().unwrap().result.force.mean, force);
    press(&mut app, "u");
    assert!(text(&app).contains("undone: check of one"), "{}", text(&app));
    assert!(app.shown_check().unwrap().stale(), "the first result belongs to the other value");
    assert_eq!(app.shown_check().unwrap().result.force.mean, force);
    press(&mut app, "u");
    assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
    press(&mut app, "UU");
    assert_ne!(app.shown_check().unwrap().result.force.mean, force);
    assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
    assert!(!text(&app).contains("stale"));
}

#[test]
fn all_layouts_are_checked_in_one_go() {
    let mut app = app();
    assert_eq!(check(&mut app, "C"), 1);
    let standing = |i: usize| app.kept_check(i).map(|shown| shown.standing);
    assert_eq!(standing(0), Some(Standing::Current));
    assert_eq!(standing(1), Some(Standing::Current));
    assert_eq!(standing(2), None);
    let said = app.status().unwrap().text.clone();
    assert_eq!(said, "2 of 3 layouts checked; not possible: on a plate");
}

#[test]
fn checks_of_all_layouts_are_one_undo() {
    let mut app = app();
    check(&mut app, "C");
    assert_eq!(app.history().undo_depth(), 1);
    press(&mut app, "u");
    assert!((0..2).all(|i| app.kept_check(i).is_none()) && !app.edited());
    press(&mut app, "U");
    assert!((0..2).all(|i| app.kept_check(i).is_some()));
}

#[test]
fn a_mesh_without_wires_is_refused_in_words() {
    let mut project = small();
    let mut mesh = (*project.mesh(&project.layouts[0]).unwrap()).clone();
    mesh.wire = None;
    project.meshes = vec![meshcast::project::MeshUse::Inline(mesh.into())];
    let mut app = start(project, (80, 24), COLOR);
    check(&mut app, "c");
    let said = app.status().unwrap().text.clone();
    assert!(said.contains("no wire data"), "{said}");
    assert!(app.shown_check().is_none() && !app.edited());
}

#[test]
fn live_checks_follow_edits_and_leave_the_project_alone() {
    let mut app = app();
    let effects = press(&mut app, "l");
    assert_eq!(work(&mut app, effects).len(), 1, "switching it on is reason enough");
    assert_eq!(app.shown_check().unwrap().standing, Standing::Live(false));
    assert!(!app.edited());
    // A key that changes no input starts nothing.
    assert_eq!(check(&mut app, "n<Esc>?q"), 0);
    // Of two edits the newer order is the one whose result is shown.
    let first = press(&mut app, "<Down><Right>");
    let [Command::Work(first)] = &first[..] else { panic!("{first:?}") };
    assert!(app.shown_check().unwrap().stale(), "the old result is not the new inputs'");
    let second = press(&mut app, "<Right>");
    for late in news(first) {
        app.update(Message::Work(late));
    }
    assert!(app.shown_check().unwrap().stale());
    work(&mut app, second);
    assert_eq!(app.shown_check().unwrap().standing, Standing::Live(false));
    // The kept one goes first, and no live check is made where it is current.
    check(&mut app, "c");
    assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
    assert_eq!(check(&mut app, "<Tab>"), 1);
    assert_eq!(check(&mut app, "<BackTab>"), 0);
    press(&mut app, "l");
    assert_eq!(check(&mut app, "<Tab><Right>"), 0, "switched off");
}

#[test]
fn escape_ends_what_runs_and_what_is_done_is_kept() {
    let mut app = app();
    let effects = press(&mut app, "c");
    let [Command::Work(order)] = &effects[..] else { panic!("{effects:?}") };
    let uid = app.layout().uid;
    let progress = Progress {
        uid,
        parts: 1,
        done: 1,
        planned: 2,
        fraction: 0.5,
        left: 3.0,
        ..Progress::default()
    };
    app.update(Message::Work(News { number: order.number, what: What::Progress(progress) }));
    let bottom = text(&app).lines().last().unwrap().to_string();
    assert_eq!(bottom, " checking one: 1 of 2 runs, 50 %, 3 s left; Esc ends it");
    let effects = press(&mut app, "<Esc>");
    assert!(matches!(&effects[..], [Command::StopWork]));
    // The worker does what it is told: here the first run is done and the second is not.
    let mut short = order.clone();
    let Task::Checks(checks) = &mut short.task else { panic!("{short:?}") };
    checks.wanted.runs = Some(1);
    for news in news(&short) {
        let what = match news.what {
            What::Ended { .. } => What::Ended { cancelled: true },
            other => other,
        };
        app.update(Message::Work(News { what, ..news }));
    }
    assert_eq!(app.shown_check().unwrap().result.runs, 1);
    assert!(app.running().is_none());
    let effects = press(&mut app, "<C-g>");
    assert!(effects.is_empty(), "there is nothing to end any more");
    assert!(app.status().unwrap().text.contains("nothing is running"));
}

#[test]
fn a_fault_in_the_worker_leaves_the_program_ready() {
    let mut app = app();
    let effects = press(&mut app, "c");
    let [Command::Work(order)] = &effects[..] else { panic!("{effects:?}") };
    app.update(Message::Trouble("a part of the program failed and was stopped".into()));
    app.update(Message::Work(News { number: order.number, what: What::Failed }));
    assert!(app.running().is_none());
    assert_eq!(check(&mut app, "c"), 1);
    assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
}

#[test]
fn screens_with_a_check() {
    for (name, size, look) in PICTURES {
        let mut app = start(small(), size, look);
        press(&mut app, ":runs 3<Enter>:fidelity quick<Enter>");
        check(&mut app, "c");
        press(&mut app, "<Down>");
        insta::assert_snapshot!(format!("check_{name}"), styled(&app));
    }
    let mut app = app();
    check(&mut app, "c");
    press(&mut app, "<Right>i");
    // The fingerprint is not the screen's to say.
    let print = app.shown_check().unwrap().result.inputs.to_string();
    insta::assert_snapshot!("check_details", text(&app).replace(&print, "(16 digits)     "));
}

#[test]
fn screens_with_a_check_that_is_not_plain() {
    for name in ["slipped", "partial", "diverged", "bifurcation"] {
        let mut project = small();
        let mesh = project.mesh(&project.layouts[0]).unwrap();
        let wanted = Wanted { fidelity: Exactness::Quick, runs: None, seed: 0 };
        let made = canned::named(name, &project.layouts[0].layout, &mesh, &wanted);
        project.layouts[0].check = Some(made.into());
        let app = start(project, (80, 24), COLOR);
        assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
        insta::assert_snapshot!(format!("check_{name}"), text(&app));
    }
    let mut app = app();
    check(&mut app, "c");
    press(&mut app, "<Down><Right>");
    insta::assert_snapshot!("check_stale", styled(&app));
    check(&mut app, "l");
    insta::assert_snapshot!("check_live", styled(&app));
}

#[test]
fn a_single_block_that_has_not_converged_says_so_with_its_last_change() {
    let mut project = small();
    project.layouts[0].layout.blocks = Blocks::Single;
    let mesh = project.mesh(&project.layouts[0]).unwrap();
    let wanted = Wanted { fidelity: Exactness::Quick, runs: None, seed: 0 };
    let mut made = canned::named("whole", &project.layouts[0].layout, &mesh, &wanted);
    made.flags.push(CheckFlag::from_code("not_converged"));
    made.field.arrangement = Some("single in 7 x 7 cells, not converged, last change 8.6 %".into());
    project.layouts[0].check = Some(made.into());
    let mut app = start(project, (80, 24), COLOR);
    assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
    assert!(text(&app).contains("not converged"), "{}", text(&app));
    press(&mut app, "i");
    let mut pages = String::new();
    for _ in 0..8 {
        pages.push_str(&text(&app));
        press(&mut app, "<PgDn>");
    }
    // As one line, without the breaks of a narrow page.
    let pages = pages.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(pages.contains("single in 7 x 7 cells, not converged, last change 8.6 %"), "{pages}");
    assert!(pages.contains("a single block, not converged"), "{pages}");
    assert!(!pages.contains("8.6 %, the lowest"), "{pages}");
}

/// The solver itself behind the state: what its results mean, not what they are.
#[test]
fn what_the_solver_makes_is_taken_and_current() {
    let mut app = app();
    let effects = press(&mut app, "c");
    let [Command::Work(order)] = &effects[..] else { panic!("{effects:?}") };
    let heard = Mutex::new(Vec::new());
    order.carry_out(1, &Ticket::default(), &|news| heard.lock().unwrap().push(news));
    for news in heard.into_inner().unwrap() {
        app.update(Message::Work(news));
    }
    let shown = app.shown_check().unwrap();
    assert_eq!(shown.standing, Standing::Current);
    assert_eq!((shown.result.runs, shown.result.slipped, shown.result.breaks.len()), (2, 0, 2));
    // The punch is in the middle, and there the net is highest, as far out as the punch.
    let relief = shown.relief.unwrap();
    let (highest, deflection) = (relief.highest, shown.result.breaks[0].at.deflection);
    assert!((highest / deflection - 1.0).abs() < 0.1, "{highest} {deflection}");
    assert!(text(&app).contains("DEM "), "{}", text(&app));
    // What the plates catch is told, with what each pattern carries.
    press(&mut app, "i");
    let mut told = text(&app);
    for _ in 0..5 {
        press(&mut app, "<PgDn>");
        told += &text(&app);
    }
    // Lines are broken where the page ends.
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("a plate catches ") && told.contains(" of the slope"), "{told}");
    press(&mut app, "<Esc><Down><Right>");
    assert!(app.shown_check().unwrap().stale());
}

#[test]
fn a_check_grows_on_the_chart_while_it_runs() {
    let mut app = app();
    let effects = press(&mut app, "c");
    let [Command::Work(order)] = &effects[..] else { panic!("{effects:?}") };
    let before = text(&app);
    let point = |k: usize| Point { deflection: 0.05 * k as f64, force: 3_000.0 * k as f64 };
    let progress = Progress {
        uid: app.layout().uid,
        parts: 1,
        planned: 2,
        curves: vec![(0..6).map(point).collect()],
        ..Progress::default()
    };
    app.update(Message::Work(News { number: order.number, what: What::Progress(progress) }));
    let chart = |text: &str| text.lines().take(14).collect::<Vec<_>>().join("\n");
    assert_ne!(chart(&before), chart(&text(&app)));
    // News of an order that is not the last one change nothing.
    let now = text(&app);
    let late = Progress { uid: app.layout().uid, done: 7, ..Progress::default() };
    app.update(Message::Work(News { number: order.number + 9, what: What::Progress(late) }));
    assert_eq!(now, text(&app));
}

/// The forecast carries the load and the check does not: what would mend it is not known, as only the
/// forecast is searched, and that is said instead of a plate that mends nothing.
#[test]
fn where_the_check_alone_fails_no_cure_is_invented() {
    let mut project = small();
    project.basis = meshcast::study::verdict::Basis::Mean;
    let mut app = start(project, (80, 24), COLOR);
    press(&mut app, ":runs 2<Enter>:fidelity quick<Enter>");
    check(&mut app, "c");
    let check = app.shown_check().unwrap().result.force.mean;
    let forecast = app.result().forecast().unwrap().field.unwrap().values.force;
    assert!(check < forecast, "{check} {forecast}");
    press(
        &mut app,
        &format!("<Down><Down><Down><Down><Down>{:.3}<Enter>i", (check + forecast) / 2e3),
    );
    // Lines are broken where the page ends.
    let shown = text(&app).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(shown.contains("FAILS"), "{shown}");
    assert!(shown.contains("only the forecast is searched"), "{shown}");
}

#[test]
fn a_result_of_another_solver_is_stale() {
    let mut app = app();
    check(&mut app, "c");
    let mut project = (**app.project()).clone();
    let mut older = (*project.layouts[0].check.clone().unwrap()).clone();
    older.by.solver += 1;
    project.layouts[0].check = Some(older.into());
    let app = start(project, (80, 24), COLOR);
    assert!(app.shown_check().unwrap().stale() && text(&app).contains("stale"));
}

/// All pages of the details as one line, without the breaks of a narrow page.
fn details(app: &mut App) -> String {
    press(app, "i");
    let mut pages = String::new();
    for _ in 0..8 {
        pages.push_str(&text(app));
        press(app, "<PgDn>");
    }
    press(app, "<Esc>");
    pages.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_check_kept_at_another_fidelity_than_the_default_stays_current() {
    for fidelity in [Exactness::Standard, Exactness::Auto] {
        let mut project = small();
        let mesh = project.mesh(&project.layouts[0]).unwrap();
        let wanted = Wanted { fidelity, runs: None, seed: 0 };
        let made = canned::named("whole", &project.layouts[0].layout, &mesh, &wanted);
        project.layouts[0].check = Some(made.into());
        let mut app = start(project, (80, 24), COLOR);
        assert_eq!(app.settings().fidelity, Exactness::Auto);
        assert_eq!(app.shown_check().unwrap().standing, Standing::Current);
        let told = details(&mut app);
        let words = match fidelity {
            Exactness::Auto => {
                "fidelity auto (quick runs, as slow as it takes for a mean known to 1 %)"
            }
            _ => "fidelity standard force",
        };
        assert!(told.contains(words), "{told}");
        assert_eq!(told.contains("%, by itself"), fidelity == Exactness::Auto);
        // What is asked for now is asked of the next one.
        let effects = press(&mut app, "c");
        let [Command::Work(order)] = &effects[..] else { panic!("{effects:?}") };
        let Task::Checks(checks) = &order.task else { panic!("{order:?}") };
        assert_eq!(checks.wanted.fidelity, Exactness::Auto);
    }
}

#[test]
fn of_one_run_by_the_default_its_own_estimate_is_told() {
    let mut project = small();
    let mesh = project.mesh(&project.layouts[0]).unwrap();
    let wanted = Wanted { runs: Some(1), ..Wanted::default() };
    let mut made = canned::named("whole", &project.layouts[0].layout, &mesh, &wanted);
    made.runs = 1;
    made.breaks.truncate(1);
    made.quality.error_estimate = 0.04;
    project.layouts[0].check = Some(made.into());
    let mut app = start(project, (80, 24), COLOR);
    let told = details(&mut app);
    assert!(told.contains("fidelity auto (standard runs)"), "{told}");
    assert!(
        told.contains("estimated error of a run up to 4.0 %, where standard aims at 1.0 %"),
        "{told}"
    );
}

#[test]
fn what_a_new_solver_changed_is_told_of_each_layout() {
    let mut app = app();
    check(&mut app, "C");
    // The same checks as another solver kept them, of a project that is opened anew.
    let mut project = (**app.project()).clone();
    for layout in &mut project.layouts {
        let Some(kept) = &layout.check else { continue };
        let mut old = (**kept).clone();
        old.by = Revisions { solver: 1, sampling: 1 };
        old.force.mean /= 1.25;
        layout.check = Some(Arc::new(old));
    }
    let mut app = start(project, (100, 120), COLOR);
    press(&mut app, ":runs 2<Enter>:fidelity quick<Enter>");
    let page = |app: &mut App| {
        press(app, "i");
        let lines = text(app);
        press(app, "<Esc>");
        lines.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    assert!(!page(&mut app).contains("Checks made again"));
    check(&mut app, "C");
    let said = &app.status().unwrap().text;
    assert!(said.contains("i: what the new solver changed"), "{said}");
    let page = page(&mut app);
    let told = page.split("Checks made again").nth(1).unwrap_or_else(|| panic!("{page}"));
    let at = |name: &str| told.find(name).unwrap_or_else(|| panic!("{told}"));
    let (one, two) = (at("one: "), at("two: "));
    for part in [&told[one..two], &told[two..]] {
        assert!(part.contains("by solver 1, sampling 1, quick; now F +25 %, delta +0 %"), "{part}");
    }
}

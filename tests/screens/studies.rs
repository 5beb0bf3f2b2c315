//! The pages of studies: what they show at once, what their checks add, what an edit does to it.

use crate::canned::news;
use crate::harness::*;
use meshcast::app::App;
use meshcast::app::look::Look;
use meshcast::app::message::{Command, Message};
use meshcast::job::news::{Progress, What};
use meshcast::job::order::Task;
use meshcast::job::{News, Order};
use meshcast::project::schema::Project;

/// The small cells, the first with a design force.
fn asked() -> Project {
    let mut project = small();
    project.layouts[0].question.force = Some(12_000.0);
    project
}

fn app(size: (u16, u16)) -> App {
    with_look(size, COLOR)
}

fn with_look(size: (u16, u16), look: Look) -> App {
    let mut app = start(asked(), size, look);
    press(&mut app, ":runs 2<Enter>:fidelity quick<Enter>?q");
    app
}

/// The one order among some effects.
fn order(effects: Vec<Command>) -> Order {
    let [Command::Work(order)] = &effects[..] else { panic!("{effects:?}") };
    order.clone()
}

/// Presses keys and does the work they ask for; tells how many cases or layouts it was.
fn work(app: &mut App, script: &str) -> usize {
    let effects = press(app, script);
    let size = |order: &Order| match &order.task {
        Task::Checks(checks) => checks.targets.len(),
        Task::Campaign(campaign) => campaign.cases.len(),
        Task::Method(job) => panic!("no check: {job:?}"),
        Task::Adopt(job) => panic!("no check: {job:?}"),
    };
    crate::harness::work(app, effects).iter().map(size).sum()
}

fn said(app: &App) -> String {
    app.status().map_or(String::new(), |s| s.text.clone())
}

#[test]
fn a_page_opens_closes_and_keeps_its_place_under_the_help() {
    for (key, word) in [
        ("s", "sensitivity of"),
        ("w", "sweep of"),
        ("v", "compare: in the project"),
        ("g", "design of"),
        ("S", "tolerance of"),
    ] {
        let mut app = app((80, 24));
        let main = text(&app);
        press(&mut app, key);
        assert!(text(&app).contains(word), "{}", text(&app));
        press(&mut app, "?");
        assert!(!text(&app).contains(word));
        press(&mut app, "q");
        assert!(text(&app).contains(word), "help goes back to the page");
        for leave in ["q", "<Esc>", "<C-g>", "<C-c>"] {
            press(&mut app, leave);
            assert_eq!(text(&app), main, "{leave}");
            press(&mut app, key);
        }
        assert!(!app.edited());
    }
}

#[test]
fn sensitivity_by_forecast_at_once_and_by_checks_beside_it() {
    let mut app = app((80, 24));
    press(&mut app, "s");
    let view = app.sensitivity().unwrap();
    assert_eq!((view.forecast.bars.len(), view.coverage.have), (7, 0));
    assert_eq!(work(&mut app, "c"), 11, "the layout, and two steps of d, L, D, ex, ey");
    let view = app.sensitivity().unwrap();
    assert_eq!((view.coverage.have, view.coverage.of, view.coverage.stale), (11, 11, false));
    let change = view.checked.bars[1].raised.change.unwrap();
    assert_eq!(said(&app), "11 cases checked");
    // Nothing is checked twice, and another value is shown of the same checks.
    assert_eq!(work(&mut app, "c"), 0);
    assert!(said(&app).starts_with("all of it is checked"), "{}", said(&app));
    press(&mut app, "<Right><Right>");
    assert!(text(&app).contains("change of use"), "{}", text(&app));
    press(&mut app, "<Right>");
    // An edit leaves nothing that could be taken for current; undoing it brings the same back.
    press(&mut app, "q<Down><Right>s");
    let view = app.sensitivity().unwrap();
    assert!(view.coverage.stale && view.checked.base.is_err());
    assert!(text(&app).contains("stale"), "{}", text(&app));
    press(&mut app, "u");
    let view = app.sensitivity().unwrap();
    assert!(!view.coverage.stale);
    assert_eq!(view.checked.bars[1].raised.change, Some(change));
    // Another layout has not been checked, which is not the same as stale.
    press(&mut app, "<Tab>");
    assert!(!app.sensitivity().unwrap().coverage.stale);
    assert!(text(&app).contains("not made"));
    // Other seeds or fidelity, other checks.
    press(&mut app, "<BackTab>f");
    assert_eq!(app.sensitivity().unwrap().coverage.have, 0);
    press(&mut app, "ff");
    assert_eq!(app.sensitivity().unwrap().coverage.have, 11);
}

#[test]
fn a_layout_without_a_value_says_why() {
    let mut app = app((80, 24));
    press(&mut app, "<BackTab>s");
    assert!(text(&app).contains("the block is on an anchor plate"), "{}", text(&app));
}

#[test]
fn escape_ends_a_campaign_first_and_keeps_what_is_done() {
    let mut app = app((80, 24));
    press(&mut app, "s");
    let order = order(press(&mut app, "c"));
    let all = news(&order);
    let (first, rest) = all.split_at(1);
    assert!(matches!(first[0].what, What::Case { index: 0, .. }), "{first:?}");
    app.update(Message::Work(first[0].clone()));
    let progress =
        Progress { part: 1, parts: 11, fraction: 0.25, left: 6.0, ..Progress::default() };
    app.update(Message::Work(News { number: order.number, what: What::Progress(progress) }));
    let bottom = |app: &App| text(app).lines().last().unwrap().to_string();
    assert_eq!(bottom(&app), " sensitivity: check 2 of 11, 25 %, 6 s left; Esc ends it");
    // It goes on behind the main screen, and escape ends it there too.
    press(&mut app, "q");
    assert!(bottom(&app).contains("check 2 of 11"));
    press(&mut app, "s");
    let effects = press(&mut app, "<Esc>");
    assert!(matches!(&effects[..], [Command::StopWork]));
    assert!(app.page_open().is_some(), "the page stays");
    app.update(Message::Work(News { number: order.number, what: What::Ended { cancelled: true } }));
    assert_eq!(said(&app), "ended early; 1 of 11 cases are kept");
    assert_eq!(app.sensitivity().unwrap().coverage.have, 1);
    press(&mut app, "<Esc>");
    assert!(app.page_open().is_none());
    // What is late belongs to nobody; what is missing is made when asked for.
    for late in rest {
        app.update(Message::Work(late.clone()));
    }
    assert!(app.campaign().is_none());
    press(&mut app, "s");
    assert_eq!(work(&mut app, "c"), 10);
    assert_eq!(app.sensitivity().unwrap().coverage.have, 11);
}

#[test]
fn a_check_takes_the_place_of_a_campaign_and_the_other_way_round() {
    let mut app = app((80, 24));
    press(&mut app, "s");
    let campaign = order(press(&mut app, "c"));
    press(&mut app, "q");
    let check = order(press(&mut app, "c"));
    assert!(app.campaign().is_none() && app.running().is_some());
    app.update(Message::Work(News {
        number: campaign.number,
        what: What::Ended { cancelled: true },
    }));
    assert!(app.running().is_some());
    press(&mut app, "s");
    order(press(&mut app, "c"));
    assert!(app.campaign().is_some() && app.running().is_none());
    app.update(Message::Work(News { number: check.number, what: What::Failed }));
    assert!(app.campaign().is_some());
}

#[test]
fn a_mesh_without_wires_has_no_campaign() {
    let mut project = asked();
    let mut mesh = (*project.mesh(&project.layouts[0]).unwrap()).clone();
    mesh.wire = None;
    project.meshes = vec![meshcast::project::MeshUse::Inline(mesh.into())];
    let mut app = start(project, (80, 24), COLOR);
    assert_eq!(work(&mut app, "sc"), 0);
    assert!(said(&app).contains("no wire data"), "{}", said(&app));
    assert!(text(&app).contains("F_l*"), "the forecast is there all the same");
}

#[test]
fn the_table_is_sorted_scrolled_and_selected_from() {
    let mut app = app((80, 24));
    press(&mut app, "v");
    let names = |app: &App| -> Vec<String> {
        let view = app.comparison().unwrap();
        view.order.iter().map(|row| view.comparison.rows[*row].name.clone()).collect()
    };
    assert_eq!(names(&app), ["one", "two", "on a plate"]);
    press(&mut app, ">");
    assert_eq!(names(&app), ["on a plate", "one", "two"]);
    press(&mut app, "-");
    assert_eq!(names(&app), ["two", "one", "on a plate"]);
    // Without a value last, either way: by F_a.
    press(&mut app, ">>>>>>");
    assert!(text(&app).contains("by F_a, falling"), "{}", text(&app));
    assert_eq!(names(&app), ["two", "one", "on a plate"]);
    press(&mut app, "-");
    assert_eq!(names(&app), ["one", "two", "on a plate"]);
    press(&mut app, "<Right><Right>");
    assert!(text(&app).contains("<- more") && text(&app).contains("F/Fl"), "{}", text(&app));
    press(&mut app, "<Down><Enter>");
    assert!(app.page_open().is_none());
    assert_eq!(app.layout().name, "two");
    assert!(!app.edited());
    press(&mut app, "v");
    assert_eq!(app.comparison_marked(), 1);
    press(&mut app, &"<lt>".repeat(9));
    assert_eq!(app.comparison_sort(), None);
}

#[test]
fn the_checks_of_a_comparison_are_those_of_the_project() {
    let mut app = app((80, 24));
    assert_eq!(work(&mut app, "vc"), 3);
    let checked = |app: &App| -> Vec<Option<bool>> {
        app.comparison().unwrap().checked.iter().map(|c| c.map(|c| c.stale)).collect()
    };
    assert_eq!(checked(&app), [Some(false), Some(false), None]);
    assert!(app.edited(), "they are kept with the project");
    press(&mut app, "q<Down><Right>v");
    assert_eq!(checked(&app), [Some(true), Some(false), None]);
    assert!(text(&app).contains("stale"), "{}", text(&app));
    press(&mut app, "u");
    assert_eq!(checked(&app), [Some(false), Some(false), None]);
}

#[test]
fn a_sweep_is_a_line_at_once_and_points_come_one_by_one() {
    let mut app = app((80, 24));
    press(&mut app, "w");
    let view = app.sweep().unwrap();
    let axis = view.axes[0];
    assert_eq!((axis.input.word(), axis.from, axis.to, axis.steps), ("L", 1.25, 4.5, 9));
    // Its range is chosen by arrows and by typing, with units.
    press(
        &mut app,
        "<Down>1200mm<Enter><Down>1.4<Enter><Down><Left><Left><Left><Left><Left><Left>",
    );
    let axis = app.sweep().unwrap().axes[0];
    assert_eq!((axis.from, axis.to, axis.steps), (1.2, 1.4, 3));
    let order = order(press(&mut app, "c"));
    let dem = |app: &App| -> Vec<bool> {
        app.sweep().unwrap().figures.iter().map(Option::is_some).collect()
    };
    for (k, news) in
        news(&order).into_iter().filter(|n| matches!(n.what, What::Case { .. })).enumerate()
    {
        app.update(Message::Work(news));
        assert_eq!(dem(&app).iter().filter(|d| **d).count(), k + 1);
    }
    app.update(Message::Work(News {
        number: order.number,
        what: What::Ended { cancelled: false },
    }));
    // Other points, none of them checked; what was checked is known where it comes up again.
    press(&mut app, "<Right><Right>");
    assert_eq!(dem(&app), [true, false, true, false, true]);
    press(&mut app, "<Left><Left>");
    assert_eq!(dem(&app), [true; 3]);
    // The marked point is taken into the layout, which undo takes back.
    press(&mut app, &"<lt>".repeat(9));
    press(&mut app, ">a");
    assert_eq!(app.layout().layout.spacing, 1.3, "it was 1.3 before");
    assert!(said(&app).contains("is like that already"));
    press(&mut app, ">a");
    assert_eq!(app.layout().layout.spacing, 1.4);
    assert_eq!(dem(&app), [true; 3], "the swept input itself is no other input");
    press(&mut app, "u");
    assert_eq!(app.layout().layout.spacing, 1.3);
    // Another input of the layout makes all of it stale.
    press(&mut app, "q<Right>w");
    assert!(app.sweep().unwrap().coverage.stale);
    assert!(text(&app).contains("stale"), "{}", text(&app));
}

#[test]
fn a_second_input_makes_a_map() {
    let mut app = app((80, 24));
    press(&mut app, "w2");
    let view = app.sweep().unwrap();
    assert_eq!((view.axes.len(), view.points.len(), view.axes[1].input.word()), (2, 45, "D"));
    assert!(text(&app).contains("F_a kN:"), "{}", text(&app));
    // The other axis never takes the same input.
    for _ in 0..7 {
        press(&mut app, "<Right>");
        let axes = &app.sweep().unwrap().axes;
        assert_ne!(axes[0].input, axes[1].input);
    }
    // Laboratory values have a forecast and no check.
    while app.sweep().unwrap().axes[1].input.word() != "Fl" {
        press(&mut app, "<Right>");
    }
    assert!(app.sweep().unwrap().points.iter().any(Result::is_ok));
    assert_eq!(work(&mut app, "c"), 0);
    assert!(said(&app).contains("not from the laboratory values"), "{}", said(&app));
    press(&mut app, "m");
    assert_eq!(app.sweep().unwrap().axes.len(), 1);
    // A digit on a range is a value and no map.
    press(&mut app, "<Down>2<Enter>");
    let view = app.sweep().unwrap();
    assert_eq!((view.axes.len(), view.axes[0].from), (1, 2.0));
    // An empty range is refused where it is typed.
    press(&mut app, "<Down>2<Enter>");
    assert!(text(&app).contains("the range is empty"), "{}", text(&app));
    press(&mut app, "<Esc>");
    assert_eq!(app.sweep().unwrap().axes[0].to, 4.5);
}

/// The same signs as on the command line, which its own tests hold.
#[test]
fn the_signs_of_a_map_are_those_of_the_command_line_and_are_explained() {
    let mut app = app((80, 24));
    let ranges =
        "w<Down>1.3<Enter><Down>1.4<Enter><Down>3<Enter>m<Down>0.4<Enter><Down>1.35<Enter>";
    press(&mut app, ranges);
    let order = order(press(&mut app, "c"));
    for mut news in news(&order) {
        // No run of the first case breaks a wire; a punch of 1.35 m cannot be checked at L = 1.3 m.
        if let What::Case { index: 0, answer, .. } = &mut news.what {
            let mut result = answer.as_ref().clone().unwrap();
            result.curve.failure = None;
            *answer = Ok(result).into();
        }
        app.update(Message::Work(news));
    }
    let screen = text(&app);
    assert!(screen.contains("n no break, X cannot be checked"), "{screen}");
    let rows: Vec<&str> = screen.lines().filter(|line| line.contains('│')).collect();
    let (above, below) = (rows[1], rows[rows.len() - 1]);
    assert!(above.contains("│X") && below.contains("│n"), "{screen}");
}

#[test]
fn the_plate_that_just_meets_the_design_force_is_taken() {
    let mut app = start(road_cut(), (80, 24), COLOR);
    press(&mut app, "g");
    assert!(text(&app).contains("No design value is set"), "{}", text(&app));
    // bench 2: 22.8 kN at d = 0.25 m, and it grows as 1.5 d + 0.45; the characteristic value is 0.88485 of
    // it. 23 kN: d = (23/(0.88485 x 22.806/0.825) - 0.45)/1.5 = 0.3268 m.
    press(&mut app, "23<Enter>");
    assert_eq!(app.layout().question.force, Some(23_000.0));
    let view = app.design().unwrap();
    let at = view.lines.iter().position(|l| l.input.word() == "d").unwrap();
    for _ in 0..at {
        press(&mut app, "<Down>");
    }
    press(&mut app, "<Enter>");
    assert_eq!(app.layout().layout.plate, 0.327);
    assert!(text(&app).contains("PASSES: strength 99.9"), "{}", text(&app));
    assert!(app.page_open().is_some(), "the page stays, to see what it gives");
    press(&mut app, "u");
    assert_eq!(app.layout().layout.plate, 0.25);
    // Factors act, a deflection is asked for too, and the arrows choose which of them.
    press(&mut app, "L<C-u>1.2<Enter>R<C-u>1.1<Enter>D0.4<Enter>");
    let view = app.design().unwrap();
    assert_eq!((view.case.question.gamma_load, view.case.question.gamma_resistance), (1.2, 1.1));
    assert_eq!(view.asked.len(), 3);
    assert_eq!(view.requirement.unwrap().word(), "both");
    press(&mut app, "<Left>");
    assert_eq!(app.design().unwrap().requirement.unwrap().word(), "deflection");
    assert!(text(&app).contains("gL 1.2") && text(&app).contains("gR 1.1"), "{}", text(&app));
    press(&mut app, "F<C-u><Enter>D<C-u><Enter>");
    assert!(app.design().unwrap().asked.is_empty());
}

#[test]
fn solved_values_are_checked_too() {
    let mut app = app((80, 24));
    press(&mut app, "g");
    let takes = app.design().unwrap().coverage.of;
    assert!(takes > 1);
    assert_eq!(work(&mut app, "c"), takes);
    let view = app.design().unwrap();
    assert_eq!((view.coverage.have, view.coverage.stale), (takes, false));
    assert!(view.own.is_some());
    assert!(text(&app).contains("DEM"), "{}", text(&app));
    press(&mut app, "q<Down><Down><Right>g");
    assert!(app.design().unwrap().coverage.stale);
}

#[test]
fn pages_are_drawn_at_every_size_and_for_every_layout() {
    for size in [(40, 12), (41, 13), (59, 17), (79, 23), (80, 24), (100, 30), (120, 40), (200, 60)]
    {
        for look in [COLOR, MONO, ASCII] {
            let mut app = start(asked(), size, look);
            for page in ["s", "w", "wm", "v", "g", "g9<Enter>D0.2<Enter>"] {
                for _ in 0..3 {
                    press(&mut app, page);
                    let shown = text(&app);
                    assert!(shown.lines().count() == usize::from(size.1), "{page}: {shown}");
                    press(&mut app, "e>><Right><Down>tq<Tab>");
                }
            }
        }
    }
}

#[test]
fn screens_of_studies() {
    for (page, script) in
        [("sensitivity", "sc"), ("compare", "vc"), ("sweep", "w<Down>1.2<Enter><Down>1.6<Enter>c")]
    {
        for (name, size, look) in PICTURES {
            check(&format!("{page}_{name}"), script, size, look);
        }
    }
    let map = "w<Down>1.3<Enter><Down>1.5<Enter><Down>3<Enter>m<Down>0.3<Enter><Down>0.5<Enter>c";
    for (page, script) in [("map", map), ("design", "gc")] {
        check(page, script, (80, 24), COLOR);
    }
}

#[test]
fn a_tolerance_is_of_the_chosen_input_and_as_typed() {
    let mut app = app((80, 24));
    press(&mut app, "S");
    assert!(text(&app).contains("tolerance of") && text(&app).contains("[d]"), "{}", text(&app));
    press(&mut app, "<Right><Right>");
    assert!(text(&app).contains("[D]"), "{}", text(&app));
    press(&mut app, "0.02<Enter>");
    assert!(text(&app).contains("by up to 0.02 m either way"), "{}", text(&app));
    // What is no tolerance is said and changes nothing; each input keeps its own.
    press(&mut app, "0<Enter>");
    assert!(said(&app).contains("above 0") || text(&app).contains("above 0"), "{}", text(&app));
    press(&mut app, "<Esc><Left><Right>");
    assert!(text(&app).contains("by up to 0.02 m either way"), "{}", text(&app));
}

/// The pages by forecast alone, for layouts that are not small.
#[test]
fn screens_of_studies_without_checks() {
    for (page, script) in [
        ("sensitivity", "s"),
        ("compare", "v"),
        ("sweep", "w"),
        ("map", "w2"),
        ("design", "g25<Enter>D0.5<Enter>"),
        ("tolerance", "S<Right>0.4<Enter>"),
    ] {
        let mut app = start(road_cut(), (80, 24), COLOR);
        press(&mut app, script);
        insta::assert_snapshot!(format!("{page}_forecast"), styled(&app));
    }
}

fn check(name: &str, script: &str, size: (u16, u16), look: Look) {
    let mut app = with_look(size, look);
    work(&mut app, script);
    press(&mut app, "<Down><Up>");
    insta::assert_snapshot!(name, styled(&app));
}

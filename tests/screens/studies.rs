//! The pages of studies: what they show at once, what their checks add, what an edit does to it.

use crate::harness::*;
use meshcast::app::App;
use meshcast::app::message::{Effect, Message};
use meshcast::job::order::{Progress, Task, What};
use meshcast::job::{News, Order, Ticket};
use meshcast::layout::Layout;
use meshcast::mesh::REFERENCE_ID;
use meshcast::project::schema::{NamedLayout, Project};
use std::sync::Mutex;

/// Two small cells, which are checked in milliseconds, and one that cannot be: the punch is on a plate.
fn small() -> Project {
    let layout = |spacing, ex| Layout { plate: 0.25, spacing, punch: 0.4, ex, ey: ex };
    let mut project = Project::starter("Small");
    project.layouts = vec![
        NamedLayout::new("one", layout(1.3, 0.0), REFERENCE_ID),
        NamedLayout::new("two", layout(1.4, 0.0), REFERENCE_ID),
        NamedLayout::new("on a plate", layout(1.4, 0.7), REFERENCE_ID),
    ];
    project.layouts[0].design_force = Some(12_000.0);
    project
}

fn app(size: (u16, u16)) -> App {
    let mut app = start(small(), size, COLOR);
    press(&mut app, ":runs 2<Enter>:fidelity quick<Enter>");
    app
}

/// The one order among some effects.
fn order(effects: Vec<Effect>) -> Order {
    let [Effect::Work(order)] = &effects[..] else { panic!("{effects:?}") };
    order.clone()
}

fn news(order: &Order) -> Vec<News> {
    let heard = Mutex::new(Vec::new());
    order.carry_out(&Ticket::default(), &|news| heard.lock().unwrap().push(news));
    heard.into_inner().unwrap()
}

/// Presses keys and does the work they ask for; tells how many cases or layouts it was.
fn work(app: &mut App, script: &str) -> usize {
    let effects = press(app, script);
    let orders = effects.into_iter().filter_map(|effect| match effect {
        Effect::Work(order) => Some(order),
        _ => None,
    });
    let mut count = 0;
    for order in orders {
        count += match &order.task {
            Task::Checks(checks) => checks.targets.len(),
            Task::Campaign(campaign) => campaign.cases.len(),
        };
        for news in news(&order) {
            let more = app.update(Message::Work(news));
            assert!(more.is_empty(), "{more:?}");
        }
    }
    count
}

fn said(app: &App) -> String {
    app.status().map_or(String::new(), |s| s.text.clone())
}

#[test]
fn a_page_opens_closes_and_keeps_its_place_under_the_help() {
    for (key, word) in [("s", "sensitivity of"), ("v", "compare")] {
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
    assert!(text(&app).contains("the punch is on a plate"), "{}", text(&app));
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
    assert!(matches!(&effects[..], [Effect::StopWork]));
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
    let mut project = small();
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
    assert!(text(&app).contains("<- more") && text(&app).contains("d/dl"), "{}", text(&app));
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
fn screens_of_studies() {
    let sizes = [("80x24", (80, 24)), ("120x40", (120, 40)), ("40x12", (40, 12))];
    for (word, size) in sizes {
        for (page, script) in [("sensitivity", "sc"), ("compare", "vc<Down>")] {
            let mut app = app(size);
            work(&mut app, script);
            press(&mut app, "<Down><Up>");
            insta::assert_snapshot!(format!("{page}_{word}"), styled(&app));
        }
    }
    for (page, script) in [("sensitivity", "s"), ("compare", "v")] {
        let mut app = start(road_cut(), (80, 24), ASCII);
        press(&mut app, script);
        insta::assert_snapshot!(format!("{page}_80x24_ascii"), text(&app));
    }
}

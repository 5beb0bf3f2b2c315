//! A mesh adopted from its own tests: the form, its work behind the screen, and what comes of it.

use crate::harness::*;
use meshcast::app::App;
use meshcast::app::message::{Command, Message, OpenedProject};
use meshcast::job::news::{StepProgress, What};
use meshcast::job::order::{Order, Task};
use meshcast::job::{News, Ticket};
use meshcast::layout::MethodChoice;
use meshcast::mesh::catalogue;
use meshcast::problem::Problem;
use meshcast::project::{MeshUse, Project};
use std::sync::{Arc, Mutex};

/// The made-up double-twist mesh 6x8 of 2.2 mm wire, tested on a small panel so that it is soon done.
const EXAMPLE: &str = "Example 6x8, 2.2<Enter>20<Enter>0.32<Enter>1.6<Enter>0.5<Enter>60 mm<Enter>\
    <Enter>2.2 mm<Enter><Enter><Enter><Enter><Enter><Enter><Enter><Enter>mean example<Enter><Enter>60<Enter>\
    made up<Enter>";

fn bottom(app: &App) -> String {
    text(app).lines().last().unwrap().trim_end().to_string()
}

fn order(commands: Vec<Command>) -> Order {
    let [Command::Work(order)] = &commands[..] else { panic!("{commands:?}") };
    assert!(matches!(order.task, Task::Adopt(_)), "{order:?}");
    order.clone()
}

#[test]
fn the_form_at_every_size() {
    for (name, size) in [("adopt_form", (80, 24)), ("adopt_form_small", (40, 12))] {
        let mut app = start(road_cut(), size, MONO);
        press(&mut app, "m");
        assert!(size.0 < 80 || bottom(&app).contains("A adopt"), "{}", bottom(&app));
        press(&mut app, "AExample 6x8, 2.2<Enter>20<Enter>0.32");
        insta::assert_snapshot!(name, text(&app));
        // The last row is reached, and what it is about is whole.
        press(&mut app, "<PgDn>");
        assert!(text(&app).contains(">source"), "{}", text(&app));
        let said = text(&app).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains("Esc ends it"), "{said}");
    }
    let mut app = start(road_cut(), (80, 24), MONO);
    press(&mut app, "m?");
    assert!(text(&app).contains("adopt a mesh from its own tests"), "{}", text(&app));
}

#[test]
fn what_is_wrong_is_marked_in_its_row_and_nothing_is_lost() {
    let mut app = start(road_cut(), (80, 24), MONO);
    // What is wrong in a row is said at its Enter; a row that is left empty may be filled in later.
    press(&mut app, "mA<Enter>20 apples<Enter>");
    let shown = text(&app);
    assert!(shown.contains(">force") && shown.contains("apples"), "{shown}");
    press(&mut app, "<C-u>73300 kN<Enter>");
    let shown = text(&app);
    assert!(shown.contains(">force") && shown.contains("allowed: 0.5"), "{shown}");
    press(&mut app, "<PgUp>mine<Enter><C-u>20<Enter><Enter>0.9<PgDn>");
    let press_last = |app: &mut App| press(app, "<Enter>");
    assert!(press_last(&mut app).is_empty());
    // The punch of 1 m does not fit into a panel of 0.9 m; the first row that is wrong is shown.
    let shown = text(&app);
    assert!(shown.contains(">punch") && shown.contains("below the panel of 0.9 m"), "{shown}");
    press(&mut app, "0.5<PgDn>");
    assert!(press_last(&mut app).is_empty());
    assert!(
        text(&app).contains(">kind") && text(&app).contains("mean, characteristic or minimum?")
    );
    // Left and shown again, all of it stands there.
    press(&mut app, "m<PgDn>a sheet<Esc>A");
    assert!(text(&app).contains("a sheet") && text(&app).contains("mine"), "{}", text(&app));
    press(&mut app, "<PgUp><C-u>dt 8x10 2.7");
    press(&mut app, "<PgDn><Enter>");
    let shown = text(&app);
    assert!(shown.contains(">name") && shown.contains("there is a mesh"), "{shown}");
}

#[test]
fn progress_is_told_escape_ends_it_and_a_refusal_brings_the_form_back() {
    let mut app = start(road_cut(), (80, 24), MONO);
    let ordered = order(press(&mut app, &format!("mA{EXAMPLE}")));
    assert!(bottom(&app).contains("adopting example-6x8-2.2; Esc ends it"), "{}", bottom(&app));
    let number = ordered.number;
    let news = |what| Message::Work(News { number, what });
    let text_of_step = "laws that fit, trial 12 of about 144".to_string();
    app.update(news(What::Step(StepProgress { text: text_of_step, fraction: 0.08, left: None })));
    press(&mut app, "<Down>");
    assert!(
        bottom(&app).contains("adopt: laws that fit, trial 12 of about 144"),
        "{}",
        bottom(&app)
    );
    assert!(matches!(press(&mut app, "<Esc>")[..], [Command::StopWork]));
    app.update(news(What::Told(Ok("kept; the same goes on".into()))));
    app.update(news(What::Ended { cancelled: true }));
    assert!(bottom(&app).contains("the same goes on"));
    // The same order again by the form as it was left; this time the file is not there.
    let again = order(press(&mut app, "mA<PgDn><Enter>"));
    assert!(again.number > number);
    let number = again.number;
    let news = |what| Message::Work(News { number, what });
    let wrong = Problem {
        field: "--curve".into(),
        value: String::new(),
        message: "none.csv: there is no such file".into(),
        allowed: String::new(),
        advice: String::new(),
    };
    app.update(news(What::FormRefused(vec![wrong])));
    app.update(news(What::Ended { cancelled: false }));
    let shown = text(&app);
    assert!(shown.contains(">curve file") && shown.contains("no such file"), "{shown}");
    assert!(shown.contains("Example 6x8, 2.2"), "{shown}");
}

/// An adopted mesh that nobody computed: the reference's, under another name.
fn canned() -> Arc<meshcast::mesh::MeshType> {
    let mut mesh = (*catalogue::reference()).clone();
    (mesh.id, mesh.name, mesh.reference) = ("mine".into(), "Mine".into(), false);
    Arc::new(mesh)
}

#[test]
fn the_mesh_comes_into_the_project_as_one_undo_and_only_where_it_was_asked_for() {
    let mut app = start(road_cut(), (80, 24), MONO);
    let first = order(press(&mut app, &format!("mA{EXAMPLE}")));
    let before = app.project().clone();
    let adopted = || What::Adopted {
        uid: before.layouts[0].uid,
        mesh: canned(),
        remarks: vec!["which bond broke first is not known; --breaks would tell it".into()],
    };
    // Another layout is selected by then.
    press(&mut app, "<Tab>");
    app.update(Message::Work(News { number: first.number, what: adopted() }));
    app.update(Message::Work(News {
        number: first.number,
        what: What::Ended { cancelled: false },
    }));
    let layout = |app: &App, at: usize| app.project().layouts[at].clone();
    assert_eq!(
        (layout(&app, 0).mesh.as_str(), layout(&app, 1).mesh.as_str()),
        ("mine", "dt-8x10-2.7")
    );
    assert_eq!(layout(&app, 0).layout.method, MethodChoice::Derived);
    // The message takes the lines it needs.
    let shown = text(&app).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        shown.ends_with("mesh mine adopted and given to bench 2; u takes it back; Ctrl+S saves it; which bond broke first is not known; breaks would tell it"),
        "{shown}"
    );
    press(&mut app, "u");
    assert!(**app.project() == *before);
    // Late news of work that gave way change nothing.
    app.update(Message::Work(News { number: first.number, what: adopted() }));
    assert!(**app.project() == *before);
}

/// From the keys to the verdict, with all that is computed on the way.
#[test]
fn the_example_is_adopted_from_end_to_end_by_keys() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("site.ron");
    let mut app = App::new(meshcast::app::Start {
        project: Arc::new(Project::starter("Site")),
        path: Some(file),
        note: None,
        kept: None,
        holder: None,
        look: MONO,
        units: meshcast::units::ChosenUnits::default(),
        size: (80, 24),
        preferences: meshcast::app::settings::Preferences::default(),
    });
    let run = |order: &Order, stop_at: Option<usize>| {
        let (ticket, heard) = (Ticket::default(), Mutex::new(Vec::new()));
        order.carry_out(2, &ticket, &|news| {
            let mut heard = heard.lock().unwrap();
            heard.push(news);
            if stop_at.is_some_and(|at| heard.len() >= at) {
                ticket.cancel();
            }
        });
        heard.into_inner().unwrap()
    };
    // Ended at its second word, and gone on with by the form as it stands.
    let script = format!("mA{EXAMPLE}");
    let ended = run(&order(press(&mut app, &script)), Some(2));
    for news in ended {
        app.update(Message::Work(news));
    }
    assert!(bottom(&app).contains("what is done is kept; m and A"), "{}", bottom(&app));
    let kept = folder.path().join("site.adopt-example-6x8-2.2/laws.txt");
    let lines = std::fs::read_to_string(&kept).unwrap().lines().count();
    assert!(lines >= 1, "{lines}");
    let news = run(&order(press(&mut app, "mA<PgDn><Enter>")), None);
    assert!(news.iter().any(|news| matches!(&news.what, What::Step(_))));
    for news in news {
        app.update(Message::Work(news));
    }
    let shown = text(&app);
    assert!(shown.contains("mesh example-6x8-2.2 adopted and given to"), "{shown}");
    assert_eq!(app.layout().mesh, "example-6x8-2.2");
    press(&mut app, "i");
    let shown = text(&app);
    assert!(shown.contains("example-6x8-2.2") || shown.contains("Example 6x8, 2.2"), "{shown}");
    press(&mut app, "<Esc>u");
    assert_eq!(app.layout().mesh, "dt-8x10-2.7");
}

#[test]
fn a_mesh_of_the_users_own_is_offered_and_written_into_the_project() {
    let mut app = start(road_cut(), (80, 24), MONO);
    app.offer(vec![canned()]);
    press(&mut app, "m");
    assert!(text(&app).contains("mine"), "{}", text(&app));
    press(&mut app, "<PgDn><Enter>");
    assert_eq!(app.layout().mesh, "mine");
    let held = &app.project().meshes;
    let inline = |held: &MeshUse| matches!(held, MeshUse::Inline(mesh) if mesh.id == "mine");
    assert!(held.iter().any(inline), "{held:?}");
}

#[test]
fn a_mesh_of_the_project_is_kept_for_other_projects_by_a_key() {
    let mut app = start(road_cut(), (80, 24), MONO);
    // The catalogue has the reference mesh, and it is not the project's.
    press(&mut app, "m");
    assert!(press(&mut app, "C").is_empty());
    assert!(bottom(&app).contains("only a mesh that is written out"), "{}", bottom(&app));
    press(&mut app, "a");
    press(&mut app, "mine<Enter><Enter>70<Enter>0.5<Enter>m<Enter><Enter><Enter>a sheet<Enter>m");
    assert!(text(&app).contains("C keeps it in your own catalogue"), "{}", text(&app));
    let commands = press(&mut app, "C");
    assert!(matches!(&commands[..], [Command::KeepMesh { mesh }] if mesh.id == "mine"));
    app.update(Message::KeptAtHome(Ok(Some("mine is in your own catalogue too: /x".into()))));
    assert!(bottom(&app).contains("mine is in your own catalogue too"), "{}", bottom(&app));
    // Another project that is opened in this session is offered it; it was offered none of the user's own.
    let other = OpenedProject {
        project: Arc::new(Project::starter("Other")),
        path: "/site/other.ron".into(),
        note: None,
        kept: None,
        holder: None,
    };
    app.update(Message::Opened(Ok(other)));
    press(&mut app, "<Esc>m");
    assert!(text(&app).contains("> mine") || text(&app).contains(" mine "), "{}", text(&app));
}

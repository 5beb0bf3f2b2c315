//! A real job from start to end: double twist 8x10, d 0.25 m, blocks of 0.6 to 1.5 m, 20 kN, 0.4 m
//! allowed. The deflection at 20 kN is 0.4 m at L = 1.87 m for a block of 0.6 m: every wider square grid
//! fails on deflection there, and says so in every place. The same by commands stands in
//! `tests/cli/verdict.rs`.

use crate::harness::*;
use meshcast::app::App;
use meshcast::app::message::{Command, Message};
use meshcast::job::News;
use meshcast::job::news::{StepProgress, What};
use meshcast::job::order::Task;
use meshcast::layout::{Layout, MethodChoice, REFERENCE};
use meshcast::project::{NamedLayout, Project};
use meshcast::study::verdict::Basis;

const GRIDS: [f64; 6] = [1.8, 1.9, 2.0, 2.5, 3.0, 3.5];
const BLOCKS: [f64; 4] = [0.6, 0.9, 1.2, 1.5];

/// 24 layouts, all grids with all blocks, whose names differ at both ends.
fn job() -> Project {
    let mut project = Project::starter("Job");
    project.basis = Basis::Mean;
    project.layouts = GRIDS
        .into_iter()
        .flat_map(|spacing| BLOCKS.map(|punch| (spacing, punch)))
        .map(|(spacing, punch)| {
            let name = format!("double twist grid {spacing} block {punch}");
            let geometry = Layout { plate: 0.25, spacing, punch, ..REFERENCE };
            let mut layout = NamedLayout::new(name, geometry, "dt-8x10-2.7");
            layout.question.force = Some(20_000.0);
            layout.question.deflection = Some(0.4);
            layout
        })
        .collect();
    project
}

#[test]
fn every_grid_that_is_too_wide_says_so_in_every_place() {
    let mut app = start(job(), (80, 24), MONO);
    for spacing in GRIDS {
        // The first block of each grid: 0.6 m.
        let fails = spacing > 1.87;
        let word = if fails { "x FAILS: deflection" } else { "+ PASSES: deflection" };
        let answer = text(&app);
        assert!(answer.contains(word), "{spacing}:\n{answer}");
        let row = answer.lines().find(|line| line.starts_with('>')).unwrap();
        let mark = if fails { " x" } else { " +" };
        assert!(row.contains(mark), "{spacing}: {row}");
        press(&mut app, "i");
        assert!(text(&app).contains(word.get(2..).unwrap()), "{spacing}:\n{}", text(&app));
        press(&mut app, "<Esc>g");
        assert!(text(&app).contains(word.get(2..).unwrap()), "{spacing}:\n{}", text(&app));
        press(&mut app, "q<Tab><Tab><Tab><Tab>");
    }
}

#[test]
fn the_job_at_every_size() {
    let mut app = start(job(), (80, 24), MONO);
    press(&mut app, "<Tab><Tab><Tab><Tab>");
    insta::assert_snapshot!("job_answer", text(&app));
    press(&mut app, "v");
    let table = text(&app);
    // What tells the names apart is there, and the line of the governing layout is whole.
    assert!(table.contains("; 15 of 24 fail"), "{table}");
    assert!(table.lines().all(|line| !line.contains("fail..")), "{table}");
    insta::assert_snapshot!("job_compare", table);
    press(&mut app, "q");
    let mut small = start(job(), (40, 12), MONO);
    press(&mut small, "<Tab><Tab><Tab><Tab>");
    let answer = text(&small);
    assert!(answer.contains("x FAILS: deflection 101 %"), "{answer}");
    insta::assert_snapshot!("job_small", answer);
}

/// What the derived method says beside its value stood before the verdict once, which was pushed off.
#[test]
fn the_verdict_of_the_derived_method_is_seen_at_every_size() {
    let mut project = job();
    for layout in &mut project.layouts {
        layout.layout.method = MethodChoice::Derived;
    }
    let mut small = start(project.clone(), (40, 12), MONO);
    press(&mut small, "<Tab><Tab><Tab><Tab>");
    assert!(text(&small).contains("x FAILS: deflection"), "{}", text(&small));
    let mut app = start(project, (80, 24), MONO);
    press(&mut app, "<Tab><Tab><Tab><Tab>");
    let answer = text(&app);
    assert!(answer.contains("x FAILS: deflection"), "{answer}");
    // The paper's value with its difference, whole, and the band.
    let paper = answer.lines().find_map(|line| line.split("paper ").nth(1)).unwrap();
    assert!(paper.contains(" kN ") && paper.contains(" %)"), "{paper}");
    assert!(answer.contains("90 %: "), "{answer}");
}

#[test]
fn the_comparison_is_sorted_by_the_governing_use() {
    let mut app = start(job(), (120, 40), MONO);
    press(&mut app, "v");
    for _ in 0..9 {
        press(&mut app, ">");
    }
    let shown = text(&app);
    assert!(shown.contains("by use, rising"), "{shown}");
    press(&mut app, "-");
    let view = app.comparison().unwrap();
    let name = |at: usize| view.comparison.rows[view.order[at]].name.as_str();
    assert_eq!(name(0), "double twist grid 3.5 block 0.6");
    assert_eq!(name(23), "double twist grid 1.8 block 1.5");
}

/// The basis is the project's, an edit like any other; both uses are in the details.
#[test]
fn the_basis_is_changed_by_a_key_and_undone() {
    let mut app = start(job(), (80, 24), MONO);
    assert!(text(&app).contains("+ PASSES: deflection") && text(&app).contains("mean values"));
    press(&mut app, "B");
    // 20 kN over 0.88485 of 21.9 kN.
    assert!(text(&app).contains("x FAILS: strength 103 %"), "{}", text(&app));
    press(&mut app, "u");
    assert!(text(&app).contains("+ PASSES: deflection"), "{}", text(&app));
    press(&mut app, ":basis characteristic<Enter>i");
    assert!(text(&app).contains("103 % characteristic"), "{}", text(&app));
}

#[test]
fn a_campaign_tells_how_far_it_is_and_escape_ends_it() {
    let mut app = start(job(), (80, 24), MONO);
    let ordered = press(&mut app, ":campaign 64 mirrored some runs<Enter>");
    let [Command::Work(order)] = &ordered[..] else { panic!("{ordered:?}") };
    assert!(matches!(order.task, Task::Method(_)));
    let bottom = |app: &App| text(app).lines().last().unwrap().trim_end().to_string();
    assert_eq!(bottom(&app), " campaign; Esc ends it");
    let number = order.number;
    let news = |what| Message::Work(News { number, what });
    let step = StepProgress { text: "12 of 78 runs".into(), fraction: 0.15, left: Some(9.0) };
    // Without a key: who waits presses none.
    app.update(news(What::Step(step)));
    let due = " campaign: 12 of 78 runs, 15 %, 9 s left; Esc ends it, what is made is kept";
    assert_eq!(bottom(&app), due);
    // A question stands above it.
    press(&mut app, "d<Right>q");
    assert!(bottom(&app).starts_with(" s save and quit  d discard"), "{}", bottom(&app));
    press(&mut app, "<Esc>");
    assert_eq!(bottom(&app), due);
    assert!(matches!(press(&mut app, "<Esc>")[..], [Command::StopWork]));
    app.update(news(What::Told(Ok("12 of 78 runs are kept".into()))));
    app.update(news(What::Ended { cancelled: true }));
    assert_eq!(bottom(&app), " 12 of 78 runs are kept");
    press(&mut app, "<Down>");
    assert!(!bottom(&app).contains("campaign"), "{}", bottom(&app));
}

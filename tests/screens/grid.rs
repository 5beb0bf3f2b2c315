//! Grids of anchors on the screen: keys, rows of the inputs, the plan.

use crate::harness::*;
use meshcast::app::App;
use meshcast::case::Input;
use meshcast::layout::{Blocks, Grid, Twists};

fn app() -> App {
    start(road_cut(), (80, 24), COLOR)
}

#[test]
fn keys_turn_the_grid_and_the_net_and_undo_takes_each_back() {
    let mut app = app();
    press(&mut app, "P");
    let two = Grid { up: Some(2.5), ..Grid::SQUARE };
    assert_eq!(app.layout().layout.grid, two);
    press(&mut app, "P");
    assert_eq!(app.layout().layout.grid, Grid { stagger: true, ..two });
    press(&mut app, "T");
    assert_eq!(app.layout().layout.grid.twists, Twists::Across);
    press(&mut app, "P");
    assert_eq!(app.layout().layout.grid, Grid { twists: Twists::Across, ..Grid::SQUARE });
    press(&mut app, "uuu");
    assert_eq!(app.layout().layout.grid, two);
    press(&mut app, ":grid staggered<Enter>:twists across<Enter>");
    let all = Grid { stagger: true, twists: Twists::Across, ..two };
    assert_eq!(app.layout().layout.grid, all);
}

#[test]
fn the_second_spacing_is_a_row_where_there_is_one() {
    let mut app = app();
    // From d down: L, D.
    press(&mut app, "<Down><Down><Right>");
    assert_eq!(app.layout().layout.punch, 0.65);
    press(&mut app, "P<Up><Right>");
    assert_eq!(app.layout().layout.sides(), [2.5, 2.55]);
    press(&mut app, "<Up>3.2<Enter>");
    assert_eq!(app.layout().layout.sides(), [3.2, 2.55]);
    // The next layout has no second spacing: the mark is at its only one.
    press(&mut app, "<Down><Tab><Right>");
    assert_eq!(app.layout().layout.sides(), [2.55, 2.55]);
    press(&mut app, "<S-Tab><Del>");
    assert_eq!(app.layout().layout.grid, Grid::SQUARE);
}

#[test]
fn studies_vary_the_second_spacing_where_there_is_one() {
    let mut app = app();
    let inputs = |app: &App| app.sensitivity().unwrap().forecast.bars.len();
    press(&mut app, "s");
    assert_eq!(inputs(&app), 7);
    press(&mut app, "qPs");
    assert_eq!(inputs(&app), 8);
    assert!(text(&app).contains("Lx ") && text(&app).contains("Ly "), "{}", text(&app));
    // L, then Ly, on the sweep's page; and back.
    press(&mut app, "qw<Right>");
    let vary = |app: &App| app.sweep().unwrap().axes[0].input;
    assert_eq!(vary(&app), Input::SpacingUp);
    press(&mut app, "<Left>");
    assert_eq!(vary(&app), Input::Spacing);
    assert!(text(&app).contains("vary [Lx]"), "{}", text(&app));
    // On a square grid the arrow goes to D.
    press(&mut app, "qPP<Right>w<Right>");
    assert_eq!(vary(&app), Input::Punch);
}

#[test]
fn a_grid_without_a_relation_says_so_and_is_drawn() {
    let mut app = start(road_cut(), (80, 24), ASCII);
    press(&mut app, "<Tab><Tab>P:grid staggered<Enter>L4.5<Enter>");
    insta::with_settings!({ prepend_module_to_snapshot => false, omit_expression => true }, {
        insta::assert_snapshot!("grid_staggered_80x24_ascii", styled(&app));
    });
}

/// At 80x24 the plan ended at the cell's own edge: of blocks that face it across an anchor line nothing was seen.
#[test]
fn blocks_that_face_the_own_one_are_seen_in_the_plan() {
    let with = |blocks: Blocks| {
        let mut project = road_cut();
        // The gully: L 3.5 m, D 0.8 m, ey 1.15 m; above the line the next block begins at 1.95 m.
        project.layouts = vec![project.layouts[4].clone()];
        project.layouts[0].layout.blocks = blocks;
        text(&start(project, (80, 24), ASCII))
    };
    // The plan's part of the screen; '.' is a block of another cell there.
    let others = |shown: String| -> usize {
        let rows = shown.lines().skip(17).take(6);
        rows.map(|row| row.chars().skip(60).filter(|c| *c == '.').count()).sum()
    };
    assert!(others(with(Blocks::Mirrored)) > 3, "{}", with(Blocks::Mirrored));
    assert_eq!(others(with(Blocks::Single)), 0, "{}", with(Blocks::Single));
}

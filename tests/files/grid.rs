//! Grids of anchors in files: one spacing or two, rows that are shifted, a net hung across.

use super::rendering::{after, open};
use meshcast::layout::{Grid, Twists};
use meshcast::project::{self, Project};

const TEXT: &str = "(
    version: 2,
    name: \"p\",
    layouts: [
        (name: \"a\", d: 0.32, L: \"3000 mm\", D: 1.0), // one
        // Two rows of the wall.
        (name: \"b\", d: 0.32, Lx: 2.5, Ly: \"350 cm\", D: 1.0, stagger: true, twists: across),
    ],
)
";

#[test]
fn a_layout_has_one_spacing_or_two() {
    let layouts = open(TEXT).project.layouts;
    assert_eq!((layouts[0].layout.spacing, layouts[0].layout.grid), (3.0, Grid::SQUARE));
    let grid = Grid { up: Some(3.5), stagger: true, twists: Twists::Across };
    assert_eq!((layouts[1].layout.spacing, layouts[1].layout.grid), (2.5, grid));
}

#[test]
fn edits_of_a_grid_leave_the_rest_of_the_text_alone() {
    assert_eq!(after(TEXT, |p| p.layouts[1].layout.spacing = 2.75), TEXT.replace("2.5", "2.75"));
    let up = |p: &mut Project| p.layouts[1].layout.grid.up = Some(3.6);
    assert_eq!(after(TEXT, up), TEXT.replace("350 cm", "360 cm"));
    let plain = |p: &mut Project| p.layouts[1].layout.grid.stagger = false;
    assert_eq!(after(TEXT, plain), TEXT.replace("stagger: true", "stagger: false"));
    let down = |p: &mut Project| p.layouts[1].layout.grid.twists = Twists::Down;
    assert_eq!(after(TEXT, down), TEXT.replace("twists: across", "twists: down"));
    // A second spacing, and the way back.
    let two = after(TEXT, |p| p.layouts[0].layout.grid.up = Some(3.25));
    assert_eq!(two, TEXT.replace("L: \"3000 mm\", D", "Lx: 3.0, Ly: 3.25, D"));
    let one = after(&two, |p| p.layouts[0].layout.grid.up = None);
    assert_eq!(one, TEXT.replace("\"3000 mm\"", "3.0"));
}

#[test]
fn what_a_grid_gains_and_loses_is_told_by_its_fields() {
    let from = open(TEXT).project;
    let mut to = from.clone();
    to.layouts[1].layout.grid = Grid { up: Some(3.0), ..Grid::SQUARE };
    to.layouts[1].layout.spacing = 2.0;
    let words = ["b: Lx 2.50 to 2.00 m, Ly 3.50 to 3.00 m, stagger, twists"];
    assert_eq!(project::difference(&from, &to), words);
}

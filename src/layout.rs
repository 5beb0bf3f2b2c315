//! A layout: the geometry of anchors and punch that both the forecast and the check take.

use crate::problem::Problem;
use crate::units::{shortest, significant};
use crate::words::Choice;

/// How the blocks of a field stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Blocks {
    /// The paper's method with its map, checked with the same block in every cell.
    #[default]
    Paper,
    /// The same block at the same place in every cell.
    Repeated,
    /// Blocks of neighbouring cells face each other across the line of anchors between them.
    Mirrored,
    /// One block on a large mesh: as many cells around it as change nothing any more.
    Single,
    /// The lower of repeated and mirrored ones, where these do not overlap.
    Worst,
}

impl Choice for Blocks {
    const ALL: &'static [Blocks] =
        &[Blocks::Paper, Blocks::Repeated, Blocks::Mirrored, Blocks::Single, Blocks::Worst];

    fn word(self) -> &'static str {
        match self {
            Blocks::Paper => "paper",
            Blocks::Repeated => "repeated",
            Blocks::Mirrored => "mirrored",
            Blocks::Single => "single",
            Blocks::Worst => "worst",
        }
    }
}

/// How the net hangs under the axes of a layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Twists {
    /// The twists run down the slope, along y.
    #[default]
    Down,
    /// The twists run across the slope, along x.
    Across,
}

impl Twists {
    /// The other way.
    pub(crate) fn other(self) -> Twists {
        match self {
            Twists::Down => Twists::Across,
            Twists::Across => Twists::Down,
        }
    }
}

impl Choice for Twists {
    const ALL: &'static [Twists] = &[Twists::Down, Twists::Across];

    fn word(self) -> &'static str {
        match self {
            Twists::Down => "down",
            Twists::Across => "across",
        }
    }
}

/// What a block looks like to the net.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PunchShape {
    /// The laboratory's dome: a flat cap with a rounded rim.
    #[default]
    Dome,
    Sphere,
    /// Flat but for its rounded rim.
    Flat,
}

impl Choice for PunchShape {
    const ALL: &'static [PunchShape] = &[PunchShape::Dome, PunchShape::Sphere, PunchShape::Flat];

    fn word(self) -> &'static str {
        match self {
            PunchShape::Dome => "dome",
            PunchShape::Sphere => "sphere",
            PunchShape::Flat => "flat",
        }
    }
}

/// Which relations a forecast takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub enum MethodChoice {
    /// Those of the paper, with the map that stands for its Fig. A1.
    #[default]
    #[serde(rename = "pol-gabrieli-2021")]
    Published,
    /// Those derived from simulations of the blocks as they stand.
    #[serde(rename = "derived")]
    Derived,
}

impl Choice for MethodChoice {
    const ALL: &'static [MethodChoice] = &[MethodChoice::Published, MethodChoice::Derived];

    fn word(self) -> &'static str {
        match self {
            MethodChoice::Published => "pol-gabrieli-2021",
            MethodChoice::Derived => "derived",
        }
    }
}

impl MethodChoice {
    pub(crate) fn other(self) -> MethodChoice {
        match self {
            MethodChoice::Published => MethodChoice::Derived,
            MethodChoice::Derived => MethodChoice::Published,
        }
    }
}

/// What a grid of anchors has besides one spacing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Spacing up the slope, L_y, m, where two are given: [`Layout::spacing`] is L_x then. Without it the
    /// grid has one spacing, L.
    pub up: Option<f64>,
    /// Whether every other row of anchors is shifted by half the spacing in the row.
    pub stagger: bool,
    /// How the net hangs.
    pub twists: Twists,
}

impl Grid {
    /// One spacing both ways, and the twists down the slope.
    pub const SQUARE: Grid = Grid { up: None, stagger: false, twists: Twists::Down };
}

/// The grid of anchors and one punching element, all in metres.
///
/// x is horizontal, y runs up the slope, whatever the net does. Row k of the anchors stands at y = k L_y,
/// one block to each anchor. The symbols of Pol & Gabrieli (2021) stand beside the words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layout {
    /// Side of the square anchor plate, d, m; above 0 and below the spacing. Published range 0.16 to 0.48.
    pub plate: f64,
    /// Anchor spacing, L, or where two are given the horizontal one, L_x, m; above 0. Published range 1.25
    /// to 4.5, of a square grid.
    pub spacing: f64,
    /// Diameter of the punching element, D, m; above 0 and below the spacing. Published range 0.1 to 2.5.
    pub punch: f64,
    /// Horizontal offset of the punch from the place farthest from all anchors ([`Layout::farthest`]), e_x, m.
    pub ex: f64,
    /// The same up the slope, e_y, m.
    pub ey: f64,
    /// How the blocks of other cells stand; the published forecast takes it for what the paper had.
    pub blocks: Blocks,
    /// Which relations the forecast takes; nothing to a check.
    pub method: MethodChoice,
    /// What the grid has besides the spacing.
    pub grid: Grid,
    /// What the punch looks like; the check's alone, published relations know the dome only.
    pub shape: PunchShape,
}

/// The layout at which the published reference values hold: d* = 0.32 m, L* = 3 m, D* = 1 m,
/// centred (Pol & Gabrieli 2021, appendix).
pub const REFERENCE: Layout = Layout {
    plate: 0.32,
    spacing: 3.0,
    punch: 1.0,
    ex: 0.0,
    ey: 0.0,
    blocks: Blocks::Paper,
    method: MethodChoice::Published,
    grid: Grid::SQUARE,
    shape: PunchShape::Dome,
};

/// A layout that is added to a project: the reference panel, with blocks that stand as they take the least and
/// the method that is nearer to checks of layouts that no fit saw (`tests/bench/METHODS.md`).
pub const NEW: Layout =
    Layout { blocks: Blocks::Worst, method: MethodChoice::Derived, ..REFERENCE };

/// Which branch of Eqs. A.1-A.2 (Pol & Gabrieli 2021) a forecast takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BranchRule {
    /// As published: the small-punch branch where D <= d, the large-punch branch elsewhere.
    #[default]
    Published,
    /// The branch with the lower force, and the deflection of the same branch.
    Conservative,
}

impl Choice for BranchRule {
    const ALL: &'static [BranchRule] = &[BranchRule::Published, BranchRule::Conservative];

    fn word(self) -> &'static str {
        match self {
            BranchRule::Published => "published",
            BranchRule::Conservative => "conservative",
        }
    }
}

/// Smallest size that is taken for a size and not for rounding, m; keeps every quotient finite.
pub(crate) const SMALLEST_LENGTH: f64 = 1.0e-6;
/// Largest length that is taken for a length and not for a slip of the keyboard, m.
pub(crate) const LARGEST_LENGTH: f64 = 100.0;

/// L_x / L_y of a staggered grid. Outside of it the place farthest from all anchors is another one.
pub(crate) const STAGGERED: (f64, f64) = (0.5, 2.0);

/// Part of half the spacing by which an offset may miss it and still be it.
const ON_THE_LINE: f64 = 1.0e-9;

impl Layout {
    /// Checks that the sizes make sense: finite, positive, plate and punch smaller than the spacing.
    ///
    /// What is merely outside the published ranges is no error; the forecast lists it.
    ///
    /// # Errors
    /// Every field that is wrong, with its allowed range.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Vec::new();
        // Nothing is written for what is sound: sweeps ask this of millions of layouts.
        let mut size = |field: &str, words: &str, value: f64, limit: f64, limit_words: &str| {
            if !(value.is_finite() && value >= SMALLEST_LENGTH && value < limit) {
                let why = if !value.is_finite() {
                    format!("{words} must be a finite number")
                } else if value <= 0.0 {
                    format!("{words} must be above 0")
                } else if value < SMALLEST_LENGTH {
                    format!("{words} is too small")
                } else {
                    format!("{words} is too large")
                };
                let problem = Problem::new(field, why)
                    .value(length_value(value))
                    .allowed(format!("above 0, below {limit_words}{} m", shortest(limit)));
                // A bare number is metres; what makes sense as millimetres was most likely meant so.
                let millimetres = value >= 20.0 && value / 1000.0 < limit;
                problems.push(if millimetres {
                    problem.advice(format!(
                        "is {0} mm meant? write {1} or \"{0} mm\"",
                        shortest(value).trim_end_matches(".0"),
                        shortest(value / 1000.0)
                    ))
                } else {
                    problem
                });
            }
        };
        let sound = |side: f64| (SMALLEST_LENGTH..LARGEST_LENGTH).contains(&side);
        let words =
            if self.grid.up.is_some() { "the smaller spacing, " } else { "the spacing L = " };
        let (limit, limit_words) = if self.sides().into_iter().all(sound) {
            (self.least(), words)
        } else {
            (LARGEST_LENGTH, "")
        };
        size("d", "plate side d", self.plate, limit, limit_words);
        match self.grid.up {
            None => size("L", "spacing L", self.spacing, LARGEST_LENGTH, ""),
            Some(up) => {
                size("Lx", "spacing Lx", self.spacing, LARGEST_LENGTH, "");
                size("Ly", "spacing Ly", up, LARGEST_LENGTH, "");
            }
        }
        size("D", "block diameter D", self.punch, limit, limit_words);
        for ((field, value), side) in
            [("ex", self.ex), ("ey", self.ey)].into_iter().zip(self.words())
        {
            if !(value.is_finite() && value.abs() < LARGEST_LENGTH) {
                let why =
                    if value.is_finite() { "is too large" } else { "must be a finite length" };
                problems.push(
                    Problem::new(field, format!("offset {field} {why}"))
                        .value(length_value(value))
                        .allowed(format!("within half the spacing, -{side}/2 to {side}/2"))
                        .advice("larger offsets are the same as a neighbouring cell's"),
                );
            }
        }
        let ratio = self.spacing / self.sides()[1];
        if problems.is_empty() && self.grid.stagger && !(STAGGERED.0..=STAGGERED.1).contains(&ratio)
        {
            problems.push(
                Problem::new(
                    "stagger",
                    "the rows of a staggered grid are too near or too far apart",
                )
                .value(format!("Lx/Ly = {}", significant(ratio, 3)))
                .allowed(format!("{} to {}", STAGGERED.0, STAGGERED.1)),
            );
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }

    /// The spacings L_x and L_y, m.
    pub fn sides(&self) -> [f64; 2] {
        [self.spacing, self.grid.up.unwrap_or(self.spacing)]
    }

    /// What the two spacings are called.
    pub(crate) fn words(&self) -> [&'static str; 2] {
        if self.grid.up.is_some() { ["Lx", "Ly"] } else { ["L", "L"] }
    }

    /// The smaller spacing, m.
    pub(crate) fn least(&self) -> f64 {
        let [x, y] = self.sides();
        x.min(y)
    }

    /// Area of a cell, which is the face that an anchor has, m2.
    pub(crate) fn area(&self) -> f64 {
        let [x, y] = self.sides();
        x * y
    }

    /// Whether the anchors stand on a square grid, the one that published relations are for.
    pub(crate) fn is_square(&self) -> bool {
        let [x, y] = self.sides();
        x == y && !self.grid.stagger
    }

    /// The place that is farthest from all anchors, from an anchor at a cell's lower left corner, m: the
    /// cell's centre, or in a staggered grid the centre of the circle through three anchors,
    /// L_x^2/(8 L_y) lower.
    pub(crate) fn farthest(&self) -> [f64; 2] {
        let [x, y] = self.sides();
        let lower = if self.grid.stagger { x * x / (8.0 * y) } else { 0.0 };
        [x / 2.0, y / 2.0 - lower]
    }

    /// How far the row of anchors so many above is shifted along x, m.
    fn shift(&self, above: i32) -> f64 {
        if self.grid.stagger && above % 2 != 0 { self.spacing / 2.0 } else { 0.0 }
    }

    /// Offsets with x across the twists and y along them, as a net has it; and those of a layout from
    /// these: turning twice gives what was there.
    pub(crate) fn turned<T: Copy>(&self, [x, y]: [T; 2]) -> [T; 2] {
        if self.grid.twists == Twists::Across { [y, x] } else { [x, y] }
    }

    /// The offsets brought within half the spacings, which is the same place in a neighbouring cell.
    pub(crate) fn folded(&self) -> (f64, f64) {
        let [x, y] = self.sides();
        if !self.grid.stagger || self.ey.abs() <= y / 2.0 {
            return (fold(self.ex, x), fold(self.ey, y));
        }
        // The next rows are shifted.
        let rows = (self.ey / y).round();
        (fold(self.ex - x * (rows / 2.0).fract(), x), self.ey - y * rows)
    }

    /// Whether mirrored blocks of neighbouring cells would overlap, and in which offset: |e| > (L - D)/2,
    /// but for half the spacing exactly, where the two are one block on the line.
    pub fn blocks_overlap(&self) -> Option<&'static str> {
        let (ex, ey) = self.folded();
        let sides = self.sides();
        let overlaps = |k: usize, e: f64| {
            e != 0.0 && e.abs() > (sides[k] - self.punch) / 2.0 && !self.on_line(k, e)
        };
        [("ex", ex), ("ey", ey)]
            .into_iter()
            .enumerate()
            .find(|(k, (_, e))| overlaps(*k, *e))
            .map(|(_, (name, _))| name)
    }

    /// Whether blocks may face each other: not on a staggered grid, and not where they would overlap.
    pub(crate) fn can_face(&self) -> bool {
        !self.grid.stagger && self.blocks_overlap().is_none()
    }

    /// Whether its blocks stand as the paper has them where they might face each other and then take less.
    pub(crate) fn facing_left_out(&self) -> bool {
        self.blocks == Blocks::Paper && self.folded() != (0.0, 0.0) && self.can_face()
    }

    /// Whether an offset along x (0) or y (1) is half the spacing.
    pub(crate) fn on_line(&self, axis: usize, e: f64) -> bool {
        (e.abs() * 2.0 / self.sides()[axis] - 1.0).abs() < ON_THE_LINE
    }

    /// Where the block of the cell so many to the right and above stands from that cell's place that is
    /// farthest from all anchors, m.
    pub fn offset_in(&self, right: i32, above: i32) -> (f64, f64) {
        let (ex, ey) = self.folded();
        let mirrored = self.facing();
        let turn = |e: f64, cells: i32| if mirrored && cells % 2 != 0 { -e } else { e };
        (turn(ex, right), turn(ey, above))
    }

    /// Where the block of the cell so many to the right and above stands from the centre of the first
    /// cell, m.
    pub(crate) fn block_in(&self, right: i32, above: i32) -> (f64, f64) {
        let ([x, y], [_, zero]) = (self.sides(), self.farthest());
        let (ex, ey) = self.offset_in(right, above);
        (
            ex + f64::from(right) * x + self.shift(above),
            ey + (zero - y / 2.0) + f64::from(above) * y,
        )
    }

    /// The anchor so many to the right of and above the lower left one of a cell, from the cell's centre, m.
    pub(crate) fn anchor_in(&self, right: i32, above: i32) -> (f64, f64) {
        let [x, y] = self.sides();
        (f64::from(right) * x + self.shift(above) - x / 2.0, f64::from(above) * y - y / 2.0)
    }

    /// Whether its blocks are drawn facing their neighbours: mirrored, or the worst where they can be.
    pub(crate) fn facing(&self) -> bool {
        match self.blocks {
            Blocks::Paper | Blocks::Repeated | Blocks::Single => false,
            Blocks::Mirrored => !self.grid.stagger,
            Blocks::Worst => self.can_face(),
        }
    }

    /// Upper bound of what the worst anchor carries of the force on a block, where blocks face each other:
    /// (1 + 2|ex|/L_x)(1 + 2|ey|/L_y), by the lever in each direction. Nothing where every anchor carries
    /// the whole force of its cell, by statics.
    pub(crate) fn facing_bound(&self) -> Option<f64> {
        let (ex, ey) = self.folded();
        let [x, y] = self.sides();
        let lever = |e: f64, side: f64| 1.0 + 2.0 * e.abs() / side;
        (self.facing() && (ex, ey) != (0.0, 0.0)).then(|| lever(ex, x) * lever(ey, y))
    }

    /// Whether statics do not say what each anchor carries of a block's force: around a single block, and in a
    /// staggered grid, where there is more than one anchor to a repeating cell.
    pub(crate) fn shares_unknown(&self) -> bool {
        self.blocks == Blocks::Single || self.grid.stagger
    }

    /// Distance from the punch's centre to the nearest anchor plate, m, periodic images included;
    /// 0 if the centre stands on a plate. Plates stand at the corners of the cell.
    pub fn distance_to_plate(&self) -> f64 {
        let (ex, ey) = self.folded();
        if self.grid.stagger {
            let (x, y) = self.block_in(0, 0);
            return self.apart_from_plate([x, y]);
        }
        let gap = |e: f64, side: f64| (side / 2.0 - e.abs() - self.plate / 2.0).max(0.0);
        let [x, y] = self.sides();
        let (gx, gy) = (gap(ex, x), gap(ey, y));
        (gx * gx + gy * gy).sqrt()
    }

    /// Distance from a place, given from the cell's centre, to the nearest plate, m.
    pub(crate) fn apart_from_plate(&self, place: [f64; 2]) -> f64 {
        let [side, height] = self.sides();
        let gap = |v: f64| (v.abs() - self.plate / 2.0).max(0.0);
        let below = ((place[1] + height / 2.0) / height).floor();
        let to = [below, below + 1.0].map(|row| {
            let (x, y) = self.anchor_in(0, row as i32);
            let apart = place[0] - x;
            gap(apart - side * (apart / side).round()).hypot(gap(place[1] - y))
        });
        to[0].min(to[1])
    }

    /// Distance from a place, given from the cell's centre, to the axis of the nearest block, m, where the same
    /// block stands in every cell.
    pub(crate) fn apart_from_block(&self, place: [f64; 2]) -> f64 {
        let (x, y) = self.block_in(0, 0);
        let apart = Layout { ex: place[0] - x, ey: place[1] - y, ..*self }.folded();
        apart.0.hypot(apart.1)
    }

    /// Whether the punch overlaps an anchor plate or its periodic image, where the method does not
    /// apply: the distance of its centre to the nearest plate is below D/2.
    pub fn punch_on_plate(&self) -> bool {
        self.distance_to_plate() < self.punch / 2.0
    }
}

fn fold(e: f64, period: f64) -> f64 {
    if e.abs() <= period / 2.0 { e } else { e - period * (e / period).round() }
}

fn length_value(metres: f64) -> String {
    if metres.is_finite() { format!("{} m", shortest(metres)) } else { format!("{metres}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn senseless_sizes_are_errors_with_field_value_and_range() {
        let wrong = Layout { plate: -0.1, punch: 3.0, ex: f64::NAN, ..REFERENCE };
        let said: Vec<String> =
            wrong.check().unwrap_err().iter().map(std::string::ToString::to_string).collect();
        assert_eq!(said.len(), 3);
        assert_eq!(
            said[0],
            "d = -0.1 m: plate side d must be above 0; allowed: above 0, below the spacing L = 3.0 m"
        );
        assert!(said[1].starts_with("D = 3.0 m: block diameter D is too large"));
        assert!(said[2].starts_with("ex = NaN: offset ex must be a finite length"));
        assert!(REFERENCE.check().is_ok());
        let dust = Layout { spacing: 5e-324, ..REFERENCE }.check().unwrap_err();
        assert!(dust.iter().any(|p| p.to_string().contains("spacing L is too small")));
    }

    #[test]
    fn plates_stand_at_the_corners_and_their_images() {
        // Worked by hand: L/2 = 1.5, d/2 = 0.16, so a centred punch is 1.34 m from the plate in x and y.
        assert!((REFERENCE.distance_to_plate() - 1.34 * 2.0_f64.sqrt()).abs() < 1e-12);
        let corner = Layout { ex: 1.5, ey: -1.5, ..REFERENCE };
        assert_eq!(corner.distance_to_plate(), 0.0);
        let image = Layout { ex: 4.5, ey: 1.5, ..REFERENCE };
        assert!(image.punch_on_plate());
        let edge = Layout { ex: 1.5, ey: 0.84, ..REFERENCE };
        assert!((edge.distance_to_plate() - 0.5).abs() < 1e-12);
        // A centred punch can be on a plate inside the published ranges.
        let wide = Layout { plate: 0.48, spacing: 1.25, punch: 1.2, ex: 0.0, ey: 0.0, ..REFERENCE };
        assert!(wide.punch_on_plate());
    }

    #[test]
    fn blocks_that_face_each_other_load_the_anchor_between_them_more() {
        // Test 5 of the paper, by hand: (1 + 1.1/3.5)(1 + 2.3/3.5).
        let at = Layout { plate: 0.25, spacing: 3.5, punch: 0.8, ex: 0.55, ey: 1.15, ..REFERENCE };
        assert_eq!(at.facing_bound(), None);
        let mirrored = Layout { blocks: Blocks::Mirrored, ..at };
        let bound = (4.6 / 3.5) * (5.8 / 3.5);
        assert!((mirrored.facing_bound().unwrap() - bound).abs() < 1e-12);
        let neighbours = [(0, 0), (1, 0), (0, -1), (1, 1), (2, 0)];
        let turned = neighbours.map(|(right, above)| mirrored.offset_in(right, above));
        let due = [(0.55, 1.15), (-0.55, 1.15), (0.55, -1.15), (-0.55, -1.15), (0.55, 1.15)];
        assert_eq!(turned, due);
        // They would overlap: the worst is then the repeated one.
        let close = Layout { ex: 1.5, blocks: Blocks::Worst, ..at };
        assert_eq!((close.blocks_overlap(), close.facing_bound()), (Some("ex"), None));
        assert_eq!(close.offset_in(1, 0), (1.5, 1.15));
        assert_eq!(Layout { ex: 1.75, ..close }.blocks_overlap(), None, "one block on the line");
    }
}

//! What a forecast has to say about itself: published ranges left, values assumed, places where the
//! method is weak. The number is still given; the warning says how far to trust it.

use super::NoField;
use crate::remark::Weight;
use crate::units::{LengthUnit, Units, force_text, length_entry, length_text, shortest};

/// A published range: symbol, words, limits, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PublishedRange {
    /// Symbol of the paper.
    pub symbol: &'static str,
    /// The quantity in words.
    pub words: &'static str,
    /// Smallest value covered, m.
    pub min: f64,
    /// Largest value covered, m.
    pub max: f64,
}

/// Range of the plate side d of Eqs. A.1-A.2 and 3 (Pol & Gabrieli 2021, section 4.1).
pub(crate) const PLATE: PublishedRange =
    PublishedRange { symbol: "d", words: "plate side", min: 0.16, max: 0.48 };
/// Range of the spacing L of Eqs. A.1-A.2 and 3.
pub(crate) const SPACING: PublishedRange =
    PublishedRange { symbol: "L", words: "spacing", min: 1.25, max: 4.5 };
/// Range of the punch diameter D of Eqs. A.1-A.2 and 3.
pub(crate) const PUNCH: PublishedRange =
    PublishedRange { symbol: "D", words: "block", min: 0.1, max: 2.5 };
/// Range of the laboratory panel's side of Eqs. 1-2.
pub(crate) const PANEL: PublishedRange = PublishedRange {
    symbol: "L_l",
    words: "laboratory panel",
    min: super::laboratory::PANEL_RANGE.0,
    max: super::laboratory::PANEL_RANGE.1,
};

impl PublishedRange {
    /// Whether a value lies in the range; its ends belong to it, to a nanometre.
    pub(crate) fn holds(&self, value: f64) -> bool {
        value >= self.min - 1e-9 && value <= self.max + 1e-9
    }

    /// The range as text, in the units shown: `0.16 to 0.48 m`.
    pub(crate) fn text(&self, units: Units) -> String {
        format!("{} to {} {}", bare(self.min, units), bare(self.max, units), units.symbol())
    }
}

/// What is known of a forecast with a size outside its range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outside {
    /// Nothing: another mesh, or no value.
    Unknown,
    /// That it is farther out than checks were made.
    TooFar,
    /// What checks gave.
    Measured(OutsideRecord),
}

/// Check over forecast in ranges that are wider by a part: the middle 80 %.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutsideRecord {
    /// Part by which the ranges of d, L and D were wider, down and up.
    pub(crate) wider: f64,
    /// Layouts that were checked there.
    pub(crate) layouts: usize,
    /// 10 and 90 % points of the force's quotients.
    pub(crate) force: [f64; 2],
    /// The same of the deflection's.
    pub(crate) deflection: [f64; 2],
}

/// One warning of a forecast.
#[derive(Debug, Clone, PartialEq)]
pub enum Warning {
    /// A size outside the published range.
    Extrapolated {
        /// The range that is left.
        range: PublishedRange,
        /// The value, m.
        value: f64,
        /// What is known there.
        outside: Outside,
    },
    /// The punch overlaps an anchor plate.
    PunchOnPlate {
        /// Distance from the punch's centre to the nearest plate, m.
        distance: f64,
        /// Radius of the punch, m.
        radius: f64,
    },
    /// The block is smaller than the opening of the mesh.
    PassesThrough {
        /// Its diameter, m.
        block: f64,
        /// Distance between two twists, m.
        opening: f64,
    },
    /// The anchors stand on no square grid.
    GridWithoutRelation {
        /// Whether its rows are shifted.
        stagger: bool,
    },
    /// Mirrored blocks of neighbouring cells would overlap.
    BlocksOverlap,
    /// The plate is as large as blocks are and the block as small as plates: are d and D swapped?
    Swapped,
    /// The laboratory record is far from what such tests give.
    ImplausibleLaboratory {
        /// Its force, N.
        force: f64,
        /// Its deflection, m, if it has one.
        deflection: Option<f64>,
    },
    /// The laboratory record has no deflection: forces are given, and no curve.
    StrengthOnly,
    /// The layout is near the jump of A.1-A.2 at D = d.
    NearBranchChange {
        /// Force by the branch that was used, N.
        used: f64,
        /// Force by the other branch, N.
        other: f64,
    },
    /// The punch is eccentric, so the map's uncertainty applies.
    EccentricityUncertain {
        /// Relative standard uncertainty of F.
        force: f64,
        /// Relative standard uncertainty of delta.
        deflection: f64,
    },
    /// The map has no data around this eccentricity.
    EccentricityWithoutData,
    /// The offset was taken back into the cell by its periodicity.
    EccentricityFolded {
        /// The offset that stands for e_x, m.
        ex: f64,
        /// The offset that stands for e_y, m.
        ey: f64,
    },
    /// Blocks stand as the paper has them where they might face each other.
    FacingLeftOut {
        /// Force by the derived method where they take the least, N.
        worst: f64,
    },
    /// The simulations behind the derived method are of other wires than this mesh's.
    OtherWires,
    /// Another mesh than the reference one uses the default ratios.
    DefaultRatios,
    /// What an offset does is known of another mesh than this one.
    BorrowedMap,
    /// One block alone is forecast by relations of a block in every cell.
    OneBlock,
    /// The laboratory values were converted from another panel.
    PanelConverted {
        /// Side of the tested panel, m.
        panel: f64,
    },
    /// At the reference point the published relations do not return the reference values.
    ReferencePoint {
        /// F_a there, N.
        force: f64,
        /// delta_a there, m.
        deflection: Option<f64>,
        /// F_a*, N.
        reference_force: f64,
        /// delta_a*, m.
        reference_deflection: Option<f64>,
    },
    /// The mesh is an example, not a product.
    ExampleMesh,
}

/// What checks of one block alone gave, over those of a block in every cell, least and most of eight layouts
/// (`meshcast bench --arrangements`): the force...
const ONE_BLOCK_FORCE: [f64; 2] = [0.8, 1.3];

/// ... and the deflection.
const ONE_BLOCK_DEFLECTION: [f64; 2] = [1.4, 1.7];

/// Whether some of these say that a size is outside its published range, so that numbers are
/// extrapolated.
pub(crate) fn extrapolated(warnings: &[Warning]) -> bool {
    warnings
        .iter()
        .any(|w| matches!(w, Warning::Extrapolated { .. } | Warning::EccentricityWithoutData))
}

/// A length as it was entered, without its sign.
fn bare(metres: f64, units: Units) -> String {
    if units.length == LengthUnit::Metre { shortest(metres) } else { length_entry(metres, units) }
}

/// A force (N) and, where it is known, a deflection (m).
fn record(force: f64, deflection: Option<f64>, between: &str, units: Units) -> String {
    let delta = deflection.map(|delta| length_text(delta, units));
    let force = force_text(force, units);
    [Some(force), delta].into_iter().flatten().collect::<Vec<_>>().join(between)
}

impl Warning {
    /// Stable identifier for programs.
    pub(crate) fn code(&self) -> &'static str {
        match self {
            Warning::Extrapolated { range, .. } => match range.symbol {
                "d" => "extrapolated_d",
                "L" => "extrapolated_L",
                "D" => "extrapolated_D",
                _ => "extrapolated_panel",
            },
            Warning::PunchOnPlate { .. } => NoField::PunchOnPlate.code(),
            Warning::PassesThrough { .. } => NoField::PassesThrough.code(),
            Warning::GridWithoutRelation { .. } => NoField::Grid.code(),
            Warning::BlocksOverlap => NoField::Overlap.code(),
            Warning::Swapped => "d_and_D_swapped",
            Warning::ImplausibleLaboratory { .. } => "implausible_laboratory",
            Warning::StrengthOnly => "strength_only",
            Warning::NearBranchChange { .. } => "near_branch_change",
            Warning::EccentricityUncertain { .. } => "eccentricity_uncertain",
            Warning::EccentricityWithoutData => "eccentricity_without_data",
            Warning::EccentricityFolded { .. } => "eccentricity_folded",
            Warning::FacingLeftOut { .. } => "facing_left_out",
            Warning::OtherWires => "method_of_other_wires",
            Warning::DefaultRatios => "default_ratios",
            Warning::BorrowedMap => "borrowed_map",
            Warning::OneBlock => "one_block_by_relations_of_many",
            Warning::PanelConverted { .. } => "panel_converted",
            Warning::ReferencePoint { .. } => "reference_point",
            Warning::ExampleMesh => "example_mesh",
        }
    }

    /// How much it weighs.
    pub(crate) fn weight(&self) -> Weight {
        match self {
            Warning::PunchOnPlate { .. }
            | Warning::PassesThrough { .. }
            | Warning::GridWithoutRelation { .. }
            | Warning::BlocksOverlap => Weight::Outside,
            Warning::EccentricityFolded { .. }
            | Warning::FacingLeftOut { .. }
            | Warning::PanelConverted { .. }
            | Warning::ReferencePoint { .. } => Weight::Note,
            _ => Weight::Caution,
        }
    }

    /// A few words for a narrow panel, in the units shown.
    pub(crate) fn short(&self, units: Units) -> String {
        let [low, high] = ONE_BLOCK_DEFLECTION;
        match self {
            Warning::Extrapolated { range, value, outside } => match outside {
                Outside::Unknown => format!("{} outside {}", range.symbol, range.text(units)),
                Outside::TooFar => format!("{} outside {}, far", range.symbol, range.text(units)),
                Outside::Measured(OutsideRecord { force: [low, high], .. }) => {
                    let (sign, end) =
                        if *value < range.min { ('<', range.min) } else { ('>', range.max) };
                    let end = bare(end, units);
                    let m = units.symbol();
                    format!("{} {sign} {end} {m}: check x{low:.2}-{high:.2}", range.symbol)
                }
            },
            Warning::PunchOnPlate { .. } => "block on an anchor plate".into(),
            Warning::PassesThrough { .. } => "block below the mesh opening".into(),
            Warning::GridWithoutRelation { .. } => "no relation for this grid".into(),
            Warning::BlocksOverlap => "mirrored blocks overlap".into(),
            Warning::ImplausibleLaboratory { force, deflection } => {
                format!("laboratory {}: units?", record(*force, *deflection, ", ", units))
            }
            Warning::StrengthOnly => "no deflection: forces only".into(),
            Warning::Swapped => "are d and D swapped?".into(),
            Warning::NearBranchChange { other, .. } => {
                format!("near D = d: other {}", force_text(*other, units))
            }
            Warning::EccentricityUncertain { force, .. } => {
                format!("eccentricity +-{:.0} % on F", force * 100.0)
            }
            Warning::EccentricityWithoutData => "no eccentricity data here".into(),
            Warning::EccentricityFolded { .. } => "offset taken back into the cell".into(),
            Warning::FacingLeftOut { worst } => {
                format!("blocks worst: {}, derived", force_text(*worst, units))
            }
            Warning::OtherWires => "method of other wires".into(),
            Warning::DefaultRatios => "ratios of another mesh assumed".into(),
            Warning::BorrowedMap => "offset map of another mesh".into(),
            Warning::OneBlock => format!("one block: delta x{low:.1}-{high:.1}"),
            Warning::PanelConverted { .. } => "laboratory panel converted".into(),
            Warning::ReferencePoint { .. } => "0.93 F_a* here, as published".into(),
            Warning::ExampleMesh => "example mesh, not a product".into(),
        }
    }

    /// The whole sentence for people, in the units shown, without a final stop.
    pub fn sentence(&self, units: Units) -> String {
        let m = |v: f64| length_text(v, units);
        let kn = |v: f64| force_text(v, units);
        match self {
            Warning::Extrapolated { range, value, outside } => format!(
                "{} {} = {} {} is outside the published range {}; the values are extrapolated{}",
                range.words,
                range.symbol,
                bare(*value, units),
                units.symbol(),
                range.text(units),
                match outside {
                    Outside::Unknown => String::new(),
                    Outside::TooFar => ", farther than checks were made".into(),
                    Outside::Measured(OutsideRecord { wider, layouts, force, deflection }) => format!(
                        ": in ranges wider by {:.0} % checks gave {:.2} to {:.2} of such a force and {:.2} to {:.2} of such a deflection (middle 80 % of {layouts} layouts)",
                        100.0 * wider,
                        force[0],
                        force[1],
                        deflection[0],
                        deflection[1]
                    ),
                }
            ),
            Warning::PunchOnPlate { distance, radius } => format!(
                "the block overlaps an anchor plate (its centre is {} from the plate, its radius is {}): outside the method, no field value",
                m(*distance),
                m(*radius)
            ),
            Warning::PassesThrough { block, opening } => format!(
                "the block of {} is smaller than the opening of the mesh, {}: it passes through, no field value",
                m(*block),
                m(*opening)
            ),
            Warning::GridWithoutRelation { stagger } => format!(
                "the published relations are for anchors on a square grid and this one is {}: no field value; the check answers",
                if *stagger { "staggered" } else { "rectangular" }
            ),
            Warning::BlocksOverlap => {
                "mirrored blocks of neighbouring cells would overlap: no field value by the derived method".into()
            }
            Warning::ImplausibleLaboratory { force, deflection } => format!(
                "the laboratory record of {} is far from what punch tests give (10 to 500 kN, 0.1 to 1.5 m): is a unit wrong?",
                record(*force, *deflection, " at ", units)
            ),
            Warning::Swapped => {
                "the plate d is larger than any that was tested and the block D as small as a plate: are the two swapped?".into()
            }
            Warning::StrengthOnly => {
                "the laboratory record has no deflection: forces are given, and no deflection, curve, stiffness or energy".into()
            }
            Warning::NearBranchChange { used, other } => format!(
                "near the branch change at D = d, where A.1 jumps: this branch gives {}, the other {}; choose `conservative` for the lower",
                kn(*used),
                kn(*other)
            ),
            Warning::EccentricityUncertain { force, deflection } => format!(
                "the eccentricity factors come from a map of scattered runs: +-{:.0} % on F, +-{:.0} % on delta",
                force * 100.0,
                deflection * 100.0
            ),
            Warning::EccentricityWithoutData => {
                "the eccentricity map has no data here (its own punch was on a plate); the factors are extrapolated".into()
            }
            Warning::EccentricityFolded { ex, ey } => format!(
                "the offset is beyond half the spacing; by periodicity it stands for ex = {}, ey = {}",
                m(*ex),
                m(*ey)
            ),
            Warning::FacingLeftOut { worst } => format!(
                "blocks as the paper has them: the same in every cell; blocks `worst`, the lower of repeated and mirrored ones, takes {} by the derived method",
                kn(*worst)
            ),
            Warning::OtherWires => {
                "the derived method is made of simulations of the reference mesh, whose net and wires are others than this mesh's: a check of this mesh may differ, and `adopt` makes a method of its own".into()
            }
            Warning::DefaultRatios => {
                "this mesh has no ratios of its own: alpha_F and alpha_delta of the double-twist reference are assumed, and may differ".into()
            }
            Warning::BorrowedMap => {
                "this mesh has no runs of blocks that stand like this: what the offset does is taken from the double-twist reference, and may differ".into()
            }
            Warning::OneBlock => format!(
                "the relations are of a block in every cell: for one block alone checks of eight layouts of the reference mesh gave {} to {} of their force and {} to {} of their deflection, and only a check knows it",
                ONE_BLOCK_FORCE[0], ONE_BLOCK_FORCE[1], ONE_BLOCK_DEFLECTION[0], ONE_BLOCK_DEFLECTION[1],
            ),
            Warning::PanelConverted { panel } => format!(
                "the laboratory values were measured on a panel of {} and converted to the standard 3.0 m by Eqs. 1-2",
                m(*panel)
            ),
            Warning::ReferencePoint { force, deflection, reference_force, reference_deflection } => format!(
                "at the reference point the published relations return {}, not {} (factors 0.93 and 0.98)",
                record(*force, *deflection, " and ", units),
                record(*reference_force, *reference_deflection, " and ", units)
            ),
            Warning::ExampleMesh => {
                "this mesh is an example of the file format; its values are not a product's".into()
            }
        }
    }
}

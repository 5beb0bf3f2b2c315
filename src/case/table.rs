//! The inputs and their table: what each is called, measures and may be.

use super::range::Range;
use crate::forecast::warning::{PLATE, PUNCH, PublishedRange, SPACING};
use crate::mesh;
use crate::units::Quantity;

/// One input of a case. Lengths are metres and forces newtons, everywhere but in texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Input {
    /// Side of the anchor plate, d.
    Plate,
    /// Anchor spacing, L, or L_x of a grid with two. The offsets stay as they are in metres.
    Spacing,
    /// Anchor spacing up the slope, L_y, of a grid with two.
    SpacingUp,
    /// Diameter of the punch, D.
    Punch,
    /// Offset across the twists, e_x.
    OffsetX,
    /// Offset along the twists, e_y.
    OffsetY,
    /// Design force, without its factor.
    DesignForce,
    /// Load per area of face, without its factor; instead of the design force.
    Pressure,
    AllowableDeflection,
    /// What an anchor can take.
    AnchorResistance,
    /// Partial factor on the load.
    GammaLoad,
    /// Partial factor on the resistance.
    GammaResistance,
    /// Force of the standard laboratory test, F_l*.
    LabForce,
    /// Deflection of the standard laboratory test, delta_l*.
    LabDeflection,
}

/// What stands where an input is not given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Missing {
    /// It has to be given.
    Needed,
    /// This value.
    Means(f64),
    /// Nothing is asked.
    Nothing,
}

/// All there is to know of an input.
#[derive(Debug)]
pub(crate) struct InputRow {
    pub(super) input: Input,
    /// One or two letters for commands, narrow tables and the screen.
    pub(crate) word: &'static str,
    /// The paper's symbol where it has one.
    pub(crate) symbol: &'static str,
    /// A word or two on the screen.
    pub(crate) label: &'static str,
    /// A whole phrase for help and messages, without an article.
    pub(crate) phrase: &'static str,
    /// What it measures.
    pub(crate) quantity: Quantity,
    /// Its name in a project file; in a mesh for the laboratory's.
    pub(crate) name: &'static str,
    /// Its flag on the command line; empty where it has none.
    pub(crate) flag: &'static str,
    /// What the flag asks for.
    pub(crate) help: &'static str,
    /// Its name in JSON, CSV and copied tables, with the unit.
    pub(crate) column: &'static str,
    /// A value as it may stand in a file.
    pub(crate) example: &'static str,
    /// What it may be.
    pub(crate) range: Range,
    /// What stands where it is not given.
    pub(crate) missing: Missing,
    /// Steps of the arrow keys, small and large, SI.
    pub(crate) steps: [f64; 2],
    /// The range in which the paper's relations were made, where it gives one.
    pub(crate) published: Option<PublishedRange>,
}

use Missing::{Means, Needed, Nothing};
use Quantity::{Force, Length, Number, Pressure};

/// In the order of [`Input`].
pub(super) const TABLE: [InputRow; 14] = [
    InputRow {
        input: Input::Plate,
        word: "d",
        symbol: "d",
        label: "plate",
        phrase: "side of the square anchor plate",
        quantity: Length,
        name: "d",
        flag: "-d",
        help: "Side of the square anchor plate, d [default: 0.32 m]",
        column: "d_m",
        example: "0.32",
        range: Range::BelowSpacing,
        missing: Needed,
        steps: [0.01, 0.05],
        published: Some(PLATE),
    },
    InputRow {
        input: Input::Spacing,
        word: "L",
        symbol: "L",
        label: "spacing",
        phrase: "anchor spacing",
        quantity: Length,
        name: "L",
        flag: "-L",
        help: "Anchor spacing, L, of a square grid [default: 3 m]",
        column: "L_m",
        example: "3.0",
        range: Range::Spacing,
        missing: Needed,
        steps: [0.05, 0.50],
        published: Some(SPACING),
    },
    InputRow {
        input: Input::SpacingUp,
        word: "Ly",
        symbol: "Ly",
        label: "up slope",
        phrase: "anchor spacing up the slope, of a grid with two",
        quantity: Length,
        name: "Ly",
        flag: "--Ly",
        help: "Anchor spacing up the slope, Ly, beside Lx; nothing: a square grid",
        column: "Ly_m",
        example: "3.0",
        range: Range::Spacing,
        missing: Nothing,
        steps: [0.05, 0.50],
        published: None,
    },
    InputRow {
        input: Input::Punch,
        word: "D",
        symbol: "D",
        label: "block",
        phrase: "diameter of the punching block",
        quantity: Length,
        name: "D",
        flag: "-D",
        help: "Diameter of the punching block, D [default: 1 m]",
        column: "D_m",
        example: "1.0",
        range: Range::BelowSpacing,
        missing: Needed,
        steps: [0.05, 0.25],
        published: Some(PUNCH),
    },
    InputRow {
        input: Input::OffsetX,
        word: "ex",
        symbol: "ex",
        label: "offset x",
        phrase: "offset of the block across the twists",
        quantity: Length,
        name: "ex",
        flag: "--ex",
        help: "Offset of the block in x, across the slope, -L/2 to L/2 [default: 0 m]",
        column: "ex_m",
        example: "0.0",
        range: Range::HalfSpacing(0),
        missing: Means(0.0),
        steps: [0.05, 0.25],
        published: None,
    },
    InputRow {
        input: Input::OffsetY,
        word: "ey",
        symbol: "ey",
        label: "offset y",
        phrase: "offset of the block along the twists",
        quantity: Length,
        name: "ey",
        flag: "--ey",
        help: "Offset of the block in y, up the slope, -L/2 to L/2 [default: 0 m]",
        column: "ey_m",
        example: "0.0",
        range: Range::HalfSpacing(1),
        missing: Means(0.0),
        steps: [0.05, 0.25],
        published: None,
    },
    InputRow {
        input: Input::DesignForce,
        word: "Fd",
        symbol: "Fd",
        label: "design",
        phrase: "design force on the panel",
        quantity: Force,
        name: "design_force",
        flag: "--force",
        help: "Design force: asks for utilisation and deflection",
        column: "design_F_kN",
        example: "20.0",
        range: Range::UpTo(1.0e7),
        missing: Nothing,
        steps: [1.0e3, 1.0e4],
        published: None,
    },
    InputRow {
        input: Input::Pressure,
        word: "q",
        symbol: "q",
        label: "pressure",
        phrase: "load per area of face, instead of the design force",
        quantity: Pressure,
        name: "pressure",
        flag: "--pressure",
        help: "Load per area of face, times the cell's area a design force; not beside --force",
        column: "pressure_kPa",
        example: "2.5",
        range: Range::UpTo(1.0e6),
        missing: Nothing,
        steps: [0.1e3, 1.0e3],
        published: None,
    },
    InputRow {
        input: Input::AllowableDeflection,
        word: "dm",
        symbol: "dm",
        label: "allowed",
        phrase: "allowable deflection",
        quantity: Length,
        name: "allowable_deflection",
        flag: "--deflection",
        help: "Allowable deflection: asks for the force mobilised",
        column: "allowable_delta_m",
        example: "0.4",
        range: Range::UpTo(10.0),
        missing: Nothing,
        steps: [0.01, 0.10],
        published: None,
    },
    InputRow {
        input: Input::AnchorResistance,
        word: "Ra",
        symbol: "Ra",
        label: "anchor",
        phrase: "what an anchor can take",
        quantity: Force,
        name: "anchor_resistance",
        flag: "--anchor",
        help: "What an anchor can take: asks whether it takes the factored load",
        column: "anchor_resistance_kN",
        example: "100.0",
        range: Range::UpTo(1.0e7),
        missing: Nothing,
        steps: [1.0e3, 1.0e4],
        published: None,
    },
    InputRow {
        input: Input::GammaLoad,
        word: "gL",
        symbol: "gL",
        label: "load fac",
        phrase: "partial factor on the load",
        quantity: Number,
        name: "gamma_load",
        flag: "--gamma-load",
        help: "Partial factor on the load [default: 1]",
        column: "gamma_load",
        example: "1.0",
        range: FACTOR,
        missing: Means(1.0),
        steps: [0.05, 0.25],
        published: None,
    },
    InputRow {
        input: Input::GammaResistance,
        word: "gR",
        symbol: "gR",
        label: "res. fac",
        phrase: "partial factor on the resistance",
        quantity: Number,
        name: "gamma_resistance",
        flag: "--gamma-resistance",
        help: "Partial factor on the resistance [default: 1]",
        column: "gamma_resistance",
        example: "1.0",
        range: FACTOR,
        missing: Means(1.0),
        steps: [0.05, 0.25],
        published: None,
    },
    InputRow {
        input: Input::LabForce,
        word: "Fl",
        symbol: "F_l*",
        label: "lab force",
        phrase: "force of the standard laboratory test",
        quantity: Force,
        name: "laboratory.force",
        flag: "",
        help: "",
        column: "F_l_kN",
        example: "73.3",
        range: Range::UpTo(mesh::LARGEST_FORCE),
        missing: Needed,
        steps: [1.0e3, 1.0e4],
        published: None,
    },
    InputRow {
        input: Input::LabDeflection,
        word: "dl",
        symbol: "delta_l*",
        label: "lab defl.",
        phrase: "deflection of the standard laboratory test",
        quantity: Length,
        name: "laboratory.deflection",
        flag: "",
        help: "",
        column: "delta_l_m",
        example: "0.60",
        range: Range::UpTo(mesh::LARGEST_DEFLECTION),
        missing: Needed,
        steps: [0.01, 0.10],
        published: None,
    },
];

/// What a partial factor may be.
const FACTOR: Range = Range::Between(0.5, 5.0);

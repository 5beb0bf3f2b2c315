//! The inputs of a case, each defined once: what it is called, measures and may be, and where it
//! stands in a file, on the command line and in a table. Whoever reads, writes, asks for or shows an
//! input takes it from here.
//!
//! A new input is a variant, a row of [`TABLE`] and a line each in [`Input::of`] and [`Input::put`]
//! (in [`Case::get`](super::Case::get) and [`Case::set`](super::Case::set) if it belongs to the mesh).

use super::range::Range;
use crate::forecast::design::Question;
use crate::forecast::warning::{PLATE, PUNCH, PublishedRange, SPACING};
use crate::layout::Layout;
use crate::mesh;
use crate::problem::Problem;
use crate::units::{Quantity, shortest, to_kn};
use crate::words::Choice;

/// One input of a case. Lengths are metres and forces newtons, everywhere but in texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Input {
    /// Side of the anchor plate, d.
    Plate,
    /// Anchor spacing, L. The offsets stay as they are in metres.
    Spacing,
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
    /// Allowable deflection.
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
    input: Input,
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
const TABLE: [InputRow; 13] = [
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
        phrase: "anchor spacing, square grid only",
        quantity: Length,
        name: "L",
        flag: "-L",
        help: "Anchor spacing, L; anchors stand on a square grid [default: 3 m]",
        column: "L_m",
        example: "3.0",
        range: Range::Spacing,
        missing: Needed,
        steps: [0.05, 0.50],
        published: Some(SPACING),
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
        help: "Offset of the block across the twists, -L/2 to L/2 [default: 0 m]",
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
        help: "Offset of the block along the twists, down the slope, -L/2 to L/2 [default: 0 m]",
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

impl Choice for Input {
    const ALL: &'static [Input] = &[
        Input::Plate,
        Input::Spacing,
        Input::Punch,
        Input::OffsetX,
        Input::OffsetY,
        Input::DesignForce,
        Input::Pressure,
        Input::AllowableDeflection,
        Input::AnchorResistance,
        Input::GammaLoad,
        Input::GammaResistance,
        Input::LabForce,
        Input::LabDeflection,
    ];

    fn word(self) -> &'static str {
        self.row().word
    }
}

impl Input {
    /// The inputs of a layout and its design question, in the order of screens and flags.
    pub const LAYOUT: [Input; 11] = [
        Input::Plate,
        Input::Spacing,
        Input::Punch,
        Input::OffsetX,
        Input::OffsetY,
        Input::DesignForce,
        Input::Pressure,
        Input::AllowableDeflection,
        Input::AnchorResistance,
        Input::GammaLoad,
        Input::GammaResistance,
    ];

    /// The geometry alone.
    pub(crate) const GEOMETRY: [Input; 5] =
        [Input::Plate, Input::Spacing, Input::Punch, Input::OffsetX, Input::OffsetY];

    /// What is asked, alone.
    pub(crate) const QUESTION: [Input; 6] = [
        Input::DesignForce,
        Input::Pressure,
        Input::AllowableDeflection,
        Input::AnchorResistance,
        Input::GammaLoad,
        Input::GammaResistance,
    ];

    /// What a study varies: the geometry and the laboratory values.
    pub const VARIED: [Input; 7] = [
        Input::Plate,
        Input::Spacing,
        Input::Punch,
        Input::OffsetX,
        Input::OffsetY,
        Input::LabForce,
        Input::LabDeflection,
    ];

    /// All there is to know of it.
    pub(crate) fn row(self) -> &'static InputRow {
        &TABLE[self as usize]
    }

    /// The word for commands, narrow tables and the screen: `d`, `L`, `D`, `ex`, `ey`, `Fl`, `dl`.
    pub fn word(self) -> &'static str {
        self.row().word
    }

    /// The paper's symbol: `F_l*` for the laboratory force.
    pub(crate) fn symbol(self) -> &'static str {
        self.row().symbol
    }

    /// The name in JSON and CSV, with its unit: `L_m`, `F_l_kN`.
    pub(crate) fn column(self) -> &'static str {
        self.row().column
    }

    /// Whether it is a force.
    pub(crate) fn is_force(self) -> bool {
        self.row().quantity == Force
    }

    /// Whether its column is in thousands of its SI unit: kN, kN/m2.
    pub(crate) fn in_kilo(self) -> bool {
        matches!(self.row().quantity, Force | Pressure)
    }

    /// The input of this name in a layout of a project file.
    pub(crate) fn named(name: &str) -> Option<Input> {
        let mut of_layout = TABLE.iter().filter(|row| !row.input.is_laboratory());
        of_layout.find(|row| row.name == name).map(|row| row.input)
    }

    /// Whether it belongs to the mesh's laboratory test and not to the layout.
    pub(crate) fn is_laboratory(self) -> bool {
        matches!(self, Input::LabForce | Input::LabDeflection)
    }

    /// Whether it is an offset of the punch.
    pub(crate) fn is_offset(self) -> bool {
        matches!(self, Input::OffsetX | Input::OffsetY)
    }

    /// The input that it stands instead of, where only one of two can be given: the load is a force or
    /// a pressure.
    pub(crate) fn instead_of(self) -> Option<Input> {
        match self {
            Input::DesignForce => Some(Input::Pressure),
            Input::Pressure => Some(Input::DesignForce),
            _ => None,
        }
    }

    /// Whether it may be left out or taken away.
    pub(crate) fn clearable(self) -> bool {
        self.row().missing != Needed
    }

    /// The value in a layout with its question, SI; missing where it is not set and where it is the
    /// mesh's.
    pub(crate) fn of(self, layout: &Layout, question: &Question) -> Option<f64> {
        match self {
            Input::Plate => Some(layout.plate),
            Input::Spacing => Some(layout.spacing),
            Input::Punch => Some(layout.punch),
            Input::OffsetX => Some(layout.ex),
            Input::OffsetY => Some(layout.ey),
            Input::DesignForce => question.force,
            Input::Pressure => question.pressure,
            Input::AnchorResistance => question.anchor_resistance,
            Input::AllowableDeflection => question.deflection,
            Input::GammaLoad => Some(question.gamma_load),
            Input::GammaResistance => Some(question.gamma_resistance),
            Input::LabForce | Input::LabDeflection => None,
        }
    }

    /// Sets the value in SI, unchecked. `None` takes it away: what may be missing is missing then, or
    /// has its default; what is needed stays.
    pub(crate) fn put(self, layout: &mut Layout, question: &mut Question, value: Option<f64>) {
        let sure = match (value, self.row().missing) {
            (Some(value), _) | (None, Means(value)) => value,
            (None, Needed) => return,
            (None, Nothing) => f64::NAN,
        };
        match self {
            Input::Plate => layout.plate = sure,
            Input::Spacing => layout.spacing = sure,
            Input::Punch => layout.punch = sure,
            Input::OffsetX => layout.ex = sure,
            Input::OffsetY => layout.ey = sure,
            Input::DesignForce => question.force = value,
            Input::Pressure => question.pressure = value,
            Input::AnchorResistance => question.anchor_resistance = value,
            Input::AllowableDeflection => question.deflection = value,
            Input::GammaLoad => question.gamma_load = sure,
            Input::GammaResistance => question.gamma_resistance = sure,
            Input::LabForce | Input::LabDeflection => {}
        }
    }

    /// What is wrong with a value whatever the other inputs are; the field is its name in the file.
    pub(crate) fn problem(self, value: f64) -> Option<Problem> {
        let row = self.row();
        (!row.range.holds_alone(value)).then(|| {
            Problem::new(row.name, "the value is outside what makes sense")
                .value(self.text(value))
                .allowed(row.range.alone(row.quantity))
        })
    }

    /// What it may be, as text for files and flags: `above 0, up to 10000 kN`.
    pub(crate) fn allowed(self) -> String {
        self.row().range.text(self.row().quantity)
    }

    /// A value as a person writes it, with its unit: `2.5 m`, `73.3 kN`.
    pub(crate) fn text(self, value: f64) -> String {
        match self.row().quantity {
            _ if !value.is_finite() => value.to_string(),
            Length => format!("{} m", shortest(value)),
            Force => format!("{} kN", shortest(to_kn(value))),
            Pressure => format!("{} kN/m2", shortest(to_kn(value))),
            Number => shortest(value),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    #[test]
    fn the_table_stands_in_the_order_of_the_inputs() {
        assert_eq!(Input::ALL.len(), TABLE.len());
        for (at, row) in TABLE.iter().enumerate() {
            assert_eq!(row.input as usize, at, "{:?}", row.input);
        }
    }

    #[test]
    fn a_layout_has_its_geometry_and_its_question() {
        assert_eq!([&Input::GEOMETRY[..], &Input::QUESTION[..]].concat(), Input::LAYOUT);
    }

    #[test]
    fn no_two_inputs_share_a_name() {
        type Name = fn(&InputRow) -> &'static str;
        let names: [Name; 4] = [|r| r.word, |r| r.name, |r| r.flag, |r| r.column];
        for name in names {
            let all: Vec<&str> = TABLE.iter().map(name).filter(|n| !n.is_empty()).collect();
            let different: std::collections::BTreeSet<&&str> = all.iter().collect();
            assert_eq!(different.len(), all.len(), "{all:?}");
        }
    }

    /// The ground knows no table of inputs, yet speaks of its fields by the same names.
    #[test]
    fn the_fields_that_a_layout_complains_of_are_inputs() {
        let nan = f64::NAN;
        let wrong = Layout { plate: nan, spacing: nan, punch: nan, ex: nan, ey: nan, ..REFERENCE };
        let fields: Vec<_> =
            wrong.check().unwrap_err().iter().map(|p| Input::named(&p.field)).collect();
        assert_eq!(fields, Input::GEOMETRY.map(Some));
    }

    #[test]
    fn what_is_taken_away_is_missing_or_has_its_default() {
        let question = Question { force: Some(1.0), deflection: Some(1.0), ..Question::default() };
        for input in Input::LAYOUT {
            let (mut layout, mut question) = (REFERENCE, question);
            let before = input.of(&layout, &question);
            input.put(&mut layout, &mut question, Some(0.7));
            input.put(&mut layout, &mut question, None);
            let wanted = match input.row().missing {
                Needed => Some(0.7),
                Means(value) => Some(value),
                Nothing => None,
            };
            assert_eq!(input.of(&layout, &question), wanted, "{input:?}, before {before:?}");
        }
    }
}

//! The inputs of a case, each defined once: what it is called, measures and may be, and where it
//! stands in a file, on the command line and in a table. Whoever reads, writes, asks for or shows an
//! input takes it from here.
//!
//! A new input is a variant, a row of the table ([`super::table`]) and a line each in [`Input::of`] and
//! [`Input::put`] (in [`Case::get`](super::Case::get) and [`Case::set`](super::Case::set) if it belongs to the mesh).

pub use super::table::Input;
pub(crate) use super::table::Missing;

use super::table::{InputRow, TABLE};
use crate::forecast::design::Question;
use crate::layout::Layout;
use crate::problem::Problem;
use crate::units::{Quantity, shortest, to_kn};
use crate::words::Choice;
use Missing::{Means, Needed, Nothing};
use Quantity::{Force, Length, Number, Pressure};

/// The name of the spacing, in files and problems, where there are two.
pub(crate) const LX: &str = "Lx";

impl Choice for Input {
    /// The geometry, what is asked of the layout, and the laboratory's values, in the order of screens and flags.
    const ALL: &'static [Input] = &[
        Input::Plate,
        Input::Spacing,
        Input::SpacingUp,
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

/// Some of [`Input::ALL`] that stand together there.
const fn part<const N: usize>(from: usize) -> [Input; N] {
    let mut part = [Input::Plate; N];
    let mut k = 0;
    while k < N {
        part[k] = <Input as Choice>::ALL[from + k];
        k += 1;
    }
    part
}

impl Input {
    /// The inputs of a layout and its design question, in the order of screens and flags.
    pub const LAYOUT: [Input; 12] = part(0);

    /// The geometry alone.
    pub(crate) const GEOMETRY: [Input; 6] = part(0);

    /// What is asked, alone.
    pub(crate) const QUESTION: [Input; 6] = part(6);

    /// What a study varies: the geometry and the laboratory values. A layout has not all of them, see
    /// [`Input::varied`].
    pub const VARIED: [Input; 8] = [
        Input::Plate,
        Input::Spacing,
        Input::SpacingUp,
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

    /// The word in a layout: `Lx` where the grid has two spacings.
    pub(crate) fn word_in(self, layout: &Layout) -> &'static str {
        match self {
            Input::Spacing => layout.words()[0],
            _ => self.word(),
        }
    }

    /// The paper's symbol in a layout, or its word: `Lx` where the grid has two spacings.
    pub(crate) fn symbol_in(self, layout: &Layout) -> &'static str {
        match self {
            Input::Spacing => layout.words()[0],
            _ => self.symbol(),
        }
    }

    /// Whether a layout has it: a grid with one spacing has no second one.
    pub(crate) fn stands_in(self, layout: &Layout) -> bool {
        self != Input::SpacingUp || layout.grid.up.is_some()
    }

    /// What a study of a layout varies: of [`Input::VARIED`] what it has.
    pub(crate) fn varied(layout: &Layout) -> impl Iterator<Item = Input> {
        Input::VARIED.into_iter().filter(|input| input.stands_in(layout))
    }

    /// The inputs that a layout has, of those in [`Input::LAYOUT`].
    pub(crate) fn of_layout(layout: &Layout) -> Vec<Input> {
        Input::LAYOUT.into_iter().filter(|input| input.stands_in(layout)).collect()
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

    /// The input of this name in a layout of a project file; `Lx` is `L` of a grid with two spacings.
    pub(crate) fn named(name: &str) -> Option<Input> {
        let name = if name == LX { Input::Spacing.row().name } else { name };
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
            Input::SpacingUp => layout.grid.up,
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
            Input::SpacingUp => layout.grid.up = value,
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
    use crate::layout::{Grid, REFERENCE};

    #[test]
    fn the_table_stands_in_the_order_of_the_inputs() {
        assert_eq!(Input::ALL.len(), TABLE.len());
        for (at, row) in TABLE.iter().enumerate() {
            assert_eq!(row.input as usize, at, "{:?}", row.input);
        }
    }

    #[test]
    fn a_layout_has_its_geometry_and_its_question_and_no_laboratory_value() {
        let ends = |all: &[Input]| [all[0], all[all.len() - 1]];
        assert_eq!(ends(&Input::GEOMETRY), [Input::Plate, Input::OffsetY]);
        assert_eq!(ends(&Input::QUESTION), [Input::DesignForce, Input::GammaResistance]);
        assert_eq!(ends(&Input::LAYOUT), [Input::Plate, Input::GammaResistance]);
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
        let grid = Grid { up: Some(nan), ..REFERENCE.grid };
        let wrong =
            Layout { plate: nan, spacing: nan, punch: nan, ex: nan, ey: nan, grid, ..REFERENCE };
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

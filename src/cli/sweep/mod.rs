//! `meshcast sweep`: one input over a range, or two over a grid.
//!
//! - [`text`]: a line plotted in characters; [`both`]: the same with checks; [`map`]: a grid as shaded
//!   cells; [`json`], [`csv`] of its [`table`]: for programs.

mod both;
mod csv;
mod json;
mod map;
mod table;
mod text;

use super::UiFlags;
use super::case::Source;
use super::choice::one_of;
use super::dem::{DemFlags, Done, Job};
use super::output::{CommandEnd, Fault, Output, TableFormat};
use super::verdict::BasisFlag;
use crate::case::{Case, Input};
use crate::problem::Problem;
use crate::study::checks::CheckAnswer;
use crate::study::sweep::{Sweep, SweepAxis, SweepGrid, dem, sweep};
use crate::study::verdict::Basis;
use crate::units::{Quantity, Units, parse};
use clap::Args;

/// F, delta and utilisation over a range of one input, or over a grid of two.
///
/// Inputs: d, L, D, ex, ey (m), Fl (laboratory force F_l*, kN), dl (laboratory deflection delta_l*, m).
/// With --dem each point by discrete elements too, unless Fl or dl is varied, which those do not know.
#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    source: Source,
    #[command(flatten)]
    ranges: Ranges,
    #[command(flatten)]
    basis: BasisFlag,
    #[command(flatten)]
    dem: DemFlags,
    /// How the result is written: JSON and CSV in SI with kN.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Ranges (both ends belong to them)")]
struct Ranges {
    /// The input to vary.
    #[arg(long, value_name = "INPUT", value_parser = one_of(&Input::VARIED))]
    vary: Input,
    /// Its first value.
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    from: String,
    /// Its last value.
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    to: String,
    /// Number of values, both ends included.
    #[arg(long, value_name = "N", default_value_t = 21)]
    steps: usize,
    /// A second input: the result is a map.
    #[arg(long, value_name = "INPUT", value_parser = one_of(&Input::VARIED), requires_all = ["from2", "to2"])]
    vary2: Option<Input>,
    /// Its first value.
    #[arg(long, value_name = "M", requires = "vary2", allow_hyphen_values = true)]
    from2: Option<String>,
    /// Its last value.
    #[arg(long, value_name = "M", requires = "vary2", allow_hyphen_values = true)]
    to2: Option<String>,
    /// Number of its values [default: 11].
    #[arg(long, value_name = "N", requires = "vary2")]
    steps2: Option<usize>,
}

/// Values of the second input, where their number is not given.
const STEPS_2: usize = 11;

/// One layout with its sweep.
#[derive(Debug)]
struct Swept {
    name: Option<String>,
    case: Case,
    /// Which value of a capacity verdicts go by.
    basis: Basis,
    sweep: Sweep,
    /// The check of each point, where checks are asked for.
    checked: Option<Vec<CheckAnswer>>,
}

impl Ranges {
    fn grid(&self) -> Result<SweepGrid, Fault> {
        let value = |flag: &str, text: &str, input: Input| {
            let (quantity, how) = if input.is_force() {
                (Quantity::Force, "a force in kN or with a unit such as 73300N")
            } else {
                (Quantity::Length, "a length in metres or with a unit such as 250mm")
            };
            parse(text, quantity, Units::METRES).map_err(|e| {
                Fault::input(
                    Problem::new(flag, e.to_string())
                        .value(format!("{text:?}"))
                        .allowed(how)
                        .to_string(),
                )
            })
        };
        let first = SweepAxis {
            input: self.vary,
            from: value("--from", &self.from, self.vary)?,
            to: value("--to", &self.to, self.vary)?,
            steps: self.steps,
        };
        let second = match (self.vary2, &self.from2, &self.to2) {
            (Some(input), Some(from), Some(to)) => Some(SweepAxis {
                input,
                from: value("--from2", from, input)?,
                to: value("--to2", to, input)?,
                steps: self.steps2.unwrap_or(STEPS_2),
            }),
            _ => None,
        };
        SweepGrid::new(first, second).map_err(|found| {
            Fault::from(found.into_iter().map(|p| p.renamed(FLAGS)).collect::<Vec<_>>())
        })
    }
}

/// The flags of the axes, by the names of their fields.
const FLAGS: &[(&str, &str)] = &[
    ("first.from", "--from"),
    ("first.to", "--to"),
    ("first.steps", "--steps"),
    ("second.from", "--from2"),
    ("second.to", "--to2"),
    ("second.steps", "--steps2"),
    ("second", "--vary2"),
];

/// Sweeps each layout and writes the result in the form asked for.
pub(crate) fn run(args: &SweepArgs, ui: &UiFlags) -> CommandEnd {
    let grid = args.ranges.grid()?;
    let loaded = args.source.load(ui).or_else(|fault| {
        // What is varied need not make sense at its default beside the other flags: an end of the
        // range stands in for it.
        let end = |of: fn(&SweepAxis) -> f64| {
            let axes = std::iter::once(&grid.first).chain(&grid.second);
            let defaults: Vec<(Input, f64)> = axes.map(|axis| (axis.input, of(axis))).collect();
            args.source.with_defaults(&defaults).load(ui)
        };
        end(|axis| axis.from).or_else(|_| end(|axis| axis.to)).map_err(|_| fault)
    })?;
    let basis = args.basis.basis(loaded.basis);
    let mut swept: Vec<Swept> = loaded
        .cases
        .into_iter()
        .map(|c| {
            let case = c.case;
            let sweep = sweep(&case, grid.clone());
            Swept { sweep, name: c.name, case, basis, checked: None }
        })
        .collect();
    let wanted = args.dem.wanted();
    let mut interrupted = false;
    if let Some(wanted) = &wanted {
        let jobs: Vec<Job> = swept.iter().flat_map(|s| jobs(s, &grid)).collect();
        let done = args.dem.run(wanted, &jobs);
        interrupted = done.interrupted;
        put(&mut swept, &grid, done);
    }
    let result = args.format.write(
        || text::report(&swept, wanted.as_ref(), loaded.unit),
        || json::report(&swept, wanted.as_ref(), loaded.several),
        || csv::report(&swept, &grid, wanted.is_some(), loaded.several),
    )?;
    Ok(Output { result, interrupted, ..Output::default() })
}

/// The checks of a layout's points; none where a check does not know what is varied.
fn jobs(s: &Swept, grid: &SweepGrid) -> Vec<Job> {
    let front = s.name.as_ref().map_or(String::new(), |name| format!("{name:?}, "));
    let cases = dem::cases(&s.case, grid).unwrap_or_default();
    let named =
        |(index, case): (usize, Case)| Job { name: format!("{front}{}", point(grid, index)), case };
    cases.into_iter().enumerate().map(named).collect()
}

/// Gives each layout its own answers.
fn put(swept: &mut [Swept], grid: &SweepGrid, done: Done) {
    let mut answers = done.answers.into_iter();
    for s in swept {
        let own = match dem::cases(&s.case, grid) {
            Ok(cases) => answers.by_ref().take(cases.len()).collect(),
            Err(why) => vec![Err(why); grid.len()],
        };
        s.checked = Some(own);
    }
}

/// A point by its inputs: `L 2.5 m, D 0.6 m`.
fn point(grid: &SweepGrid, index: usize) -> String {
    let (first, second) = grid.at(index);
    let of = |axis: &SweepAxis, value| format!("{} {}", axis.input.word(), axis.input.text(value));
    let second = grid.second.as_ref().zip(second).map(|(axis, value)| of(axis, value));
    let all: Vec<String> = std::iter::once(of(&grid.first, first)).chain(second).collect();
    all.join(", ")
}

//! `meshcast design`: the answer to a design question, and the plate, spacing or punch that just meets
//! it.
//!
//! - [`text`]: sentences for people; [`json`], [`csv`]: for programs.

mod csv;
mod json;
mod text;

use super::UiFlags;
use super::case::Source;
use super::choice::one_of;
use super::output::{CommandEnd, Fault, Output, TableFormat};
use super::verdict::VerdictFlags;
use crate::case::{self, Case, Input};
use crate::study::solve::{Crossing, Requirement, Solution, solve};
use crate::study::verdict::{Simulated, Verdict, verdict};
use clap::Args;

/// Which plate, spacing or punch just meets a design force or an allowable deflection.
///
/// The question comes from --force, --deflection and the partial factors, or from the project. With
/// both a force and a deflection each is solved for, and both at once; the deflection is then that at
/// the design force without its factor, and without a force it is delta_a. Searched: the published range.
#[derive(Debug, Args)]
pub(crate) struct DesignArgs {
    #[command(flatten)]
    source: Source,
    /// The input to solve for [default: each of d, L and D].
    #[arg(long, value_name = "INPUT", value_parser = one_of(&[Input::Plate, Input::Spacing, Input::Punch]))]
    solve: Option<Input>,
    #[command(flatten)]
    verdict: VerdictFlags,
    /// How the result is written: JSON and CSV in SI with kN.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// Inputs that can be solved for: those with a published range, the spacing first.
const SOLVED: [Input; 3] = [Input::Spacing, Input::Plate, Input::Punch];

/// One layout with its solutions.
#[derive(Debug)]
struct Solved {
    name: Option<String>,
    case: Case,
    outcome: case::CaseValue,
    /// Whether it is enough as it stands.
    verdict: Verdict,
    /// By input, then by requirement; empty where nothing is asked of the layout.
    solutions: Vec<Solution>,
}

/// On which side of a crossing a requirement is met.
fn side(c: &Crossing) -> &'static str {
    if c.met_above { "above" } else { "below" }
}

/// Solves for each layout and writes the result in the form asked for.
pub(crate) fn run(args: &DesignArgs, ui: &UiFlags) -> CommandEnd {
    let loaded = args.source.load(ui)?;
    let basis = args.verdict.basis(loaded.basis);
    let inputs = args.solve.map_or(SOLVED.to_vec(), |one| vec![one]);
    let solved: Vec<Solved> = loaded
        .cases
        .into_iter()
        .map(|c| {
            let case = c.case;
            let asked = Requirement::of(&case);
            let pairs = inputs.iter().flat_map(|i| asked.iter().map(move |r| (*i, *r)));
            let solutions = pairs.filter_map(|(i, r)| solve(&case, i, r, basis)).collect();
            let outcome = case.outcome();
            let kept = Simulated::of(c.check.as_deref(), &case);
            let verdict = verdict(&case, &outcome, kept, basis);
            Solved { name: c.name, outcome, verdict, solutions, case }
        })
        .collect();
    if !solved.is_empty() && solved.iter().all(|s| s.solutions.is_empty()) {
        return Err(Fault::input(
            "there is nothing to design for; give --force or --deflection, or put a design_force or an allowable_deflection in the project",
        ));
    }
    let result = args.format.write(
        || text::report(&solved, loaded.unit),
        || json::report(&solved, loaded.several),
        || csv::report(&solved, loaded.several),
    )?;
    let verdict = args.verdict.code(solved.iter().map(|s| &s.verdict));
    Ok(Output { result, verdict, ..Output::default() })
}

//! Which plate, spacing or punch just meets the design values of the selected layout.

use super::super::keymap::StudyPage;
use super::super::status::Status;
use super::super::work::campaign::Coverage;
use super::given::Given;
use crate::case::{Case, CaseValue, Input};
use crate::fingerprint::Fingerprint;
use crate::study::checks::CheckAnswer;
use crate::study::checks::figures::Figures;
use crate::study::solve::{Crossing, Place, Requirement, Solution, solve};
use crate::study::verdict::Basis;
use std::sync::Arc;

/// The inputs that are solved for.
const SOLVED: [Input; 3] = [Input::Plate, Input::Spacing, Input::Punch];

/// What the page shows.
#[derive(Debug)]
pub struct DesignView {
    /// Which value of the capacities is taken.
    pub basis: Basis,
    /// The layout as a case.
    pub case: Case,
    /// What it gives.
    pub outcome: CaseValue,
    /// What can be asked of it; empty where no design value is set.
    pub asked: Vec<Requirement>,
    /// What is asked of it here.
    pub requirement: Option<Requirement>,
    /// The answers for d, L and D.
    pub solutions: Arc<Vec<Solution>>,
    /// A line for each value that just meets it, and one for each input that has none.
    pub lines: Vec<DesignLine>,
    /// The marked line.
    pub marked: usize,
    /// How much of it is checked.
    pub coverage: Coverage,
    /// What the check of the layout itself says.
    pub own: Option<Figures>,
}

/// A line of the list.
#[derive(Debug)]
pub struct DesignLine {
    /// What is solved for: d, L or D.
    pub input: Input,
    /// What there is to take.
    pub kind: DesignKind,
    /// What the check says of it.
    pub figures: Option<Figures>,
}

/// What a line offers.
#[derive(Debug)]
pub enum DesignKind {
    /// A value at which the requirement comes to be met or not.
    Take {
        crossing: Box<Crossing>,
        /// The value to take, m: the nearest whole millimetre that meets it, or the crossing.
        value: f64,
        /// What it gives.
        outcome: CaseValue,
    },
    /// The whole range meets it.
    Always,
    /// Nothing in the range meets it; the nearest there is.
    Never(Option<Place>),
}

/// What solutions are made of: the question, what has to be met, and on which basis.
type Solving = (Fingerprint, Requirement, Basis);

/// Where the user is on the page.
#[derive(Debug, Default)]
pub(crate) struct DesignState {
    requirement: Option<Requirement>,
    marked: usize,
    /// The last solutions with what they were made of: solving takes some milliseconds.
    solved: Option<(Solving, Arc<Vec<Solution>>)>,
    view: Option<DesignView>,
}

fn cases(case: &Case, lines: &[DesignLine]) -> Vec<Case> {
    let taken = lines.iter().filter_map(|line| match &line.kind {
        DesignKind::Take { value, .. } => Some(case.with(line.input, *value)),
        DesignKind::Always | DesignKind::Never(_) => None,
    });
    std::iter::once(case.clone()).chain(taken).collect()
}

/// What is said where there is nothing to be met.
const NOTHING_ASKED: &str = "no design value is set: F types a force, D a deflection";

/// What is said where anchors farther apart would be taken as a cure.
const NOT_ADVISED: &str = "wider anchors are no cure: more rock hangs on each";

impl DesignState {
    /// What the page shows.
    pub(in crate::app) fn view(&self) -> Option<&DesignView> {
        self.view.as_ref()
    }

    /// The cases to check: the layout, and each value that can be taken.
    pub(super) fn cases(&self) -> Vec<Case> {
        self.view.as_ref().map_or(Vec::new(), |view| cases(&view.case, &view.lines))
    }

    /// Makes what the page shows anew.
    pub(super) fn follow(&mut self, given: &Given) {
        self.view = given.case().map(|case| self.made(given, case));
    }

    fn made(&mut self, given: &Given, case: Case) -> DesignView {
        let asked = Requirement::of(&case);
        let chosen = self.requirement.filter(|r| asked.contains(r));
        // Both at once stands last.
        let requirement = chosen.or(asked.last().copied());
        let basis = given.editor.project().basis;
        let solutions = requirement.map_or_else(Arc::default, |r| self.solved(&case, r, basis));
        let mut lines: Vec<DesignLine> =
            solutions.iter().flat_map(|solution| lines(&case, solution)).collect();
        let all = cases(&case, &lines);
        let answers = given.answers(&all);
        let coverage = given.coverage(given.purpose(StudyPage::Design, 0), &all, &answers);
        let figures = |answer: Option<&CheckAnswer>, outcome: &CaseValue| {
            let result = answer?.as_ref().ok()?;
            let forecast = outcome.as_ref().ok().map(crate::case::CasePoint::values);
            Some(Figures::of(result, forecast, &case.asked()))
        };
        let outcome = case.outcome();
        let own = figures(answers.first(), &outcome);
        let mut rest = answers.iter().skip(1);
        for line in &mut lines {
            if let DesignKind::Take { outcome, .. } = &line.kind {
                line.figures = figures(rest.next(), outcome);
            }
        }
        let marked = self.marked.min(lines.len().saturating_sub(1));
        DesignView {
            basis,
            case,
            outcome,
            asked,
            requirement,
            solutions,
            lines,
            marked,
            coverage,
            own,
        }
    }

    /// The solutions, made anew only where something changed.
    fn solved(
        &mut self,
        case: &Case,
        requirement: Requirement,
        basis: Basis,
    ) -> Arc<Vec<Solution>> {
        let of = (case.question_fingerprint(), requirement, basis);
        if let Some((what, solutions)) = &self.solved
            && *what == of
        {
            return solutions.clone();
        }
        let all = SOLVED.into_iter().filter_map(|input| solve(case, input, requirement, basis));
        let solutions = Arc::new(all.collect::<Vec<Solution>>());
        self.solved = Some((of, solutions.clone()));
        solutions
    }

    /// Marks another line.
    pub(super) fn step(&mut self, lines: isize) {
        let last = self.view.as_ref().map_or(0, |view| view.lines.len().saturating_sub(1));
        self.marked = self.marked.saturating_add_signed(lines).min(last);
    }

    /// Asks for the next or the previous of what can be asked for.
    ///
    /// # Errors
    /// There is nothing.
    pub(super) fn next_requirement(&mut self, next: bool) -> Result<(), &'static str> {
        let Some(view) = &self.view else { return Ok(()) };
        let now = view.requirement.ok_or(NOTHING_ASKED)?;
        let pairs = view.asked.iter().zip(view.asked.iter().cycle().skip(1));
        let other = pairs.into_iter().find_map(|(one, other)| match next {
            true => (*one == now).then_some(*other),
            false => (*other == now).then_some(*one),
        });
        self.requirement = other.or(self.requirement);
        Ok(())
    }

    /// The layout with the marked value and the symbol of the input that it is of, or why there is
    /// nothing to take; nothing without a page.
    pub(super) fn taken(&self) -> Option<Result<(Case, &'static str), Status>> {
        let view = self.view.as_ref()?;
        let Some(line) = view.lines.get(view.marked) else {
            return Some(Err(Status::info(NOTHING_ASKED)));
        };
        let symbol = line.input.symbol();
        Some(match &line.kind {
            DesignKind::Take { crossing, .. } if !crossing.advised => {
                Err(Status::error(NOT_ADVISED))
            }
            DesignKind::Take { value, .. } => Ok((view.case.with(line.input, *value), symbol)),
            DesignKind::Always => {
                Err(Status::info(format!("every {symbol} of the range meets it")))
            }
            DesignKind::Never(_) => {
                Err(Status::error(format!("no {symbol} of the range meets it")))
            }
        })
    }
}

/// The lines of an input.
fn lines(case: &Case, solution: &Solution) -> Vec<DesignLine> {
    let input = solution.input;
    let line = |kind| DesignLine { input, kind, figures: None };
    let whole = match (solution.always(), solution.never()) {
        (true, _) => Some(DesignKind::Always),
        (_, true) => Some(DesignKind::Never(solution.best.clone())),
        _ => None,
    };
    let taken = solution.crossings.iter().map(|crossing| {
        let value = crossing.rounded.unwrap_or(crossing.value);
        let outcome = case.with(input, value).outcome();
        DesignKind::Take { crossing: Box::new(crossing.clone()), value, outcome }
    });
    whole.into_iter().chain(taken).map(line).collect()
}

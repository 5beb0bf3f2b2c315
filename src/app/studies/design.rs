//! Which plate, spacing or punch just meets the design values of the selected layout.

use super::super::entry::{EditTarget, LineEntry, Typed};
use super::super::keymap::{Ask, StudyPage};
use super::super::{App, Mode};
use super::campaign::Coverage;
use crate::case::{Case, CaseValue, Input};
use crate::fingerprint::Fingerprint;
use crate::study::checks::CheckAnswer;
use crate::study::checks::figures::Figures;
use crate::study::solve::{Crossing, Place, Requirement, Solution, solve};
use std::sync::Arc;

/// The inputs that are solved for.
const SOLVED: [Input; 3] = [Input::Plate, Input::Spacing, Input::Punch];

/// What the page shows.
#[derive(Debug)]
pub struct DesignView {
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
    /// The input.
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
        /// The crossing.
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

/// Where the user is on the page.
#[derive(Debug, Default)]
pub(crate) struct DesignState {
    requirement: Option<Requirement>,
    marked: usize,
    /// The last solutions with what they were made of: solving takes some milliseconds.
    solved: Option<(Fingerprint, Requirement, Arc<Vec<Solution>>)>,
    view: Option<DesignView>,
}

impl DesignState {
    /// The cases to check: the layout, and each value that can be taken.
    pub(super) fn cases(&self) -> Vec<Case> {
        self.view.as_ref().map_or(Vec::new(), |view| cases(&view.case, &view.lines))
    }
}

fn cases(case: &Case, lines: &[DesignLine]) -> Vec<Case> {
    let taken = lines.iter().filter_map(|line| match &line.kind {
        DesignKind::Take { value, .. } => Some(case.with(line.input, *value)),
        DesignKind::Always | DesignKind::Never(_) => None,
    });
    std::iter::once(case.clone()).chain(taken).collect()
}

impl App {
    /// The design page; nothing where it is not open or the layout's mesh is not known.
    pub fn design(&self) -> Option<&DesignView> {
        self.studies.design.view.as_ref()
    }

    pub(super) fn make_design(&mut self) {
        let view = self.case(self.selected).map(|case| self.design_of(case));
        self.studies.design.view = view;
    }

    fn design_of(&mut self, case: Case) -> DesignView {
        let asked = Requirement::asked(&case.question);
        let chosen = self.studies.design.requirement.filter(|r| asked.contains(r));
        // Both at once stands last.
        let requirement = chosen.or(asked.last().copied());
        let solutions = requirement.map_or_else(Arc::default, |r| self.solved(&case, r));
        let mut lines = Vec::new();
        for solution in solutions.iter() {
            let input = solution.input;
            let line = |kind| DesignLine { input, kind, figures: None };
            if solution.always() {
                lines.push(line(DesignKind::Always));
            } else if solution.never() {
                lines.push(line(DesignKind::Never(solution.best.clone())));
            }
            for crossing in &solution.crossings {
                let value = crossing.rounded.unwrap_or(crossing.value);
                let outcome = case.with(input, value).outcome();
                let crossing = Box::new(crossing.clone());
                lines.push(line(DesignKind::Take { crossing, value, outcome }));
            }
        }
        let all = cases(&case, &lines);
        let answers: Vec<CheckAnswer> = all.iter().map(|case| self.found(case)).collect();
        let coverage = self.coverage(self.purpose(StudyPage::Design, 0), &all, &answers);
        let figures = |answer: Option<&CheckAnswer>, outcome: &CaseValue| {
            let result = answer?.as_ref().ok()?;
            let forecast = outcome.as_ref().ok().map(|p| p.values());
            Some(Figures::of(result, forecast, &case.question))
        };
        let outcome = case.outcome();
        let own = figures(answers.first(), &outcome);
        let mut rest = answers.iter().skip(1);
        for line in &mut lines {
            if let DesignKind::Take { outcome, .. } = &line.kind {
                line.figures = figures(rest.next(), outcome);
            }
        }
        let marked = self.studies.design.marked.min(lines.len().saturating_sub(1));
        DesignView { asked, requirement, solutions, lines, marked, coverage, own, outcome, case }
    }

    /// The solutions, made anew only where something changed.
    fn solved(&mut self, case: &Case, requirement: Requirement) -> Arc<Vec<Solution>> {
        let of = case.question_fingerprint();
        if let Some((inputs, what, solutions)) = &self.studies.design.solved
            && (*inputs, *what) == (of, requirement)
        {
            return solutions.clone();
        }
        let all = SOLVED.into_iter().filter_map(|input| solve(case, input, requirement));
        let solutions = Arc::new(all.collect::<Vec<Solution>>());
        self.studies.design.solved = Some((of, requirement, solutions.clone()));
        solutions
    }

    pub(super) fn design_move(&mut self, lines: isize) {
        let state = &mut self.studies.design;
        let last = state.view.as_ref().map_or(0, |view| view.lines.len().saturating_sub(1));
        state.marked = state.marked.saturating_add_signed(lines).min(last);
    }

    pub(super) fn design_ask(&mut self, ask: Ask) {
        let field = match ask {
            Ask::NextColumn => return self.next_requirement(true),
            Ask::PreviousColumn => return self.next_requirement(false),
            Ask::DesignForce => Input::DesignForce,
            Ask::AllowableDeflection => Input::AllowableDeflection,
            Ask::LoadFactor => Input::GammaLoad,
            Ask::ResistanceFactor => Input::GammaResistance,
            _ => return,
        };
        let text = self.layout().get(field);
        let text = text.map_or(String::new(), |v| field.entry_text(v, self.units()));
        self.type_design(field, text);
    }

    /// Begins to type a design value.
    pub(super) fn type_design(&mut self, field: Input, text: impl Into<String>) {
        self.mode = Mode::Entry(LineEntry::new(EditTarget::Study(Typed::Design(field)), text));
    }

    fn next_requirement(&mut self, next: bool) {
        let Some(view) = &self.studies.design.view else { return };
        let count = view.asked.len();
        if count == 0 {
            return self.inform("no design value is set: F types a force, D a deflection");
        }
        let at = view.asked.iter().position(|r| Some(*r) == view.requirement).unwrap_or(0);
        let requirement = view.asked[(at + if next { 1 } else { count - 1 }) % count];
        self.studies.design.requirement = Some(requirement);
    }

    /// Takes the marked value into the layout.
    pub(super) fn design_take(&mut self) {
        let Some(view) = &self.studies.design.view else { return };
        let Some(line) = view.lines.get(view.marked) else {
            return self.inform("no design value is set: F types a force, D a deflection");
        };
        let symbol = line.input.symbol();
        match &line.kind {
            DesignKind::Take { value, .. } => {
                let case = view.case.with(line.input, *value);
                self.take_into_layout(case, symbol);
            }
            DesignKind::Always => self.inform(format!("every {symbol} of the range meets it")),
            DesignKind::Never(_) => self.complain(format!("no {symbol} of the range meets it")),
        }
    }
}

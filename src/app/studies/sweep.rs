//! One input over a range, or two over a map, of the selected layout: forecast at once, checks one
//! after the other where they were asked for.

use super::super::entry::{EditTarget, LineEntry, Slot, Typed};
use super::super::keymap::{Ask, StudyPage};
use super::super::message::Command;
use super::super::{App, Mode};
use super::campaign::Coverage;
use super::neighbour;
use crate::case::{Case, CaseValue, Input, StepSize};
use crate::fingerprint::Fingerprinter;
use crate::problem::{Problem, summary};
use crate::study::checks::figures::Figures;
use crate::study::checks::{CheckAnswer, NoCheck};
use crate::study::sensitivity::Effect;
use crate::study::sweep::{Grid, SweepAxis, dem, sweep};
use crate::units::{LengthUnit, Quantity, parse, shortest, to_kn};

/// Values of the first input where nobody says otherwise.
const FIRST: usize = 9;
/// Values of the second input where nobody says otherwise.
const SECOND: usize = 5;
/// Most values of an input on the screen; the command line takes more.
pub(crate) const MOST: usize = 61;
/// Points through which the forecast's line is drawn.
const LINE: usize = 161;

const SLOTS: [Slot; 4] = [Slot::Input, Slot::From, Slot::To, Slot::Steps];

/// What the page shows.
#[derive(Debug)]
pub struct SweepView {
    /// The layout as a case.
    pub case: Case,
    /// The ranges, whether they are sound or not.
    pub axes: Vec<SweepAxis>,
    /// What is wrong with them.
    pub problems: Vec<Problem>,
    /// The points; nothing where the ranges are not sound.
    pub grid: Option<Grid>,
    /// The forecast at the points.
    pub points: Vec<CaseValue>,
    /// The forecast along the line in finer steps: value of the input and outcome; empty for a map.
    pub line: Vec<(f64, CaseValue)>,
    /// The checks at the points, as far as there are any.
    pub answers: Vec<CheckAnswer>,
    /// What they say beside the forecast.
    pub figures: Vec<Option<Figures>>,
    /// How much of it is checked.
    pub coverage: Coverage,
    /// Why there can be no checks.
    pub no_dem: Option<NoCheck>,
    /// The value that is shown.
    pub shown: Effect,
    /// The marked point.
    pub marked: usize,
    /// Whether a map with room for one of both shows the checks.
    pub checks_shown: bool,
}

/// Where the user is on the page.
#[derive(Debug)]
pub(crate) struct SweepState {
    first: Input,
    second: Option<Input>,
    /// Ranges that were changed, by the place of the input.
    ranges: [Option<(f64, f64)>; 7],
    steps: [usize; 2],
    /// The slot that the arrows change: of which axis, and which.
    pub(super) slot: (usize, Slot),
    shown: Option<Effect>,
    marked: usize,
    checks_shown: bool,
    view: Option<SweepView>,
}

impl Default for SweepState {
    fn default() -> Self {
        SweepState {
            first: Input::Spacing,
            second: None,
            ranges: [None; 7],
            steps: [FIRST, SECOND],
            slot: (0, Slot::Input),
            shown: None,
            marked: FIRST / 2,
            checks_shown: false,
            view: None,
        }
    }
}

fn place(input: Input) -> usize {
    Input::VARIED.iter().position(|i| *i == input).unwrap_or(0)
}

/// The range of an input where nobody says otherwise: the published one, the quarter of the cell that
/// repeats, or 30 % around the mesh's own.
fn usual_range(input: Input, case: &Case) -> (f64, f64) {
    match input.row().published {
        Some(range) => (range.min, range.max),
        None if input.is_offset() => (0.0, case.layout.spacing / 2.0),
        None => (0.7 * input.value(case), 1.3 * input.value(case)),
    }
}

/// Small step of a range's end.
fn step_of(input: Input) -> f64 {
    input.step(StepSize::Fine)
}

impl SweepState {
    fn inputs(&self) -> Vec<Input> {
        std::iter::once(self.first).chain(self.second).collect()
    }

    fn range(&self, input: Input, case: &Case) -> (f64, f64) {
        self.ranges[place(input)].unwrap_or_else(|| usual_range(input, case))
    }

    fn axes(&self, case: &Case) -> Vec<SweepAxis> {
        let all = self.inputs().into_iter().zip(self.steps);
        all.map(|(input, steps)| {
            let (from, to) = self.range(input, case);
            SweepAxis { input, from, to, steps }
        })
        .collect()
    }

    /// Which ranges are swept, as a number; the usual range of an offset follows the layout and counts
    /// as the same.
    pub(super) fn question(&self) -> u64 {
        let of = Fingerprinter::new("ranges");
        let inputs = self.inputs().into_iter().zip(self.steps);
        let taken = inputs.fold(of, |of, (input, steps)| {
            let range = self.ranges[place(input)];
            of.text(input.word())
                .optional(range.map(|r| r.0))
                .optional(range.map(|r| r.1))
                .text(&steps.to_string())
        });
        taken.finish().0
    }

    /// The cases to check, or why there are none.
    pub(super) fn cases(&self) -> Result<Vec<Case>, String> {
        let Some(view) = &self.view else { return Ok(Vec::new()) };
        match (&view.grid, &view.no_dem) {
            (_, Some(why)) => Err(format!("no check: {}", why.sentence())),
            (Some(grid), None) => dem::cases(&view.case, grid).map_err(|why| why.sentence()),
            (None, None) => Err(summary(&view.problems)),
        }
    }
}

impl App {
    /// The sweep; nothing where the page is not open or the layout's mesh is not known.
    pub fn sweep(&self) -> Option<&SweepView> {
        self.studies.sweep.view.as_ref()
    }

    /// The slot that the arrows change: of the first input (0) or the second (1), and which.
    pub(crate) fn sweep_slot(&self) -> (usize, Slot) {
        self.studies.sweep.slot
    }

    pub(super) fn make_sweep(&mut self) {
        let view = self.case(self.selected).map(|case| self.sweep_of(case));
        if let Some(view) = &view {
            self.studies.sweep.marked = view.marked;
        }
        self.studies.sweep.view = view;
    }

    fn sweep_of(&self, case: Case) -> SweepView {
        let state = &self.studies.sweep;
        let axes = state.axes(&case);
        // There always is a first one.
        let made = match axes[..] {
            [first] => Grid::new(first, None),
            [first, second, ..] => Grid::new(first, Some(second)),
            [] => Err(Vec::new()),
        };
        let asked = case.question.force.is_some();
        let shown = state.shown.filter(|e| asked || *e != Effect::Utilisation);
        let mut view = SweepView {
            axes,
            problems: Vec::new(),
            grid: None,
            points: Vec::new(),
            line: Vec::new(),
            answers: Vec::new(),
            figures: Vec::new(),
            coverage: Coverage::default(),
            no_dem: None,
            shown: shown.unwrap_or(Effect::Force),
            marked: 0,
            checks_shown: state.checks_shown,
            case,
        };
        let grid = match made {
            Ok(grid) => grid,
            Err(problems) => return SweepView { problems, ..view },
        };
        match dem::cases(&view.case, &grid) {
            Ok(cases) => {
                view.answers = cases.iter().map(|case| self.found(case)).collect();
                view.coverage = self.coverage(
                    self.purpose(StudyPage::Sweep, state.question()),
                    &cases,
                    &view.answers,
                );
            }
            Err(why) => view.no_dem = Some(why),
        }
        view.points = sweep(&view.case, grid.clone()).points;
        view.figures = (view.answers.iter().zip(&view.points))
            .map(|(answer, point)| {
                let forecast = point.as_ref().ok().map(|p| p.values());
                answer.as_ref().ok().map(|v| Figures::of(v, forecast, &view.case.question))
            })
            .collect();
        view.marked = state.marked.min(grid.len().saturating_sub(1));
        if grid.second.is_none()
            && let Ok(fine) = Grid::new(SweepAxis { steps: LINE, ..grid.first }, None)
        {
            let columns = fine.columns.clone();
            view.line = columns.into_iter().zip(sweep(&view.case, fine).points).collect();
        }
        view.grid = Some(grid);
        view
    }

    /// Goes to another slot.
    pub(super) fn sweep_move(&mut self, lines: isize) {
        let state = &mut self.studies.sweep;
        let at = SLOTS.iter().position(|s| *s == state.slot.1).unwrap_or(0) + 4 * state.slot.0;
        let count = SLOTS.len() * state.inputs().len();
        let to = at.saturating_add_signed(lines).min(count - 1);
        state.slot = (to / SLOTS.len(), SLOTS[to % SLOTS.len()]);
    }

    pub(super) fn sweep_ask(&mut self, ask: Ask) {
        match ask {
            Ask::NextColumn => self.change_slot(true),
            Ask::PreviousColumn => self.change_slot(false),
            Ask::NextValue => {
                let asked = self.layout().question.force.is_some();
                let state = &mut self.studies.sweep;
                let now = state.view.as_ref().map_or(Effect::Force, |view| view.shown);
                state.shown = Some(neighbour(now, true, asked));
            }
            Ask::MarkNext | Ask::MarkPrevious => {
                let state = &mut self.studies.sweep;
                let way = if ask == Ask::MarkNext { 1 } else { -1 };
                state.marked = state.marked.saturating_add_signed(way);
            }
            Ask::Two if self.studies.sweep.slot.1 != Slot::Input => {
                self.type_slot(Some('2'));
            }
            Ask::SecondInput | Ask::Two => self.toggle_second(),
            Ask::Layer => {
                self.studies.sweep.checks_shown = !self.studies.sweep.checks_shown;
            }
            Ask::Adopt => self.adopt_point(),
            _ => {}
        }
    }

    fn toggle_second(&mut self) {
        let state = &mut self.studies.sweep;
        state.second = match state.second {
            Some(_) => None,
            None if state.first == Input::Spacing => Some(Input::Punch),
            None => Some(Input::Spacing),
        };
        state.slot = if state.second.is_some() { (1, Slot::Input) } else { (0, Slot::Input) };
        state.marked = 0;
        let said = match state.second {
            Some(input) => {
                format!("against {}: arrows choose another; m takes it away", input.symbol())
            }
            None => "one input".to_string(),
        };
        self.inform(said);
    }

    /// Changes the chosen slot by an arrow.
    fn change_slot(&mut self, up: bool) {
        let Some(case) = self.case(self.selected) else { return };
        let state = &mut self.studies.sweep;
        let (axis, slot) = state.slot;
        let inputs = state.inputs();
        let Some(input) = inputs.get(axis).copied() else { return };
        let (from, to) = state.range(input, &case);
        let way = if up { 1.0 } else { -1.0 };
        // At a tenth of a millimetre, as steps of inputs.
        let moved = |v: f64| ((v + way * step_of(input)) * 1.0e4).round() / 1.0e4;
        let changed = match slot {
            Slot::Input => {
                let taken = inputs.get(1 - axis).copied();
                let mut at = place(input);
                loop {
                    at = (at + if up { 1 } else { Input::VARIED.len() - 1 }) % Input::VARIED.len();
                    if Some(Input::VARIED[at]) != taken {
                        break;
                    }
                }
                match axis {
                    0 => state.first = Input::VARIED[at],
                    _ => state.second = Some(Input::VARIED[at]),
                }
                return;
            }
            Slot::Steps => {
                let steps = state.steps[axis].saturating_add_signed(if up { 1 } else { -1 });
                state.steps[axis] = steps.clamp(2, MOST);
                return;
            }
            Slot::From => (moved(from), to),
            Slot::To => (from, moved(to)),
        };
        let [a, b] = [changed.0, changed.1].map(|v| input.problem(v));
        match a.or(b) {
            Some(problem) => self.complain(problem.to_string()),
            None => self.studies.sweep.ranges[place(input)] = Some(changed),
        }
    }

    /// Begins to type into the chosen slot.
    pub(super) fn type_slot(&mut self, first: Option<char>) -> Vec<Command> {
        let (axis, slot) = self.studies.sweep.slot;
        let unit = self.units();
        let Some(view) = &self.studies.sweep.view else { return Vec::new() };
        let Some(range) = view.axes.get(axis).copied() else { return Vec::new() };
        let entry = |value: f64| match range.input.is_force() {
            true => shortest(to_kn(value)),
            false => crate::units::length_entry(value, unit),
        };
        let text = match (first, slot) {
            (_, Slot::Input) => {
                self.inform("Left and Right choose the input; Down goes to its range");
                return Vec::new();
            }
            (Some(c), _) => c.to_string(),
            (None, Slot::From) => entry(range.from),
            (None, Slot::To) => entry(range.to),
            (None, Slot::Steps) => range.steps.to_string(),
        };
        self.mode = Mode::Entry(LineEntry::new(EditTarget::Study(Typed::Range(axis, slot)), text));
        Vec::new()
    }

    /// Takes a typed end of a range or a number of values.
    ///
    /// # Errors
    /// Why it is refused.
    pub(super) fn take_slot(&mut self, axis: usize, slot: Slot, text: &str) -> Result<(), String> {
        let unit = self.units();
        let case = self.case(self.selected).ok_or("the mesh of this layout is not known")?;
        let state = &mut self.studies.sweep;
        let input = *state.inputs().get(axis).ok_or("there is no second input")?;
        if slot == Slot::Steps {
            let steps = text.trim().parse::<usize>().ok().filter(|n| (2..=MOST).contains(n));
            state.steps[axis.min(1)] = steps.ok_or(format!("2 to {MOST} values"))?;
            return Ok(());
        }
        let value = read(input, text, unit)?;
        if let Some(problem) = input.problem(value) {
            return Err(problem.to_string());
        }
        let (from, to) = state.range(input, &case);
        let changed = if slot == Slot::From { (value, to) } else { (from, value) };
        if changed.0 == changed.1 {
            return Err("the range is empty: it ends where it begins".into());
        }
        state.ranges[place(input)] = Some(changed);
        Ok(())
    }

    /// Takes the marked point's values into the layout.
    fn adopt_point(&mut self) {
        let Some(view) = &self.studies.sweep.view else { return };
        let Some(grid) = &view.grid else { return };
        let case = grid.case(&view.case, view.marked);
        let words: Vec<&str> = view.axes.iter().map(|axis| axis.input.symbol()).collect();
        if view.axes.iter().any(|axis| axis.input.is_laboratory()) {
            return self.complain("the laboratory values are the mesh's, not the layout's");
        }
        self.take_into_layout(case, &words.join(", "));
    }
}

/// Reads a typed value of an input, SI.
fn read(input: Input, text: &str, unit: LengthUnit) -> Result<f64, String> {
    let quantity = if input.is_force() { Quantity::Force } else { Quantity::Length };
    parse(text, quantity, unit).map_err(|e| e.to_string())
}

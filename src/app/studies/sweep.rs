//! One input over a range, or two over a map, of the selected layout: forecast at once, checks one
//! after the other where they were asked for.

use super::super::entry::Slot;
use super::super::keymap::StudyPage;
use super::super::work::campaign::Coverage;
use super::given::Given;
use super::neighbour;
use crate::case::entry::on_grain;
use crate::case::{Case, CaseValue, Input, StepSize};
use crate::fingerprint::Fingerprinter;
use crate::problem::{self, Problem};
use crate::study::checks::figures::Figures;
use crate::study::checks::{CheckAnswer, NoCheck};
use crate::study::sensitivity::Effect;
use crate::study::sweep::{SweepAxis, SweepGrid, dem, sweep};
use crate::units::{Units, parse_typed};
use std::collections::HashMap;

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
    pub grid: Option<SweepGrid>,
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
    /// Ranges that were changed.
    ranges: HashMap<Input, (f64, f64)>,
    steps: [usize; 2],
    /// The slot that the arrows change: of which axis, and which.
    slot: (usize, Slot),
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
            ranges: HashMap::new(),
            steps: [FIRST, SECOND],
            slot: (0, Slot::Input),
            shown: None,
            marked: FIRST / 2,
            checks_shown: false,
            view: None,
        }
    }
}

/// The range of an input where nobody says otherwise: the published one, the quarter of the cell that
/// repeats, or 30 % around the mesh's own.
fn usual_range(input: Input, case: &Case) -> (f64, f64) {
    match input.row().published {
        Some(range) => (range.min, range.max),
        None if input == Input::OffsetY => (0.0, case.layout.sides()[1] / 2.0),
        None if input.is_offset() => (0.0, case.layout.spacing / 2.0),
        None if input == Input::SpacingUp => usual_range(Input::Spacing, case),
        None => (0.7 * input.value(case), 1.3 * input.value(case)),
    }
}

impl SweepState {
    fn inputs(&self) -> Vec<Input> {
        std::iter::once(self.first).chain(self.second).collect()
    }

    fn range(&self, input: Input, case: &Case) -> (f64, f64) {
        self.ranges.get(&input).copied().unwrap_or_else(|| usual_range(input, case))
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
            let range = self.ranges.get(&input);
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
            (None, None) => Err(problem::summary(&view.problems)),
        }
    }
}

impl SweepState {
    /// What the page shows.
    pub(in crate::app) fn view(&self) -> Option<&SweepView> {
        self.view.as_ref()
    }

    /// The slot that the arrows change: of the first input (0) or the second (1), and which.
    pub(in crate::app) fn slot(&self) -> (usize, Slot) {
        self.slot
    }

    /// Makes what the page shows anew.
    pub(super) fn follow(&mut self, given: &Given) {
        self.view = given.case().map(|case| self.made(given, case));
        if let Some(view) = &self.view {
            self.marked = view.marked;
        }
    }

    fn made(&self, given: &Given, case: Case) -> SweepView {
        let axes = self.axes(&case);
        // There always is a first one.
        let made = match axes[..] {
            [first] => SweepGrid::new(first, None),
            [first, second, ..] => SweepGrid::new(first, Some(second)),
            [] => Err(Vec::new()),
        };
        let asked = case.asked().force.is_some();
        let shown = self.shown.filter(|e| Effect::all(asked).contains(e));
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
            checks_shown: self.checks_shown,
            case,
        };
        let grid = match made {
            Ok(grid) => grid,
            Err(problems) => return SweepView { problems, ..view },
        };
        match dem::cases(&view.case, &grid) {
            Ok(cases) => {
                view.answers = given.answers(&cases);
                let purpose = given.purpose(StudyPage::Sweep, self.question());
                view.coverage = given.coverage(purpose, &cases, &view.answers);
            }
            Err(why) => view.no_dem = Some(why),
        }
        view.points = sweep(&view.case, grid.clone()).points;
        view.figures = (view.answers.iter().zip(&view.points).enumerate())
            .map(|(index, (answer, point))| {
                let asked = grid.case(&view.case, index).asked();
                let forecast = point.as_ref().ok().map(crate::case::CasePoint::values);
                answer.as_ref().ok().map(|v| Figures::of(v, forecast, &asked))
            })
            .collect();
        view.marked = self.marked.min(grid.len().saturating_sub(1));
        if grid.second.is_none()
            && let Ok(fine) = SweepGrid::new(SweepAxis { steps: LINE, ..grid.first }, None)
        {
            let columns = fine.columns.clone();
            view.line = columns.into_iter().zip(sweep(&view.case, fine).points).collect();
        }
        view.grid = Some(grid);
        view
    }

    /// Goes to another slot.
    pub(super) fn step(&mut self, lines: isize) {
        let (axis, slot) = self.slot;
        let at = axis * SLOTS.len() + slot as usize;
        let count = SLOTS.len() * self.inputs().len();
        let to = at.saturating_add_signed(lines).min(count - 1);
        self.slot = (to / SLOTS.len(), SLOTS[to % SLOTS.len()]);
    }

    /// Shows the next value. `asked` says whether a design force is set.
    pub(super) fn show_next(&mut self, asked: bool) {
        let now = self.view.as_ref().map_or(Effect::Force, |view| view.shown);
        self.shown = Some(neighbour(now, true, asked));
    }

    /// Marks a point further on or back.
    pub(super) fn mark(&mut self, way: isize) {
        self.marked = self.marked.saturating_add_signed(way);
    }

    /// Shows the checks of a map instead of its forecast, or the other way round.
    pub(super) fn toggle_layer(&mut self) {
        self.checks_shown = !self.checks_shown;
    }

    /// Takes a second input, or only one again; what to say.
    pub(super) fn toggle_second(&mut self) -> String {
        self.second = match self.second {
            Some(_) => None,
            None if self.first == Input::Spacing => Some(Input::Punch),
            None => Some(Input::Spacing),
        };
        self.marked = 0;
        self.slot = (usize::from(self.second.is_some()), Slot::Input);
        match self.second {
            Some(input) => {
                format!("against {}: arrows choose another; m takes it away", input.symbol())
            }
            None => "one input".to_string(),
        }
    }

    /// Changes the chosen slot by an arrow.
    ///
    /// # Errors
    /// Why the value is refused.
    pub(super) fn change_slot(&mut self, case: &Case, up: bool) -> Result<(), String> {
        let (axis, slot) = self.slot;
        let inputs = self.inputs();
        let Some(input) = inputs.get(axis).copied() else { return Ok(()) };
        let (from, to) = self.range(input, case);
        let way = if up { 1.0 } else { -1.0 };
        let moved = |v: f64| on_grain(v + way * input.step(StepSize::Fine));
        let changed = match slot {
            Slot::Input => {
                let next = next_input(case, input, up, inputs.get(1 - axis).copied());
                match axis {
                    0 => self.first = next,
                    _ => self.second = Some(next),
                }
                return Ok(());
            }
            Slot::Steps => {
                let steps = self.steps[axis].saturating_add_signed(if up { 1 } else { -1 });
                self.steps[axis] = steps.clamp(2, MOST);
                return Ok(());
            }
            Slot::From => (moved(from), to),
            Slot::To => (from, moved(to)),
        };
        if let Some(problem) = input.problem(changed.0).or(input.problem(changed.1)) {
            return Err(problem.to_string());
        }
        self.ranges.insert(input, changed);
        Ok(())
    }

    /// The text of the chosen slot's value.
    pub(super) fn slot_text(&self, unit: Units) -> Option<String> {
        let (axis, slot) = self.slot;
        let range = self.view.as_ref()?.axes.get(axis)?;
        let entry = |value: f64| range.input.entry_text(value, unit);
        match slot {
            Slot::Input => None,
            Slot::From => Some(entry(range.from)),
            Slot::To => Some(entry(range.to)),
            Slot::Steps => Some(range.steps.to_string()),
        }
    }

    /// Takes a typed end of a range or a number of values.
    ///
    /// # Errors
    /// Why it is refused.
    pub(super) fn take_slot(
        &mut self,
        case: &Case,
        axis: usize,
        slot: Slot,
        text: &str,
        unit: Units,
    ) -> Result<(), String> {
        let input = *self.inputs().get(axis).ok_or("there is no second input")?;
        if slot == Slot::Steps {
            let steps = text.trim().parse::<usize>().ok().filter(|n| (2..=MOST).contains(n));
            self.steps[axis.min(1)] = steps.ok_or(format!("2 to {MOST} values"))?;
            return Ok(());
        }
        let value = read(input, text, unit)?;
        if let Some(problem) = input.problem(value) {
            return Err(problem.to_string());
        }
        let (from, to) = self.range(input, case);
        let changed = if slot == Slot::From { (value, to) } else { (from, value) };
        if changed.0 == changed.1 {
            return Err("the range is empty: it ends where it begins".into());
        }
        self.ranges.insert(input, changed);
        Ok(())
    }

    /// The layout at the marked point, and the symbols of what varies; nothing without points.
    pub(super) fn point(&self) -> Option<Result<(Case, String), &'static str>> {
        let view = self.view.as_ref()?;
        let grid = view.grid.as_ref()?;
        if view.axes.iter().any(|axis| axis.input.is_laboratory()) {
            return Some(Err("the laboratory values are the mesh's, not the layout's"));
        }
        let words: Vec<&str> = view.axes.iter().map(|axis| axis.input.symbol()).collect();
        Some(Ok((grid.case(&view.case, view.marked), words.join(", "))))
    }
}

/// The input after or before one of those that a layout has, round and round; `taken` is passed over.
fn next_input(case: &Case, input: Input, up: bool, taken: Option<Input>) -> Input {
    let mut ring: Vec<Input> = Input::varied(&case.layout).collect();
    if !up {
        ring.reverse();
    }
    let behind = ring.iter().skip_while(|other| **other != input).skip(1);
    let mut round = behind.chain(&ring).filter(|other| Some(**other) != taken);
    round.next().copied().unwrap_or(input)
}

/// Reads a typed value of an input, SI.
pub(super) fn read(input: Input, text: &str, unit: Units) -> Result<f64, String> {
    parse_typed(text, input.row().quantity, unit).map_err(|e| e.to_string())
}

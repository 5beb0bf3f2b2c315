//! Design: the plate side, spacing or punch diameter that just meets what is asked, by the forecast,
//! within the published range of that input.
//!
//! F_a and delta_a need not be monotone in any of them: A.1 jumps at D = d, an eccentric punch comes
//! nearer to a plate as the spacing shrinks, and a punch on a plate has no value. So the whole range
//! is scanned, every change from met to not met is narrowed down to two neighbouring floating point
//! numbers, and all of them are reported, with the side on which the requirement is met.

use super::verdict::{Aspect, Basis, Checked, Simulated, verdict};
use crate::case::{Case, CasePoint, CaseValue, Input, NoValue};
use crate::forecast::design::Question;
use crate::forecast::field::BRANCH_CROSSING;
use crate::forecast::warning::PublishedRange;

/// Equal parts into which a range is cut before anything is narrowed down: at most 2.2 mm each.
const PARTS: usize = 2000;
/// Relative change of F_a or delta_a between neighbouring numbers above which it is a jump.
const JUMP: f64 = 1e-9;

/// What has to be met.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Requirement {
    /// The design force: utilisation at most 1, both partial factors included.
    Force,
    /// The allowable deflection. With a design force: the deflection at the design force, without its
    /// factor, is at most the allowable one, and is reached before failure. Without: delta_a is.
    Deflection,
    /// Both at once.
    Both,
}

impl Requirement {
    /// The requirements that a case's question sets and its mesh can answer: without the laboratory's
    /// deflection there is none of the panel.
    pub(crate) fn of(case: &Case) -> Vec<Requirement> {
        let question = case.asked();
        let known = case.mesh.laboratory.deflection.is_some();
        Requirement::asked(&Question {
            deflection: question.deflection.filter(|_| known),
            ..question
        })
    }

    /// The requirements that a question sets.
    pub fn asked(question: &Question) -> Vec<Requirement> {
        match (question.force, question.deflection) {
            (None, None) => Vec::new(),
            (Some(_), None) => vec![Requirement::Force],
            (None, Some(_)) => vec![Requirement::Deflection],
            (Some(_), Some(_)) => {
                vec![Requirement::Force, Requirement::Deflection, Requirement::Both]
            }
        }
    }

    /// The word in output: `force`, `deflection` or `both`.
    pub fn word(self) -> &'static str {
        match self {
            Requirement::Force => "force",
            Requirement::Deflection => "deflection",
            Requirement::Both => "both",
        }
    }

    /// How far a panel is from the limit, as a part of it: 0 just meets it, below 0 does not. Nothing
    /// where the question does not set the requirement.
    ///
    /// 1 over the use of [`verdict`], less 1: force by its strength on a basis, deflection by that under
    /// the service load. Without a force the deflection at failure, delta_a, is asked for.
    pub fn margin(self, case: &Case, point: &CasePoint, basis: Basis) -> Option<f64> {
        let checks = || verdict(case, point, Simulated::Missing, basis).checks;
        let margin = |c: Checked| c.usage[basis as usize].map(|usage| 1.0 / usage - 1.0);
        match self {
            Requirement::Force => margin(checks()[Aspect::Strength as usize]),
            Requirement::Deflection if case.asked().force.is_none() => {
                Some(case.question.deflection? / point.values().deflection? - 1.0)
            }
            Requirement::Deflection => {
                let checked = checks()[Aspect::Deflection as usize];
                // A load of F_a and more fails, whatever is allowed.
                let most = if checked.state.fails() { -f64::MIN_POSITIVE } else { f64::INFINITY };
                margin(checked).map(|margin| margin.min(most))
            }
            Requirement::Both => {
                let force = Requirement::Force.margin(case, point, basis)?;
                Some(force.min(Requirement::Deflection.margin(case, point, basis)?))
            }
        }
    }
}

/// A value of the input with what it gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Value of the input, m.
    pub(crate) value: f64,
    /// What the case gives there.
    pub(crate) outcome: CaseValue,
    /// Margin of the requirement, see [`Requirement::margin`]; nothing without a value.
    pub(crate) margin: Option<f64>,
}

impl Place {
    /// Whether the requirement is met there.
    pub(crate) fn met(&self) -> bool {
        self.margin.is_some_and(|m| m >= 0.0)
    }
}

/// How the requirement comes to be met or not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RequirementKind {
    /// The value just meets it.
    Exact,
    /// The forecast jumps there (another branch of A.1-A.2): no value just meets it.
    Jump,
    /// Beyond it there is no value: the punch is on a plate, or the sizes make no sense.
    Edge,
}

impl RequirementKind {
    /// The word in output: `exact`, `jump` or `edge`.
    pub(crate) fn word(self) -> &'static str {
        match self {
            RequirementKind::Exact => "exact",
            RequirementKind::Jump => "jump",
            RequirementKind::Edge => "edge",
        }
    }
}

/// Where the requirement changes from met to not met.
#[derive(Debug, Clone, PartialEq)]
pub struct Crossing {
    /// The last value that meets it, m: to the last bit, so that it is never beyond.
    pub value: f64,
    /// What the case gives there.
    pub point: CasePoint,
    /// What the case gives at the neighbouring number that does not meet it.
    pub beyond: CaseValue,
    /// Whether it is met above the value; otherwise below.
    pub met_above: bool,
    /// How it comes about.
    pub kind: RequirementKind,
    /// The nearest whole millimetre on the safe side, m, where that meets it too.
    pub rounded: Option<f64>,
    /// Whether it may be advised. Anchors farther apart than now make the forecast's panel stronger, but no
    /// engineer means that as a cure: more rock hangs on each.
    pub advised: bool,
}

/// A part of the range in which the requirement is met throughout, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolveSpan {
    /// Smallest value.
    pub from: f64,
    /// Largest value.
    pub to: f64,
}

/// The answer for one input and one requirement.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// The input that is solved for: d, L or D.
    pub input: Input,
    /// What has to be met.
    pub requirement: Requirement,
    /// The range that was searched, the published one.
    pub range: PublishedRange,
    /// Where it is met, rising; empty where it is not in the whole range.
    pub spans: Vec<SolveSpan>,
    /// The ends of the spans inside the range, rising.
    pub crossings: Vec<Crossing>,
    /// The two ends of the range.
    pub ends: [Place; 2],
    /// The value of the largest margin among those scanned; nothing where no value gives a forecast.
    pub best: Option<Place>,
}

impl Solution {
    /// Whether every value of the range meets it.
    pub(crate) fn always(&self) -> bool {
        self.crossings.is_empty() && !self.spans.is_empty()
    }

    /// Whether no value of the range meets it.
    pub fn never(&self) -> bool {
        self.spans.is_empty()
    }
}

/// Solves for one input, capacities on a basis. Nothing where the input has no published range, or the
/// case's question does not set the requirement.
pub fn solve(
    case: &Case,
    input: Input,
    requirement: Requirement,
    basis: Basis,
) -> Option<Solution> {
    let range = input.row().published?;
    if !Requirement::of(case).contains(&requirement) {
        return None;
    }
    let search = Search { case, input, requirement, basis };
    let places = search.scan(range);
    let mut crossings = Vec::new();
    for pair in places.windows(2) {
        if pair[0].met() != pair[1].met() {
            crossings.extend(search.narrow(pair[0].clone(), pair[1].clone()));
        }
    }
    let (first, last) = (places.first()?.clone(), places.last()?.clone());
    let margin = |p: &&Place| p.margin.is_some();
    let best = places
        .iter()
        .filter(margin)
        .max_by(|a, b| a.margin.unwrap_or(f64::MIN).total_cmp(&b.margin.unwrap_or(f64::MIN)));
    let mut solution = Solution {
        input,
        requirement,
        range,
        spans: spans(&first, &last, &crossings),
        best: best.cloned(),
        crossings,
        ends: [first, last],
    };
    for crossing in &mut solution.crossings {
        crossing.rounded = search.rounded(crossing, &solution.spans);
    }
    Some(solution)
}

fn spans(first: &Place, last: &Place, crossings: &[Crossing]) -> Vec<SolveSpan> {
    let mut spans = Vec::new();
    let mut open = first.met().then_some(first.value);
    for crossing in crossings {
        if crossing.met_above {
            open = Some(crossing.value);
        } else if let Some(from) = open.take() {
            spans.push(SolveSpan { from, to: crossing.value });
        }
    }
    spans.extend(open.map(|from| SolveSpan { from, to: last.value }));
    spans
}

struct Search<'a> {
    case: &'a Case,
    input: Input,
    requirement: Requirement,
    basis: Basis,
}

impl Search<'_> {
    fn place(&self, value: f64) -> Place {
        let case = self.case.with(self.input, value);
        let outcome = case.outcome();
        let point = outcome.as_ref().ok();
        let margin = point.and_then(|p| self.requirement.margin(&case, p, self.basis));
        Place { value, outcome, margin }
    }

    /// The range in equal parts, the places where the branch changes with their neighbours, and the
    /// bottom of every dip towards the limit that two parts could hide.
    fn scan(&self, range: PublishedRange) -> Vec<Place> {
        let mut values: Vec<f64> = (1..PARTS)
            .map(|i| range.min + (range.max - range.min) * (i as f64 / PARTS as f64))
            .collect();
        values.extend([range.min, range.max]);
        let changes = match self.input {
            Input::Plate => vec![self.case.layout.punch],
            Input::Punch => vec![self.case.layout.plate, BRANCH_CROSSING],
            _ => Vec::new(),
        };
        for at in changes {
            values.extend([at.next_down(), at, at.next_up()]);
        }
        values.retain(|v| (range.min..=range.max).contains(v));
        values.sort_by(f64::total_cmp);
        values.dedup();
        let mut places: Vec<Place> = values.into_iter().map(|v| self.place(v)).collect();
        let dips: Vec<Place> = places.windows(3).filter_map(|three| self.dip(three)).collect();
        places.extend(dips);
        places.sort_by(|a, b| a.value.total_cmp(&b.value));
        places
    }

    /// Of three neighbours with the middle one nearest to the limit, all on one side of it: the
    /// nearest place between them, if it is on the other side.
    fn dip(&self, three: &[Place]) -> Option<Place> {
        let [a, b, c] = three else { return None };
        let (left, middle, right) = (a.margin?, b.margin?, c.margin?);
        let met = b.met();
        let nearest = middle.abs() <= left.abs() && middle.abs() <= right.abs();
        if !nearest || a.met() != met || c.met() != met {
            return None;
        }
        // Towards the limit is down where it is met and up where it is not.
        let height = |place: &Place| place.margin.map_or(f64::MAX, |m| if met { m } else { -m });
        let (mut low, mut high) = (a.value, c.value);
        // A third less each time: 40 times is 1e-7 of two parts, where a smooth dip is flat.
        for _ in 0..40 {
            let third = (high - low) / 3.0;
            let (one, two) = (self.place(low + third), self.place(high - third));
            if one.met() != met {
                return Some(one);
            }
            if height(&one) <= height(&two) { high = two.value } else { low = one.value }
        }
        None
    }

    /// The change between two places of which one meets the requirement, by bisection down to two
    /// neighbouring floating point numbers.
    fn narrow(&self, mut low: Place, mut high: Place) -> Option<Crossing> {
        let met_above = high.met();
        loop {
            let middle = low.value + (high.value - low.value) / 2.0;
            if middle <= low.value || middle >= high.value {
                break;
            }
            let place = self.place(middle);
            if place.met() == met_above { high = place } else { low = place }
        }
        let (inside, outside) = if met_above { (high, low) } else { (low, high) };
        // What meets the requirement has a value.
        let point = inside.outcome.ok()?;
        Some(Crossing {
            value: inside.value,
            kind: kind(&point, &outside.outcome),
            point,
            beyond: outside.outcome,
            met_above,
            rounded: None,
            advised: !(self.input == Input::Spacing
                && met_above
                && inside.value > self.input.value(self.case)),
        })
    }

    fn rounded(&self, crossing: &Crossing, spans: &[SolveSpan]) -> Option<f64> {
        let span = spans.iter().find(|s| (s.from..=s.to).contains(&crossing.value))?;
        let whole = (crossing.value * 1000.0).round();
        let millimetres = match crossing.met_above {
            true if whole / 1000.0 < crossing.value => whole + 1.0,
            false if whole / 1000.0 > crossing.value => whole - 1.0,
            _ => whole,
        };
        let value = millimetres / 1000.0;
        ((span.from..=span.to).contains(&value) && self.place(value).met()).then_some(value)
    }
}

fn kind(inside: &CasePoint, outside: &CaseValue) -> RequirementKind {
    match outside {
        Err(NoValue::Outside(_) | NoValue::Senseless(_)) => RequirementKind::Edge,
        Ok(outside) => {
            let (a, b) = (inside.values(), outside.values());
            let jump = |a: f64, b: f64| (a - b).abs() > JUMP * a.abs();
            let deflections = a.deflection.zip(b.deflection);
            if jump(a.force, b.force) || deflections.is_some_and(|(a, b)| jump(a, b)) {
                RequirementKind::Jump
            } else {
                RequirementKind::Exact
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::example as case;
    use crate::forecast::NoField;
    use crate::layout::{Layout, REFERENCE};

    fn asked(layout: Layout, force: Option<f64>, deflection: Option<f64>) -> Case {
        let mut case = case(layout, force);
        case.question.deflection = deflection;
        case
    }

    fn solved(case: &Case, input: Input, requirement: Requirement) -> Solution {
        solve(case, input, requirement, Basis::Mean).unwrap()
    }

    #[test]
    fn the_spacing_for_a_force_worked_by_hand() {
        // 27.063 (0.16 L/3 + 0.84) = 25: L = (25/27.063 - 0.84) 3/0.16 = 1.57068...
        let s = solved(&asked(REFERENCE, Some(25_000.0), None), Input::Spacing, Requirement::Force);
        let c = &s.crossings[0];
        assert_eq!((s.crossings.len(), c.met_above, c.kind), (1, true, RequirementKind::Exact));
        assert!((c.value - (25.0 / 27.063 - 0.84) * 3.0 / 0.16).abs() < 1e-9);
        assert!((c.point.utilisation().unwrap() - 1.0).abs() < 1e-12);
        assert!(c.point.utilisation().unwrap() <= 1.0 && c.rounded == Some(1.571));
        assert_eq!(s.spans, [SolveSpan { from: c.value, to: 4.5 }]);
        // Partial factors: 1.2 x 1.25 x 16.667 kN is the same load.
        let mut factored = asked(REFERENCE, Some(25_000.0 / 1.5), None);
        factored.question.gamma_load = 1.2;
        factored.question.gamma_resistance = 1.25;
        let other = solved(&factored, Input::Spacing, Requirement::Force);
        assert!((other.crossings[0].value - c.value).abs() < 1e-9);
    }

    #[test]
    fn the_spacing_for_a_deflection_worked_by_hand() {
        // Without a force: delta_a = 0.63504 L/3 = 0.6.
        let s = solved(&asked(REFERENCE, None, Some(0.6)), Input::Spacing, Requirement::Deflection);
        assert!((s.crossings[0].value - 0.6 / 0.635_04 * 3.0).abs() < 1e-9);
        assert!(!s.crossings[0].met_above && s.crossings[0].rounded == Some(2.834));
        // With the force that the curve reaches at half the deflection of L = 3 (0.10425 F_a by Eq. 3).
        let case = asked(REFERENCE, Some(0.104_25 * 27_063.0), Some(0.317_52));
        let s = solved(&case, Input::Spacing, Requirement::Deflection);
        assert!((s.crossings[0].value - 3.0).abs() < 1e-9, "{:?}", s.crossings);
        assert_eq!(Requirement::asked(&case.asked()).len(), 3);
    }

    #[test]
    fn characteristic_values_need_more_and_factors_leave_the_deflection_alone() {
        // 25 kN on 0.88485 of 29.1 x 1 x (1.5 d + 0.45) kN: d = 0.3472 m; on the mean 0.2727 m.
        let at = asked(REFERENCE, Some(25_000.0), Some(0.7));
        for (basis, part) in [(Basis::Mean, 1.0), (Basis::Characteristic, 0.884_85)] {
            let s = solve(&at, Input::Plate, Requirement::Force, basis).unwrap();
            let by_hand = (25.0 / (29.1 * part) - 0.45) / 1.5;
            assert!((s.crossings[0].value - by_hand).abs() < 1e-9, "{basis:?}");
        }
        let mut factored = at.clone();
        factored.question.gamma_load = 1.3;
        let of = |case| solved(case, Input::Spacing, Requirement::Deflection).crossings;
        assert!((of(&factored)[0].value - of(&at)[0].value).abs() < 1e-12);
    }

    #[test]
    fn a_wider_spacing_is_not_advised() {
        let at = asked(REFERENCE, Some(28_000.0), None);
        let s = solved(&at, Input::Spacing, Requirement::Force);
        assert!(s.crossings[0].met_above && !s.crossings[0].advised);
        let s = solved(&at, Input::Plate, Requirement::Force);
        assert!(s.crossings[0].met_above && s.crossings[0].advised);
    }

    #[test]
    fn a_jump_is_a_jump_and_all_crossings_are_there() {
        // D = 0.2, d from 0.16: below d = 0.2 the large punch, 29.1 x 0.952 x (1.5 d + 0.45) kN, 19.1
        // to 20.8; from d = 0.2 on the small one, 29.1 x 0.494 x (1.5 d + 0.45), 10.8 to 16.8.
        let at = Layout { punch: 0.2, ..REFERENCE };
        let s = solved(&asked(at, Some(15_000.0), None), Input::Plate, Requirement::Force);
        let kinds: Vec<RequirementKind> = s.crossings.iter().map(|c| c.kind).collect();
        assert_eq!(
            (kinds.as_slice(), s.spans.len()),
            (&[RequirementKind::Jump, RequirementKind::Exact][..], 2)
        );
        assert_eq!(s.crossings[0].value.next_up(), 0.2);
        let by_hand = (15.0 / (29.1 * 0.494) - 0.45) / 1.5;
        assert!((s.crossings[1].value - by_hand).abs() < 1e-9);
        assert_eq!(s.crossings[0].rounded, Some(0.199));
    }

    #[test]
    fn what_cannot_be_met_says_what_the_range_gives() {
        // 29.1 kN would need L = 29.1/27.063...: at 4.5 m F_a is 27.063 x 1.08 = 29.228 kN.
        let s = solved(&asked(REFERENCE, Some(30_000.0), None), Input::Spacing, Requirement::Force);
        assert!(s.never() && s.crossings.is_empty());
        let best = s.best.as_ref().unwrap();
        assert_eq!((best.value, s.ends[1].value), (4.5, 4.5));
        assert!((best.margin.unwrap() - (27.063 * 1.08 / 30.0 - 1.0)).abs() < 1e-12);
        let s = solved(&asked(REFERENCE, Some(1_000.0), None), Input::Spacing, Requirement::Force);
        assert!(s.always());
        assert_eq!(s.spans, [SolveSpan { from: 1.25, to: 4.5 }]);
        let none =
            |case: &Case, input| solve(case, input, Requirement::Force, Basis::Mean).is_none();
        assert!(none(&asked(REFERENCE, None, None), Input::Spacing));
        assert!(none(&case(REFERENCE, Some(1.0)), Input::OffsetX));
    }

    #[test]
    fn a_plate_under_the_punch_is_an_edge() {
        // The centre is 0.5 m from the plates' edge at ex = 1.34 - 0.5, ey = 1.5: D up to 1.0 m.
        let at = Layout { ex: 0.84, ey: 1.5, punch: 0.5, ..REFERENCE };
        let s = solved(&asked(at, Some(5_000.0), None), Input::Punch, Requirement::Force);
        let last = s.crossings.last().unwrap();
        assert_eq!((last.kind, last.met_above), (RequirementKind::Edge, false));
        assert!(
            (last.value - 1.0).abs() < 1e-9
                && last.beyond == Err(NoValue::Outside(NoField::PunchOnPlate))
        );
    }
}

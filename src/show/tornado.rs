//! A tornado: for each input how far a value moves when it is lowered and raised, as texts and as bars
//! from a common middle.

use super::effect::EffectScale;
use super::glyphs::Glyphs;
use crate::case::input::LX;
use crate::case::{Input, input_unit, input_value};
use crate::study::checks::NoCheck;
use crate::study::sensitivity::dem::{CheckedSensitivity, CheckedStep};
use crate::study::sensitivity::{Bar, Effect, Sensitivity, Step};
use crate::units::Units;

/// One input of a tornado.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TornadoRow {
    pub(crate) input: Input,
    /// Its symbol: `Lx` for L where the grid has two spacings.
    pub(crate) symbol: &'static str,
    /// Between which values it is moved, with their unit.
    pub(crate) range: String,
    pub(crate) forecast: Moves,
    pub(crate) check: Option<Moves>,
}

/// How a value moves.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Moves {
    /// With the input lowered, then raised: the change, with a mark or a blank behind it, or a word for
    /// why there is none.
    pub(crate) texts: [String; 2],
    /// The changes, SI.
    pub(crate) sizes: [Option<f64>; 2],
}

/// The largest change of a value, SI, by the forecast or by checks.
pub(crate) fn most(s: &Sensitivity, checked: Option<&CheckedSensitivity>, effect: Effect) -> f64 {
    let forecast = s.bars.iter().map(|bar| bar.largest(effect));
    let checks = checked.into_iter().flat_map(|c| &c.bars).map(|bar| bar.largest(effect));
    forecast.chain(checks).fold(0.0, f64::max)
}

/// The rows of one value, by falling effect in the forecast.
pub(crate) fn tornado(
    s: &Sensitivity,
    checked: Option<&CheckedSensitivity>,
    effect: Effect,
    scale: &EffectScale,
    unit: Units,
) -> Vec<TornadoRow> {
    let two = s.bars.iter().any(|bar| bar.input == Input::SpacingUp);
    let row = |bar: &Bar| TornadoRow {
        input: bar.input,
        symbol: if two && bar.input == Input::Spacing { LX } else { bar.input.symbol() },
        range: range(bar, unit),
        forecast: moves([&bar.lowered, &bar.raised].map(|step| by_forecast(step, effect, scale))),
        check: checked
            .and_then(|c| c.bar(bar.input))
            .map(|bar| moves([&bar.lowered, &bar.raised].map(|s| by_check(s, effect, scale)))),
    };
    s.by(effect).into_iter().map(row).collect()
}

fn moves([low, high]: [(String, Option<f64>); 2]) -> Moves {
    Moves { texts: [low.0, high.0], sizes: [low.1, high.1] }
}

fn range(bar: &Bar, unit: Units) -> String {
    let value = |v: f64| input_value(bar.input, v, unit);
    let symbol = input_unit(bar.input, unit);
    format!("{} to {} {symbol}", value(bar.lowered.value), value(bar.raised.value))
}

/// A change by the forecast; `*` where the branch changes.
fn by_forecast(step: &Step, effect: Effect, scale: &EffectScale) -> (String, Option<f64>) {
    let size = step.change.and_then(|change| change.of(effect));
    let text = match (&step.change, &step.outcome) {
        (Some(change), _) => {
            let mark = if change.other_branch { "*" } else { " " };
            size.map_or(String::new(), |size| scale.text(size) + mark)
        }
        (None, Err(why)) => why.short().to_string(),
        (None, Ok(_)) => "- ".to_string(),
    };
    (text, size)
}

/// A change by checks; `~` where it may be chance.
fn by_check(step: &CheckedStep, effect: Effect, scale: &EffectScale) -> (String, Option<f64>) {
    let known = step.change.and_then(|change| change.of(effect));
    let text = match (known, &step.answer) {
        (Some(known), _) => scale.text(known.value) + if known.doubtful() { "~" } else { " " },
        (None, Err(NoCheck::NotMade)) => ". ".to_string(),
        (None, Err(NoCheck::Laboratory)) => "none ".to_string(),
        (None, Err(NoCheck::Impossible(_))) => "no ".to_string(),
        (None, Ok(_)) => "- ".to_string(),
    };
    (text, known.map(|known| known.value))
}

/// The signs of bars: lowered, raised, both, and the middle. They read without colour: the lower half
/// of the line for lowered, the upper half for raised, the whole for both.
pub(crate) fn signs(glyphs: Glyphs) -> [char; 4] {
    match glyphs {
        Glyphs::Ascii => ['-', '=', '#', '|'],
        _ => ['▄', '▀', '█', '│'],
    }
}

/// The bars of two changes from the middle to both sides, `half` columns for `most`.
pub(crate) fn bars(changes: [Option<f64>; 2], most: f64, half: usize, glyphs: Glyphs) -> String {
    let half = half as isize;
    let [low, high] = changes.map(|change| {
        // At most `half` by the choice of `most`.
        if most > 0.0 { (change.unwrap_or(0.0) / most * half as f64).round() as isize } else { 0 }
    });
    let covers = |end: isize, at: isize| {
        if end < 0 { (end..0).contains(&at) } else { (1..=end).contains(&at) }
    };
    let [lowered, raised, both, middle] = signs(glyphs);
    (-half..=half)
        .map(|at| match (at, covers(low, at), covers(high, at)) {
            (0, ..) => middle,
            (_, true, true) => both,
            (_, true, false) => lowered,
            (_, false, true) => raised,
            _ => ' ',
        })
        .collect()
}

/// What the marks and words in the rows of a forecast mean, those that stand there.
pub(crate) fn notes(s: &Sensitivity) -> Vec<(&'static str, &'static str)> {
    let steps = || s.bars.iter().flat_map(|bar| [&bar.lowered, &bar.raised]);
    let mut notes = Vec::new();
    if steps().any(|step| step.change.is_some_and(|change| change.other_branch)) {
        notes.push(("*", "the step goes over the branch change at D = d, where A.1 and A.2 jump"));
    }
    for (code, text) in [
        ("punch_on_plate", "the step takes the block onto an anchor plate: outside the method"),
        ("passes_through", "the step makes the block smaller than the opening of the mesh"),
        ("senseless", "the step makes no sense: plate and block must be smaller than the spacing"),
    ] {
        let why = |step: &Step| {
            step.outcome
                .as_ref()
                .err()
                .filter(|e| e.code() == code)
                .map(super::super::case::NoValue::short)
        };
        notes.extend(steps().find_map(why).map(|short| (short, text)));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_run_from_the_middle_and_read_without_colour() {
        let ascii = |low, high| bars([low, high], 1.0, 4, Glyphs::Ascii);
        assert_eq!(ascii(Some(-1.0), Some(0.5)), "----|==  ");
        // Both ways onto the same side.
        assert_eq!(ascii(Some(1.0), Some(0.5)), "    |##--");
        assert_eq!(ascii(None, None), "    |    ");
        assert_eq!(bars([Some(-1.0), Some(1.0)], 1.0, 2, Glyphs::Block), "▄▄│▀▀");
        assert_eq!(bars([Some(1.0), None], 0.0, 1, Glyphs::Ascii), " | ");
    }
}

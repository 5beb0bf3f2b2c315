//! A sensitivity as tornadoes in characters: one for F_a, one for delta_a, and with a design force one
//! for the utilisation.

use super::{Studied, both};
use crate::cli::dem::text as dem;
use crate::cli::page::{BASIS, NO_LAYOUTS, Page, input_unit, input_value, percent};
use crate::forecast::warning::Weight;
use crate::study::case::{CasePoint, Input};
use crate::study::result::Wanted;
use crate::study::sensitivity::{Bar, Effect, Sensitivity, Step, step};
use crate::units::{LengthUnit, force_text, significant, to_kn};

/// Cells of a tornado on each side of its middle.
const HALF: usize = 15;

/// The reports of all layouts, an empty line between them.
pub(crate) fn report(studied: &[Studied], wanted: Option<&Wanted>, unit: LengthUnit) -> String {
    if studied.is_empty() {
        return NO_LAYOUTS.to_string();
    }
    let all: Vec<String> = studied.iter().map(|s| one(s, wanted, unit)).collect();
    all.join("\n")
}

fn one(s: &Studied, wanted: Option<&Wanted>, unit: LengthUnit) -> String {
    let mut page = Page::new(unit);
    page.inputs("sensitivity", s.name.as_deref(), s.case.fingerprint(), &s.case);
    match &s.sensitivity.base {
        Ok(point) => {
            base(&mut page, point);
            let offset = page.length(step(&s.case, Input::OffsetX));
            page.line(
                "steps",
                format!("10 % of d, L, D, F_l*, delta_l*; {offset} (L/20) of ex, ey"),
            );
            page.line("bars", "--- input lowered, === input raised, ### both");
            let checked = s.checked.as_ref().zip(wanted);
            if let Some((checked, wanted)) = checked {
                dem::plan(&mut page, wanted);
                both::base(&mut page, s, checked);
            }
            for effect in [Effect::Force, Effect::Deflection, Effect::Utilisation] {
                if effect != Effect::Utilisation || point.utilisation().is_some() {
                    match checked {
                        Some((checked, _)) => both::tornado(&mut page, s, checked, effect),
                        None => tornado(&mut page, &s.sensitivity, effect),
                    }
                }
            }
            notes(&mut page, &s.sensitivity);
            if let Some((checked, _)) = checked {
                both::notes(&mut page, checked);
            }
        }
        Err(_) => page.line("field", "no value, and so no sensitivity: the punch is on a plate"),
    }
    page.line("basis", BASIS);
    page.text()
}

fn base(page: &mut Page, point: &CasePoint) {
    let v = point.values();
    let mut text = format!("F_a {}, delta_a {}", force_text(v.force), page.length(v.deflection));
    if let Some(utilisation) = point.utilisation() {
        text.push_str(&format!(", use {} %", percent(utilisation)));
    }
    page.line("FIELD", text);
}

/// A change in the unit that is shown, with its sign.
fn number(change: f64, effect: Effect, unit: LengthUnit) -> String {
    let value = match effect {
        Effect::Force => to_kn(change),
        Effect::Deflection => change * unit.per_metre(),
        Effect::Utilisation => change * 100.0,
    };
    if value.abs() < 5e-10 {
        return "0".to_string();
    }
    format!("{}{}", if value < 0.0 { "-" } else { "+" }, significant(value.abs(), 3))
}

fn tornado(page: &mut Page, s: &Sensitivity, effect: Effect) {
    let unit = page.unit;
    let bars = s.by(effect);
    let most = bars.first().map_or(0.0, |b| b.largest(effect));
    let title = match effect {
        Effect::Force => "change of F_a, kN".to_string(),
        Effect::Deflection => format!("change of delta_a, {}", unit.symbol()),
        Effect::Utilisation => "change of use, %".to_string(),
    };
    let (left, right) = (number(-most, effect, unit), number(most, effect, unit));
    page.lines.push(String::new());
    page.lines.push(format!("{title:<30} lowered   raised {left:<HALF$}0{right:>HALF$}"));
    for bar in bars {
        page.lines.push(row(bar, effect, most, unit));
    }
}

fn row(bar: &Bar, effect: Effect, most: f64, unit: LengthUnit) -> String {
    let value = |v: f64| input_value(bar.input, v, unit);
    let symbol = input_unit(bar.input, unit);
    let range = format!("{} to {} {symbol}", value(bar.lowered.value), value(bar.raised.value));
    let text = |step: &Step| match (&step.change, &step.outcome) {
        (Some(change), _) => {
            let mark = if change.other_branch { "*" } else { " " };
            change.of(effect).map_or(String::new(), |c| number(c, effect, unit) + mark)
        }
        (None, Err(why)) => why.short().to_string(),
        (None, Ok(_)) => "-".to_string(),
    };
    let change = |step: &Step| step.change.and_then(|c| c.of(effect));
    let drawn = drawing([change(&bar.lowered), change(&bar.raised)], most, HALF);
    let line = format!(
        "{:<9}{range:<20}{:>9}{:>9} {drawn}",
        bar.input.symbol(),
        text(&bar.lowered),
        text(&bar.raised)
    );
    line.trim_end().to_string()
}

/// The two bars from the middle, `|`, to both sides: `-` lowered, `=` raised, `#` both.
pub(super) fn drawing(changes: [Option<f64>; 2], most: f64, half: usize) -> String {
    let half = half as isize;
    let [low, high] = changes.map(|change| {
        // At most `half` by the choice of `most`.
        if most > 0.0 { (change.unwrap_or(0.0) / most * half as f64).round() as isize } else { 0 }
    });
    let covers = |end: isize, at: isize| {
        if end < 0 { (end..0).contains(&at) } else { (1..=end).contains(&at) }
    };
    (-half..=half)
        .map(|at| match (at, covers(low, at), covers(high, at)) {
            (0, ..) => '|',
            (_, true, true) => '#',
            (_, true, false) => '-',
            (_, false, true) => '=',
            _ => ' ',
        })
        .collect()
}

fn notes(page: &mut Page, s: &Sensitivity) {
    let steps = || s.bars.iter().flat_map(|b| [&b.lowered, &b.raised]);
    page.lines.push(String::new());
    if steps().any(|s| s.change.is_some_and(|c| c.other_branch)) {
        page.line("*", "the step goes over the branch change at D = d, where A.1 and A.2 jump");
    }
    for (code, text) in [
        ("punch_on_plate", "the step takes the punch onto an anchor plate: outside the method"),
        ("senseless", "the step makes no sense: plate and punch must be smaller than the spacing"),
    ] {
        if let Some(why) =
            steps().find_map(|s| s.outcome.as_ref().err().filter(|e| e.code() == code))
        {
            page.line(why.short(), text);
        }
    }
    if let Ok(point) = &s.base {
        for w in point.warnings.iter().filter(|w| w.weight() >= Weight::Caution) {
            page.line(w.weight().word(), w.short());
        }
    }
}

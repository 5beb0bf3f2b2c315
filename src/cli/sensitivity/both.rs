//! Tornadoes of forecast and check side by side, on one scale, so that they can be compared.

use super::Studied;
use super::text::drawing;
use crate::cli::dem::text as dem;
use crate::cli::page::{Page, percent};
use crate::study::case::CaseValue;
use crate::study::checks::CheckAnswer;
use crate::study::checks::figures::Figures;
use crate::study::sensitivity::dem::{CheckedBar, CheckedSensitivity, CheckedStep};
use crate::study::sensitivity::scale::EffectScale;
use crate::study::sensitivity::{Effect, Step};
use crate::units::{force_text, significant, to_kn};

/// Cells of a tornado on each side of its middle.
const HALF: usize = 7;

/// The check of the case itself.
pub(crate) fn base(page: &mut Page, s: &Studied, checked: &CheckedSensitivity) {
    let result = match &checked.base {
        Ok(result) => result,
        Err(why) => return page.line("CHECK", format!("none: {}", why.reason())),
    };
    let forecast = s.sensitivity.base.as_ref().ok().map(|p| p.values());
    let f = Figures::of(result, forecast, &s.case.question);
    let Some(mean) = f.mean else { return page.line("CHECK", "no run broke a wire") };
    let error = f
        .error
        .map_or(String::new(), |e| format!(" (standard error {})", significant(to_kn(e.force), 2)));
    let mut text =
        format!("F {}{error}, delta {}", force_text(mean.force), page.length(mean.deflection));
    if let Some(utilisation) = f.utilisation {
        text.push_str(&format!(", use {} %", percent(utilisation)));
    }
    if let Some(d) = f.difference {
        let parts = [100.0 * d.force, 100.0 * d.deflection];
        text.push_str(&format!("; {:+.1} % and {:+.1} % over the forecast", parts[0], parts[1]));
    }
    page.line("CHECK", text);
}

/// One effect: the inputs by its size in the forecast.
pub(crate) fn tornado(page: &mut Page, s: &Studied, checked: &CheckedSensitivity, effect: Effect) {
    let unit = page.unit;
    let bars = s.sensitivity.by(effect);
    let by_check = checked.bars.iter().map(|bar| bar.largest(effect)).fold(0.0, f64::max);
    let most = bars.first().map_or(0.0, |bar| bar.largest(effect)).max(by_check);
    let title = match effect {
        Effect::Force => "change of F, kN".to_string(),
        Effect::Deflection => format!("change of delta, {}", unit.symbol()),
        Effect::Utilisation => "change of use, %".to_string(),
    };
    let scale = EffectScale::new(effect, unit, most);
    let bars_to = scale.size(most);
    page.lines.push(String::new());
    page.lines.push(format!("{title:<24}bars to {bars_to} each way; ~ within two standard errors"));
    let side = |word: &str| format!("{:>9}{:>9}  {word:<15}", "lowered", "raised");
    page.lines
        .push(format!("{:<9}{} {}", "", side("FORECAST"), side("DEM")).trim_end().to_string());
    for bar in bars {
        let Some(other) = checked.bar(bar.input) else { continue };
        let forecast = |step: &Step| match (step.change.and_then(|c| c.of(effect)), &step.outcome) {
            (Some(change), _) => {
                let jump = step.change.is_some_and(|c| c.other_branch);
                scale.text(change) + if jump { "*" } else { " " }
            }
            (None, outcome) => missing(outcome),
        };
        let sizes = |low: Option<f64>, high: Option<f64>| drawing([low, high], most, HALF);
        let of = |step: &Step| step.change.and_then(|c| c.of(effect));
        let line = format!(
            "{:<9}{:>9}{:>9}  {} {:>9}{:>9}  {}",
            bar.input.symbol(),
            forecast(&bar.lowered),
            forecast(&bar.raised),
            sizes(of(&bar.lowered), of(&bar.raised)),
            found(&other.lowered, &scale),
            found(&other.raised, &scale),
            sizes(value(&other.lowered, effect), value(&other.raised, effect)),
        );
        page.lines.push(line.trim_end().to_string());
    }
    if let Some(error) = largest_error(checked, effect) {
        let text = scale.size(error);
        page.lines.push(format!("{:<9}standard error of the DEM's changes: up to {text}", ""));
    }
}

fn missing(outcome: &CaseValue) -> String {
    outcome.as_ref().err().map_or("- ", |why| why.short()).to_string()
}

fn value(step: &CheckedStep, effect: Effect) -> Option<f64> {
    step.change.and_then(|c| c.of(effect)).map(|known| known.value)
}

/// A change by the check in words.
fn found(step: &CheckedStep, scale: &EffectScale) -> String {
    match step.change.and_then(|c| c.of(scale.effect)) {
        Some(known) => scale.text(known.value) + if known.doubtful() { "~" } else { " " },
        None => "- ".to_string(),
    }
}

fn largest_error(checked: &CheckedSensitivity, effect: Effect) -> Option<f64> {
    let steps = checked.bars.iter().flat_map(|bar| [&bar.lowered, &bar.raised]);
    steps.filter_map(|s| s.change.and_then(|c| c.of(effect))?.error).reduce(f64::max)
}

/// What to know of the checks.
pub(crate) fn notes(page: &mut Page, checked: &CheckedSensitivity) {
    let end = |bar: &CheckedBar, step: &CheckedStep| {
        format!("{} {}", bar.input.symbol(), bar.input.text(step.value))
    };
    let mut all: Vec<(String, &CheckAnswer)> =
        vec![("the layout itself".to_string(), &checked.base)];
    for bar in &checked.bars {
        for step in [&bar.lowered, &bar.raised] {
            all.push((end(bar, step), &step.answer));
        }
    }
    dem::notes(page, all.iter().map(|(name, answer)| (name.clone(), *answer)));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_run_from_the_middle() {
        // Both ways onto the same side, and one way each.
        assert_eq!(drawing([Some(1.0), Some(0.5)], 1.0, HALF), "       |####---");
        assert_eq!(drawing([Some(-1.0), Some(0.5)], 1.0, HALF), "-------|====   ");
        assert_eq!(drawing([None, None], 0.0, HALF), "       |       ");
    }
}

//! Tornadoes of forecast and check side by side, on one scale, so that they can be compared.

use super::Studied;
use crate::cli::dem::text as dem;
use crate::cli::page::Page;
use crate::show::effect::{self, EffectScale};
use crate::show::glyphs::Glyphs;
use crate::show::say;
use crate::show::tornado::{self, Moves};
use crate::study::checks::CheckAnswer;
use crate::study::checks::figures::Figures;
use crate::study::sensitivity::Effect;
use crate::study::sensitivity::dem::{CheckedBar, CheckedSensitivity, CheckedStep};
use crate::units::force_text;

/// Cells of a tornado on each side of its middle.
const HALF: usize = 7;

/// The check of the case itself.
pub(crate) fn base(page: &mut Page, s: &Studied, checked: &CheckedSensitivity) {
    let result = match &checked.base {
        Ok(result) => result,
        Err(why) => return page.line("CHECK", format!("none: {}", why.sentence())),
    };
    let forecast = s.sensitivity.base.as_ref().ok().map(crate::case::CasePoint::values);
    let f = Figures::of(result, forecast, &s.case.asked());
    let Some(mean) = f.mean else { return page.line("CHECK", "no run broke a wire") };
    let error = f.error.map_or(String::new(), |e| {
        format!(" (standard error {})", page.unit.force_number(e.force, 2))
    });
    let mut text = format!(
        "F {}{error}, delta {}",
        force_text(mean.force, page.unit),
        page.length(mean.deflection)
    );
    text.push_str(&say::used(f.utilisation));
    if let Some(d) = f.difference {
        let parts = [Some(d.force), d.deflection];
        let parts = parts.iter().flatten().map(|part| format!("{:+.1} %", 100.0 * part));
        let parts: Vec<String> = parts.collect();
        text.push_str(&format!("; {} over the forecast", parts.join(" and ")));
    }
    page.line("CHECK", text);
}

/// One effect: the inputs by its size in the forecast.
pub(crate) fn tornado(page: &mut Page, s: &Studied, checked: &CheckedSensitivity, effect: Effect) {
    let most = tornado::most(&s.sensitivity, Some(checked), effect);
    let scale = EffectScale::aligned(effect, page.unit, most);
    let (symbol, unit) = (effect::symbol(effect), effect::unit(effect, page.unit));
    let title = format!("change of {symbol}, {unit}");
    let bars_to = scale.size(most);
    page.lines.push(String::new());
    page.lines.push(format!("{title:<24}bars to {bars_to} each way; ~ within two standard errors"));
    let side = |word: &str| format!("{:>9}{:>9}  {word:<15}", "lowered", "raised");
    page.lines
        .push(format!("{:<9}{} {}", "", side("FORECAST"), side("DEM")).trim_end().to_string());
    let side = |moves: &Moves| {
        let [low, high] = &moves.texts;
        format!("{low:>9}{high:>9}  {}", tornado::bars(moves.sizes, most, HALF, Glyphs::Ascii))
    };
    for row in tornado::tornado(&s.sensitivity, Some(checked), effect, &scale, page.unit) {
        let Some(check) = &row.check else { continue };
        let line = format!("{:<9}{} {}", row.symbol, side(&row.forecast), side(check));
        page.lines.push(line.trim_end().to_string());
    }
    if let Some(error) = largest_error(checked, effect) {
        let text = scale.size(error);
        page.lines.push(format!("{:<9}standard error of the DEM's changes: up to {text}", ""));
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

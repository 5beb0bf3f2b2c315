//! A sensitivity as tornadoes in characters: one for F_a, one for delta_a, and with a design force one
//! for the utilisation and one for the deflection at that force.

use super::{Studied, both};
use crate::case::Input;
use crate::cli::dem::text as dem;
use crate::cli::page::{BASIS, Page, pages};
use crate::remark::Weight;
use crate::show::effect::{self, EffectScale};
use crate::show::glyphs::Glyphs;
use crate::show::{say, tornado};
use crate::study::result::Wanted;
use crate::study::sensitivity::{Effect, Sensitivity, step};
use crate::units::Units;

/// Cells of a tornado on each side of its middle.
const HALF: usize = 15;

/// The reports of all layouts, an empty line between them.
pub(crate) fn report(studied: &[Studied], wanted: Option<&Wanted>, unit: Units) -> String {
    pages(studied, |s| one(s, wanted, unit))
}

fn one(s: &Studied, wanted: Option<&Wanted>, unit: Units) -> String {
    let mut page = Page::new(unit);
    page.inputs("sensitivity", s.name.as_deref(), s.case.fingerprint(), &s.case);
    match &s.sensitivity.base {
        Ok(point) => {
            page.line("FIELD", say::point(point, unit));
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
            for effect in Effect::all(point.utilisation().is_some()) {
                match checked {
                    Some((checked, _)) => both::tornado(&mut page, s, checked, *effect),
                    None => tornado(&mut page, &s.sensitivity, *effect),
                }
            }
            notes(&mut page, &s.sensitivity);
            if let Some((checked, _)) = checked {
                both::notes(&mut page, checked);
            }
        }
        Err(why) => page.line("field", why.sentence()),
    }
    page.line("basis", BASIS);
    page.text()
}

fn tornado(page: &mut Page, s: &Sensitivity, effect: Effect) {
    let most = tornado::most(s, None, effect);
    let scale = EffectScale::digits(effect, page.unit);
    let (symbol, unit) = (effect::whose(effect, false), effect::unit(effect, page.unit));
    let title = format!("change of {symbol}, {unit}");
    let (left, right) = (scale.text(-most), scale.text(most));
    page.lines.push(String::new());
    page.lines.push(format!("{title:<30} lowered   raised {left:<HALF$}0{right:>HALF$}"));
    for row in tornado::tornado(s, None, effect, &scale, page.unit) {
        let [low, high] = row.forecast.texts;
        let drawn = tornado::bars(row.forecast.sizes, most, HALF, Glyphs::Ascii);
        let line = format!("{:<9}{:<20}{low:>9}{high:>9} {drawn}", row.symbol, row.range);
        page.lines.push(line.trim_end().to_string());
    }
}

fn notes(page: &mut Page, s: &Sensitivity) {
    page.lines.push(String::new());
    for (head, text) in tornado::notes(s) {
        page.line(head, text);
    }
    if let Ok(point) = &s.base {
        for w in point.warnings.iter().filter(|w| w.weight() >= Weight::Caution) {
            page.line(w.weight().word(), w.short(page.unit));
        }
    }
}

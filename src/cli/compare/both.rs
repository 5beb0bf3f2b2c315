//! The checks of a comparison as a second table below the forecasts.

use super::Compared;
use crate::cli::dem::text as dem;
use crate::cli::page::{NAME, Page, cut, percent};
use crate::show::comparison::over;
use crate::show::effect::{deflection, number};
use crate::study::checks::figures::Figures;
use crate::study::sensitivity::Effect;

/// The table of the checks with what to know of them; nothing where none were asked for.
pub(crate) fn table(page: &mut Page, compared: &Compared, order: &[usize]) {
    let Some((wanted, answers)) = &compared.checked else { return };
    let rows = &compared.comparison.rows;
    let unit = page.unit;
    page.lines.push(String::new());
    dem::plan(page, wanted);
    page.lines.push(format!(
        "  {:<NAME$}{:>8}{:>6}{:>14}{:>9}{:>8}{:>9}{:>8}",
        "DEM", "F", "+-", "band", "over F_a", "delta", "over d_a", "use"
    ));
    let (u, kn) = (unit.symbol(), unit.force_symbol());
    page.lines.push(format!(
        "  {:<NAME$}{:>8}{:>6}{:>14}{:>9}{u:>8}{:>9}{:>8}",
        "", kn, kn, kn, "%", "%", "%"
    ));
    for index in order {
        // As many answers as rows.
        let (Some(row), Some(answer)) = (rows.get(*index), answers.get(*index)) else { continue };
        let result = match answer {
            Ok(result) => result,
            Err(why) => {
                let name = cut(&row.name, NAME);
                page.lines.push(format!("  {name}{:>28}", why.short()));
                continue;
            }
        };
        let f = Figures::of(result, row.values().ok(), &row.case.asked());
        let none = || "-".to_string();
        let kn = |v: f64| number(v, Effect::Force, unit);
        let band =
            f.force_band.map_or_else(none, |[low, high]| format!("{}-{}", kn(low), kn(high)));
        page.lines.push(format!(
            "  {}{:>8}{:>6}{band:>14}{:>9}{:>8}{:>9}{:>8}",
            cut(&row.name, NAME),
            f.mean.map_or_else(|| "none".into(), |v| kn(v.force)),
            f.error.map_or_else(none, |e| unit.force_number(e.force, 2)),
            over(f.difference.map(|d| d.force)),
            f.mean.map_or_else(none, |v| deflection(v.deflection, unit)),
            over(f.difference.and_then(|d| d.deflection)),
            f.utilisation.map_or_else(none, percent),
        ));
    }
    let named = rows.iter().zip(answers).map(|(row, answer)| (row.name.clone(), answer));
    dem::notes(page, named);
    page.lines.push(String::new());
}

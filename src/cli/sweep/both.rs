//! A sweep of one input with its checks: both side by side, and the forces plotted with their bands.

use super::Swept;
use crate::case::CaseValue;
use crate::cli::page::{Page, WIDTH, input_unit, input_value, percent};
use crate::show::effect::{deflection, maybe_deflection};
use crate::show::strip::{StripMark, strip};
use crate::study::checks::CheckAnswer;
use crate::study::checks::figures::Figures;
use crate::study::sweep::{dem, extent};

/// Columns of the forecast and of the check, without those of the utilisation.
const FORECAST: usize = 16;
const CHECK: usize = 22;
/// Columns of a utilisation.
const USE: usize = 7;

/// The line of the forecast, the points of the check beside it, and the plot turned on its side.
pub(crate) fn line_plot(page: &mut Page, s: &Swept, answers: &[CheckAnswer]) {
    let (unit, input, points) = (page.unit, s.sweep.grid.first.input, &s.sweep.points);
    let forces = extent(points, |p| Some(p.values().force));
    let ends = [forces, dem::extent(answers)].into_iter().flatten();
    let Some((least, most)) = ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))) else {
        return page.line("field", "no value anywhere in the range");
    };
    let kn = |v: f64| unit.force_number(v, 3);
    let asked = s.case.asked().force.is_some();
    let text = format!(
        "F from {} to {} {}: F forecast, D mean of the DEM in its band ---, * both",
        kn(least),
        kn(most),
        unit.force_symbol()
    );
    page.line("plot", text);
    page.lines.push(String::new());
    let more = if asked { USE } else { 0 };
    let head = format!("{} {}", input.symbol(), input_unit(input, unit));
    let symbol = unit.symbol();
    let used = if asked { format!("{:>USE$}", "use %") } else { String::new() };
    let (left, right) = (FORECAST + more + 2, CHECK + more);
    page.lines.push(format!("{:>10}{:^left$}{:^right$}", "", "FORECAST", "DEM").trim_end().into());
    let delta = format!("delta {symbol}");
    let force = format!("F {}", unit.force_symbol());
    page.lines.push(format!(
        "{head:>10}{:>7}{delta:>9}{used}  {:>7}{:>6}{delta:>9}{used}",
        force, force, "+-"
    ));
    let width = WIDTH - 10 - left - right - 3;
    for ((at, outcome), answer) in s.sweep.grid.columns.iter().zip(points).zip(answers) {
        let forecast = outcome.as_ref().ok().map(crate::case::CasePoint::values);
        let theirs = match outcome {
            Ok(p) => {
                let v = p.values();
                let used =
                    p.utilisation().map_or(String::new(), |u| format!("{:>USE$}", percent(u)));
                let mark = if p.doubtful() { " !" } else { "" };
                format!("{:>7}{:>9}{used}{mark}", kn(v.force), maybe_deflection(v.deflection, unit))
            }
            Err(why) => format!("{:>FORECAST$}", why.short()),
        };
        let asked = s.case.with(input, *at).asked();
        let figures = answer.as_ref().ok().map(|v| Figures::of(v, forecast, &asked));
        let ours = match (figures, answer) {
            (Some(f), _) => match f.mean {
                Some(v) => {
                    let error = f.error.map_or("-".into(), |e| unit.force_number(e.force, 2));
                    let used =
                        f.utilisation.map_or(String::new(), |u| format!("{:>USE$}", percent(u)));
                    let reached = deflection(v.deflection, unit);
                    format!("{:>7}{error:>6}{reached:>9}{used}", kn(v.force))
                }
                None => format!("{:>CHECK$}", "no break"),
            },
            (None, Err(why)) => format!("{:>CHECK$}", why.short()),
            (None, Ok(_)) => String::new(),
        };
        let drawn = row(width, (least, most), outcome, figures);
        let at = input_value(input, *at, unit);
        page.lines.push(format!("{at:>10}{theirs:<left$}{ours:<right$} |{drawn}|"));
    }
    page.lines.push(String::new());
    page.lines.push("+-  standard error of the mean of the runs".to_string());
}

/// One line of the plot.
fn row(width: usize, ends: (f64, f64), outcome: &CaseValue, figures: Option<Figures>) -> String {
    let band = figures.and_then(|f| f.force_band);
    let mean = figures.and_then(|f| f.mean);
    let marks = [
        band.map(|[from, to]| StripMark { from, to, ends, sign: '-' }),
        mean.map(|v| StripMark::at(v.force, ends, 'D')),
        outcome.as_ref().ok().map(|p| StripMark::at(p.values().force, ends, 'F')),
    ];
    strip(width, marks.into_iter().flatten())
}

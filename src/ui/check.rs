//! The check by simulation: its lines in the answer, its curves on the chart, its progress.

use super::curves::CurvePlot;
use super::studies;
use super::theme::Theme;
use crate::app::App;
use crate::app::work::shown::{ShownCheck, Standing};
use crate::app::work::steps::RunningSteps;
use crate::curve::{Curve, Point};
use crate::job::pace::duration;
use crate::remark::Weight;
use crate::show::grid::{DotGrid, DotPen, Pattern};
use crate::show::picture::Ink;
use crate::show::say;
use crate::study::checks::{self, Difference};
use crate::study::remark::CheckRemark;
use crate::study::result::places::Places;
use crate::units::{force_text, length_text, significant};
use crate::words::Choice;
use ratatui::style::Style;

/// The sign of the mean first break on the chart.
pub(crate) const SIGN: char = 'o';

/// What is said of the check in the answer, the most important first.
pub(crate) fn lines(app: &App, theme: &Theme) -> Vec<(String, Style)> {
    let Some(shown) = app.shown_check() else {
        return match app.live_refusal() {
            Some(why) => vec![(format!("no check: {why}"), theme.caution)],
            None if app.live_running() => vec![("live check under way".into(), theme.check)],
            None => Vec::new(),
        };
    };
    let result = shown.result;
    let style = if shown.stale() { theme.caution } else { theme.check };
    let mut lines = vec![(figures(app, &shown), style)];
    let (first, later): (Vec<_>, Vec<_>) = result
        .remarks()
        .into_iter()
        .filter(said_here)
        .partition(|r| matches!(r, CheckRemark::Bifurcation(_) | CheckRemark::Diverged(_)));
    lines.extend(first.iter().map(|r| (format!("! {}", r.short()), theme.caution)));
    let runs = match shown.standing {
        Standing::Live(true) => format!("{} of {}", result.runs, crate::app::work::live::LIVE_RUNS),
        _ => result.runs.to_string(),
    };
    let word = if runs == "1" { "run" } else { "runs" };
    let difference = difference(app, &shown);
    let difference = difference.map_or(String::new(), |d| format!("{}; ", say::difference(&d)));
    let cut = if result.partial() {
        format!(", {}", CheckRemark::Cancelled(None).short())
    } else {
        String::new()
    };
    lines.push((format!(" {difference}{runs} {word}{cut}"), theme.text));
    lines.extend(later.iter().map(|r| (format!(" {}", r.short()), theme.caution)));
    if let Some(arrangement) = &result.field.arrangement {
        let anchor = result.anchor().map_or(String::new(), |a| {
            format!(", anchor {}", force_text(a.normal.hypot(a.in_plane), app.units()))
        });
        lines.push((format!(" {arrangement}{anchor}"), theme.text));
    }
    let places = Places::from_result(result, &app.layout().layout).text();
    if !places.is_empty() && !shown.stale() {
        lines.push((format!(" breaks: {places}"), theme.text));
    }
    lines
}

/// Whether a remark has a line of its own: that it was ended early stands with its runs, and how well the
/// mean is known beside it.
fn said_here(remark: &CheckRemark) -> bool {
    let elsewhere = matches!(remark, CheckRemark::Cancelled(_) | CheckRemark::StandardError(_));
    remark.weight() > Weight::Note && !elsewhere
}

/// How far the check can be trusted, where there is room for it.
pub(crate) fn trust(app: &App, theme: &Theme) -> Option<(String, Style)> {
    let result = app.shown_check()?.result;
    // Of an ensemble that chooses the mean counts: its runs are as rough as that allows.
    let chosen = result.wanted.run_fidelity().is_none() && result.breaks.len() > 1;
    let (what, part) = match chosen {
        true => ("mean to", result.force.uncertainty()),
        false => ("error est.", result.quality.error_estimate),
    };
    let (word, error) = (result.wanted.fidelity.word(), significant(100.0 * part, 2));
    Some((format!("DEM {word}: {what} {error} %"), theme.text))
}

/// Force and deflection with their deviation.
fn figures(app: &App, shown: &ShownCheck) -> String {
    let result = shown.result;
    let label = match shown.standing {
        Standing::Live(_) => "live",
        Standing::Current | Standing::Stale => "DEM",
    };
    let stale = if shown.stale() { " stale" } else { "" };
    if !result.broke() {
        return format!(
            "{label} no break, peak {}{stale}",
            force_text(result.peak.force, app.units())
        );
    }
    let mean = app.units().force_number(result.force.mean, 3);
    let deviation = match result.breaks.len() {
        0 | 1 => String::new(),
        _ => {
            // As many decimals as the mean has.
            let decimals = mean.rsplit_once('.').map_or(0, |(_, d)| d.len());
            format!("+-{:.decimals$}", app.units().force(result.force.deviation))
        }
    };
    format!(
        "{label} {mean}{deviation} {} {}{stale}",
        app.units().force_symbol(),
        length_text(result.deflection.mean, app.units())
    )
}

/// Difference of the check from the forecast of the inputs as they are.
fn difference(app: &App, shown: &ShownCheck) -> Option<Difference> {
    let field = app.result().forecast()?.field.ok()?;
    checks::difference(shown.result, field.values).filter(|_| !shown.stale())
}

/// How far the chart must reach for the check.
pub(crate) fn reach(app: &App) -> Point {
    let mut reach = Point::default();
    let mut hold = |p: Point| {
        reach.force = reach.force.max(p.force);
        reach.deflection = reach.deflection.max(p.deflection);
    };
    if let Some(shown) = app.shown_check() {
        shown.result.curve.points().for_each(&mut hold);
        let top = shown.result.band[1].iter().copied().fold(0.0, f64::max);
        hold(Point { force: top, deflection: 0.0 });
    }
    app.growing().iter().flatten().copied().for_each(&mut hold);
    reach
}

/// Draws the mean curve, its band, and the runs under way.
pub(super) fn curves(app: &App, chart: &CurvePlot, grid: &mut DotGrid) {
    let thin = DotPen { ink: Ink::Check, pattern: Pattern::Dashed(1, 3), ascii: Some(',') };
    let growing = app.growing();
    for run in growing {
        chart.line(run.iter().copied(), thin, grid);
    }
    let Some(shown) = app.shown_check().filter(|_| growing.is_empty()) else { return };
    let result = shown.result;
    for limit in result.band.iter().filter(|limit| !limit.is_empty()) {
        let curve = Curve {
            deflection: result.curve.deflection.clone(),
            force: limit.clone(),
            failure: None,
        };
        chart.curve(&curve, thin, grid);
    }
    let pattern = if shown.stale() { Pattern::Dashed(1, 2) } else { Pattern::Dashed(4, 2) };
    chart.curve(&result.curve, DotPen { ink: Ink::Check, pattern, ascii: Some('o') }, grid);
    for broken in &result.breaks {
        chart.dot(broken.at, DotPen { pattern: Pattern::Solid, ..thin }, grid);
    }
}

/// Puts the sign at the mean first break.
pub(super) fn marks(app: &App, chart: &mut CurvePlot) {
    let Some(shown) = app.shown_check().filter(|_| app.growing().is_empty()) else { return };
    if let Some(end) = shown.result.curve.failure {
        chart.mark(end, SIGN, Ink::Check);
    }
}

/// How far long work of several steps has come, in a line.
fn step(steps: &RunningSteps) -> String {
    let Some(p) = steps.progress() else { return format!("{}; Esc ends it", steps.name()) };
    let left = p.left.map_or(String::new(), |left| format!(", {} left", duration(left)));
    let percent = 100.0 * p.fraction;
    format!("{}: {}, {percent:.0} %{left}; Esc ends it, what is made is kept", steps.name(), p.text)
}

/// How far the user's check has come, in a line.
pub(crate) fn progress(app: &App) -> Option<String> {
    if let Some(steps) = app.steps() {
        return Some(step(steps));
    }
    let Some(running) = app.running() else { return studies::progress(app) };
    let Some(p) = running.progress() else {
        return Some("checking; Esc ends it".into());
    };
    let layouts = &app.project().layouts;
    let name = layouts.iter().find(|l| l.uid == p.uid).map_or("", |l| l.name.as_str());
    let part =
        if p.parts > 1 { format!(" ({} of {})", p.part + 1, p.parts) } else { String::new() };
    Some(format!(
        "checking {name}{part}: {} of {} runs, {:.0} %, {} left; Esc ends it",
        p.done,
        p.planned,
        100.0 * p.fraction,
        duration(p.left)
    ))
}

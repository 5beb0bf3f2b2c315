//! Design: what is asked with its partial factors, what the layout answers, and which plate, spacing or
//! punch just meets it.

use super::super::text::{below, cut, heading, put, spot};
use super::super::theme::Theme;
use super::super::{answer, chart};
use super::{nothing, plan};
use crate::app::App;
use crate::app::look::Glyphs;
use crate::app::studies::design::{DesignKind, DesignLine, DesignView};
use crate::case::{CasePoint, CaseValue, Input, input_value};
use crate::show::{say, verdict};
use crate::study::checks::figures::Figures;
use crate::study::solve::{Requirement, RequirementKind as At, Solution};
use crate::units::{
    Units, force_text, length_entry, length_text, maybe_length_text, percent, shortest,
};
use crate::words::Choice;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;

/// Cells of the drawing of a range.
const RANGE: usize = 20;

/// Least rows of the chart with its heading.
const CHART: u16 = 6;

/// Draws the page.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let name = &app.layout().name;
    let Some(view) = app.design() else {
        heading(buf, area, &format!("design of {name}"), "", theme);
        nothing("the mesh of this layout is not known", area, buf, theme);
        return None;
    };
    heading(buf, area, &format!("design of {name}"), &asked(view), theme);
    let mut rest = below(area, 1);
    let columns = usize::from(rest.width.saturating_sub(2));
    for (text, style) in question(app, view, theme) {
        put(buf, rest, 0, 1, &cut(&text, columns), style);
        rest = below(rest, 1);
    }
    if view.asked.is_empty() {
        for (row, line) in [
            "No design value is set, so there is nothing to solve.",
            "F or a digit types the design force, D the allowable deflection;",
            "L and R type the partial factors on load and resistance.",
        ]
        .iter()
        .enumerate()
        {
            put(buf, rest, 1 + row as u16, 1, &cut(line, columns), theme.text);
        }
        charted(app, below(rest, 5), buf, theme);
        return None;
    }
    let word = match view.requirement {
        Some(Requirement::Force) => "the force",
        Some(Requirement::Deflection) => "the deflection",
        _ => "both",
    };
    heading(buf, rest, &format!("what just meets {word}"), "published ranges", theme);
    rest = below(rest, 1);
    let lines = 2 * view.lines.len() as u16;
    let notes = notes(app, view, theme);
    let wanted = lines + notes.len() as u16;
    let chart = rest.height.saturating_sub(wanted);
    let chart = if chart >= CHART { chart } else { 0 };
    let list = Rect { height: (rest.height - chart).min(wanted), ..rest };
    let place = solved(
        app,
        view,
        Rect { height: list.height.saturating_sub(notes.len() as u16), ..list },
        buf,
        theme,
    );
    let foot = Rect {
        y: list.bottom() - (notes.len() as u16).min(list.height),
        height: (notes.len() as u16).min(list.height),
        ..list
    };
    for (row, (text, style)) in notes.iter().enumerate() {
        put(buf, foot, row as u16, 1, &cut(text, columns), *style);
    }
    charted(app, below(rest, list.height), buf, theme);
    place
}

/// The curve with the design lines, and the answer beside it.
fn charted(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    if area.height < CHART {
        return;
    }
    let beside = if area.width >= 70 { 29 } else { 0 };
    let left = Rect { width: area.width - beside - beside.min(1), ..area };
    heading(buf, left, &chart::caption(app), "", theme);
    chart::draw(app, below(left, 1), buf, theme);
    if beside > 0 {
        answer::draw(app, Rect { x: area.right() - beside, width: beside, ..area }, buf, theme);
    }
}

/// What the arrows go through.
fn asked(view: &DesignView) -> String {
    let words = view.asked.iter().map(|r| {
        if Some(*r) == view.requirement { format!("[{}]", r.word()) } else { r.word().to_string() }
    });
    words.collect::<Vec<_>>().join(" ")
}

/// Design values with their factors, and what the layout answers.
fn question(app: &App, view: &DesignView, theme: &Theme) -> Vec<(String, Style)> {
    let unit = app.units();
    let m = |v: f64| length_text(v, unit);
    let q = view.case.asked();
    let (on_load, on_resistance) = (shortest(q.gamma_load), shortest(q.gamma_resistance));
    let force = match q.force {
        Some(force) => format!(
            "Fd {} x gL {on_load} = {}",
            force_text(force, unit),
            force_text(force * q.gamma_load, unit)
        ),
        None => format!("Fd -, gL {on_load}"),
    };
    let allowed = match q.deflection {
        Some(v) => format!("dm {} {}", length_entry(v, unit), unit.symbol()),
        None => "dm -".to_string(),
    };
    let mut lines = vec![(format!("asked    {force};  {allowed}"), theme.design)];
    let point = match &view.outcome {
        Ok(point) => point,
        Err(why) => {
            lines.push((format!("forecast {}", why.sentence()), theme.caution));
            return lines;
        }
    };
    let v = point.values();
    let a = &point.answer;
    let resistance = format!(
        "forecast F_a {} / gR {on_resistance} = {}, delta_a {}",
        force_text(v.force, unit),
        force_text(a.resistance, unit),
        maybe_length_text(v.deflection, unit)
    );
    lines.push((resistance, theme.forecast));
    let mut words = Vec::new();
    if let Some(at) = &a.at_force {
        words.push(format!("margin {}", force_text(at.margin, unit)));
        if let Some(reached) = at.service_deflection {
            words.push(format!("{} at Fd", m(reached)));
        }
    }
    if let Some(at) = &a.at_deflection {
        let fails = if at.beyond_failure { " (fails before)" } else { "" };
        words.push(format!("{} at dm{fails}", force_text(at.force, unit)));
    }
    if !words.is_empty() {
        lines.push((format!("answer   {}", words.join(", ")), theme.text));
    }
    if let Some(v) = app.result().asked_verdict() {
        let text = format!("verdict  {}; {} values", verdict::short(v), v.basis.word());
        lines.push((text, answer::style(v.finding(), theme)));
    }
    if let Some(own) = &view.own {
        lines.push((format!("DEM      {}", say::check(own, unit)), theme.check));
    }
    lines
}

/// The list: two lines an entry. Returns the place of the marked one.
fn solved(
    app: &App,
    view: &DesignView,
    list: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    let unit = app.units();
    let entries = usize::from(list.height / 2).max(1);
    let first = super::super::layouts::first_shown(view.marked, entries, view.lines.len());
    let columns = usize::from(list.width.saturating_sub(1));
    for (place, (index, line)) in
        view.lines.iter().enumerate().skip(first).take(entries).enumerate()
    {
        let row = 2 * place as u16;
        let marked = index == view.marked;
        let sign = if marked { ">" } else { " " };
        let solution = view.solutions.iter().find(|s| s.input == line.input);
        let drawn = solution.map_or(String::new(), |s| range(s, view, theme.glyphs));
        let ends = solution.map_or(String::new(), |s| {
            format!("{}..{}", length_entry(s.range.min, unit), length_entry(s.range.max, unit))
        });
        let text =
            format!("{sign}{} {:<22} {drawn} {ends}", line.input.symbol(), offer(line, unit));
        let style = if marked { theme.selected } else { theme.title };
        put(buf, list, row, 0, &cut(&text, columns), style);
        let (gives, style) = gives(line, solution, view, unit, theme);
        put(buf, list, row + 1, 4, &cut(&gives, columns.saturating_sub(4)), style);
    }
    spot(buf, list, 2 * view.marked.saturating_sub(first) as u16, 0)
}

/// The value that a line offers.
fn offer(line: &DesignLine, unit: Units) -> String {
    match &line.kind {
        DesignKind::Take { crossing, value, .. } => {
            let side = match (crossing.advised, crossing.met_above) {
                (false, _) => "no cure",
                (true, true) => "or more",
                (true, false) => "or less",
            };
            format!("{} {} {side}", input_value(line.input, *value, unit), unit.symbol())
        }
        DesignKind::Always => "any of the range".into(),
        DesignKind::Never(_) => "NONE of the range".into(),
    }
}

/// What a line gives.
fn gives(
    line: &DesignLine,
    solution: Option<&Solution>,
    view: &DesignView,
    unit: Units,
    theme: &Theme,
) -> (String, Style) {
    let now = format!("now {}", input_value(line.input, line.input.value(&view.case), unit));
    match &line.kind {
        DesignKind::Take { crossing, outcome, .. } => {
            let how = match crossing.kind {
                At::Exact => "",
                At::Jump => "; F jumps there (A.1-A.2)",
                At::Edge => "; the method ends there",
            };
            let mut text = format!("{now}; gives {}{how}", outcome_text(outcome, unit));
            if let Some(f) = &line.figures {
                text = format!("{now}; gives {}; DEM {}", short(outcome, unit), dem(f, unit));
            }
            let doubtful = outcome.as_ref().is_ok_and(CasePoint::doubtful);
            if doubtful {
                text.push_str(" !");
            }
            (text, theme.text)
        }
        DesignKind::Always => {
            let ends = solution.map_or(String::new(), |s| {
                let ends = s.ends.iter().map(|e| at(line.input, e.value, &e.outcome, unit));
                ends.collect::<Vec<_>>().join("; ")
            });
            (format!("{now}; {ends}"), theme.text)
        }
        DesignKind::Never(best) => {
            let nearest = best.as_ref().map_or("no value anywhere".to_string(), |b| {
                let there = view.case.with(line.input, b.value);
                let found = verdict::of_outcome(&there, &b.outcome, view.basis);
                let at = input_value(line.input, b.value, unit);
                match found {
                    Some(found) => format!("nearest: at {at} {found}"),
                    None => format!("nearest: at {at} {}", short(&b.outcome, unit)),
                }
            });
            (format!("{now}; {nearest}"), theme.caution)
        }
    }
}

fn dem(f: &Figures, unit: Units) -> String {
    let Some(mean) = f.mean else { return "no break".into() };
    let used = say::used(f.utilisation);
    let force = force_text(mean.force, unit);
    format!("F {force}, {}{used}", length_text(mean.deflection, unit))
}

fn at(input: Input, value: f64, outcome: &CaseValue, unit: Units) -> String {
    format!("at {} {}", input_value(input, value, unit), short(outcome, unit))
}

/// Force and use, or why there are none.
fn short(outcome: &CaseValue, unit: Units) -> String {
    match outcome {
        Ok(p) => match p.answer.at_force {
            Some(at) => {
                format!("{}, use {} %", force_text(p.values().force, unit), percent(at.utilisation))
            }
            None => format!(
                "{}, delta_a {}",
                force_text(p.values().force, unit),
                maybe_length_text(p.values().deflection, unit)
            ),
        },
        Err(why) => why.short().into(),
    }
}

fn outcome_text(outcome: &CaseValue, unit: Units) -> String {
    match outcome {
        Ok(p) => say::point_at_load(p, unit, "at Fd"),
        Err(_) => short(outcome, unit),
    }
}

/// The published range: where it is met, and where the layout is.
fn range(s: &Solution, view: &DesignView, glyphs: Glyphs) -> String {
    let (met, not) = match glyphs {
        Glyphs::Ascii => ('=', '.'),
        _ => ('━', '·'),
    };
    let width = s.range.max - s.range.min;
    let now = s.input.value(&view.case);
    let own = ((now - s.range.min) / width * RANGE as f64).floor();
    let cells = (0..RANGE).map(|i| {
        let middle = s.range.min + width * (i as f64 + 0.5) / RANGE as f64;
        let inside = s.spans.iter().any(|span| (span.from..=span.to).contains(&middle));
        let here = own == i as f64 || (now == s.range.max && i + 1 == RANGE);
        match (here, inside) {
            (true, _) => 'X',
            (false, true) => met,
            (false, false) => not,
        }
    });
    format!("[{}]", cells.collect::<String>())
}

fn notes(app: &App, view: &DesignView, theme: &Theme) -> Vec<(String, Style)> {
    let (met, not) = match theme.glyphs {
        Glyphs::Ascii => ("=", "."),
        _ => ("━", "·"),
    };
    let mut lines = vec![(
        format!(
            "[{met} met, {not} not met, X as it is]; Enter takes the value, all else as it stands"
        ),
        theme.text,
    )];
    let coverage = view.coverage;
    if coverage.stale && !coverage.any() {
        lines.push(("DEM stale: of other inputs; c checks these".into(), theme.caution));
    } else if coverage.any() || app.campaign().is_some() {
        let count = format!(
            "DEM: {} of {} checks, {}",
            coverage.have,
            coverage.of,
            plan(&app.study_wanted())
        );
        lines.push((count, theme.check));
    }
    lines
}

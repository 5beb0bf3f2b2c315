//! The answer: force, deflection, branch, design, anchor force, the first warnings.

use super::check;
use super::text::{below, cut, heading, put};
use super::theme::Theme;
use crate::app::App;
use crate::forecast::warning::Warning;
use crate::forecast::{Field, Forecast};
use crate::layout::Layout;
use crate::remark::Weight;
use crate::show::{say, verdict};
use crate::study::verdict::Finding;
use crate::units::{Units, force_text, length_text, maybe_length_text};
use crate::words::Choice;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

/// Draws the answer with its heading, as many lines as there are rows, the most important first.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    heading(buf, area, "answer", "", theme);
    let list = below(area, 1);
    let columns = usize::from(list.width.saturating_sub(1));
    let lines = lines(app, usize::from(list.height), theme);
    for (row, (text, style)) in lines.iter().enumerate() {
        put(buf, list, row as u16, 1, &cut(text, columns), *style);
    }
}

/// Columns that the answer has at least.
const NARROWEST: usize = 28;

/// The lines of the answer with their styles, at most `rows`. The verdict stands behind the values and is
/// never pushed off.
pub(crate) fn lines(app: &App, rows: usize, theme: &Theme) -> Lines {
    let forecast = match &app.result().derived {
        Ok(derived) => &derived.forecast,
        Err(problems) => {
            let problems = problems.iter().map(|p| (p.to_string(), theme.error));
            return verdict_line(app, theme).into_iter().chain(problems).take(rows).collect();
        }
    };
    let (mut first, rest) = match &forecast.field {
        Ok(field) => field_lines(app, forecast, field, theme),
        Err(why) => {
            let said = textwrap::wrap(why.sentence(), NARROWEST);
            let said = said.iter().map(|line| (line.to_string(), theme.caution));
            (verdict_line(app, theme).into_iter().chain(said).collect(), Vec::new())
        }
    };
    // Where rows are few, what to distrust comes before how it was found.
    if rows > first.len() + rest.len() {
        first.extend(rest);
        let room = rows.saturating_sub(first.len());
        first.extend(warning_lines(forecast, app.units(), room, theme));
    } else {
        let room = rows.saturating_sub(first.len());
        first.extend(warning_lines(forecast, app.units(), room, theme));
        first.extend(rest);
    }
    first.truncate(rows);
    first
}

/// The verdict in a few words with its mark in front, where anything is asked.
fn verdict_line(app: &App, theme: &Theme) -> Option<(String, Style)> {
    let v = app.result().asked_verdict()?;
    let finding = v.finding();
    Some((format!("{} {}", finding.mark(), verdict::short(v)), style(finding, theme)))
}

/// How a finding is drawn.
pub(crate) fn style(finding: Finding, theme: &Theme) -> Style {
    match finding {
        Finding::Fails => theme.error,
        Finding::NotJudged | Finding::Doubtful => theme.caution,
        Finding::Passes | Finding::NotAsked => theme.text,
    }
}

/// The checks behind the verdict, the basis and the factors that act, what to know beside it.
fn checked_lines(app: &App, theme: &Theme) -> (Lines, Lines) {
    let Some(v) = app.result().asked_verdict() else { return (Vec::new(), Vec::new()) };
    let checks = v.checks.iter().filter_map(|c| {
        let style = if c.state.fails() { theme.error } else { theme.text };
        verdict::brief(v, c, app.units()).map(|text| (text, style))
    });
    let cautions = v.remarks.iter().map(|r| (format!("! {}", r.short()), theme.caution));
    let question = &app.layout().question;
    let mut basis = format!("{} values", v.basis.word());
    if question.gamma_load != 1.0 || question.gamma_resistance != 1.0 {
        basis += &format!(", gL {} gR {}", question.gamma_load, question.gamma_resistance);
    }
    let basis = (basis, theme.text);
    (checks.collect(), std::iter::once(basis).chain(cautions).collect())
}

/// Lines of text with their styles.
type Lines = Vec<(String, Style)>;

/// What was found, and how.
fn field_lines(app: &App, forecast: &Forecast, field: &Field, theme: &Theme) -> (Lines, Lines) {
    let mark = if forecast.extrapolated() { " !" } else { "" };
    let mut lines = vec![(
        format!(
            "F_a {}  delta_a {}{mark}",
            force_text(field.values.force, app.units()),
            maybe_length_text(field.values.deflection, app.units())
        ),
        theme.forecast,
    )];
    lines.extend(verdict_line(app, theme));
    let (checks, beside) = checked_lines(app, theme);
    let dem = check::lines(app, theme);
    // With a check the numbers of both stand before their reasons.
    let (dem_first, dem_rest) = dem.split_at(dem.len().min(2));
    lines.extend_from_slice(dem_first);
    lines.extend(checks);
    // What else there is of the force comes behind whether it is enough.
    if let Some(published) = field.published {
        lines.push((say::published_short(published, field.values, app.units()), theme.text));
        lines.push((format!("90 %: {}", say::band(field, app.units())), theme.text));
    }
    lines.extend(beside);
    lines.extend_from_slice(dem_rest);
    lines.extend(mobilised(app, theme));
    let branch = match field.branch {
        crate::forecast::field::Branch::SmallPunch => "small punch",
        crate::forecast::field::Branch::LargePunch => "large punch",
    };
    let how_found = match field.method {
        None => format!("{branch}, {}", forecast.rule.word()),
        Some(_) => format!("{branch}, derived method"),
    };
    let mut how = vec![
        (how_found, theme.text),
        (anchor_line(&app.layout().layout, field, app.units()), theme.text),
    ];
    how.extend(check::trust(app, theme));
    (lines, how)
}

/// How the blocks stand, and what an anchor carries at failure: at most, where blocks face each other.
fn anchor_line(layout: &Layout, field: &Field, unit: Units) -> String {
    let (word, force) = (layout.blocks.word(), field.values.force);
    match layout.facing_bound() {
        None => format!("blocks {word}; anchor {}", force_text(force, unit)),
        Some(bound) => format!("blocks {word}; anchor <{}", force_text(bound * force, unit)),
    }
}

/// The force at the allowed deflection.
fn mobilised(app: &App, theme: &Theme) -> Option<(String, Style)> {
    let a = app.result().answer()?.at_deflection?;
    let allowed = length_text(app.layout().question.deflection?, app.units());
    Some(match a.beyond_failure {
        true => (format!("fails before {allowed}"), theme.caution),
        false => (format!("at {allowed}: {}", force_text(a.force, app.units())), theme.text),
    })
}

/// The heaviest warnings in a few words, and how many more there are.
fn warning_lines(forecast: &Forecast, units: Units, rows: usize, theme: &Theme) -> Lines {
    let mut warnings: Vec<&Warning> = forecast.warnings.iter().collect();
    warnings.sort_by_key(|w| std::cmp::Reverse(w.weight()));
    let style =
        |w: &Warning| if w.weight() >= Weight::Caution { theme.caution } else { theme.text };
    let mut lines: Lines =
        warnings.iter().take(rows).map(|w| (format!("! {}", w.short(units)), style(w))).collect();
    if warnings.len() > rows
        && let Some((text, _)) = lines.last_mut()
    {
        text.push_str(&format!(" (+{}, i)", warnings.len() - rows));
    }
    lines
}

//! The answer: force, deflection, branch, design, anchor force, the first warnings.

use super::check;
use super::text::{below, cut, heading, put};
use super::theme::Theme;
use crate::app::App;
use crate::forecast::warning::Warning;
use crate::forecast::{Field, Forecast};
use crate::remark::Weight;
use crate::units::{force_text, length_text, significant, to_kn};
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

/// The lines of the answer with their styles, at most `rows`.
pub(crate) fn lines(app: &App, rows: usize, theme: &Theme) -> Lines {
    let forecast = match &app.result().derived {
        Ok(derived) => &derived.forecast,
        Err(problems) => {
            return problems.iter().take(rows).map(|p| (p.to_string(), theme.error)).collect();
        }
    };
    let (mut first, rest) = match &forecast.field {
        Ok(field) => field_lines(app, forecast, field, theme),
        Err(why) => {
            let lines = textwrap::wrap(why.sentence(), NARROWEST);
            (lines.iter().map(|line| (line.to_string(), theme.caution)).collect(), Vec::new())
        }
    };
    // Where rows are few, what to distrust comes before how it was found.
    if rows > first.len() + rest.len() {
        first.extend(rest);
        let room = rows.saturating_sub(first.len());
        first.extend(warning_lines(forecast, room, theme));
    } else {
        let room = rows.saturating_sub(first.len());
        first.extend(warning_lines(forecast, room, theme));
        first.extend(rest);
    }
    first.truncate(rows);
    first
}

/// Lines of text with their styles.
type Lines = Vec<(String, Style)>;

/// What was found, and how.
fn field_lines(app: &App, forecast: &Forecast, field: &Field, theme: &Theme) -> (Lines, Lines) {
    let m = |v: f64| length_text(v, app.units());
    let mark = if forecast.extrapolated() { " !" } else { "" };
    let mut lines = vec![(
        format!(
            "F_a {}  delta_a {}{mark}",
            force_text(field.values.force),
            m(field.values.deflection)
        ),
        theme.forecast,
    )];
    lines.extend(check::lines(app, theme));
    lines.extend(design_lines(app, theme));
    let branch = match field.branch {
        crate::forecast::field::Branch::SmallPunch => "small punch",
        crate::forecast::field::Branch::LargePunch => "large punch",
    };
    let mut how = vec![
        (format!("{branch}, {}", forecast.rule.word()), theme.text),
        (format!("lower bound; anchor {}", force_text(field.values.force)), theme.text),
    ];
    how.extend(check::trust(app, theme));
    (lines, how)
}

fn design_lines(app: &App, theme: &Theme) -> Lines {
    let mut lines = Vec::new();
    let Some(design) = app.result().answer() else { return lines };
    let m = |v: f64| length_text(v, app.units());
    let layout = app.layout();
    let factors = layout.question.gamma_load != 1.0 || layout.question.gamma_resistance != 1.0;
    if let Some(a) = design.at_force {
        let load = significant(to_kn(a.load), 3);
        let percent = format!("{:.0} %", a.utilisation * 100.0);
        let style = if a.trouble().is_some() { theme.error } else { theme.text };
        let text = match (a.deflection, a.trouble()) {
            (Some(deflection), _) if a.utilisation <= 1.0 => {
                format!("at {load} kN: {}  use {percent}", m(deflection))
            }
            (_, trouble) => format!("{}: use {percent} at {load}", trouble.unwrap_or_default()),
        };
        lines.push((text, style));
        if let (true, Some(trouble), Some(allowed)) =
            (a.over_allowed(), a.trouble(), layout.question.deflection)
        {
            lines.push((format!("{trouble} {}", m(allowed)), style));
        }
    }
    if let Some(a) = design.at_deflection {
        let allowed = layout.question.deflection.map_or(String::new(), m);
        let text = if a.beyond_failure {
            format!("fails before {allowed}")
        } else {
            format!("at {allowed}: {}", force_text(a.force))
        };
        lines.push((text, if a.beyond_failure { theme.caution } else { theme.text }));
    }
    if factors && (design.at_force.is_some() || design.at_deflection.is_some()) {
        lines.push((
            format!(
                "factors gL {}, gR {}",
                layout.question.gamma_load, layout.question.gamma_resistance
            ),
            theme.text,
        ));
    }
    lines
}

/// The heaviest warnings in a few words, and how many more there are.
fn warning_lines(forecast: &Forecast, rows: usize, theme: &Theme) -> Lines {
    let mut warnings: Vec<&Warning> = forecast.warnings.iter().collect();
    warnings.sort_by_key(|w| std::cmp::Reverse(w.weight()));
    let style =
        |w: &Warning| if w.weight() >= Weight::Caution { theme.caution } else { theme.text };
    let mut lines: Lines =
        warnings.iter().take(rows).map(|w| (format!("! {}", w.short()), style(w))).collect();
    if warnings.len() > rows
        && let Some((text, _)) = lines.last_mut()
    {
        text.push_str(&format!(" (+{}, i)", warnings.len() - rows));
    }
    lines
}

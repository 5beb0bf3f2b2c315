//! The list of layouts with force and verdict of each.

use super::answer::style;
use super::chart::overlay_letter;
use super::text::{below, heading, put};
use super::theme::Theme;
use crate::app::App;
use crate::app::derived::LayoutResult;
use crate::forecast::NoField;
use crate::remark::Weight;
use crate::show::names::shortened;
use crate::study::verdict::{Finding, Verdict};
use crate::units::Units;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Draws the list with its heading; it scrolls so that the selected layout is seen.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let layouts = &app.project().layouts;
    let title = if layouts.len() > usize::from(area.height.saturating_sub(1)) {
        format!("layouts {}/{}", app.selected() + 1, layouts.len())
    } else {
        "layouts".to_string()
    };
    heading(buf, area, &title, &format!("F_a {}", app.units().force_symbol()), theme);
    let list = below(area, 1);
    let rows = usize::from(list.height);
    let first = first_shown(app.selected(), rows, layouts.len());
    let room = usize::from(list.width).saturating_sub(12);
    let shown = first..layouts.len().min(first + rows);
    let names: Vec<&str> = layouts[shown.clone()].iter().map(|l| l.name.as_str()).collect();
    let names = shortened(&names, room);
    for (row, (index, name)) in shown.zip(names).enumerate() {
        let selected = index == app.selected();
        let sign = if selected { ">" } else { " " };
        let letter = overlay_letter(app, index).unwrap_or(' ');
        let result = &app.results()[index];
        let (value, doubt) = force(result, app.units());
        let finding = result.verdict.as_ref().map_or(Finding::NotAsked, Verdict::finding);
        let used = unicode_width::UnicodeWidthStr::width(name.as_str());
        let line = format!(
            "{sign}{letter}{name}{} {value:>6} {}{doubt}",
            " ".repeat(room.saturating_sub(used)),
            finding.mark()
        );
        put(buf, list, row as u16, 0, &line, if selected { theme.selected } else { theme.text });
        if !selected && finding != Finding::NotAsked {
            let column = room as u16 + 10;
            put(buf, list, row as u16, column, &finding.mark().to_string(), style(finding, theme));
        }
    }
}

/// First entry shown of a list so that the selected one is seen, near the middle.
pub(crate) fn first_shown(selected: usize, rows: usize, count: usize) -> usize {
    selected.saturating_sub(rows / 2).min(count.saturating_sub(rows))
}

/// The force of a layout and the mark of its warnings.
fn force(result: &LayoutResult, units: Units) -> (String, &'static str) {
    let Some(forecast) = result.forecast() else { return ("error".into(), "!") };
    let weight =
        forecast.warnings.iter().map(super::super::forecast::warning::Warning::weight).max();
    let mark = if weight >= Some(Weight::Caution) { "!" } else { " " };
    let value = match &forecast.field {
        Ok(field) => units.force_number(field.values.force, 3),
        Err(NoField::PunchOnPlate) => "plate".into(),
        Err(why) => why.short().into(),
    };
    (value, mark)
}

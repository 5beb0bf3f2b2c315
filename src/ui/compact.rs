//! The screen of small terminals, from 40x12: layout, inputs and answer; the chart where it fits.

use super::text::{below as under, cut, heading, put};
use super::theme::Theme;
use super::{answer, chart, inputs};
use crate::app::App;
use crate::show::names::shortened;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Draws everything between title and bottom line. Returns the place of the selected input.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) -> Option<Position> {
    let count = app.project().layouts.len();
    let names: Vec<&str> = app.project().layouts.iter().map(|l| l.name.as_str()).collect();
    let name = shortened(&names, 26).into_iter().nth(app.selected()).unwrap_or_default();
    let text = format!(" {name} ({}/{count})", app.selected() + 1);
    put(buf, area, 0, 0, &text, theme.selected);
    let rest = under(area, 1);
    // Inputs beside the answer, or above it.
    if rest.width >= 64 {
        let left = Rect { width: 27, ..rest };
        let right = Rect { x: rest.x + 28, width: rest.width - 28, ..rest };
        let list = Rect { height: rest.height.min(11), ..left };
        let place = inputs::draw(app, list, buf, theme);
        let answer_rows = 5.min(rest.height);
        let charted = right.height > answer_rows + 7;
        let answer_area = if charted { Rect { height: answer_rows, ..right } } else { right };
        answer::draw(app, answer_area, buf, theme);
        if charted {
            let area = under(right, answer_rows);
            heading(buf, area, &chart::caption(app), "", theme);
            chart::draw(app, under(area, 1), buf, theme);
        }
        return place;
    }
    // No headings: every row counts.
    let rows = rest.height.saturating_sub(3).min(10);
    let place = inputs::draw_rows(app, Rect { height: rows, ..rest }, buf, theme);
    let below = under(rest, rows);
    let charted = below.height > 14;
    let answer_area = if charted { Rect { height: 6, ..below } } else { below };
    let columns = usize::from(answer_area.width.saturating_sub(1));
    for (row, (text, style)) in
        answer::lines(app, usize::from(answer_area.height), theme).iter().enumerate()
    {
        put(buf, answer_area, row as u16, 1, &cut(text, columns), *style);
    }
    if charted {
        let area = under(below, 6);
        heading(buf, area, &chart::caption(app), "", theme);
        chart::draw(app, under(area, 1), buf, theme);
    }
    place
}

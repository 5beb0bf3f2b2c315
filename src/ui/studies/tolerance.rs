//! The tolerance of one input: a line for each of its values.

use super::super::text::{below, cut, heading, put};
use super::super::theme::Theme;
use super::nothing;
use crate::app::App;
use crate::case::Input;
use crate::show::tolerance::{lines, title};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Draws the page.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let name = &app.layout().name;
    let Some(view) = app.tolerance() else {
        heading(buf, area, &format!("tolerance of {name}"), "", theme);
        return nothing(
            "the mesh of this layout is not known, or lacks the value",
            area,
            buf,
            theme,
        );
    };
    let mark = |input: &Input| match *input == view.input {
        true => format!("[{}]", input.symbol()),
        false => input.symbol().to_string(),
    };
    let inputs: Vec<String> =
        Input::varied(&app.layout().layout).map(|input| mark(&input)).collect();
    heading(buf, area, &format!("tolerance of {name}"), &inputs.join(" "), theme);
    let found = match &view.found {
        Ok(found) => found,
        Err(problems) => return nothing(&problems[0].to_string(), area, buf, theme),
    };
    let columns = usize::from(area.width.saturating_sub(2));
    put(buf, area, 1, 1, &cut(&title(found, app.units()), columns), theme.title);
    let table = below(area, 3);
    for (row, line) in (0..table.height).zip(lines(found, app.units())) {
        let style = match (row, line.bad) {
            (0, _) => theme.heading,
            (_, true) => theme.caution,
            (_, false) => theme.text,
        };
        put(buf, table, row, 1, &cut(&line.text, columns), style);
    }
    put(buf, area, 9, 1, &cut("a digit types how far the input may be off", columns), theme.text);
}

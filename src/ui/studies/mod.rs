//! The pages of studies, one a file; [`map`] is a sweep of two inputs.

pub(crate) mod compare;
pub(crate) mod design;
pub(crate) mod map;
pub(crate) mod sensitivity;
pub(crate) mod sweep;
pub(crate) mod tolerance;

use super::text::{clear, put, spot};
use super::theme::Theme;
use crate::app::App;
use crate::app::keymap::StudyPage;
use crate::job::pace::duration;
use crate::show::effect;
use crate::study::result::Wanted;
use crate::study::sensitivity::Effect;
use crate::words::Choice;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

/// Draws a page over the whole area. Returns the place of what is marked on it, or of its first line.
pub(crate) fn draw(
    app: &App,
    page: StudyPage,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) -> Option<Position> {
    clear(buf, area);
    let marked = match page {
        StudyPage::Sensitivity => {
            sensitivity::draw(app, area, buf, theme);
            None
        }
        StudyPage::Tolerance => {
            tolerance::draw(app, area, buf, theme);
            None
        }
        StudyPage::Sweep => sweep::draw(app, area, buf, theme),
        StudyPage::Compare => compare::draw(app, area, buf, theme),
        StudyPage::Design => design::draw(app, area, buf, theme),
    };
    marked.or_else(|| spot(buf, area, 1, 1))
}

/// How far the campaign of a page is, in a line.
pub(crate) fn progress(app: &App) -> Option<String> {
    let running = app.campaign()?;
    let (word, total) = (running.page().word(), running.total());
    let Some(p) = running.progress() else {
        return Some(format!("{word}: {total} checks begin; Esc ends them"));
    };
    Some(format!(
        "{word}: check {} of {total}, {:.0} %, {} left; Esc ends it",
        p.part + 1,
        100.0 * p.fraction,
        duration(p.left)
    ))
}

/// What all checks of a study have in common.
fn plan(wanted: &Wanted) -> String {
    let runs = wanted.runs.map_or("runs as needed".into(), |n| format!("{n} runs each"));
    format!("{}, {runs}, same draws", wanted.fidelity.word())
}

/// A line that says why there is nothing.
fn nothing(text: &str, area: Rect, buf: &mut Buffer, theme: &Theme) {
    put(buf, area, 2, 2, text, theme.caution);
}

/// What a key goes through, with the one that is shown.
fn value(effect: Effect, asked: bool) -> String {
    let word = |e: &Effect| match (effect::symbol(*e), *e == effect) {
        (word, true) => format!("[{word}]"),
        (word, false) => word.to_string(),
    };
    Effect::all(asked).iter().map(word).collect::<Vec<_>>().join(" ")
}

/// Columns and rows of an area.
fn size(area: Rect) -> (usize, usize) {
    (usize::from(area.width), usize::from(area.height))
}

//! Tornado of one value: for each input a bar by the forecast and one by checks, on one scale.

use super::super::text::{below, cut, heading, put, put_right};
use super::super::theme::Theme;
use super::{nothing, plan, value};
use crate::app::App;
use crate::app::studies::sensitivity::SensitivityView;
use crate::case::Input;
use crate::show::effect::{self, EffectScale};
use crate::show::picture::Ink;
use crate::show::say;
use crate::show::tornado::{self, Moves};
use crate::study::checks::{NoCheck, utilisation};
use crate::study::sensitivity::{Bar, Effect};
use crate::study::verdict::{Simulated, verdict};
use crate::units::{force_text, length_text};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

/// Lines of a tornado with its head: two an input.
const EACH: u16 = 15;
/// Columns from which the range of each input stands beside it.
const WITH_RANGES: u16 = 70;

/// Draws the page.
pub(crate) fn draw(app: &App, area: Rect, buf: &mut Buffer, theme: &Theme) {
    let name = &app.layout().name;
    let Some(view) = app.sensitivity() else {
        heading(buf, area, &format!("sensitivity of {name}"), "", theme);
        return nothing("the mesh of this layout is not known", area, buf, theme);
    };
    let title = format!("sensitivity of {name}: {}", title_of(view.effect, app));
    let asked = view.case.asked().force.is_some();
    heading(buf, area, &title, &value(view.effect, asked), theme);
    let mut rest = below(area, 1);
    let columns = usize::from(rest.width.saturating_sub(2));
    for (text, style) in top(app, view, theme) {
        put(buf, rest, 0, 1, &cut(&text, columns), style);
        rest = below(rest, 1);
    }
    if view.forecast.base.is_err() {
        return;
    }
    let notes = notes(app, view, theme);
    let room = if rest.height >= 12 { notes.len() as u16 + 1 } else { 1 };
    let table = Rect { height: rest.height.saturating_sub(room), ..rest };
    let others = Effect::all(asked).iter().copied();
    let mut left = table;
    for (place, effect) in
        std::iter::once(view.effect).chain(others.filter(|e| *e != view.effect)).enumerate()
    {
        // Where there is room the other values stand below the chosen one.
        if place > 0 {
            if left.height < EACH + 1 {
                break;
            }
            heading(buf, left, &title_of(effect, app), "", theme);
            left = below(left, 1);
        }
        let height = if place == 0 && table.height < 2 * EACH { left.height } else { EACH };
        draw_tornado(
            app,
            view,
            effect,
            Rect { height: height.min(left.height), ..left },
            buf,
            theme,
        );
        left = below(left, EACH);
    }
    let foot = below(rest, table.height);
    let first = foot.height.min(room).saturating_sub(notes.len() as u16);
    for (row, (text, style)) in notes.iter().enumerate() {
        put(buf, foot, first + row as u16, 1, &cut(text, columns), *style);
    }
}

fn title_of(shown: Effect, app: &App) -> String {
    format!("change of {}, {}", effect::symbol(shown), effect::unit(shown, app.units()))
}

/// What the layout itself gives, by the forecast and by its check.
fn top(app: &App, view: &SensitivityView, theme: &Theme) -> Vec<(String, Style)> {
    let m = |v: f64| length_text(v, app.units());
    let point = match &view.forecast.base {
        Ok(point) => point,
        Err(why) => {
            return vec![(why.sentence(), theme.caution)];
        }
    };
    let mut lines = vec![(format!("forecast {}", say::point(point, app.units())), theme.forecast)];
    let text = match &view.checked.base {
        Ok(result) if result.broke() => {
            let used = utilisation(&view.case.asked(), result.force.mean);
            let used = say::used(used);
            let (force, delta) = (result.force.mean, result.deflection.mean);
            format!("DEM      F   {}, delta   {}{used}", force_text(force, app.units()), m(delta))
        }
        Ok(_) => "DEM      no run broke a wire".to_string(),
        Err(NoCheck::NotMade) if view.coverage.stale => {
            "DEM      stale: of other inputs; c checks these, u undoes the edit".to_string()
        }
        Err(NoCheck::NotMade) => match app.campaign() {
            Some(_) => "DEM      on its way".to_string(),
            None => "DEM      not made; c checks the layout and every step".to_string(),
        },
        Err(why) => format!("DEM      none: {}", why.sentence()),
    };
    lines.push((text, if view.coverage.stale { theme.caution } else { theme.check }));
    lines
}

/// One line of the tornado.
struct Line {
    label: String,
    by: &'static str,
    moves: Moves,
    ink: Ink,
    /// Marks of the verdict with the input lowered and raised, where it fails or is doubtful.
    marks: [char; 2],
}

/// The lines of a tornado, one or two an input, with its largest change and how changes are written.
fn lines(
    app: &App,
    view: &SensitivityView,
    effect: Effect,
    wide: bool,
) -> (Vec<Line>, f64, EffectScale) {
    let both = view.coverage.any() || app.campaign().is_some();
    let checked = both.then_some(&view.checked);
    let most = tornado::most(&view.forecast, checked, effect);
    let scale = EffectScale::aligned(effect, app.units(), most);
    let rows = tornado::tornado(&view.forecast, checked, effect, &scale, app.units());
    let mut lines = Vec::new();
    for row in rows {
        let range = if wide { row.range.as_str() } else { "" };
        let by = match effect {
            Effect::Force => "F_a",
            Effect::Deflection => "d_a",
            Effect::Utilisation => "use",
            Effect::Service => "d_F",
        };
        let label = format!("{:<9}{range}", row.symbol);
        let marks = marks(app, view, row.input);
        lines.push(Line { label, by, moves: row.forecast, ink: Ink::Forecast, marks });
        if let Some(moves) = row.check {
            let label = String::new();
            lines.push(Line { label, by: "DEM", moves, ink: Ink::Check, marks: [' '; 2] });
        }
    }
    (lines, most, scale)
}

/// The marks of the verdicts, by the forecast, with an input lowered and raised.
fn marks(app: &App, view: &SensitivityView, input: Input) -> [char; 2] {
    let bar = view.forecast.bars.iter().find(|bar| bar.input == input);
    let Some(bar) = bar.filter(|_| view.case.question.asks()) else { return [' '; 2] };
    [&bar.lowered, &bar.raised].map(|step| {
        let case = view.case.with(input, step.value);
        let basis = app.project().basis;
        verdict(&case, &step.outcome, Simulated::Missing, basis).finding().mark()
    })
}

fn draw_tornado(
    app: &App,
    view: &SensitivityView,
    effect: Effect,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) {
    let wide = area.width >= WITH_RANGES;
    let (lines, most, scale) = lines(app, view, effect, wide);
    let label: u16 = if wide { 28 } else { 9 };
    let number: u16 = if wide { 9 } else { 7 };
    let start = label + 4 + 2 * number + 1;
    let half = area.width.saturating_sub(start + 2) / 2;
    let head = Rect { height: 1.min(area.height), ..area };
    put(buf, head, 0, 1, "input", theme.heading);
    let ends = format!("{:>w$}{:>w$}", "lowered", "raised", w = usize::from(number));
    put(buf, head, 0, label + 4, &ends, theme.heading);
    let list = below(area, 1);
    let rows = usize::from(list.height);
    let scrolled = lines.len() > rows;
    if half > 0 && !scrolled {
        let (left, right) = (format!("-{}", scale.size(most)), format!("+{}", scale.size(most)));
        put(buf, head, 0, start, &left, theme.heading);
        put(buf, head, 0, start + half, "0", theme.heading);
        put_right(buf, Rect { width: start + 2 * half + 1, ..head }, 0, &right, theme.heading);
    }
    let first = view.scroll.min(lines.len().saturating_sub(rows));
    for (row, line) in lines.iter().skip(first).take(rows).enumerate() {
        let row = row as u16;
        put(buf, list, row, 1, &cut(&line.label, usize::from(label)), theme.text);
        let style = theme.ink(line.ink);
        put(buf, list, row, label, line.by, style);
        for (at, text) in (1..).zip(&line.moves.texts) {
            let end = label + 4 + at * number;
            put_right(buf, Rect { width: end.min(list.width), ..list }, row, text, theme.text);
            // Behind the number; what passes is left unmarked.
            if let mark @ ('x' | '?') = line.marks[usize::from(at) - 1] {
                put(buf, list, row, end, &mark.to_string(), theme.caution);
            }
        }
        if half > 0 {
            let drawn = tornado::bars(line.moves.sizes, most, usize::from(half), theme.glyphs);
            put(buf, list, row, start, &drawn, style);
        }
    }
    if scrolled {
        let text =
            format!(" {}-{} of {} ", first + 1, (first + rows).min(lines.len()), lines.len());
        put(buf, head, 0, area.width.saturating_sub(text.len() as u16), &text, theme.title);
    }
}

fn notes(app: &App, view: &SensitivityView, theme: &Theme) -> Vec<(String, Style)> {
    let [lowered, raised, both, _] = tornado::signs(theme.glyphs);
    let offset =
        length_text(crate::study::sensitivity::OFFSET_STEP * view.case.layout.least(), app.units());
    let mut lines = vec![(
        format!(
            "{lowered} lowered {raised} raised {both} both; steps 10 %, of ex and ey {offset} (L/20)"
        ),
        theme.text,
    )];
    let fails = |bar: &Bar| marks(app, view, bar.input).contains(&'x');
    if view.forecast.bars.iter().any(fails) {
        lines.push(("x behind a change: with it the layout fails".into(), theme.text));
    }
    let coverage = view.coverage;
    if coverage.any() || app.campaign().is_some() {
        lines.push((
            format!(
                "DEM: {} of {} checks, {}; ~ may be chance",
                coverage.have,
                coverage.of,
                plan(&app.study_wanted())
            ),
            theme.check,
        ));
        lines.push((
            "none: the check takes its wires from the mesh, not from F_l* and delta_l*".into(),
            theme.text,
        ));
        let steps = view.checked.bars.iter().flat_map(|bar| [&bar.lowered, &bar.raised]);
        let why = steps.filter_map(|s| s.answer.as_ref().err()).find(|e| e.code() == "impossible");
        if let Some(why) = why {
            lines.push((format!("no: {}", why.sentence()), theme.caution));
        }
    }
    let notes = tornado::notes(&view.forecast).into_iter();
    lines.extend(notes.map(|(head, text)| (format!("{head}: {text}"), theme.caution)));
    lines
}

//! Tornado of one value: for each input a bar by the forecast and one by checks, on one scale.

use super::super::text::{below, cut, heading, put, put_right};
use super::super::theme::Theme;
use super::{nothing, plan, symbol, unit_of, value};
use crate::app::App;
use crate::app::look::Glyphs;
use crate::app::studies::sensitivity::SensitivityView;
use crate::study::case::{NoValue, input_unit, input_value};
use crate::study::checks::NoCheck;
use crate::study::sensitivity::dem::CheckedStep;
use crate::study::sensitivity::scale::EffectScale;
use crate::study::sensitivity::{Bar, Effect, Step};
use crate::units::{LengthUnit, force_text, length_text, percent};
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
    let unit = unit_of(view.effect, app.units());
    let title = format!("sensitivity of {name}: change of {}, {unit}", symbol(view.effect));
    heading(buf, area, &title, value(view.effect), theme);
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
    let asked = view.case.question.force.is_some();
    let all = [Effect::Force, Effect::Deflection, Effect::Utilisation];
    let others = all.into_iter().filter(|e| asked || *e != Effect::Utilisation);
    let mut left = table;
    for (place, effect) in
        std::iter::once(view.effect).chain(others.filter(|e| *e != view.effect)).enumerate()
    {
        // Where there is room the other values stand below the chosen one.
        if place > 0 {
            if left.height < EACH + 1 {
                break;
            }
            let unit = unit_of(effect, app.units());
            let title = format!("change of {}, {unit}", symbol(effect));
            heading(buf, left, &title, "", theme);
            left = below(left, 1);
        }
        let height = if place == 0 && table.height < 2 * EACH { left.height } else { EACH };
        tornado(app, view, effect, Rect { height: height.min(left.height), ..left }, buf, theme);
        left = below(left, EACH);
    }
    let foot = below(rest, table.height);
    let first = foot.height.min(room).saturating_sub(notes.len() as u16);
    for (row, (text, style)) in notes.iter().enumerate() {
        put(buf, foot, first + row as u16, 1, &cut(text, columns), *style);
    }
}

/// What the layout itself gives, by the forecast and by its check.
fn top(app: &App, view: &SensitivityView, theme: &Theme) -> Vec<(String, Style)> {
    let m = |v: f64| length_text(v, app.units());
    let point = match &view.forecast.base {
        Ok(point) => point,
        Err(why) => {
            let text = match why {
                NoValue::PunchOnPlate => {
                    "no value, and so no sensitivity: the punch is on a plate".to_string()
                }
                NoValue::Senseless(problems) => {
                    problems.first().map_or(String::new(), |p| p.to_string())
                }
            };
            return vec![(text, theme.caution)];
        }
    };
    let used = |u: Option<f64>| u.map_or(String::new(), |u| format!(", use {} %", percent(u)));
    let v = point.values();
    let text = format!(
        "forecast F_a {}, delta_a {}{}",
        force_text(v.force),
        m(v.deflection),
        used(point.utilisation())
    );
    let mut lines = vec![(text, theme.forecast)];
    let text = match &view.checked.base {
        Ok(result) if result.broke() => {
            let used =
                used(crate::study::checks::utilisation(&view.case.question, result.force.mean));
            let (force, delta) = (result.force.mean, result.deflection.mean);
            format!("DEM      F   {}, delta   {}{used}", force_text(force), m(delta))
        }
        Ok(_) => "DEM      no run broke a wire".to_string(),
        Err(NoCheck::NotMade) if view.coverage.stale => {
            "DEM      stale: of other inputs; c checks these, u undoes the edit".to_string()
        }
        Err(NoCheck::NotMade) => match app.campaign() {
            Some(_) => "DEM      on its way".to_string(),
            None => "DEM      not made; c checks the layout and every step".to_string(),
        },
        Err(why) => format!("DEM      none: {}", why.reason()),
    };
    lines.push((text, if view.coverage.stale { theme.caution } else { theme.check }));
    lines
}

/// One line of the tornado.
struct Line {
    label: String,
    by: &'static str,
    low: String,
    high: String,
    sizes: [Option<f64>; 2],
    style: Style,
}

fn tornado(
    app: &App,
    view: &SensitivityView,
    effect: Effect,
    area: Rect,
    buf: &mut Buffer,
    theme: &Theme,
) {
    let unit = app.units();
    let bars = view.forecast.by(effect);
    let by_check = view.checked.bars.iter().map(|bar| bar.largest(effect)).fold(0.0, f64::max);
    let most = bars.first().map_or(0.0, |bar| bar.largest(effect)).max(by_check);
    let scale = EffectScale::new(effect, unit, most);
    let wide = area.width >= WITH_RANGES;
    let mut lines = Vec::new();
    let both = view.coverage.any() || app.campaign().is_some();
    for bar in bars {
        let range = if wide { range(bar, unit) } else { String::new() };
        lines.push(Line {
            label: format!("{:<9}{range}", bar.input.symbol()),
            by: "F_a",
            low: forecast(&bar.lowered, effect, &scale),
            high: forecast(&bar.raised, effect, &scale),
            sizes: [&bar.lowered, &bar.raised].map(|s| s.change.and_then(|c| c.of(effect))),
            style: theme.forecast,
        });
        let Some(other) = view.checked.bar(bar.input).filter(|_| both) else { continue };
        let of = |s: &CheckedStep| s.change.and_then(|c| c.of(effect)).map(|known| known.value);
        lines.push(Line {
            label: String::new(),
            by: "DEM",
            low: found(&other.lowered, &scale),
            high: found(&other.raised, &scale),
            sizes: [of(&other.lowered), of(&other.raised)],
            style: theme.check,
        });
    }
    if effect == Effect::Deflection {
        lines.iter_mut().filter(|l| l.by == "F_a").for_each(|l| l.by = "d_a");
    } else if effect == Effect::Utilisation {
        lines.iter_mut().filter(|l| l.by == "F_a").for_each(|l| l.by = "use");
    }
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
        put(buf, list, row, label, line.by, line.style);
        for (at, text) in [(0, &line.low), (1, &line.high)] {
            let end = label + 4 + (at + 1) * number;
            put_right(buf, Rect { width: end.min(list.width), ..list }, row, text, theme.text);
        }
        if half > 0 {
            let drawn = drawing(line.sizes, most, usize::from(half), theme.glyphs);
            put(buf, list, row, start, &drawn, line.style);
        }
    }
    if scrolled {
        let text =
            format!(" {}-{} of {} ", first + 1, (first + rows).min(lines.len()), lines.len());
        put(buf, head, 0, area.width.saturating_sub(text.len() as u16), &text, theme.title);
    }
}

fn range(bar: &Bar, unit: LengthUnit) -> String {
    let value = |v: f64| input_value(bar.input, v, unit);
    let symbol = input_unit(bar.input, unit);
    format!("{} to {} {symbol}", value(bar.lowered.value), value(bar.raised.value))
}

/// A change by the forecast in words; `*` where the branch changes.
fn forecast(step: &Step, effect: Effect, scale: &EffectScale) -> String {
    match (&step.change, &step.outcome) {
        (Some(change), _) => {
            let mark = if change.other_branch { "*" } else { " " };
            change.of(effect).map_or(String::new(), |c| scale.text(c) + mark)
        }
        (None, Err(why)) => why.short().to_string(),
        (None, Ok(_)) => "- ".to_string(),
    }
}

/// A change by checks in words; `~` where it may be chance.
fn found(step: &CheckedStep, scale: &EffectScale) -> String {
    match (step.change.and_then(|c| c.of(scale.effect)), &step.answer) {
        (Some(known), _) => scale.text(known.value) + if known.doubtful() { "~" } else { " " },
        (None, Err(NoCheck::NotMade)) => ". ".to_string(),
        (None, Err(NoCheck::Laboratory)) => "none ".to_string(),
        (None, Err(_)) => "no ".to_string(),
        (None, Ok(_)) => "- ".to_string(),
    }
}

/// The two bars from the middle to both sides, as signs that read without colour: the lower half of
/// the line for lowered, the upper half for raised, the whole for both.
fn drawing(changes: [Option<f64>; 2], most: f64, half: usize, glyphs: Glyphs) -> String {
    let [low, high] = changes.map(|change| {
        // At most `half` by the choice of `most`.
        if most > 0.0 { (change.unwrap_or(0.0) / most * half as f64).round() as isize } else { 0 }
    });
    let covers = |end: isize, at: isize| {
        if end < 0 { (end..0).contains(&at) } else { (1..=end).contains(&at) }
    };
    let [lowered, raised, both, middle] = signs(glyphs);
    let half = half as isize;
    (-half..=half)
        .map(|at| match (at, covers(low, at), covers(high, at)) {
            (0, ..) => middle,
            (_, true, true) => both,
            (_, true, false) => lowered,
            (_, false, true) => raised,
            _ => ' ',
        })
        .collect()
}

/// Signs of a bar: lowered, raised, both, and the middle.
fn signs(glyphs: Glyphs) -> [char; 4] {
    match glyphs {
        Glyphs::Ascii => ['-', '=', '#', '|'],
        _ => ['▄', '▀', '█', '│'],
    }
}

fn notes(app: &App, view: &SensitivityView, theme: &Theme) -> Vec<(String, Style)> {
    let [lowered, raised, both, _] = signs(theme.glyphs);
    let offset =
        length_text(crate::study::sensitivity::OFFSET_STEP * view.case.layout.spacing, app.units());
    let mut lines = vec![(
        format!(
            "{lowered} lowered {raised} raised {both} both; steps 10 %, of ex and ey {offset} (L/20)"
        ),
        theme.text,
    )];
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
            lines.push((format!("no: {}", why.reason()), theme.caution));
        }
    }
    let steps = || view.forecast.bars.iter().flat_map(|bar| [&bar.lowered, &bar.raised]);
    if steps().any(|s| s.change.is_some_and(|c| c.other_branch)) {
        let text = "* the step goes over the branch change at D = d, where A.1 and A.2 jump";
        lines.push((text.into(), theme.caution));
    }
    for (code, text) in [
        ("punch_on_plate", "on plate: the step takes the punch onto an anchor plate"),
        ("senseless", "no sense: plate and punch must be smaller than the spacing"),
    ] {
        if steps().any(|s| s.outcome.as_ref().is_err_and(|e| e.code() == code)) {
            lines.push((text.into(), theme.caution));
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_run_from_the_middle_and_read_without_colour() {
        let ascii = |low, high| drawing([low, high], 1.0, 4, Glyphs::Ascii);
        assert_eq!(ascii(Some(-1.0), Some(0.5)), "----|==  ");
        assert_eq!(ascii(Some(1.0), Some(0.5)), "    |##--");
        assert_eq!(ascii(None, None), "    |    ");
        assert_eq!(drawing([Some(-1.0), Some(1.0)], 1.0, 2, Glyphs::Block), "▄▄│▀▀");
        assert_eq!(drawing([Some(1.0), None], 0.0, 1, Glyphs::Ascii), " | ");
    }
}

//! Force over deflection: one layout with everything that belongs to it, or several together.

use super::drawing::{Anchor, Drawing, Frame, Stroke, TEXT};
use super::frame::ChartPlane;
use super::labels::Labels;
use super::legend::{self, LegendEntry};
use super::marks::{self, Mark};
use crate::curve::{Curve, Point};
use crate::export::{Check, ExportedLayout};
use crate::forecast::design::Question;
use crate::forecast::{Field, Strength, Values, rescaled};
use crate::units::{Units, force_text, length_entry, length_text, shortest};

/// A layout in a chart, with its check if there is one.
#[derive(Debug, Clone, Copy)]
pub struct Series<'a> {
    /// The layout.
    pub case: &'a ExportedLayout,
    /// The check that is drawn over the forecast.
    pub check: Option<&'a Check>,
}

impl Series<'_> {
    /// Whether a chart of it would show no line: neither laboratory nor panel has a deflection, and there
    /// is no check.
    pub(crate) fn bare(&self) -> bool {
        self.check.is_none() && self.case.forecast().laboratory.deflection.is_none()
    }
}

impl<'a> From<&'a ExportedLayout> for Series<'a> {
    fn from(case: &'a ExportedLayout) -> Series<'a> {
        Series { case, check: None }
    }
}

/// Points that a forecast curve is drawn through.
const POINTS: usize = 81;
/// Width of a chart, in units of the picture.
const WIDTH: f64 = 760.0;
/// Left and right edge of the plot.
const EDGES: (f64, f64) = (76.0, WIDTH - 24.0);
/// Height of the plot.
const HEIGHT: f64 = 400.0;

/// Draws the chart: one layout with laboratory test, design values and the other branch where it is
/// flagged, or the forecasts of several with their checks. Lengths are shown in `unit`.
pub fn chart(series: &[Series<'_>], title: &str, unit: Units) -> String {
    let mut content = Content::default();
    match series {
        [one] => single(&mut content, one, unit),
        all => several(&mut content, all, unit),
    }
    content.draw(title, unit)
}

/// A line with its sign and its word.
struct Line {
    points: Vec<Point>,
    stroke: Stroke,
    end: Option<(Mark, Point)>,
    tag: String,
}

/// A design value.
struct Level {
    /// Force, N, or deflection, m.
    value: f64,
    /// Whether it is a force, a level line; else an upright one.
    force: bool,
    stroke: Stroke,
    words: String,
    /// Its place in the legend.
    entry: usize,
}

/// What stands in a chart, in the order in which it is drawn.
#[derive(Default)]
struct Content {
    bands: Vec<Vec<Point>>,
    lines: Vec<Line>,
    levels: Vec<Level>,
    breaks: Vec<Point>,
    legend: Vec<LegendEntry>,
    /// A sentence across the plot where there is nothing else to see.
    remark: Option<&'static str>,
    /// The axes end at these where they are set, and lines beyond leave the plot.
    largest: Option<Point>,
}

impl Content {
    fn line(&mut self, curve: &Curve, stroke: Stroke, mark: Mark, tag: &str, words: String) {
        self.legend.push(LegendEntry {
            line: Some(stroke),
            mark: curve.failure.map(|_| mark),
            band: false,
            tag: tag_of_legend(tag),
            words,
        });
        self.lines.push(Line {
            points: curve.points().collect(),
            stroke,
            end: curve.failure.map(|end| (mark, end)),
            tag: tag.to_string(),
        });
    }

    fn words(&mut self, tag: &str, words: String) {
        let tag = tag_of_legend(tag);
        self.legend.push(LegendEntry { line: None, mark: None, band: false, tag, words });
    }

    fn level(&mut self, force: bool, value: f64, stroke: Stroke, words: String) {
        let entry = self.legend.len();
        self.legend.push(LegendEntry {
            line: Some(stroke),
            mark: None,
            band: false,
            tag: String::new(),
            words: words.clone(),
        });
        self.levels.push(Level { value, force, stroke, words, entry });
    }

    fn check(&mut self, check: &Check, stroke: Stroke, tag: &str, unit: Units) {
        if let Some(band) = &check.band {
            let edge = |forces: &[f64]| -> Vec<Point> {
                let pairs = band.deflection.iter().zip(forces);
                pairs.map(|(&deflection, &force)| Point { deflection, force }).collect()
            };
            let mut around = edge(&band.low);
            around.extend(edge(&band.high).into_iter().rev());
            self.bands.push(around);
        }
        let at_break = check.mean.failure.map_or(String::new(), |p| {
            format!(
                ": first break at {}, {}",
                force_text(p.force, unit),
                length_text(p.deflection, unit)
            )
        });
        let band = if check.band.is_some() { "; shaded: its band" } else { "" };
        let breaks = if check.breaks.is_empty() { "" } else { "; small x: first break of a run" };
        let words = format!("{}{at_break}{band}{breaks}", check.title());
        self.line(&check.mean, stroke, Mark::Diamond, tag, words);
        if let Some(entry) = self.legend.last_mut() {
            entry.band = check.band.is_some();
        }
        self.breaks.extend(&check.breaks);
    }

    /// Between which 90 % of the simulated curves lie, where the method is a derived one.
    fn envelope(&mut self, field: &Field) {
        let Some(edges) = field.envelope() else { return };
        let words = "90 % of the simulated curves, over their own ends".to_string();
        let (line, tag) = (Some(marks::ENVELOPE), String::new());
        self.legend.push(LegendEntry { line, mark: None, band: false, tag, words });
        self.lines.extend(edges.iter().map(|edge| Line {
            points: edge.points().collect(),
            stroke: marks::ENVELOPE,
            end: None,
            tag: String::new(),
        }));
    }

    /// The point that the axes must hold.
    fn extent(&self) -> Point {
        if let Some(largest) = self.largest {
            return largest;
        }
        let mut most = Point::default();
        let mut take = |p: &Point| {
            most.deflection = most.deflection.max(p.deflection);
            most.force = most.force.max(p.force);
        };
        self.bands.iter().flatten().for_each(&mut take);
        self.lines.iter().flat_map(|l| &l.points).for_each(&mut take);
        self.breaks.iter().for_each(&mut take);
        // A design value far beyond everything else is named in the legend: curves stay readable.
        let (force, deflection) = (most.force, most.deflection);
        for level in &self.levels {
            if level.force && level.value < 1.6 * force {
                most.force = most.force.max(level.value);
            } else if !level.force && level.value < 1.6 * deflection {
                most.deflection = most.deflection.max(level.value);
            }
        }
        most
    }

    fn draw(&self, title: &str, unit: Units) -> String {
        let mut drawing = Drawing::new(WIDTH);
        let mut top = 24.0;
        for line in legend::wrapped(title, WIDTH - 24.0) {
            drawing.bold((12.0, top), Anchor::Start, TEXT + 1.0, &line);
            top += 20.0;
        }
        let frame = Frame { left: EDGES.0, top, right: EDGES.1, bottom: top + HEIGHT };
        let most = self.extent();
        let plane = ChartPlane::holding(frame, most.deflection, most.force, unit);
        plane.draw(&mut drawing);
        let mut labels = Labels::new(frame);
        for band in &self.bands {
            let around: Vec<_> = band.iter().map(|p| clamped(plane.at(*p), &frame)).collect();
            drawing.area(&around, marks::FILL, marks::BAND);
        }
        for level in &self.levels {
            Self::level_line(level, &plane, &mut drawing, &mut labels);
        }
        for line in &self.lines {
            let points: Vec<_> = line.points.iter().map(|p| plane.at(*p)).collect();
            for piece in frame.pieces(&points) {
                drawing.line(&piece, line.stroke);
                labels.avoid(&piece);
            }
        }
        for point in self.breaks.iter().filter(|p| plane.holds(**p)) {
            Mark::Cross.draw(&mut drawing, plane.at(*point), 5.0, marks::CHECK);
        }
        for line in &self.lines {
            if let Some((mark, end)) = line.end
                && plane.holds(end)
            {
                mark.draw(&mut drawing, plane.at(end), 10.0, line.stroke);
                labels.avoid_point(plane.at(end), 6.0);
            }
        }
        self.tags(&plane, &mut drawing, &mut labels);
        if let Some(remark) = self.remark {
            let corner = (frame.left + 16.0, frame.top + 34.0);
            drawing.bold(corner, Anchor::Start, TEXT + 1.0, remark);
        }
        let entries = self.legend_on(&plane);
        let below = legend::draw(&mut drawing, &entries, EDGES.0, EDGES.1, frame.bottom + 58.0);
        let description = entries.iter().map(said).collect::<Vec<_>>().join(". ");
        drawing.finish(below + 12.0, title, &description)
    }

    /// The legend; a design value that is not drawn says so.
    fn legend_on(&self, plane: &ChartPlane) -> Vec<LegendEntry> {
        let mut entries = self.legend.clone();
        for level in &self.levels {
            let end = if level.force { plane.largest_force() } else { plane.last_deflection() };
            if level.value > end
                && let Some(entry) = entries.get_mut(level.entry)
            {
                entry.words.push_str(" (beyond the chart)");
            }
        }
        entries
    }

    fn level_line(level: &Level, plane: &ChartPlane, drawing: &mut Drawing, labels: &mut Labels) {
        let (last, largest) = (plane.last_deflection(), plane.largest_force());
        let ends = if level.force {
            [
                Point { deflection: 0.0, force: level.value },
                Point { deflection: last, force: level.value },
            ]
        } else {
            [
                Point { deflection: level.value, force: 0.0 },
                Point { deflection: level.value, force: largest },
            ]
        };
        if ends.iter().all(|p| plane.holds(*p)) {
            let ends = ends.map(|p| plane.at(p));
            drawing.line(&ends, level.stroke);
            labels.avoid(&ends);
        }
    }

    /// The words inside the plot, once every line is known.
    fn tags(&self, plane: &ChartPlane, drawing: &mut Drawing, labels: &mut Labels) {
        for line in self.lines.iter().filter(|line| !line.tag.is_empty()) {
            if let Some((_, end)) = line.end
                && plane.holds(end)
            {
                labels.beside(drawing, plane.at(end), &line.tag);
            }
        }
        for level in &self.levels {
            let at = plane.at(Point { deflection: level.value, force: level.value });
            if level.force && level.value <= plane.largest_force() {
                labels.along(drawing, at.1, &level.words);
            } else if !level.force && level.value <= plane.last_deflection() {
                labels.upright(drawing, at.0, &level.words);
            }
        }
    }
}

/// Numbers stand in front of a legend's words; names of curves are words themselves.
fn tag_of_legend(tag: &str) -> String {
    if tag.chars().all(|c| c.is_ascii_digit()) { tag.to_string() } else { String::new() }
}

fn said(entry: &LegendEntry) -> String {
    if entry.tag.is_empty() {
        entry.words.clone()
    } else {
        format!("{} {}", entry.tag, entry.words)
    }
}

fn clamped((x, y): (f64, f64), frame: &Frame) -> (f64, f64) {
    (x.clamp(frame.left, frame.right), y.clamp(frame.top, frame.bottom))
}

fn at_failure(values: Values, unit: Units) -> String {
    format!("{} at {}", force_text(values.force, unit), length_text(values.deflection, unit))
}

/// One layout and everything that belongs to it.
fn single(content: &mut Content, series: &Series<'_>, unit: Units) {
    let case = series.case;
    let forecast = &case.forecast();
    match &forecast.field {
        Ok(field) => {
            let mark = if forecast.extrapolated() { ", extrapolated" } else { "" };
            let words = format!("forecast: failure at {}{mark}", pair(field.values, unit));
            match field.end() {
                Some(end) => {
                    let curve = end.curve(POINTS);
                    content.line(&curve, marks::FORECAST, Mark::Cross, "forecast", words);
                    content.envelope(field);
                }
                None => {
                    content.remark = Some(STRENGTH_ONLY);
                    content.words("", format!("{words}; {STRENGTH_ONLY}"));
                }
            }
            if let Some(other) = field.other_branch.and_then(Strength::both) {
                let relation = field.branch.other().word().replace('_', " ");
                let words = format!(
                    "forecast by the other branch ({relation}), near the branch change at D = d: {}",
                    at_failure(other, unit)
                );
                let curve = rescaled(other, POINTS);
                content.line(&curve, marks::OTHER, Mark::Square, "other branch", words);
            }
        }
        Err(why) => {
            let remark = why.sentence();
            content.remark = Some(remark);
            content.words("", format!("forecast: {remark}"));
        }
    }
    if let Some(check) = series.check {
        content.check(check, marks::CHECK, "check", unit);
    }
    if let Some(laboratory) = forecast.laboratory.both() {
        let words = laboratory_words(laboratory, unit);
        let curve = rescaled(laboratory, POINTS);
        content.line(&curve, marks::LABORATORY, Mark::Ring, "laboratory", words);
    }
    design(content, case, unit);
}

/// What stands in a chart instead of a curve.
const STRENGTH_ONLY: &str = "no curve: the laboratory record has no deflection";

fn pair(values: Strength, unit: Units) -> String {
    let delta = values.deflection.map(|delta| format!(", {}", length_text(delta, unit)));
    force_text(values.force, unit) + &delta.unwrap_or_default()
}

fn laboratory_words(laboratory: Values, unit: Units) -> String {
    format!(
        "laboratory test, standard panel: {} (only its end point was published; the shape is that of Eq. 3)",
        at_failure(laboratory, unit)
    )
}

/// Design force, allowable deflection, and with a factor on it the resistance.
fn design(content: &mut Content, case: &ExportedLayout, unit: Units) {
    let question = &case.case.asked();
    demand(content, question, unit);
    if question.force.is_some()
        && question.gamma_resistance != 1.0
        && let Some(design) = &case.design()
    {
        let words = format!(
            "design resistance, failure force / {} = {}",
            shortest(question.gamma_resistance),
            force_text(design.resistance, unit)
        );
        content.level(true, design.resistance, marks::RESISTANCE, words);
    }
    allowed(content, question, unit);
}

/// What is asked of all layouts alike.
fn asked_of_all(content: &mut Content, all: &[Series<'_>], unit: Units) {
    let Some(first) = all.first().map(|series| series.case.case.asked()) else { return };
    let alike =
        |same: &dyn Fn(&Question) -> bool| all.iter().all(|series| same(&series.case.case.asked()));
    if alike(&|asked| asked.force == first.force && asked.gamma_load == first.gamma_load) {
        demand(content, &first, unit);
    }
    if alike(&|asked| asked.deflection == first.deflection) {
        allowed(content, &first, unit);
    }
}

/// The design force, with its factor.
fn demand(content: &mut Content, question: &Question, unit: Units) {
    if let Some(force) = question.force {
        let load = force * question.gamma_load;
        let words = if question.gamma_load == 1.0 {
            format!("design force {}", force_text(load, unit))
        } else {
            let factor = shortest(question.gamma_load);
            format!(
                "design force {} x {factor} = {}",
                force_text(force, unit),
                force_text(load, unit)
            )
        };
        content.level(true, load, marks::DESIGN, words);
    }
}

/// The allowed deflection.
fn allowed(content: &mut Content, question: &Question, unit: Units) {
    if let Some(deflection) = question.deflection {
        let words =
            format!("allowable deflection {} {}", length_entry(deflection, unit), unit.symbol());
        content.level(false, deflection, marks::ALLOWABLE, words);
    }
}

/// The forecasts of several layouts, told apart by dashes, sign and number.
fn several(content: &mut Content, all: &[Series<'_>], unit: Units) {
    for (index, series) in all.iter().enumerate() {
        let (stroke, mark) = marks::nth(index);
        let tag = (index + 1).to_string();
        let name = &series.case.entry.name;
        match &series.case.forecast().field {
            Ok(field) => {
                let far = if series.case.forecast().extrapolated() { ", extrapolated" } else { "" };
                match field.end() {
                    Some(end) => {
                        let words = format!("{name}: {}{far}", at_failure(end, unit));
                        content.line(&end.curve(POINTS), stroke, mark, &tag, words);
                    }
                    None => {
                        let force = pair(field.values, unit);
                        content.words(&tag, format!("{name}: {force}{far}; {STRENGTH_ONLY}"));
                    }
                }
            }
            Err(why) => content.words(&tag, format!("{name}: {}", why.sentence())),
        }
        if let Some(check) = series.check {
            content.check(check, Stroke { width: 1.2, ..marks::CHECK }, &tag, unit);
        }
    }
    asked_of_all(content, all, unit);
    let most = content.extent();
    // One laboratory test for all is a useful scale. It is far above the field's forces and leaves
    // the plot at its upper edge.
    let mut tests = all.iter().map(|s| s.case.forecast().laboratory);
    if let Some(first) = tests.next()
        && tests.all(|other| other == first)
        && let Some(first) = first.both()
    {
        let curve = rescaled(first, POINTS);
        let mut words = laboratory_words(first, unit);
        if most.force > 0.0 && first.force > most.force {
            words.push_str("; it leaves the chart");
        }
        content.line(&curve, marks::LABORATORY, Mark::Ring, "laboratory", words);
        if most.force > 0.0 {
            let deflection = most.deflection.max(first.deflection);
            content.largest = Some(Point { deflection, force: most.force });
        }
    }
}

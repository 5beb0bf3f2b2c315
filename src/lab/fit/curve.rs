//! A laboratory's curve as a table of text: a header that names deflection and force with their units, then
//! a point a line. Gaps are left out, noise is averaged, what comes behind the largest force is cut off.

use crate::curve::Point;
use crate::problem::Problem;
use crate::units::{shortest, significant, to_kn};
use std::ops::RangeInclusive;

/// Points that a curve needs.
pub(crate) const FEWEST: usize = 8;
/// Fall before the largest force, over that force, that is still noise.
const NOISE: f64 = 0.15;
/// Step back of the deflection, over its span, that is still noise.
const STEP_BACK: f64 = 0.02;
/// Largest forces, N, and deflections, m, that a punch test of a mesh has.
const FORCES: RangeInclusive<f64> = 500.0..=2.0e6;
const DEFLECTIONS: RangeInclusive<f64> = 0.02..=5.0;

/// A curve as it was read.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LabCurve {
    /// Its points up to the largest force, SI, by deflection.
    pub(crate) points: Vec<Point>,
    /// Lines that had no number in a column.
    pub(crate) gaps: usize,
    /// Points behind the largest force, left out.
    pub(crate) behind: usize,
}

/// A column: its number, the word of the header, and its unit's word and size.
struct Column {
    number: usize,
    head: String,
    unit: &'static str,
    size: f64,
}

/// Units by their word, lower case but for what differs by it, and their size in SI.
const LENGTHS: [(&str, f64); 3] = [("mm", 1.0e-3), ("cm", 1.0e-2), ("m", 1.0)];
const FORCE_UNITS: [(&str, f64); 3] = [("kn", 1.0e3), ("n", 1.0), ("mn", 1.0e6)];

impl LabCurve {
    /// Reads a table. Problems name the line as their field.
    ///
    /// # Errors
    /// The first thing that is wrong.
    pub(crate) fn read(text: &str) -> Result<LabCurve, Problem> {
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(k, line)| (k + 1, line.trim_start_matches('\u{feff}').trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let Some((number, head)) = lines.next() else {
            return Err(Problem::new("line 1", "the file is empty").allowed(HEADER));
        };
        let separator = [';', '\t', ','].into_iter().find(|c| head.contains(*c)).unwrap_or(',');
        let heads: Vec<&str> = head.split(separator).map(str::trim).collect();
        let x =
            column(number, &heads, &["deflection", "displacement", "delta", "travel"], &LENGTHS)?;
        let y = column(number, &heads, &["force", "load", "f"], &FORCE_UNITS)?;
        let mut rows: Vec<(usize, Point)> = Vec::new();
        let mut gaps = 0;
        for (line, text) in lines {
            let cells: Vec<&str> = text.split(separator).map(str::trim).collect();
            let value = |c: &Column| number_in(line, c, cells.get(c.number).copied(), separator);
            match (value(&x)?, value(&y)?) {
                (Some(deflection), Some(force)) => rows.push((line, Point { deflection, force })),
                _ => gaps += 1,
            }
        }
        Self::of(rows, gaps, [&x, &y])
    }

    fn of(
        rows: Vec<(usize, Point)>,
        gaps: usize,
        [x, y]: [&Column; 2],
    ) -> Result<LabCurve, Problem> {
        if rows.len() < FEWEST {
            return Err(Problem::new(
                "",
                format!("a curve of {} points says too little", rows.len()),
            )
            .allowed(format!("{FEWEST} points and more, each with deflection and force")));
        }
        let most = |of: fn(&Point) -> f64| rows.iter().map(|(_, p)| of(p)).fold(0.0, f64::max);
        let (span, peak) = (most(|p| p.deflection), most(|p| p.force));
        if !DEFLECTIONS.contains(&span) {
            return Err(outside(x, span / x.size, &DEFLECTIONS, "largest deflection"));
        }
        if !FORCES.contains(&peak) {
            return Err(outside(y, peak / y.size, &FORCES, "largest force"));
        }
        let (mut far, mut high) = (0.0_f64, 0.0_f64);
        for (line, p) in &rows {
            if p.deflection < far - STEP_BACK * span {
                return Err(Problem::new(
                    format!("line {line}, {}", x.head),
                    format!("the deflection goes back from {} {}", shortest(far / x.size), x.unit),
                )
                .value(format!("{} {}", shortest(p.deflection / x.size), x.unit))
                .allowed("deflections that rise from line to line")
                .advice("one unit for the whole column, and one test for a file"));
            }
            if p.force < high - NOISE * peak && high < peak {
                return Err(falls(*line, y, p, high));
            }
            (far, high) = (far.max(p.deflection), high.max(p.force));
        }
        let at = rows.iter().position(|(_, p)| p.force == peak).unwrap_or(rows.len() - 1);
        if at + 1 < FEWEST {
            let (line, p) = rows[rows.len() - 1];
            return Err(falls(line, y, &p, peak));
        }
        let behind = rows.len() - 1 - at;
        let mut points: Vec<Point> = rows[..=at].iter().map(|(_, p)| *p).collect();
        points.sort_by(|a, b| a.deflection.total_cmp(&b.deflection));
        Ok(LabCurve { points, gaps, behind })
    }

    /// Its end: the largest force.
    pub(crate) fn end(&self) -> Point {
        self.points.last().copied().unwrap_or_default()
    }

    /// The force at so many even parts of the end's deflection, the end left out: each the line through the
    /// points near it, or nothing where there are none.
    pub(crate) fn levels(&self, count: usize) -> Vec<Point> {
        let end = self.end().deflection;
        let width = 0.5 * end / (count + 1) as f64;
        (1..=count)
            .filter_map(|k| {
                let at = end * k as f64 / (count + 1) as f64;
                let near: Vec<&Point> =
                    self.points.iter().filter(|p| (p.deflection - at).abs() <= width).collect();
                let force = through(&near, at).or_else(|| self.between(at))?;
                (force > 0.0).then_some(Point { deflection: at, force })
            })
            .collect()
    }

    /// Between the two points around a deflection, if they are not too far apart.
    fn between(&self, at: f64) -> Option<f64> {
        let k = self.points.partition_point(|p| p.deflection < at);
        let (a, b) = (self.points.get(k.checked_sub(1)?)?, self.points.get(k)?);
        let apart = b.deflection - a.deflection;
        let close = apart > 0.0 && apart <= 0.15 * self.end().deflection;
        close.then(|| a.force + (b.force - a.force) * (at - a.deflection) / apart)
    }
}

/// The least-squares line through three points and more, read at `at`.
fn through(points: &[&Point], at: f64) -> Option<f64> {
    if points.len() < 3 {
        return None;
    }
    let n = points.len() as f64;
    let x = points.iter().map(|p| p.deflection).sum::<f64>() / n;
    let y = points.iter().map(|p| p.force).sum::<f64>() / n;
    let top: f64 = points.iter().map(|p| (p.deflection - x) * (p.force - y)).sum();
    let bottom: f64 = points.iter().map(|p| (p.deflection - x) * (p.deflection - x)).sum();
    (bottom > 0.0).then(|| y + top / bottom * (at - x))
}

/// What a header looks like.
const HEADER: &str = "a header such as deflection_mm,force_kN or deflection [m];force [N]";

fn falls(line: usize, y: &Column, p: &Point, high: f64) -> Problem {
    Problem::new(
        format!("line {line}, {}", y.head),
        format!(
            "the force falls by more than noise before its largest value, from {} {}",
            significant(high / y.size, 4),
            y.unit
        ),
    )
    .value(format!("{} {}", significant(p.force / y.size, 4), y.unit))
    .allowed("a force that rises to failure; what comes behind the largest one is left out")
    .advice("one test for a file, deflection and force not exchanged")
}

fn outside(c: &Column, value: f64, range: &RangeInclusive<f64>, what: &str) -> Problem {
    Problem::new(c.head.clone(), format!("no punch test has such a {what}"))
        .value(format!("{} {}", significant(value, 4), c.unit))
        .allowed(format!(
            "{} to {} {}",
            shortest(range.start() / c.size),
            shortest(range.end() / c.size),
            c.unit
        ))
        .advice("see whether the header's unit is that of the column")
}

/// The column whose head begins with one of these words, with a unit behind it.
fn column(
    line: usize,
    heads: &[&str],
    words: &[&str],
    units: &'static [(&'static str, f64)],
) -> Result<Column, Problem> {
    let field = format!("line {line}");
    let letters = |head: &str| -> Vec<String> {
        let parts = head.split(|c: char| !c.is_alphabetic());
        parts.filter(|p| !p.is_empty()).map(str::to_lowercase).collect()
    };
    let found = heads.iter().position(|head| {
        letters(head).first().is_some_and(|first| words.contains(&first.as_str()))
    });
    let Some(number) = found else {
        return Err(Problem::new(field, format!("no column is called {}", words[0]))
            .value(heads.join(", "))
            .allowed(HEADER));
    };
    let unit = letters(heads[number]).into_iter().skip(1).next_back().unwrap_or_default();
    let Some((unit, size)) = units.iter().find(|(word, _)| *word == unit) else {
        let known: Vec<&str> = units.iter().map(|(word, _)| shown(word)).collect();
        return Err(Problem::new(
            field,
            format!("the unit of {} is missing or not known", words[0]),
        )
        .value(heads[number])
        .allowed(format!("{}; {HEADER}", known.join(", "))));
    };
    Ok(Column { number, head: heads[number].to_string(), unit: shown(unit), size: *size })
}

/// A unit's word as people write it.
fn shown(unit: &'static str) -> &'static str {
    match unit {
        "kn" => "kN",
        "n" => "N",
        "mn" => "MN",
        other => other,
    }
}

/// A cell's number in SI; nothing in a gap.
fn number_in(
    line: usize,
    column: &Column,
    cell: Option<&str>,
    separator: char,
) -> Result<Option<f64>, Problem> {
    let cell = cell.unwrap_or_default();
    if ["", "-", "nan", "n/a"].contains(&cell.to_lowercase().as_str()) {
        return Ok(None);
    }
    // Where fields are not parted by commas, a comma is a decimal one.
    let plain = if separator == ',' { cell.to_string() } else { cell.replace(',', ".") };
    match plain.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(Some(value * column.size)),
        _ => Err(Problem::new(format!("line {line}, {}", column.head), "this is no number")
            .value(cell)
            .allowed(format!("a number in {} without its unit", column.unit))),
    }
}

/// How a point is told to people.
pub(crate) fn told(p: Point) -> String {
    format!("{} kN at {} m", significant(to_kn(p.force), 4), significant(p.deflection, 3))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 20 points of F = 200 d^2 kN up to 0.6 m, in mm and kN.
    fn table(change: impl Fn(usize, f64, f64) -> Option<String>) -> String {
        let mut text = "deflection_mm,force_kN\n".to_string();
        for k in 1..=20 {
            let d = 0.03 * k as f64;
            let line = change(k, d, 200.0 * d * d)
                .unwrap_or_else(|| format!("{:.0},{:.2}", 1000.0 * d, 200.0 * d * d));
            text += &(line + "\n");
        }
        text
    }

    #[test]
    fn units_gaps_separators_and_what_comes_behind_the_peak_are_read() {
        let curve = LabCurve::read(&table(|k, _, _| (k == 7).then(|| "210,".into()))).unwrap();
        assert_eq!((curve.points.len(), curve.gaps, curve.behind), (19, 1, 0));
        assert!((curve.end().force - 72_000.0).abs() < 1e-6);
        assert!((curve.end().deflection - 0.6).abs() < 1e-12);
        let level = curve.levels(3)[1];
        assert!((level.deflection - 0.3).abs() < 1e-12);
        // By hand 18 kN; a line through the points of a parabola from 0.225 to 0.375 m reads 0.4 kN more.
        assert!((level.force / 18_000.0 - 1.0).abs() < 0.05, "{level:?}");
        let other = table(|_, d, f| Some(format!("{};{}", d, 1000.0 * f).replace('.', ",")))
            .replace("deflection_mm,force_kN", "# made up\nDeflection [m];Load (N)");
        let other = LabCurve::read(&(other + "0,62;12000\n")).unwrap();
        assert_eq!((other.points.len(), other.behind), (20, 1));
        assert!((other.end().force - 72_000.0).abs() < 1e-6);
    }

    #[test]
    fn what_is_wrong_is_said_with_line_field_value_unit_and_range() {
        let said = |text: &str| LabCurve::read(text).unwrap_err().to_string();
        let five: String =
            table(|_, _, _| None).lines().take(6).map(|l| format!("{l}\n")).collect();
        assert!(said(&five).contains("a curve of 5 points says too little"), "{}", said(&five));
        let falls = said(&table(|k, d, _| Some(format!("{},{}", 1000.0 * d, 80 - 3 * k))));
        assert!(falls.contains("line 21, force_kN = 20.00 kN: the force falls"), "{falls}");
        let dip = said(&table(|k, _, _| (k == 15).then(|| "450,5".into())));
        assert!(dip.contains("line 16, force_kN = 5.000 kN") && dip.contains("35.28 kN"), "{dip}");
        let mixed = said(&table(|k, d, f| (k > 12).then(|| format!("{d},{f}"))));
        assert!(mixed.contains("line 14, deflection_mm = 0.39 mm"), "{mixed}");
        let newtons = said(&table(|_, d, f| Some(format!("{},{}", 1000.0 * d, 1000.0 * f))));
        assert!(newtons.contains("force_kN = 72000 kN: no punch test has such"), "{newtons}");
        assert!(newtons.contains("0.5 to 2000.0 kN"), "{newtons}");
        let word = said(&table(|k, _, _| (k == 3).then(|| "90,many".into())));
        assert!(word.contains("line 4, force_kN = many: this is no number"), "{word}");
        let unit = said(&table(|_, _, _| None).replace("_mm", ""));
        assert!(unit.contains("line 1 = deflection: the unit of deflection is missing"), "{unit}");
        assert!(said("a,b\n").contains("no column is called deflection"));
        assert!(said("\n\n").contains("the file is empty"));
    }
}

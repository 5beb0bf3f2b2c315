//! A check as a text for people, 80 columns wide.

use super::chart::{ChartLine, draw};
use super::json::kind;
use super::{Checked, VERSION};
use crate::cli::output::wrapped;
use crate::cli::page::blocks_said;
use crate::curve::Curve;
use crate::dem::{Arrangement, Stop, Test};
use crate::forecast::CURVE_POINTS;
use crate::layout::Blocks;
use crate::show::{say, verdict};
use crate::study::blocks::word;
use crate::study::ensemble::{Run, weighted_mean};
use crate::study::result::sampled::{CHARACTERISTIC, sentence};
use crate::units::{
    Units, energy_text, force_text, length_entry, length_text, significant, stiffness_text,
};
use crate::words::Choice;

/// Widest line, columns.
const WIDTH: usize = 80;
/// Columns of the words in front.
const MARGIN: usize = 14;
/// Most runs that are listed one by one.
const LISTED: usize = 12;

/// The reports of all layouts, an empty line between them.
pub(crate) fn report(checked: &[Checked], unit: Units) -> String {
    if checked.is_empty() {
        return "The project has no layouts.\n".to_string();
    }
    let all: Vec<String> = checked.iter().map(|c| one(c, unit).join("\n") + "\n").collect();
    all.join("\n")
}

struct Page {
    lines: Vec<String>,
    unit: Units,
}

impl Page {
    fn line(&mut self, head: &str, text: impl AsRef<str>) {
        self.lines.extend(wrapped(&format!("{head:<MARGIN$}"), text.as_ref(), WIDTH));
    }

    fn entry(&self, metres: f64) -> String {
        format!("{} {}", length_entry(metres, self.unit), self.unit.symbol())
    }
}

fn one(c: &Checked, unit: Units) -> Vec<String> {
    let mut page = Page { lines: Vec::new(), unit };
    inputs(&mut page, c);
    judged(&mut page, c);
    side_by_side(&mut page, c);
    curves(&mut page, c);
    runs(&mut page, c);
    quality(&mut page, c);
    if let Some(first) = c.ensemble.runs.first() {
        for (k, what) in first.outcome.skipped.iter().enumerate() {
            page.line(if k == 0 { "skipped" } else { "" }, what);
        }
    }
    for remark in &c.remarks {
        page.line(remark.weight().word(), remark.sentence(page.unit));
    }
    page.lines
}

fn inputs(page: &mut Page, c: &Checked) {
    let made_by = format!("meshcast {VERSION}, inputs {}", c.fingerprint);
    match &c.name {
        Some(name) => page.line("layout", format!("{name}   [{made_by}]")),
        None => page.line("check", format!("[{made_by}]")),
    }
    let l = &c.spec.layout;
    let plates = match c.spec.test {
        Test::Anchored => format!("d {}, ", page.entry(l.plate)),
        Test::Laboratory => String::new(),
    };
    let text = format!(
        "{plates}{}, D {}, ex {}, ey {}{}",
        say::grid(l, page.unit),
        page.entry(l.punch),
        page.entry(l.ex),
        page.entry(l.ey),
        blocks_said(l)
    );
    page.line("inputs", text);
    let test = match c.spec.test {
        Test::Anchored => "anchored, periodic cell held by plates",
        Test::Laboratory => "laboratory, panel held along its edges",
    };
    let [x, y] = c.stretch.map(|s| 100.0 * (s - 1.0));
    let text = format!(
        "{test}; {} fidelity; net stretched {x:+.1} % in x, {y:+.1} % in y",
        c.fidelity_said()
    );
    page.line("test", text);
    page.line("mesh", format!("{} ({})", c.case.mesh.id, c.case.mesh.title()));
}

/// Whether it is enough, where that is asked.
fn judged(page: &mut Page, c: &Checked) {
    let Some(v) = &c.verdict else { return };
    page.line("VERDICT", format!("{}; {} values", verdict::short(v), v.basis.word()));
    for line in verdict::lines(&c.case, v, page.unit) {
        page.line("", line);
    }
}

/// Forecast and check beside each other, with the difference.
fn side_by_side(page: &mut Page, c: &Checked) {
    let e = &c.ensemble;
    let mut row = |head: &str, force: String, deflection: String| {
        page.lines.push(format!("{head:<26}{force:>22}{deflection:>24}").trim_end().to_string());
    };
    let unit = page.unit;
    let length = |v: f64| length_text(v, unit);
    row("", "force F".into(), "deflection delta".into());
    let none = || "-".to_string();
    let forecast = c.forecast.values;
    row(
        "  forecast",
        forecast.map_or_else(none, |v| force_text(v.force, unit)),
        forecast.and_then(|v| v.deflection).map_or_else(none, length),
    );
    let (broken, counted) = (c.broken(), c.counted());
    let several = broken > 1;
    let head = if several { "  CHECK, mean +- sd" } else { "  CHECK, first break" };
    let spread = |text: String, sd: String| if several { format!("{text} +- {sd}") } else { text };
    if broken == 0 {
        row(head, "no break".into(), none());
    } else {
        row(
            head,
            spread(force_text(e.force.mean, unit), unit.force_number(e.force.deviation, 2)),
            spread(length(e.deflection.mean), length(e.deflection.deviation)),
        );
    }
    if let Some(v) = forecast.filter(|_| broken > 0) {
        let percent = |ours: f64, theirs: f64| format!("{:+.1} %", 100.0 * (ours / theirs - 1.0));
        row(
            "  check over forecast",
            percent(e.force.mean, v.force),
            v.deflection.map_or_else(none, |delta| percent(e.deflection.mean, delta)),
        );
    }
    if several {
        let part = |error: f64, mean: f64| format!("{:.1} %", 100.0 * error / mean);
        row(
            "  standard error",
            part(e.force.error, e.force.mean),
            part(e.deflection.error, e.deflection.mean),
        );
    }
    if counted > 1 {
        let [low, high] = e.force.band.map(|v| unit.force_number(v, 3));
        let [near, far] = e.deflection.band;
        row(
            "  band, 5 to 95 %",
            format!("{low} to {high} {}", unit.force_symbol()),
            format!("{} to {}", length(near), length(far)),
        );
    }
    if let Some(force) = c.characteristic() {
        row("  characteristic, 5 %", force_text(force, unit), String::new());
    }
    if counted > 0 {
        row("  peak, mean", force_text(e.peak[0], unit), length(e.peak[1]));
    }
    if let Some(former) = &c.former {
        page.line("kept check", say::former(former, c.mean_break(), unit));
    }
    if let Some(text) = sentence(&c.catches(), page.unit) {
        page.line("patterns", text);
    }
    if c.characteristic().is_some() {
        page.line("5 % point", CHARACTERISTIC);
    }
    blocks(page, c);
}

/// How the blocks stood, what else was simulated, and what the anchors carry.
fn blocks(page: &mut Page, c: &Checked) {
    if !c.test_is_anchored() {
        return;
    }
    let mut text = match c.arrangement {
        Arrangement::Mirrored => "mirrored, facing their neighbours across the anchor lines".into(),
        _ => c.words.clone(),
    };
    for other in &c.others {
        let e = &other.ensemble;
        text.push_str(&format!(
            "; {} {} (standard error {}) at {}",
            word(other.arrangement),
            force_text(e.force.mean, page.unit),
            page.unit.force_number(e.force.error, 2),
            length_text(e.deflection.mean, page.unit)
        ));
    }
    if c.case.layout.blocks == Blocks::Worst {
        text = match c.case.layout.blocks_overlap() {
            _ if !c.others.is_empty() => format!("lowest of the arrangements computed: {text}"),
            Some(_) => format!("{text} alone: mirrored ones would overlap"),
            None => format!("{text}: a centred block is its own mirror image"),
        };
    }
    page.line("blocks", text);
    if let Some(a) = c.anchor() {
        let [normal, in_plane, largest] =
            [a.normal, a.in_plane, a.largest].map(|v| force_text(v, page.unit));
        page.line(
            "worst anchor",
            format!("{normal} out of the plane and {in_plane} in it, means; largest {largest}"),
        );
        let carrying: Vec<usize> = c.carrying();
        if let (Arrangement::Single(_), Some(least), Some(most)) =
            (c.arrangement, carrying.iter().min(), carrying.iter().max())
        {
            page.line(
                "anchors",
                format!("90 % of the force is carried by {least} to {most} of them"),
            );
        }
    }
}

fn curves(page: &mut Page, c: &Checked) {
    let expected: Option<Curve> = c.forecast.field.and_then(|f| Some(f.end()?.curve(CURVE_POINTS)));
    let expected = expected.as_ref().map(|curve| ChartLine { curve, sign: '.' });
    let ours = c.ensemble.runs.iter().map(|r| ChartLine { curve: &r.outcome.curve, sign: '*' });
    let lines: Vec<ChartLine> = ours.chain(expected).collect();
    let drawn = draw(&lines, page.unit);
    if drawn.is_empty() {
        return;
    }
    page.lines.push(String::new());
    page.lines.extend(drawn);
    let dots =
        if c.forecast.field.is_some_and(|f| f.end().is_some()) { " . forecast," } else { "" };
    page.lines.push(format!("          * runs of the check,{dots} X failure"));
    page.lines.push(String::new());
}

/// The word for an end.
fn stop(stop: Stop) -> &'static str {
    match stop {
        Stop::AfterBreak => "after break",
        Stop::Slipped => "slipped",
        Stop::DisplacementLimit => "limit",
        Stop::Cancelled => "cancelled",
        Stop::Diverged => "diverged",
    }
}

fn runs(page: &mut Page, c: &Checked) {
    page.lines
        .push("run  alignment   first break       peak   breaks  first wire, x, y  end".into());
    for (k, run) in c.ensemble.runs.iter().take(LISTED).enumerate() {
        page.lines.push(run_line(k, run, page.unit).trim_end().to_string());
    }
    let left = c.ensemble.runs.len().saturating_sub(LISTED);
    if left > 0 {
        page.lines.push(format!("and {left} more, see --format json"));
    }
    let stiffness = if c.ensemble.k75 > 0.0 {
        format!("k75 {} (tangent at 75 % of F); ", stiffness_text(c.ensemble.k75, page.unit))
    } else {
        String::new()
    };
    let runs: Vec<&Run> = c.ensemble.runs.iter().collect();
    let energy = weighted_mean(&c.ensemble.sample, &runs, &|run| run.outcome.energy);
    let text = format!("{stiffness}{} absorbed to the first break", energy_text(energy, page.unit));
    page.line("means", text);
}

fn run_line(k: usize, run: &Run, unit: Units) -> String {
    let o = &run.outcome;
    let kn = |v: f64| unit.force_number(v, 3);
    let first = o.first_break.map_or_else(
        || "none".to_string(),
        |p| format!("{} {}", force_text(p.force, unit), length_text(p.deflection, unit)),
    );
    let wire = o.breaks.first().map_or(String::new(), |b| {
        let word = kind(b.role).split('_').next_back().unwrap_or("");
        format!("{word:<5} {:+.2} {:+.2}", b.place[0], b.place[1])
    });
    format!(
        "{:>3}  {:.2}, {:.2}  {first:<17} {:>5}  {:>6}  {wire:<17} {}",
        k + 1,
        run.phase[0],
        run.phase[1],
        kn(o.peak.force),
        o.breaks.len(),
        stop(o.stop)
    )
}

fn quality(page: &mut Page, c: &Checked) {
    let runs = &c.ensemble.runs;
    let worst = |of: fn(&Run) -> f64| runs.iter().map(|r| of(r).abs()).fold(0.0, f64::max);
    let percent = |v: f64| format!("{} %", significant(100.0 * v, 2));
    let text = format!(
        "worst of all runs: kinetic over internal energy {}, energy out of balance {}, support off punch {}, estimated error {}",
        percent(worst(|r| r.outcome.quality.kinetic_over_internal)),
        percent(worst(|r| r.outcome.quality.energy_balance)),
        percent(worst(|r| r.outcome.quality.support_over_punch - 1.0)),
        percent(worst(|r| r.outcome.quality.error_estimate)),
    );
    page.line("quality", text);
    if let Some(first) = runs.first() {
        let n = runs.len() as f64;
        let cost = &first.outcome.cost;
        let steps = runs.iter().map(|r| r.outcome.cost.steps as f64).sum::<f64>() / n;
        let wall = 1000.0 * runs.iter().map(|r| r.wall).sum::<f64>() / n;
        let text = format!(
            "{} runs of {} nodes and {} bonds; a run: {steps:.0} steps, {wall:.0} ms to its first break",
            runs.len(),
            cost.nodes,
            cost.bonds
        );
        page.line("cost", text);
    }
}

//! `meshcast bench`: run time against error of the check, measured now, as a table and a plot.

use crate::cli::VERSION;
use crate::cli::choice::one_of;
use crate::cli::output::{CommandEnd, Fault, Format, Output, json, say, wrapped};
use crate::cli::watch::Watch;
use crate::cli::written::create;
use crate::dem::{Fidelity, Flow};
use crate::export::svg::drawing::{Anchor, Drawing, Stroke};
use crate::fingerprint::Fingerprinter;
use crate::lab::arrangements::{self, ArrangementTable};
use crate::lab::bench::{BenchRow, KnownError, Listener, SCENES, Table, table};
use crate::lab::convergence::{self, Sizes, Tables};
use crate::lab::estimates::{self, EstimatePlan};
use crate::lab::questions::{self, LAYOUTS, QuestionPlan, RANDOM};
use crate::lab::statements::{self, Statements};
use crate::project::SaveError;
use crate::show::glyphs::Glyphs;
use crate::show::picture::Ink;
use crate::show::plot::{Plot, PlotAxis};
use crate::words::Choice;
use clap::Args;
use clap::builder::PossibleValuesParser;
use serde::Serialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Scenes: A anchored L = 3, D = 1, d = 0.32 m; B laboratory L = 3, D = 1 m; C anchored L = 4, D = 1.2,
d = 0.40, ex = 2.0, ey = 0.2 m; all with the bench law; A' is A with the reference law and its scatter.
Errors are against a reference run of the same scene, of force and deflection at the first break and
of the whole curve; times are of one core to the first break, set-up included.
Ctrl+C ends with the rows made so far, exit code 130.";

/// Measure run time against error of the check.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct BenchArgs {
    /// Only this scene; may be given several times.
    #[arg(long, value_name = "SCENE", value_parser = PossibleValuesParser::new(SCENES))]
    scene: Vec<String>,
    /// Error against step, speed, damping and precision instead, with the observed orders.
    #[arg(long, conflicts_with = "svg")]
    convergence: bool,
    /// Cost against the panel's size from 2 to 12 m instead, with the fitted exponent of nodes.
    #[arg(long, conflicts_with_all = ["svg", "scene", "convergence"])]
    size: bool,
    /// Repeated, mirrored and single blocks of the paper's tests instead: force per block, deflection, what the
    /// worst anchor carries, cost.
    #[arg(long, conflicts_with_all = ["svg", "scene", "convergence", "size"])]
    arrangements: bool,
    /// Error estimates against true errors instead, on scenes drawn by a seed: beaten, median of estimate over
    /// error, said to be decided by a snap, aims missed; steps and time.
    #[arg(long, group = "drawn", conflicts_with_all = ["svg", "scene", "convergence", "size", "arrangements"])]
    estimate: bool,
    /// Scenes of `--estimate` from a file instead: the flags of a check on each line.
    #[arg(long, value_name = "FILE", requires = "estimate", conflicts_with_all = ["scenes", "seed"])]
    listed: Option<PathBuf>,
    /// In `--estimate` a run that says that it may miss its aim is made again, slower.
    #[arg(long, requires = "estimate")]
    to_aim: bool,
    /// Whole checks instead: time against error of the mean force, random runs beside placed ones of every
    /// fidelity, on four layouts and drawn ones.
    #[arg(long, group = "drawn", conflicts_with_all = ["scene", "convergence", "size", "arrangements"])]
    questions: bool,
    /// Standard runs over quick ones instead, pair by pair, on drawn scenes.
    #[arg(long, group = "drawn", conflicts_with_all = ["svg", "scene", "convergence", "size", "arrangements"])]
    pairs: bool,
    /// Drawn scenes [default: 30; 0 of --questions].
    #[arg(long, value_name = "N", requires = "drawn")]
    scenes: Option<usize>,
    /// Seed that draws the scenes.
    #[arg(long, value_name = "S", default_value_t = 1, requires = "drawn")]
    seed: u64,
    /// Seeds that each of `--questions` is asked with.
    #[arg(long, value_name = "N", default_value_t = 8, requires = "questions")]
    times: usize,
    /// Only this fidelity in `--estimate`; may be given several times [default: quick, standard, fine].
    #[arg(long, value_name = "FIDELITY", value_parser = one_of(Fidelity::ALL), requires = "estimate")]
    fidelity: Vec<Fidelity>,
    /// Five statements of others about one block on a large mesh instead, each yes or no with our figures.
    #[arg(long, conflicts_with_all = ["svg", "scene", "convergence", "size", "arrangements"])]
    statements: bool,
    /// Draws the plot to a new file.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// How the result is written.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Measures and prints.
pub(crate) fn run(args: &BenchArgs) -> CommandEnd {
    if let Some(path) = args.svg.as_ref().filter(|path| path.exists()) {
        return Err(exists(path));
    }
    let names: Vec<&str> = if args.scene.is_empty() {
        SCENES.to_vec()
    } else {
        args.scene.iter().map(String::as_str).collect()
    };
    let watch = Watch::start();
    let listener = Listener {
        tell: &|what| say("progress", what),
        ask: &|| if watch.cancelled() { Flow::Cancel } else { Flow::Continue },
    };
    if args.convergence {
        let tables = convergence::tables(&names, listener)?;
        let result = match args.format {
            Format::Text => convergence_text(&tables),
            Format::Json => whole("bench --convergence", &tables)?,
        };
        return Ok(Output { result, interrupted: tables.part, ..Output::default() });
    }
    if args.size {
        let sizes = convergence::sizes(listener)?;
        let result = match args.format {
            Format::Text => size_text(&sizes),
            Format::Json => whole("bench --size", &sizes)?,
        };
        return Ok(Output { result, interrupted: sizes.part, ..Output::default() });
    }
    if args.arrangements {
        let table = arrangements::table(listener)?;
        let result = match args.format {
            Format::Text => arrangements_text(&table),
            Format::Json => whole("bench --arrangements", &table)?,
        };
        return Ok(Output { result, interrupted: table.part, ..Output::default() });
    }
    if args.estimate {
        return estimate(args, listener);
    }
    if args.questions {
        return questions(args, listener);
    }
    if args.pairs {
        let pairs = questions::pairs(args.scenes(), args.seed, listener)?;
        let result = match args.format {
            Format::Text => super::questions::pairs_text(&pairs),
            Format::Json => whole("bench --pairs", &pairs)?,
        };
        return Ok(Output { result, interrupted: pairs.part, ..Output::default() });
    }
    if args.statements {
        let all = statements::statements(listener)?;
        let result = match args.format {
            Format::Text => statements_text(&all),
            Format::Json => whole("bench --statements", &all)?,
        };
        return Ok(Output { result, interrupted: all.part, ..Output::default() });
    }
    let Table { rows, known, part } = table(&names, listener)?;
    if let (Some(path), false) = (&args.svg, part) {
        draw(path, &rows, &WORDS)?;
    }
    let result = match args.format {
        Format::Text if rows.is_empty() => String::new(),
        Format::Text => text(&rows, &known),
        Format::Json => {
            json(&rows.iter().zip(std::iter::repeat(&known)).map(Made::new).collect::<Vec<_>>())?
                + "\n"
        }
    };
    Ok(Output { result, interrupted: part, ..Output::default() })
}

/// Draws the plot to a new file.
fn draw(path: &Path, rows: &[BenchRow], words: &Words) -> Result<(), Fault> {
    create(path, &svg(rows, words)).map_err(|e| match e {
        SaveError::Exists(path) => exists(&path),
        other => Fault::Failure(other.to_string()),
    })
}

/// Asks whole questions.
fn questions(args: &BenchArgs, listener: Listener) -> CommandEnd {
    let plan =
        QuestionPlan { times: args.times, scenes: args.scenes.unwrap_or(0), seed: args.seed };
    let table = questions::questions(&plan, listener)?;
    let points = super::questions::points(&table);
    if let (Some(path), false) = (&args.svg, table.part) {
        draw(path, &points, &QUESTIONS)?;
    }
    let result = match args.format {
        Format::Text => {
            let plot = plot(&points, &QUESTIONS);
            format!("{}\n{plot}", super::questions::text(&table))
        }
        Format::Json => whole("bench --questions", &table)?,
    };
    Ok(Output { result, interrupted: table.part, ..Output::default() })
}

impl BenchArgs {
    /// How many scenes are drawn.
    fn scenes(&self) -> usize {
        self.scenes.unwrap_or(30)
    }
}

/// Surveys the error estimates.
fn estimate(args: &BenchArgs, listener: Listener) -> CommandEnd {
    let fidelities = if args.fidelity.is_empty() { &Fidelity::USUAL[..] } else { &args.fidelity };
    let given = args.listed.as_deref().map(super::estimates::listed).transpose()?;
    let given = given.as_deref().unwrap_or_default();
    let (scenes, to_aim) = (args.scenes(), args.to_aim);
    let plan = EstimatePlan { given, scenes, seed: args.seed, fidelities, to_aim };
    let survey = estimates::survey(&plan, listener)?;
    let result = match args.format {
        Format::Text => super::estimates::text(&survey),
        Format::Json => whole("bench --estimate", &survey)?,
    };
    Ok(Output { result, interrupted: survey.part, ..Output::default() })
}

/// A study with what made it, as JSON.
fn whole(what: &str, study: &impl Serialize) -> Result<String, Fault> {
    #[derive(Serialize)]
    struct Whole<'a, T> {
        version: &'static str,
        fingerprint: String,
        #[serde(flatten)]
        study: &'a T,
    }
    let fingerprint = Fingerprinter::new(what).finish().to_string();
    Ok(json(&Whole { version: VERSION, fingerprint, study })? + "\n")
}

fn exists(path: &Path) -> Fault {
    Fault::input(format!(
        "--svg: {} exists already and is not overwritten; choose another name",
        path.display()
    ))
}

/// A row with what made it, and how well its scene's reference is known.
#[derive(Serialize)]
struct Made<'a> {
    version: &'static str,
    fingerprint: String,
    #[serde(flatten)]
    row: &'a BenchRow,
    reference_known_to: Option<&'a KnownError>,
}

impl<'a> Made<'a> {
    fn new((row, known): (&'a BenchRow, &'a Vec<KnownError>)) -> Made<'a> {
        let print = Fingerprinter::new("bench").text(&row.scene).text(&row.fidelity).finish();
        Made {
            version: VERSION,
            fingerprint: print.to_string(),
            row,
            reference_known_to: known.iter().find(|k| k.scene == row.scene),
        }
    }
}

/// What a plot of rows is called.
struct Words {
    /// Its scenes.
    names: &'static [&'static str],
    title: &'static str,
    about: &'static str,
    /// Names of the axes.
    x: &'static str,
    y: &'static str,
    /// What the letters are.
    legend: &'static str,
}

const WORDS: Words = Words {
    names: &SCENES,
    title: "Run time against error of the check",
    about: "Worst error in per cent over processor time to the first break in milliseconds, both \
            logarithmic; a line for each scene, hollow for the plain run.",
    x: "processor time to the first break, ms",
    y: "worst error, %",
    legend: "letters: scenes (' is A'); small letters: the plain run",
};

/// What the plots of questions are called.
const QUESTIONS: Words = Words {
    names: &LAYOUTS,
    title: "What a mean force costs and how far off it is",
    about: "Root mean square error of the mean force in per cent over processor time in milliseconds, both \
            logarithmic; a line for each layout, hollow for random runs.",
    x: "processor time of a check, ms",
    y: "rms error of the mean, %",
    legend: "letters: layouts; small letters: random runs",
};

/// Whether a row is what the others are held against.
fn beside(row: &BenchRow) -> bool {
    ["plain", RANDOM].contains(&row.fidelity.as_str())
}

/// The worst of the three errors of a row, %.
fn worst(row: &BenchRow) -> f64 {
    row.force_error.abs().max(row.deflection_error.abs()).max(row.curve_error.abs())
}

fn text(rows: &[BenchRow], known: &[KnownError]) -> String {
    let mut out = String::from(
        "scene fidelity    time, ms    steps   F err %  delta err %  curve err %  x plain\n",
    );
    for r in rows {
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "{:<5} {:<10} {:>9.1} {:>8} {:>9.3} {:>12.3} {:>12.3} {:>8.1}",
            r.scene,
            r.fidelity,
            r.wall_ms,
            r.steps,
            r.force_error,
            r.deflection_error,
            r.curve_error,
            r.faster
        );
    }
    for k in known {
        let line = format!(
            "The reference of {} is known to {:.3} % in force, {:.3} % in deflection, {:.3} % in the curve (its change at half the speed).",
            k.scene, k.force, k.deflection, k.curve
        );
        let _ = write!(out, "\n{}", wrapped("", &line, 80).join("\n"));
    }
    let _ = write!(out, "\n\n{}", plot(rows, &WORDS));
    out
}

/// Columns and rows of the plot in characters.
const COLUMNS: usize = 60;
const ROWS: usize = 16;
/// Columns of its labels at the left.
const LEFT: usize = 9;

/// Ranges of the plot as logarithms of ten: time in ms, worst error in %.
fn ranges(rows: &[BenchRow]) -> ([f64; 2], [f64; 2]) {
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (low, high) = values
            .filter(|v| *v > 0.0 && v.is_finite())
            .map(f64::log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if low <= high { [low.floor(), high.ceil().max(low.floor() + 1.0)] } else { [0.0, 1.0] }
    };
    (range(&mut rows.iter().map(|r| r.wall_ms)), range(&mut rows.iter().map(worst)))
}

/// Where a row stands in the plot, each from 0 to 1; nothing for an error of 0.
fn place(row: &BenchRow, times: [f64; 2], errors: [f64; 2]) -> Option<(f64, f64)> {
    let part = |v: f64, [low, high]: [f64; 2]| (v.log10() - low) / (high - low);
    let (x, y) = (part(row.wall_ms, times), part(worst(row), errors));
    (x.is_finite() && y.is_finite()).then_some((x.clamp(0.0, 1.0), y.clamp(0.0, 1.0)))
}

/// The sign of a row: its scene's letter, small for what the others are held against.
fn sign(row: &BenchRow) -> char {
    let letter = if row.scene == "A'" { '\'' } else { row.scene.chars().next().unwrap_or('?') };
    if beside(row) { letter.to_ascii_lowercase() } else { letter }
}

fn plot(rows: &[BenchRow], words: &Words) -> String {
    let (times, errors) = ranges(rows);
    let power = |exponent: f64| 10.0_f64.powf(exponent).to_string();
    let ends = (0.0, 1.0);
    let ticks = vec![(0.0, power(times[0])), (1.0, format!("{} ms", power(times[1])))];
    let x = PlotAxis { ends, ticks };
    let y = PlotAxis { ends, ticks: vec![(1.0, power(errors[1]))] };
    let size = (LEFT + 1 + COLUMNS, ROWS + 2);
    let Some(mut plot) = Plot::new(size, LEFT, x, y, Glyphs::Ascii) else { return String::new() };
    plot.picture.put_right(ROWS - 1, LEFT - 1, &power(errors[0]), Ink::Text);
    for row in rows {
        if let Some((x, y)) = place(row, times, errors) {
            plot.mark(x, y, sign(row), Ink::Text);
        }
    }
    format!(
        "{} (logarithmic)\n{}\n          {}\n",
        words.y,
        plot.picture.lines().join("\n"),
        words.legend
    )
}

/// Size of the picture and room around the plot.
const PICTURE: (f64, f64) = (640.0, 420.0);
const MARGIN: f64 = 60.0;
const COLOURS: [&str; 4] = ["#1b6ca8", "#c0392b", "#27864a", "#7d3c98"];

/// The plot as SVG, with a line through the fidelities of each scene.
fn svg(rows: &[BenchRow], words: &Words) -> String {
    let (times, errors) = ranges(rows);
    let mut drawing = Drawing::new(PICTURE.0);
    draw_grid(&mut drawing, times, errors, words);
    for (name, colour) in words.names.iter().zip(COLOURS) {
        let mut through = Vec::new();
        for row in rows.iter().filter(|r| r.scene == *name) {
            let Some((px, py)) = place(row, times, errors) else { continue };
            let (x, y) = on_paper(px, py);
            let plain = beside(row);
            let fill = if plain { "#fff" } else { colour };
            drawing.circle((x, y), 4.0, fill, Stroke::solid(colour, 1.0));
            let label = format!("{name} {}", row.fidelity);
            drawing.text((x + 6.0, y - 6.0), Anchor::Start, SMALL_TEXT, &label);
            if !plain {
                through.push((x, y));
            }
        }
        drawing.line(&through, Stroke::solid(colour, 1.0));
    }
    drawing.finish(PICTURE.1, words.title, words.about)
}

/// Size of the words in the picture.
const SMALL_TEXT: f64 = 12.0;

/// Where a place in the plot, each from 0 to 1, is on the paper.
fn on_paper(x: f64, y: f64) -> (f64, f64) {
    let (width, height) = PICTURE;
    (MARGIN + x * (width - 2.0 * MARGIN), height - MARGIN - y * (height - 2.0 * MARGIN))
}

/// Lines at the powers of ten, with their numbers and the names of the axes.
fn draw_grid(drawing: &mut Drawing, times: [f64; 2], errors: [f64; 2], words: &Words) {
    let thin = Stroke::solid("#ccc", 1.0);
    // Both limits are whole powers of ten, see `ranges`.
    let powers = |[low, high]: [f64; 2]| {
        let count = (high - low).round();
        (0..=count as usize)
            .map(move |k| (k as f64 / count, 10.0_f64.powf(low + k as f64).to_string()))
    };
    for (part, number) in powers(times) {
        let (x, y) = on_paper(part, 0.0);
        drawing.line(&[(x, y), on_paper(part, 1.0)], thin);
        drawing.text((x, y + 16.0), Anchor::Middle, SMALL_TEXT, &number);
    }
    for (part, number) in powers(errors) {
        let (x, y) = on_paper(0.0, part);
        drawing.line(&[(x, y), on_paper(1.0, part)], thin);
        drawing.text((x - 6.0, y + 4.0), Anchor::End, SMALL_TEXT, &number);
    }
    let (width, height) = PICTURE;
    drawing.text((width / 2.0, height - 16.0), Anchor::Middle, SMALL_TEXT, words.x);
    drawing.upright((16.0, height / 2.0), SMALL_TEXT, words.y);
}

/// The convergence tables as a text.
fn convergence_text(tables: &Tables) -> String {
    let mut out = String::from(
        "scene knob            value   F err %  delta err %  curve err %  order  estimate %\n",
    );
    for r in &tables.rows {
        let order = r.order.map_or_else(|| "-".to_string(), |o| format!("{o:.2}"));
        let _ = writeln!(
            out,
            "{:<5} {:<10} {:>10.3e} {:>9.3} {:>12.3} {:>12.3} {:>6} {:>11.3}",
            r.scene, r.knob, r.value, r.force, r.deflection, r.curve, order, r.estimate
        );
    }
    if !tables.relations.is_empty() {
        out.push_str(
            "\nworst error over estimate    runs  within  median    90 %  rank correlation\n",
        );
    }
    for r in &tables.relations {
        let _ = writeln!(
            out,
            "{:<28} {:>4} {:>7} {:>7.2} {:>7.2} {:>17.2}",
            r.of, r.runs, r.within, r.median, r.most, r.rank_correlation
        );
    }
    out
}

/// The table of how blocks stand.
fn arrangements_text(table: &ArrangementTable) -> String {
    let mut out = String::from(
        "Blocks as they may stand: quick runs at the same alignments, one thread; first break, force per\n\
         block; worst anchor over that force, out of the plane and in it; most anchors that carry 90 %\n\n\
         scene             F kN  s.e.  delta m   s.e.  anchor       90 %   ms   ns  blocks\n",
    );
    for r in &table.rows {
        let anchor = r.anchor.map_or("-".into(), |[n, p]| format!("{n:.2} {p:.2}"));
        let _ = writeln!(
            out,
            "{:<16} {:>5.1} {:>5.2}   {:>6.3} {:>6.3}  {anchor:<11} {:>5} {:>4.0} {:>4.2}  {}",
            r.scene,
            r.force_kn[0],
            r.force_kn[1],
            r.delta_m[0],
            r.delta_m[1],
            r.carrying,
            r.ms,
            r.ns,
            r.blocks
        );
    }
    for missing in &table.missing {
        let _ = writeln!(out, "{missing}");
    }
    out
}

/// The statements of others about single blocks.
fn statements_text(all: &Statements) -> String {
    let mut out = String::from(
        "One block on a large mesh: quick runs at the same alignments and slack, first break; changes against\n\
         the first row run by run, of fields against the row above; where the first bond broke (block, plate,\n\
         between, none), how many of these are twists, most anchors that carry 90 %\n\n\
         scene           F kN  s.e.  delta m   s.e.    dF %  s.e.  ddelta %  s.e.  broke first  tw 90 %    ms\n",
    );
    for r in all.scenes.iter().chain(&all.fields) {
        let change = |change: Option<[f64; 2]>| {
            change.map_or("-".into(), |[c, e]| format!("{:+.1} {:>5.1}", 100.0 * c, 100.0 * e))
        };
        let [block, plate, between, none] = r.places;
        let _ = writeln!(
            out,
            "{:<14} {:>5.1} {:>5.2}   {:>6.3} {:>6.3}  {:>12}  {:>12}  {block:>2} {plate:>2} {between:>2} {none:>2}  {:>2}  {:>3} {:>5.0}",
            r.scene,
            r.force_kn[0],
            r.force_kn[1],
            r.delta_m[0],
            r.delta_m[1],
            change(r.force_change),
            change(r.delta_change),
            r.twists,
            r.carrying,
            r.ms
        );
    }
    for answer in &all.answers {
        let yes = if answer.holds { "yes" } else { "no" };
        let _ = write!(out, "\n{yes}: {}\n     {}\n", answer.says, answer.judged);
    }
    out
}

/// Cost against size as a text.
fn size_text(sizes: &Sizes) -> String {
    let mut out =
        String::from("punch          L, m   nodes   steps   time, ms  ns per node and step\n");
    for r in &sizes.rows {
        let _ = writeln!(
            out,
            "{:<13} {:>5} {:>7} {:>7} {:>10.1} {:>21.2}",
            r.punch, r.spacing, r.nodes, r.steps, r.wall_ms, r.ns_per_node_step
        );
    }
    for (punch, exponent) in ["fixed", "in proportion"].iter().zip(&sizes.exponents) {
        let _ = writeln!(out, "Time goes with nodes to the power {exponent:.2}, punch {punch}.");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(scene: &str, fidelity: &str, wall_ms: f64, error: f64) -> BenchRow {
        BenchRow {
            scene: scene.into(),
            fidelity: fidelity.into(),
            wall_ms,
            steps: 1,
            force_error: error,
            deflection_error: -error / 2.0,
            curve_error: 0.0,
            estimate: 0.0,
            faster: 1.0,
            force: 0.0,
            deflection: 0.0,
        }
    }

    #[test]
    fn the_plots_hold_every_point_and_stand_a_point_without_error() {
        let rows = [
            row("A", "quick", 10.0, 1.0),
            row("A", "plain", 1000.0, 10.0),
            row("A", "reference", 100.0, 0.0),
        ];
        let plotted = plot(&rows, &WORDS);
        assert!(plotted.contains('a') && plotted.lines().all(|l| l.len() <= 80), "{plotted}");
        // Worked by hand: 10 ms of 10 to 1000 and 1 % of 1 to 10 is the lower left corner.
        assert!(plotted.contains("       1 |A"), "{plotted}");
        let drawn = svg(&rows, &WORDS);
        assert_eq!(drawn.matches("<circle").count(), 2);
        // The same corner on the paper, hollow for the plain run, which is at the other corner.
        assert!(drawn.contains("<circle cx=\"60\" cy=\"360\" r=\"4\" fill=\"#1b6ca8\""), "{drawn}");
        assert!(drawn.contains("<circle cx=\"580\" cy=\"60\" r=\"4\" fill=\"#fff\""), "{drawn}");
        assert!(drawn.ends_with("</svg>\n"));
    }
}

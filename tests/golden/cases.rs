//! The cases that go well: every form in which a subcommand answers, once.

use super::{Case, errors};

/// A project of small panels whose checks the program made and kept, some of them out of date.
const KEPT: &str = "tests/golden/inputs/kept.ron";

const ROAD: &str = "projects/road-cut.ron";

/// A panel that is checked in some milliseconds, and how.
const PANEL: &str = "-d 0.25 -L 1.5 -D 0.5";
const QUICK: &str = "--fidelity quick --runs 2 --seed 3 --threads 1";
const QUICK_DEM: &str = "--dem --fidelity quick --runs 2 --seed 3 --threads 1";

const FORMATS: [&str; 3] = ["text", "json", "csv"];

/// Layouts from flags: those of which a forecast has things to say that no other test reads as a text.
const PANELS: [(&str, &str); 3] = [
    ("near-the-branch", "-d 0.32 -D 0.325"),
    ("eccentric", "-d 0.4 -L 4 -D 1.2 --ex 2 --ey 0.2 --force 20"),
    ("extrapolated", "-d 0.6 -L 6 -D 3"),
];

/// Splits at blanks outside of single quotes.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (index, part) in line.split('\'').enumerate() {
        if index % 2 == 1 {
            words.push(part.to_string());
        } else {
            words.extend(part.split_whitespace().map(str::to_string));
        }
    }
    words
}

/// The table while it is made.
#[derive(Default)]
pub(crate) struct Table(Vec<Case>);

impl Table {
    pub(crate) fn add(&mut self, name: impl Into<String>, line: impl AsRef<str>) {
        self.0.push(Case { name: name.into(), arguments: words(line.as_ref()) });
    }

    /// One case a format.
    fn each(&mut self, formats: &[&str], name: &str, line: impl AsRef<str>) {
        for format in formats {
            self.add(format!("{name}.{format}"), format!("{} --format {format}", line.as_ref()));
        }
    }
}

/// All cases, the slow ones first so that no thread is left alone with one at the end.
pub(crate) fn all() -> Vec<Case> {
    let mut table = Table::default();
    slow(&mut table);
    forecasts(&mut table);
    comparisons(&mut table);
    studies(&mut table);
    designs(&mut table);
    exports(&mut table);
    checks(&mut table);
    rest(&mut table);
    errors::add(&mut table);
    table.0
}

/// Ensembles and campaigns of seconds.
fn slow(table: &mut Table) {
    // Of the bench only the form without a plot, because a plot is made of times.
    table.add("bench-A.json", "bench --scene A --format json");
    table.each(&["text"], "validate-dem", "validate --dem --fidelity quick --threads 1");
    let calibrate = "calibrate --force 73.3 --deflection 0.6 --runs 1 --fidelity quick --threads 1";
    table.each(&["text", "json"], "calibrate", calibrate);
}

fn forecasts(table: &mut Table) {
    for (name, flags) in PANELS {
        table.add(format!("forecast-{name}.text"), format!("forecast {flags}"));
    }
    let question = "--force 20 --deflection 0.6 --gamma-load 1.3 --gamma-resistance 1.25";
    table.each(&["text", "json"], "forecast-question", format!("forecast {question}"));
    table.each(&["text", "json"], "forecast-kept", format!("forecast {KEPT}"));
    table.each(&["csv"], "forecast-road-cut", format!("forecast {ROAD}"));
    table.add("forecast-road-cut.mm", format!("--units mm forecast {ROAD}"));
}

fn comparisons(table: &mut Table) {
    table.each(&FORMATS, "compare-road-cut", format!("compare {ROAD}"));
    table.each(&FORMATS, "compare-kept-dem", format!("compare {KEPT} {QUICK_DEM}"));
}

fn studies(table: &mut Table) {
    let question = "-d 0.25 -L 2.5 -D 0.6 --force 15 --deflection 0.45";
    table.each(&["text"], "sensitivity-question", format!("sensitivity {question}"));
    let dem = format!("sensitivity {PANEL} --force 8 {QUICK_DEM}");
    table.each(&FORMATS, "sensitivity-dem", dem);

    let line = "sweep --vary L --from 1.25 --to 4.5 --steps 9 --force 20";
    table.each(&["text"], "sweep-spacing", line);
    table.add("sweep-lab-force.mm", "--units mm sweep --vary Fl --from 40kN --to 120");
    let map = "sweep --vary L --from 2 --to 4 --vary2 D --from2 0.4 --to2 1.6 --force 20";
    table.each(&["text"], "map-spacing-punch", map);
    let line = format!("sweep {PANEL} --vary L --from 1.3 --to 1.6 --steps 4");
    table.each(&FORMATS, "sweep-dem", format!("{line} --force 8 {QUICK_DEM}"));
    let map = "--steps 2 --vary2 D --from2 0.4 --to2 0.6 --steps2 2";
    table.each(&FORMATS, "map-dem", format!("{line} {map} {QUICK_DEM}"));
}

fn designs(table: &mut Table) {
    table.each(&FORMATS, "design-both", "design -d 0.25 --force 18 --deflection 0.45");
    table.add("design-road-cut.text", format!("design {ROAD}"));
}

fn exports(table: &mut Table) {
    table.add("export-road-cut-chart", format!("export {ROAD} --what chart"));
    for what in ["table", "plan", "chart", "curve"] {
        let line = format!("export {KEPT} --layout centred --what {what}");
        table.add(format!("export-kept-centred-{what}"), line);
    }
}

fn checks(table: &mut Table) {
    table.each(&FORMATS, "check", format!("check {PANEL} {QUICK}"));
    table.add(
        "check-laboratory.text",
        "check --test laboratory -L 2 --fidelity quick --runs 2 --seed 3 --threads 1",
    );
    let single = "--fidelity quick --runs 1 --phase 0.25,0.125 --threads 1";
    table.add("check-single.text", format!("check {PANEL} {single}"));
    table.add("check-limit.text", format!("check {PANEL} {QUICK} --limit 0.2"));
    table.add(
        "check-slipped.text",
        "check -L 1.6 -D 0.08 --fidelity quick --runs 1 --phase 0.25,0.25 --threads 1",
    );
    table.add("check-kept.text", format!("check {KEPT} {QUICK}"));
}

fn rest(table: &mut Table) {
    table.each(&["html", "md"], "report-kept", format!("report {KEPT}"));
    table.add("mesh-list.text", "mesh list");
    table.each(&["text", "json"], "mesh-show", "mesh show dt-8x10-2.7");
    table.add("validate.text", "validate");
    table.add("help", "--help");
    table.add("help-check", "check --help");
}

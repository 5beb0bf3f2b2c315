//! The cases that go well: every subcommand in every form.

use super::{Case, errors};

/// A project of small panels whose checks the program made and kept, some of them out of date.
const KEPT: &str = "tests/golden/inputs/kept.ron";

/// The same without checks.
const SMALL: &str = "tests/golden/inputs/small.ron";

const ROAD: &str = "projects/road-cut.ron";

/// A panel that is checked in some milliseconds, and how.
const PANEL: &str = "-d 0.25 -L 1.5 -D 0.5";
const QUICK: &str = "--fidelity quick --runs 2 --seed 3 --threads 1";
const QUICK_DEM: &str = "--dem --fidelity quick --runs 2 --seed 3 --threads 1";

const FORMATS: [&str; 3] = ["text", "json", "csv"];

/// Layouts from flags: one for each thing that a forecast can have to say.
const PANELS: [(&str, &str); 9] = [
    ("default", ""),
    ("units", "-d 250mm -L '2.5 m' -D 60cm --force '12000 N' --deflection 450mm"),
    ("question", "--force 20 --deflection 0.6 --gamma-load 1.3 --gamma-resistance 1.25"),
    ("overloaded", "--force 45 --deflection 0.2"),
    ("conservative", "-D 0.33 --branch conservative"),
    ("near-the-branch", "-d 0.32 -D 0.325"),
    ("eccentric", "-d 0.4 -L 4 -D 1.2 --ex 2 --ey 0.2 --force 20"),
    ("on-a-plate", "--ex 1.5 --ey 1.5 --force 10"),
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
    reports(&mut table);
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
        table.each(&["text", "json"], &format!("forecast-{name}"), format!("forecast {flags}"));
    }
    table.each(&FORMATS, "forecast-road-cut", format!("forecast {ROAD}"));
    table.add("forecast-road-cut.mm", format!("--units mm forecast {ROAD}"));
    table.each(&["text", "json"], "forecast-own-mesh", "forecast projects/own-mesh.ron");
    table.each(&["text", "json"], "forecast-kept", format!("forecast {KEPT}"));
}

fn comparisons(table: &mut Table) {
    table.each(&FORMATS, "compare-road-cut", format!("compare {ROAD}"));
    table.add("compare-road-cut.mm", format!("--units mm compare {ROAD}"));
    table.add("compare-falling-F.text", format!("compare {ROAD} --sort F --descending"));
    let flags = "--force 18 --gamma-load 1.2 --deflection 0.55";
    table.each(&FORMATS, "compare-flags", format!("compare {ROAD} {flags}"));
    table.each(&FORMATS, "compare-kept-dem", format!("compare {KEPT} {QUICK_DEM}"));
}

fn studies(table: &mut Table) {
    let question = "-d 0.25 -L 2.5 -D 0.6 --force 15 --deflection 0.45";
    table.each(&FORMATS, "sensitivity-question", format!("sensitivity {question}"));
    table.add("sensitivity-plate.text", "sensitivity --ex 1.5 --ey 1.5");
    let dem = format!("sensitivity {PANEL} --force 8 {QUICK_DEM}");
    table.each(&FORMATS, "sensitivity-dem", dem);

    let line = "sweep --vary L --from 1.25 --to 4.5 --steps 9 --force 20";
    table.each(&FORMATS, "sweep-spacing", line);
    table.add("sweep-lab-force.mm", "--units mm sweep --vary Fl --from 40kN --to 120");
    let map = "sweep --vary L --from 2 --to 4 --vary2 D --from2 0.4 --to2 1.6 --force 20";
    table.each(&FORMATS, "map-spacing-punch", map);
    let line = format!("sweep {PANEL} --vary L --from 1.3 --to 1.6 --steps 4");
    table.each(&FORMATS, "sweep-dem", format!("{line} --force 8 {QUICK_DEM}"));
    let map = "--steps 2 --vary2 D --from2 0.4 --to2 0.6 --steps2 2";
    table.each(&FORMATS, "map-dem", format!("{line} {map} {QUICK_DEM}"));
}

fn designs(table: &mut Table) {
    table.each(&FORMATS, "design-both", "design -d 0.25 --force 18 --deflection 0.45");
    for (input, solve) in [("plate", "d"), ("spacing", "L"), ("punch", "D")] {
        let line = format!("design --force 20 --gamma-load 1.3 --solve {solve}");
        table.add(format!("design-force-{input}.text"), line);
    }
    table.add("design-too-much.text", "design --force 200");
    table.add("design-on-a-plate.text", "design --force 20 --ex 1.5 --ey 1.5");
    table.add("design-road-cut.text", format!("design {ROAD}"));
}

fn exports(table: &mut Table) {
    for what in ["table", "chart", "curve"] {
        table.add(format!("export-road-cut-{what}"), format!("export {ROAD} --what {what}"));
    }
    for (project, name, layout) in [(ROAD, "road-cut", "gully"), (KEPT, "kept", "centred")] {
        for what in ["table", "plan", "chart", "curve"] {
            let line = format!("export {project} --layout {layout} --what {what}");
            table.add(format!("export-{name}-{layout}-{what}"), line);
        }
    }
    table.add("export-to-another-ending", format!("export {ROAD} --what table -o table.svg"));
    table.add("export-to-an-unknown-ending", format!("export {ROAD} --what table -o table.pdf"));
}

fn reports(table: &mut Table) {
    table.each(&["html", "md"], "report-kept", format!("report {KEPT}"));
    table.add("report-road-cut.html", format!("report {ROAD}"));
}

fn checks(table: &mut Table) {
    table.each(&FORMATS, "check", format!("check {PANEL} {QUICK}"));
    table.each(
        &FORMATS,
        "check-laboratory",
        "check --test laboratory -L 2 --fidelity quick --runs 2 --seed 3 --threads 1",
    );
    let single = "--fidelity quick --runs 1 --phase 0.25,0.125 --threads 1";
    table.each(&FORMATS, "check-single", format!("check {PANEL} {single}"));
    table.add("check-limit.text", format!("check {PANEL} {QUICK} --limit 0.2"));
    table.each(
        &["text", "json"],
        "check-slipped",
        "check -L 1.6 -D 0.08 --fidelity quick --runs 1 --phase 0.25,0.25 --threads 1",
    );
    table.each(&["text", "json"], "check-small", format!("check {SMALL} {QUICK}"));
    table.add("check-kept.text", format!("check {KEPT} {QUICK}"));
}

fn rest(table: &mut Table) {
    table.each(&["text", "json"], "mesh-list", "mesh list");
    table.each(&["text", "json"], "mesh-show", "mesh show dt-8x10-2.7");
    table.each(&["text", "json"], "validate", "validate");
    table.add("new", "new road.ron");
    table.add("version", "--version");
    table.add("help", "--help");
    for command in [
        "new",
        "forecast",
        "sensitivity",
        "sweep",
        "compare",
        "design",
        "export",
        "report",
        "check",
        "adopt",
        "calibrate",
        "bench",
        "mesh",
        "mesh list",
        "mesh show",
        "validate",
    ] {
        let name = command.replace(' ', "-");
        table.add(format!("help-{name}"), format!("{command} --help"));
    }
}

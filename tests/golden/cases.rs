//! The cases that go well: every subcommand on every sample, in every form.

use super::{Case, errors};

/// Samples of the project, each with its layouts.
const SAMPLES: [(&str, &[&str]); 4] = [
    ("own-mesh", &["our mesh", "reference mesh"]),
    ("reference-panel", &["reference"]),
    ("road-cut", &["bench 1", "bench 2", "portal", "gully", "shelf"]),
    ("spacing-study", &["L 2.0", "L 2.5", "L 3.0", "L 3.5", "L 4.0", "L 4.5"]),
];

/// A project of small panels whose checks the program made and kept, some of them out of date.
const KEPT: &str = "tests/golden/inputs/kept.ron";
const KEPT_LAYOUTS: [&str; 10] = [
    "centred",
    "eccentric",
    "one of two",
    "slipping",
    "own wires",
    "no wires",
    "on a plate",
    "widened",
    "by the wall",
    "new",
];

/// The same without checks.
const SMALL: &str = "tests/golden/inputs/small.ron";

/// A panel that is checked in some milliseconds, and how.
const PANEL: &str = "-d 0.25 -L 1.5 -D 0.5";
const QUICK: &str = "--fidelity quick --runs 2 --seed 3 --threads 1";
const QUICK_DEM: &str = "--dem --fidelity quick --runs 2 --seed 3 --threads 1";

const FORMATS: [&str; 3] = ["text", "json", "csv"];

/// Layouts from flags: all branches, units, ranges and warnings of the method.
const PANELS: [(&str, &str); 22] = [
    ("default", ""),
    ("units", "-d 250mm -L '2.5 m' -D 60cm --force '12000 N' --deflection 450mm"),
    ("force", "-d 0.25 -L 2.5 -D 0.6 --force 15"),
    ("deflection", "-d 0.25 -L 2.5 -D 0.6 --deflection 0.45"),
    ("question", "--force 20 --deflection 0.6 --gamma-load 1.3 --gamma-resistance 1.25"),
    ("overloaded", "--force 45 --deflection 0.2"),
    ("beyond-the-curve", "--deflection 2.5"),
    ("conservative", "-D 0.33 --branch conservative"),
    ("conservative-small", "-d 0.48 -D 0.4 --branch conservative"),
    ("published", "-D 0.33 --branch published"),
    ("near-the-branch", "-d 0.32 -D 0.325"),
    ("at-the-branch", "-d 0.32 -D 0.32"),
    ("small-punch", "-d 0.32 -L 2.5 -D 0.2"),
    ("very-small-punch", "-D 0.05"),
    ("eccentric", "-d 0.4 -L 4 -D 1.2 --ex 2 --ey 0.2 --force 20"),
    ("eccentric-negative", "-d 0.25 -L 3.5 -D 0.8 --ex -0.55 --ey -1.15"),
    ("eccentric-periodic", "--ex 1.9 --ey -7.5"),
    ("on-a-plate", "--ex 1.5 --ey 1.5 --force 10"),
    ("extrapolated", "-d 0.6 -L 6 -D 3"),
    ("extrapolated-low", "-d 0.1 -L 1 -D 0.5"),
    ("mesh", "--mesh dt-8x10-2.7 -L 2"),
    ("huge", "-d 0.9 -L 12 -D 6 --ex 2 --ey 1 --force 1MN"),
];

const SORTS: [&str; 14] = [
    "layout",
    "mesh",
    "d",
    "L",
    "D",
    "ex",
    "ey",
    "F",
    "delta",
    "F_ratio",
    "delta_ratio",
    "utilisation",
    "design_delta",
    "warnings",
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
    table.each(&["text", "json"], "validate-dem", "validate --dem --fidelity quick --threads 1");
    table.add("check-automatic.text", format!("check {PANEL} --fidelity quick --threads 1"));
    let calibrate = "calibrate --force 73.3 --deflection 0.6 --runs 1 --fidelity quick --threads 1";
    table.each(&["text", "json"], "calibrate", calibrate);
    let other = "--panel 2.5 --from yade --seed 4 --out fitted.ron";
    table.add("calibrate-out", format!("{calibrate} {other}"));
}

fn forecasts(table: &mut Table) {
    for (name, flags) in PANELS {
        // The curves of one relation are those of all.
        let formats = if flags.contains("-L") { &FORMATS[..] } else { &FORMATS[..2] };
        table.each(formats, &format!("forecast-{name}"), format!("forecast {flags}"));
    }
    for (sample, layouts) in SAMPLES {
        let project = format!("forecast projects/{sample}.ron");
        table.each(&FORMATS, &format!("forecast-{sample}"), &project);
        table.add(format!("forecast-{sample}.mm"), format!("--units mm {project}"));
        table.add(format!("forecast-{sample}.m"), format!("--units m {project}"));
        for layout in layouts {
            let name = layout.replace(' ', "-");
            table.add(
                format!("forecast-{sample}-{name}.text"),
                format!("{project} --layout '{layout}'"),
            );
        }
    }
    let over = "-d 0.3 -D 800mm --force 25 --branch conservative";
    table.each(
        &["text", "json"],
        "forecast-road-cut-flags",
        format!("forecast projects/road-cut.ron {over}"),
    );
    for valid in VALID {
        let line = format!("forecast tests/files/valid/{valid}.ron");
        table.add(format!("valid-{valid}.text"), line);
    }
    table.each(&["text", "json"], "forecast-kept", format!("forecast {KEPT}"));
    table.each(&FORMATS, "forecast-kept-widened", format!("forecast {KEPT} --layout widened"));
}

const VALID: [&str; 15] = [
    "byte_order_mark",
    "comments_everywhere",
    "fields_in_any_order",
    "fields_on_shared_lines",
    "mixed_styles",
    "names_and_some",
    "odd_numbers",
    "one_line",
    "outside_published_ranges",
    "own_wire",
    "raw_and_odd_strings",
    "smallest",
    "units_everywhere",
    "version_0",
    "windows_line_ends",
];

fn comparisons(table: &mut Table) {
    for (sample, _) in SAMPLES {
        let line = format!("compare projects/{sample}.ron");
        table.each(&FORMATS, &format!("compare-{sample}"), &line);
        table.add(format!("compare-{sample}.mm"), format!("--units mm {line}"));
    }
    for sort in SORTS {
        let line = format!("compare projects/road-cut.ron --sort {sort}");
        // d and D are one name where the file system does not tell cases apart.
        let name = if sort == "D" { "punch" } else { sort };
        table.add(format!("compare-sorted-{name}.text"), &line);
        table.add(format!("compare-falling-{name}.text"), format!("{line} --descending"));
    }
    let flags = "--force 18 --gamma-load 1.2 --deflection 0.55";
    table.each(&FORMATS, "compare-flags", format!("compare projects/road-cut.ron {flags}"));
    table.each(&FORMATS, "compare-kept", format!("compare {KEPT}"));
    table.each(&FORMATS, "compare-kept-dem", format!("compare {KEPT} {QUICK_DEM}"));
    table.each(&FORMATS, "compare-dem", format!("compare {SMALL} {QUICK_DEM}"));
    table.add(
        "compare-dem-sorted.text",
        format!("compare {SMALL} --sort delta --descending {QUICK_DEM}"),
    );
}

fn studies(table: &mut Table) {
    table.each(&FORMATS, "sensitivity", "sensitivity");
    table.each(
        &FORMATS,
        "sensitivity-question",
        "sensitivity -d 0.25 -L 2.5 -D 0.6 --force 15 --deflection 0.45",
    );
    table.each(&FORMATS, "sensitivity-branch", "sensitivity -d 0.32 -D 0.33");
    table.each(&FORMATS, "sensitivity-eccentric", "sensitivity -L 4 -D 1.2 --ex 1.4 --ey 1.3");
    table.each(&FORMATS, "sensitivity-plate", "sensitivity --ex 1.5 --ey 1.5");
    table.add("sensitivity.mm", "--units mm sensitivity --force 20");
    for (sample, _) in SAMPLES {
        let line = format!("sensitivity projects/{sample}.ron");
        table.each(&FORMATS, &format!("sensitivity-{sample}"), line);
    }
    let dem = format!("sensitivity {PANEL} --force 8 {QUICK_DEM}");
    table.each(&FORMATS, "sensitivity-dem", dem);
    table.add("sensitivity-kept-dem.text", format!("sensitivity {KEPT} --layout new {QUICK_DEM}"));

    for (name, vary, from, to) in [
        ("plate", "d", "0.16", "0.48"),
        ("spacing", "L", "1.25", "4.5"),
        ("punch", "D", "0.1", "2.5"),
        ("across", "ex", "-1.5", "1.5"),
        ("along", "ey", "0", "1.5"),
        ("lab-force", "Fl", "40kN", "120"),
        ("lab-deflection", "dl", "300mm", "0.9"),
    ] {
        let line = format!("sweep --vary {vary} --from {from} --to {to}");
        table.each(&FORMATS, &format!("sweep-{name}"), format!("{line} --steps 9"));
        table.add(format!("sweep-{name}-force.text"), format!("{line} --force 20 --units mm"));
    }
    for (name, first, second) in [
        ("spacing-punch", "L --from 2 --to 4", "D --from2 0.4 --to2 1.6"),
        ("plate-spacing", "d --from 0.16 --to 0.48", "L --from2 1 --to2 6 --steps2 6"),
        ("offsets", "ex --from 0 --to 1.5 --steps 7", "ey --from2 0 --to2 1.5 --steps2 7"),
        ("lab", "Fl --from 50 --to 100 --steps 5", "dl --from2 0.4 --to2 0.8 --steps2 5"),
    ] {
        let line = format!("sweep --vary {first} --vary2 {second}");
        table.each(&FORMATS, &format!("map-{name}"), &line);
        table.add(format!("map-{name}-force.text"), format!("{line} --force 20"));
    }
    for (sample, layouts) in SAMPLES {
        let line = format!(
            "sweep projects/{sample}.ron --layout '{}' --vary L --from 2 --to 4 --steps 5",
            layouts[0]
        );
        table.each(&FORMATS, &format!("sweep-{sample}"), line);
    }
    let all = "sweep projects/road-cut.ron --vary L --from 2 --to 3 --steps 3";
    table.each(&FORMATS, "sweep-all-layouts", all);
    let line = format!("sweep {PANEL} --vary L --from 1.3 --to 1.6 --steps 4");
    table.each(&FORMATS, "sweep-dem", format!("{line} --force 8 {QUICK_DEM}"));
    let map = "--steps 2 --vary2 D --from2 0.4 --to2 0.6 --steps2 2";
    table.each(&FORMATS, "map-dem", format!("{line} {map} {QUICK_DEM}"));
    table.add(
        "sweep-lab-dem.text",
        format!("sweep {PANEL} --vary Fl --from 50 --to 90 --steps 3 {QUICK_DEM}"),
    );
    table.add(
        "sweep-plate-dem.text",
        format!("sweep {PANEL} --vary ex --from 0 --to 0.75 --steps 3 --ey 0.75 {QUICK_DEM}"),
    );
}

fn designs(table: &mut Table) {
    for (name, question) in [
        ("force", "--force 20 --gamma-load 1.3"),
        ("deflection", "--deflection 0.5"),
        ("both", "-d 0.25 --force 18 --deflection 0.45"),
        ("too-much", "--force 200"),
        ("too-stiff", "--deflection 0.05"),
        ("eccentric", "-L 4 --ex 1 --ey 0.5 --force 15"),
        ("conservative", "--force 12 --branch conservative"),
    ] {
        table.each(&FORMATS, &format!("design-{name}"), format!("design {question}"));
        for (input, solve) in [("plate", "d"), ("spacing", "L"), ("punch", "D")] {
            let line = format!("design {question} --solve {solve}");
            table.each(&["text", "json"], &format!("design-{name}-{input}"), line);
        }
    }
    table.each(&FORMATS, "design-on-a-plate", "design --force 20 --ex 1.5 --ey 1.5");
    table.add("design.mm", "--units mm design --force 20");
    for (sample, layouts) in SAMPLES {
        let line = format!("design projects/{sample}.ron");
        table.each(&FORMATS, &format!("design-{sample}"), &line);
        table.add(
            format!("design-{sample}-force.text"),
            format!("{line} --layout '{}' --force 14", layouts[0]),
        );
    }
}

fn exports(table: &mut Table) {
    let samples = SAMPLES.map(|(name, layouts)| (name, format!("projects/{name}.ron"), layouts));
    let kept: [(&str, String, &[&str]); 1] = [("kept", KEPT.into(), &KEPT_LAYOUTS)];
    for (name, project, layouts) in samples.into_iter().chain(kept) {
        let line = format!("export {project}");
        // The curves are those of the forecast's CSV.
        let whats = if name == "spacing-study" { &WHATS[..3] } else { &WHATS[..] };
        for what in whats.iter().filter(|what| **what != "plan") {
            table.add(format!("export-{name}-{what}"), format!("{line} --what {what}"));
        }
        for &layout in layouts {
            let one = format!("{line} --layout '{layout}'");
            let stem = format!("export-{name}-{}", layout.replace(' ', "-"));
            // Charts and curves of one layout are long: not those of the six that are alike, and not
            // all of the checked ones.
            let whats = match (name, layout) {
                ("spacing-study", _) => &WHATS[..2],
                ("kept", "centred" | "slipping" | "widened" | "on a plate") => &WHATS[..3],
                ("kept", _) => &WHATS[..2],
                _ => &WHATS[..],
            };
            for what in whats {
                table.add(format!("{stem}-{what}"), format!("{one} --what {what}"));
            }
        }
    }
    let road = "export projects/road-cut.ron";
    let own = "export projects/own-mesh.ron";
    table.add("export-default", own);
    table.add("export-svg", format!("{own} --format svg"));
    table.add("export-csv", format!("{own} --format csv"));
    table.add("export-to-svg", format!("{own} -o chart.svg"));
    table.add("export-to-csv", format!("{road} --what table -o table.csv"));
    table.add("export-to-plan", format!("{road} --layout gully --what plan -o plan.svg --force"));
    table.add("export-to-stdout", format!("{road} --what table --format csv -o -"));
    table.add("export-to-another-ending", format!("{road} --what table -o table.svg"));
    table.add("export-to-an-unknown-ending", format!("{own} --layout 'our mesh' -o curve.pdf"));
    table.add("export-mm", format!("--units mm {road} --what chart"));
    table.add("export-plan-mm", format!("--units mm {road} --layout gully --what plan"));
}

/// What can be exported of one layout, the long ones last.
const WHATS: [&str; 4] = ["table", "plan", "chart", "curve"];

fn reports(table: &mut Table) {
    table.each(&["html", "md"], "report-kept", format!("report {KEPT}"));
    // The study of six layouts that differ in one input is only longer.
    for (sample, _) in &SAMPLES[..3] {
        table.add(format!("report-{sample}.html"), format!("report projects/{sample}.ron"));
    }
    let one = "report projects/reference-panel.ron";
    table.add("report-to-md", format!("{one} -o report.md"));
    table.add("report-to-an-unknown-ending", format!("{one} -o report.doc"));
    table.add("report-mm", format!("--units mm {one}"));
}

fn checks(table: &mut Table) {
    let check = format!("check {PANEL} {QUICK}");
    table.each(&FORMATS, "check", &check);
    table.add("check.mm", format!("--units mm {check}"));
    table.each(
        &FORMATS,
        "check-laboratory",
        "check --test laboratory -L 2 --fidelity quick --runs 2 --seed 3 --threads 1",
    );
    table.add("check-laboratory-punch.text", format!("{check} --test laboratory"));
    let single = "--fidelity quick --runs 1 --phase 0.25,0.125 --threads 1";
    table.each(&FORMATS, "check-single", format!("check {PANEL} {single}"));
    table.add("check-random-phase.text", format!("{check} --phase random"));
    for law in ["bench", "yade", "projects/wire/dt-8x10-2.7.ron"] {
        let name = format!("check-law-{}", law.rsplit('/').next().unwrap_or(law));
        table.add(format!("{name}.text"), format!("check {PANEL} {single} --law {law}"));
    }
    let file = "--mesh-file projects/wire/dt-8x10-2.7.ron";
    table.each(&["text", "json"], "check-mesh-file", format!("{check} {file}"));
    table.add(
        "check-settings.json",
        format!(
            "check {PANEL} {single} --law bench --step-factor 0.8 --speed 0.0002 --damping 0.02 \
             --after-break 0 --limit 0.7 --format json"
        ),
    );
    table.add("check-limit.text", format!("{check} --limit 0.2"));
    table.add("check-standard.text", format!("check {PANEL} --runs 2 --fidelity standard"));
    table.add("check-portable.json", format!("{check} --instructions portable --format json"));
    table.add("check-threads.json", format!("check {PANEL} {single} --threads 2 --format json"));
    table.each(
        &["text", "json"],
        "check-slipped",
        "check -L 1.6 -D 0.08 --fidelity quick --runs 1 --phase 0.25,0.25 --threads 1",
    );
    table.add("check-diverged.text", format!("check -d 0.25 -L 1.6 -D 0.08 {QUICK}"));
    table.add("check-eccentric.text", format!("{check} --ex 0.3 --ey -0.2"));
    table.each(&["text", "json"], "check-small", format!("check {SMALL} {QUICK}"));
    table.add("check-small-twin.csv", format!("check {SMALL} --layout twin {QUICK} --format csv"));
    table.add("check-kept.text", format!("check {KEPT} {QUICK}"));
    table.add("check-own-wire.text", format!("check tests/files/valid/own_wire.ron {QUICK}"));
    table.add("check-road-cut.text", format!("check projects/road-cut.ron {QUICK}"));
    table.add("check-own-mesh.text", format!("check projects/own-mesh.ron {QUICK}"));
}

fn rest(table: &mut Table) {
    table.each(&["text", "json"], "mesh-list", "mesh list");
    table.each(&["text", "json"], "mesh-show", "mesh show dt-8x10-2.7");
    table.add("mesh-list.mm", "--units mm mesh list");
    table.add("mesh-show.mm", "--units mm mesh show dt-8x10-2.7");
    table.each(&["text", "json"], "validate", "validate");
    table.add("new", "new road.ron");
    table.add("new-without-ending", "new road");
    table.add("new-in-a-folder", "new 'data folder/road cut.ron'");
    table.add("version", "--version");
    table.add("help", "--help");
    table.add("help-short", "-h");
    table.add("help-of-help", "help");
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
        "calibrate",
        "bench",
        "mesh",
        "mesh list",
        "mesh show",
        "validate",
    ] {
        let name = command.replace(' ', "-");
        table.add(format!("help-{name}"), format!("{command} --help"));
        table.add(format!("help-short-{name}"), format!("{command} -h"));
    }
}

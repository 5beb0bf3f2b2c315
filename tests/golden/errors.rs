//! The cases that are refused or fail.

use super::cases::Table;
use std::path::Path;

const ROAD: &str = "projects/road-cut.ron";

/// What is refused, by its name.
const REFUSED: &[(&str, &str)] = &[
    ("decimal-comma", "forecast -d 2,7"),
    ("unit", "forecast -L '3 kN'"),
    ("no-number", "forecast -D wide"),
    ("nan", "forecast --ex NaN"),
    ("infinite", "forecast -L 1e999"),
    ("empty-number", "forecast -d ''"),
    ("force-unit", "forecast --force '25 mm'"),
    ("factor-unit", "forecast --gamma-load '1.5 m'"),
    ("swallowed-flag", "forecast --ex --format"),
    ("negative", "forecast -d -0.1"),
    ("too-large", "forecast -D 3"),
    ("zero", "forecast -L 0"),
    ("factor-range", "forecast --gamma-load 9"),
    ("negative-force", "forecast --force -1"),
    ("zero-deflection", "forecast --deflection 0"),
    ("default-too-large", "forecast -L 0.5"),
    ("branch", "forecast --branch lower"),
    ("format", "forecast --format xml"),
    ("mesh", "forecast --mesh dt-8x10-2.2"),
    ("mesh-show", "mesh show nothing"),
    ("mesh-alone", "mesh"),
    ("glyphs", "--glyphs dots forecast"),
    ("colours", "--color 256 forecast"),
    ("units", "--units cm forecast"),
    ("layout-without-project", "forecast --layout a"),
    ("unknown-flag", "forecast --what"),
    ("layout", "forecast projects/road-cut.ron --layout bench2"),
    ("layout-far", "export projects/road-cut.ron --layout zzz"),
    ("layout-senseless", "forecast projects/road-cut.ron -L '1 m'"),
    ("no-file", "forecast projects/none.ron"),
    ("folder", "forecast projects"),
    ("no-file-report", "report none.ron"),
    ("command", "forcast"),
    ("command-short", "valdate"),
    ("project-before-command", "road.ron forecast"),
    ("two-projects", "forecast a.ron b.ron"),
    ("no-terminal", ""),
    ("no-terminal-project", "projects/road-cut.ron"),
    ("program-flag", "--fidelity quick forecast"),
    ("compare-without-project", "compare"),
    ("compare-sort", "compare projects/road-cut.ron --sort colour"),
    ("compare-descending", "compare projects/road-cut.ron --descending"),
    ("dem-flags-without-dem", "sensitivity --runs 3"),
    ("dem-reference-runs", "sweep --vary L --from 2 --to 3 --dem --runs 0"),
    ("sweep-without-range", "sweep --vary L"),
    ("sweep-without-input", "sweep"),
    ("sweep-input", "sweep --vary q --from 1 --to 2"),
    ("sweep-same-input", "sweep --vary L --from 2 --to 3 --vary2 L --from2 2 --to2 3"),
    ("sweep-steps", "sweep --vary L --from 2 --to 3 --steps 1"),
    ("sweep-many-steps", "sweep --vary L --from 2 --to 3 --steps 100001"),
    ("sweep-range", "sweep --vary L --from 3 --to 3"),
    ("sweep-impossible", "sweep --vary D --from -1 --to 2"),
    ("sweep-half-a-map", "sweep --vary L --from 2 --to 3 --vary2 D"),
    ("sweep-map-without-input", "sweep --vary L --from 2 --to 3 --steps2 4"),
    ("design-without-question", "design"),
    ("design-solve", "design --force 20 --solve ex"),
    ("export-plan-of-several", "export projects/road-cut.ron --what plan"),
    ("export-what", "export projects/road-cut.ron --what picture"),
    ("export-chart-csv", "export projects/road-cut.ron --what chart --format csv"),
    ("export-table-svg", "export projects/road-cut.ron --what table --format svg"),
    ("export-no-folder", "export projects/road-cut.ron -o none/chart.svg"),
    ("export-to-folder", "export projects/road-cut.ron -o projects"),
    ("export-overwrites", "export projects/road-cut.ron -o projects/road-cut.ron"),
    ("export-force-alone", "export projects/road-cut.ron --force"),
    ("report-overwrites", "report projects/road-cut.ron --format md -o projects/own-mesh.ron"),
    ("report-format", "report projects/road-cut.ron --format pdf"),
    ("new-exists", "new projects/road-cut.ron"),
    ("new-no-folder", "new no/such/road.ron"),
    ("new-without-path", "new"),
    ("check-phase", "check --phase 0.25"),
    ("check-phase-range", "check --phase 1,0"),
    ("check-runs", "check --runs 0"),
    ("check-many-runs", "check --runs 100000"),
    ("check-threads", "check --threads 0"),
    ("check-fidelity", "check --fidelity best"),
    ("check-step-factor", "check --step-factor 50 --fidelity quick --runs 1"),
    ("check-damping", "check --damping 0.7"),
    ("check-speed", "check --speed 0"),
    ("check-limit", "check --limit -1"),
    ("check-test", "check --test field"),
    ("check-law", "check --law steel"),
    ("check-mesh-file", "check --mesh-file none.ron"),
    ("check-mesh-file-of-another-kind", "check --mesh-file projects/road-cut.ron"),
    ("check-on-a-plate", "check --ex 1.5 --ey 1.5"),
    ("check-wires", "check projects/own-mesh.ron --layout 'our mesh'"),
    ("check-branch", "check --branch published"),
    ("check-instructions", "check --instructions mmx"),
    ("calibrate-without-test", "calibrate"),
    ("calibrate-force", "calibrate --force 0 --deflection 0.6"),
    ("calibrate-from", "calibrate --force 70 --deflection 0.6 --from none"),
    ("calibrate-format", "calibrate --force 70 --deflection 0.6 --format csv"),
    ("calibrate-out", "calibrate --force 70 --deflection 0.6 --out projects/road-cut.ron"),
    ("bench-scene", "bench --scene D"),
    ("bench-both", "bench --convergence --size"),
    ("bench-svg", "bench --size --svg none/bench.svg"),
    ("validate-format", "validate --format csv"),
    ("validate-law", "validate --dem --law steel"),
    ("validate-flags-without-dem", "validate --seed 3"),
];

pub(crate) fn add(table: &mut Table) {
    for (name, line) in REFUSED {
        table.add(format!("error-{name}"), line);
    }
    table.add("error-empty-layout-name", format!("forecast {ROAD} --layout ''"));
    // Every bad file of the tests of files, so also those that come later.
    let folder = "tests/files/invalid";
    let entries = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
    let mut files: Vec<String> =
        entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    files.sort();
    for file in files {
        let name = file.trim_end_matches(".ron");
        table.add(format!("invalid-{name}"), format!("forecast {folder}/{file}"));
    }
    for command in ["compare", "report", "export", "check", "sensitivity", "design"] {
        table.add(format!("invalid-{command}"), format!("{command} {folder}/many_problems.ron"));
    }
}

//! The cases that are refused or fail, where no other test names the words.

use super::cases::Table;

const ROAD: &str = "projects/road-cut.ron";

/// What is refused, by its name.
const REFUSED: &[(&str, &str)] = &[
    ("factor-unit", "forecast --gamma-load '1.5 m'"),
    ("swallowed-flag", "forecast --ex --format"),
    ("factor-range", "forecast --gamma-load 9"),
    ("negative-force", "forecast --force -1"),
    ("zero-deflection", "forecast --deflection 0"),
    ("mesh-show", "mesh show nothing"),
    ("layout-far", "export projects/road-cut.ron --layout zzz"),
    ("folder", "forecast projects"),
    ("command-short", "valdate"),
    ("program-flag", "--fidelity quick forecast"),
    ("dem-flags-without-dem", "sensitivity --runs 3"),
    ("sweep-same-input", "sweep --vary L --from 2 --to 3 --vary2 L --from2 2 --to2 3"),
    ("sweep-many-steps", "sweep --vary L --from 2 --to 3 --steps 100001"),
    ("export-chart-csv", "export projects/road-cut.ron --what chart --format csv"),
    ("export-to-folder", "export projects/road-cut.ron -o projects"),
    ("report-overwrites", "report projects/road-cut.ron --format md -o projects/own-mesh.ron"),
    ("check-step-factor", "check --step-factor 50 --fidelity quick --runs 1"),
    ("check-damping", "check --damping 0.7"),
    ("check-speed", "check --speed 0"),
    ("check-limit", "check --limit -1"),
    ("check-mesh-file-of-another-kind", "check --mesh-file projects/road-cut.ron"),
    ("check-wires", "check projects/own-mesh.ron --layout 'our mesh'"),
    ("calibrate-force", "calibrate --force 0 --deflection 0.6"),
    ("calibrate-from", "calibrate --force 70 --deflection 0.6 --from none"),
];

pub(crate) fn add(table: &mut Table) {
    for (name, line) in REFUSED {
        table.add(format!("error-{name}"), line);
    }
    table.add("error-empty-layout-name", format!("forecast {ROAD} --layout ''"));
    table.add("invalid", "forecast tests/files/invalid/many_problems.ron");
}

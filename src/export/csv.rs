//! CSV: a header whose names carry the units, then one line a point or a layout; names and units are
//! those of the JSON of `meshcast forecast`, lengths m, forces kN.

use super::ExportedLayout;
use super::check::current;
use crate::VERSION;
use crate::curve::Curve;
use crate::forecast::CURVE_POINTS;
use crate::study::result::CheckResult;
use crate::units::{to_kj, to_kn, without_noise};
use csv::{Terminator, WriterBuilder};

/// Curves one below the other. Where `named`, the name of its layout stands before every point.
pub(crate) fn curves<'a>(
    curves: impl IntoIterator<Item = (&'a str, Curve)>,
    named: bool,
) -> String {
    let mut table = Table::new();
    table.row(if named { &["layout", "delta_m", "F_kN"][..] } else { &["delta_m", "F_kN"] });
    for (name, curve) in curves {
        for point in curve.points() {
            let (delta, force) = (number(point.deflection), number(to_kn(point.force)));
            let row = [name, delta.as_str(), force.as_str()];
            table.row(if named { &row[..] } else { &row[1..] });
        }
    }
    table.text()
}

/// The forecast curves of cases; those without a field value have none.
pub fn case_curves(cases: &[ExportedLayout]) -> String {
    let curves_of = cases.iter().filter_map(|case| {
        Some((case.entry.name.as_str(), case.forecast().field?.curve(CURVE_POINTS)))
    });
    curves(curves_of, true)
}

/// All inputs and results, one line a layout. What does not apply is left empty.
pub fn table(cases: &[ExportedLayout]) -> String {
    let mut table = Table::new();
    let columns = COLUMNS.iter().map(|column| column.0).collect::<Vec<_>>();
    table.row(&columns);
    for case in cases {
        table.row(&COLUMNS.iter().map(|column| column.1(case)).collect::<Vec<_>>());
    }
    table.text()
}

/// A column: its name with the unit, and what stands in it.
type Column = (&'static str, fn(&ExportedLayout) -> String);

const COLUMNS: &[Column] = &[
    ("layout", |c| c.entry.name.clone()),
    ("mesh", |c| c.case.mesh.id.clone()),
    ("d_m", |c| number(c.entry.layout.plate)),
    ("L_m", |c| number(c.entry.layout.spacing)),
    ("D_m", |c| number(c.entry.layout.punch)),
    ("ex_m", |c| number(c.entry.layout.ex)),
    ("ey_m", |c| number(c.entry.layout.ey)),
    ("branch", |c| c.forecast().rule.word().into()),
    ("F_lab_kN", |c| kn(c.forecast().laboratory.force)),
    ("delta_lab_m", |c| number(c.forecast().laboratory.deflection)),
    ("alpha_F", |c| number(c.forecast().ratios.force)),
    ("alpha_delta", |c| number(c.forecast().ratios.deflection)),
    ("F_reference_kN", |c| kn(c.forecast().reference.force)),
    ("delta_reference_m", |c| number(c.forecast().reference.deflection)),
    ("eccentricity_F", |c| number(c.forecast().eccentricity.force)),
    ("eccentricity_F_sd", |c| number(c.forecast().eccentricity.force_sd)),
    ("eccentricity_delta", |c| number(c.forecast().eccentricity.deflection)),
    ("eccentricity_delta_sd", |c| number(c.forecast().eccentricity.deflection_sd)),
    ("regime", |c| maybe(c.forecast().field, |f| f.regime.word().into())),
    ("relation", |c| maybe(c.forecast().field, |f| f.branch.word().into())),
    ("F_kN", |c| maybe(c.forecast().field, |f| kn(f.values.force))),
    ("delta_m", |c| maybe(c.forecast().field, |f| number(f.values.deflection))),
    ("other_branch_F_kN", |c| maybe(other(c), |o| kn(o.force))),
    ("other_branch_delta_m", |c| maybe(other(c), |o| number(o.deflection))),
    ("F_field_over_lab", |c| maybe(c.forecast().force_over_lab(), number)),
    ("delta_field_over_lab", |c| maybe(c.forecast().deflection_over_lab(), number)),
    ("anchor_kN", |c| maybe(c.forecast().field, |f| kn(f.values.force))),
    ("secant_kN_per_m", |c| maybe(c.forecast().field, |f| kn(f.secant_at(f.values.deflection)))),
    ("tangent_kN_per_m", |c| maybe(c.forecast().field, |f| kn(f.tangent_at(f.values.deflection)))),
    ("energy_kJ", |c| {
        maybe(c.forecast().field, |f| number(to_kj(f.energy_to(f.values.deflection))))
    }),
    ("gamma_resistance", |c| number(c.case.question.gamma_resistance)),
    ("gamma_load", |c| number(c.case.question.gamma_load)),
    ("resistance_kN", |c| maybe(c.design(), |d| kn(d.resistance))),
    ("design_F_kN", |c| maybe(c.case.question.force, kn)),
    ("load_kN", |c| maybe(at_force(c), |a| kn(a.load))),
    ("utilisation", |c| maybe(at_force(c), |a| number(a.utilisation))),
    ("margin_kN", |c| maybe(at_force(c), |a| kn(a.margin))),
    ("load_delta_m", |c| maybe(at_force(c).and_then(|a| a.deflection), number)),
    ("allowable_delta_m", |c| maybe(c.case.question.deflection, number)),
    ("allowable_F_kN", |c| maybe(at_deflection(c), |a| kn(a.force))),
    ("allowable_design_F_kN", |c| maybe(at_deflection(c), |a| kn(a.design_force))),
    ("allowable_energy_kJ", |c| maybe(at_deflection(c), |a| number(to_kj(a.energy)))),
    ("dem_F_kN", |c| maybe(broke(c), |v| kn(v.force.mean))),
    ("dem_F_sd_kN", |c| maybe(broke(c), |v| kn(v.force.deviation))),
    ("dem_delta_m", |c| maybe(broke(c), |v| number(v.deflection.mean))),
    ("dem_delta_sd_m", |c| maybe(broke(c), |v| number(v.deflection.deviation))),
    ("dem_runs", |c| maybe(c.entry.check.as_ref(), |v| v.runs.to_string())),
    ("dem_fidelity", |c| maybe(c.entry.check.as_ref(), |v| v.wanted.fidelity.word().into())),
    ("dem_stale", |c| maybe(c.entry.check.as_ref(), |v| (!current(c, v)).to_string())),
    ("warnings", |c| c.forecast().warnings.iter().map(|w| w.code()).collect::<Vec<_>>().join(" ")),
    ("fingerprint", |c| c.case.fingerprint().to_string()),
    ("version", |_| VERSION.into()),
];

/// The kept check, if a wire broke in it.
fn broke(case: &ExportedLayout) -> Option<&CheckResult> {
    case.entry.check.as_deref().filter(|v| v.broke())
}

fn other(case: &ExportedLayout) -> Option<crate::forecast::Values> {
    case.forecast().field.and_then(|f| f.other_branch)
}

fn at_force(case: &ExportedLayout) -> Option<crate::forecast::design::AtForce> {
    case.design().and_then(|d| d.at_force)
}

fn at_deflection(case: &ExportedLayout) -> Option<crate::forecast::design::AtDeflection> {
    case.design().and_then(|d| d.at_deflection)
}

fn maybe<T>(value: Option<T>, text: impl Fn(T) -> String) -> String {
    value.map_or(String::new(), text)
}

fn number(value: f64) -> String {
    without_noise(value).to_string()
}

fn kn(newton: f64) -> String {
    number(to_kn(newton))
}

/// Lines that end in a line feed, fields in quotes where RFC 4180 wants them.
struct Table(csv::Writer<Vec<u8>>);

impl Table {
    fn new() -> Table {
        let mut builder = WriterBuilder::new();
        Table(builder.terminator(Terminator::Any(b'\n')).flexible(true).from_writer(Vec::new()))
    }

    fn row<T: AsRef<[u8]>>(&mut self, fields: &[T]) {
        // Writing to memory cannot fail.
        let _ = self.0.write_record(fields);
    }

    fn text(self) -> String {
        let bytes = self.0.into_inner().unwrap_or_default();
        String::from_utf8(bytes).unwrap_or_default()
    }
}

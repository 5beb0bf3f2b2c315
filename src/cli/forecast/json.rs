//! A forecast as JSON: SI with kN, one object a layout.

use super::{Answered, BASIS};
use crate::cli::output::{Fault, json_list};
use crate::forecast::eccentricity::published;
use crate::forecast::{CURVE_POINTS, Field, Forecast, Strength};
use crate::method::DerivedMethod;
use crate::show::columns::{OVER_LAB, RATIOS, STIFFNESS};
use crate::show::objects::{curve, design, head, inputs, values, warnings};
use crate::show::value::{Object, Value};
use crate::show::verdict;
use crate::words::Choice;

/// One object, or a list of them with one line each.
pub(crate) fn report(answered: &[Answered], several: bool) -> Result<String, Fault> {
    json_list(answered.iter().map(one), several)
}

fn one(a: &Answered) -> Object {
    let f = &a.forecast;
    let other = f.field.ok().and_then(|field| {
        let relation = field.branch.other().word();
        Some(values(field.other_branch?).with("relation", relation))
    });
    head(a.name.as_deref(), a.case.fingerprint(), inputs(&a.case))
        .with("lab", laboratory(a))
        .with("field_reference", values(f.reference))
        .with("field", f.field.ok().map(|of| field(f, &of)))
        .with("other_branch", other)
        .with("eccentricity", eccentricity(f))
        .with("ratios", ratios(f))
        .with("design", a.design.map(|answer| design(&answer, &a.case.asked())))
        .maybe("verdict", a.case.question.asks().then(|| verdict::object(&a.case, &a.verdict)))
        .with(
            "curve",
            f.field.ok().and_then(|field| Some(curve(&field.end()?.curve(CURVE_POINTS)))),
        )
        .with("warnings", warnings(&f.warnings))
        .with("basis", BASIS)
}

fn laboratory(a: &Answered) -> Object {
    let record = &a.case.mesh.laboratory;
    let measured = Strength { force: record.force, deflection: record.deflection };
    values(a.forecast.laboratory)
        .with("statistic", record.statistic.word())
        .with("panel_m", record.panel)
        .with("punch_m", record.punch)
        // The record itself where it was measured on another panel.
        .with("measured", (measured != a.forecast.laboratory).then(|| values(measured)))
        .with("source", record.source.clone())
}

fn field(f: &Forecast, field: &Field) -> Object {
    values(field.values)
        .with("regime", field.regime.word())
        .with("branch", f.rule.word())
        .with("relation", field.branch.word())
        .maybe("method", field.method.map(|method| of_method(field, method)))
        .columns(&STIFFNESS, field)
}

/// The derived method in use, and what the published one gives.
fn of_method(field: &Field, method: &DerivedMethod) -> Object {
    let published = field.published.map(values);
    Object::new()
        .with("name", method.name.clone())
        .with("blocks", method.blocks.word())
        .with("runs", method.runs.used)
        .with("revisions", method.revisions.clone())
        .with("variation_F", Value::Exact(field.variation))
        .with("published", published)
}

fn eccentricity(f: &Forecast) -> Object {
    let sources = published().sources().iter().cloned().map(Value::from);
    Object::new()
        .with("F", f.eccentricity.force)
        .with("delta", f.eccentricity.deflection)
        .with("F_sd", f.eccentricity.force_sd)
        .with("delta_sd", f.eccentricity.deflection_sd)
        .with("supported", f.eccentricity.supported)
        .with("sources", sources.collect::<Value>())
}

fn ratios(f: &Forecast) -> Object {
    Object::new().columns(&RATIOS, f).with("default", f.ratios.default).columns(&OVER_LAB, f)
}

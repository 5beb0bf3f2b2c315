//! `meshcast mesh show ID`.

use crate::cli::case::unknown_mesh;
use crate::cli::output::{CommandEnd, Fault, Format, json, result, wrapped};
use crate::forecast::ratios;
use crate::mesh::strength::StrengthRecord;
use crate::mesh::wire::{CurvePoint, Slack, WireData};
use crate::mesh::{MeshType, catalogue, strength};
use crate::project::Home;
use crate::show::objects::pair;
use crate::show::say;
use crate::show::value::{Object, Value, exact};
use crate::units::{Units, length_entry, shortest, to_kn};
use crate::words::Choice;

/// Everything of one mesh.
pub(crate) fn run(id: &str, format: Format) -> CommandEnd {
    if let Some(record) = strength::find(id) {
        return match format {
            Format::Json => result(json(&strength_object(record))? + "\n"),
            Format::Text => result(strength_text(record)),
        };
    }
    let found = match catalogue::find(id) {
        None => Home::find().own_meshes()?.into_iter().find(|mesh| mesh.id == id),
        found => found,
    };
    let Some(mesh) = found else {
        let known: Vec<String> = catalogue::all().iter().map(|m| m.id.clone()).collect();
        return Err(Fault::input(unknown_mesh("ID", id, &known)));
    };
    match format {
        Format::Json => result(json(&object(&mesh))? + "\n"),
        Format::Text => result(text(&mesh)),
    }
}

fn text(mesh: &MeshType) -> String {
    let mut lines = Vec::new();
    let mut line = |head: &str, text: &str| {
        lines.extend(wrapped(&format!("{head:<16}"), text, 80));
    };
    let metres = |v: f64| format!("{} m", length_entry(v, Units::METRES));
    let lab = &mesh.laboratory;
    line("id", &mesh.id);
    line("name", mesh.title());
    if mesh.reference {
        line("", "the double-twist reference mesh of the method");
    }
    if mesh.example {
        line("", "an example of the format, not a product's values");
    }
    line("force F_l", &format!("{} kN ({})", shortest(to_kn(lab.force)), lab.statistic.word()));
    let delta = lab.deflection;
    line(
        "deflection",
        &delta.map_or("not stated: forces only".into(), |delta| {
            format!("{} ({})", metres(delta), lab.statistic.word())
        }),
    );
    line("panel", &metres(lab.panel));
    line("punch", &metres(lab.punch));
    line("standard", if lab.standard.is_empty() { "not stated" } else { &lab.standard });
    line("date", if lab.date.is_empty() { "not stated" } else { &lab.date });
    line("source", &lab.source);
    let used = ratios::of_mesh(mesh);
    let ratios = format!("alpha_F {:.4}, alpha_delta {:.4}", used.force, used.deflection);
    if let Some(adopted) = &mesh.adopted {
        line("adopted", &say::adopted(adopted, Units::METRES));
        let names: Vec<&str> = adopted.methods.iter().map(|kept| kept.0.name.as_str()).collect();
        line("methods", &format!("{}; with method: derived", names.join(", ")));
    }
    match &mesh.ratios {
        Some(own) => {
            line("ratios", &ratios);
            line("source", &own.source);
        }
        None if mesh.reference => line("ratios", &format!("{ratios} (the method's own)")),
        None => line("ratios", &format!("{ratios} (default, of the double-twist reference)")),
    }
    match &mesh.wire {
        Some(wire) => wire_text(wire, &mut line),
        None => line("net and wire", "not stated: forecast only, no check"),
    }
    lines.join("\n") + "\n"
}

/// A mesh of which only the strength is known.
fn strength_text(record: &StrengthRecord) -> String {
    let mut lines = Vec::new();
    let mut line = |head: &str, text: &str| {
        lines.extend(wrapped(&format!("{head:<16}"), text, 80));
    };
    let mm = |v: f64| format!("{} mm", length_entry(v, Units::MILLIMETRES));
    line("id", &record.id);
    line("name", &record.name);
    line("net", &format!("opening {}, wire {}", mm(record.opening), mm(record.diameter)));
    let across = record.across.map_or("not stated".into(), |v| format!("{} kN/m", shortest(v)));
    let kind = record.kind.word();
    line(
        "strength",
        &format!("{} kN/m along the twists, {across} across ({kind})", shortest(record.along)),
    );
    line("standard", &record.standard);
    line("date", &record.date);
    line("source", &record.source);
    let problem = record.problem();
    line("MISSING", &format!("{}; {}; {}", problem.message, record.missing, problem.advice));
    lines.join("\n") + "\n"
}

/// The same as JSON.
pub(super) fn strength_object(record: &StrengthRecord) -> Object {
    Object::new()
        .with("id", record.id.clone())
        .with("name", record.name.clone())
        .with("opening_m", Value::Exact(record.opening))
        .with("diameter_m", Value::Exact(record.diameter))
        .with("strength_along_kN_per_m", Value::Exact(record.along))
        .with("strength_across_kN_per_m", record.across.map(Value::Exact))
        .with("kind", record.kind.word())
        .with("standard", record.standard.clone())
        .with("date", record.date.clone())
        .with("source", record.source.clone())
        .with("missing", format!("{}; {}", record.problem().advice, record.missing))
}

fn wire_text(wire: &WireData, line: &mut impl FnMut(&str, &str)) {
    let mm = |v: f64| format!("{} mm", length_entry(v, Units::MILLIMETRES));
    let net = &wire.net;
    line(
        "net",
        &format!(
            "opening {}, twist {}, wire along the twist {}",
            mm(net.opening),
            mm(net.twist),
            mm(net.projection)
        ),
    );
    line(
        "wire",
        &format!(
            "diameter {}, node {} g, node radius {}",
            mm(net.diameter),
            shortest(net.node_mass * 1000.0),
            mm(net.node_radius)
        ),
    );
    let curve = |points: &[CurvePoint]| {
        let all: Vec<String> =
            points.iter().map(|p| format!("({}, {})", shortest(p.0), shortest(p.1))).collect();
        all.join(" ")
    };
    line("single wire", &format!("strain, stress in MPa: {}", curve(&wire.single)));
    line("double twist", &format!("strain, stress in MPa: {}", curve(&wire.double_twist)));
    let d = &wire.distortion;
    line(
        "distortion",
        &format!(
            "lambda_u {}, lambda_F {}, slack {}",
            shortest(d.lambda_u),
            shortest(d.lambda_f),
            slack(d.slack)
        ),
    );
    line("source", &wire.source);
}

fn slack(slack: Slack) -> String {
    match slack {
        Slack::Fixed(t) => format!("fixed at {}", shortest(t)),
        Slack::Triangular => "triangular".to_string(),
    }
}

/// A mesh as JSON: SI with kN, stresses in MPa.
pub(super) fn object(mesh: &MeshType) -> Object {
    let lab = &mesh.laboratory;
    let lab = pair(lab.force, lab.deflection)
        .with("statistic", lab.statistic.word())
        .with("panel_m", lab.panel)
        .with("punch_m", lab.punch)
        .with("standard", lab.standard.clone())
        .with("date", lab.date.clone())
        .with("source", lab.source.clone());
    let used = ratios::of_mesh(mesh);
    let ratios = Object::new()
        .with("alpha_F", used.force)
        .with("alpha_delta", used.deflection)
        .with("default", used.default)
        .with("source", mesh.ratios.as_ref().map(|r| r.source.clone()));
    Object::new()
        .with("id", mesh.id.clone())
        .with("name", mesh.title().to_string())
        .with("reference", mesh.reference)
        .with("example", mesh.example)
        .with("lab", lab)
        .with("ratios", ratios)
        .with("wire", mesh.wire.as_ref().map(wire_object))
}

fn wire_object(wire: &WireData) -> Object {
    let curve = |points: &[CurvePoint]| points.iter().map(|p| exact([p.0, p.1])).collect::<Value>();
    let (net, distortion) = (&wire.net, &wire.distortion);
    Object::new()
        .with("opening_m", Value::Exact(net.opening))
        .with("twist_m", Value::Exact(net.twist))
        .with("projection_m", Value::Exact(net.projection))
        .with("diameter_m", Value::Exact(net.diameter))
        .with("node_mass_kg", Value::Exact(net.node_mass))
        .with("node_radius_m", Value::Exact(net.node_radius))
        .with("single_strain_stress_MPa", curve(&wire.single))
        .with("double_twist_strain_stress_MPa", curve(&wire.double_twist))
        .with("lambda_u", Value::Exact(distortion.lambda_u))
        .with("lambda_F", Value::Exact(distortion.lambda_f))
        .with("slack", slack(distortion.slack))
        .with("source", wire.source.clone())
}

//! `meshcast mesh show ID`.

use crate::cli::case::unknown_mesh;
use crate::cli::output::{CommandEnd, Fault, Format, json, number, result, wrapped};
use crate::forecast::ratios;
use crate::mesh::wire::{CurvePoint, Slack, WireData};
use crate::mesh::{MeshType, catalogue};
use crate::units::{LengthUnit, length_entry, shortest, to_kn};
use serde::Serialize;

/// Everything of one mesh.
pub(crate) fn run(id: &str, format: Format) -> CommandEnd {
    let Some(mesh) = catalogue::find(id) else {
        let known: Vec<String> = catalogue::all().iter().map(|m| m.id.clone()).collect();
        return Err(Fault::input(unknown_mesh("ID", id, &known)));
    };
    match format {
        Format::Json => result(json(&MeshJson::of(&mesh))? + "\n"),
        Format::Text => result(text(&mesh)),
    }
}

fn text(mesh: &MeshType) -> String {
    let mut lines = Vec::new();
    let mut line = |head: &str, text: &str| {
        lines.extend(wrapped(&format!("{head:<16}"), text, 80));
    };
    let metres = |v: f64| format!("{} m", length_entry(v, LengthUnit::Metre));
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
    line("deflection", &format!("{} ({})", metres(lab.deflection), lab.statistic.word()));
    line("panel", &metres(lab.panel));
    line("punch", &metres(lab.punch));
    line("standard", if lab.standard.is_empty() { "not stated" } else { &lab.standard });
    line("source", &lab.source);
    let used = ratios::of_mesh(mesh);
    let ratios = format!("alpha_F {:.4}, alpha_delta {:.4}", used.force, used.deflection);
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

fn wire_text(wire: &WireData, line: &mut impl FnMut(&str, &str)) {
    let mm = |v: f64| format!("{} mm", length_entry(v, LengthUnit::Millimetre));
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
#[derive(Serialize)]
pub(super) struct MeshJson<'a> {
    id: &'a str,
    name: &'a str,
    reference: bool,
    example: bool,
    lab: LabJson<'a>,
    ratios: RatiosJson<'a>,
    wire: Option<WireJson<'a>>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct LabJson<'a> {
    #[serde(serialize_with = "number")]
    F_kN: f64,
    #[serde(serialize_with = "number")]
    delta_m: f64,
    statistic: &'static str,
    #[serde(serialize_with = "number")]
    panel_m: f64,
    #[serde(serialize_with = "number")]
    punch_m: f64,
    standard: &'a str,
    source: &'a str,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct RatiosJson<'a> {
    #[serde(serialize_with = "number")]
    alpha_F: f64,
    #[serde(serialize_with = "number")]
    alpha_delta: f64,
    #[serde(rename = "default")]
    is_default: bool,
    source: Option<&'a str>,
}

#[derive(Serialize)]
#[allow(non_snake_case, reason = "the names are the paper's symbols")]
struct WireJson<'a> {
    opening_m: f64,
    twist_m: f64,
    projection_m: f64,
    diameter_m: f64,
    node_mass_kg: f64,
    node_radius_m: f64,
    single_strain_stress_MPa: &'a [CurvePoint],
    double_twist_strain_stress_MPa: &'a [CurvePoint],
    lambda_u: f64,
    lambda_F: f64,
    slack: String,
    source: &'a str,
}

impl<'a> MeshJson<'a> {
    pub(super) fn of(mesh: &'a MeshType) -> MeshJson<'a> {
        let (lab, used) = (&mesh.laboratory, ratios::of_mesh(mesh));
        MeshJson {
            id: &mesh.id,
            name: mesh.title(),
            reference: mesh.reference,
            example: mesh.example,
            lab: LabJson {
                F_kN: to_kn(lab.force),
                delta_m: lab.deflection,
                statistic: lab.statistic.word(),
                panel_m: lab.panel,
                punch_m: lab.punch,
                standard: &lab.standard,
                source: &lab.source,
            },
            ratios: RatiosJson {
                alpha_F: used.force,
                alpha_delta: used.deflection,
                is_default: used.default,
                source: mesh.ratios.as_ref().map(|r| r.source.as_str()),
            },
            wire: mesh.wire.as_ref().map(|wire| WireJson {
                opening_m: wire.net.opening,
                twist_m: wire.net.twist,
                projection_m: wire.net.projection,
                diameter_m: wire.net.diameter,
                node_mass_kg: wire.net.node_mass,
                node_radius_m: wire.net.node_radius,
                single_strain_stress_MPa: &wire.single,
                double_twist_strain_stress_MPa: &wire.double_twist,
                lambda_u: wire.distortion.lambda_u,
                lambda_F: wire.distortion.lambda_f,
                slack: slack(wire.distortion.slack),
                source: &wire.source,
            }),
        }
    }
}

//! `meshcast mesh list`.

use super::show::{object, strength_object};
use crate::cli::output::{CommandEnd, Format, json, result};
use crate::mesh::{catalogue, strength};
use crate::project::Home;
use crate::show::value::Value;
use crate::units::{Units, force_text, maybe_length_text, shortest};
use std::fmt::Write;

/// The catalogue, one line a mesh, or as a JSON list of what `mesh show` prints.
pub(crate) fn run(format: Format) -> CommandEnd {
    let meshes = catalogue::all();
    let own = Home::find().own_meshes()?;
    if format == Format::Json {
        let records = strength::all().iter().map(strength_object);
        let all: Value = meshes
            .iter()
            .map(|m| object(m))
            .chain(own.iter().map(|m| object(m)))
            .chain(records)
            .collect();
        return result(json(&all)? + "\n");
    }
    let widest = |text: fn(&crate::mesh::MeshType) -> &str, least: usize| {
        meshes.iter().map(|m| text(m).chars().count()).max().unwrap_or(0).max(least)
    };
    let (id, name) = (widest(|m| &m.id, 2), widest(|m| m.title(), 4));
    let mut out = format!(
        "{:<id$}  {:<name$}  {:>8}  {:>8}  {:<4}  remarks\n",
        "id", "name", "F_l", "delta_l", ""
    );
    for mesh in meshes {
        let lab = &mesh.laboratory;
        let mut remarks = Vec::new();
        if mesh.reference {
            remarks.push("reference");
        }
        if mesh.example {
            remarks.push("example");
        }
        if mesh.ratios.is_some() {
            remarks.push("own ratios");
        }
        if mesh.wire.is_none() {
            remarks.push("forecast only");
        }
        let line = format!(
            "{:<id$}  {:<name$}  {:>8}  {:>8}  {:<4}  {}",
            mesh.id,
            mesh.title(),
            force_text(lab.force, Units::METRES),
            maybe_length_text(lab.deflection, Units::METRES),
            lab.statistic.short(),
            remarks.join(", ")
        );
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", line.trim_end());
    }
    if !own.is_empty() {
        out.push_str("\nof your own, to be taken into a project with m:\n");
    }
    for mesh in own {
        let force = force_text(mesh.laboratory.force, Units::METRES);
        let _ = writeln!(out, "{:<20}  {:>8}  {}", mesh.id, force, mesh.title());
    }
    out.push_str("\nstrength of the net alone, no forecast (mesh show ID says what is missing):\n");
    for record in strength::all() {
        let _ = writeln!(
            out,
            "{:<20}  {:>5} kN/m  {:<4}  {} {}",
            record.id,
            shortest(record.along),
            record.kind.short(),
            record.standard,
            record.date
        );
    }
    result(out)
}

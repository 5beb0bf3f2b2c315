//! Project to text: the clean form that a new file has, with what each value means beside it.

use super::decode::LAYOUT_FIELDS;
use super::kept;
use super::schema::{MeshUse, MethodFile, NamedLayout, Project};
use super::text::scalar::quoted;
use crate::case::Input;
use crate::case::input::{LX, Missing};
use crate::layout::{Blocks, BranchRule, MethodChoice, PunchShape, Twists};
use crate::method::DerivedMethod;
use crate::units::{ForceUnit, Quantity, Units, from_kn, parse, shortest, to_kn};
use crate::words::Choice;
use std::fmt::Write;

/// Something that no file can hold.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{what} cannot be written: {why}")]
pub struct Unwritable {
    pub(crate) what: String,
    /// Why not.
    pub(crate) why: String,
}

/// RON as the program writes it everywhere: optional values need no `Some`.
pub(super) fn ron_options() -> ron::Options {
    ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME)
}

/// A value as RON, one field a line.
pub(super) fn pretty(value: &impl serde::Serialize) -> Result<String, ron::Error> {
    let pretty = ron::ser::PrettyConfig::new()
        .depth_limit(4)
        .new_line("\n")
        .extensions(ron::extensions::Extensions::IMPLICIT_SOME);
    Ok(without_extension(ron_options().to_string_pretty(value, pretty)?))
}

/// A value as a file of its own, with a comment on top; nothing where it cannot be written.
pub(crate) fn commented(value: &impl serde::Serialize, comment: &str) -> Option<String> {
    let head: String = comment.lines().map(|line| format!("// {line}\n")).collect();
    Some(format!("{head}{}\n", pretty(value).ok()?))
}

/// A value as RON on one line.
pub(super) fn compact(value: &impl serde::Serialize) -> Result<String, ron::Error> {
    Ok(without_extension(ron_options().to_string(value)?))
}

/// The writer names the extension that is on anyway.
fn without_extension(text: String) -> String {
    match text.strip_prefix("#![enable(implicit_some)]") {
        Some(rest) => rest.trim_start().to_string(),
        None => text,
    }
}

/// A number as the file holds it, forces in kN: the shortest text that is read back as exactly this
/// value.
pub(crate) fn number(si: f64, quantity: Quantity) -> String {
    let kilo = matches!(quantity, Quantity::Force | Quantity::Pressure);
    let back = |text: &str| -> Option<f64> {
        let v: f64 = text.parse().ok()?;
        Some(if kilo { from_kn(v) } else { v })
    };
    let written = if kilo { to_kn(si) } else { si };
    for text in [shortest(written), format!("{written:?}")] {
        if back(&text) == Some(si) {
            return text;
        }
    }
    // A force or pressure whose kilonewtons do not lead back to it: newtons do.
    let unit = if quantity == Quantity::Pressure { "Pa" } else { "N" };
    format!("\"{si:?} {unit}\"")
}

/// A number in a unit that the user chose, if it is read back as exactly this value.
pub(crate) fn number_with_unit(si: f64, quantity: Quantity, unit: &str) -> Option<String> {
    let per_si = match unit {
        "mm" | "MM" => 1000.0,
        "cm" => 100.0,
        "m" | "N" | "Pa" => 1.0,
        "kN" | "kPa" | "kN/m2" => 1.0e-3,
        "MN" => 1.0e-6,
        _ => return None,
    };
    let bare = shortest(si * per_si);
    let text = format!("{} {unit}", bare.strip_suffix(".0").unwrap_or(&bare));
    (parse(&text, quantity, Units::METRES).ok() == Some(si)).then(|| format!("\"{text}\""))
}

const HEAD: &str = "\
// A meshcast project. Lengths are metres and forces kN; a value may carry a unit in quotes instead:
// \"250 mm\", \"25000 N\". Comments stay when meshcast saves the file.
";

const BASIS_HELP: &str =
    "    // What verdicts go by: mean, or characteristic values, which 5 % fall below.
    // For the head of a report these may stand here too: client, author, checker, revision, date.
";

const LAYOUT_HELP: &str = "    // One entry a layout.
    //   name    unique
    //   d       side of the anchor plate, published range 0.16 to 0.48 m
    //   L       anchor spacing, published range 1.25 to 4.5 m; or Lx and Ly, across and up the slope
    //   D       diameter of the punching block, published range 0.1 to 2.5 m
    // These may be left out:
    //   ex, ey  offset of the block across and up the slope, -L/2 to L/2, default 0 m
    //   stagger true shifts every other row of anchors by half the spacing in it
    //   twists  down (default) the slope or across it
    //   shape   of the block in the check: dome (default), sphere, flat
    //   blocks  how those of other cells stand: paper (default), repeated, mirrored, single, worst
    //   method  of the forecast: \"pol-gabrieli-2021\" (default) or \"derived\" from simulations
    //   mesh    identifier, default the first of `meshes`
    //   branch  published (default) or conservative
    //   design_force          kN, above 0; or
    //   pressure              kN/m2 of face, above 0, never beside design_force
    //   allowable_deflection  m, above 0
    //   anchor_resistance     kN, above 0
    //   gamma_resistance, gamma_load  partial factors, 0.5 to 5, default 1
    //   overlay true draws the curve over the current one, up to four
    //   note    free text
    //   check   result of the last check, written by meshcast; may be taken out
";

/// The text of a new project with one layout at the published reference point, with comments that
/// explain the format. What `meshcast new` writes.
pub fn new_project(name: &str) -> String {
    project(&Project::starter(name)).expect("a starter has no mesh and no check of its own")
}

/// The methods that a project names by file.
pub(super) fn method_files(files: &[MethodFile]) -> String {
    let quoted: Vec<String> = files.iter().map(|named| quoted(&named.file, false)).collect();
    format!("[{}]", quoted.join(", "))
}

/// A project in the clean form.
///
/// # Errors
/// Names what cannot be written.
pub fn project(p: &Project) -> Result<String, Unwritable> {
    let mut out = HEAD.to_string();
    out.push_str("(\n");
    // Writing to a string cannot fail.
    let _ = writeln!(out, "    version: {},", p.version);
    let _ = writeln!(out, "    name: {},", quoted(&p.name, false));
    let _ = writeln!(out, "    site: {},", quoted(&p.site, false));
    for (field, text) in p.title.rows().into_iter().filter(|(_, text)| !text.is_empty()) {
        let _ = writeln!(out, "    {field}: {},", quoted(text, false));
    }
    let _ = writeln!(out, "    notes: {},", quoted(&p.notes, true));
    out.push_str(BASIS_HELP);
    let _ = writeln!(out, "    basis: {},", p.basis.word());
    if !p.method_files.is_empty() {
        let _ = writeln!(out, "    method_files: {},", method_files(&p.method_files));
    }
    out.push_str(
        "    // Mesh types: catalogue identifiers (meshcast mesh list) or meshes written out.\n",
    );
    let _ = writeln!(out, "    meshes: [");
    for mesh in &p.meshes {
        let _ = writeln!(out, "        {},", mesh_use(mesh, 2)?);
    }
    out.push_str("    ],\n");
    out.push_str(LAYOUT_HELP);
    out.push_str("    layouts: [\n");
    for l in &p.layouts {
        let _ = writeln!(out, "        {},", layout(l, p.default_mesh(), "        ", "\n")?);
    }
    out.push_str("    ],\n");
    let _ = writeln!(out, "    display: ({}),", display(p.display.units));
    out.push_str(")\n");
    Ok(out)
}

/// The fields of `display`. An older program does not know `force_unit`: kN is not written.
pub(super) fn display(units: Units) -> String {
    let force = match units.force {
        ForceUnit::Kilonewton => String::new(),
        other => format!(", force_unit: {}", other.symbol()),
    };
    format!("length_unit: {}{force}", units.length.symbol())
}

/// An item of `meshes`, `indent` steps of four blanks in.
///
/// # Errors
/// Names the mesh if it cannot be written.
pub(crate) fn mesh_use(mesh: &MeshUse, indent: usize) -> Result<String, Unwritable> {
    let mesh = match mesh {
        MeshUse::Catalogue(id) => return Ok(quoted(id, false)),
        MeshUse::Inline(mesh) => mesh,
    };
    let text = pretty(&**mesh)
        .map_err(|e| Unwritable { what: format!("the mesh {}", mesh.id), why: e.to_string() })?;
    // Line feeds inside strings are escaped by the writer, so every one of these starts a line.
    Ok(text.replace('\n', &format!("\n{}", "    ".repeat(indent))))
}

/// An item of `layouts`, one field a line: its opening bracket stands where it is put, the other
/// lines begin with `indent`, and `newline` ends them.
///
/// # Errors
/// Names what cannot be written.
pub(crate) fn layout(
    l: &NamedLayout,
    default_mesh: &str,
    indent: &str,
    newline: &str,
) -> Result<String, Unwritable> {
    let fields: String = layout_fields(l, default_mesh)?
        .iter()
        .map(|field| format!("{newline}{indent}    {field},"))
        .collect();
    Ok(format!("({fields}{newline}{indent})"))
}

/// An item of `layouts` on one line.
///
/// # Errors
/// Names what cannot be written.
pub(crate) fn layout_on_one_line(
    l: &NamedLayout,
    default_mesh: &str,
) -> Result<String, Unwritable> {
    Ok(format!("({})", layout_fields(l, default_mesh)?.join(", ")))
}

fn layout_fields(l: &NamedLayout, default_mesh: &str) -> Result<Vec<String>, Unwritable> {
    let mut fields = Vec::new();
    for field in LAYOUT_FIELDS {
        if let Some(value) = layout_field(l, field, default_mesh)? {
            fields.push(format!("{field}: {value}"));
        }
    }
    Ok(fields)
}

/// The text of a layout's field; nothing where it may be left out because it has its default.
///
/// # Errors
/// Names what cannot be written.
pub(crate) fn layout_field(
    l: &NamedLayout,
    field: &str,
    default_mesh: &str,
) -> Result<Option<String>, Unwritable> {
    let two = l.layout.grid.up.is_some();
    if (field == LX && !two) || (field == Input::Spacing.row().name && two) {
        return Ok(None);
    }
    if let Some(input) = Input::named(field) {
        let value = l.get(input).filter(|v| input.row().missing != Missing::Means(*v));
        return Ok(value.map(|v| number(v, input.row().quantity)));
    }
    Ok(match field {
        "name" => Some(quoted(&l.name, false)),
        "mesh" => (l.mesh != default_mesh).then(|| quoted(&l.mesh, false)),
        "blocks" => {
            let blocks = l.layout.blocks;
            (blocks != Blocks::default()).then(|| blocks.word().to_string())
        }
        "shape" => {
            let shape = l.layout.shape;
            (shape != PunchShape::default()).then(|| shape.word().to_string())
        }
        "stagger" => l.layout.grid.stagger.then(|| "true".to_string()),
        "twists" => {
            let twists = l.layout.grid.twists;
            (twists != Twists::default()).then(|| twists.word().to_string())
        }
        "method" => {
            let method = l.layout.method;
            (method != MethodChoice::default()).then(|| quoted(method.word(), false))
        }
        "branch" => (l.branch != BranchRule::default()).then(|| l.branch.word().to_string()),
        "overlay" => l.overlay.then(|| "true".to_string()),
        "note" => (!l.note.is_empty()).then(|| quoted(&l.note, true)),
        "check" => l.check.as_ref().map(|result| kept::write(result, &l.name)).transpose()?,
        _ => None,
    })
}

/// The text of a derived method's file, with the commands that make it on top; nothing where it cannot be
/// written so that it is read back.
pub(crate) fn method_text(method: &DerivedMethod) -> Option<String> {
    let campaigns = method.campaigns.iter().map(|c| {
        let share = if c.eccentric == 0.5 {
            String::new()
        } else {
            format!(" --eccentric {}", c.eccentric)
        };
        format!(
            "\n  meshcast campaign --blocks {} --runs {} --seed {}{share} --fidelity {} --out DIR",
            method.blocks.word(),
            c.runs,
            c.seed,
            method.fidelity
        )
    });
    let comment = format!(
        "A method of forecasts derived from simulations. Forces kN, lengths m. Made by{}\n  meshcast derive DIR... --out THIS",
        campaigns.collect::<String>()
    );
    commented(method, &comment).filter(|text| DerivedMethod::from_ron(text).as_ref() == Ok(method))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::canned;

    #[test]
    fn methods_that_are_named_by_file_are_written_and_read() {
        let mut p = Project::starter("p");
        p.method_files = vec![MethodFile { file: "a \"b\"/m.ron".into(), method: None }];
        let text = project(&p).unwrap();
        let parsed = super::super::load::parse_text(&text, "").unwrap();
        assert_eq!(parsed.project, p);
        // A text that stands in no file has no folder to look in.
        assert!(super::super::parse(&text, "p.ron").is_err());
    }

    #[test]
    fn a_method_comes_back_from_its_file_to_the_last_bit() {
        let method = canned::method();
        let text = commented(&method, "two\nlines").unwrap();
        assert!(text.starts_with("// two\n// lines\n("), "{text}");
        assert_eq!(DerivedMethod::from_ron(&text).unwrap(), method);
        let wrong = text.replacen("format: 1", "format: 99", 1);
        assert!(DerivedMethod::from_ron(&wrong).unwrap_err().contains("derive it again"));
        assert!(DerivedMethod::from_ron("(format: 1)").is_err());
    }
}

//! Tree to project: the fields of a file, and the project that they make.

use super::error::Found;
use super::kept::{self, Kept};
use super::read::soft::{Refused, Soft};
use super::schema::{
    CURRENT_VERSION, Display, MeshUse, MethodFile, NamedLayout, Project, TitleBlock,
};
use super::text::{Node, NodeKind, Shape};
use super::{read, words};
use crate::case::Input;
use crate::layout::{
    Blocks, BranchRule, Grid, Layout, MethodChoice, PunchShape, REFERENCE, Twists,
};
use crate::mesh::MeshType;
use crate::problem::Problem;
use crate::study::verdict::Basis;
use crate::units::{self, ForceUnit, LengthUnit, Units};
use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor, value::MapAccessDeserializer};
use std::fmt;
use std::sync::Arc;

/// Fields of a project, in the order in which they are written.
pub(crate) const PROJECT_FIELDS: &[&str] = &[
    "version",
    "name",
    "site",
    "client",
    "author",
    "checker",
    "revision",
    "date",
    "notes",
    "basis",
    "method_files",
    "meshes",
    "layouts",
    "display",
];
/// Fields of a layout, in the order in which they are written.
pub(crate) const LAYOUT_FIELDS: &[&str] = &[
    "name",
    "d",
    "L",
    "Lx",
    "Ly",
    "stagger",
    "twists",
    "D",
    "ex",
    "ey",
    "shape",
    "blocks",
    "mesh",
    "branch",
    "method",
    "design_force",
    "pressure",
    "allowable_deflection",
    "anchor_resistance",
    "gamma_resistance",
    "gamma_load",
    "overlay",
    "note",
    "check",
];
/// Fields of the display preferences.
pub(crate) const DISPLAY_FIELDS: &[&str] = &["length_unit", "force_unit"];

/// A project as a file of the current version has it. Which fields cannot be left out is said in
/// [`words::needed`].
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename = "Project", deny_unknown_fields)]
pub(super) struct ProjectFile {
    /// Looked at before all else, see [`version`].
    version: Soft<Factor>,
    name: Soft<String>,
    site: Soft<String>,
    client: Soft<String>,
    author: Soft<String>,
    checker: Soft<String>,
    revision: Soft<String>,
    date: Soft<String>,
    notes: Soft<String>,
    basis: Soft<Basis>,
    method_files: Soft<Vec<Soft<String>>>,
    meshes: Soft<Vec<Soft<MeshUse>>>,
    layouts: Soft<Vec<Soft<LayoutFile>>>,
    display: Soft<DisplayFile>,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename = "Layout", deny_unknown_fields)]
struct LayoutFile {
    name: Soft<String>,
    d: Soft<Length>,
    #[serde(rename = "L")]
    spacing: Soft<Length>,
    #[serde(rename = "Lx")]
    spacing_x: Soft<Length>,
    #[serde(rename = "Ly")]
    spacing_y: Soft<Length>,
    stagger: Soft<bool>,
    twists: Soft<Twists>,
    #[serde(rename = "D")]
    punch: Soft<Length>,
    ex: Soft<Length>,
    ey: Soft<Length>,
    shape: Soft<PunchShape>,
    blocks: Soft<Blocks>,
    mesh: Soft<String>,
    branch: Soft<BranchRule>,
    method: Soft<MethodChoice>,
    design_force: Soft<Force>,
    pressure: Soft<Pressure>,
    allowable_deflection: Soft<Length>,
    anchor_resistance: Soft<Force>,
    gamma_resistance: Soft<Factor>,
    gamma_load: Soft<Factor>,
    overlay: Soft<bool>,
    note: Soft<String>,
    check: Soft<Kept>,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename = "Display", deny_unknown_fields)]
struct DisplayFile {
    length_unit: Soft<LengthUnit>,
    force_unit: Soft<ForceUnit>,
}

/// Metres.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(transparent)]
struct Length(#[serde(with = "units::file::length")] f64);

/// Newtons.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(transparent)]
struct Force(#[serde(with = "units::file::force")] f64);

/// Newtons on a square metre.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(transparent)]
struct Pressure(#[serde(with = "units::file::pressure")] f64);

/// No unit.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(transparent)]
struct Factor(#[serde(with = "units::file::number")] f64);

impl<'de> Deserialize<'de> for MeshUse {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reading;

        impl<'de> Visitor<'de> for Reading {
            type Value = MeshUse;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a mesh identifier in quotes, or a mesh in brackets,")
            }
            fn visit_str<E: Error>(self, id: &str) -> Result<MeshUse, E> {
                Ok(MeshUse::Catalogue(id.to_string()))
            }
            fn visit_map<A: MapAccess<'de>>(self, fields: A) -> Result<MeshUse, A::Error> {
                let mesh = MeshType::deserialize(MapAccessDeserializer::new(fields))?;
                Ok(MeshUse::Inline(Arc::new(mesh)))
            }
        }

        deserializer.deserialize_any(Reading)
    }
}

/// Reads a tree of the current version as a project. The result is checked field by field, but not
/// yet as a whole ([`Project::check`]).
///
/// # Errors
/// Everything that is wrong.
pub(crate) fn project(text: &str, root: &Node) -> Result<Project, Vec<Found>> {
    let file: ProjectFile = read::values(text, root, "")
        .map_err(|found| found.into_iter().map(kept::with_a_way_out).collect::<Vec<_>>())?;
    file.project().map_err(|problems| {
        problems.into_iter().map(|problem| Found::located(root, problem)).collect()
    })
}

impl ProjectFile {
    /// The project.
    ///
    /// # Errors
    /// Kept checks that make no sense, by their path.
    pub(super) fn project(self) -> Result<Project, Vec<Problem>> {
        let mut problems = Vec::new();
        match self.made(&mut problems) {
            Ok(project) if problems.is_empty() => Ok(project),
            // The reader has noted why and gives no file then.
            Err(Refused) if problems.is_empty() => {
                Err(vec![Problem::new("", "the file cannot be read")])
            }
            _ => Err(problems),
        }
    }

    fn made(self, problems: &mut Vec<Problem>) -> Result<Project, Refused> {
        self.version.needed()?;
        let meshes = self.meshes.get()?.unwrap_or_default();
        let files = self.method_files.get()?.unwrap_or_default().into_iter();
        let files: Vec<String> = files.map(Soft::needed).collect::<Result<_, _>>()?;
        let mut units = Units::default();
        if let Some(display) = self.display.get()? {
            units.length = display.length_unit.get()?.unwrap_or_default();
            units.force = display.force_unit.get()?.unwrap_or_default();
        }
        let mut project = Project {
            version: CURRENT_VERSION,
            name: self.name.needed()?,
            site: self.site.get()?.unwrap_or_default(),
            title: TitleBlock {
                client: self.client.get()?.unwrap_or_default(),
                author: self.author.get()?.unwrap_or_default(),
                checker: self.checker.get()?.unwrap_or_default(),
                revision: self.revision.get()?.unwrap_or_default(),
                date: self.date.get()?.unwrap_or_default(),
            },
            notes: self.notes.get()?.unwrap_or_default(),
            basis: self.basis.get()?.unwrap_or_default(),
            method_files: files.into_iter().map(|file| MethodFile { file, method: None }).collect(),
            meshes: meshes.into_iter().map(Soft::needed).collect::<Result<_, _>>()?,
            layouts: Vec::new(),
            display: Display { units },
        };
        let mesh = project.default_mesh().to_string();
        for (index, layout) in self.layouts.needed()?.into_iter().enumerate() {
            let path = format!("layouts[{index}]");
            project.layouts.push(layout.needed()?.layout(&mesh, &path, problems)?);
        }
        Ok(project)
    }
}

impl LayoutFile {
    fn layout(
        self,
        default_mesh: &str,
        path: &str,
        problems: &mut Vec<Problem>,
    ) -> Result<NamedLayout, Refused> {
        let mut check = None;
        match self.check.get()?.map(Kept::result) {
            Some(Ok(result)) => check = Some(Arc::new(result)),
            Some(Err(problem)) => problems.push(problem.under("check").under(path)),
            None => {}
        }
        let mesh = self.mesh.get()?.unwrap_or_else(|| default_mesh.to_string());
        let one = self.spacing.get()?.map(|v| v.0);
        let two = [self.spacing_x.get()?, self.spacing_y.get()?].map(|v| v.map(|v| v.0));
        let (spacing, up) = match (one, two) {
            (Some(side), [None, None]) => (side, None),
            (None, [Some(x), Some(y)]) => (x, Some(y)),
            (one, two) => {
                problems.push(words::spacings(one.is_some(), two.map(|v| v.is_some())).under(path));
                return Err(Refused);
            }
        };
        let grid = Grid {
            up,
            stagger: self.stagger.get()?.unwrap_or(false),
            twists: self.twists.get()?.unwrap_or_default(),
        };
        let blocks = self.blocks.get()?.unwrap_or_default();
        let shape = self.shape.get()?.unwrap_or_default();
        let method = self.method.get()?.unwrap_or_default();
        let geometry = Layout { blocks, method, grid, shape, ..REFERENCE };
        let mut layout = NamedLayout {
            branch: self.branch.get()?.unwrap_or_default(),
            overlay: self.overlay.get()?.unwrap_or(false),
            note: self.note.get()?.unwrap_or_default(),
            check,
            ..NamedLayout::new(self.name.needed()?, geometry, mesh)
        };
        for (input, value) in [
            (Input::Plate, Some(self.d.needed()?.0)),
            (Input::Spacing, Some(spacing)),
            (Input::Punch, Some(self.punch.needed()?.0)),
            (Input::OffsetX, self.ex.get()?.map(|v| v.0)),
            (Input::OffsetY, self.ey.get()?.map(|v| v.0)),
            (Input::DesignForce, self.design_force.get()?.map(|v| v.0)),
            (Input::Pressure, self.pressure.get()?.map(|v| v.0)),
            (Input::AllowableDeflection, self.allowable_deflection.get()?.map(|v| v.0)),
            (Input::AnchorResistance, self.anchor_resistance.get()?.map(|v| v.0)),
            (Input::GammaLoad, self.gamma_load.get()?.map(|v| v.0)),
            (Input::GammaResistance, self.gamma_resistance.get()?.map(|v| v.0)),
        ] {
            layout.set(input, value);
        }
        Ok(layout)
    }
}

/// What is said of a file of a newer version.
pub(super) const NEWER: &str =
    "the file was written by a newer meshcast and this one cannot read it";

/// The version field of a tree, before anything else is looked at.
///
/// # Errors
/// The one thing that is wrong with it.
pub(crate) fn version(text: &str, root: &Node) -> Result<u32, Found> {
    let allowed = format!("0 to {CURRENT_VERSION}");
    let is_struct = matches!(&root.kind, NodeKind::Group(g) if g.shape == Shape::Struct || g.entries.is_empty());
    if !is_struct {
        let problem = Problem::new("", "this is no project")
            .value(words::shorten(root.span.slice(text)))
            .advice(format!("a project starts with (version: {CURRENT_VERSION}, name: ..."));
        return Err(Found::new(root.span.start, problem));
    }
    let Some(entry) = root.field("version") else {
        let problem = Problem::new("version", "the format version is missing")
            .allowed(allowed)
            .advice(format!("put version: {CURRENT_VERSION}, first in the file"));
        return Err(Found::new(root.span.start, problem));
    };
    let node = entry.value.unwrapped();
    let wrong = |said: &str, advice: &str| {
        let problem = Problem::new("version", said)
            .value(words::shorten(node.span.slice(text)))
            .allowed(allowed)
            .advice(advice);
        Err(Found::new(entry.span().start, problem))
    };
    match node.kind {
        NodeKind::Number(v) if v.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&v) => {
            // Whole and within range, so nothing is lost.
            let version = v as u32;
            if version <= CURRENT_VERSION {
                return Ok(version);
            }
            wrong(NEWER, "use the newer meshcast; the file is left as it is")
        }
        _ => wrong("the format version is a whole number", ""),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::wire::{Distortion, NetGeometry, WireData};
    use crate::mesh::{LabRecord, RatioRecord};
    use crate::project::text::parser::parse;
    use crate::project::write::ron_options;
    use serde::de::DeserializeOwned;

    #[test]
    fn slips_and_other_names_lead_to_the_field() {
        for (written, meant) in [
            ("spacing", "L"),
            ("spaceing", "L"),
            ("l", "L"),
            ("E_x", "ex"),
            ("desing_force", "design_force"),
            ("gamma_laod", "gamma_load"),
            ("Overlay", "overlay"),
        ] {
            assert_eq!(words::closest(written, LAYOUT_FIELDS), Some(meant), "{written}");
        }
        assert_eq!(words::closest("layout", PROJECT_FIELDS), Some("layouts"));
        assert_eq!(words::closest("weather_forecast", LAYOUT_FIELDS), None);
    }

    /// What is wrong with a text, first the problem's field.
    fn wrong<T: DeserializeOwned>(text: &str) -> Vec<(String, Problem)> {
        let tree = parse(text).unwrap();
        let found = read::values::<T>(text, &tree.root, "").err().unwrap_or_default();
        found.into_iter().map(|f| (f.problem.field.clone(), *f.problem)).collect()
    }

    #[test]
    fn what_is_read_is_what_is_written() {
        let allowed = |found: &[(String, Problem)]| found.last().unwrap().1.allowed.clone();
        assert_eq!(allowed(&wrong::<ProjectFile>("(zz: 1)")), PROJECT_FIELDS.join(", "));
        assert_eq!(allowed(&wrong::<LayoutFile>("(zz: 1)")), LAYOUT_FIELDS.join(", "));
        assert_eq!(allowed(&wrong::<DisplayFile>("(zz: 1)")), DISPLAY_FIELDS.join(", "));
    }

    /// The fields said to be needed are so, and no others; what is shown as an example can be read.
    fn fields_needed<T: DeserializeOwned>(holder: &str, soft: bool) {
        let needed = words::needed(holder);
        assert!(!needed.is_empty(), "{holder}");
        let example = |n: &str| words::example(n).split(" (strain").next().unwrap().to_string();
        let without = |left_out: &str| {
            let fields = needed.iter().filter(|n| **n != left_out);
            let fields: Vec<String> = fields.map(|n| format!("{n}: {}", example(n))).collect();
            format!("({})", fields.join(", "))
        };
        assert_eq!(wrong::<T>(&without("")), [], "{holder}: {}", without(""));
        for name in needed {
            let found = wrong::<T>(&without(name));
            assert_eq!(found.len(), 1, "{holder}.{name}: {found:?}");
            assert_eq!(found[0].0, *name);
            // Soft fields are needed because the table says so, the others because serde does.
            let ron = ron_options().from_str::<T>(&without(name));
            assert_eq!(ron.is_ok(), soft, "{holder}.{name}");
        }
    }

    #[test]
    fn the_table_of_needed_fields_is_that_of_the_structs() {
        fields_needed::<ProjectFile>("Project", true);
        fields_needed::<LayoutFile>("Layout", true);
        fields_needed::<MeshType>("MeshType", false);
        fields_needed::<LabRecord>("LabRecord", false);
        fields_needed::<RatioRecord>("RatioRecord", false);
        fields_needed::<WireData>("WireData", false);
        fields_needed::<NetGeometry>("NetGeometry", false);
        fields_needed::<Distortion>("Distortion", false);
        assert_eq!(words::example("version"), CURRENT_VERSION.to_string());
        let inputs = Input::LAYOUT.into_iter().filter(|i| !i.clearable()).map(|i| i.row().name);
        let needed: Vec<&str> = ["name"].into_iter().chain(inputs).collect();
        assert_eq!(words::needed("Layout"), needed);
        assert!(Input::LAYOUT.into_iter().all(|i| LAYOUT_FIELDS.contains(&i.row().name)));
    }

    #[test]
    fn names_kept_for_later_versions_are_said_to_be_so() {
        for (holder, names) in words::RESERVED {
            for name in *names {
                let text = format!("({name}: 1)");
                let found = match *holder {
                    "Project" => wrong::<ProjectFile>(&text),
                    _ => wrong::<LayoutFile>(&text),
                };
                let said = &found.iter().find(|(field, _)| field == name).unwrap().1;
                assert!(said.message.contains("does not know yet"), "{said}");
                assert!(said.advice.contains("take the field out"), "{said}");
                assert!(!LAYOUT_FIELDS.contains(name) && !PROJECT_FIELDS.contains(name), "{name}");
            }
        }
    }

    #[test]
    fn all_that_is_wrong_is_said_at_once() {
        let text = "(version: 2, name: 7, meshes: [(id: \"m\", laboratory: (force: [1], sauce: 2))], \
                    layouts: [(name: \"a\", d: true, D: 1, note: 3, note: 4), (L: 3)])";
        let fields: Vec<String> = wrong::<ProjectFile>(text).into_iter().map(|f| f.0).collect();
        let due = [
            "name",
            "meshes[0].laboratory.statistic",
            "meshes[0].laboratory.source",
            "meshes[0].laboratory.force",
            "layouts[0].L",
            "layouts[0].d",
            "layouts[0].note",
            "layouts[0].note",
            "layouts[1].name",
            "layouts[1].d",
            "layouts[1].D",
        ];
        assert_eq!(fields, due);
    }
}

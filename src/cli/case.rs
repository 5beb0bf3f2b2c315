//! One layout to forecast: from a project file or the defaults, with the flags above both.

use super::UiFlags;
use super::output::Fault;
use super::quantity;
use crate::forecast::design::Question;
use crate::layout::{BranchRule, REFERENCE};
use crate::mesh::{MeshType, REFERENCE_ID, catalogue};
use crate::problem::Problem;
use crate::project::{self, NamedLayout, Project};
use crate::study;
use crate::study::case::Input;
use crate::units::LengthUnit;
use crate::words::nearest;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Where the layouts come from: a project file or the flags alone.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct Source {
    /// Project file; without it, one layout from the flags below.
    #[arg(value_name = "PROJECT.ron")]
    project: Option<PathBuf>,
    /// Only the layout of this name.
    #[arg(long, value_name = "NAME", requires = "project", allow_hyphen_values = true)]
    layout: Option<String>,
    #[command(flatten)]
    inputs: Inputs,
}

/// The cases of a command.
#[derive(Debug)]
pub(crate) struct Loaded {
    /// One, or those of a project in its order.
    pub(crate) cases: Vec<Case>,
    /// Unit of lengths in texts: of the flag, the project, or metres.
    pub(crate) unit: LengthUnit,
    /// Whether the result is a list, also of one or of none: all layouts of a project.
    pub(crate) several: bool,
}

impl Source {
    /// Reads the project, if there is one, and puts the flags above it.
    ///
    /// # Errors
    /// What is wrong with the file, the layout's name or the inputs.
    pub(crate) fn load(&self, ui: &UiFlags) -> Result<Loaded, Fault> {
        match &self.project {
            Some(path) => self.inputs.of_file(path, self.layout.as_deref(), ui),
            None => Ok(Loaded {
                cases: vec![self.inputs.alone()?],
                unit: ui.units.unwrap_or_default(),
                several: false,
            }),
        }
    }

    /// The same with other defaults: without a project, an input that no flag gives is the one here
    /// and not that of the paper's reference panel.
    pub(crate) fn with_defaults(&self, defaults: &[(Input, f64)]) -> Source {
        let mut source = self.clone();
        if self.project.is_none() {
            let inputs = &mut source.inputs.geometry;
            for (input, value) in defaults {
                let flag = match input {
                    Input::Plate => &mut inputs.plate,
                    Input::Spacing => &mut inputs.spacing,
                    Input::Punch => &mut inputs.punch,
                    Input::OffsetX => &mut inputs.ex,
                    Input::OffsetY => &mut inputs.ey,
                    Input::LabForce | Input::LabDeflection => continue,
                };
                flag.get_or_insert(*value);
            }
        }
        source
    }
}

/// Panel, plates, punch and mesh on the command line; each goes above the file.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Inputs (above the file's; default: the paper's reference panel)")]
pub(crate) struct Geometry {
    /// Side of the square anchor plate, d [default: 0.32 m].
    #[arg(short = 'd', value_name = "M", value_parser = quantity::size, allow_hyphen_values = true)]
    plate: Option<f64>,
    /// Anchor spacing, L; anchors stand on a square grid [default: 3 m].
    #[arg(short = 'L', value_name = "M", value_parser = quantity::spacing, allow_hyphen_values = true)]
    spacing: Option<f64>,
    /// Diameter of the punching block, D [default: 1 m].
    #[arg(short = 'D', value_name = "M", value_parser = quantity::size, allow_hyphen_values = true)]
    punch: Option<f64>,
    /// Offset of the block across the twists, -L/2 to L/2 [default: 0 m].
    #[arg(long, value_name = "M", value_parser = quantity::offset, allow_hyphen_values = true)]
    ex: Option<f64>,
    /// Offset of the block along the twists, down the slope, -L/2 to L/2 [default: 0 m].
    #[arg(long, value_name = "M", value_parser = quantity::offset, allow_hyphen_values = true)]
    ey: Option<f64>,
    /// Mesh, by its identifier; `meshcast mesh list` names those of the catalogue.
    #[arg(long, value_name = "ID")]
    mesh: Option<String>,
}

/// Inputs of a forecast on the command line; each goes above the file.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Inputs (above the file's; default: the paper's reference panel)")]
pub(crate) struct Inputs {
    #[command(flatten)]
    geometry: Geometry,
    /// Branch of Eqs. A.1-A.2: by the size of the block as published, or the lower force.
    #[arg(long, value_name = "RULE", value_parser = branch_rule())]
    branch: Option<BranchRule>,
    /// Design force: asks for utilisation and deflection.
    #[arg(long, value_name = "KN", value_parser = quantity::force, allow_hyphen_values = true)]
    force: Option<f64>,
    /// Allowable deflection: asks for the force mobilised.
    #[arg(long, value_name = "M", value_parser = quantity::deflection, allow_hyphen_values = true)]
    deflection: Option<f64>,
    /// Partial factor on the resistance [default: 1].
    #[arg(long, value_name = "X", value_parser = quantity::factor, allow_hyphen_values = true)]
    gamma_resistance: Option<f64>,
    /// Partial factor on the load [default: 1].
    #[arg(long, value_name = "X", value_parser = quantity::factor, allow_hyphen_values = true)]
    gamma_load: Option<f64>,
}

impl From<Geometry> for Inputs {
    fn from(geometry: Geometry) -> Self {
        Inputs { geometry, ..Inputs::default() }
    }
}

fn branch_rule() -> impl TypedValueParser<Value = BranchRule> {
    let words = [BranchRule::Published, BranchRule::Conservative].map(BranchRule::word);
    PossibleValuesParser::new(words).map(|word| {
        if word == BranchRule::Conservative.word() {
            BranchRule::Conservative
        } else {
            BranchRule::Published
        }
    })
}

/// One layout to forecast, sound as far as a layout can be by itself.
#[derive(Debug, Clone)]
pub(crate) struct Case {
    /// Name of the layout, where it is one of a project.
    pub name: Option<String>,
    /// Geometry, branch rule and design questions.
    pub entry: NamedLayout,
    /// Its mesh.
    pub mesh: Arc<MeshType>,
}

impl Case {
    /// Its design questions.
    pub(crate) fn question(&self) -> Question {
        Question {
            force: self.entry.design_force,
            deflection: self.entry.allowable_deflection,
            gamma_resistance: self.entry.gamma_resistance,
            gamma_load: self.entry.gamma_load,
        }
    }

    /// The same for a study.
    pub(crate) fn study(&self) -> study::case::Case {
        study::case::Case {
            layout: self.entry.layout(),
            mesh: self.mesh.clone(),
            rule: self.entry.branch,
            question: self.question(),
        }
    }
}

impl Inputs {
    /// The cases of a project file's layouts, or of the one that is named.
    ///
    /// # Errors
    /// What is wrong with the file, the layout's name or the inputs.
    pub(crate) fn of_file(
        &self,
        path: &Path,
        only: Option<&str>,
        ui: &UiFlags,
    ) -> Result<Loaded, Fault> {
        let opened = project::load(path)?;
        Ok(Loaded {
            cases: self.of_project(&opened.project, only)?,
            unit: ui.units.unwrap_or(opened.project.display.length_unit),
            several: only.is_none(),
        })
    }

    /// The case without a project: the defaults and these inputs.
    ///
    /// # Errors
    /// Every input that makes no sense, by its flag.
    pub(crate) fn alone(&self) -> Result<Case, Fault> {
        let entry = NamedLayout::new("command line", REFERENCE, REFERENCE_ID);
        self.over(entry, None, catalogue::find, &ids(catalogue::all()))
    }

    /// The cases of a project's layouts, or of the one that is named.
    ///
    /// # Errors
    /// An unknown name, or every input that makes no sense, by its flag or its place in the project.
    pub(crate) fn of_project(
        &self,
        project: &Project,
        only: Option<&str>,
    ) -> Result<Vec<Case>, Fault> {
        let meshes = project.available_meshes();
        let case = |layout: &NamedLayout| {
            let find = |id: &str| project.find_mesh(id);
            self.over(layout.clone(), Some(layout.name.clone()), find, &ids(&meshes))
        };
        match only {
            None => project.layouts.iter().map(case).collect(),
            Some(name) => match project.find_layout(name) {
                Some(layout) => Ok(vec![case(layout)?]),
                None => Err(Fault::input(unknown_layout(project, name))),
            },
        }
    }

    /// A layout with these inputs above its own.
    fn over(
        &self,
        mut entry: NamedLayout,
        name: Option<String>,
        find: impl Fn(&str) -> Option<Arc<MeshType>>,
        known: &[String],
    ) -> Result<Case, Fault> {
        let set = |to: &mut f64, from: Option<f64>| *to = from.unwrap_or(*to);
        set(&mut entry.plate, self.geometry.plate);
        set(&mut entry.spacing, self.geometry.spacing);
        set(&mut entry.punch, self.geometry.punch);
        set(&mut entry.ex, self.geometry.ex);
        set(&mut entry.ey, self.geometry.ey);
        set(&mut entry.gamma_resistance, self.gamma_resistance);
        set(&mut entry.gamma_load, self.gamma_load);
        entry.design_force = self.force.or(entry.design_force);
        entry.allowable_deflection = self.deflection.or(entry.allowable_deflection);
        entry.branch = self.branch.unwrap_or(entry.branch);
        if let Some(id) = &self.geometry.mesh {
            entry.mesh.clone_from(id);
        }
        let Some(mesh) = find(&entry.mesh) else {
            return Err(Fault::input(unknown_mesh("--mesh", &entry.mesh, known)));
        };
        match entry.check() {
            Ok(()) => Ok(Case { name, entry, mesh }),
            Err(found) => Err(Fault::Input(
                found.into_iter().map(|p| self.placed(p, name.as_deref()).to_string()).collect(),
            )),
        }
    }

    /// A problem of a layout's field at the flag, or at the layout of the file, that it comes from.
    fn placed(&self, mut problem: Problem, layout: Option<&str>) -> Problem {
        let (flag, given) = match problem.field.as_str() {
            "d" => ("-d", self.geometry.plate.is_some()),
            "L" => ("-L", self.geometry.spacing.is_some()),
            "D" => ("-D", self.geometry.punch.is_some()),
            "ex" => ("--ex", self.geometry.ex.is_some()),
            "ey" => ("--ey", self.geometry.ey.is_some()),
            "design_force" => ("--force", self.force.is_some()),
            "allowable_deflection" => ("--deflection", self.deflection.is_some()),
            "gamma_resistance" => ("--gamma-resistance", self.gamma_resistance.is_some()),
            "gamma_load" => ("--gamma-load", self.gamma_load.is_some()),
            _ => return problem,
        };
        match layout {
            _ if given => problem.field = flag.to_string(),
            Some(name) => problem = problem.under(&format!("layout {name:?}")),
            None => {
                problem.field = flag.to_string();
                problem.value.push_str(" (its default)");
                problem.advice = format!("give {flag} as well");
            }
        }
        problem
    }
}

fn ids(meshes: &[Arc<MeshType>]) -> Vec<String> {
    meshes.iter().map(|m| m.id.clone()).collect()
}

/// What to say to a mesh that nobody knows; `place` is the flag or argument.
pub(crate) fn unknown_mesh(place: &str, id: &str, known: &[String]) -> String {
    let words: Vec<&str> = known.iter().map(String::as_str).collect();
    unknown(place, "there is no mesh of this identifier", id, &words)
}

/// What to say to a layout that the project does not have.
pub(crate) fn unknown_layout(project: &Project, name: &str) -> String {
    let words: Vec<&str> = project.layouts.iter().map(|l| l.name.as_str()).collect();
    unknown("--layout", "the project has no layout of this name", name, &words)
}

fn unknown(place: &str, said: &str, typed: &str, known: &[&str]) -> String {
    /// Names that are listed; more would hide the message.
    const LISTED: usize = 12;
    let mut listed: Vec<String> = known.iter().take(LISTED).map(|k| format!("{k:?}")).collect();
    if known.len() > LISTED {
        listed.push(format!("and {} more", known.len() - LISTED));
    }
    let allowed =
        if listed.is_empty() { "none, the list is empty".into() } else { listed.join(", ") };
    let advice = nearest(typed, known).map_or(String::new(), |n| format!("did you mean {n:?}?"));
    Problem::new(place, said)
        .value(format!("{typed:?}"))
        .allowed(allowed)
        .advice(advice)
        .to_string()
}

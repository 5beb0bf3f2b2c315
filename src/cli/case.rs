//! One layout to forecast: from a project file or the defaults, with the flags above both.

use super::UiFlags;
use super::choice::one_of;
use super::input_flags::InputFlags;
use super::opening::load_project;
use super::output::Fault;
use super::quantity;
use crate::case::input::LX;
use crate::case::{Case, Input};
use crate::layout::{Blocks, BranchRule, MethodChoice, PunchShape, REFERENCE, Twists};
use crate::mesh::adopted::KeptMethod;
use crate::mesh::{MeshType, REFERENCE_ID, catalogue, strength};
use crate::problem::Problem;
use crate::project::{NamedLayout, Project, method_files};
use crate::study::result::CheckResult;
use crate::study::verdict::Basis;
use crate::units::Units;
use crate::words::{Choice, nearest};
use clap::Args;
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

/// A case of a command.
#[derive(Debug, Clone)]
pub(crate) struct NamedCase {
    /// Name of the layout, where it is one of a project.
    pub(crate) name: Option<String>,
    pub(crate) case: Case,
    /// The check that the project keeps of the layout, whether or not its inputs are still these.
    pub(crate) check: Option<Arc<CheckResult>>,
}

/// The cases of a command.
#[derive(Debug)]
pub(crate) struct Loaded {
    /// One, or those of a project in its order.
    pub(crate) cases: Vec<NamedCase>,
    /// Units in texts: of the flag, the project, or m and kN.
    pub(crate) unit: Units,
    /// Which capacity verdicts go by: the project's, or the mean.
    pub(crate) basis: Basis,
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
                unit: ui.units_over(Units::default()),
                basis: Basis::default(),
                several: false,
            }),
        }
    }

    /// The same with other defaults: without a project, an input that no flag gives is the one here
    /// and not that of the paper's reference panel.
    pub(crate) fn with_defaults(&self, defaults: &[(Input, f64)]) -> Source {
        let mut source = self.clone();
        if self.project.is_none() {
            source.inputs.geometry.values.default_to(defaults);
        }
        source
    }
}

/// Panel, plates, punch and mesh on the command line; each goes above the file.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Inputs (above the file's; default: the paper's reference panel)")]
pub(crate) struct Geometry {
    #[command(flatten)]
    values: InputFlags<false>,
    /// Anchor spacing across the slope, Lx, of a grid with two; not beside -L.
    #[arg(long = "Lx", value_name = "M", allow_hyphen_values = true, value_parser = spacing_across)]
    spacing_across: Option<f64>,
    /// Every other row of anchors is shifted by half the spacing in it (false: none is).
    #[arg(long, value_name = "BOOL", num_args = 0..=1, default_missing_value = "true", require_equals = true)]
    stagger: Option<bool>,
    /// How the net hangs: its twists down the slope or across it.
    #[arg(long, value_name = "WAY", value_parser = one_of(Twists::ALL))]
    twists: Option<Twists>,
    /// Shape of the block in the check; forecasts know the dome alone.
    #[arg(long, value_name = "SHAPE", value_parser = one_of(PunchShape::ALL))]
    shape: Option<PunchShape>,
    /// How the blocks of other cells stand: as the paper had it, or (worst) the lower of repeated and mirrored; single: there are none.
    #[arg(long, value_name = "BLOCKS", value_parser = one_of(Blocks::ALL))]
    blocks: Option<Blocks>,
    /// Relations of the forecast: the paper's, or those derived from simulations of the blocks as they stand.
    #[arg(long, value_name = "METHOD", value_parser = one_of(MethodChoice::ALL))]
    method: Option<MethodChoice>,
    /// A method that `derive` or a campaign wrote, for --method derived; again for other blocks.
    #[arg(long, value_name = "FILE")]
    method_file: Vec<PathBuf>,
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
    #[arg(long, value_name = "RULE", value_parser = one_of(BranchRule::ALL))]
    branch: Option<BranchRule>,
    #[command(flatten)]
    question: InputFlags<true>,
}

/// A value of `--Lx`.
fn spacing_across(text: &str) -> Result<f64, String> {
    quantity::of_input(Input::Spacing, text)
}

impl Geometry {
    /// Makes room for the spacings that are given: one takes the second away, and two are never one.
    fn one_or_two(&self, entry: &mut NamedLayout) -> Result<(), Vec<Problem>> {
        let has = |input| self.values.given().any(|(given, _)| given == input);
        let (one, up) = (has(Input::Spacing), has(Input::SpacingUp));
        let across = self.spacing_across;
        if one && (up || across.is_some()) {
            let other = if up { Input::SpacingUp.row().flag } else { LX_FLAG };
            return Err(vec![
                Problem::new(other, "a grid has one spacing or two, never both")
                    .allowed("-L, or --Lx and --Ly"),
            ]);
        }
        if one {
            entry.set(Input::SpacingUp, None);
        }
        let Some(across) = across else { return Ok(()) };
        if !up && entry.layout.grid.up.is_none() {
            return Err(vec![
                Problem::new(LX_FLAG, "the spacing up the slope is missing")
                    .advice("give --Ly as well, or -L for both"),
            ]);
        }
        entry.set(Input::Spacing, Some(across));
        Ok(())
    }
}

impl Geometry {
    /// A mesh with the methods of the files that are given, before those that it has.
    fn with_methods(&self, mesh: Arc<MeshType>) -> Result<Arc<MeshType>, Fault> {
        if self.method_file.is_empty() {
            return Ok(mesh);
        }
        let mut mesh = (*mesh).clone();
        for file in self.method_file.iter().rev() {
            let method = method_files::read(file).and_then(|method| {
                method_files::fits(&method, Some(&mesh))?;
                Ok(method)
            });
            let method = method.map_err(|why| {
                let shown = format!("{:?}", file.display().to_string());
                Fault::input(Problem::new("--method-file", why).value(shown).to_string())
            })?;
            mesh.methods.0.insert(0, KeptMethod::keep(method));
        }
        Ok(Arc::new(mesh))
    }
}

/// The flag of the spacing where there are two.
const LX_FLAG: &str = "--Lx";

impl Inputs {
    /// Those of a check, which has no branch of equations.
    pub(crate) fn of_check(geometry: Geometry, question: InputFlags<true>) -> Inputs {
        Inputs { geometry, branch: None, question }
    }

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
        let opened = load_project(path)?;
        Ok(Loaded {
            cases: self.of_project(&opened.project, only)?,
            unit: ui.units_over(opened.project.display.units),
            basis: opened.project.basis,
            several: only.is_none(),
        })
    }

    /// The case without a project: the defaults and these inputs.
    ///
    /// # Errors
    /// Every input that makes no sense, by its flag.
    pub(crate) fn alone(&self) -> Result<NamedCase, Fault> {
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
    ) -> Result<Vec<NamedCase>, Fault> {
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
    ) -> Result<NamedCase, Fault> {
        let given = || self.geometry.values.given().chain(self.question.given());
        // A flag also takes away what it stands instead of; two flags are left to be refused.
        for other in given().filter_map(|(input, _)| input.instead_of()) {
            entry.set(other, None);
        }
        self.geometry.one_or_two(&mut entry).map_err(Fault::from)?;
        for (input, value) in given() {
            entry.set(input, Some(value));
        }
        let grid = &mut entry.layout.grid;
        grid.stagger = self.geometry.stagger.unwrap_or(grid.stagger);
        grid.twists = self.geometry.twists.unwrap_or(grid.twists);
        entry.layout.shape = self.geometry.shape.unwrap_or(entry.layout.shape);
        entry.layout.blocks = self.geometry.blocks.unwrap_or(entry.layout.blocks);
        entry.layout.method = self.geometry.method.unwrap_or(entry.layout.method);
        entry.branch = self.branch.unwrap_or(entry.branch);
        if let Some(id) = &self.geometry.mesh {
            entry.mesh.clone_from(id);
        }
        let Some(mesh) = find(&entry.mesh) else {
            return Err(Fault::input(unknown_mesh("--mesh", &entry.mesh, known)));
        };
        let mesh = self.geometry.with_methods(mesh)?;
        if !self.geometry.method_file.is_empty() && self.geometry.method.is_none() {
            entry.layout.method = MethodChoice::Derived;
        }
        match entry.check() {
            Ok(()) => Ok(NamedCase { case: entry.case(mesh), name, check: entry.check }),
            Err(found) => Err(self.placed(found, name.as_deref())),
        }
    }

    /// Problems of inputs at the flags, or at the layout of the file, that they come from.
    pub(crate) fn placed(&self, found: Vec<Problem>, layout: Option<&str>) -> Fault {
        Fault::from(found.into_iter().map(|p| self.at_flag(p, layout)).collect::<Vec<_>>())
    }

    fn at_flag(&self, mut problem: Problem, layout: Option<&str>) -> Problem {
        let under = |problem: Problem| match layout {
            Some(name) => problem.under(&format!("layout {name:?}")),
            None => problem,
        };
        let Some(input) = Input::named(&problem.field) else {
            // What has been put at a flag of its own stays there.
            return if problem.field.starts_with('-') { problem } else { under(problem) };
        };
        let mut given = self.geometry.values.given().chain(self.question.given());
        let across = problem.field == LX;
        let flag = if across { LX_FLAG } else { input.row().flag };
        let own = across && self.geometry.spacing_across.is_some();
        if own || given.any(|(given, _)| given == input) {
            problem.field = flag.to_string();
            return problem;
        }
        if layout.is_some() {
            return under(problem);
        }
        problem.field = flag.to_string();
        problem.value.push_str(" (its default)");
        if problem.advice.is_empty() {
            problem.advice = format!("give {flag} as well");
        }
        problem
    }
}

fn ids(meshes: &[Arc<MeshType>]) -> Vec<String> {
    meshes.iter().map(|m| m.id.clone()).collect()
}

/// What to say to a mesh that nobody knows; `place` is the flag or argument.
pub(crate) fn unknown_mesh(place: &str, id: &str, known: &[String]) -> String {
    if let Some(record) = strength::find(id) {
        let problem = record.problem();
        return format!("{place}: {id}: {}; {}", problem.message, problem.advice);
    }
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

//! Edits of a layout and of the list of layouts; each is one step of undo.

use super::history::Run;
use super::{Editor, NONE};
use crate::case::entry::on_grain;
use crate::case::{Input, StepSize};
use crate::layout::{self, Blocks, BranchRule, Grid, Layout, MethodChoice, PunchShape, Twists};
use crate::mesh::{MeshType, REFERENCE_ID};
use crate::problem;
use crate::project::method_files::fits;
use crate::project::schema::{
    LONGEST_NAME, MOST_LAYOUTS, MOST_MESHES, MOST_OVERLAYS, MeshUse, MethodFile, NamedLayout,
};
use crate::study::verdict::Basis;
use crate::units::ChosenUnits;
use crate::words::Choice;
use std::sync::Arc;

/// A choice of mesh: the type, and whether the project already names it.
#[derive(Debug, Clone)]
pub(crate) struct MeshChoice {
    pub(crate) mesh: Arc<MeshType>,
    /// Whether it is written out in the project file.
    pub(crate) inline: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::app) enum GridKind {
    /// One spacing.
    Square,
    /// Two.
    Rectangular,
    /// Two, and every other row shifted.
    Staggered,
}

impl Choice for GridKind {
    const ALL: &'static [GridKind] =
        &[GridKind::Square, GridKind::Rectangular, GridKind::Staggered];

    fn word(self) -> &'static str {
        match self {
            GridKind::Square => "square",
            GridKind::Rectangular => "rectangular",
            GridKind::Staggered => "staggered",
        }
    }
}

impl Editor {
    /// Steps the selected input up or down.
    ///
    /// # Errors
    /// What the input may be, where the step leads out of that.
    pub(in crate::app) fn step_field(&mut self, size: StepSize, up: bool) -> Result<(), String> {
        let field = self.field();
        let value = match self.layout().get(field) {
            Some(value) => field.stepped(value, &self.layout().layout, size, up),
            None => self.first_value(field),
        };
        field.check(value, &self.layout().layout, self.units())?;
        self.put_field(Run::Steps(self.layout().uid, field, up), Some(value));
        Ok(())
    }

    /// Sets the selected input to a checked value, or clears it.
    pub(in crate::app) fn set_field(&mut self, value: Option<f64>) {
        self.put_field(Run::Alone, value);
    }

    fn put_field(&mut self, run: Run, value: Option<f64>) {
        let field = self.field();
        let label = format!("{} of {}", field.word_in(&self.layout().layout), self.layout().name);
        let at = self.selected;
        self.edit_in(run, label, |project| {
            let Some(layout) = project.layouts.get_mut(at) else { return };
            layout.set(field, value);
            if let (Some(other), Some(_)) = (field.instead_of(), value) {
                layout.set(other, None);
            }
        });
    }

    /// The text of an input's value; empty where it is not set.
    pub(in crate::app) fn field_text(&self, field: Input) -> String {
        let value = self.layout().get(field);
        value.map_or(String::new(), |value| field.entry_text(value, self.units()))
    }

    /// Selects an input and sets it to what was typed.
    ///
    /// # Errors
    /// Why the text is refused.
    pub(in crate::app) fn read_field(&mut self, field: Input, text: &str) -> Result<(), String> {
        let value = field.read(text, &self.layout().layout, self.units())?;
        self.select_field(field);
        self.set_field(value);
        Ok(())
    }

    /// Where an optional input starts: three quarters of what the panel takes, rounded to a step.
    fn first_value(&self, field: Input) -> f64 {
        let panel = self.result().forecast().and_then(|f| f.field.ok());
        let whole = panel.and_then(|panel| match field {
            Input::DesignForce => Some(panel.values.force),
            _ => panel.values.deflection,
        });
        let Some(whole) = whole else { return field.step(StepSize::Coarse) };
        let step = field.step(StepSize::Fine);
        let steps = (0.75 * whole / step).round().max(1.0);
        on_grain(steps * step)
    }

    /// Adds a layout at the reference point after the selected one, with the same mesh; what to say.
    ///
    /// # Errors
    /// There are too many.
    pub(in crate::app) fn add_layout(&mut self) -> Result<String, String> {
        let name = self.project.free_name("layout");
        let mesh = self.layout().mesh.clone();
        self.insert(NamedLayout::new(name, layout::NEW, mesh), "added")
    }

    /// Copies the selected layout after itself; what to say.
    ///
    /// # Errors
    /// There are too many.
    pub(in crate::app) fn duplicate_layout(&mut self) -> Result<String, String> {
        let name = self.project.free_name(&self.layout().name);
        let copy = self.layout().duplicate(name);
        self.insert(copy, "copied to")
    }

    fn insert(&mut self, layout: NamedLayout, verb: &str) -> Result<String, String> {
        if self.project.layouts.len() >= MOST_LAYOUTS {
            return Err(format!("a project holds at most {MOST_LAYOUTS} layouts"));
        }
        let at = (self.selected + 1).min(self.project.layouts.len());
        let name = layout.name.clone();
        self.edit(format!("{name} {verb}"), |project| project.layouts.insert(at, layout));
        self.selected = at;
        Ok(format!("{verb} {name}; r renames it"))
    }

    /// Deletes the selected layout; what to say.
    ///
    /// # Errors
    /// There is none.
    pub(in crate::app) fn delete_layout(&mut self) -> Result<String, String> {
        if self.project.layouts.is_empty() {
            return Err(NONE.into());
        }
        let (name, at) = (self.layout().name.clone(), self.selected);
        self.edit(format!("{name} deleted"), |project| {
            project.layouts.remove(at);
        });
        Ok(format!("deleted {name}; u brings it back"))
    }

    /// Moves the selected layout one place up or down the list.
    pub(in crate::app) fn move_layout(&mut self, down: bool) {
        let at = self.selected;
        let to = if down { at + 1 } else { at.wrapping_sub(1) };
        if to >= self.project.layouts.len() {
            return;
        }
        let name = self.layout().name.clone();
        self.edit(format!("{name} moved"), |project| project.layouts.swap(at, to));
        self.selected = to;
    }

    /// Renames the selected layout.
    ///
    /// # Errors
    /// Why the name cannot be used.
    pub(in crate::app) fn rename_layout(&mut self, name: &str) -> Result<(), String> {
        let name = name.trim();
        let at = self.selected;
        if name.is_empty() {
            return Err("a layout needs a name".into());
        }
        if name.chars().count() > LONGEST_NAME {
            return Err(format!("a name has at most {LONGEST_NAME} characters"));
        }
        let taken = |(i, l): (usize, &NamedLayout)| i != at && l.name.trim() == name;
        if self.project.layouts.iter().enumerate().any(taken) {
            return Err(format!("another layout is already called {name:?}"));
        }
        let label = format!("name of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.name = name.to_string());
        Ok(())
    }

    /// Sets the note of the selected layout.
    pub(in crate::app) fn set_note(&mut self, note: &str) {
        let label = format!("note of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.note = note.trim().to_string());
    }

    /// Marks the selected layout for overlay, or unmarks it; what to say.
    ///
    /// # Errors
    /// There are too many.
    pub(in crate::app) fn toggle_overlay(&mut self) -> Result<String, String> {
        let marked = self.project.layouts.iter().filter(|l| l.overlay).count();
        if !self.layout().overlay && marked >= MOST_OVERLAYS {
            return Err(format!(
                "at most {MOST_OVERLAYS} curves are overlaid; press o on one of them first"
            ));
        }
        let label = format!("overlay of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.overlay = !layout.overlay);
        let name = self.layout().name.clone();
        Ok(match self.layout().overlay {
            true => format!("{name} stays on the chart; select another layout to compare"),
            false => format!("{name} is no longer overlaid"),
        })
    }

    /// Switches the branch rule of the selected layout; what to say.
    pub(in crate::app) fn toggle_branch(&mut self) -> &'static str {
        let rule = match self.layout().branch {
            BranchRule::Published => BranchRule::Conservative,
            BranchRule::Conservative => BranchRule::Published,
        };
        let label = format!("branch of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.branch = rule);
        match rule {
            BranchRule::Published => "branch of A.1-A.2 as published: by D <= d",
            BranchRule::Conservative => "conservative: the branch of A.1-A.2 with the lower force",
        }
    }

    /// Goes on to the next way in which the blocks of other cells stand; what to say.
    pub(in crate::app) fn turn_blocks(&mut self) -> String {
        let now = self.layout().layout.blocks;
        let at = Blocks::ALL.iter().position(|b| *b == now).unwrap_or(0);
        let blocks = Blocks::ALL[(at + 1) % Blocks::ALL.len()];
        let label = format!("blocks of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.layout.blocks = blocks);
        let said = match blocks {
            Blocks::Paper => "blocks as the paper has them: its map, checked as repeated ones",
            Blocks::Repeated => "repeated: the same block in every cell",
            Blocks::Mirrored => "mirrored: blocks face their neighbours across the anchor lines",
            Blocks::Single => "single: one block on a large mesh, in as many cells as it needs",
            Blocks::Worst => "worst: the check takes the lower of repeated and mirrored",
        };
        let layout = &self.layout().layout;
        if blocks == Blocks::Mirrored && layout.grid.stagger {
            format!("{said}; not on a staggered grid: no check")
        } else if blocks == Blocks::Mirrored && layout.blocks_overlap().is_some() {
            format!("{said}; here they overlap: no check")
        } else {
            said.into()
        }
    }

    /// Goes on to the next kind of grid: square, two spacings, staggered; what to say.
    pub(in crate::app) fn turn_grid(&mut self) -> &'static str {
        let kind = match self.layout().layout.grid {
            Grid { stagger: true, .. } => GridKind::Square,
            Grid { up: Some(_), .. } => GridKind::Staggered,
            Grid { up: None, .. } => GridKind::Rectangular,
        };
        self.set_grid(kind)
    }

    /// Sets the kind of grid; what to say. What has no second spacing yet begins with the first.
    pub(in crate::app) fn set_grid(&mut self, kind: GridKind) -> &'static str {
        let label = format!("grid of {}", self.layout().name);
        self.edit_layout(label, |layout| {
            let spacing = layout.layout.spacing;
            let grid = &mut layout.layout.grid;
            grid.stagger = kind == GridKind::Staggered;
            grid.up = (kind != GridKind::Square).then(|| grid.up.unwrap_or(spacing));
        });
        match kind {
            GridKind::Square => "square grid: one spacing L",
            GridKind::Rectangular => "two spacings: Lx across, Ly up the slope; Del takes Ly away",
            GridKind::Staggered => "staggered: every other row of anchors is Lx/2 further",
        }
    }

    /// Sets the shape of the block; what to say.
    pub(in crate::app) fn set_shape(&mut self, shape: PunchShape) -> String {
        let label = format!("shape of the block of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.layout.shape = shape);
        format!(
            "the check's block is {}; forecasts know the dome alone",
            match shape {
                PunchShape::Dome => "the laboratory's dome",
                PunchShape::Sphere => "a sphere",
                PunchShape::Flat => "flat",
            }
        )
    }

    /// Turns the net under the layout; what to say.
    pub(in crate::app) fn set_twists(&mut self, twists: Twists) -> &'static str {
        let label = format!("twists of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.layout.grid.twists = twists);
        match twists {
            Twists::Down => "the twists run down the slope, along y",
            Twists::Across => "the twists run across the slope, along x",
        }
    }

    /// Goes over to the other relations of the forecast; what to say.
    pub(in crate::app) fn toggle_method(&mut self) -> &'static str {
        let method = self.layout().layout.method.other();
        let label = format!("method of {}", self.layout().name);
        self.edit_layout(label, |layout| layout.layout.method = method);
        match method {
            MethodChoice::Published => "the published method (Pol & Gabrieli 2021)",
            MethodChoice::Derived => {
                "derived from simulations of blocks as they stand; dots: 90 % of curves"
            }
        }
    }

    /// Sets one unit or both, kept in the project.
    pub(in crate::app) fn set_units(&mut self, chosen: ChosenUnits) {
        let units = chosen.over(self.units());
        self.units = ChosenUnits::default();
        self.edit("units", |project| project.display.units = units);
    }

    /// The meshes to choose from: the project's own first, then the catalogue.
    pub(in crate::app) fn meshes(&self) -> Vec<MeshChoice> {
        let written_out = |id: &str| {
            self.project.meshes.iter().any(|m| matches!(m, MeshUse::Inline(mesh) if mesh.id == id))
        };
        let mut meshes = self.project.available_meshes();
        for mesh in &self.own {
            if !meshes.iter().any(|there| there.id == mesh.id) {
                meshes.push(mesh.clone());
            }
        }
        meshes.into_iter().map(|mesh| MeshChoice { inline: written_out(&mesh.id), mesh }).collect()
    }

    /// Gives the selected layout a mesh, by its identifier; the project then names it too.
    ///
    /// # Errors
    /// That there is no such mesh, with the known ones, or no layout.
    pub(in crate::app) fn set_mesh(&mut self, id: &str) -> Result<(), String> {
        if self.empty() {
            return Err(NONE.into());
        }
        let choices = self.meshes();
        if !choices.iter().any(|c| c.mesh.id == id) {
            let known: Vec<&str> = choices.iter().map(|c| c.mesh.id.as_str()).collect();
            return Err(format!("no mesh {id:?}; there are: {}", known.join(", ")));
        }
        // Whoever gets the project has no catalogue of this user's.
        let own = self.own.iter().find(|mesh| mesh.id == id);
        let own = own.filter(|_| self.project.find_mesh(id).is_none());
        self.give_mesh(match own {
            Some(mesh) => MeshUse::Inline(mesh.clone()),
            None => MeshUse::Catalogue(id.to_string()),
        });
        Ok(())
    }

    /// Gives the selected layout a mesh, which the project then names if it does not yet.
    fn give_mesh(&mut self, mesh: MeshUse) {
        let at = self.selected;
        let label = format!("mesh of {}", self.layout().name);
        self.edit(label, |project| {
            if let Some(layout) = project.layouts.get_mut(at) {
                layout.mesh = mesh.id().to_string();
            }
            if !project.meshes.iter().any(|m| m.id() == mesh.id()) {
                // An empty list stands for the reference mesh, which must stay the first.
                if project.meshes.is_empty() && mesh.id() != REFERENCE_ID {
                    project.meshes.push(MeshUse::Catalogue(REFERENCE_ID.into()));
                }
                project.meshes.push(mesh);
            }
        });
    }

    /// Writes a checked mesh out in the project and gives it to the selected layout; what to say.
    ///
    /// # Errors
    /// There is no layout, there is a mesh of this identifier, or there are too many.
    pub(in crate::app) fn add_mesh(&mut self, mesh: MeshType) -> Result<String, String> {
        if self.empty() {
            return Err(NONE.into());
        }
        self.new_mesh(&mesh.id)?;
        let said = format!("mesh {} added and given to {}; Ctrl+S", mesh.id, self.layout().name);
        self.give_mesh(MeshUse::Inline(Arc::new(mesh)));
        Ok(said + " saves it in the project")
    }

    /// Whether a mesh of this identifier can come into the project.
    ///
    /// # Errors
    /// There is one already, or there are too many.
    pub(in crate::app) fn new_mesh(&self, id: &str) -> Result<(), String> {
        if self.meshes().iter().any(|c| c.mesh.id == id) {
            return Err(format!("there is a mesh {id:?} already; take another identifier"));
        }
        if self.project.meshes.len() >= MOST_MESHES {
            return Err(format!("there are {MOST_MESHES} meshes, which is the most"));
        }
        Ok(())
    }

    /// Writes an adopted mesh out in the project, and gives it with its own method to a layout if that is still
    /// there; what to say.
    ///
    /// # Errors
    /// There is a mesh of this identifier by now, or there are too many.
    pub(in crate::app) fn adopt_mesh(
        &mut self,
        uid: u64,
        mesh: &Arc<MeshType>,
    ) -> Result<String, String> {
        self.new_mesh(&mesh.id)?;
        let mut given = String::new();
        self.edit(format!("mesh {} adopted", mesh.id), |project| {
            // An empty list stands for the reference mesh, which must stay the first.
            if project.meshes.is_empty() {
                project.meshes.push(MeshUse::Catalogue(REFERENCE_ID.into()));
            }
            project.meshes.push(MeshUse::Inline(mesh.clone()));
            if let Some(layout) = project.layouts.iter_mut().find(|layout| layout.uid == uid) {
                layout.mesh.clone_from(&mesh.id);
                layout.layout.method = MethodChoice::Derived;
                given = format!(" and given to {}", layout.name);
            }
        });
        Ok(format!("mesh {} adopted{given}; u takes it back", mesh.id))
    }

    /// Gives the selected layout other sizes, as an edit; what to say.
    ///
    /// # Errors
    /// The sizes do not go together.
    pub(in crate::app) fn take_sizes(
        &mut self,
        sizes: Layout,
        words: &str,
    ) -> Result<String, String> {
        sizes.check().map_err(|problems| problem::summary(&problems))?;
        let name = self.layout().name.clone();
        let label = format!("{words} of {name}");
        Ok(match self.edit_layout(label, |layout| layout.layout = sizes) {
            true => format!("{words} of {name} set; u undoes it"),
            false => format!("{name} is like that already"),
        })
    }

    /// Says which value of a capacity verdicts go by; what to say.
    pub(in crate::app) fn set_basis(&mut self, basis: Basis) -> String {
        self.edit("basis of verdicts", |project| project.basis = basis);
        format!("verdicts go by {} values", basis.word())
    }

    /// Names a method's file that was read. One of the same mesh and arrangement makes room for it; what to say.
    ///
    /// # Errors
    /// Why it cannot be named.
    pub(in crate::app) fn name_method(&mut self, named: MethodFile) -> Result<String, String> {
        let method = named.method.ok_or("it was not read")?.0;
        let file = named.file.clone();
        fits(method, self.project.find_mesh(&method.mesh).as_deref())
            .map_err(|why| format!("{file}: {why}"))?;
        let there = self.project.method_files.iter().find(|other| other.file == file);
        if let Some(there) = there {
            let as_before = there.method == named.method;
            let anew = if as_before { "" } else { "; it has changed since, :reload reads it" };
            return Ok(format!("{file} is named already{anew}"));
        }
        let takes_place = |other: &MethodFile| {
            let other = other.method.map(|kept| (&kept.0.mesh, kept.0.blocks));
            other == Some((&method.mesh, method.blocks))
        };
        let before = self.project.method_files.iter().find(|other| takes_place(other));
        let before = before.map_or(String::new(), |before| format!(" in place of {}", before.file));
        self.edit("method's file", |project| {
            project.method_files.retain(|other| !takes_place(other));
            project.method_files.push(named);
        });
        let blocks = method.blocks.word();
        Ok(format!("derived forecasts of {blocks} blocks go by {file}{before}"))
    }

    /// Names no method's file any more; what to say.
    pub(in crate::app) fn drop_methods(&mut self) -> String {
        match self.edit("methods' files", |project| project.method_files.clear()) {
            true => "derived forecasts go by the methods of the meshes again".into(),
            false => "no method's file is named".into(),
        }
    }

    /// Names the project, its site or what else stands in the head of its report.
    ///
    /// # Errors
    /// Why the text cannot be used.
    pub(in crate::app) fn name_project(&mut self, word: &str, text: &str) -> Result<(), String> {
        if text.is_empty() && word == "name" {
            return Err("a project needs a name".into());
        }
        if text.chars().count() > LONGEST_NAME {
            return Err(format!("at most {LONGEST_NAME} characters"));
        }
        self.edit(format!("{word} of the project"), |project| match word {
            "name" => project.name = text.to_string(),
            "site" => project.site = text.to_string(),
            _ => {
                if let Some(field) = project.title.field_mut(word) {
                    *field = text.to_string();
                }
            }
        });
        Ok(())
    }
}

//! Edits of a layout and of the list of layouts; each is one step of undo.

use super::App;
use crate::case::entry::on_grain;
use crate::case::{Input, StepSize};
use crate::layout::{self, BranchRule};
use crate::mesh::{MeshType, REFERENCE_ID};
use crate::project::schema::{LONGEST_NAME, MOST_LAYOUTS, MOST_OVERLAYS, MeshUse, NamedLayout};
use std::sync::Arc;

/// A choice of mesh: the type, and whether the project already names it.
#[derive(Debug, Clone)]
pub(crate) struct MeshChoice {
    /// The mesh.
    pub(crate) mesh: Arc<MeshType>,
    /// Whether it is written out in the project file.
    pub(crate) inline: bool,
}

impl App {
    /// Steps the selected input up or down.
    pub(super) fn step_field(&mut self, size: StepSize, up: bool) {
        let field = self.field;
        let value = match self.layout().get(field) {
            Some(value) => field.stepped(value, &self.layout().layout, size, up),
            None => self.first_value(field),
        };
        if let Err(refusal) = field.check(value, &self.layout().layout, self.units()) {
            return self.complain(refusal);
        }
        self.set_field(Some(value));
    }

    /// Sets the selected input to a checked value, or clears it.
    pub(super) fn set_field(&mut self, value: Option<f64>) {
        let (field, selected) = (self.field, self.selected);
        let label = format!("{} of {}", field.word(), self.layout().name);
        self.edit(label, |project| project.layouts[selected].set(field, value));
    }

    /// Where an optional input starts: three quarters of what the panel takes, rounded to a step.
    fn first_value(&self, field: Input) -> f64 {
        let Some(panel) = self.result().forecast().and_then(|f| f.field) else {
            return field.step(StepSize::Coarse);
        };
        let whole = match field {
            Input::DesignForce => panel.values.force,
            _ => panel.values.deflection,
        };
        let step = field.step(StepSize::Fine);
        let steps = (0.75 * whole / step).round().max(1.0);
        on_grain(steps * step)
    }

    /// Adds a layout at the reference point after the selected one, with the same mesh.
    pub(super) fn add_layout(&mut self) {
        let name = self.project.free_name("layout");
        let mesh = self.layout().mesh.clone();
        self.insert(NamedLayout::new(name, layout::REFERENCE, mesh), "added");
    }

    /// Copies the selected layout after itself.
    pub(super) fn duplicate_layout(&mut self) {
        let name = self.project.free_name(&self.layout().name);
        let copy = self.layout().duplicate(name);
        self.insert(copy, "copied to");
    }

    fn insert(&mut self, layout: NamedLayout, verb: &str) {
        if self.project.layouts.len() >= MOST_LAYOUTS {
            return self.complain(format!("a project holds at most {MOST_LAYOUTS} layouts"));
        }
        let (name, at) = (layout.name.clone(), self.selected + 1);
        self.edit(format!("{name} {verb}"), |project| project.layouts.insert(at, layout));
        self.selected = at;
        self.inform(format!("{verb} {name}; r renames it"));
    }

    /// Deletes the selected layout, unless it is the last one.
    pub(super) fn delete_layout(&mut self) {
        if self.project.layouts.len() == 1 {
            return self.complain("a project keeps at least one layout");
        }
        let (name, at) = (self.layout().name.clone(), self.selected);
        self.edit(format!("{name} deleted"), |project| {
            project.layouts.remove(at);
        });
        self.inform(format!("deleted {name}; u brings it back"));
    }

    /// Moves the selected layout one place up or down the list.
    pub(super) fn move_layout(&mut self, down: bool) {
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
    pub(super) fn rename_layout(&mut self, name: &str) -> Result<(), String> {
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
        self.edit(label, |project| project.layouts[at].name = name.to_string());
        Ok(())
    }

    /// Sets the note of the selected layout.
    pub(super) fn set_note(&mut self, note: &str) {
        let at = self.selected;
        let label = format!("note of {}", self.layout().name);
        self.edit(label, |project| project.layouts[at].note = note.trim().to_string());
    }

    /// Marks the selected layout for overlay, or unmarks it.
    pub(super) fn toggle_overlay(&mut self) {
        let at = self.selected;
        let marked = self.project.layouts.iter().filter(|l| l.overlay).count();
        if !self.layout().overlay && marked >= MOST_OVERLAYS {
            return self.complain(format!(
                "at most {MOST_OVERLAYS} curves are overlaid; press o on one of them first"
            ));
        }
        let label = format!("overlay of {}", self.layout().name);
        self.edit(label, |project| {
            let layout = &mut project.layouts[at];
            layout.overlay = !layout.overlay;
        });
        let name = self.layout().name.clone();
        if self.layout().overlay {
            self.inform(format!("{name} stays on the chart; select another layout to compare"));
        } else {
            self.inform(format!("{name} is no longer overlaid"));
        }
    }

    /// Switches the branch rule of the selected layout.
    pub(super) fn toggle_branch(&mut self) {
        let at = self.selected;
        let rule = match self.layout().branch {
            BranchRule::Published => BranchRule::Conservative,
            BranchRule::Conservative => BranchRule::Published,
        };
        let label = format!("branch of {}", self.layout().name);
        self.edit(label, |project| project.layouts[at].branch = rule);
        self.inform(match rule {
            BranchRule::Published => "branch of A.1-A.2 as published: by D <= d",
            BranchRule::Conservative => "conservative: the branch of A.1-A.2 with the lower force",
        });
    }

    /// Sets the unit of lengths, kept in the project.
    pub(super) fn set_units(&mut self, unit: crate::units::LengthUnit) {
        self.units = None;
        self.edit("units", |project| project.display.length_unit = unit);
    }

    /// The meshes to choose from: the project's own first, then the catalogue.
    pub(crate) fn meshes(&self) -> Vec<MeshChoice> {
        let written_out = |id: &str| {
            self.project.meshes.iter().any(|m| matches!(m, MeshUse::Inline(mesh) if mesh.id == id))
        };
        let meshes = self.project.available_meshes().into_iter();
        meshes.map(|mesh| MeshChoice { inline: written_out(&mesh.id), mesh }).collect()
    }

    /// Gives the selected layout a mesh, by its identifier; the project then names it too.
    ///
    /// # Errors
    /// That there is no such mesh, with the known ones.
    pub(super) fn set_mesh(&mut self, id: &str) -> Result<(), String> {
        let choices = self.meshes();
        if !choices.iter().any(|c| c.mesh.id == id) {
            let known: Vec<&str> = choices.iter().map(|c| c.mesh.id.as_str()).collect();
            return Err(format!("no mesh {id:?}; there are: {}", known.join(", ")));
        }
        let at = self.selected;
        let label = format!("mesh of {}", self.layout().name);
        self.edit(label, |project| {
            project.layouts[at].mesh = id.to_string();
            if !project.meshes.iter().any(|m| m.id() == id) {
                // An empty list stands for the reference mesh, which must stay the first.
                if project.meshes.is_empty() && id != REFERENCE_ID {
                    project.meshes.push(MeshUse::Catalogue(REFERENCE_ID.into()));
                }
                project.meshes.push(MeshUse::Catalogue(id.to_string()));
            }
        });
        Ok(())
    }
}

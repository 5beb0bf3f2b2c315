//! What Enter and Esc do in the form of a mesh.

use super::keymap::Action;
use super::mesh_form::FormKind;
use super::message::Command;
use super::{App, Mode};
use crate::problem::Problem;

impl App {
    /// Enter in the form: the next row, and from the last one the mesh is added and given to the layout, or its
    /// adoption begins.
    pub(super) fn take_mesh_form(&mut self) -> Vec<Command> {
        let unit = self.units();
        let Some(form) = self.screen.mesh_form() else { return Vec::new() };
        if !form.at_end() {
            form.step(1);
            return Vec::new();
        }
        if form.kind == FormKind::Tests {
            return self.take_adopt_form();
        }
        let first = |found: Vec<Problem>| {
            let p = found.into_iter().next();
            p.map_or((String::new(), String::new()), |p| (p.field.clone(), p.to_string()))
        };
        let checked = form.mesh(unit).map_err(|(field, why)| (field.to_string(), why));
        let checked = checked.and_then(|mesh| mesh.check().map_err(first).map(|()| mesh));
        let added = checked
            .and_then(|mesh| self.editor.add_mesh(mesh).map_err(|why| ("id".to_string(), why)));
        match added {
            Ok(said) => {
                self.screen.show(Mode::Main);
                self.inform(said);
            }
            Err((field, why)) => {
                if let Some(form) = self.screen.mesh_form() {
                    form.refuse(&field, why);
                }
            }
        }
        Vec::new()
    }

    /// Esc in the form: back to the list of meshes.
    pub(super) fn leave_mesh_form(&mut self) -> Vec<Command> {
        self.screen.leave_form();
        self.screen.show(Mode::Main);
        self.act(Action::PickMesh)
    }
}

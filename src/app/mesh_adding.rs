//! What Enter and Esc do in the form of a mesh.

use super::keymap::Action;
use super::mesh_form::ROWS;
use super::message::Command;
use super::{App, Mode};
use crate::problem::Problem;

impl App {
    /// Enter in the form: the next row, and from the last one the mesh is added and given to the layout.
    pub(super) fn take_mesh_form(&mut self) -> Vec<Command> {
        let unit = self.units();
        let Some(form) = self.screen.mesh_form() else { return Vec::new() };
        if form.index + 1 < ROWS.len() {
            form.step(1);
            return Vec::new();
        }
        let first = |found: Vec<Problem>| {
            let p = found.into_iter().next();
            p.map_or((String::new(), String::new()), |p| (p.field.clone(), p.to_string()))
        };
        let checked = form.mesh(unit).map_err(|(field, why)| (field.to_string(), why));
        let checked = checked.and_then(|mesh| mesh.check().map_err(first).map(|()| mesh));
        let added = checked.and_then(|mesh| {
            self.editor.add_mesh(mesh).map_err(|why| (ROWS[0].field.to_string(), why))
        });
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
        self.screen.show(Mode::Main);
        self.act(Action::PickMesh)
    }
}

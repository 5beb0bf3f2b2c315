//! What Enter and Esc do in the form of a mesh.

use super::adopt_form;
use super::keymap::Action;
use super::mesh_form::{FormKind, first};
use super::message::Command;
use super::{App, Mode};

impl App {
    /// Enter in the form: the next row, and from the last one the mesh is added and given to the layout, or its
    /// adoption begins.
    pub(super) fn take_mesh_form(&mut self) -> Vec<Command> {
        let unit = self.units();
        let Some(form) = self.screen.mesh_form() else { return Vec::new() };
        if !form.at_end() {
            let wrong = match form.kind {
                FormKind::Record => form.mesh(unit).err(),
                FormKind::Tests => adopt_form::typed(form, unit).err(),
            };
            // What is wrong in a row is said while it is looked at.
            match wrong.and_then(|wrong| form.said_here(wrong)) {
                Some((field, why)) => form.refuse(field, why),
                None => form.step(1),
            }
            return Vec::new();
        }
        if form.kind == FormKind::Tests {
            return self.take_adopt_form();
        }
        let checked = form.mesh(unit).map_err(first);
        match checked.and_then(|mesh| self.editor.add_mesh(mesh).map_err(|why| ("id", why))) {
            Ok(said) => {
                self.screen.show(Mode::Main);
                self.inform(said);
            }
            Err((field, why)) => {
                if let Some(form) = self.screen.mesh_form() {
                    form.refuse(field, why);
                }
            }
        }
        Vec::new()
    }

    /// The marked mesh of the project goes into the user's own catalogue too.
    pub(super) fn keep_mesh(&mut self) -> Vec<Command> {
        let Mode::MeshPicker { index } = *self.screen.mode() else { return Vec::new() };
        match self.meshes().into_iter().nth(index) {
            Some(choice) if choice.inline => {
                // Another project that is opened now is offered it already.
                self.editor.offer_too(&choice.mesh);
                vec![Command::KeepMesh { mesh: choice.mesh }]
            }
            _ => {
                self.complain(
                    "only a mesh that is written out in this project is kept by this key",
                );
                Vec::new()
            }
        }
    }

    /// Esc in the form: back to the list of meshes.
    pub(super) fn leave_mesh_form(&mut self) -> Vec<Command> {
        self.screen.leave_form();
        self.screen.show(Mode::Main);
        self.act(Action::PickMesh)
    }
}

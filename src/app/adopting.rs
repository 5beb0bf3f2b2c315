//! A mesh adopted from its own tests: its form, the work behind the screen, and what comes of it.

use super::adopt_form::{self, Typed, typed};
use super::mesh_form::{Refusal, first, of_rows};
use super::message::Command;
use super::{App, Mode};
use crate::job::adoption::AdoptJob;
use crate::job::order::Task;
use crate::lab::adopt::folder;
use crate::mesh::MeshType;
use crate::problem::Problem;
use std::sync::Arc;

impl App {
    /// Offers meshes of the user's own in the list of meshes.
    pub fn offer(&mut self, own: Vec<Arc<MeshType>>) {
        self.editor.offer(own);
    }

    /// Shows the form, as it was left.
    pub(super) fn show_adopt_form(&mut self) {
        let form = self.screen.take_left_form();
        let form = form.unwrap_or_else(|| Box::new(adopt_form::form()));
        self.screen.show(Mode::MeshForm(form));
    }

    /// Enter in the last row of the form: the work begins.
    pub(super) fn take_adopt_form(&mut self) -> Vec<Command> {
        let unit = self.units();
        let Some(form) = self.screen.mesh_form() else { return Vec::new() };
        let typed = typed(form, unit).map_err(first);
        match typed.and_then(|typed| self.adoption(typed)) {
            Ok(job) => {
                let id = job.words.id.clone();
                self.screen.leave_form();
                self.screen.show(Mode::Main);
                self.inform(format!("adopting {id}; Esc ends it, m and A go on with it"));
                vec![self.work.start_steps("adopt", Task::Adopt(Box::new(job)))]
            }
            Err((field, why)) => {
                if let Some(form) = self.screen.mesh_form() {
                    form.refuse(field, why);
                }
                Vec::new()
            }
        }
    }

    /// The work for what was typed.
    fn adoption(&self, typed: Typed) -> Result<AdoptJob, Refusal> {
        let Typed { words, sheet, curve, runs } = typed;
        if let Err(why) = self.editor.new_mesh(&words.id) {
            return Err(("--name", why));
        }
        let Some(file) = self.editor.path() else {
            let why =
                "the work is kept beside the project's file, and it has none yet: Esc, :w PATH";
            return Err(("--source", why.into()));
        };
        let folder = folder(file, &words.id);
        Ok(AdoptJob { folder, sheet, curve, words, runs, uid: self.layout().uid })
    }

    /// The work ended because of what was typed: the form comes back where nothing else is open.
    pub(super) fn form_refused(&mut self, problems: &[Problem]) {
        let Some(problem) = problems.first() else { return };
        if matches!(self.screen.mode(), Mode::Main) {
            self.show_adopt_form();
            if let Some(form) = self.screen.mesh_form() {
                let (field, why) = form.refusal(problem);
                form.refuse(field, why);
            }
        } else {
            self.complain(of_rows(&problem.to_string()));
        }
    }

    /// A mesh was adopted: it goes into the project.
    pub(super) fn adopted(
        &mut self,
        (number, uid): (u64, u64),
        mesh: &Arc<MeshType>,
        remarks: &[String],
    ) {
        // Work that gave way, or of another project, is heard no more: it is kept, and quickly taken up.
        if !self.work.at_steps(number) {
            return;
        }
        match self.editor.adopt_mesh(uid, mesh) {
            Ok(said) => {
                self.screen.forget_form();
                let remarks: Vec<String> =
                    remarks.iter().map(|remark| format!("; {}", of_rows(remark))).collect();
                self.inform(format!("{said}; Ctrl+S saves it{}", remarks.concat()));
            }
            Err(why) => self.complain(why),
        }
    }
}

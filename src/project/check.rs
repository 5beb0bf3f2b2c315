//! Checks a project as a whole: every value against its range, every name against the others.

use super::schema::{
    LONGEST_NAME, MOST_LAYOUTS, MOST_MESHES, MOST_OVERLAYS, MeshUse, NamedLayout, Project,
};
use crate::case::Input;
use crate::mesh::{catalogue, strength};
use crate::problem::Problem;
use crate::words::shown;
use std::collections::HashMap;

/// Longest notes, in bytes.
const LONGEST_NOTES: usize = 64 * 1024;

impl Project {
    /// Checks every value against its range and every name against the others.
    ///
    /// # Errors
    /// Everything that is wrong, by its path in the file, for example `layouts[2].d`.
    pub fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Vec::new();
        problems.extend(check_name("name", &self.name, true));
        problems.extend(check_name("site", &self.site, false));
        let title = self.title.rows().into_iter();
        problems.extend(title.filter_map(|(field, text)| check_name(field, text, false)));
        problems.extend(check_notes("notes", &self.notes));
        self.check_meshes(&mut problems);
        self.check_layouts(&mut problems);
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }

    fn check_meshes(&self, problems: &mut Vec<Problem>) {
        if self.meshes.len() > MOST_MESHES {
            problems.push(
                Problem::new("meshes", "there are too many meshes")
                    .value(format!("{} meshes", self.meshes.len()))
                    .allowed(format!("up to {MOST_MESHES}")),
            );
            return;
        }
        let mut seen: HashMap<&str, usize> = HashMap::new();
        for (index, mesh) in self.meshes.iter().enumerate() {
            let path = format!("meshes[{index}]");
            if let Some(first) = seen.insert(mesh.id(), index) {
                problems.push(
                    Problem::new(&path, format!("meshes[{first}] has the same identifier"))
                        .value(format!("{:?}", mesh.id()))
                        .advice("give each mesh an identifier of its own"),
                );
            }
            match mesh {
                MeshUse::Catalogue(id) if strength::find(id).is_some() => {
                    problems.extend(strength::find(id).map(|record| record.problem().under(&path)));
                }
                MeshUse::Catalogue(id) if catalogue::find(id).is_none() => {
                    problems.push(
                        Problem::new(&path, "the catalogue has no mesh of this identifier")
                            .value(format!("{id:?}"))
                            .allowed(self.mesh_ids())
                            .advice("or write the mesh out in the project"),
                    );
                }
                MeshUse::Catalogue(_) => {}
                MeshUse::Inline(mesh) => {
                    if let Err(found) = mesh.check() {
                        problems.extend(found.into_iter().map(|p| p.under(&path)));
                    }
                }
            }
        }
    }

    fn check_layouts(&self, problems: &mut Vec<Problem>) {
        if self.layouts.len() > MOST_LAYOUTS {
            problems.push(
                Problem::new("layouts", "there are too many layouts")
                    .value(format!("{} layouts", self.layouts.len()))
                    .allowed(format!("up to {MOST_LAYOUTS}")),
            );
            return;
        }
        let mut seen: HashMap<&str, usize> = HashMap::new();
        let mut overlays = 0;
        for (index, layout) in self.layouts.iter().enumerate() {
            let path = format!("layouts[{index}]");
            let mut add = |p: Problem| problems.push(p.under(&path));
            if let Some(&first) = seen.get(layout.name.trim()) {
                add(Problem::new("name", format!("layouts[{first}] has the same name"))
                    .value(format!("{:?}", layout.name))
                    .advice("give each layout a name of its own"));
            } else {
                seen.insert(layout.name.trim(), index);
            }
            overlays += usize::from(layout.overlay);
            if layout.overlay && overlays > MOST_OVERLAYS {
                add(Problem::new("overlay", "too many layouts are overlaid")
                    .value("true")
                    .allowed(format!("up to {MOST_OVERLAYS} in a project")));
            }
            if self.find_mesh(&layout.mesh).is_none() {
                add(Problem::new("mesh", "there is no mesh of this identifier")
                    .value(format!("{:?}", layout.mesh))
                    .allowed(self.mesh_ids()));
            }
            if let Err(found) = layout.check() {
                found.into_iter().for_each(add);
            }
        }
    }

    /// The identifiers that a layout can name, as a text.
    fn mesh_ids(&self) -> String {
        let ids: Vec<String> =
            self.available_meshes().iter().take(8).map(|m| format!("{:?}", m.id)).collect();
        ids.join(", ")
    }
}

impl NamedLayout {
    /// Checks the layout by itself; its name against the others and its mesh are the project's.
    ///
    /// # Errors
    /// Every field that is wrong, by its name in the file.
    pub(crate) fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Vec::new();
        problems.extend(check_name("name", &self.name, true));
        problems.extend(check_notes("note", &self.note));
        if let Err(found) = self.layout.check() {
            problems.extend(found);
        }
        let asked = Input::QUESTION.into_iter();
        problems.extend(asked.filter_map(|i| self.get(i).and_then(|value| i.problem(value))));
        if self.question.force.is_some()
            && let Some(pressure) = self.question.pressure
        {
            let said = "a layout has a design force or a pressure, never both";
            problems.push(
                Problem::new(Input::Pressure.row().name, said)
                    .value(Input::Pressure.text(pressure))
                    .allowed("one of design_force and pressure"),
            );
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }
}

/// What is wrong with a name: empty, too long, or with characters that cannot be shown.
pub(crate) fn check_name(field: &str, name: &str, needed: bool) -> Option<Problem> {
    let said = if needed && name.trim().is_empty() {
        "a name is needed"
    } else if name.chars().count() > LONGEST_NAME {
        "the name is too long"
    } else if !name.chars().all(shown) {
        "the name has characters that cannot be shown"
    } else {
        return None;
    };
    let least = usize::from(needed);
    Some(
        Problem::new(field, said)
            .value(format!("{name:?}"))
            .allowed(format!("{least} to {LONGEST_NAME} characters on one line")),
    )
}

fn check_notes(field: &str, notes: &str) -> Option<Problem> {
    if notes.len() > LONGEST_NOTES {
        Some(
            Problem::new(field, "the text is too long")
                .value(format!("{} bytes", notes.len()))
                .allowed(format!("up to {LONGEST_NOTES} bytes")),
        )
    } else {
        Problem::of_text(field, notes)
    }
}

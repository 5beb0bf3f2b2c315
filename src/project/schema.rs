//! A project in memory: what a user's file holds, in SI.

use crate::case::{Case, Input, Question};
use crate::layout::{self, BranchRule, Layout};
use crate::mesh::adopted::{KeptMethod, NamedMethods};
use crate::mesh::{self, MeshType, catalogue};
use crate::problem::Problem;
use crate::study::result::CheckResult;
use crate::study::verdict::Basis;
use crate::units::Units;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// The format that this program writes. Older ones are still read, see [`super::migrate`].
pub(crate) const CURRENT_VERSION: u32 = 2;

/// A project: a site's layouts and the meshes they use.
#[derive(Debug, Clone, PartialEq)]
pub struct Project {
    /// Format version, always [`CURRENT_VERSION`] in memory.
    pub version: u32,
    /// Name of the project, not empty.
    pub name: String,
    /// Where it is; may be empty.
    pub site: String,
    /// What the head of a report says besides.
    pub title: TitleBlock,
    /// Free text; may be empty and may have several lines.
    pub notes: String,
    /// Which value of a capacity verdicts go by. Left out in a file: the mean.
    pub basis: Basis,
    /// Methods of forecasts in files of their own.
    pub method_files: Vec<MethodFile>,
    /// The mesh types it uses. Empty stands for the reference mesh alone.
    pub meshes: Vec<MeshUse>,
    /// Its layouts, in the order of the list on the screen; names are unique.
    pub layouts: Vec<NamedLayout>,
    /// How it is shown.
    pub display: Display,
}

/// A method's file as a project names it, and what is in it.
#[derive(Debug, Clone)]
pub struct MethodFile {
    /// Its path, from the project's folder, as it stands in the project.
    pub file: String,
    /// The method, once the file has been read.
    pub(crate) method: Option<KeptMethod>,
}

/// Two are the same that are named alike: a project is the same before and after its methods are read.
impl PartialEq for MethodFile {
    fn eq(&self, other: &MethodFile) -> bool {
        self.file == other.file
    }
}

/// What the head of a report says besides the project's name and site; each may be empty. The date is a
/// text like the others: nothing here reads a clock.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TitleBlock {
    /// For whom.
    pub client: String,
    /// By whom.
    pub author: String,
    /// Checked by whom.
    pub checker: String,
    /// Which revision.
    pub revision: String,
    /// When.
    pub date: String,
}

impl TitleBlock {
    /// The names of its fields, in the file and in commands, in the order of a report.
    pub(crate) const FIELDS: [&str; 5] = ["client", "author", "checker", "revision", "date"];

    /// The field of a name.
    pub(crate) fn field_mut(&mut self, name: &str) -> Option<&mut String> {
        Some(match name {
            "client" => &mut self.client,
            "author" => &mut self.author,
            "checker" => &mut self.checker,
            "revision" => &mut self.revision,
            "date" => &mut self.date,
            _ => return None,
        })
    }

    /// Its fields with their names.
    pub(crate) fn rows(&self) -> [(&'static str, &str); 5] {
        let texts = [&self.client, &self.author, &self.checker, &self.revision, &self.date];
        std::array::from_fn(|at| (Self::FIELDS[at], texts[at].as_str()))
    }
}

/// A mesh type that a project uses.
#[derive(Debug, Clone, PartialEq)]
pub enum MeshUse {
    /// One of the catalogue, by its identifier.
    Catalogue(String),
    /// One written out in the project.
    Inline(Arc<MeshType>),
}

impl MeshUse {
    /// Identifier of the mesh, by which layouts name it.
    pub(crate) fn id(&self) -> &str {
        match self {
            MeshUse::Catalogue(id) => id,
            MeshUse::Inline(mesh) => &mesh.id,
        }
    }
}

/// How a project is shown.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Display {
    /// Units on the screen; the file always holds metres and kN.
    pub units: Units,
}

/// A layout with its name, its mesh and its design question. What its inputs may be stands in
/// [`crate::case::input`].
///
/// Two layouts are equal when all but their [`uid`](NamedLayout::uid) is equal.
#[derive(Debug, Clone)]
pub struct NamedLayout {
    /// Which layout this is, whatever its name, values and position: kept through edits, undo and
    /// reordering, so that its comments in the file can follow it. Not part of the file.
    /// A copy that is to be a layout of its own needs a [`fresh_uid`].
    pub uid: u64,
    /// Name, unique in the project, 1 to 60 characters.
    pub name: String,
    /// Its geometry.
    pub layout: Layout,
    /// Identifier of the mesh. Left out in a file: the project's first mesh.
    pub mesh: String,
    /// Which branch of Eqs. A.1-A.2 to take, default `published`.
    pub branch: BranchRule,
    /// What is asked of it.
    pub question: Question,
    /// Whether the layout's curve is drawn over the current one; at most [`MOST_OVERLAYS`] are.
    pub overlay: bool,
    /// Free text; may be empty.
    pub note: String,
    /// The last check that the user asked for, whether or not its inputs are still the layout's.
    pub check: Option<Arc<CheckResult>>,
}

/// Most layouts whose curves are overlaid.
pub(crate) const MOST_OVERLAYS: usize = 4;
/// Most layouts in a project.
pub(crate) const MOST_LAYOUTS: usize = 1000;
/// Most mesh types in a project.
pub(crate) const MOST_MESHES: usize = 100;
/// Longest name of a project, site or layout, in characters.
pub(crate) const LONGEST_NAME: usize = 60;

/// A number for a new layout's [`uid`](NamedLayout::uid), never given out before in this process.
pub(crate) fn fresh_uid() -> u64 {
    // Shared by the whole process on purpose: a number taken from a project's state would come back
    // after an undo and hand one layout's comments to another.
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

impl PartialEq for NamedLayout {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
            && self.layout == other.layout
            && self.mesh == other.mesh
            && self.branch == other.branch
            && self.question == other.question
            && self.overlay == other.overlay
            && self.note == other.note
            && self.check == other.check
    }
}

impl NamedLayout {
    /// A new layout of this name and geometry, with the given mesh and nothing else set.
    pub fn new(name: impl Into<String>, layout: Layout, mesh: impl Into<String>) -> Self {
        NamedLayout {
            uid: fresh_uid(),
            name: name.into(),
            layout,
            mesh: mesh.into(),
            branch: BranchRule::Published,
            question: Question::default(),
            overlay: false,
            note: String::new(),
            check: None,
        }
    }

    /// An input's value, SI; missing where it is not set.
    pub fn get(&self, input: Input) -> Option<f64> {
        input.of(&self.layout, &self.question)
    }

    /// Sets an input, SI, unchecked; `None` takes it away, see [`Input::put`].
    pub fn set(&mut self, input: Input, value: Option<f64>) {
        input.put(&mut self.layout, &mut self.question, value);
    }

    /// What is asked of it, with the load as a force on the panel.
    pub(crate) fn asked(&self) -> Question {
        self.question.on(&self.layout)
    }

    /// The layout as a case, with its mesh.
    pub(crate) fn case(&self, mesh: Arc<MeshType>) -> Case {
        Case { layout: self.layout, mesh, rule: self.branch, question: self.question }
    }

    /// The same layout under another name, as a layout of its own: a fresh uid, no overlay.
    pub fn duplicate(&self, name: impl Into<String>) -> Self {
        NamedLayout { uid: fresh_uid(), name: name.into(), overlay: false, ..self.clone() }
    }
}

impl Project {
    /// A project of one layout at the published reference point with the reference mesh.
    pub fn starter(name: impl Into<String>) -> Self {
        Project {
            version: CURRENT_VERSION,
            name: name.into(),
            site: String::new(),
            title: TitleBlock::default(),
            notes: String::new(),
            basis: Basis::Characteristic,
            method_files: Vec::new(),
            meshes: vec![MeshUse::Catalogue(mesh::REFERENCE_ID.to_string())],
            layouts: vec![NamedLayout::new("reference", layout::NEW, mesh::REFERENCE_ID)],
            display: Display::default(),
        }
    }

    /// Identifier of the mesh of a layout that names none: the project's first, or the reference mesh.
    pub(crate) fn default_mesh(&self) -> &str {
        self.meshes.first().map_or(mesh::REFERENCE_ID, MeshUse::id)
    }

    /// The mesh of a layout, if there is one of that identifier, see [`Project::find_mesh`].
    pub fn mesh(&self, layout: &NamedLayout) -> Option<Arc<MeshType>> {
        self.find_mesh(&layout.mesh)
    }

    /// The mesh of this identifier: one written out in the project, or else one of the catalogue.
    pub(crate) fn find_mesh(&self, id: &str) -> Option<Arc<MeshType>> {
        let inline = self.meshes.iter().find_map(|m| match m {
            MeshUse::Inline(mesh) if mesh.id == id => Some(mesh.clone()),
            _ => None,
        });
        let mesh = inline.or_else(|| catalogue::find(id))?;
        let named = self.method_files.iter().filter_map(|file| file.method);
        let named: Vec<KeptMethod> = named.filter(|kept| kept.0.mesh == id).collect();
        if named.is_empty() {
            return Some(mesh);
        }
        Some(Arc::new(MeshType { methods: NamedMethods(named), ..(*mesh).clone() }))
    }

    /// A layout as a case.
    ///
    /// # Errors
    /// There is no mesh of its mesh's identifier.
    pub(crate) fn case(&self, layout: &NamedLayout) -> Result<Case, Problem> {
        self.mesh(layout).map(|mesh| layout.case(mesh)).ok_or_else(|| {
            Problem::new("mesh", "the project and the catalogue have no such mesh")
                .value(format!("{:?}", layout.mesh))
        })
    }

    /// Every mesh that a layout can name: those of the project first, then the rest of the catalogue.
    pub(crate) fn available_meshes(&self) -> Vec<Arc<MeshType>> {
        let mut list: Vec<Arc<MeshType>> =
            self.meshes.iter().filter_map(|m| self.find_mesh(m.id())).collect();
        for mesh in catalogue::all() {
            if !list.iter().any(|m| m.id == mesh.id) {
                list.push(mesh.clone());
            }
        }
        list
    }

    /// The layout of this name; blanks around the name do not matter.
    pub fn find_layout(&self, name: &str) -> Option<&NamedLayout> {
        self.layouts.iter().find(|l| l.name.trim() == name.trim())
    }

    /// A name near `wanted` that no layout has yet: `bench 2`, `bench 2 (2)`, `bench 2 (3)`.
    pub fn free_name(&self, wanted: &str) -> String {
        let wanted = wanted.trim();
        let wanted = if wanted.is_empty() { "layout" } else { wanted };
        if self.find_layout(wanted).is_none() {
            return wanted.to_string();
        }
        let stem = wanted
            .rsplit_once(" (")
            .filter(|(_, n)| n.strip_suffix(')').is_some_and(|n| n.parse::<u32>().is_ok()))
            .map_or(wanted, |(stem, _)| stem);
        // One more than there are layouts: one of these names is free.
        for n in 2..self.layouts.len() + 3 {
            let tail = format!(" ({n})");
            let room = LONGEST_NAME - tail.len();
            let name = format!("{}{tail}", stem.chars().take(room).collect::<String>().trim_end());
            if self.find_layout(&name).is_none() {
                return name;
            }
        }
        wanted.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_project_without_meshes_uses_the_reference_mesh() {
        let mut project = Project::starter("p");
        project.meshes.clear();
        assert_eq!(project.default_mesh(), mesh::REFERENCE_ID);
        assert!(project.mesh(&project.layouts[0]).is_some_and(|m| m.reference));
    }

    #[test]
    fn an_inline_mesh_goes_before_one_of_the_catalogue() {
        let mut own = (*catalogue::reference()).clone();
        own.name = "ours".into();
        let mut project = Project::starter("p");
        project.meshes = vec![MeshUse::Inline(Arc::new(own))];
        assert_eq!(
            project.find_mesh(mesh::REFERENCE_ID).map(|m| m.name.clone()),
            Some("ours".into())
        );
        assert_eq!(project.find_mesh("no-such"), None);
    }

    #[test]
    fn free_names_are_free_and_not_too_long() {
        let mut project = Project::starter("p");
        assert_eq!(project.free_name("a"), "a");
        assert_eq!(project.free_name("reference"), "reference (2)");
        project.layouts.push(project.layouts[0].duplicate("reference (2)"));
        assert_eq!(project.free_name("reference (2)"), "reference (3)");
        let long = "x".repeat(LONGEST_NAME);
        project.layouts[0].name = long.clone();
        assert_eq!(project.free_name(&long).chars().count(), LONGEST_NAME);
    }

    #[test]
    fn equality_looks_past_the_uid() {
        let one = Project::starter("p");
        let mut two = Project::starter("p");
        assert_ne!(one.layouts[0].uid, two.layouts[0].uid);
        assert_eq!(one, two);
        two.layouts[0].layout.ey = 0.1;
        assert_ne!(one, two);
    }
}

//! The user's own catalogue: meshes that were adopted and are kept for other projects too, in one file of the user's
//! folder. A project that takes one holds the whole of it.

use super::error::{Cause, FileFault, Found, LoadError};
use super::hold::rewrite;
use super::home::Home;
use super::load::{LARGEST_FILE, decode_utf8, read_within};
use super::read;
use super::text::parser;
use super::write::commented;
use crate::mesh::MeshType;
use crate::problem::Problem;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;

/// Name of the file.
const NAME: &str = "meshes.ron";
/// What stands on its top.
const COMMENT: &str =
    "Meshes of your own, by meshcast adopt --catalogue; a project takes one with m";

impl Home {
    /// The file of the user's own meshes; it need not exist.
    pub(crate) fn meshes_file(&self) -> Option<PathBuf> {
        self.data_dir().map(|dir| dir.join(NAME))
    }

    /// The user's own meshes; none where there is no file.
    ///
    /// # Errors
    /// What is wrong with the file.
    pub fn own_meshes(&self) -> Result<Vec<Arc<MeshType>>, LoadError> {
        let Some(file) = self.meshes_file() else { return Ok(Vec::new()) };
        match read_within(&file, LARGEST_FILE) {
            Ok(bytes) => meshes(bytes, &file.display().to_string()),
            Err(error) if error.cause == Cause::NotFound => Ok(Vec::new()),
            Err(error) => Err(error),
        }
    }

    /// Puts a mesh behind the user's own; the file. What stands in it stays.
    ///
    /// # Errors
    /// In a sentence: there is no folder, a mesh of this identifier, or a file that cannot be read or written.
    pub fn keep_own_mesh(&self, mesh: &Arc<MeshType>) -> Result<PathBuf, String> {
        let file = self.meshes_file().ok_or("there is no folder for a catalogue of your own")?;
        let shown = file.display().to_string();
        let kept = rewrite(&file, |old| {
            let mut all = match old {
                Some(old) => meshes(old.to_vec(), &shown)
                    .map_err(|error| io::Error::other(error.in_one_line()))?,
                None => Vec::new(),
            };
            if all.iter().any(|there| there.id == mesh.id) {
                let said = format!("it has a mesh {:?} already, which stays", mesh.id);
                return Err(io::Error::other(said));
            }
            all.push(mesh.clone());
            let plain: Vec<&MeshType> = all.iter().map(|mesh| &**mesh).collect();
            let text = commented(&plain, COMMENT)
                .ok_or_else(|| io::Error::other("the mesh cannot be written as RON"))?;
            Ok(Some(text.into_bytes()))
        });
        kept.map(|()| file.clone()).map_err(|e| format!("{}: {e}", file.display()))
    }
}

/// The meshes of a file, each sound and of an identifier of its own.
fn meshes(bytes: Vec<u8>, shown: &str) -> Result<Vec<Arc<MeshType>>, LoadError> {
    let text = decode_utf8(bytes, shown)?;
    let refuse = |faults| LoadError::new(shown, Cause::BadInput, faults);
    let place = |found: Vec<Found>, tree| {
        refuse(found.into_iter().map(|f| FileFault::placed(&text, tree, f)).collect())
    };
    let tree = parser::parse(&text).map_err(|e| place(vec![e.into()], None))?;
    let all: Vec<MeshType> =
        read::values(&text, &tree.root, "").map_err(|found| place(found, Some(&tree)))?;
    for (k, mesh) in all.iter().enumerate() {
        if let Err(problems) = mesh.check() {
            let at = format!("[{k}]");
            let found = |p| Found::located(&tree.root, Problem::under(p, &at));
            return Err(place(problems.into_iter().map(found).collect(), Some(&tree)));
        }
        if all[..k].iter().any(|before| before.id == mesh.id) {
            let twice =
                Problem::new(format!("[{k}].id"), "another mesh of the file has this identifier")
                    .value(&mesh.id);
            return Err(place(vec![Found::located(&tree.root, twice)], Some(&tree)));
        }
    }
    Ok(all.into_iter().map(Arc::new).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::adopted::{Adopted, AdoptedQuality, KeptMethod};
    use crate::mesh::catalogue;
    use crate::method::canned;

    fn mesh(id: &str) -> Arc<MeshType> {
        let mut mesh = (*catalogue::reference()).clone();
        (mesh.id, mesh.reference) = (id.into(), false);
        mesh.adopted = Some(Adopted {
            quality: AdoptedQuality::TwoTests,
            low: 20_000.0,
            middle: 22_000.0,
            high: 24_000.0,
            methods: vec![KeptMethod::keep(canned::method())],
        });
        Arc::new(mesh)
    }

    #[test]
    fn meshes_are_kept_one_behind_the_other_and_none_takes_anothers_place() {
        let dir = tempfile::tempdir().unwrap();
        let home = Home::at(Some(dir.path().join("data")));
        assert_eq!(home.own_meshes().unwrap(), []);
        let file = home.keep_own_mesh(&mesh("one")).unwrap();
        home.keep_own_mesh(&mesh("two")).unwrap();
        assert_eq!(home.own_meshes().unwrap(), [mesh("one"), mesh("two")]);
        let text = std::fs::read_to_string(&file).unwrap();
        let again = home.keep_own_mesh(&mesh("one")).unwrap_err();
        assert!(again.contains("has a mesh \"one\" already"), "{again}");
        assert_eq!(std::fs::read_to_string(&file).unwrap(), text);
        // A file that is no catalogue is said and stays.
        std::fs::write(&file, "[(id: \"x\"").unwrap();
        assert!(home.own_meshes().is_err());
        assert!(home.keep_own_mesh(&mesh("three")).unwrap_err().contains("meshes.ron"));
        assert_eq!(std::fs::read_to_string(&file).unwrap(), "[(id: \"x\"");
        // Which of two would be meant cannot be known.
        std::fs::write(&file, text.replace("\"two\"", "\"one\"")).unwrap();
        let twice = home.own_meshes().unwrap_err().to_string();
        assert!(twice.contains("another mesh of the file"), "{twice}");
        assert!(Home::at(None).keep_own_mesh(&mesh("one")).is_err());
    }
}

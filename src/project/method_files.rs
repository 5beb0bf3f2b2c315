//! The methods that a project names by file: `method_files: ["campaign/method.ron"]`, made by a campaign on
//! the screen or by `meshcast derive`. Paths are from the project's own folder.

use super::error::{Cause, FileFault, LoadError};
use super::load::{LARGEST_FILE, decode_utf8, load_table};
use super::schema::{MethodFile, Project};
use super::text::parser;
use crate::mesh::MeshType;
use crate::mesh::adopted::KeptMethod;
use crate::method::DerivedMethod;
use crate::problem::Problem;
use std::fs;
use std::path::Path;

/// Reads a method's file by the door of all files, and says what is wrong with it.
///
/// # Errors
/// A sentence.
pub(crate) fn read(path: &Path) -> Result<DerivedMethod, String> {
    let said = |error: LoadError| {
        let first = error.faults.into_iter().next();
        first.map_or_else(|| "it cannot be read".into(), |fault| fault.problem.message)
    };
    let bytes = load_table(path, LARGEST_FILE).map_err(said)?;
    let text = decode_utf8(bytes, "").map_err(said)?;
    // In bounds first: the reader of values has none for depth.
    parser::parse(&text).map_err(|_| "it is no method: derive writes one".to_string())?;
    DerivedMethod::from_ron(&text).map_err(|why| format!("it is no method: {why}"))
}

/// Reads a method's file whose path was typed, and names it for the project in the file `of`: from its folder
/// where it stands below that, and by the whole path where not.
///
/// # Errors
/// A sentence.
pub(crate) fn name(typed: &Path, of: &Path) -> Result<MethodFile, String> {
    let method = read(typed).map_err(|why| format!("{}: {why}", typed.display()))?;
    let whole = |path: &Path| {
        fs::canonicalize(path)
            .map_err(|why| format!("{} is not found again: {why}", path.display()))
    };
    let folder = of.parent().filter(|folder| !folder.as_os_str().is_empty());
    let (file, folder) = (whole(typed)?, whole(folder.unwrap_or(Path::new(".")))?);
    let named = file.strip_prefix(&folder).unwrap_or(&file);
    let named = named.to_str().ok_or("its name is no text, and a project's file is one")?;
    Ok(MethodFile { file: named.to_string(), method: Some(KeptMethod::keep(method)) })
}

/// Whether a mesh can go by a method: it has the net and the wires of the simulations.
///
/// # Errors
/// A sentence.
pub(crate) fn fits(method: &DerivedMethod, mesh: Option<&MeshType>) -> Result<(), String> {
    let mesh = mesh
        .filter(|mesh| mesh.id == method.mesh)
        .ok_or_else(|| format!("it is of the mesh {:?}, which is not here", method.mesh))?;
    match mesh.wire.as_ref() {
        Some(wire) if wire.print().to_string() == method.wires => Ok(()),
        Some(_) => Err(format!(
            "its simulations are of another net or other wires than those of {:?}: make its campaign again",
            method.mesh
        )),
        None => Err(format!("{:?} has no net and wires to go by", method.mesh)),
    }
}

/// Reads the methods of a project that stands in a file.
///
/// # Errors
/// The first that cannot be read or does not fit.
pub(super) fn resolve(project: &mut Project, of: &Path) -> Result<(), LoadError> {
    let folder = of.parent().unwrap_or(Path::new(""));
    let mut seen: Vec<(String, crate::layout::Blocks)> = Vec::new();
    for index in 0..project.method_files.len() {
        let file = project.method_files[index].file.clone();
        let found = read(&folder.join(&file)).and_then(|method| {
            fits(&method, project.find_mesh(&method.mesh).as_deref())?;
            let key = (method.mesh.clone(), method.blocks);
            if seen.contains(&key) {
                return Err("another one is of the same mesh and arrangement".into());
            }
            seen.push(key);
            Ok(method)
        });
        match found {
            Ok(method) => project.method_files[index].method = Some(KeptMethod::keep(method)),
            Err(why) => return Err(refused(of, index, &file, &why)),
        }
    }
    Ok(())
}

/// Whether a project finds the methods that it has beside another file too, so that what is saved there can
/// be opened again and gives the same.
///
/// # Errors
/// The name of the first that is not there.
pub(super) fn follow(project: &Project, to: &Path) -> Result<(), String> {
    let folder = to.parent().unwrap_or(Path::new(""));
    let away = project.method_files.iter().find(|named| {
        let there = read(&folder.join(&named.file)).ok().map(KeptMethod::keep);
        there.is_none() || there != named.method
    });
    away.map_or(Ok(()), |named| Err(named.file.clone()))
}

/// That methods cannot be looked for.
pub(super) fn nowhere(project: &Project, shown: &str) -> Result<(), LoadError> {
    match project.method_files.first() {
        None => Ok(()),
        Some(first) => {
            let why =
                "methods are looked for beside the project's file, and this one stands in none";
            Err(refused(Path::new(shown), 0, &first.file, why))
        }
    }
}

fn refused(of: &Path, index: usize, file: &str, why: &str) -> LoadError {
    let problem = Problem::new(format!("method_files[{index}]"), why)
        .value(format!("{file:?}"))
        .advice("name another one or take it out; paths are from the project's folder");
    let fault = FileFault { problem, ..FileFault::whole("", String::new()) };
    LoadError::new(&of.display().to_string(), Cause::BadInput, vec![fault])
}

#[cfg(test)]
mod tests {
    use super::super::save::Overwrite;
    use super::super::{SaveError, load};
    use crate::mesh::catalogue;
    use crate::method::{DerivedMethod, canned};
    use std::fs;

    /// A method's file of the reference mesh.
    fn method() -> (DerivedMethod, String) {
        let reference = catalogue::reference();
        let wires = reference.wire.as_ref().unwrap().print().to_string();
        let method = DerivedMethod { mesh: reference.id.clone(), wires, ..canned::method() };
        let text = ron::ser::to_string(&method).unwrap();
        (method, text)
    }

    #[test]
    fn a_typed_file_is_named_from_the_projects_folder() {
        let dir = tempfile::tempdir().unwrap();
        let [site, other] = ["site", "other"].map(|name| dir.path().join(name));
        fs::create_dir_all(site.join("runs")).unwrap();
        fs::create_dir(&other).unwrap();
        let of = site.join("p.ron");
        for folder in [site.join("runs"), other.clone()] {
            fs::write(folder.join("m.ron"), method().1).unwrap();
        }
        let below = super::name(&site.join("runs/../runs/m.ron"), &of).unwrap();
        assert_eq!(below.file, "runs/m.ron");
        // Outside of the folder the whole path is what finds it.
        let outside = super::name(&other.join("m.ron"), &of).unwrap();
        assert_eq!(outside.file, other.canonicalize().unwrap().join("m.ron").to_str().unwrap());
        assert_eq!(below.method, outside.method);
        assert!(super::name(&site.join("none.ron"), &of).unwrap_err().contains("none.ron"));
        fs::write(site.join("no.ron"), "(version: 2)").unwrap();
        assert!(super::name(&site.join("no.ron"), &of).unwrap_err().contains("no method"));
    }

    /// Seen: a project was saved into another folder and could not be opened there, for its method stayed where
    /// it was. Cause: its text was looked at before it was written, and not what it names.
    #[test]
    fn a_project_is_saved_only_where_it_finds_its_methods() {
        let dir = tempfile::tempdir().unwrap();
        let [here, there] = ["here", "there"].map(|name| dir.path().join(name));
        fs::create_dir(&here).unwrap();
        fs::create_dir(&there).unwrap();
        let (canned, method) = method();
        fs::write(here.join("m.ron"), &method).unwrap();
        let text = "(version: 2, name: \"p\", meshes: [\"dt-8x10-2.7\"], method_files: [\"m.ron\"], layouts: [])";
        fs::write(here.join("p.ron"), text).unwrap();
        let mut opened = load(&here.join("p.ron")).unwrap();
        let mut save = |name| {
            opened.document.save_as(&there.join(name), &opened.project, Overwrite::No).map(|_| ())
        };
        let said = save("q.ron").unwrap_err();
        assert!(matches!(said, SaveError::MethodAway(_)), "{said}");
        assert!(said.to_string().contains("m.ron") && !there.join("q.ron").exists(), "{said}");
        // Another method of that name is not this one.
        let mut other = canned.clone();
        other.alpha.force *= 1.1;
        fs::write(there.join("m.ron"), ron::ser::to_string(&other).unwrap()).unwrap();
        assert!(save("q.ron").is_err());
        fs::write(there.join("m.ron"), &method).unwrap();
        save("q.ron").unwrap();
        assert_eq!(load(&there.join("q.ron")).unwrap().project.method_files.len(), 1);
    }
}

//! The wires of a check: those of its mesh, of a file, or a named law on the mesh's net.

use super::output::Fault;
use crate::mesh::wire::WireData;
use crate::mesh::{MeshType, laws};
use crate::problem::Problem;
use crate::project::load_wire;
use crate::units::shortest;
use std::path::{Path, PathBuf};

/// Laws with a name.
pub(crate) const LAWS: &str = "bench, yade or reference";

/// What stands above the mesh's own wires.
#[derive(Debug, Clone, Default)]
pub(crate) struct Wires {
    file: Option<(PathBuf, WireData)>,
    law: Option<WireData>,
}

impl Wires {
    /// Reads what the flags name: a whole mesh file, and a law whose curves and distortion are taken.
    ///
    /// # Errors
    /// A file that cannot be read, or a law of no such name.
    pub(crate) fn read(mesh_file: Option<&Path>, law: Option<&str>) -> Result<Wires, Fault> {
        let read = |path: &Path| load_wire(path).map(|wire| (path.to_path_buf(), wire));
        let file = mesh_file.map(read).transpose()?;
        let law = law.map(named_or_file).transpose()?;
        Ok(Wires { file, law })
    }

    /// The mesh that is checked in place of `mesh`, where a file has another net: it is named by that file,
    /// and `mesh` tells nothing of it.
    pub(crate) fn other_net(&self, mesh: &MeshType) -> Option<MeshType> {
        let (path, wire) = self.file.as_ref()?;
        let own = mesh.wire.as_ref().map(|wire| wire.net);
        own.is_none_or(|net| net != wire.net).then(|| {
            let mm = |v: f64| shortest(1000.0 * v);
            let net =
                format!("opening {} mm, wire {} mm", mm(wire.net.opening), mm(wire.net.diameter));
            let id =
                path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
            MeshType {
                id,
                name: net,
                reference: false,
                wire: Some(wire.clone()),
                adopted: None,
                ..mesh.clone()
            }
        })
    }

    /// The wires of a check of `mesh`.
    ///
    /// # Errors
    /// A mesh without wire data where no file stands in for them.
    pub(crate) fn for_mesh(&self, mesh: &MeshType) -> Result<WireData, Fault> {
        let Some(wire) = self.file.as_ref().map(|(_, wire)| wire).or(mesh.wire.as_ref()) else {
            return Err(Fault::input(without_wire(mesh)));
        };
        Ok(match &self.law {
            None => wire.clone(),
            Some(law) => WireData { net: wire.net, ..law.clone() },
        })
    }
}

/// What to say of a mesh that has no wire data.
pub(crate) fn without_wire(mesh: &MeshType) -> String {
    Problem::new("mesh", "nothing is known of its net and wires, so it can be forecast and not checked")
        .value(format!("{:?}", mesh.id))
        .advice(
            "give them with --mesh-file FILE.ron (projects/wire/dt-8x10-2.7.ron shows how), or write wire: (...) into the project's mesh",
        )
        .to_string()
}

/// A law by its name, or from a file.
///
/// # Errors
/// No such name, or a file that cannot be read.
pub(crate) fn named_or_file(law: &str) -> Result<WireData, Fault> {
    if let Some(found) = laws::find(law) {
        return Ok(found);
    }
    if !law.contains(['.', '/', '\\']) && !Path::new(law).exists() {
        let problem = Problem::new("--law", "there is no law of this name")
            .value(format!("{law:?}"))
            .allowed(format!("{LAWS}, or a file such as FILE.ron"));
        return Err(Fault::input(problem.to_string()));
    }
    Ok(load_wire(Path::new(law))?)
}

//! The mesh types shipped with the program, from `assets/meshes.ron`.
//!
//! The catalogue holds only values that a public document states; each record names it.

use super::{MeshType, REFERENCE_ID};
use std::sync::{Arc, OnceLock};

const TEXT: &str = include_str!("../../assets/meshes.ron");

/// All mesh types of the catalogue, the reference mesh first.
pub(crate) fn all() -> &'static [Arc<MeshType>] {
    static ALL: OnceLock<Vec<Arc<MeshType>>> = OnceLock::new();
    ALL.get_or_init(|| {
        let options = ron::Options::default()
            .with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
        let list: Vec<MeshType> = options
            .from_str(TEXT)
            // The text is part of the program; a test loads it, so a broken one is never shipped.
            .unwrap_or_else(|e| panic!("assets/meshes.ron: {e}"));
        list.into_iter().map(Arc::new).collect()
    })
}

/// The mesh of this identifier, if the catalogue has it.
pub(crate) fn find(id: &str) -> Option<Arc<MeshType>> {
    all().iter().find(|m| m.id == id).cloned()
}

/// The reference mesh of the paper.
pub fn reference() -> Arc<MeshType> {
    find(REFERENCE_ID).unwrap_or_else(|| all()[0].clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_catalogue_loads_and_every_mesh_is_sound() {
        let mut ids = std::collections::BTreeSet::new();
        for mesh in all() {
            assert_eq!(mesh.check(), Ok(()), "{}", mesh.id);
            assert!(ids.insert(mesh.id.clone()), "{} stands twice", mesh.id);
            assert!(!mesh.laboratory.source.is_empty());
        }
        assert!(reference().reference);
        assert_eq!(reference().laboratory.force, 73_300.0);
    }
}

//! The forecast by a derived method: the same three steps with relations made of simulations
//! ([`crate::method`]).
//!
//! The methods of the reference mesh are shipped in `assets/methods`, made by `meshcast campaign` and
//! `meshcast derive`, for repeated blocks and for mirrored ones. Another mesh takes them as it takes the paper's
//! relations: with its own laboratory values, its own ratios where it has any, and a warning where not. A mesh
//! that was adopted brings methods of its own; an arrangement that it has none for borrows what an offset does
//! from the reference mesh. One block alone takes those of repeated blocks, unless the mesh has its own.

use super::eccentricity::Eccentricity;
use super::field::Branch;
use super::ratios::{self, Ratios};
use super::{Field, NoField, Strength};
use crate::layout::{Blocks, Layout};
use crate::mesh::MeshType;
use crate::mesh::adopted::Adopted;
use crate::method::DerivedMethod;
use crate::method::offset::Offsets;
use std::sync::OnceLock;

/// The method of an arrangement, as it is shipped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Arranged {
    /// Repeated blocks.
    Repeated,
    /// Blocks that face each other.
    Mirrored,
}

const TEXTS: [&str; 2] = [
    include_str!("../../assets/methods/dt-8x10-2.7-repeated.ron"),
    include_str!("../../assets/methods/dt-8x10-2.7-mirrored.ron"),
];

/// A shipped method.
pub(crate) fn shipped(of: Arranged) -> &'static DerivedMethod {
    static METHODS: OnceLock<[DerivedMethod; 2]> = OnceLock::new();
    let both = METHODS.get_or_init(|| {
        // The texts are part of the program and a test reads them, so a broken one is never shipped.
        TEXTS.map(|text| {
            DerivedMethod::from_ron(text).unwrap_or_else(|e| panic!("assets/methods: {e}"))
        })
    });
    &both[of as usize]
}

/// The arrangements that a layout's forecast considers, of which the lowest force counts.
fn arrangements(layout: &Layout) -> Result<&'static [Arranged], NoField> {
    let centred = layout.folded() == (0.0, 0.0);
    Ok(match layout.blocks {
        Blocks::Mirrored if centred => &[Arranged::Repeated],
        Blocks::Mirrored if layout.can_face() => &[Arranged::Mirrored],
        Blocks::Mirrored => return Err(NoField::Overlap),
        Blocks::Worst if !centred && layout.can_face() => &[Arranged::Repeated, Arranged::Mirrored],
        // For one block alone they are those of repeated ones where the mesh has no others, with a warning.
        Blocks::Worst | Blocks::Paper | Blocks::Repeated | Blocks::Single => &[Arranged::Repeated],
    })
}

/// Steps 1 and 2 of a layout: ratios, reference values, factors of the offset, and the panel's values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Derived {
    pub(super) ratios: Ratios,
    pub(super) eccentricity: Eccentricity,
    pub(super) field: Result<Field, NoField>,
    /// Whether the factors of the offset are another mesh's.
    pub(super) borrowed: bool,
    /// Whether the relations are of one block alone.
    pub(super) of_one: bool,
}

/// The relations that a mesh goes by in an arrangement.
#[derive(Debug, Clone, Copy)]
struct Relations {
    method: &'static DerivedMethod,
    offsets: &'static Offsets,
    /// Whether the method is the mesh's own.
    own: bool,
    /// Whether the offsets are not.
    borrowed: bool,
    /// Whether they are of one block alone.
    of_one: bool,
}

impl Relations {
    fn of(mesh: &MeshType, of: Arranged, blocks: Blocks) -> Relations {
        let adopted = mesh.adopted.as_ref();
        let own = |blocks| {
            let named = mesh.methods.method(blocks);
            named.or_else(|| adopted.and_then(|adopted| adopted.method(blocks)))
        };
        let wanted = match of {
            Arranged::Repeated => Blocks::Repeated,
            Arranged::Mirrored => Blocks::Mirrored,
        };
        let by = |method: &'static DerivedMethod, own| Relations {
            method,
            offsets: &method.offsets,
            own,
            borrowed: false,
            of_one: false,
        };
        // None is shipped of one block alone, but a mesh may have one.
        if let Some(method) = own(Blocks::Single).filter(|_| blocks == Blocks::Single) {
            return Relations { of_one: true, ..by(method, true) };
        }
        match (own(wanted), own(Blocks::Repeated)) {
            (Some(method), _) => by(method, true),
            (None, Some(method)) => {
                Relations { offsets: &shipped(of).offsets, borrowed: true, ..by(method, true) }
            }
            (None, None) => by(shipped(of), false),
        }
    }
}

/// By the methods of the mesh, or the shipped ones. `layout` has a square grid and no block on a plate.
pub(super) fn derived(layout: &Layout, mesh: &MeshType, laboratory: Strength) -> Derived {
    let list = arrangements(layout);
    let all = list.unwrap_or(&[Arranged::Repeated]).iter();
    let mut made: Vec<Derived> = all
        .map(|of| by(Relations::of(mesh, *of, layout.blocks), layout, mesh, laboratory))
        .collect();
    let force = |d: &Derived| d.field.map_or(f64::INFINITY, |field| field.values.force);
    made.sort_by(|a, b| force(a).total_cmp(&force(b)));
    // There is one at least.
    let lowest = made.swap_remove(0);
    Derived { field: list.and(lowest.field), ..lowest }
}

/// By one method.
fn by(
    Relations { method, offsets, own: by_own, borrowed, of_one }: Relations,
    layout: &Layout,
    mesh: &MeshType,
    laboratory: Strength,
) -> Derived {
    let own = ratios::of_mesh(mesh);
    let alpha =
        Ratios { force: method.alpha.force, deflection: method.alpha.deflection, default: !by_own };
    let ratios = if own.default { alpha } else { own };
    let reference = ratios::field_reference(laboratory, &ratios);
    let centred = method.sizes.at(layout);
    let factors = offsets.at(layout, &centred);
    let offset = layout.folded() != (0.0, 0.0);
    let sd = |k: usize, factor: f64| if offset { offsets.deviation[k] * factor } else { 0.0 };
    let eccentricity = Eccentricity {
        force: factors.force,
        deflection: factors.deflection,
        force_sd: sd(0, factors.force),
        deflection_sd: sd(1, factors.deflection),
        supported: true,
    };
    let by_offset = centred.deflection * factors.deflection;
    let values = Strength {
        force: centred.force * factors.force * reference.force,
        deflection: reference.deflection.map(|deflection| by_offset * deflection),
    };
    let small = centred.through > 0.5;
    let branch = if small { Branch::SmallPunch } else { Branch::LargePunch };
    let s = &method.scatter;
    let scatter = match (small, offset) {
        (true, false) => s.small,
        (false, false) => s.large,
        (true, true) => s.small_offset,
        (false, true) => s.large_offset,
    };
    // That the law is known within a range scatters no panel, but what is known of all of them.
    let laws = mesh.adopted.as_ref().filter(|_| by_own).map_or(0.0, Adopted::variation);
    let field = Field {
        values,
        regime: branch,
        branch,
        other_branch: None,
        method: Some(method),
        published: None,
        variation: scatter[0].hypot(laws),
    };
    Derived { ratios, eccentricity, field: Ok(field), borrowed: borrowed && offset, of_one }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forecast::forecast;
    use crate::forecast::warning::Warning;
    use crate::layout::{BranchRule, MethodChoice, REFERENCE};
    use crate::mesh::adopted::{AdoptedQuality, KeptMethod};
    use crate::mesh::catalogue;

    fn at(layout: Layout) -> crate::forecast::Forecast {
        let layout = Layout { method: MethodChoice::Derived, ..layout };
        forecast(&layout, &catalogue::reference(), BranchRule::Published).unwrap()
    }

    #[test]
    fn the_shipped_methods_are_sound_and_of_the_reference_mesh() {
        for (of, blocks) in
            [(Arranged::Repeated, Blocks::Repeated), (Arranged::Mirrored, Blocks::Mirrored)]
        {
            let method = shipped(of);
            assert_eq!((method.blocks, method.mesh.as_str()), (blocks, crate::mesh::REFERENCE_ID));
            assert!(method.runs.used > 300 && method.master.envelope.len() == 21);
            // At the reference panel the relations give about what they are scaled with. They are fits over the
            // whole range, so at one panel they may be off by the scatter of a run's deflection, 3 %.
            let centred = method.sizes.at(&REFERENCE);
            assert!(
                (centred.force - 1.0).abs() < 0.03 && (centred.deflection - 1.0).abs() < 0.03,
                "{centred:?}"
            );
        }
    }

    #[test]
    fn force_rises_with_block_and_plate_without_a_jump_at_d() {
        let force = |punch: f64, plate: f64| {
            at(Layout { plate, punch, ..REFERENCE }).field.unwrap().values.force
        };
        for plate in [0.16, 0.32, 0.48] {
            let mut before = force(0.1, plate);
            for k in 11..100 {
                let now = force(f64::from(k) / 100.0, plate);
                // A centimetre more of block is at most a tenth more of force where the force goes with D, and
                // no loss beyond what the scatter of the runs leaves in the exponents.
                assert!(now > before * 0.998 && now < before * 1.12, "d {plate}, D 0.{k}");
                before = now;
            }
        }
        assert!(force(1.0, 0.48) > 1.1 * force(1.0, 0.32));
    }

    #[test]
    fn the_worst_is_the_lower_of_the_two_and_overlapping_blocks_have_no_value() {
        let layout = |blocks| Layout { ex: 0.5, ey: 0.9, blocks, ..REFERENCE };
        let force = |blocks| at(layout(blocks)).field.unwrap().values.force;
        let both = [force(Blocks::Repeated), force(Blocks::Mirrored)];
        assert_eq!(force(Blocks::Worst), both[0].min(both[1]));
        assert_ne!(both[0], both[1]);
        let close = Layout { ex: 1.2, blocks: Blocks::Mirrored, ..REFERENCE };
        assert_eq!(at(close).field, Err(NoField::Overlap));
        assert!(at(Layout { blocks: Blocks::Worst, ..close }).field.is_ok());
    }

    #[test]
    fn one_block_alone_is_said_to_go_by_relations_of_many_unless_the_mesh_has_its_own() {
        let one = Layout { blocks: Blocks::Single, method: MethodChoice::Derived, ..REFERENCE };
        let said = |mesh: &MeshType, layout: Layout| {
            let made = forecast(&layout, mesh, BranchRule::Published).unwrap();
            (made.warnings.contains(&Warning::OneBlock), made.field.unwrap().values.force)
        };
        let reference = catalogue::reference();
        let many = Layout { blocks: Blocks::Repeated, ..one };
        assert_eq!(said(&reference, one), (true, said(&reference, many).1));
        assert!(!said(&reference, many).0);
        // Nor does the paper know one block alone.
        let published = MethodChoice::Published;
        assert!(said(&reference, Layout { method: published, ..one }).0);
        // Relations of its own are taken, here those of repeated blocks at a tenth more of force.
        let mut method = shipped(Arranged::Repeated).clone();
        method.blocks = Blocks::Single;
        method.alpha.force *= 1.1;
        let methods =
            vec![KeptMethod::keep(shipped(Arranged::Repeated).clone()), KeptMethod::keep(method)];
        let quality = AdoptedQuality::TwoTests;
        let adopted = Adopted { quality, low: 24e3, middle: 27e3, high: 30e3, methods };
        let own = MeshType { adopted: Some(adopted), ratios: None, ..(*reference).clone() };
        let (told, force) = said(&own, one);
        assert!(!told && (force / said(&own, many).1 - 1.1).abs() < 1e-3, "{force}");
    }

    #[test]
    fn that_a_method_is_of_other_wires_is_told_where_it_is_so_and_nowhere_else() {
        use crate::mesh::adopted::NamedMethods;
        use crate::method::canned;
        let told = |mesh: &MeshType, method: MethodChoice| {
            let layout = Layout { method, ..REFERENCE };
            let found = forecast(&layout, mesh, BranchRule::Published).unwrap().warnings;
            found.contains(&Warning::OtherWires)
        };
        let own = (*catalogue::reference()).clone();
        assert!(!told(&own, MethodChoice::Derived));
        let mut other = MeshType { id: "other".into(), ..own.clone() };
        // The same wires are the same whatever they are called and wherever they come from.
        other.wire.as_mut().unwrap().source = "measured".into();
        assert!(!told(&other, MethodChoice::Derived));
        let last = other.wire.as_mut().unwrap().single.last_mut().unwrap();
        last.1 *= 1.01;
        assert!(told(&other, MethodChoice::Derived));
        // The published method is of no wires.
        assert!(!told(&other, MethodChoice::Published));
        // Nor is it told of a method of the mesh's own, or of a mesh without wires.
        let method = DerivedMethod { mesh: "other".into(), ..canned::method() };
        let methods = NamedMethods(vec![KeptMethod::keep(method)]);
        assert!(!told(&MeshType { methods, ..other.clone() }, MethodChoice::Derived));
        assert!(!told(&MeshType { wire: None, ..other }, MethodChoice::Derived));
    }

    #[test]
    fn the_curve_is_the_methods_own_and_ends_at_its_values() {
        let field = at(REFERENCE).field.unwrap();
        let end = field.end().unwrap();
        assert_eq!(end.curve(11).force[10], field.values.force);
        let half = end.deflection_at(0.5 * end.force).unwrap();
        assert!((end.force_at(half) - 0.5 * end.force).abs() < 1e-6 * end.force);
        let published =
            forecast(&REFERENCE, &catalogue::reference(), BranchRule::Published).unwrap();
        assert!(published.field.unwrap().envelope().is_none());
        let [low, high] = field.envelope().unwrap();
        for (k, x) in low.deflection.iter().enumerate().skip(1) {
            let on = end.force_at(*x);
            assert!(low.force[k] <= high.force[k] && low.force[k] < 1.1 * on + 500.0, "{x}");
        }
    }
}

//! What holds of the forecast whatever the layout and the mesh.

mod studies;

use meshcast::forecast::field::Branch;
use meshcast::forecast::{CURVE_POINTS, Field, Forecast, Values, forecast};
use meshcast::layout::{BranchRule, Layout, REFERENCE};
use meshcast::mesh::{MeshType, catalogue};
use meshcast::units::{Quantity, Units, parse, shortest};
use proptest::prelude::*;

/// Relative rounding of a chain of some twenty operations.
const ROUNDING: f64 = 1e-13;

fn rules() -> impl Strategy<Value = BranchRule> {
    prop_oneof![Just(BranchRule::Published), Just(BranchRule::Conservative)]
}

/// Layouts that make sense, in and out of the published ranges.
fn layouts() -> impl Strategy<Value = Layout> {
    (0.3..12.0_f64, 0.01..0.5_f64, 0.01..0.9_f64, -1.5..1.5_f64, -1.5..1.5_f64).prop_map(
        |(spacing, plate, punch, ex, ey)| Layout {
            plate: plate * spacing,
            spacing,
            punch: punch * spacing,
            ex: ex * spacing,
            ey: ey * spacing,
            ..REFERENCE
        },
    )
}

/// The same with the punch clear of the plates.
fn clear_layouts() -> impl Strategy<Value = Layout> {
    layouts()
        .prop_map(|mut layout| {
            // A smaller punch at the same place; a centre on a plate moves to the middle.
            let room = layout.distance_to_plate();
            if room == 0.0 {
                (layout.ex, layout.ey) = (0.0, 0.0);
            }
            layout.punch = layout.punch.min(1.9 * layout.distance_to_plate());
            layout
        })
        .prop_filter("a punch of at least a centimetre", |l| l.punch > 0.01)
}

/// The reference mesh of an unknown net: the relations hold for blocks of any size, and with a net those
/// below its opening pass through.
fn bare() -> MeshType {
    MeshType { wire: None, ..(*catalogue::reference()).clone() }
}

fn meshes() -> impl Strategy<Value = MeshType> {
    let ratios = proptest::option::of((0.05..1.5_f64, 0.3..2.0_f64));
    (1.0..500.0_f64, 0.05..2.0_f64, 1.5..6.0_f64, ratios).prop_map(
        |(kilonewton, deflection, panel, ratios)| {
            let mut mesh = bare();
            mesh.laboratory.force = kilonewton * 1000.0;
            mesh.laboratory.deflection = Some(deflection);
            mesh.laboratory.panel = panel;
            mesh.ratios = ratios.map(|(force, deflection)| meshcast::mesh::RatioRecord {
                force,
                deflection,
                source: "made up".into(),
            });
            mesh
        },
    )
}

fn of(layout: &Layout, mesh: &MeshType, rule: BranchRule) -> Forecast {
    forecast(layout, mesh, rule).expect("a sound layout and mesh have a forecast")
}

fn field_of(layout: &Layout, mesh: &MeshType, rule: BranchRule) -> Field {
    of(layout, mesh, rule).field.expect("a punch clear of the plates has a field value")
}

/// Where its curve ends: force and deflection at failure.
fn end_of(field: &Field) -> Values {
    field.end().expect("a mesh with a deflection has a curve")
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs())
}

/// Every number of a forecast.
fn numbers(f: &Forecast) -> Vec<f64> {
    let e = &f.eccentricity;
    let mut all = vec![
        f.laboratory.force,
        f.reference.force,
        e.force,
        e.deflection,
        e.force_sd,
        e.deflection_sd,
    ];
    all.extend(f.laboratory.deflection);
    all.extend(f.reference.deflection);
    if let Ok(field) = &f.field {
        all.push(field.values.force);
        if let Some(other) = field.other_branch {
            all.push(other.force);
            all.extend(other.deflection);
        }
    }
    if let Ok(Some(field)) = f.field.map(|field| field.end()) {
        let end = field.deflection;
        all.extend([end, field.tangent_at(end), field.secant_at(end)]);
        all.extend([field.energy_to(end), field.tangent_at(0.0)]);
        let curve = field.curve(CURVE_POINTS);
        all.extend(curve.deflection);
        all.extend(curve.force);
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, failure_persistence: None, ..ProptestConfig::default() })]

    /// Any five floating point numbers at all: a forecast of finite numbers, or an error.
    #[test]
    fn any_input_gives_finite_numbers_or_an_error(
        sizes in prop::array::uniform5(prop_oneof![prop::num::f64::ANY, -10.0..10.0_f64, 0.0..3.0_f64]),
        rule in rules(),
    ) {
        let [plate, spacing, punch, ex, ey] = sizes;
        let layout = Layout { plate, spacing, punch, ex, ey, ..REFERENCE };
        match forecast(&layout, &catalogue::reference(), rule) {
            Ok(f) => {
                prop_assert!(numbers(&f).iter().all(|v| v.is_finite()), "{f:?}");
                prop_assert!(f.warnings.iter().all(|w| !w.sentence(meshcast::units::Units::METRES).is_empty()));
            }
            Err(problems) => prop_assert!(!problems.is_empty()),
        }
    }

    #[test]
    fn values_are_positive_and_finite(layout in clear_layouts(), mesh in meshes(), rule in rules()) {
        let f = of(&layout, &mesh, rule);
        prop_assert!(numbers(&f).iter().all(|v| v.is_finite() && *v >= 0.0));
        let values = end_of(&f.field.unwrap());
        prop_assert!(values.force > 0.0 && values.deflection > 0.0);
    }

    #[test]
    fn the_forecast_is_even_in_both_offsets(layout in layouts(), rule in rules()) {
        let mesh = bare();
        let here = of(&layout, &mesh, rule);
        for (x, y) in [(-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let there = Layout { ex: x * layout.ex, ey: y * layout.ey, ..layout };
            prop_assert_eq!(here.field, of(&there, &mesh, rule).field);
        }
    }

    #[test]
    fn the_forecast_is_periodic_with_the_spacing(
        layout in clear_layouts(), rule in rules(), nx in -3..=3_i32, ny in -3..=3_i32,
    ) {
        let mesh = bare();
        let (ex, ey) = (
            layout.ex + f64::from(nx) * layout.spacing,
            layout.ey + f64::from(ny) * layout.spacing,
        );
        let there = Layout { ex, ey, ..layout };
        let (a, b) = (field_of(&layout, &mesh, rule), field_of(&there, &mesh, rule));
        // A shift by three spacings costs ex/L three bits; the map's slope is below 30 a spacing.
        prop_assert!(close(a.values.force, b.values.force, 1e-12));
        prop_assert!(close(end_of(&a).deflection, end_of(&b).deflection, 1e-12));
    }

    #[test]
    fn the_curve_rises_from_zero_to_the_failure_point(layout in clear_layouts(), mesh in meshes()) {
        let field = end_of(&field_of(&layout, &mesh, BranchRule::Published));
        let curve = field.curve(CURVE_POINTS);
        prop_assert_eq!((curve.deflection.len(), curve.force.len()), (201, 201));
        prop_assert_eq!((curve.deflection[0], curve.force[0]), (0.0, 0.0));
        prop_assert_eq!(curve.deflection[200], field.deflection);
        prop_assert_eq!(curve.force[200], field.force);
        prop_assert!(curve.deflection.windows(2).all(|w| w[0] < w[1]));
        prop_assert!(curve.force.windows(2).all(|w| w[0] < w[1]));
    }

    #[test]
    fn deflection_and_force_invert_each_other(
        layout in clear_layouts(), mesh in meshes(), part in 0.0..=1.0_f64,
    ) {
        let field = end_of(&field_of(&layout, &mesh, BranchRule::Published));
        let deflection = part * field.deflection;
        let back = field.deflection_at(field.force_at(deflection)).unwrap();
        // Rounding over the least slope of the curve, 0.035.
        prop_assert!((back - deflection).abs() <= 1e-13 * field.deflection);
        let force = part * field.force;
        let there = field.force_at(field.deflection_at(force).unwrap());
        prop_assert!((there - force).abs() <= ROUNDING * field.force);
        prop_assert_eq!(field.deflection_at(1.001 * field.force), None);
        prop_assert_eq!(field.deflection_at(-1.0), None);
    }

    /// The tangent is the slope and the energy the area of the curve, found by finite differences.
    #[test]
    fn stiffness_and_energy_belong_to_the_curve(layout in clear_layouts(), part in 0.05..0.95_f64) {
        let field = end_of(&field_of(&layout, &bare(), BranchRule::Published));
        let (at, step) = (part * field.deflection, 1e-4 * field.deflection);
        let (before, after) = (field.force_at(at - step), field.force_at(at + step));
        // A central difference of a cubic is off by a h^2 = 1.3e-8 of F_a/delta_a; the slope is at
        // least 0.035 of it.
        prop_assert!(close(field.tangent_at(at), (after - before) / (2.0 * step), 1e-6));
        let strip = field.energy_to(at + step) - field.energy_to(at - step);
        // Simpson's rule is exact for a cubic; the strip is a small difference of energies.
        let simpson = (before + 4.0 * field.force_at(at) + after) * step / 3.0;
        prop_assert!((strip - simpson).abs() <= 1e-12 * field.energy_to(field.deflection));
        prop_assert!(close(field.secant_at(at) * at, field.force_at(at), ROUNDING));
    }

    #[test]
    fn forces_scale_with_the_laboratory_force_and_deflections_with_its_deflection(
        layout in clear_layouts(), mesh in meshes(), rule in rules(),
        force in 0.1..10.0_f64, deflection in 0.1..10.0_f64,
    ) {
        let mut scaled = mesh.clone();
        scaled.laboratory.force *= force;
        scaled.laboratory.deflection = mesh.laboratory.deflection.map(|delta| delta * deflection);
        let (a, b) = (field_of(&layout, &mesh, rule), field_of(&layout, &scaled, rule));
        prop_assert!(close(a.values.force * force, b.values.force, ROUNDING));
        prop_assert!(close(end_of(&a).deflection * deflection, end_of(&b).deflection, ROUNDING));
        prop_assert_eq!((a.regime, a.branch), (b.regime, b.branch));
    }

    #[test]
    fn the_conservative_rule_never_gives_the_higher_force(
        layout in clear_layouts(), mesh in meshes(),
    ) {
        let published = field_of(&layout, &mesh, BranchRule::Published);
        let conservative = field_of(&layout, &mesh, BranchRule::Conservative);
        prop_assert!(conservative.values.force <= published.values.force);
        prop_assert_eq!(conservative.regime, published.regime);
    }

    /// Inside a branch a small step of any input makes a small step of the result.
    #[test]
    fn the_forecast_is_continuous_inside_a_branch(layout in clear_layouts(), which in 0..5_usize) {
        let mesh = bare();
        let mut beside = layout;
        let step = 1e-7 * layout.spacing;
        *[&mut beside.plate, &mut beside.spacing, &mut beside.punch, &mut beside.ex, &mut beside.ey]
            [which] += step;
        prop_assume!(Branch::published(&layout) == Branch::published(&beside));
        prop_assume!(!beside.punch_on_plate());
        let (a, b) = (
            field_of(&layout, &mesh, BranchRule::Published),
            field_of(&beside, &mesh, BranchRule::Published),
        );
        // D is at least a part in 1200 of L, so 1e-7 of L is below 1.2e-4 of it; F goes with D.
        prop_assert!(close(a.values.force, b.values.force, 2e-4), "{a:?} {b:?}");
        // delta's slopes in D/L, d/L, L and the offsets are all below 100.
        prop_assert!(close(end_of(&a).deflection, end_of(&b).deflection, 1e-5), "{a:?} {b:?}");
    }

    #[test]
    fn no_text_makes_the_reader_of_quantities_panic(text in ".{0,24}") {
        for quantity in [Quantity::Length, Quantity::Force, Quantity::Number] {
            if let Ok(value) = parse(&text, quantity, Units::METRES) {
                prop_assert!(value.is_finite());
            }
        }
    }

    #[test]
    fn lengths_written_in_any_unit_are_read_back(millimetres in 0..100_000_u32) {
        let metres = f64::from(millimetres) / 1000.0;
        for text in [
            format!("{millimetres}mm"),
            format!("{millimetres} mm"),
            format!("{} cm", shortest(f64::from(millimetres) / 10.0)),
            shortest(metres),
            format!("-{} m", shortest(metres)),
        ] {
            let read = parse(&text, Quantity::Length, Units::METRES).unwrap().abs();
            // Centimetres with a decimal are off by the rounding of one division.
            prop_assert!(close(read, metres, 3e-16), "{text}: {read}");
        }
    }
}

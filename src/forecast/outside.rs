//! How far forecasts hold outside the ranges of d, L and D: what checks of random layouts of the reference mesh
//! gave in wider ranges, by `meshcast held-out --widen`. Its tables stand in tests/bench/METHODS.md.

use super::Field;
use super::warning::{Outside, OutsideRecord, PLATE, PUNCH, SPACING, Warning};
use crate::layout::{Blocks, Layout};

/// Which layouts a record is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Like {
    Centred,
    Repeated,
    Mirrored,
}

/// By how much the ranges were wider.
const WIDER: f64 = 0.5;

/// Layouts, and check over forecast by the derived and by the published method, F and delta.
type Row = (Like, usize, [[f64; 2]; 2], [[f64; 2]; 2]);

/// Those of blocks with an offset are of few layouts.
#[rustfmt::skip]
const TABLE: [Row; 3] = [
    (Like::Centred, 28, [[0.971, 1.044], [1.002, 1.053]], [[0.808, 1.017], [0.901, 1.024]]),
    (Like::Repeated, 24, [[0.947, 1.067], [0.987, 1.081]], [[0.657, 1.145], [0.908, 1.061]]),
    (Like::Mirrored, 13, [[0.900, 1.058], [0.970, 1.068]], [[0.546, 0.908], [0.920, 1.055]]),
];

/// How far the size of a layout that is farthest out is beyond its range, as a part; 0 inside.
fn beyond(layout: &Layout) -> f64 {
    let sizes = [(PLATE, layout.plate), (SPACING, layout.spacing), (PUNCH, layout.punch)];
    let most = |(range, value): (super::warning::PublishedRange, f64)| {
        (value / range.max).max(range.min / value) - 1.0
    };
    sizes.into_iter().map(most).fold(0.0, f64::max)
}

/// What is known of a forecast of the reference mesh with these sizes.
fn known(layout: &Layout, field: &Field) -> Outside {
    let faces = match field.method {
        Some(method) => method.blocks == Blocks::Mirrored,
        // The published method has one value for all arrangements; the check is what differs.
        None => matches!(layout.blocks, Blocks::Mirrored | Blocks::Worst) && layout.can_face(),
    };
    let like = match layout.folded() {
        (0.0, 0.0) => Like::Centred,
        _ if faces => Like::Mirrored,
        _ => Like::Repeated,
    };
    let near = beyond(layout) <= WIDER + 1.0e-9;
    let row = TABLE.iter().find(|(of, ..)| near && *of == like);
    row.map_or(Outside::TooFar, |(_, layouts, derived, published)| {
        let [force, deflection] = if field.method.is_some() { *derived } else { *published };
        Outside::Measured(OutsideRecord { wider: WIDER, layouts: *layouts, force, deflection })
    })
}

/// Puts what is known into the first of the warnings of a size outside its range: it is of all three together.
pub(super) fn tell(layout: &Layout, field: &Field, warnings: &mut [Warning]) {
    let mut of_sizes = warnings.iter_mut().filter_map(|warning| match warning {
        Warning::Extrapolated { range, outside, .. } => {
            [PLATE, SPACING, PUNCH].contains(range).then_some(outside)
        }
        _ => None,
    });
    if let Some(outside) = of_sizes.next() {
        *outside = known(layout, field);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forecast::{Forecast, forecast};
    use crate::layout::{BranchRule, MethodChoice, REFERENCE};
    use crate::mesh::catalogue;
    use crate::units::Units;

    fn of(layout: Layout) -> Forecast {
        forecast(&layout, &catalogue::reference(), BranchRule::Published).unwrap()
    }

    fn outside(layout: Layout) -> Outside {
        let found = of(layout).warnings.into_iter().find_map(|w| match w {
            Warning::Extrapolated { outside, .. } => Some(outside),
            _ => None,
        });
        found.unwrap()
    }

    /// 10 and 90 % points of the force.
    fn force(layout: Layout) -> [f64; 2] {
        let Outside::Measured(record) = outside(layout) else { panic!("{layout:?}") };
        record.force
    }

    #[test]
    fn what_was_measured_is_told_by_method_arrangement_and_distance() {
        // 5.4 m is 20 % beyond 4.5 m, 6.3 m 40 %, 7 m 56 %; 0.12 m of plate are 33 % below 0.16 m, 0.1 m 60 %.
        let derived = Layout { method: MethodChoice::Derived, spacing: 5.4, ..REFERENCE };
        assert_eq!(force(derived), [0.971, 1.044]);
        assert_eq!(force(Layout { plate: 0.12, ..derived }), [0.971, 1.044]);
        assert_eq!(outside(Layout { plate: 0.1, ..derived }), Outside::TooFar);
        assert_eq!(force(Layout { method: MethodChoice::Published, ..derived }), [0.808, 1.017]);
        assert_eq!(outside(Layout { spacing: 7.0, ..derived }), Outside::TooFar);
        let off = Layout { ex: 0.9, spacing: 6.3, ..derived };
        assert_eq!(force(Layout { blocks: Blocks::Repeated, ..off }), [0.947, 1.067]);
        assert_eq!(force(Layout { blocks: Blocks::Mirrored, ..off }), [0.900, 1.058]);
        let paper = Layout { method: MethodChoice::Published, ..off };
        assert_eq!(force(Layout { blocks: Blocks::Paper, ..paper }), [0.657, 1.145]);
        assert_eq!(force(Layout { blocks: Blocks::Worst, ..paper }), [0.546, 0.908]);
    }

    #[test]
    fn the_warning_has_the_figures_short_and_long() {
        let layout = Layout { method: MethodChoice::Derived, spacing: 6.3, ..REFERENCE };
        let warnings = of(layout).warnings;
        assert_eq!(warnings[0].short(Units::METRES), "L > 4.5 m: check x0.97-1.04");
        assert!(
            warnings[0].sentence(Units::METRES).ends_with(
                "the values are extrapolated: in ranges wider by 50 % checks gave 0.97 to 1.04 of such a force and 1.00 to 1.05 of such a deflection (middle 80 % of 28 layouts)"
            ),
            "{}",
            warnings[0].sentence(Units::METRES)
        );
        let far = of(Layout { spacing: 9.0, ..layout }).warnings[0].clone();
        assert_eq!(far.short(Units::METRES), "L outside 1.25 to 4.5 m, far");
        assert!(
            far.sentence(Units::METRES).ends_with("extrapolated, farther than checks were made")
        );
        // Of another mesh nothing was measured.
        let mut other = (*catalogue::reference()).clone();
        other.id = "other".into();
        let warnings = forecast(&layout, &other, BranchRule::Published).unwrap().warnings;
        assert!(
            warnings.iter().any(|w| w.short(Units::METRES) == "L outside 1.25 to 4.5 m"),
            "{warnings:?}"
        );
    }
}

//! What a check has to say about itself.

use super::Checked;
use crate::forecast::NoField;
use crate::study::remark::{CheckRemark, NoForecast};

/// Stretch of the net beyond which it is said.
const MUCH_STRETCH: f64 = 0.02;

/// The remarks on a check, the heaviest first.
pub(super) fn of(c: &Checked) -> Vec<CheckRemark> {
    let mut list = c.ensemble.remarks(c.run_fidelity(), c.plan.phase.is_some());
    let without = match (c.forecast.values, c.forecast.outside) {
        _ if c.forecast.other_net => Some(NoForecast::OtherNet),
        (_, Some(why)) if c.test_is_anchored() || why == NoField::PassesThrough => {
            Some(NoForecast::Field(why))
        }
        (None, _) => Some(NoForecast::Laboratory),
        (Some(_), _) => None,
    };
    list.extend(without.map(CheckRemark::NoForecast));
    if c.test_is_anchored() && c.case.layout.facing_left_out() {
        list.push(CheckRemark::FacingLeftOut);
    }
    let stretch = c.stretch.map(|s| s - 1.0);
    if stretch.iter().any(|part| part.abs() > MUCH_STRETCH) {
        list.push(CheckRemark::Stretch(stretch));
    }
    list.push(CheckRemark::WireLaw(c.spec.wire.source.clone()));
    list.sort_by_key(|remark| std::cmp::Reverse(remark.weight()));
    list
}

//! What a check has to say about itself.

use super::Checked;
use crate::dem::Test;
use crate::study::remark::{CheckRemark, NoForecast};

/// Stretch of the net beyond which it is said.
const MUCH_STRETCH: f64 = 0.02;

/// The remarks on a check, the heaviest first.
pub(super) fn of(c: &Checked) -> Vec<CheckRemark> {
    let mut list = c.ensemble.remarks(c.fidelity, c.plan.phase.is_some());
    if c.forecast.values.is_none() {
        list.push(CheckRemark::NoForecast(match c.spec.test {
            _ if c.forecast.other_net => NoForecast::OtherNet,
            Test::Laboratory => NoForecast::Laboratory,
            Test::Anchored => NoForecast::Field,
        }));
    }
    let stretch = c.stretch.map(|s| s - 1.0);
    if stretch.iter().any(|part| part.abs() > MUCH_STRETCH) {
        list.push(CheckRemark::Stretch(stretch));
    }
    list.push(CheckRemark::WireLaw(c.spec.wire.source.clone()));
    list.sort_by_key(|remark| std::cmp::Reverse(remark.weight()));
    list
}

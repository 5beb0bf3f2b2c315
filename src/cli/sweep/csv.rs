//! A sweep as CSV: one line a point.

use super::{Swept, table};
use crate::study::sweep::SweepGrid;

/// The points of all layouts, with the checks where there are any; several layouts share one table with
/// the layout's name in front.
pub(crate) fn report(swept: &[Swept], grid: &SweepGrid, checks: bool, several: bool) -> String {
    let columns = table::table(grid, several).when(checks, table::with_checks);
    columns.csv(swept.iter().flat_map(table::rows), ";")
}

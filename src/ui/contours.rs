//! The deformed net as lines of equal height in the plan.

use crate::app::App;
use crate::show::grid::{DotGrid, DotPen, Pattern};
use crate::show::picture::Ink;

/// Heights at which lines are drawn, over the largest height.
pub(crate) const LEVELS: [f64; 4] = [0.2, 0.4, 0.6, 0.8];

/// Draws the lines of the result shown, if its shape is known. `reach` is the width of the plan in m.
pub(crate) fn draw(app: &App, reach: f64, grid: &mut DotGrid) {
    let Some(relief) = app.shown_check().and_then(|shown| shown.relief) else { return };
    if relief.highest <= 0.0 {
        return;
    }
    let pen = DotPen { ink: Ink::Check, pattern: Pattern::Solid, ascii: Some('.') };
    let (width, height) = grid.dots();
    // A few characters hold one line, not four.
    let levels = if width < 20 { &LEVELS[1..2] } else { &LEVELS[..] };
    // Which band of height a dot is in; a line runs where neighbours differ.
    let band = |x: i32, y: i32| {
        let px = (f64::from(x) + 0.5) / f64::from(width) * reach - reach / 2.0;
        let py = reach / 2.0 - (f64::from(y) + 0.5) / f64::from(height) * reach;
        let [half_x, half_y] = relief.sides.map(|side| side / 2.0);
        if app.layout().layout.grid.up.is_some() && (px.abs() > half_x || py.abs() > half_y) {
            return 0; // Beyond a cell that is not as wide as the plan.
        }
        let part = relief.at(px, py) / relief.highest;
        levels.iter().filter(|level| part > **level).count()
    };
    for y in 0..height {
        for x in 0..width {
            let here = band(x, y);
            if here > band(x + 1, y)
                || here > band(x - 1, y)
                || here > band(x, y + 1)
                || here > band(x, y - 1)
            {
                grid.dot(x, y, pen);
            }
        }
    }
}

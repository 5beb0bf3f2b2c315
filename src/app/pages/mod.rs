//! The texts of help and details, as lines; drawing them is the business of `ui`.
//!
//! - [`text`]: a page of text as it grows; [`help`], [`details`]: the two pages; [`check`]: the part of
//!   the details that speaks of the check.

mod check;
mod details;
mod help;
mod text;

pub(crate) use text::PageLine;

use super::{App, Mode};
use crate::forecast::warning::{PANEL, PLATE, PUNCH, SPACING};
use crate::units::Units;
use text::TextPage;

/// What the method is and where it ends.
fn method(page: &mut TextPage) {
    page.text("  Pol & Gabrieli (2021): the laboratory punch test of the mesh (F_l*, delta_l*), times alpha_F and alpha_delta, gives the field reference (F_a*, delta_a*); Eqs. A.1-A.2 take plate d, spacing L and punch D into account, the map of Fig. A1 the eccentricity; the master curve, Eq. 3, gives the whole curve.", 2);
    page.text(&format!("  Published ranges: d {}, L {}, D {}; laboratory panel {}. Outside them the numbers are extrapolated and marked.", PLATE.text(Units::METRES), SPACING.text(Units::METRES), PUNCH.text(Units::METRES), PANEL.text(Units::METRES)), 2);
    page.text("  It is the lowest of the arrangements computed, with a block in every cell of the mesh: where they repeat every anchor carries the whole force of its cell, where they face each other (p) the one between them carries more. It is not the answer for one block on a large mesh. Published relations are for anchors on a square grid; on others (P) the check answers alone.", 2);
    page.text("  As published, the relations return 0.93 F_a* and 0.98 delta_a* at their own reference point (27.1 kN and 0.635 m, not 29.1 kN and 0.65 m), and F jumps at D = d.", 2);
}

impl App {
    /// Columns of a page on this screen.
    pub(crate) fn page_width(&self) -> usize {
        usize::from(self.size().0).saturating_sub(4).clamp(20, 100)
    }

    /// The lines of the page that lies over the main screen.
    pub(crate) fn page_lines(&self) -> Vec<PageLine> {
        match self.mode() {
            Mode::Details { .. } => details::details(self, self.page_width()),
            _ => {
                let topic = help::Topic::of(self.screen.under_help(), self.empty());
                help::help(self.page_width(), topic)
            }
        }
    }
}

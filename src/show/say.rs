//! What a case gives, in a line for people.

use crate::case::CasePoint;
use crate::curve::Point;
use crate::forecast::field::Branch;
use crate::forecast::{Field, Strength};
use crate::layout::{Layout, Twists};
use crate::mesh::adopted::Adopted;
use crate::method::DerivedMethod;
use crate::study::checks::Difference;
use crate::study::checks::figures::Figures;
use crate::study::result::remade::Former;
use crate::units::{Units, force_text, length_entry, length_text, maybe_length_text, percent};
use crate::words::Choice;

/// The grid of a layout: `L 3.00 m`, `Lx 2.50 m, Ly 3.50 m, staggered, twists across`.
pub(crate) fn grid(layout: &Layout, unit: Units) -> String {
    let text = |metres: f64| format!("{} {}", length_entry(metres, unit), unit.symbol());
    let grid = &layout.grid;
    let mut said = match grid.up {
        None => format!("L {}", text(layout.spacing)),
        Some(up) => format!("Lx {}, Ly {}", text(layout.spacing), text(up)),
    };
    if grid.stagger {
        said.push_str(", staggered");
    }
    if grid.twists != Twists::default() {
        said.push_str(&format!(", twists {}", grid.twists.word()));
    }
    said
}

/// The spacings of a layout for a column: `3.00`, `2.50 x 3.50`, staggered ones with an `s` behind.
pub(crate) fn spacings(layout: &Layout, unit: Units) -> String {
    let up = layout.grid.up.map_or(String::new(), |up| format!(" x {}", length_entry(up, unit)));
    let stagger = if layout.grid.stagger { " s" } else { "" };
    format!("{}{up}{stagger}", length_entry(layout.spacing, unit))
}

/// Which anchor carries what where a block brings this force, N, without a check.
pub(crate) fn anchors(layout: &Layout, force: f64, unit: Units) -> (&'static str, String) {
    match layout.facing_bound() {
        Some(bound) => (
            "worst anchor",
            format!(
                "carries at most {} at failure (estimate), as blocks face each other across the anchors",
                force_text(bound * force, unit)
            ),
        ),
        None if layout.shares_unknown() => (
            "each anchor",
            format!(
                "carries {} at failure (estimate), the whole force of a block; a check knows its share",
                force_text(force, unit)
            ),
        ),
        None => (
            "each anchor",
            format!("carries {} at failure, the whole force of its cell", force_text(force, unit)),
        ),
    }
}

/// `F_a 27.1 kN, delta_a 0.635 m`.
pub(crate) fn values(v: Strength, unit: Units) -> String {
    format!("F_a {}, delta_a {}", force_text(v.force, unit), maybe_length_text(v.deflection, unit))
}

/// The same with the use, where a design force is set, and the deflection at that force without its
/// factor.
pub(crate) fn point(p: &CasePoint, unit: Units) -> String {
    let used = used(p.utilisation());
    let service = p.service_deflection();
    let service = service.map(|v| format!(", {} at F", length_text(v, unit)));
    values(p.values(), unit) + &used + &service.unwrap_or_default()
}

/// The same with the deflection at the design force without its factor, where it is reached; `place`
/// says so behind it.
pub(crate) fn point_at_load(p: &CasePoint, unit: Units, place: &str) -> String {
    let reached = p.service_deflection();
    let reached = reached.map(|v| format!(", {} {place}", length_text(v, unit)));
    values(p.values(), unit) + &used(p.utilisation()) + &reached.unwrap_or_default()
}

/// `, use 37.3 %`; nothing where no design force is set.
pub(crate) fn used(utilisation: Option<f64>) -> String {
    utilisation.map_or(String::new(), |u| format!(", use {} %", percent(u)))
}

/// What the law of an adopted mesh rests on, and how far those that fit differ.
pub(crate) fn adopted(a: &Adopted, unit: Units) -> String {
    format!(
        "{}: the reference panel (d 0.32, L 3, D 1 m) holds {}, 90 % of the laws that fit {} to {}",
        a.quality.word(),
        force_text(a.middle, unit),
        force_text(a.low, unit),
        force_text(a.high, unit)
    )
}

/// Which derived method gave a panel, what it rests on and how much single panels scatter about it.
pub(crate) fn derived(method: &DerivedMethod, field: &Field, unit: Units) -> String {
    let way = match field.branch {
        Branch::SmallPunch => "the block goes through the mesh",
        Branch::LargePunch => "the mesh tears at the anchors",
    };
    format!(
        "derived from {} simulations of {} blocks; {way}; 90 % of panels {}",
        method.runs.used,
        method.blocks.word(),
        band(field, unit)
    )
}

/// Between which 90 % of panels break, by the scatter of alignment and slack: `25.3 to 33.1 kN`.
pub(crate) fn band(field: &Field, unit: Units) -> String {
    let [low, high] = [-1.0, 1.0].map(|side| {
        let force = field.values.force * (1.0 + side * NINETY_PER_CENT * field.variation);
        unit.force_number(force, 3)
    });
    format!("{low} to {high} {}", unit.force_symbol())
}

/// Standard deviations to either side that hold 90 % of a normal distribution.
const NINETY_PER_CENT: f64 = 1.645;

/// What another method gives, and how far the one in use is from it.
pub(crate) fn beside(other: Strength, used: Strength, unit: Units) -> String {
    format!("{}; the method in use: {}", values(other, unit), apart(other, used))
}

/// The same for a narrow panel, with the difference of the force alone: `paper 27.1 kN 0.635 m (+2 %)`.
pub(crate) fn published_short(other: Strength, used: Strength, unit: Units) -> String {
    format!(
        "paper {} {} ({:+.0} %)",
        force_text(other.force, unit),
        maybe_length_text(other.deflection, unit),
        100.0 * (used.force / other.force - 1.0)
    )
}

/// `F +5 %, delta -3 %`.
fn apart(from: Strength, to: Strength) -> String {
    let deflection = from.deflection.zip(to.deflection).map(|(from, to)| to / from - 1.0);
    difference(&Difference { force: to.force / from.force - 1.0, deflection })
}

/// How far a check is from the forecast: `F +5 %, delta -3 %`.
pub(crate) fn difference(d: &Difference) -> String {
    let delta = d.deflection.map(|part| format!(", delta {:+.0} %", 100.0 * part));
    format!("F {:+.0} %{}", 100.0 * d.force, delta.unwrap_or_default())
}

/// What a kept check had before it was made again by another solver or sampling, and how far the result
/// has moved: `22.5 kN, 0.541 m by solver 1, sampling 1, quick; now F +1 %, delta +2 %`.
pub(crate) fn former(former: &Former, now: Option<Point>, unit: Units) -> String {
    let (old, was) = (&former.result, former.mean());
    let was = was.map_or("no break".into(), |p| {
        format!("{}, {}", force_text(p.force, unit), length_text(p.deflection, unit))
    });
    let moved = former.moved(now).map(|d| format!("; now {}", difference(&d)));
    let others = if former.same_inputs { "" } else { "; of other inputs or wires" };
    let fidelity = old.wanted.fidelity.word();
    format!("{was} by {}, {fidelity}{}{others}", old.by, moved.unwrap_or_default())
}

/// What a check says, with its difference from the forecast.
pub(crate) fn check(f: &Figures, unit: Units) -> String {
    let Some(mean) = f.mean else { return "no run broke a wire".into() };
    let error = f.error.map_or(String::new(), |e| format!(" +-{}", unit.force_number(e.force, 2)));
    let band = f.force_band.map_or(String::new(), |[low, high]| {
        format!(" ({}-{})", unit.force_number(low, 3), unit.force_number(high, 3))
    });
    let over = f.difference.map_or(String::new(), |d| format!("; {}", difference(&d)));
    let force = unit.force_number(mean.force, 3);
    let (reached, used) = (length_text(mean.deflection, unit), used(f.utilisation));
    format!("{force}{error} {}{band}, {reached}{used}{over}", unit.force_symbol())
}

//! The net's geometry and the tensile curves of its wires: what the discrete element check needs.

use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::problem::Problem;
use crate::units::shortest;
use serde::{Deserialize, Serialize};

/// Net and wire data of a mesh type; SI in memory and in files (m, kg, stresses in MPa in files).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WireData {
    /// Geometry of the net.
    pub net: NetGeometry,
    /// Tensile curve of the single wire, on its own area pi diameter^2/4.
    pub single: Vec<CurvePoint>,
    /// Tensile curve of the double twist, on twice that area.
    pub double_twist: Vec<CurvePoint>,
    /// Random slack of the bonds.
    #[serde(default)]
    pub distortion: Distortion,
    /// Where the data come from, and what was fitted to what.
    pub source: String,
}

/// Geometry and inertia of a double-twist hexagonal net.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NetGeometry {
    /// Distance between twist axes (mesh opening), along x, m; 0.005 to 1.
    pub opening: f64,
    /// Length of a double twist, along y, m; 0.005 to 1.
    pub twist: f64,
    /// Projection of a single wire on y, m; 0.005 to 1.
    pub projection: f64,
    /// Wire diameter, m; 0.0002 to 0.05.
    pub diameter: f64,
    /// Mass of one node, kg; 1e-6 to 10.
    pub node_mass: f64,
    /// Radius of a node's sphere in contact with the punch, m; 0 to 0.2.
    pub node_radius: f64,
}

/// One point of a tensile curve: engineering strain (-) and stress. `(strain, stress in MPa)` in files.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CurvePoint(
    /// Strain, above 0 and rising along the curve.
    pub f64,
    /// Stress, MPa, above 0 and not falling along the curve.
    pub f64,
);

/// Random slack of a bond: delta_l = lambda_u l0 T (Thoeni et al. 2013).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Distortion {
    /// lambda_u, 0 to 0.5: the largest slack as a part of the bond's length.
    pub lambda_u: f64,
    /// lambda_F, above 0 to 1: force level of the soft first point; 1 leaves the point out.
    pub lambda_f: f64,
    /// How T is drawn.
    pub slack: Slack,
}

impl Default for Distortion {
    fn default() -> Self {
        Distortion { lambda_u: 0.0, lambda_f: 1.0, slack: Slack::Fixed(1.0) }
    }
}

/// The factor T of the slack.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Slack {
    /// The same T, 0 to 1, for every bond: no scatter.
    Fixed(f64),
    /// T triangular on 0 to 1 with mode 0.5, drawn from (seed, bond).
    Triangular,
}

/// Density of steel, kg/m3.
const STEEL: f64 = 7850.0;
/// Radius of a node's sphere over the wire's diameter, that of the reference mesh: 10.8/2.7.
const NODE_RADIUS: f64 = 4.0;

impl NetGeometry {
    /// A double-twist net of this opening, length of a twist and wire, m. As in the reference mesh a single
    /// wire reaches as far along the twists as across them, and a node's sphere has four times the wire's
    /// diameter. A node has half the steel of its pair: a twist of two wires and two single wires.
    pub(crate) fn of_double_twist(opening: f64, twist: f64, diameter: f64) -> NetGeometry {
        let projection = 0.5 * opening;
        let wire = (0.5 * opening).hypot(projection);
        let area = std::f64::consts::PI * diameter * diameter / 4.0;
        NetGeometry {
            opening,
            twist,
            projection,
            diameter,
            node_mass: STEEL * area * (twist + wire),
            node_radius: NODE_RADIUS * diameter,
        }
    }
}

impl WireData {
    /// Print of the net and its wires; where they come from is none of it.
    pub(crate) fn print(&self) -> Fingerprint {
        let plain = WireData { source: String::new(), ..self.clone() };
        // Plain data of finite numbers can always be written.
        let text = serde_json::to_string(&plain).unwrap_or_default();
        Fingerprinter::new("wires").text(&text).finish()
    }

    /// Checks every value against its range.
    ///
    /// # Errors
    /// Every field that is wrong, by its path inside the wire data (`net.opening`).
    pub(crate) fn check(&self) -> Result<(), Vec<Problem>> {
        let mut problems = Vec::new();
        let mut range = |field: &str, value: f64, min: f64, max: f64, open: bool, unit: &str| {
            let above = if open { value > min } else { value >= min };
            if !(value.is_finite() && above && value <= max) {
                problems.push(
                    Problem::new(field, "the value is outside what makes sense")
                        .value(format!("{}{unit}", shortest(value)))
                        .allowed(format!(
                            "{} {}{unit}, up to {}{unit}",
                            if open { "above" } else { "from" },
                            shortest(min),
                            shortest(max)
                        )),
                );
            }
        };
        let n = &self.net;
        // Nets that hold blocks have openings of some centimetres; far finer ones are slips of a unit, and
        // would be nets of millions of nodes.
        range("net.opening", n.opening, 0.005, 1.0, false, " m");
        range("net.twist", n.twist, 0.005, 1.0, false, " m");
        range("net.projection", n.projection, 0.005, 1.0, false, " m");
        range("net.diameter", n.diameter, 0.0002, 0.05, false, " m");
        range("net.node_mass", n.node_mass, 1.0e-6, 10.0, false, " kg");
        range("net.node_radius", n.node_radius, 0.0, 0.2, false, " m");
        let d = &self.distortion;
        range("distortion.lambda_u", d.lambda_u, 0.0, 0.5, false, "");
        range("distortion.lambda_f", d.lambda_f, 0.0, 1.0, true, "");
        if let Slack::Fixed(t) = d.slack {
            range("distortion.slack", t, 0.0, 1.0, false, "");
        }
        problems.extend(Problem::of_text("source", &self.source));
        for (name, points) in [("single", &self.single), ("double_twist", &self.double_twist)] {
            problems.extend(check_curve(points).map(|p| p.under(name)));
        }
        if problems.is_empty() { Ok(()) } else { Err(problems) }
    }
}

/// The first thing wrong with a tensile curve.
fn check_curve(points: &[CurvePoint]) -> Option<Problem> {
    if points.is_empty() || points.len() > 32 {
        return Some(
            Problem::new("", format!("a curve of {} points cannot be used", points.len()))
                .allowed("1 to 32 points; (0, 0) is implied"),
        );
    }
    let (mut strain, mut stress) = (0.0, 0.0);
    for (k, p) in points.iter().enumerate() {
        let finite = p.0.is_finite() && p.1.is_finite();
        if !(finite && p.0 > strain && p.1 >= stress && p.1 > 0.0 && p.0 <= 2.0 && p.1 <= 1.0e4) {
            return Some(
                Problem::new(
                    format!("[{k}]"),
                    "strain must rise and stress must not fall from point to point",
                )
                .value(format!("({}, {} MPa)", p.0, p.1))
                .allowed("strain above the previous, up to 2; stress above 0, up to 10000 MPa"),
            );
        }
        (strain, stress) = (p.0, p.1);
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_net_has_mass_and_nodes_of_its_own() {
        let reference = NetGeometry::of_double_twist(0.08, 0.04, 0.0027);
        assert_eq!((reference.projection, reference.node_radius), (0.04, 0.0108));
        // By hand: 7850 x 5.7256e-6 x (0.04 + 0.056569) = 4.340 g; the published net has 3.9 g.
        assert!((reference.node_mass - 0.004_340).abs() < 2e-6, "{}", reference.node_mass);
        let fine = NetGeometry::of_double_twist(0.06, 0.03, 0.0022);
        assert!((fine.node_mass - 0.002_161).abs() < 2e-6 && fine.node_radius == 0.0088);
        // 10x12 of 3.9 mm: 7850 x 11.9459e-6 x (0.05 + 0.070711) = 11.320 g.
        let coarse = NetGeometry::of_double_twist(0.1, 0.05, 0.0039);
        assert!((coarse.node_mass - 0.011_320).abs() < 2e-6, "{}", coarse.node_mass);
        assert!((coarse.node_radius - 0.0156).abs() < 1e-12);
    }
}

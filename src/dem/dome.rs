//! The punch: a dome that rises into the net, frictionless, with penalty contact.
//!
//! Spherical cap of base diameter D and sphere radius 1.2 D, rim rounded by a torus of tube radius
//! 0.05 D tangent to the cap and vertical at r = D/2, where an upright cylinder goes on downwards. Other
//! shapes are the same with another cap: half a sphere of diameter D, and a cap so flat that its middle
//! stands 0.005 D above its rim.

use crate::layout::PunchShape;

/// Radius of the cap's sphere over D; that of the dome is the published one of the 1 m punch.
pub(crate) fn cap(shape: PunchShape) -> f64 {
    match shape {
        PunchShape::Dome => 1.2,
        PunchShape::Sphere => 0.5,
        PunchShape::Flat => 20.0,
    }
}
/// Least height of the cap's centre under the seam over D: half a sphere has none, and quotients stay finite.
const LEAST_HEIGHT: f64 = 1.0e-6;
/// Tube radius of the rim over D (an assumption: 50 mm for the 1 m punch).
pub(crate) const RIM: f64 = 0.05;
/// Normal contact stiffness of punch and node, N/m (Pol & Gabrieli 2021, section 2).
pub const CONTACT_STIFFNESS: f64 = 6.5e5;

/// The dome's shape and the radius of the nodes that it touches, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dome {
    /// Diameter D, m.
    pub diameter: f64,
    /// Radius of the cap's sphere, m.
    pub cap: f64,
    /// Tube radius of the rim, m.
    pub rim: f64,
    /// Radius of the rim's centre circle, m: D/2 less the tube radius.
    pub ring: f64,
    /// Height of the cap's centre below the apex, m (the cap radius).
    pub cap_depth: f64,
    /// Height of the rim's centre circle below the apex, m.
    pub ring_depth: f64,
    /// Radius over height above the cap's centre at the seam of cap and rim.
    pub seam: f64,
    /// Radius of a node's sphere, m.
    pub node: f64,
    /// Contact stiffness, N/m.
    pub stiffness: f64,
}

impl Dome {
    /// The punch of diameter `diameter` against nodes of radius `node` (both m).
    pub(crate) fn new(shape: PunchShape, diameter: f64, node: f64) -> Dome {
        let (cap, rim) = (cap(shape) * diameter, RIM * diameter);
        let ring = diameter / 2.0 - rim;
        // The rim touches the cap from inside: its centre circle lies on a sphere of radius cap - rim.
        let height = ((cap - rim) * (cap - rim) - ring * ring).max(0.0).sqrt();
        let height = height.max(LEAST_HEIGHT * diameter);
        Dome {
            diameter,
            cap,
            rim,
            ring,
            cap_depth: cap,
            ring_depth: cap - height,
            seam: ring / height,
            node,
            stiffness: CONTACT_STIFFNESS,
        }
    }

    /// Distance from the axis from which on no node's centre touches the dome, m.
    pub(crate) fn reach(&self) -> f64 {
        self.diameter / 2.0 + self.node
    }

    /// Height of the apex over the flat net's nodes at punch displacement `delta`, m: at 0 it
    /// touches the nodes' spheres.
    pub(crate) fn apex(&self, delta: f64) -> f64 {
        delta - self.node
    }

    /// How deep a node at `p` (from the dome's axis in x and y, from the flat net in z, m) is in the
    /// dome at displacement `delta`, m, negative outside; and the outward normal there.
    pub fn depth(&self, p: [f64; 3], delta: f64) -> (f64, [f64; 3]) {
        let apex = self.apex(delta);
        let r = (p[0] * p[0] + p[1] * p[1]).sqrt();
        let over_cap_centre = p[2] - (apex - self.cap_depth);
        let on_cap = over_cap_centre > 0.0 && r <= self.seam * over_cap_centre;
        // Both are the distance to a circle about the axis: the cap's has radius 0.
        let (circle, depth, radius) = if on_cap {
            (0.0, self.cap_depth, self.cap)
        } else {
            (self.ring, self.ring_depth, self.rim)
        };
        let out = r - circle;
        let up = (p[2] - (apex - depth)).max(0.0);
        let distance = (out * out + up * up).sqrt();
        let normal = if distance > 0.0 && r > 0.0 {
            [out / distance * p[0] / r, out / distance * p[1] / r, up / distance]
        } else {
            [0.0, 0.0, 1.0]
        };
        (radius + self.node - distance, normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_seam_of_the_metre_dome_stands_where_published() {
        let d = Dome::new(PunchShape::Dome, 1.0, 0.0108);
        // Tangent point of cap and rim: r = 0.4696 D, as the YADE scenes have it.
        let r = d.cap * d.seam / (1.0 + d.seam * d.seam).sqrt();
        assert!((r - 0.4696).abs() < 5e-5, "{r}");
    }

    #[test]
    fn a_sphere_and_a_flat_punch_are_met_where_worked_by_hand() {
        let sphere = Dome::new(PunchShape::Sphere, 1.0, 0.0108);
        // On the sphere of radius 0.5 about a point 0.5 m below the apex, up to just above its equator; then
        // beside an upright cylinder.
        for angle in [0.0f64, 0.7, 1.5, 1.57] {
            let out = sphere.cap + sphere.node;
            let place = [0.0, out * angle.sin(), sphere.apex(0.2) - 0.5 + out * angle.cos()];
            assert!(sphere.depth(place, 0.2).0.abs() < 1e-5, "{angle}");
        }
        let (depth, normal) = sphere.depth([0.505, 0.0, -0.6], 0.0);
        assert!((depth - 0.0058).abs() < 1e-6 && normal[0] > 0.999_999);
        // 20 - sqrt(400 - 0.2025) = 0.0051 m lower where the rim begins, at most.
        let flat = Dome::new(PunchShape::Flat, 1.0, 0.0108);
        let at = |r: f64| flat.depth([r, 0.0, flat.apex(0.0) + flat.node], 0.0).0;
        assert!(at(0.0).abs() < 1e-12 && at(0.44) > -0.0052 && at(0.44) < -0.0045, "{}", at(0.44));
        assert!(at(0.5) < -0.02, "the rim is round");
    }

    #[test]
    fn depth_is_zero_on_the_surface_and_continuous_over_the_seam() {
        let d = Dome::new(PunchShape::Dome, 1.0, 0.0108);
        assert!(d.depth([0.0, 0.0, 0.0], 0.0).0.abs() < 1e-15);
        assert!((d.depth([0.0, 0.0, 0.0], 0.01).0 - 0.01).abs() < 1e-15);
        let seam = d.seam.atan();
        let at = |angle: f64| {
            let reach = d.cap + d.node;
            [reach * angle.sin(), 0.0, d.apex(0.3) - d.cap_depth + reach * angle.cos()]
        };
        for angle in [0.1, seam - 1e-9, seam + 1e-9] {
            let (depth, normal) = d.depth(at(angle), 0.3);
            assert!(depth.abs() < 1e-9, "{depth}");
            assert!(
                (normal[0] - angle.sin()).abs() < 1e-6 && (normal[2] - angle.cos()).abs() < 1e-6
            );
        }
        // Beside the cylinder below the rim: pushed outwards only.
        let (depth, normal) = d.depth([0.0, 0.505, -0.5], 0.3);
        assert!(
            (depth - 0.0058).abs() < 1e-12 && normal[2] == 0.0 && (normal[1] - 1.0).abs() < 1e-12
        );
    }
}

//! Wire laws with a name: the ones that solvers are compared with, and the hand-made start of a
//! calibration. All of them are the published single-wire curve of the 2.7 mm mesh under the two
//! scalings of [`scaled`].

use super::catalogue;
use super::wire::{CurvePoint, Distortion, NetGeometry, Slack, WireData};

/// Published tensile curve of the single wire of the 2.7 mm mesh: strain, stress in MPa.
pub(crate) const SINGLE_WIRE: [CurvePoint; 7] = [
    CurvePoint(0.001_923_1, 250.0),
    CurvePoint(0.0192, 321.95),
    CurvePoint(0.05, 382.92),
    CurvePoint(0.15, 512.19),
    CurvePoint(0.25, 558.54),
    CurvePoint(0.30, 565.85),
    CurvePoint(0.35, 565.85),
];

/// A curve under a *strain factor* s and a *stress factor* q: stresses times q, the elastic strain
/// times q (so that the modulus stays), strains past the elastic point measured from it times s.
///
/// The elastic strain that the others are measured from is the unscaled one.
pub(crate) fn scaled(points: &[CurvePoint], strain: f64, stress: f64) -> Vec<CurvePoint> {
    let first = points.first().map_or(0.0, |p| p.0);
    points
        .iter()
        .enumerate()
        .map(|(k, p)| {
            let e = if k == 0 { stress * first } else { first + strain * (p.0 - first) };
            CurvePoint(e, stress * p.1)
        })
        .collect()
}

/// The bench law: scatter-free, made to compare solvers and not meshes. Single wire with strains
/// x 0.4, double twist with strains x 0.16, stresses as published, slack 0.03 l0 for every bond.
pub fn bench() -> WireData {
    WireData {
        net: reference_net(),
        single: scaled(&SINGLE_WIRE, 0.4, 1.0),
        double_twist: scaled(&SINGLE_WIRE, 0.16, 1.0),
        distortion: Distortion { lambda_u: 0.03, lambda_f: 1.0, slack: Slack::Fixed(1.0) },
        source: "Bench law: made to compare solvers, not meshes".into(),
    }
}

/// The law of the published YADE curves: single wire as published, double twist of the same
/// stresses with the strains past the elastic one x 0.4 (measured whole), no slack.
pub fn yade() -> WireData {
    let elastic = 0.001_923_076_9;
    let with = |strains: [f64; 6]| -> Vec<CurvePoint> {
        let stress = SINGLE_WIRE.iter().map(|p| p.1);
        std::iter::once(elastic).chain(strains).zip(stress).map(|(e, s)| CurvePoint(e, s)).collect()
    };
    WireData {
        net: reference_net(),
        single: with([0.0192, 0.05, 0.15, 0.25, 0.3, 0.35]),
        double_twist: with([0.00768, 0.02, 0.06, 0.1, 0.12, 0.14]),
        distortion: Distortion::default(),
        source: "Law of the comparison runs made with YADE 2023.02a; no slack".into(),
    }
}

/// The reference law: a start of calibrations made by hand, with the laboratory test, the master
/// curve and the anchored reference in view. Single wire with strains x 0.4; double twist with
/// strains x 0.16 and stresses x 0.67; random slack up to 0.03 l0.
pub fn reference() -> WireData {
    WireData {
        net: reference_net(),
        single: scaled(&SINGLE_WIRE, 0.4, 1.0),
        double_twist: scaled(&SINGLE_WIRE, 0.16, 0.67),
        distortion: Distortion { lambda_u: 0.03, lambda_f: 1.0, slack: Slack::Triangular },
        source: "Reference law: chosen by hand with the laboratory test, the master curve and the \
                 anchored reference in view (fitted, not predicted)"
            .into(),
    }
}

/// A named law: `bench`, `yade` or `reference`.
pub(crate) fn find(name: &str) -> Option<WireData> {
    match name {
        "bench" => Some(bench()),
        "yade" => Some(yade()),
        "reference" => Some(reference()),
        _ => None,
    }
}

/// Geometry of the reference mesh.
fn reference_net() -> NetGeometry {
    catalogue::reference().wire.as_ref().map_or(
        // The catalogue's reference mesh has wire data; a test holds it. These are its values.
        NetGeometry {
            opening: 0.08,
            twist: 0.04,
            projection: 0.04,
            diameter: 0.0027,
            node_mass: 0.0039,
            node_radius: 0.0108,
        },
        |w| w.net,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_named_laws_are_sound_and_the_yade_law_is_the_published_one() {
        for name in ["bench", "yade", "reference"] {
            assert_eq!(find(name).unwrap().check(), Ok(()), "{name}");
        }
        let y = yade();
        assert_eq!(y.single[3], CurvePoint(0.15, 512.19));
        assert_eq!(y.double_twist[6], CurvePoint(0.14, 565.85));
    }

    #[test]
    fn scaling_keeps_the_modulus_and_moves_the_rest_as_defined() {
        let s = scaled(&SINGLE_WIRE, 0.16, 0.67);
        assert!((s[0].1 / s[0].0 - 250.0 / 0.001_923_1).abs() < 1e-6);
        // Definition by hand for the last point: 0.0019231 + 0.16 (0.35 - 0.0019231).
        assert!((s[6].0 - 0.057_615_4).abs() < 1e-7 && (s[6].1 - 379.1195).abs() < 1e-9);
    }
}

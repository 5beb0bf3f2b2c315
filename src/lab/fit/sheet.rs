//! What is typed of a mesh, as flags or in a form, and the data that it makes.

use super::curve::LabCurve;
use super::data::{FirstBond, MeshData, PunchData, TensileData};
use crate::dem::tensile::Pull;
use crate::mesh::wire::NetGeometry;
use crate::mesh::{LARGEST_DEFLECTION, LARGEST_FORCE, STANDARD_PANEL, STANDARD_PUNCH};
use crate::problem::Problem;
use crate::units::{shortest, to_kn};

/// What is typed; SI. Problems name what is wrong by its flag, such as `--force`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sheet {
    /// Force at failure of the punch test; that of the curve where missing.
    pub(crate) force: Option<f64>,
    /// Deflection there; likewise, and not known without a curve.
    pub(crate) deflection: Option<f64>,
    /// Side of its panel.
    pub(crate) panel: f64,
    /// Diameter of its punch.
    pub(crate) punch: f64,
    /// Its stiffness at 75 % of the force.
    pub(crate) stiffness: Option<f64>,
    /// Its whole curve.
    pub(crate) curve: Option<LabCurve>,
    /// Other punch tests: force, deflection, panel, punch.
    pub(crate) another: Vec<[f64; 4]>,
    /// Strength of the net along and across its twists, N/m.
    pub(crate) strengths: [Option<f64>; 2],
    /// Width and length of the piece that was pulled.
    pub(crate) piece: [f64; 2],
    /// Strength of the wire, MPa.
    pub(crate) wire_strength: Option<f64>,
    /// Elongation of the wire at rupture.
    pub(crate) wire_elongation: Option<f64>,
    /// Which bond breaks first.
    pub(crate) first: Option<FirstBond>,
    /// Opening of the mesh, length of a twist, diameter of the wire.
    pub(crate) net: [Option<f64>; 3],
}

impl Default for Sheet {
    fn default() -> Self {
        Sheet {
            force: None,
            deflection: None,
            panel: STANDARD_PANEL,
            punch: STANDARD_PUNCH,
            stiffness: None,
            curve: None,
            another: Vec::new(),
            strengths: [None; 2],
            piece: [1.0; 2],
            wire_strength: None,
            wire_elongation: None,
            first: None,
            net: [None; 3],
        }
    }
}

impl Sheet {
    /// The data; the net is `start` where nothing is said of it.
    ///
    /// # Errors
    /// All that is wrong.
    pub(crate) fn data(self, start: &NetGeometry) -> Result<MeshData, Vec<Problem>> {
        let mut problems = self.ranges();
        let net = self.net(start);
        let end = self.curve.as_ref().map(LabCurve::end);
        let force = self.force.or(end.map(|p| p.force));
        if force.is_none() {
            problems.push(
                Problem::new("--force", "the force of the test is missing")
                    .advice("give it, or its --curve"),
            );
        }
        let deflection = self.deflection.or(end.map(|p| p.deflection));
        let test = |force, deflection, panel, punch| PunchData {
            panel,
            punch,
            force,
            deflection,
            stiffness: None,
            curve: None,
        };
        let first = test(force.unwrap_or(f64::NAN), deflection, self.panel, self.punch);
        let mut punches = vec![PunchData { stiffness: self.stiffness, curve: self.curve, ..first }];
        let others = self.another.iter();
        punches.extend(others.map(|[force, deflection, panel, punch]| {
            test(*force, Some(*deflection), *panel, *punch)
        }));
        let pulls = [Pull::Along, Pull::Across].into_iter().zip(self.strengths);
        let tensile = pulls
            .filter_map(|(pull, s)| Some(TensileData { sides: self.piece, pull, strength: s? }));
        let data = MeshData {
            net,
            punches,
            tensile: tensile.collect(),
            wire_strength: self.wire_strength,
            wire_elongation: self.wire_elongation,
            first: self.first,
        };
        problems.extend(data.problems());
        if problems.is_empty() { Ok(data) } else { Err(problems) }
    }

    /// What is outside of what any test or net has.
    fn ranges(&self) -> Vec<Problem> {
        let mut found = Vec::new();
        let mut range = |field: &str, value: Option<f64>, [least, most]: [f64; 2], unit: &str| {
            if let Some(value) = value.filter(|v| !(least..=most).contains(v)) {
                found.push(
                    Problem::new(field, "no punch test and no mesh has such a value")
                        .value(format!("{} {unit}", shortest(value)))
                        .allowed(format!("{} to {} {unit}", shortest(least), shortest(most))),
                );
            }
        };
        range("--force", self.force.map(to_kn), [0.5, to_kn(LARGEST_FORCE)], "kN");
        range("--deflection", self.deflection, [0.005, LARGEST_DEFLECTION], "m");
        range("--panel", Some(self.panel), [0.2, 20.0], "m");
        range("--punch", Some(self.punch), [0.05, 10.0], "m");
        let [opening, twist, diameter] = self.net;
        range("--opening", opening, [0.02, 0.3], "m");
        range("--twist", twist, [0.005, 0.3], "m");
        range("--diameter", diameter, [0.0005, 0.01], "m");
        found
    }

    fn net(&self, start: &NetGeometry) -> NetGeometry {
        let [opening, twist, diameter] = self.net;
        if self.net == [None; 3] {
            return *start;
        }
        let opening = opening.unwrap_or(start.opening);
        let twist = twist.unwrap_or(0.5 * opening);
        NetGeometry::of_double_twist(opening, twist, diameter.unwrap_or(start.diameter))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::laws;

    fn said(sheet: Sheet) -> String {
        let found = sheet.data(&laws::reference().net).unwrap_err();
        found.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn all_that_is_wrong_is_said_by_field_value_unit_and_range() {
        let all = said(Sheet {
            force: Some(7.33e7),
            deflection: Some(0.6),
            punch: 4.0,
            net: [Some(80.0), None, Some(2.7)],
            stiffness: Some(5.0),
            ..Sheet::default()
        });
        for part in [
            "--force = 73300.0 kN",
            "0.5 to 10000.0 kN",
            "--opening = 80.0 m",
            "0.02 to 0.3 m",
            "--diameter = 2.7 m",
            "--punch = 4.0 m",
            "below the panel of 3.0 m",
            "--k75",
        ] {
            assert!(all.contains(part), "{part}: {all}");
        }
        assert!(said(Sheet::default()).contains("--force: the force of the test is missing"));
    }

    #[test]
    fn a_net_of_its_own_has_half_of_its_opening_as_twist_where_nothing_is_said() {
        let sheet = |net| Sheet { force: Some(40_000.0), net, ..Sheet::default() };
        let start = laws::reference().net;
        let net = |net| sheet(net).data(&start).unwrap().net;
        assert_eq!(net([None; 3]), start);
        let fine = net([Some(0.06), None, Some(0.0022)]);
        assert_eq!(fine, NetGeometry::of_double_twist(0.06, 0.03, 0.0022));
        assert_eq!(net([None, Some(0.05), None]).twist, 0.05);
    }
}

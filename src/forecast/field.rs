//! Step 2 of the method: the field values F_a, delta_a of a layout, Eqs. A.1-A.2 of Pol & Gabrieli
//! (2021, appendix), exactly as published, for a centred punch.

use super::Strength;
use crate::layout::{BranchRule, Layout};

/// D*, m: punch diameter of the field reference.
pub(crate) const PUNCH_REFERENCE: f64 = 1.0;
/// d*, m: plate side of the field reference.
pub(crate) const PLATE_REFERENCE: f64 = 0.32;
/// L*, m: spacing of the field reference.
pub(crate) const SPACING_REFERENCE: f64 = 3.0;

/// Punch diameter at which the two branches of Eq. A.1 cross, for every plate, m: 0.94/2.41 = 0.390.
pub(crate) const BRANCH_CROSSING: f64 = 0.94 / (2.47 - 0.06);
/// Part of d within which D is near the branch change.
pub(crate) const BRANCH_NEARNESS: f64 = 0.25;

/// A branch of Eqs. A.1-A.2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// First line: D at most d.
    SmallPunch,
    /// Second line: D above d.
    LargePunch,
}

impl Branch {
    /// The branch that the equations name for a layout: by D <= d.
    pub fn published(layout: &Layout) -> Branch {
        if layout.punch <= layout.plate { Branch::SmallPunch } else { Branch::LargePunch }
    }

    /// The branch a rule takes. The conservative one has the lower F; the branches differ in F by the
    /// factor of D alone, so it is the small-punch branch below the crossing.
    pub(crate) fn by_rule(layout: &Layout, rule: BranchRule) -> Branch {
        match rule {
            BranchRule::Published => Branch::published(layout),
            BranchRule::Conservative => {
                let force = |branch| punch_factor_force(layout.punch, branch);
                if force(Branch::SmallPunch) <= force(Branch::LargePunch) {
                    Branch::SmallPunch
                } else {
                    Branch::LargePunch
                }
            }
        }
    }

    /// The other branch.
    pub(crate) fn other(self) -> Branch {
        match self {
            Branch::SmallPunch => Branch::LargePunch,
            Branch::LargePunch => Branch::SmallPunch,
        }
    }

    /// The word in output: `small_punch` or `large_punch`.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Branch::SmallPunch => "small_punch",
            Branch::LargePunch => "large_punch",
        }
    }
}

/// Whether the layout is near the change of branch, where F jumps: D between d and the crossing at
/// 0.39 m, or within 25 % of d.
pub(crate) fn near_branch_change(layout: &Layout) -> bool {
    let (d, punch) = (layout.plate, layout.punch);
    let between = punch >= d.min(BRANCH_CROSSING) && punch <= d.max(BRANCH_CROSSING);
    // The ends of the band belong to it, to a nanometre: 0.40 - 0.32 is not quite 0.08.
    between || (punch - d).abs() <= BRANCH_NEARNESS * d + 1e-9
}

/// Factor of D in Eq. A.1.
fn punch_factor_force(punch: f64, branch: Branch) -> f64 {
    let r = punch / PUNCH_REFERENCE;
    match branch {
        Branch::SmallPunch => 2.47 * r,
        Branch::LargePunch => 0.06 * r + 0.94,
    }
}

/// Factor of D in Eq. A.2.
fn punch_factor_deflection(punch: f64, branch: Branch) -> f64 {
    let r = punch / PUNCH_REFERENCE;
    match branch {
        Branch::SmallPunch => 0.72 * r + 0.78,
        Branch::LargePunch => 0.03 * r * r - 0.16 * r + 1.13,
    }
}

/// Eq. A.1 over F_a*: the force at failure of a centred punch as a part of the reference force.
pub(crate) fn force_ratio(layout: &Layout, branch: Branch) -> f64 {
    punch_factor_force(layout.punch, branch)
        * (0.48 * layout.plate / PLATE_REFERENCE + 0.45)
        * (0.16 * layout.spacing / SPACING_REFERENCE + 0.84)
}

/// Eq. A.2 over delta_a*: the deflection at failure of a centred punch as a part of the reference one.
pub(crate) fn deflection_ratio(layout: &Layout, branch: Branch) -> f64 {
    0.98 * layout.spacing / SPACING_REFERENCE
        * punch_factor_deflection(layout.punch, branch)
        * (0.02 * layout.plate / PLATE_REFERENCE + 0.98)
}

/// Eqs. A.1-A.2: F_a, delta_a of a centred punch from the field reference values, by one branch.
pub fn centred(layout: &Layout, branch: Branch, reference: Strength) -> Strength {
    Strength {
        force: force_ratio(layout, branch) * reference.force,
        deflection: reference.deflection.map(|delta| deflection_ratio(layout, branch) * delta),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;

    const STAR: Strength = Strength { force: 29_100.0, deflection: Some(0.648) };

    #[test]
    fn the_reference_point_returns_less_than_the_reference_values() {
        // By hand: 1.00 x 0.93 x 1.00 x 29.1 = 27.063 kN; 0.98 x 1.00 x 1.00 x 0.648 = 0.63504 m.
        let v = centred(&REFERENCE, Branch::LargePunch, STAR);
        assert!(
            (v.force - 27_063.0).abs() < 1e-6 && (v.deflection.unwrap() - 0.635_04).abs() < 1e-9
        );
    }

    #[test]
    fn the_small_punch_branch_worked_by_hand() {
        // d = 0.32, L = 2.5, D = 0.2: 2.47 x 0.2 x 0.93 x (0.16 x 0.833333 + 0.84) = 0.447169...
        let layout =
            Layout { plate: 0.32, spacing: 2.5, punch: 0.2, ex: 0.0, ey: 0.0, ..REFERENCE };
        let v = centred(&layout, Branch::published(&layout), STAR);
        assert!((v.force - 29_100.0 * 0.494 * 0.93 * (0.4 / 3.0 + 0.84)).abs() < 1e-6);
        // 0.98 x 0.833333 x (0.144 + 0.78) x 1.0 x 0.648 = 0.488981 m
        assert!((v.deflection.unwrap() - 0.488_980_8).abs() < 1e-9);
    }

    #[test]
    fn the_branches_cross_at_the_same_punch_for_every_plate() {
        for plate in [0.16, 0.25, 0.48] {
            let at = Layout { plate, punch: BRANCH_CROSSING, ..REFERENCE };
            let small = force_ratio(&at, Branch::SmallPunch);
            let large = force_ratio(&at, Branch::LargePunch);
            assert!((small / large - 1.0).abs() < 1e-12);
        }
        assert!((BRANCH_CROSSING - 0.390).abs() < 0.0005);
    }

    #[test]
    fn the_conservative_rule_takes_the_lower_force() {
        for (punch, plate) in [(0.1, 0.32), (0.33, 0.32), (0.38, 0.16), (0.40, 0.48), (0.45, 0.48)]
        {
            let layout = Layout { plate, punch, ..REFERENCE };
            let taken = Branch::by_rule(&layout, BranchRule::Conservative);
            assert!(force_ratio(&layout, taken) <= force_ratio(&layout, taken.other()));
        }
    }

    #[test]
    fn nearness_to_the_branch_change() {
        let near = |punch, plate| near_branch_change(&Layout { plate, punch, ..REFERENCE });
        assert!(near(0.32, 0.32) && near(0.39, 0.32) && near(0.25, 0.32) && near(0.40, 0.32));
        assert!(near(0.38, 0.16) && !near(0.41, 0.32) && !near(0.23, 0.32) && near(0.58, 0.48));
        assert!(!near(1.0, 0.32) && !near(0.1, 0.16));
    }
}

//! Eqs. 1-3 and A.1-A.2 at values worked by hand from the printed coefficients.

use meshcast::forecast::field::{Branch, centred};
use meshcast::forecast::{Strength, laboratory, master};
use meshcast::layout::{Layout, REFERENCE};

/// F_l*, delta_l* of the paper.
const LAB: Strength = Strength { force: 73_300.0, deflection: Some(0.60) };
/// F_a*, delta_a* with which Table 1 comes out as printed.
const STAR: Strength = Strength { force: 29_100.0, deflection: Some(0.648) };

/// Equal but for the rounding of a few operations.
fn same(values: Strength, kilonewton: f64, metre: f64) {
    let values = values.both().expect("both are known");
    let force = values.force / 1000.0;
    assert!((force / kilonewton - 1.0).abs() < 1e-12, "{force} kN, not {kilonewton}");
    assert!(
        (values.deflection / metre - 1.0).abs() < 1e-12,
        "{} m, not {metre}",
        values.deflection
    );
}

#[test]
fn equations_1_and_2_from_the_standard_panel() {
    // L = 4.5: 73.3 (0.89 + 0.165) = 73.3 x 1.055; 0.6 (0.15 + 1.275) = 0.6 x 1.425.
    same(laboratory::to_panel(LAB, 4.5), 77.3315, 0.855);
    // L = 3: the standard panel itself.
    same(laboratory::to_panel(LAB, 3.0), 73.3, 0.60);
    // L = 2.25: 73.3 (0.89 + 0.0825) = 73.3 x 0.9725; 0.6 (0.15 + 0.6375) = 0.6 x 0.7875.
    same(laboratory::to_panel(LAB, 2.25), 71.284_25, 0.4725);
}

#[test]
fn equations_1_and_2_back_to_the_standard_panel() {
    let tested = |kilonewton: f64, deflection| Strength {
        force: kilonewton * 1000.0,
        deflection: Some(deflection),
    };
    same(laboratory::from_panel(tested(77.3315, 0.855), 4.5), 73.3, 0.60);
    // L = 2.25 again: 48.625 / 0.9725 = 50; 0.315 / 0.7875 = 0.4.
    same(laboratory::from_panel(tested(48.625, 0.315), 2.25), 50.0, 0.4);
}

#[test]
fn equations_a1_and_a2_for_a_small_punch() {
    let layout = Layout { plate: 0.16, spacing: 3.0, punch: 0.16, ex: 0.0, ey: 0.0, ..REFERENCE };
    assert_eq!(Branch::published(&layout), Branch::SmallPunch, "D = d belongs to the small punch");
    // A.1: 2.47 x 0.16 = 0.3952; 0.48 x 0.5 + 0.45 = 0.69; 1: 0.272688 x 29.1 = 7.9352208.
    // A.2: 0.98 x (0.1152 + 0.78 = 0.8952) x (0.01 + 0.98 = 0.99) = 0.86852304 x 0.648.
    same(centred(&layout, Branch::SmallPunch, STAR), 7.935_220_8, 0.562_802_929_92);
    let wider = Layout { plate: 0.32, spacing: 4.5, punch: 0.2, ..layout };
    // A.1: 0.494 x 0.93 x (0.24 + 0.84 = 1.08) = 0.4961736 x 29.1 = 14.43865176.
    // A.2: 0.98 x 1.5 x (0.144 + 0.78 = 0.924) x 1 = 1.35828 x 0.648 = 0.88016544.
    same(centred(&wider, Branch::SmallPunch, STAR), 14.438_651_76, 0.880_165_44);
}

#[test]
fn equations_a1_and_a2_for_a_large_punch() {
    let layout = Layout { plate: 0.48, spacing: 4.5, punch: 2.0, ex: 0.0, ey: 0.0, ..REFERENCE };
    assert_eq!(Branch::published(&layout), Branch::LargePunch);
    // A.1: (0.12 + 0.94 = 1.06) x (0.72 + 0.45 = 1.17) x 1.08 = 1.339416 x 29.1 = 38.9770056.
    // A.2: 1.47 x (0.12 - 0.32 + 1.13 = 0.93) x (0.03 + 0.98 = 1.01) = 1.380771 x 0.648.
    same(centred(&layout, Branch::LargePunch, STAR), 38.977_005_6, 0.894_739_608);
    let reference = Layout { plate: 0.32, spacing: 3.0, punch: 1.0, ..layout };
    // The disclosed oddity: 0.93 x 29.1 and 0.98 x 0.648.
    same(centred(&reference, Branch::LargePunch, STAR), 27.063, 0.635_04);
}

#[test]
fn equation_3() {
    // x = 0.8: 1.312 x 0.512 - 0.385 x 0.64 + 0.073 x 0.8 = 0.671744 - 0.2464 + 0.0584.
    // x = 0.75: 0.5535 - 0.2165625 + 0.05475.
    for (x, y) in [(0.0, 0.0), (0.5, 0.104_25), (0.75, 0.391_687_5), (0.8, 0.483_744), (1.0, 1.0)] {
        assert!((master::force(x) - y).abs() < 1e-15, "{x}");
        assert!((master::deflection(y) - x).abs() < 1e-14, "{y}");
    }
    // Slope at 0.75: 3.936 x 0.5625 - 0.77 x 0.75 + 0.073 = 2.214 - 0.5775 + 0.073.
    assert!((master::slope(0.75) - 1.7095).abs() < 1e-14);
    // Area to 0.5: 0.328 x 0.0625 - 0.128333... x 0.125 + 0.0365 x 0.25.
    assert!((master::area(0.5) - (0.0205 - 0.385 / 24.0 + 0.009_125)).abs() < 1e-15);
}

//! One bond, loaded, unloaded, reloaded and broken, against YADE's.

use meshcast::dem::fast::kernel::follow;
use meshcast::dem::fast::state::{BondValues, Kind};
use meshcast::dem::law::{BondCurve, Law, Ramp};
use meshcast::mesh::laws;

/// Elongation, force and whether the bond holds, row by row; lengths in m, forces in N.
fn rows(text: &str) -> Vec<(f64, f64, bool)> {
    text.lines()
        .skip(1)
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |k: usize| cells[k].parse::<f64>().unwrap();
            (number(0), number(1), cells[4] == "1")
        })
        .collect()
}

fn cases() -> [(&'static str, f64, BondCurve); 2] {
    let law = Law::new(&laws::yade());
    let single = (0.04_f64 * 0.04 + 0.04 * 0.04).sqrt();
    [
        (include_str!("../data/single_bond_sw.csv"), single, law.single),
        (include_str!("../data/single_bond_dt.csv"), 0.04, law.twist),
    ]
}

#[test]
fn a_bond_follows_yades_to_a_millionth_of_its_peak() {
    for (text, length, curve) in cases() {
        let ramp = curve.full(0.0);
        let peak = curve.force[curve.force.len() - 1];
        let (mut top, mut seen) = (0.0_f64, 0);
        for (elongation, expected, holds) in rows(text) {
            let e = elongation / length;
            top = top.max(e);
            if holds {
                let force = curve.force(&ramp, top, e);
                // The file has nine digits; a millionth of the peak is the bound asked for.
                assert!(
                    (force - expected).abs() < 1.0e-6 * peak,
                    "{elongation}: {force} {expected}"
                );
                seen += 1;
            } else {
                // Found broken at the last point itself: nothing may hold a hair beyond it.
                assert!((e / curve.rupture() - 1.0).abs() < 1.0e-3);
                assert_eq!(curve.force(&ramp, top * 1.001, e), 0.0);
            }
        }
        assert!(seen > 2000, "{seen}");
    }
}

#[test]
fn the_fast_kernels_bond_keeps_its_bound_on_the_same_path() {
    for (text, length, curve) in cases() {
        // Its own unloading is softer on purpose; with the true slope the path is YADE's.
        let ramp: Ramp = curve.full(0.0);
        let kind = Kind::<f32>::new(&curve, curve.unloading, &BondValues { taut: length, ramp });
        let rows = rows(text);
        let lengths: Vec<f64> = rows.iter().map(|r| length + r.0).collect();
        let peak = curve.force[curve.force.len() - 1];
        // A length in single precision is known to 3e-8 of itself, by the inverse square root to 7e-7;
        // times the elastic slope over the peak (230 for the wire) that is 2e-4.
        for (force, row) in follow(&kind, 0.0, &lengths).iter().zip(&rows).filter(|(_, r)| r.2) {
            assert!((force - row.1).abs() < 3.0e-4 * peak, "{} {force} {}", row.0, row.1);
        }
    }
}

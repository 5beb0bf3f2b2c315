//! The wires of the reference mesh are those that a calibration makes today: whoever changes a solver so
//! that the fit moves must make them again (`meshcast calibrate --force 73.3 --deflection 0.6`).

use meshcast::dem::Flow;
use meshcast::lab::calibrate::{FitOptions, FitTarget, fit};
use meshcast::mesh::{catalogue, laws};

#[test]
fn the_catalogue_has_the_wires_of_a_calibration() {
    let mesh = catalogue::reference();
    let target = FitTarget { force: 73_300.0, deflection: 0.6, panel: 3.0, punch: 1.0 };
    let options = FitOptions { threads: 2, ..FitOptions::default() };
    let fit = fit(&laws::reference(), &target, &options, &|_, _| Flow::Continue).unwrap().unwrap();
    assert!(fit.found, "{:?}", fit.residual);
    // The file's curves have seven digits, its source four of each scale.
    let kept = mesh.wire.as_ref().unwrap();
    let said =
        format!("stresses x {:.4}, strains past the first point x {:.4}", fit.stress, fit.strain);
    assert!(kept.source.contains(&said), "{said}; {}", kept.source);
    for (ours, file) in
        [(&fit.wire.single, &kept.single), (&fit.wire.double_twist, &kept.double_twist)]
    {
        for (a, b) in ours.iter().zip(file) {
            assert!((a.0 / b.0 - 1.0).abs() < 1e-6 && (a.1 / b.1 - 1.0).abs() < 1e-6);
        }
    }
}

//! The ways in which a run ends, and what it tells then.

use crate::{small, spec};
use meshcast::dem::{Controls, Fidelity, Flow, Stop, Test, check};
use meshcast::mesh::laws;

fn quick() -> Controls {
    Controls { fidelity: Fidelity::Quick, ..Controls::default() }
}

#[test]
fn a_run_goes_on_after_the_first_break_as_far_as_it_is_told() {
    let spec = spec(Test::Anchored, 2.0, laws::reference());
    for after in [0.0, 0.03] {
        let controls = Controls { after_break: after, keep_net: true, ..quick() };
        let outcome = check(&spec, &controls, &mut |_| Flow::Continue).unwrap();
        assert_eq!(outcome.stop, Stop::AfterBreak);
        let first = outcome.first_break.unwrap();
        let last = *outcome.curve.deflection.last().unwrap();
        // The run ends with a whole window: up to about 3 mm further.
        assert!(last < first.deflection + after + 0.004, "{last} {first:?}");
        assert!(outcome.peak.force >= first.force && !outcome.breaks.is_empty());
        assert!(outcome.breaks.windows(2).all(|b| b[0].deflection <= b[1].deflection));
        assert!(outcome.k75 > 0.0 && outcome.energy > 0.0);
        assert!(outcome.curve.deflection.windows(2).all(|d| d[0] < d[1]));
        assert!(outcome.quality.energy_balance.abs() < 0.01, "{:?}", outcome.quality);
        assert!((outcome.quality.support_over_punch - 1.0).abs() < 0.2);
        let net = outcome.net.unwrap();
        assert_eq!(net.nodes.len(), outcome.cost.nodes);
        assert!(net.bonds.len() > outcome.cost.bonds * 9 / 10);
    }
}

#[test]
fn a_punch_as_small_as_the_opening_slips_through() {
    let mut s = spec(Test::Anchored, 2.0, laws::reference());
    (s.layout.punch, s.phase) = (0.04, [0.0, 0.5]);
    let outcome = check(&s, &quick(), &mut |_| Flow::Continue).unwrap();
    assert!(
        outcome.stop == Stop::Slipped || outcome.stop == Stop::DisplacementLimit,
        "{:?} {:?}",
        outcome.stop,
        outcome.peak
    );
    assert_eq!(outcome.first_break, None);
}

#[test]
fn limit_and_cancelling_end_a_run_with_what_it_has() {
    let spec = small(Test::Laboratory, laws::reference());
    let controls = Controls { limit: Some(0.1), ..quick() };
    let outcome = check(&spec, &controls, &mut |_| Flow::Continue).unwrap();
    assert_eq!((outcome.stop, outcome.first_break), (Stop::DisplacementLimit, None));
    let mut calls = 0;
    let outcome = check(&spec, &quick(), &mut |now| {
        calls += 1;
        assert!(now.deflection > 0.0 && now.limit == 0.6 * 1.2);
        if calls == 10 { Flow::Cancel } else { Flow::Continue }
    })
    .unwrap();
    assert_eq!((outcome.stop, outcome.curve.force.len()), (Stop::Cancelled, 10));
}

#[test]
fn senseless_controls_are_refused_with_their_field() {
    let spec = small(Test::Anchored, laws::bench());
    for (controls, field) in [
        (Controls { step_factor: 1.5, ..quick() }, "step_factor"),
        (Controls { step_factor: f64::NAN, ..quick() }, "step_factor"),
        (Controls { speed: Some(0.0), ..quick() }, "speed"),
        (Controls { damping: Some(0.9), ..quick() }, "damping"),
        (Controls { after_break: -1.0, ..quick() }, "after_break"),
        (Controls { limit: Some(f64::INFINITY), ..quick() }, "limit"),
    ] {
        let found = check(&spec, &controls, &mut |_| Flow::Continue).unwrap_err();
        assert_eq!(found[0].field, field);
    }
}

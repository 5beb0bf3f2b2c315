//! The tensile test of a net against statics worked by hand.

use meshcast::dem::Flow;
use meshcast::dem::lattice::Role;
use meshcast::dem::law::Law;
use meshcast::dem::tensile::{Pull, TensileOutcome, TensileSpec, tensile};
use meshcast::mesh::laws;
use meshcast::mesh::wire::{CurvePoint, Slack, WireData};

/// The wires of the bench law without slack; `twist` is the factor on the twist's stresses.
fn wires(twist: f64) -> WireData {
    let mut wire = laws::bench();
    wire.distortion.lambda_u = 0.0;
    wire.double_twist.iter_mut().for_each(|p| *p = CurvePoint(p.0, p.1 * twist));
    wire
}

fn pulled(wire: WireData, pull: Pull, sides: [f64; 2]) -> TensileOutcome {
    let [width, length] = sides;
    tensile(&TensileSpec { width, length, pull, wire, seed: 3 }, &mut |_| Flow::Continue).unwrap()
}

/// Strength and elongation along the twists by statics: of every opening one twist and the two wires above
/// it; sideways the net stays as it is. All sides here are whole periods, so no net is stretched.
/// The strain of the wires is raised until one of the two breaks.
fn along(wire: &WireData) -> ([f64; 2], Role) {
    let (net, law) = (&wire.net, Law::new(wire));
    let unloaded = (net.opening / 2.0).hypot(net.projection);
    let (single, twist) = (law.single.full(0.0), law.twist.full(0.0));
    let mut last = ([0.0; 2], Role::Left);
    for k in 0..=1_000_000 {
        let strain = f64::from(k) * 1.0e-6 * law.single.rupture();
        let length = unloaded * (1.0 + strain);
        let rise = (length * length - net.opening * net.opening / 4.0).sqrt();
        let force = 2.0 * law.single.envelope(&single, strain) * rise / length;
        if force >= *law.twist.force.last().unwrap() {
            // The curve is level at its end: the twist goes on to its rupture at the same force.
            let longer = rise - net.projection + net.twist * law.twist.rupture();
            return ([force / net.opening, longer / (net.twist + net.projection)], Role::Twist);
        }
        // The twist's strain at this force, by halving.
        let (mut low, mut high) = (0.0, law.twist.rupture());
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let less = law.twist.envelope(&twist, middle) < force;
            (low, high) = if less { (middle, high) } else { (low, middle) };
        }
        let longer = rise - net.projection + net.twist * low;
        last = ([force / net.opening, longer / (net.twist + net.projection)], Role::Left);
    }
    last
}

#[test]
fn along_the_twists_a_net_without_slack_breaks_where_statics_says() {
    // Twist as strong as two wires: the wires break first; a weak one: the twists do.
    for (factor, first) in [(1.0, Role::Left), (0.5, Role::Twist)] {
        let (wire, sides) = (wires(factor), [0.8, 0.96]);
        let (by_hand, role) = along(&wire);
        assert_eq!(role, first);
        let ours = pulled(wire, Pull::Along, sides);
        let broke = ours.broke.unwrap();
        assert_eq!(broke == Role::Twist, role == Role::Twist, "{broke:?}");
        assert!((ours.strength / by_hand[0] - 1.0).abs() < 5e-3, "{} {by_hand:?}", ours.strength);
        assert!(
            (ours.elongation / by_hand[1] - 1.0).abs() < 2e-2,
            "{} {by_hand:?}",
            ours.elongation
        );
    }
}

#[test]
fn across_the_twists_every_row_carries_one_wire() {
    // By hand: the twist takes up what the wires lean; at the wires' rupture their length is l (1 + e), and
    // their rise p follows from 2 F p/l' = T((pitch - p)/t - 1), because rows stay as far apart as they were.
    let (wire, sides) = (wires(1.0), [0.96, 0.96]);
    let (net, law) = (wire.net, Law::new(&wire));
    let pitch = net.twist + net.projection;
    let force = *law.single.force.last().unwrap();
    let length = (net.opening / 2.0).hypot(net.projection) * (1.0 + law.single.rupture());
    let (mut low, mut high) = (0.0, net.projection);
    for _ in 0..60 {
        let rise = 0.5 * (low + high);
        let strain = (pitch - rise) / net.twist - 1.0;
        let held = law.twist.envelope(&law.twist.full(0.0), strain);
        let pulled = 2.0 * force * rise / length;
        (low, high) = if held > pulled { (rise, high) } else { (low, rise) };
    }
    let half = (length * length - low * low).sqrt();
    let by_hand = force * half / length / pitch;
    let ours = pulled(wire, Pull::Across, sides);
    assert!(ours.broke.is_some_and(|role| role != Role::Twist), "{:?}", ours.broke);
    assert!((ours.strength / by_hand - 1.0).abs() < 1e-2, "{} {by_hand}", ours.strength);
    let wider = 2.0 * half / net.opening - 1.0;
    assert!((ours.elongation / wider - 1.0).abs() < 2e-2, "{} {wider}", ours.elongation);
}

#[test]
fn slack_makes_a_net_weaker_and_a_piece_of_no_size_is_refused() {
    let mut wire = wires(1.0);
    wire.distortion.lambda_u = 0.03;
    wire.distortion.slack = Slack::Triangular;
    let even = pulled(wires(1.0), Pull::Along, [0.8, 0.96]).strength;
    let uneven = pulled(wire.clone(), Pull::Along, [0.8, 0.48]).strength;
    assert!(uneven < even && uneven > 0.9 * even, "{uneven} {even}");
    let spec = TensileSpec { width: 0.01, length: 1.0, pull: Pull::Along, wire, seed: 0 };
    let found = tensile(&spec, &mut |_| Flow::Continue).unwrap_err();
    assert_eq!(found[0].field, "width");
    let spec = TensileSpec { width: 0.8, ..spec };
    assert_eq!(tensile(&spec, &mut |_| Flow::Cancel).unwrap().broke, None);
}

use super::judge::{ANCHOR, Panel, characteristic_part, deflection, with_laws};
use super::*;
use crate::case::Input;
use crate::case::{Question, example};
use crate::curve::{Curve, Point};
use crate::dem::outcome::Quality;
use crate::fingerprint::Fingerprint;
use crate::layout::{Blocks, Layout, REFERENCE};
use crate::study::ensemble::Spread;
use crate::study::mend::{Mend, mend};
use crate::study::remark::CheckFlag;
use crate::study::result::{FieldFigures, Revisions, Sampled, Wanted};

/// Double twist 8x10, d 0.25, D 0.6 m, 20 kN, 0.4 m allowed.
fn job(spacing: f64) -> Case {
    let layout = Layout { plate: 0.25, punch: 0.6, spacing, ..REFERENCE };
    let mut case = example(layout, Some(20_000.0));
    case.question.deflection = Some(0.4);
    case
}

fn judged(case: &Case, basis: Basis) -> Verdict {
    with(case, Simulated::Missing, basis)
}

fn with(case: &Case, simulated: Simulated, basis: Basis) -> Verdict {
    verdict(case, &case.derive(), simulated, basis)
}

/// A check that broke at this force (kN), with this band, at 0.5 m on a straight curve.
fn check(force: f64, band: [f64; 2], runs: usize) -> CheckResult {
    let end = Point { deflection: 0.5, force: 1000.0 * force };
    CheckResult {
        wanted: Wanted::default(),
        inputs: Fingerprint(0),
        by: Revisions::CURRENT,
        runs,
        slipped: 0,
        force: Spread { mean: end.force, band: band.map(|v| 1000.0 * v), ..Spread::default() },
        deflection: Spread::default(),
        peak: end,
        k75: 0.0,
        energy: 0.0,
        curve: Curve {
            deflection: vec![0.0, 0.5],
            force: vec![0.0, end.force],
            failure: Some(end),
        },
        band: [Vec::new(), Vec::new()],
        breaks: Vec::new(),
        quality: Quality::default(),
        flags: Vec::new(),
        field: FieldFigures::default(),
        sampled: Sampled::default(),
    }
}

#[test]
fn every_square_grid_above_1_87_m_fails_on_deflection() {
    // The deflection at 20 kN is 0.4 m at L = 1.87: F_a 22.02 kN, delta_a 0.412 m.
    for (spacing, finding) in [(1.86, Finding::Passes), (1.88, Finding::Fails)] {
        let v = judged(&job(spacing), Basis::Mean);
        assert_eq!(v.finding(), finding, "{spacing}");
        assert_eq!(v.checks[0].state, State::Pass, "strength holds at {spacing}");
    }
    for step in 0..=52 {
        let v = judged(&job(1.88 + 0.05 * f64::from(step)), Basis::Mean);
        assert_eq!((v.finding().mark(), v.checks[1].state), ('x', State::Fail));
        assert_eq!(v.governing().map(|c| c.aspect), Some(Aspect::Deflection));
    }
}

#[test]
fn the_strength_at_three_metres_worked_by_hand() {
    // F_a = 29.1 x 0.976 x 0.825 x 1 = 23.43132 kN; 20/F_a = 0.85356; characteristic 0.88485 F_a.
    let mut case = job(3.0);
    let c = judged(&case, Basis::Mean).checks[0];
    assert!((c.usage[0].unwrap() - 20.0 / 23.431_32).abs() < 1e-6);
    assert!((c.usage[1].unwrap() - 20.0 / (23.431_32 * 0.884_85)).abs() < 1e-6);
    // 1.35 on the load: 1.1523, fails; the deflection is still that at 20 kN.
    let before = judged(&case, Basis::Mean).checks[1];
    case.question.gamma_load = 1.35;
    let factored = judged(&case, Basis::Mean);
    assert!((factored.checks[0].usage[0].unwrap() - 27.0 / 23.431_32).abs() < 1e-6);
    assert_eq!(factored.checks[0].state, State::Fail);
    assert_eq!(factored.checks[1], before);
    // Below 0.4 m the forecast scatters more.
    let small = crate::forecast::variation(0.39);
    assert!((characteristic_part(small) - (1.0 - 1.645 * 0.085)).abs() < 1e-12);
}

#[test]
fn the_basis_decides_and_both_uses_are_given() {
    // 21.5/23.431 = 0.9176 and 21.5/20.733 = 1.0370.
    let mut case = job(3.0);
    case.question = Question { force: Some(21_500.0), ..Question::default() };
    let [mean, low] = [Basis::Mean, Basis::Characteristic].map(|b| judged(&case, b));
    assert_eq!((mean.finding(), low.finding()), (Finding::Passes, Finding::Fails));
    assert_eq!(mean.checks[0].usage, low.checks[0].usage);
}

#[test]
fn a_load_beyond_failure_fails_by_the_force_at_the_allowed_deflection() {
    // F_k 30 kN > F_a; the allowed deflection is beyond failure, so F(allowed) is F_a = 23.431 kN.
    let mut case = job(3.0);
    case.question.force = Some(30_000.0);
    case.question.deflection = Some(2.0);
    let c = judged(&case, Basis::Mean).checks[1];
    assert_eq!((c.demand, c.state), (None, State::Fail));
    assert!((c.usage[0].unwrap() - 30.0 / 23.431_32).abs() < 1e-6);
}

#[test]
fn a_pressure_follows_the_spacing() {
    // 2.5 kN/m2 on 2 m and 4 m: 10 and 40 kN.
    for (spacing, load) in [(2.0, 10_000.0), (4.0, 40_000.0)] {
        let mut case = job(spacing);
        case.question = Question { pressure: Some(2_500.0), ..Question::default() };
        assert_eq!(judged(&case, Basis::Mean).checks[0].demand, Some(load));
    }
}

#[test]
fn an_anchor_carries_the_factored_load_of_its_cell() {
    let mut case = job(1.5);
    assert_eq!(judged(&case, Basis::Mean).checks[2].state, State::NotAsked(ANCHOR));
    case.question.gamma_load = 1.1;
    case.question.anchor_resistance = Some(20_000.0);
    let c = judged(&case, Basis::Mean).checks[2];
    assert!((c.usage[0].unwrap() - 1.1).abs() < 1e-12 && c.state == State::Fail);
}

#[test]
fn the_anchor_takes_its_share_from_the_check_or_an_upper_bound_without_one() {
    let mut case = job(3.5);
    (case.layout.ex, case.layout.ey, case.layout.punch) = (0.55, 1.15, 0.8);
    case.question = Question {
        force: Some(10_000.0),
        anchor_resistance: Some(20_000.0),
        ..Question::default()
    };
    let at = |case: &Case| judged(case, Basis::Mean).checks[2];
    assert_eq!((at(&case).usage[0], at(&case).judge), (Some(0.5), Some(Judge::Statics)));
    // Facing each other: (1 + 1.1/3.5)(1 + 2.3/3.5) = 2.17796 at most.
    case.layout.blocks = Blocks::Mirrored;
    let c = at(&case);
    assert!((c.usage[0].unwrap() - 0.5 * 2.177_96).abs() < 1e-5 && c.state == State::Fail);
    assert_eq!(c.judge, Some(Judge::Estimate));
    // A check: 24 and 7 kN are 25 kN, over a first break at 15 kN.
    let mut result = check(15.0, [14.0, 16.0], 8);
    result.field.anchors = vec![[24_000.0, 7_000.0]; 2];
    let c = with(&case, Simulated::Current(&result), Basis::Mean).checks[2];
    assert!((c.usage[0].unwrap() - 0.5 * 25.0 / 15.0).abs() < 1e-12);
    assert_eq!((c.judge, c.state), (Some(Judge::Check), State::Pass));
}

#[test]
fn nothing_asked_is_blank_and_a_block_on_a_plate_is_not_judged() {
    let plain = judged(&example(REFERENCE, None), Basis::Mean);
    assert_eq!((plain.finding().mark(), plain.governing()), (' ', None));
    let on_plate = example(Layout { ex: 1.5, ey: 1.5, ..REFERENCE }, Some(1000.0));
    let v = judged(&on_plate, Basis::Mean);
    assert_eq!((v.finding(), v.finding().mark()), (Finding::NotJudged, '?'));
    let plain = example(Layout { ex: 1.5, ey: 1.5, ..REFERENCE }, None);
    assert_eq!(judged(&plain, Basis::Mean).finding(), Finding::NotAsked);
}

#[test]
fn the_larger_use_of_forecast_and_check_counts() {
    // Forecast 23.43 kN, band 20.7 to 26.1; check 16 kN, band 14 to 18: apart. 10/16 on the mean,
    // 10/14 on the lower end.
    let mut case = job(3.0);
    case.question = Question { force: Some(10_000.0), ..Question::default() };
    let low = check(16.0, [14.0, 18.0], 8);
    let v = with(&case, Simulated::Current(&low), Basis::Characteristic);
    let c = v.checks[0];
    assert_eq!((c.judge, v.remarks.as_slice()), (Some(Judge::Check), &[VerdictRemark::Apart][..]));
    assert!((c.usage[0].unwrap() - 0.625).abs() < 1e-12);
    assert!((c.usage[1].unwrap() - 10.0 / 14.0).abs() < 1e-12);
    assert_eq!(v.finding(), Finding::Passes, "a caution counts above 0.8 only");
    case.question.force = Some(12_000.0);
    let v = with(&case, Simulated::Current(&low), Basis::Characteristic);
    assert_eq!((v.finding(), v.finding().mark()), (Finding::Doubtful, '?'));
    // A single block that a larger field would change is a caution of its own.
    let mut single = check(12.1, [12.0, 30.0], 8);
    single.flags.push(CheckFlag::Unsettled);
    let v = with(&case, Simulated::Current(&single), Basis::Mean);
    assert_eq!(
        (v.finding(), v.remarks.as_slice()),
        (Finding::Doubtful, &[VerdictRemark::Unsettled][..])
    );
    // A stronger check leaves the forecast's use.
    let v = with(&case, Simulated::Current(&check(24.0, [22.0, 26.0], 8)), Basis::Mean);
    assert_eq!((v.checks[0].judge, v.remarks.len()), (Some(Judge::Forecast), 0));
    // Its curve is straight: 10 kN of 16 at 0.5 m is 0.3125 m, over 0.25 m.
    case.question = Question { force: Some(10_000.0), deflection: Some(0.25), ..case.question };
    let check_only = deflection(&case, &Panel::Check(&low));
    assert!((check_only.demand.unwrap() - 0.3125).abs() < 1e-12);
    assert!((check_only.usage[0].unwrap() - 1.25).abs() < 1e-12);
}

/// Seen: the deflection of a block alone passed at 60 % of what is allowed, by relations of a block in every cell; a
/// check gave half as much more.
#[test]
fn a_single_block_without_a_check_is_never_a_plain_pass() {
    use crate::layout::Blocks;
    let mut case = job(3.0);
    case.question = Question { force: Some(1000.0), deflection: Some(0.6), ..Question::default() };
    assert_eq!(judged(&case, Basis::Mean).finding(), Finding::Passes);
    case.layout.blocks = Blocks::Single;
    let of_many = &[VerdictRemark::OneBlock][..];
    let v = judged(&case, Basis::Mean);
    assert_eq!((v.finding(), v.remarks.as_slice()), (Finding::Doubtful, of_many));
    assert!(v.largest_use() < Some(0.5), "{:?}", v.largest_use());
    // Its own check ends that, a stale one does not.
    let checked = check(24.0, [22.0, 26.0], 8);
    let v = with(&case, Simulated::Current(&checked), Basis::Mean);
    assert_eq!((v.finding(), v.remarks.len()), (Finding::Passes, 0));
    assert_eq!(with(&case, Simulated::Stale, Basis::Mean).finding(), Finding::Doubtful);
}

#[test]
fn a_stale_check_does_not_count_and_is_said() {
    let v = with(&job(1.86), Simulated::Stale, Basis::Mean);
    assert_eq!(
        (v.checks[0].judge, v.remarks.as_slice()),
        (Some(Judge::Forecast), &[VerdictRemark::Stale][..])
    );
    assert_eq!(v.finding(), Finding::Doubtful, "near the limit");
}

#[test]
fn a_block_that_slips_through_in_all_runs_fails() {
    let mut slipped = check(0.0, [1.0, 2.0], 4);
    slipped.slipped = 4;
    slipped.curve.failure = None;
    let mut case = job(1.5);
    case.question = Question { force: Some(100.0), ..Question::default() };
    let v = with(&case, Simulated::Current(&slipped), Basis::Mean);
    assert_eq!((v.checks[0].state, v.finding()), (State::PassesThrough, Finding::Fails));
    assert_eq!(v.governing().map(|c| c.state.why()), Some(Some("passes through".into())));
}

#[test]
fn one_run_has_no_characteristic_value() {
    let one = check(16.0, [16.0; 2], 1);
    let mut case = job(3.0);
    case.question = Question { force: Some(10_000.0), ..Question::default() };
    let v = with(&case, Simulated::Current(&one), Basis::Characteristic);
    assert_eq!((v.checks[0].judge, v.finding()), (Some(Judge::Forecast), Finding::Passes));
    assert!(v.remarks.contains(&VerdictRemark::OneRun));
}

#[test]
fn anchors_nearer_together_mend_a_deflection() {
    let case = job(3.0);
    let found = mend(&case, &judged(&case, Basis::Mean)).unwrap();
    assert_eq!(found.input, Input::Spacing);
    assert!((1.86..=1.88).contains(&found.value), "{found:?}");
    let mended = case.with(found.input, found.value);
    assert_eq!(judged(&mended, Basis::Mean).finding(), Finding::Passes);
}

#[test]
fn a_wider_spacing_is_never_the_cure() {
    // 25 kN on 23.43: a wider panel would forecast more; a plate of more than 0.25 m is the cure.
    // 29.1 x 0.976 x (1.5 d + 0.45) = 25: d = 0.28682 m.
    let mut case = job(3.0);
    case.question = Question { force: Some(25_000.0), ..Question::default() };
    let found = mend(&case, &judged(&case, Basis::Mean)).unwrap();
    assert_eq!(found, Mend { input: Input::Plate, value: 0.287 });
    // 40 kN is beyond every plate, and no spacing is advised.
    case.question.force = Some(40_000.0);
    assert_eq!(mend(&case, &judged(&case, Basis::Mean)), None);
    // With a pressure a smaller spacing takes load away: 10 kN/m2 on 9 m2 are 90 kN.
    case.question = Question { pressure: Some(10_000.0), ..Question::default() };
    let found = mend(&case, &judged(&case, Basis::Mean)).unwrap();
    assert!(found.input == Input::Spacing && found.value < 1.6, "{found:?}");
    assert_eq!(
        judged(&case.with(found.input, found.value), Basis::Mean).finding(),
        Finding::Passes
    );
}

#[test]
fn a_mesh_whose_laws_differ_widely_never_passes_plainly_and_has_less_to_rely_on() {
    use crate::layout::MethodChoice;
    use crate::mesh::adopted::{Adopted, AdoptedQuality, KeptMethod};
    let with_range = |low: f64, high: f64| {
        let mut case = job(2.5);
        case.question.force = Some(1000.0);
        case.question.deflection = None;
        case.layout.method = MethodChoice::Derived;
        let mut mesh = (*case.mesh).clone();
        mesh.adopted = Some(Adopted {
            quality: AdoptedQuality::OneTestAndPrior,
            low: 1000.0 * low,
            middle: 20_000.0,
            high: 1000.0 * high,
            methods: vec![KeptMethod::keep(crate::method::canned::method())],
        });
        case.mesh = mesh.into();
        case
    };
    let (sure, unsure) = (with_range(20.0, 20.0), with_range(16.0, 25.0));
    let basis = Basis::Characteristic;
    let (plain, doubtful) = (judged(&sure, basis), judged(&unsure, basis));
    assert_eq!(plain.finding(), Finding::Passes);
    assert_eq!(doubtful.finding(), Finding::Doubtful);
    assert_eq!(doubtful.remarks, [VerdictRemark::WideLaws]);
    // The mean is the same; the characteristic value lacks the range: by hand, the canned method scatters 0.0625
    // at the anchors and ln(25/16)/3.29 = 0.13565 comes to it, together 0.14936: 1 - 1.645 x 0.14936 = 0.75430.
    let capacity = |v: &Verdict| v.checks[0].capacity.map(Option::unwrap);
    let ([mean, low], [same, lower]) = (capacity(&plain), capacity(&doubtful));
    assert_eq!(mean, same);
    assert!((low / mean - (1.0 - 1.645 * 0.0625)).abs() < 1e-9, "{}", low / mean);
    assert!((lower / mean - 0.754_30).abs() < 1e-4, "{}", lower / mean);
    // Likewise a check's: 10 % below its mean at 5 % is 0.06079, with the range 0.14865.
    let check = check(20.0, [18.0, 22.0], 8);
    let both = [&sure, &unsure].map(|case| with_laws(case, &Panel::Check(&check)));
    assert_eq!(both[0][0], both[1][0]);
    let scatter = (1.0 - both[0][1].unwrap() / 20_000.0) / 1.645;
    let wider = 1.0 - 1.645 * scatter.hypot(0.135_65);
    assert!((both[1][1].unwrap() / 20_000.0 - wider).abs() < 1e-4, "{both:?}");
}

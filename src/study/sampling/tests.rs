//! Areas against a count, alignments against their patterns, and the statistics by simulation on strata
//! that are made up.

use super::figures::{Placed, figures};
use super::pattern::{Rectangle, caught_nodes, patterns};
use super::spread::Spread;
use super::*;
use crate::dem::{Arrangement, SceneSpec};
use crate::layout::{Grid, Layout, REFERENCE, Twists};
use crate::mesh::laws;
use std::collections::HashMap;

fn spec(layout: Layout, arrangement: Arrangement) -> SceneSpec {
    SceneSpec { arrangement, ..SceneSpec::plain(layout, Test::Anchored, laws::reference()) }
}

fn scene(layout: Layout, arrangement: Arrangement) -> Scene {
    Scene::new(&spec(layout, arrangement)).unwrap()
}

/// Scenes with centred and eccentric blocks, facing ones, plates that meet two rows of nodes at once, and
/// grids that are staggered or rectangular, with the net hung either way.
fn scenes() -> Vec<Scene> {
    let at = |plate, spacing, ex, ey| Layout { plate, spacing, punch: 0.5, ex, ey, ..REFERENCE };
    let on = |grid| Layout { grid, ..at(0.26, 2.0, 0.0, 0.0) };
    let repeated = Arrangement::default();
    vec![
        scene(REFERENCE, repeated),
        scene(at(0.25, 2.5, 0.0, 0.0), repeated),
        scene(at(0.25, 3.5, 0.55, 1.15), repeated),
        scene(at(0.25, 2.0, 0.3, 0.2), Arrangement::Mirrored),
        scene(at(0.2, 1.92, 0.4, 0.0), repeated),
        scene(at(0.41, 1.37, 0.0, 0.1), Arrangement::Repeated([2, 1])),
        scene(on(Grid { up: Some(1.84), stagger: true, twists: Twists::Down }), repeated),
        scene(on(Grid { up: Some(2.1), stagger: true, twists: Twists::Across }), repeated),
        scene(on(Grid { up: Some(1.8), stagger: false, twists: Twists::Across }), repeated),
    ]
}

#[test]
fn areas_are_one_together_and_those_that_a_fine_count_of_alignments_finds() {
    // Alignments of a grid that no cut runs along; a pattern of a rectangles has about 2 a 61 grid cells on
    // its edges, so a count is off by 4 of 61 times its extent at most: here by less than 0.02.
    let n = 61;
    for scene in scenes() {
        let found = patterns(&scene);
        let whole: f64 = found.iter().map(|p| p.area).sum();
        assert!((whole - 1.0).abs() < 1e-9, "{whole}");
        let mut nodes: HashMap<usize, usize> = HashMap::new();
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let phase = [i, j].map(|k| (f64::from(k) + 0.317) / f64::from(n));
            let spec = SceneSpec { phase, ..scene.spec.clone() };
            // What the solver itself holds fixed, in all cells alike.
            let fixed = Scene::new(&spec).unwrap().fixed;
            let held = fixed.iter().flatten().filter(|held| **held).count();
            *nodes.entry(held).or_default() += 1;
        }
        for (held, times) in nodes {
            let counted = times as f64 / f64::from(n * n);
            let anchors = scene.field.anchors() as f64;
            let of = found.iter().filter(|p| (p.nodes * anchors).round() == held as f64);
            let area: f64 = of.map(|p| p.area).sum();
            assert!((area - counted).abs() < 0.02, "{held} nodes: {area} and {counted}");
        }
    }
}

#[test]
fn an_alignment_drawn_in_a_pattern_catches_its_nodes() {
    for scene in scenes() {
        let plan = Plan { runs: Some(40), seed: 5, ..Plan::default() };
        let sample = Sample::of(&scene, &plan);
        assert!(sample.patterns.len() > 1);
        for k in 0..40 {
            let member = sample.member(k);
            let pattern = &sample.patterns[member.pattern.unwrap()];
            let inside = |r: &Rectangle| caught_nodes(&scene, r.at([0.5; 2]));
            let drawn = caught_nodes(&scene, member.phase);
            assert!(pattern.rectangles.iter().map(inside).any(|k| k == drawn));
            let spec = SceneSpec { phase: member.phase, ..scene.spec.clone() };
            let fixed = Scene::new(&spec).unwrap().fixed;
            let held = fixed.iter().flatten().filter(|held| **held).count();
            assert_eq!(held as f64, (pattern.nodes * scene.field.anchors() as f64).round());
        }
    }
}

#[test]
fn mirror_images_are_one_pattern_where_the_block_is_centred_and_where_blocks_face_each_other() {
    let at =
        |ex, ey, arrangement| patterns(&scene(Layout { ex, ey, ..REFERENCE }, arrangement)).len();
    let repeated = Arrangement::default();
    // Four columns of cuts by eight rows are 32 rectangles, two and two the same but for a translation.
    assert_eq!(at(0.3, 0.3, repeated), 16);
    assert_eq!(at(0.0, 0.0, repeated), 8);
    assert_eq!(at(0.3, 0.3, Arrangement::Mirrored), 8);
    let one = [at(0.3, 0.0, repeated), at(0.0, 0.3, repeated)];
    assert!(one.iter().all(|n| (8..16).contains(n)), "{one:?}");
    // Two plates half an opening apart: the first scene has 37 openings in its cell, an odd number.
    let staggered = |ex| {
        let grid = Grid { up: Some(2.9), stagger: true, twists: Twists::Down };
        patterns(&scene(Layout { spacing: 2.96, ex, grid, ..REFERENCE }, repeated)).len()
    };
    let [centred, aside] = [staggered(0.0), staggered(0.3)];
    assert!(centred < aside && aside < 2 * centred + 1, "{centred} {aside}");
}

#[test]
fn the_place_of_a_run_follows_from_seed_and_number() {
    let scene = scene(REFERENCE, Arrangement::default());
    let of = |seed| Sample::of(&scene, &Plan { seed, ..Plan::default() });
    let (a, again, other) = (of(1), of(1), of(2));
    let same = (0..30).filter(|k| a.member(*k) == other.member(*k)).count();
    assert!((0..30).all(|k| a.member(k) == again.member(k)) && same == 0);
    let pinned = Plan { phase: Some([0.25, 0.5]), ..Plan::default() };
    assert_eq!(Sample::of(&scene, &pinned).member(3).phase, [0.25, 0.5]);
    assert_eq!(Sample::of(&scene, &pinned).member(3).pattern, None);
}

/// Patterns that are made up: areas and means about 1, and the scatter within them.
struct Made {
    areas: Vec<f64>,
    means: Vec<f64>,
    within: f64,
}

impl Made {
    /// The four layouts that were looked at had areas and means like these.
    fn all() -> Vec<Made> {
        let areas = vec![0.4, 0.4, 0.095, 0.048, 0.024, 0.024, 0.005, 0.004];
        let means = vec![0.936, 1.051, 1.005, 0.968, 1.238, 1.064, 1.1, 1.01];
        let mut many: Vec<f64> = vec![0.128; 4];
        many.extend([0.051; 8]);
        many.extend([0.02; 4]);
        let scattered = [
            0.881, 0.994, 1.053, 0.995, 0.987, 0.914, 1.091, 1.019, 1.151, 1.091, 1.005, 0.921,
            1.123, 1.174, 0.93, 1.042,
        ];
        vec![
            Made { areas: areas.clone(), means, within: 0.011 },
            Made { areas: many, means: scattered.to_vec(), within: 0.011 },
            // More scatter within patterns than is assumed, less between them.
            Made { areas, means: vec![0.98, 1.01, 1.0, 1.02, 1.03, 0.97, 1.0, 1.0], within: 0.018 },
        ]
    }

    fn mean(&self) -> f64 {
        let whole: f64 = self.areas.iter().sum();
        self.areas.iter().zip(&self.means).map(|(a, m)| a * m).sum::<f64>() / whole
    }

    fn sample(&self, runs: Option<usize>, seed: u64) -> Sample {
        self.planned(Plan { runs, seed, ..Plan::default() })
    }

    fn planned(&self, plan: Plan) -> Sample {
        let whole: f64 = self.areas.iter().sum();
        let mut from = 0.0;
        let pattern = |area: &f64| {
            let to = from + area / whole;
            let rectangles = vec![Rectangle::new([from, to], [0.0, 1.0])];
            from = to;
            Pattern { nodes: 0.0, area: area / whole, rectangles }
        };
        let patterns = self.areas.iter().map(pattern).collect();
        let mut sample =
            Sample { kind: Kind::Pinned, patterns: Vec::new(), groups: Vec::new(), round: 1, plan };
        sample.by_patterns(patterns);
        sample
    }

    /// Figures of an ensemble of `runs` runs with values from the seeds of its members.
    fn ensemble(&self, sample: &Sample, runs: usize) -> Spread {
        let value = |k| {
            let member = sample.member(k);
            let pattern = member.pattern.unwrap();
            let [a, b] = [7, 8].map(|n| uniform(member.seed, n).max(1e-300));
            let normal = (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos();
            let value = self.means[pattern] + self.within * normal;
            Placed { pattern: member.pattern, phase: member.phase, value }
        };
        let values: Vec<Placed> = (0..runs).map(value).collect();
        figures(sample, &values, &values)
    }
}

#[test]
fn the_mean_is_unbiased_for_every_number_of_runs() {
    for made in Made::all() {
        for n in 1..=20 {
            let off = |seed| made.ensemble(&made.sample(Some(n), seed), n).mean - made.mean();
            let means: Vec<f64> = (0..600).map(off).collect();
            let s = Spread::of(&means, &means);
            // Four standard errors: one of the 60 combinations fails by chance once in 260 tries.
            assert!(s.mean.abs() < 4.0 * s.error, "{n} runs: off by {} +- {}", s.mean, s.error);
        }
    }
}

#[test]
fn the_standard_error_is_that_of_the_mean() {
    let trials = 600;
    for (number, made) in Made::all().iter().enumerate() {
        for n in [6, 8, 12, 16, 32] {
            let (mut squares, mut said, mut inside) = (0.0, 0.0, 0);
            for seed in 0..trials {
                let s = made.ensemble(&made.sample(Some(n), seed), n);
                let off = s.mean - made.mean();
                squares += off * off;
                said += s.error * s.error;
                inside += i32::from(off.abs() < 1.96 * s.error);
            }
            let ratio = (said / squares).sqrt();
            let covered = f64::from(inside) / trials as f64;
            // Of 600 trials the ratio is known to 3 %, the coverage to 1 %. What is assumed pulls the
            // error towards itself as long as few runs say otherwise: it is a fifth too small at 6 runs
            // where 1.3 % is assumed and 1.8 % true, a third too large where small patterns differ less.
            let text =
                format!("{number}, {n} runs: {ratio:.2} of the true one, covers {covered:.3}");
            assert!((0.77..1.45).contains(&ratio) && covered > 0.84, "{text}");
            assert!(n < 32 || ((0.9..1.1).contains(&ratio) && covered > 0.91), "{text}");
        }
    }
}

#[test]
fn fewer_members_without_a_second_look_tell_their_error_too() {
    for (number, made) in Made::all().iter().enumerate() {
        let (trials, mut squares, mut said, mut sum, mut inside) = (600, 0.0, 0.0, 0.0, 0);
        let mut n = 0;
        for seed in 0..trials {
            let sample = made.planned(Plan { seed, auto: true, ..Plan::default() });
            n = sample.round;
            let s = made.ensemble(&sample, n);
            let off = s.mean - made.mean();
            sum += off;
            squares += off * off;
            said += s.error * s.error;
            inside += i32::from(off.abs() < 1.96 * s.error);
        }
        let trials = trials as f64;
        let (ratio, covered) = ((said / squares).sqrt(), f64::from(inside) / trials);
        let rms = (squares / trials).sqrt();
        let text = format!("{number}, {n} runs: rms {rms:.4}, {ratio:.2} of it, {covered:.3}");
        assert!((sum / trials).abs() < 4.0 * rms / trials.sqrt(), "{text}");
        assert!(rms < 0.01 && (0.77..1.45).contains(&ratio) && covered > 0.84, "{text}");
        assert!(n < made.sample(None, 0).round, "{text}");
    }
}

#[test]
fn the_number_of_runs_is_the_least_that_should_do() {
    let runs = |made: &Made| made.sample(None, 0).round;
    // By hand for equal areas of 1/4 with one run each: 1.3 % / 2, below 0.75 % of the mean.
    let four = Made { areas: vec![0.25; 4], means: vec![1.0; 4], within: 0.01 };
    assert_eq!(runs(&four), LEAST_PLACED);
    let all: Vec<usize> = Made::all().iter().map(runs).collect();
    assert!(all.iter().all(|n| (LEAST_PLACED..=16).contains(n)), "{all:?}");
    assert!(all[1] > all[0], "sixteen patterns take more than eight: {all:?}");
}

#[test]
fn the_band_is_that_of_the_mixture() {
    // Two patterns far apart: the 5 % point is the 10 % point of the lower one, the 95 % point the 90 %
    // point of the upper one, 1.2816 standard deviations from the middle.
    let made = Made { areas: vec![0.5, 0.5], means: vec![0.8, 1.2], within: 0.0 };
    let sample = made.sample(Some(2), 0);
    let s = made.ensemble(&sample, 2);
    // Nothing was run twice: the assumed scatter stands, but 1 % of the mean at least.
    let half = 1.2816 * 0.013;
    assert!((s.band[0] - (0.8 - half)).abs() < 1e-5, "{:?}", s.band);
    assert!((s.band[1] - (1.2 + half)).abs() < 1e-5, "{:?}", s.band);
    assert!((s.mean - 1.0).abs() < 1e-12);
    assert!((s.deviation - 0.2_f64.hypot(0.013)).abs() < 1e-9);
}

#[test]
fn points_of_a_lattice_are_spread_over_the_half_period_and_their_error_is_that_of_the_mean() {
    let scene = scene(Layout { punch: 0.3, ..REFERENCE }, Arrangement::default());
    // A slow wave that is the same half an opening and a row further, and a little of chance.
    let value = |p: [f64; 2], seed: u64| {
        let [x, y] = p.map(|v| v * std::f64::consts::TAU);
        1.0 + 0.1 * x.cos() * y.cos() + 0.03 * (uniform(seed, 9) - 0.5)
    };
    for runs in [None, Some(16), Some(20)] {
        let n = runs.unwrap_or(16);
        let (mut squares, mut said, mut sum) = (0.0, 0.0, 0.0);
        for seed in 0..400 {
            let sample = Sample::of(&scene, &Plan { runs, seed, ..Plan::default() });
            let placed = |k| {
                let Member { seed, phase, pattern } = sample.member(k);
                assert!((0.0..1.0).contains(&phase[0]) && (0.0..0.5).contains(&phase[1]));
                Placed { pattern, phase, value: value(phase, seed) }
            };
            let values: Vec<Placed> = (0..n).map(placed).collect();
            let s = figures(&sample, &values, &values);
            sum += s.mean - 1.0;
            squares += (s.mean - 1.0) * (s.mean - 1.0);
            said += s.error * s.error;
        }
        let (bias, error) = (sum / 400.0, (squares / 400.0_f64).sqrt());
        assert!(bias.abs() < 4.0 * error / 20.0, "{runs:?}: {bias}");
        // At random it would be 0.05 over the root of n, 1.2 %.
        assert!(error < 0.004, "{runs:?}: {error}");
        let ratio = (said / squares).sqrt();
        assert!((0.75..1.35).contains(&ratio), "{runs:?}: {ratio}");
    }
}

#[test]
fn weights_are_exact_areas_and_what_is_lacking_is_left_out() {
    let made = Made { areas: vec![0.6, 0.3, 0.1], means: vec![1.0; 3], within: 0.0 };
    let sample = made.sample(Some(4), 0);
    let weight = |places: &[usize]| {
        weights(&sample, &places.iter().map(|p| Some(*p)).collect::<Vec<Option<usize>>>())
    };
    let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
    assert!(close(&weight(&[0, 0, 1, 2]), &[0.3, 0.3, 0.3, 0.1]), "{:?}", weight(&[0, 0, 1, 2]));
    assert!(close(&weight(&[0, 1]), &[0.6 / 0.9, 0.3 / 0.9]));
}

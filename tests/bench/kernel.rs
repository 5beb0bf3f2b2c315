//! How fast a step of the check is: `cargo bench --bench kernel`.
//!
//! Prints the best time per node and step for both precisions and every instruction set that the
//! processor has, on bench scene A (3 m) and on the same mesh with L = 12 m; then lets criterion
//! measure blocks of steps of scene A.

use criterion::{Criterion, criterion_group};
use meshcast::dem::fast::{Fast, FastOptions, Kernel, Path};
use meshcast::dem::stepper::Stepper;
use meshcast::dem::{Controls, Scene, SceneSpec};
use meshcast::lab::bench::scene;
use meshcast::study::clock::thread_seconds;
use std::hint::black_box;

/// Bench scene A with a panel of side `spacing`, m, or A' with scatter.
fn spec(name: &str, spacing: f64) -> SceneSpec {
    let mut spec = scene(name).expect("A and A' are bench scenes");
    spec.layout.spacing = spacing;
    spec
}

/// A solver whose punch has met the net: 0.3 m of its way at a travel of 4e-4 m.
fn solver<R: Kernel>(spec: &SceneSpec, path: Path) -> (Fast<R>, usize) {
    let scene = Scene::new(spec).expect("bench scenes are sound");
    let scheme = Controls::default().scheme(&scene).expect("default controls are sound");
    let options = FastOptions {
        factors: scheme.factors,
        damping: scheme.damping,
        true_unloading: false,
        fitted: false,
        path,
    };
    let mut fast = Fast::new(&scene, options);
    fast.advance(750, 4.0e-4);
    (fast, scene.lattice.nodes())
}

/// Best of some blocks of steps, ns per node and step.
fn best<R: Kernel>(spec: &SceneSpec, path: Path) -> f64 {
    let (mut fast, nodes) = solver::<R>(spec, path);
    let steps = (400_000 / nodes).max(10);
    let mut best = f64::INFINITY;
    for _ in 0..30 {
        let start = thread_seconds();
        // The punch stands still, so that the state stays where it is.
        black_box(fast.advance(steps, 0.0));
        best = best.min(thread_seconds() - start);
    }
    1.0e9 * best / (steps * nodes) as f64
}

fn table() {
    println!("ns per node and step, processor time, best of 30");
    println!(
        "{:<12} {:>9} {:>9} {:>9} {:>9} {:>9}",
        "", "A f32", "A' f32", "A f64", "12 m f32", "12 m f64"
    );
    for path in Path::available() {
        let [a, scatter, large] = [spec("A", 3.0), spec("A'", 3.0), spec("A", 12.0)];
        println!(
            "{:<12} {:>9.2} {:>9.2} {:>9.2} {:>9.2} {:>9.2}",
            format!("on {path:?}"),
            best::<f32>(&a, path),
            best::<f32>(&scatter, path),
            best::<f64>(&a, path),
            best::<f32>(&large, path),
            best::<f64>(&large, path)
        );
    }
}

fn blocks(c: &mut Criterion) {
    for path in Path::available() {
        let (mut single, _) = solver::<f32>(&spec("A", 3.0), path);
        c.bench_function(&format!("100 steps of A, f32, {path:?}"), |b| {
            b.iter(|| single.advance(100, 0.0));
        });
        let (mut double, _) = solver::<f64>(&spec("A", 3.0), path);
        c.bench_function(&format!("100 steps of A, f64, {path:?}"), |b| {
            b.iter(|| double.advance(100, 0.0));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = blocks
}

fn main() {
    // `cargo test` runs benches once to see that they work; the table would take its time there.
    if std::env::args().any(|a| a == "--bench") {
        table();
    }
    benches();
    Criterion::default().configure_from_args().final_summary();
}

//! How fast the forecast is: `cargo bench --bench forecast`.
//!
//! Aim: one forecast with its 201-point curve under 5 microseconds on one core, a sweep of a million
//! layouts in a few seconds.

use criterion::{Criterion, criterion_group};
use meshcast::forecast::{CURVE_POINTS, forecast};
use meshcast::layout::{BranchRule, Layout, REFERENCE};
use meshcast::mesh::{MeshType, catalogue};
use std::hint::black_box;
use std::time::Instant;

/// Table 1's fourth layout: eccentric, so that nothing of the map is spared.
const ECCENTRIC: Layout =
    Layout { plate: 0.40, spacing: 4.0, punch: 1.2, ex: 2.0, ey: 0.2, ..REFERENCE };

fn single(c: &mut Criterion) {
    let mesh = catalogue::reference();
    for (name, layout) in [("centred", REFERENCE), ("eccentric", ECCENTRIC)] {
        let run = |layout: &Layout| forecast(black_box(layout), &mesh, BranchRule::Published);
        c.bench_function(&format!("{name}, values only"), |b| b.iter(|| run(&layout)));
        c.bench_function(&format!("{name}, with curve"), |b| {
            b.iter(|| {
                let result = run(&layout);
                let end = result.as_ref().ok().and_then(|f| f.field.ok()?.end());
                let curve = end.map(|end| end.curve(CURVE_POINTS));
                (result, curve)
            });
        });
    }
}

/// A million different layouts over the published ranges, offsets included.
fn sweep(mesh: &MeshType) -> (usize, f64) {
    let (mut with_value, mut sum) = (0, 0.0);
    for i in 0..1_000_000_u32 {
        let part = |prime: u32| f64::from(i.wrapping_mul(prime) % 1009) / 1009.0;
        let spacing = 1.25 + 3.25 * part(7);
        let layout = Layout {
            plate: 0.16 + 0.32 * part(31),
            spacing,
            punch: 0.1 + 1.1 * part(101),
            ex: spacing * (part(401) - 0.5),
            ey: spacing * (part(733) - 0.5),
            ..REFERENCE
        };
        if let Ok(Ok(field)) =
            forecast(&layout, mesh, BranchRule::Published).map(|result| result.field)
        {
            with_value += 1;
            sum += field.values.force;
        }
    }
    (with_value, sum)
}

fn timed_sweep() {
    let mesh = catalogue::reference();
    let start = Instant::now();
    let (with_value, sum) = black_box(sweep(&mesh));
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "sweep of 1000000 layouts: {seconds:.2} s on one core ({with_value} with a value, mean {:.1} kN)",
        sum / 1000.0 / with_value.max(1) as f64
    );
}

criterion_group!(benches, single);

fn main() {
    // `cargo test` runs benches once to see that they work; a sweep would take its time there.
    if std::env::args().any(|a| a == "--bench") {
        timed_sweep();
    }
    benches();
    Criterion::default().configure_from_args().final_summary();
}

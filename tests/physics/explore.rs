use meshcast::dem::*;
use meshcast::mesh::laws;
use meshcast::study::*;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    match a[1].as_str() {
        "bench" => {
            let names: Vec<&str> =
                if a.len() > 2 { vec![a[2].as_str()] } else { bench::SCENES.to_vec() };
            let (rows, known) = bench::table(&names, &mut |s| eprintln!("{s}")).unwrap();
            for r in rows {
                println!(
                    "{} {:<10} {:8.1} ms {:7} steps F {:+.3} d {:+.3} curve {:.3} est {:.3} x{:.1}  {:.3} kN {:.4} m",
                    r.scene,
                    r.fidelity,
                    r.wall_ms,
                    r.steps,
                    r.force_error,
                    r.deflection_error,
                    r.curve_error,
                    r.estimate,
                    r.faster,
                    r.force,
                    r.deflection
                );
            }
            for k in known {
                println!("{k:?}");
            }
        }
        "conv" => {
            for r in convergence::tables(&[a[2].as_str()], &mut |s| eprintln!("{s}")).unwrap() {
                println!(
                    "{} {:<9} {:<8} F {:+.3} d {:+.3} curve {:.3} order {:?} est {:.3} kin {:.2e}",
                    r.scene,
                    r.knob,
                    r.value,
                    r.force,
                    r.deflection,
                    r.curve,
                    r.order.map(|o| (o * 100.0).round() / 100.0),
                    r.estimate,
                    r.kinetic_over_internal
                );
            }
        }
        "cal" => {
            let t = std::time::Instant::now();
            let f = calibrate::fit(
                &laws::reference(),
                &calibrate::Target { force: 73300.0, deflection: 0.6, panel: 3.0, punch: 1.0 },
                2,
                &|s| {
                    if !s.is_empty() {
                        eprintln!("{s}");
                    }
                    Flow::Continue
                },
            )
            .unwrap();
            println!(
                "{} {} {:?} anchored {:?} {:?} in {:.1} s",
                f.stress,
                f.strain,
                f.residual,
                f.anchored.force,
                f.anchored.deflection,
                t.elapsed().as_secs_f64()
            );
            println!("{:?}", f.wire);
        }
        _ => {
            let q: f64 = a[2].parse().unwrap();
            let s: f64 = a[3].parse().unwrap();
            let wire = calibrate::scale(&laws::reference(), q, s);
            let plan = ensemble::Plan { threads: 2, ..Default::default() };
            let rows = published::compare(
                &wire,
                &Controls { after_break: 0.0, ..Controls::default() },
                &plan,
                &|s| {
                    if !s.is_empty() {
                        eprintln!("{s}");
                    }
                    Flow::Continue
                },
            )
            .unwrap();
            for r in rows {
                println!(
                    "{:<32} {:<12} paper {:8.3} ours {:8.3} se {:.3} band {:.3}..{:.3} diff {:+.1} {} n{} sl{}",
                    r.name,
                    r.quantity,
                    r.paper,
                    r.ours,
                    r.standard_error,
                    r.band[0],
                    r.band[1],
                    r.difference_pct,
                    r.standing,
                    r.runs,
                    r.slipped
                );
            }
        }
    }
}

use meshcast::dem::{inertia::StepFactors, plain::*, scene::*, stepper::*};
use meshcast::layout::*;
use meshcast::mesh::laws;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let which = a[1].as_str();
    let v: f64 = a[2].parse().unwrap();
    let (test, l, wire) = match which {
        "ya" => (Test::Anchored, 3.04, laws::yade()),
        "yl" => (Test::Laboratory, 3.0, laws::yade()),
        "A" => (Test::Anchored, 3.0, laws::bench()),
        "B" => (Test::Laboratory, 3.0, laws::bench()),
        "C" => (Test::Anchored, 4.0, laws::bench()),
        _ => (Test::Anchored, 3.0, laws::reference()),
    };
    let mut layout = Layout { spacing: l, ..REFERENCE };
    if which == "C" {
        layout = Layout { spacing: 4.0, punch: 1.2, plate: 0.4, ex: 2.0, ey: 0.2 };
    }
    let scene = Scene::new(&SceneSpec { layout, test, wire, phase: PLAIN_PHASE, seed: 1 }).unwrap();
    let t = std::time::Instant::now();
    let mut s = if a.get(3).map(|x| x == "uni").unwrap_or(false) {
        Plain::of_scene(&scene, Inertia::Uniform(0.0039 / 6.222e-6f64.powi(2)), Damping::Local(0.5))
    } else {
        let c: f64 = a[3].parse().unwrap();
        let g: f64 = a[4].parse().unwrap();
        Plain::of_scene(
            &scene,
            Inertia::Pairs(StepFactors { translation: c, stretching: 0.8 }),
            Damping::Viscous(g),
        )
    };
    let mut known = vec![];
    let n = (0.002 / v).round() as usize;
    let mut next = 0.1;
    let mut loss = 0.0;
    let mut work = 0.0;
    let mut steps = 0;
    loop {
        let b = s.advance(n, v);
        steps += n;
        let ke = s.kinetic();
        work += b.punch * n as f64 * v;
        loss += s.damping_loss().unwrap_or(0.0) * ke * n as f64;
        if s.deflection() > next {
            let e = s.energies();
            println!(
                "{:.4} {:.3} {:.3} w {:.3} ke {:.3e} in {:.1} W {:.1} loss {:.1} bal {:.4} util {:.3}",
                b.deflection,
                b.punch / 1e3,
                b.support / 1e3,
                (0.4 * b.punch + 0.6 * b.support) / 1e3,
                ke,
                e.bonds,
                work,
                loss,
                (work - e.bonds - e.kinetic - e.contact - loss) / work,
                s.utilisation()
            );
            next += 0.05;
        }
        if s.broken(&mut known) > 0 {
            println!(
                "BREAK {:.4} {:.3} {:.3} w {:.3} {:?} t {:.2} us/step {:.1}",
                b.deflection,
                b.punch / 1e3,
                b.support / 1e3,
                (0.4 * b.punch + 0.6 * b.support) / 1e3,
                known,
                t.elapsed().as_secs_f64(),
                t.elapsed().as_secs_f64() * 1e6 / steps as f64
            );
            break;
        }
    }
}

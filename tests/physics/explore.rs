use meshcast::dem::{fast::*, inertia::StepFactors, plain::*, scene::*, stepper::*};
use meshcast::layout::*;
use meshcast::mesh::laws;
fn cpu() -> f64 {
    let s = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap();
    s.split(' ').next().unwrap().parse::<f64>().unwrap() * 1e-9
}
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
    let c: f64 = a[4].parse().unwrap();
    let g: f64 = a[5].parse().unwrap();
    let factors = StepFactors { translation: c, stretching: 0.8 };
    let path = match a.get(6).map(|s| s.as_str()) {
        Some("2") => Path::Avx2,
        Some("s") => Path::Sse2,
        Some("p") => Path::Portable,
        _ => Path::Avx512,
    };
    let t = cpu();
    let mut s: Box<dyn Stepper> = match a[3].as_str() {
        "uni" => Box::new(Plain::of_scene(
            &scene,
            Inertia::Uniform(0.0039 / 6.222e-6f64.powi(2)),
            Damping::Local(0.5),
        )),
        "plain" => Box::new(Plain::of_scene(&scene, Inertia::Pairs(factors), Damping::Viscous(g))),
        "f32" => Box::new(Fast::<f32>::new(
            &scene,
            FastOptions { factors, damping: g, true_unloading: false, path },
        )),
        "f32t" => Box::new(Fast::<f32>::new(
            &scene,
            FastOptions { factors, damping: g, true_unloading: true, path },
        )),
        "f64" => Box::new(Fast::<f64>::new(
            &scene,
            FastOptions { factors, damping: g, true_unloading: false, path },
        )),
        _ => Box::new(Fast::<f64>::new(
            &scene,
            FastOptions { factors, damping: g, true_unloading: true, path },
        )),
    };
    let setup = cpu() - t;
    let mut known = vec![];
    let blocks = ((0.002 / v / 4.0).round() as usize).max(1);
    let mut steps = 0;
    let mut out = String::new();
    'l: loop {
        let (mut d, mut p, mut q) = (0.0, 0.0, 0.0);
        for _ in 0..blocks {
            let b = s.advance(4, v);
            steps += 4;
            d += b.deflection;
            p += b.punch;
            q += b.support;
            if s.broken(&mut known) > 0 {
                break 'l;
            }
            if s.deflection() > 1.0 {
                break 'l;
            }
        }
        let n = blocks as f64;
        out += &format!("{:.17} {:.17} {:.17}\n", d / n, p / n, q / n);
    }
    let t2 = cpu() - t;
    eprintln!(
        "BREAK {:.5} {:?} setup {:.2} ms total {:.1} ms steps {} us/step {:.2}",
        s.deflection(),
        known,
        setup * 1e3,
        t2 * 1e3,
        steps,
        (t2 - setup) * 1e6 / steps as f64
    );
    eprintln!("{}", out.lines().last().unwrap());
    println!("# {}", s.deflection());
    print!("{}", out);
}

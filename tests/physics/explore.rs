use meshcast::dem::*;
use meshcast::layout::*;
use meshcast::mesh::laws;
unsafe extern "C" {
    fn clock_gettime(id: i32, t: *mut [i64; 2]) -> i32;
}
fn cpu() -> f64 {
    let mut t = [0i64; 2];
    unsafe { clock_gettime(3, &mut t) };
    t[0] as f64 + t[1] as f64 * 1e-9
}
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let which = a[1].as_str();
    let (test, l, wire) = match which {
        "ya" => (Test::Anchored, 3.04, laws::yade()),
        "yl" => (Test::Laboratory, 3.0, laws::yade()),
        "A" => (Test::Anchored, 3.0, laws::bench()),
        "B" => (Test::Laboratory, 3.0, laws::bench()),
        "C" => (Test::Anchored, 4.0, laws::bench()),
        "D" => (Test::Anchored, 2.5, laws::bench()),
        "Rl" => (Test::Laboratory, 3.0, laws::reference()),
        _ => (Test::Anchored, 3.0, laws::reference()),
    };
    let mut layout = Layout { spacing: l, ..REFERENCE };
    if which == "C" {
        layout = Layout { spacing: 4.0, punch: 1.2, plate: 0.4, ex: 2.0, ey: 0.2 };
    }
    if which == "D" {
        layout = Layout { spacing: 2.5, punch: 0.2, plate: 0.32, ex: 0.0, ey: 0.0 };
    }
    let spec = SceneSpec { layout, test, wire, phase: PLAIN_PHASE, seed: 1 };
    let fidelity = match a[2].as_str() {
        "q" => Fidelity::Quick,
        "s" => Fidelity::Standard,
        "f" => Fidelity::Fine,
        _ => Fidelity::Reference,
    };
    let speed = a.get(3).and_then(|x| x.parse().ok());
    let c = Controls { fidelity, speed, after_break: 0.0, ..Controls::default() };
    let mut best = 1e9f64;
    let mut o = None;
    for _ in 0..a.get(4).and_then(|x| x.parse().ok()).unwrap_or(1) {
        let t = cpu();
        o = Some(check(&spec, &c, &mut |_| Flow::Continue).unwrap());
        best = best.min(cpu() - t);
    }
    let (o, t) = (o.unwrap(), best);
    println!(
        "# {} {}",
        o.first_break.map_or(0.0, |p| p.deflection),
        o.first_break.map_or(0.0, |p| p.force)
    );
    for k in 0..o.punch.len() {
        println!("{} {} {}", o.curve.deflection[k], o.punch[k], o.support[k]);
    }
    eprintln!(
        "{which} {} {:?} {:?} k75 {:.1} E {:.0} q {:?} steps {} t {:.1} ms  us/step {:.2}",
        a[2],
        o.stop,
        o.first_break,
        o.k75 / 1e3,
        o.energy,
        o.quality,
        o.cost.steps,
        t * 1e3,
        t * 1e6 / o.cost.steps as f64
    );
}

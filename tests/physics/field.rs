//! Fields of several cells: statics, and what must not depend on how many cells are simulated.

use crate::small;
use meshcast::dem::fast::{Fast, FastOptions, Path};
use meshcast::dem::inertia::{PairInertia, StepFactors};
use meshcast::dem::law::BondCurve;
use meshcast::dem::plain::{Damping, Inertia, Plain, PlainBond, PlainNet};
use meshcast::dem::stepper::Stepper;
use meshcast::dem::{
    Arrangement, Controls, Fidelity, Flow, RunOutcome, Scene, SceneSpec, Test, check,
};
use meshcast::layout::{Grid, Layout, Twists};
use meshcast::mesh::laws;
use meshcast::mesh::wire::{CurvePoint, WireData};

const FACTORS: StepFactors = StepFactors { translation: 1.1, stretching: 0.65 };

/// The small scene with its block well off the centre, 0.1 and -0.15 m of at most 0.35 m.
fn spec(arrangement: Arrangement, wire: WireData) -> SceneSpec {
    let mut spec = small(Test::Anchored, wire);
    (spec.layout.ex, spec.layout.ey) = (0.1, -0.15);
    SceneSpec { arrangement, ..spec }
}

/// The same on a grid of 1.2 x `up` m.
fn on_grid(grid: Grid, arrangement: Arrangement) -> SceneSpec {
    let mut spec = spec(arrangement, laws::reference());
    spec.layout.grid = grid;
    spec
}

/// Spacings of 1.2 and 1.5 m.
const RECTANGLE: Grid = Grid { up: Some(1.5), ..Grid::SQUARE };
const STAGGERED: Grid = Grid { stagger: true, ..RECTANGLE };

const ALL: [Arrangement; 4] = [
    Arrangement::Repeated([1, 1]),
    Arrangement::Repeated([2, 2]),
    Arrangement::Mirrored,
    Arrangement::Single(3),
];

fn run(spec: &SceneSpec) -> RunOutcome {
    let controls = Controls { fidelity: Fidelity::Quick, ..Controls::default() };
    check(spec, &controls, &mut |_| Flow::Continue).unwrap()
}

/// What a run gives, to the bit.
fn bits(run: &RunOutcome) -> Vec<u64> {
    let first = run.first_break.unwrap();
    let curve = run.curve.deflection.iter().chain(&run.curve.force);
    let mut all: Vec<u64> =
        curve.chain(&run.punch).chain(&run.support).map(|x| x.to_bits()).collect();
    all.extend([first.force, first.deflection, run.k75, run.energy].map(f64::to_bits));
    all.push(run.cost.steps as u64);
    all
}

#[test]
fn more_cells_with_the_same_block_in_each_are_one_cell_to_the_bit() {
    let one = run(&spec(Arrangement::default(), laws::bench()));
    for cells in [[2, 1], [1, 2], [2, 2]] {
        let more = run(&spec(Arrangement::Repeated(cells), laws::bench()));
        assert_eq!(bits(&more), bits(&one), "{cells:?}");
        assert_eq!(more.breaks.len(), cells[0] * cells[1] * one.breaks.len());
        assert_eq!(more.anchors.len(), cells[0] * cells[1]);
        for anchor in &more.anchors {
            assert_eq!(anchor.force, one.anchors[0].force, "{cells:?} at {:?}", anchor.place);
        }
        // Each break again in every cell, at the same place in it but for rounding.
        for b in &more.breaks {
            let off = |x: f64, y: f64| (x - y) - 1.2 * ((x - y) / 1.2).round();
            let near = |x: [f64; 2]| off(x[0], b.place[0]).hypot(off(x[1], b.place[1])) < 1e-9;
            assert!(one.breaks.iter().any(|a| near(a.place)), "{b:?}");
        }
    }
}

#[test]
fn one_cell_is_one_cell_whatever_it_is_called() {
    let mut spec = spec(Arrangement::default(), laws::reference());
    let repeated = run(&spec);
    spec.arrangement = Arrangement::Single(1);
    assert_eq!(run(&spec), repeated);
    // A centred block stands where its mirror image does.
    (spec.layout.ex, spec.layout.ey) = (0.0, 0.0);
    let single = run(&spec);
    spec.arrangement = Arrangement::Mirrored;
    assert_eq!(run(&spec), single);
}

#[test]
fn a_field_around_one_block_is_waited_for() {
    // The net of many cells rises together: with the speed and damping of one cell its supports were late,
    // and a quick run of this field had 7 % too little force.
    let mut of = spec(Arrangement::Single(5), laws::reference());
    of.layout = Layout { spacing: 2.0, punch: 0.8, ..of.layout };
    let force = |fidelity| {
        let controls = Controls { fidelity, after_break: 0.0, ..Controls::default() };
        let run = check(&of, &controls, &mut |_| Flow::Continue).unwrap();
        run.first_break.unwrap().force
    };
    let (quick, slow) = (force(Fidelity::Quick), force(Fidelity::Fine));
    println!("quick {quick:.0} N, fine {slow:.0} N");
    assert!((quick / slow - 1.0).abs() < Fidelity::Quick.aim(), "{quick} {slow}");
}

#[test]
fn two_equal_spacings_are_one_to_the_bit() {
    let one = run(&on_grid(Grid::SQUARE, Arrangement::Mirrored));
    let two = run(&on_grid(Grid { up: Some(1.2), ..Grid::SQUARE }, Arrangement::Mirrored));
    assert_eq!(two, one);
    let other = run(&on_grid(RECTANGLE, Arrangement::Mirrored));
    assert_ne!(bits(&other), bits(&one));
    assert_eq!(run(&on_grid(Grid { stagger: false, ..STAGGERED }, Arrangement::Mirrored)), other);
}

#[test]
fn twists_across_a_square_cell_are_the_offsets_exchanged_to_the_bit() {
    for arrangement in ALL {
        let mut down = on_grid(Grid::SQUARE, arrangement);
        let across = on_grid(Grid { twists: Twists::Across, ..Grid::SQUARE }, arrangement);
        (down.layout.ex, down.layout.ey) = (across.layout.ey, across.layout.ex);
        let (down, across) = (run(&down), run(&across));
        assert_eq!(bits(&across), bits(&down), "{arrangement:?}");
        // What has a place or a direction is told in the layout's axes.
        for (a, d) in across.anchors.iter().zip(&down.anchors) {
            assert_eq!((a.place, a.force[2]), ([d.place[1], d.place[0]], d.force[2]));
            assert_eq!(a.force[..2], [d.force[1], d.force[0]]);
        }
        for (a, d) in across.breaks.iter().zip(&down.breaks) {
            assert_eq!((a.number, a.place), (d.number, [d.place[1], d.place[0]]));
        }
    }
}

#[test]
fn on_a_rectangular_grid_across_turns_the_net_and_not_the_layout() {
    // A rectangle turned with its block and its net is the same thing.
    let down = on_grid(RECTANGLE, Arrangement::Mirrored);
    let mut turned = on_grid(RECTANGLE, Arrangement::Mirrored);
    turned.layout.spacing = 1.5;
    turned.layout.grid = Grid { up: Some(1.2), twists: Twists::Across, ..Grid::SQUARE };
    (turned.layout.ex, turned.layout.ey) = (down.layout.ey, down.layout.ex);
    assert_eq!(bits(&run(&turned)), bits(&run(&down)));
    // The net alone turned is another thing.
    let mut net = down.clone();
    net.layout.grid.twists = Twists::Across;
    assert_ne!(bits(&run(&net)), bits(&run(&down)));
}

#[test]
fn anchors_and_blocks_of_a_staggered_grid_stand_where_worked_by_hand() {
    let layout = on_grid(STAGGERED, Arrangement::default()).layout;
    // Spacings 1.2 and 1.5 m: the place farthest from all anchors is 1.44/12 = 0.12 m below the centre.
    let [x, y] = [0.6, 0.75 - 0.12];
    for (x0, y0) in [(0.0, 0.0), (1.2, 0.0), (0.6, 1.5)] {
        let radius = f64::hypot(x - x0, y - y0);
        assert!((radius - 0.87).abs() < 1e-12, "{radius}");
    }
    for twists in [Twists::Down, Twists::Across] {
        let mut spec = on_grid(STAGGERED, Arrangement::default());
        spec.layout.grid.twists = twists;
        let scene = Scene::new(&spec).unwrap();
        let turned = |p: [f64; 2]| if twists == Twists::Down { p } else { [p[1], p[0]] };
        let places: Vec<[f64; 2]> = scene
            .field
            .blocks
            .iter()
            .map(|b| turned([0, 1].map(|k| b.axis[k] + scene.field.cell[k] * b.cell[k] as f64)))
            .collect();
        let due = [[0.7, 0.48], [1.3, 1.98]];
        for (place, due) in places.iter().zip(due) {
            assert!((place[0] - due[0]).hypot(place[1] - due[1]) < 1e-12, "{place:?}");
        }
        assert_eq!((places.len(), scene.field.anchors()), (2, 2));
        let run = run(&spec);
        let anchors: Vec<[f64; 2]> = run.anchors.iter().map(|a| a.place).collect();
        assert_eq!(anchors, [[0.0, 0.0], [0.6, 1.5]], "{twists:?}");
        // The nearest plate is the lower right one, 0.5 and 0.48 m away.
        assert!((layout.distance_to_plate() - 0.375f64.hypot(0.355)).abs() < 1e-12);
    }
}

#[test]
fn the_first_cell_has_its_slack_in_every_field_and_the_others_have_their_own() {
    let one = Scene::new(&spec(Arrangement::default(), laws::reference())).unwrap();
    let (columns, rows) = (one.lattice.columns, one.lattice.rows);
    let number =
        |scene: &Scene, row: usize, column: usize| 3 * (row * scene.lattice.columns + column);
    let mut fields = Vec::new();
    for arrangement in [Arrangement::Mirrored, Arrangement::Single(3), Arrangement::Single(5)] {
        let field = Scene::new(&spec(arrangement, laws::reference())).unwrap();
        for (row, column) in [(0, 0), (3, 5), (rows - 1, columns - 1)] {
            let slack = one.slack(number(&one, row, column));
            assert_eq!(field.slack(number(&field, row, column)), slack);
            assert_ne!(field.slack(number(&field, row, column + columns)), slack);
        }
        fields.push(field);
    }
    // The cell to the left of and below the block's stands at the far end of the periodic field.
    let (three, five) = (&fields[1], &fields[2]);
    let last = |f: &Scene, n: usize| f.slack(number(f, n * rows - 2, n * columns - 3));
    assert_eq!(last(three, 3), last(five, 5));
}

#[test]
fn the_anchors_carry_the_blocks_in_every_arrangement() {
    let across = Grid { twists: Twists::Across, ..STAGGERED };
    let staggered = [STAGGERED, across].into_iter().flat_map(|grid| {
        [Arrangement::default(), Arrangement::Repeated([2, 1]), Arrangement::Single(3)]
            .map(|arrangement| on_grid(grid, arrangement))
    });
    let rectangular = ALL.map(|arrangement| on_grid(RECTANGLE, arrangement));
    let square = ALL.map(|arrangement| spec(arrangement, laws::reference()));
    for spec in square.into_iter().chain(rectangular).chain(staggered) {
        let arrangement = (spec.arrangement, spec.layout.grid);
        let scene = Scene::new(&spec).unwrap();
        let options = FastOptions {
            factors: FACTORS,
            damping: 0.002,
            true_unloading: false,
            fitted: false,
            path: Path::best(),
        };
        let mut fast = Fast::<f64>::new(&scene, options);
        fast.advance(1200, 2.0e-4);
        // Held there until all is at rest.
        fast.advance(30_000, 0.0);
        let block = fast.advance(1, 0.0);
        let anchors = fast.anchors();
        let blocks = scene.field.blocks.len() as f64;
        let carried: f64 = anchors.iter().map(|f| f[2]).sum();
        assert_eq!(anchors.len(), scene.field.anchors());
        println!(
            "{arrangement:?}: {blocks} blocks of {:.3} N, anchors {carried:.3} N",
            block.punch
        );
        assert!(block.punch > 1000.0);
        assert!((carried / (blocks * block.punch) - 1.0).abs() < 1.0e-5, "{carried}");
    }
}

#[test]
fn a_mirrored_block_loads_the_near_anchors_more_and_breaks_the_net_earlier() {
    let repeated = run(&spec(Arrangement::default(), laws::bench()));
    let mirrored = run(&spec(Arrangement::Mirrored, laws::bench()));
    let force = |r: &RunOutcome| r.first_break.unwrap().force;
    let (f, worst) = (force(&mirrored), mirrored.worst_anchor().unwrap());
    println!("repeated {:.0} N, mirrored {f:.0} N, worst anchor {worst:?}", force(&repeated));
    // Blocks stand at +0.1 and -0.15 m: nearest to the anchor between all four, right of and below the
    // first one, which is the second of the first row. (1 + 2 0.1/1.2)(1 + 2 0.15/1.2) F is the bound.
    assert_eq!(worst.place, [1.2, 0.0]);
    let bound = (1.0 + 0.2 / 1.2) * (1.0 + 0.3 / 1.2);
    assert!(worst.force[2] > 1.05 * f && worst.force[2] < bound * f, "{worst:?}");
    // Repeated: every anchor carries the whole force of its cell.
    let own = repeated.anchors[0].force[2];
    assert!((own / force(&repeated) - 1.0).abs() < 0.03, "{own}");
}

#[test]
fn in_full_the_fast_solver_is_the_plain_one_on_every_field() {
    let staggered = [STAGGERED, Grid { twists: Twists::Across, ..STAGGERED }];
    let staggered = staggered.map(|grid| on_grid(grid, Arrangement::default()));
    let square = ALL.map(|arrangement| spec(arrangement, laws::yade()));
    for spec in square.into_iter().chain(staggered) {
        let spec = SceneSpec { wire: laws::yade(), ..spec };
        let arrangement = (spec.arrangement, spec.layout.grid);
        let scene = Scene::new(&spec).unwrap();
        let mut plain = Plain::of_scene(&scene, Inertia::Pairs(FACTORS), Damping::Viscous(0.002));
        let options = FastOptions {
            factors: FACTORS,
            damping: 0.002,
            true_unloading: true,
            fitted: false,
            path: Path::best(),
        };
        let mut fast = Fast::<f64>::new(&scene, options);
        for _ in 0..70 {
            let (a, b) = (plain.advance(12, 2.0e-4), fast.advance(12, 2.0e-4));
            let small = 1.0e-5 * (1.0 + a.punch.abs());
            assert!((a.punch - b.punch).abs() < small, "{arrangement:?}");
            assert!((a.support - b.support).abs() < small);
            for (a, b) in plain.anchors().iter().flatten().zip(fast.anchors().iter().flatten()) {
                assert!((a - b).abs() < small, "{arrangement:?}: {a} {b}");
            }
        }
        assert!(plain.anchors().iter().flatten().any(|f| f.abs() > 10.0));
        let (p, f) = (plain.energies(), fast.energies());
        assert!((p.bonds / f.bonds - 1.0).abs() < 1.0e-6, "{p:?} {f:?}");
        assert!((p.kinetic / f.kinetic - 1.0).abs() < 1.0e-3, "{p:?} {f:?}");
        // The plain solver tells that of the last step, the fast one that of now: a thousandth of its way on.
        assert!((p.contact / f.contact - 1.0).abs() < 0.1, "{p:?} {f:?}");
    }
}

#[test]
fn a_block_on_the_line_is_one_for_two_cells() {
    let mut spec = spec(Arrangement::Mirrored, laws::bench());
    (spec.layout.ex, spec.layout.ey) = (0.6, 0.0);
    let mirrored = run(&spec);
    assert_eq!(mirrored.anchors.len(), 2);
    let carried: f64 = mirrored.anchors.iter().map(|a| a.force[2]).sum();
    let force = mirrored.first_break.unwrap().force;
    // Two anchors carry the one block, half the load for each cell.
    assert!((carried / force - 1.0).abs() < 0.03, "{carried} {force}");
    spec.layout.ex = 0.5;
    let refused = Scene::new(&spec).unwrap_err();
    assert!(refused[0].field == "ex" && refused[0].to_string().contains("overlap"), "{refused:?}");
}

/// A closed rope of elastic bonds, straight along x, over two spans of 1 m with an anchor at 0 and at 1 m
/// and a vertical load at 0.5 + `e` and at 1.5 - `e` m: the mirrored field of a net that is a rope.
fn rope(e: f64) -> (f64, [f64; 3], [f64; 3]) {
    let n = 40;
    let stiff = 1000.0;
    let curve = BondCurve::new(&[CurvePoint(1.0, stiff)], 1.0e-6, 1.0);
    let span = 2.0 / n as f64;
    let bonds = (0..n).map(|a| PlainBond {
        a,
        b: (a + 1) % n,
        rest: [span, 0.0, 0.0],
        taut: span,
        ramp: curve.full(0.0),
        curve: 0,
        number: a,
    });
    let fixed: Vec<bool> = (0..n).map(|k| k % (n / 2) == 0).collect();
    let own = |k: usize| if fixed[k] { 0.0 } else { 1.0 / (4.0 * stiff * n as f64) };
    let net = PlainNet {
        places: (0..n).map(|k| [span * k as f64, 0.0, 0.0]).collect(),
        inertia: (0..n / 2)
            .map(|p| PairInertia { own: [own(2 * p), own(2 * p + 1)], cross: 0.0 })
            .collect(),
        bonds: bonds.collect(),
        curves: vec![curve],
        fixed,
    };
    let mut plain = Plain::new(net, Damping::Viscous(0.01));
    let at = ((0.5 + e) / span).round() as usize;
    plain.load[at] = [0.0, 0.0, 20.0];
    plain.load[n - at] = [0.0, 0.0, 20.0];
    for _ in 0..60_000 {
        plain.step(0.0);
    }
    // What the bonds beside an anchor pull it by, from where the nodes came to rest.
    let pull = |anchor: usize| {
        [1, n - 1].map(|side| {
            let other = (anchor + side) % n;
            let u = plain.moved[other];
            let along = if side == 1 { span + u[0] } else { -span + u[0] };
            let length = along.hypot(u[2]);
            let force = stiff * (length / span - 1.0);
            [force * along / length, force * u[2] / length]
        })
    };
    let total = |anchor: usize| {
        let [a, b] = pull(anchor);
        [a[0] + b[0], 0.0, a[1] + b[1]]
    };
    // Where the load now hangs, from the first anchor.
    (span * at as f64 + plain.moved[at][0], total(0), total(n / 2))
}

#[test]
fn mirrored_blocks_on_a_rope_share_their_loads_by_the_lever() {
    for e in [0.0, 0.1, 0.25, 0.35] {
        let (x, far, near) = rope(e);
        // Moments about the other anchor, span by span: from each side the far one has 1 - x of a load
        // and the near one x, which is (1 -+ 2 e) of it in all but for the way the load moved along.
        assert!((far[2] / 20.0 - 2.0 * (1.0 - x)).abs() < 1e-6, "{e}: {far:?}, load at {x}");
        assert!((near[2] / 20.0 - 2.0 * x).abs() < 1e-6, "{e}: {near:?}, load at {x}");
        assert!((far[2] + near[2] - 40.0).abs() < 1e-6);
        assert!(near[0].abs() < 1e-6 && far[0].abs() < 1e-6, "{near:?} {far:?}");
        // The stiffer short side draws the load a little nearer.
        assert!(x >= 0.5 + e - 1e-9 && x < 0.5 + e + 0.02, "{e}: {x}");
    }
}

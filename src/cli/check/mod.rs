//! `meshcast check`: the punch test by discrete elements, beside the forecast, without a screen.
//!
//! - [`flags`]: what may be asked on the command line, and at which flag a value is wrong.
//! - [`remarks`]: what a result has to say about itself.
//! - [`json`], [`csv`], [`text`] with its [`chart`]: the forms of the result.

mod chart;
mod csv;
mod flags;
mod json;
mod pull;
mod remarks;
mod text;

pub(crate) use flags::CheckArgs;
pub(super) use flags::{runs, threads};

use super::case::{Inputs, NamedCase};
use super::opening::load_project;
use super::output::{CommandEnd, Fault, Output, say};
use super::watch::Watch;
use super::wire::Wires;
use super::{UiFlags, VERSION};
use crate::case::{Case, expected_break};
use crate::curve::Point;
use crate::dem::{Arrangement, Controls, Fidelity, PLAIN_PHASE, Scene, SceneSpec, Stop, Test};
use crate::fingerprint::Fingerprint;
use crate::forecast::{Field, NoField, Strength, laboratory};
use crate::mesh::STANDARD_PUNCH;
use crate::problem::Problem;
use crate::study::blocks::{self, Stood};
use crate::study::ensemble::{Ensemble, Plan, Run};
use crate::study::exactness::Exactness;
use crate::study::inputs::of_ensemble;
use crate::study::paired;
use crate::study::remark::CheckRemark;
use crate::study::result::remade::Former;
use crate::study::result::sampled::{Catch, catches, characteristic};
use crate::study::result::{CheckResult, Wanted, WorstAnchor, worst_anchor};
use crate::study::verdict::{Basis, Finding, Forecasted, Simulated, Verdict, verdict};
use crate::words::Choice;
use std::sync::Arc;

/// One case with its check.
#[derive(Debug)]
struct Checked {
    name: Option<String>,
    case: Case,
    spec: SceneSpec,
    controls: Controls,
    plan: Plan,
    /// The ensemble of the arrangement that decides.
    ensemble: Ensemble,
    /// That arrangement, and in words.
    arrangement: Arrangement,
    words: String,
    /// What else was simulated, with higher forces.
    others: Vec<Stood>,
    /// Factors by which the net was stretched in x and y to meet the panel.
    stretch: [f64; 2],
    forecast: Forecast,
    fingerprint: Fingerprint,
    remarks: Vec<CheckRemark>,
    /// Whether it is enough, where anything is asked of the anchored panel.
    verdict: Option<Verdict>,
    /// What another solver or sampling had found, where the project keeps that.
    former: Option<Former>,
}

impl Checked {
    /// How many runs are in the mean: those with a first break.
    fn broken(&self) -> usize {
        let good = |run: &&Run| run.outcome.stop != Stop::Diverged;
        self.ensemble.runs.iter().filter(good).filter(|r| r.outcome.first_break.is_some()).count()
    }

    /// What was asked of its runs.
    fn exactness(&self) -> Exactness {
        if self.plan.auto { Exactness::Auto } else { self.controls.fidelity.into() }
    }

    fn fidelity_word(&self) -> &'static str {
        self.exactness().word()
    }

    /// The fidelity of each run, where the ensemble does not choose it.
    pub(super) fn run_fidelity(&self) -> Option<Fidelity> {
        paired::run_fidelity(&self.controls, &self.plan)
    }

    /// The same with what was made of it.
    fn fidelity_said(&self) -> String {
        let word = self.fidelity_word();
        match self.ensemble.bias {
            Some(b) => {
                let again = match b.pairs {
                    0 => String::new(),
                    n => format!(", {n} again at standard"),
                };
                let [force, deflection] = b.factors.map(|v| 100.0 * (v - 1.0));
                let known = 100.0 * b.errors[0];
                format!(
                    "{word} (quick runs{again}; bias F {force:+.2} % to {known:.1} %, delta {deflection:+.2} %)"
                )
            }
            None if self.plan.auto => format!("{word} ({} runs)", self.controls.fidelity.word()),
            None => word.into(),
        }
    }

    /// Whether it is the test with anchors.
    fn test_is_anchored(&self) -> bool {
        self.spec.test == Test::Anchored
    }

    /// The worst anchor of the runs that count.
    fn anchor(&self) -> Option<WorstAnchor> {
        worst_anchor(&self.ensemble)
    }

    /// The force at the first break that 5 % fall below, N.
    fn characteristic(&self) -> Option<f64> {
        let anchored = self.test_is_anchored();
        characteristic(&self.ensemble, self.counted()).filter(|_| anchored)
    }

    /// On how much of the slope a plate catches how many nodes.
    fn catches(&self) -> Vec<Catch> {
        catches(&self.ensemble)
    }

    /// The mean first break, N and m.
    fn mean_break(&self) -> Option<Point> {
        let (force, deflection) = (self.ensemble.force.mean, self.ensemble.deflection.mean);
        (self.broken() > 0).then_some(Point { deflection, force })
    }

    /// How many anchors carry 90 % of the force, of each run with a break.
    fn carrying(&self) -> Vec<usize> {
        let broke = self.ensemble.runs.iter().filter(|r| r.outcome.first_break.is_some());
        broke.map(|run| run.outcome.anchors_carrying(0.9)).collect()
    }

    /// How many runs are in the band and the mean peak: all that came to an end of their own.
    fn counted(&self) -> usize {
        let unfinished =
            |run: &Run| run.outcome.stop == Stop::Cancelled && run.outcome.first_break.is_none();
        let good = |run: &&Run| run.outcome.stop != Stop::Diverged && !unfinished(run);
        self.ensemble.runs.iter().filter(good).count()
    }
}

/// The forecast that a check is held against.
#[derive(Debug, Clone, Copy, Default)]
struct Forecast {
    /// Force and deflection at failure, where the method has them.
    values: Option<Strength>,
    /// The whole curve, of the anchored test.
    field: Option<Field>,
    /// Why the anchored panel has none.
    outside: Option<NoField>,
    /// Whether there is none because the wires are of another net than the mesh.
    other_net: bool,
}

/// A case ready to be run, with what it will be run as.
struct Ready {
    name: Option<String>,
    case: Case,
    spec: SceneSpec,
    controls: Controls,
    plan: Plan,
    stretch: [f64; 2],
    forecast: Forecast,
    former: Option<Former>,
}

/// Runs the checks and writes the result in the form asked for.
pub(crate) fn run(args: &CheckArgs, ui: &UiFlags) -> CommandEnd {
    if let Some(pull) = args.pull {
        return pull::run(args, pull);
    }
    let mut units = ui.units_over(crate::units::Units::default());
    let inputs = Inputs::of_check(args.geometry.clone(), args.question.clone());
    let mut basis = Basis::default();
    let cases = match &args.project {
        None => vec![inputs.alone()?],
        Some(path) => {
            let opened = load_project(path)?;
            basis = opened.project.basis;
            units = ui.units_over(opened.project.display.units);
            inputs.of_project(&opened.project, args.layout.as_deref())?
        }
    };
    let basis = args.verdict.basis(basis);
    let several = args.project.is_some() && args.layout.is_none();
    let wires = Wires::read(args.mesh_file.as_deref(), args.law.as_deref())?;
    let mut notes = Vec::new();
    let (mut ready, mut left_out) = (Vec::new(), Vec::new());
    let asked = cases.len();
    for case in cases {
        let name = case.name.clone();
        let asked_of = case.case.clone();
        match (prepare(args, &inputs, &wires, case), name) {
            (Ok(one), _) => ready.push(one),
            // One layout of many that cannot be checked is no reason not to check the others.
            (Err(Fault::Input(found)), Some(name)) if several && asked > 1 => {
                notes.extend(found.iter().map(|f| format!("layout {name:?} is left out: {f}")));
                let unjudged = Forecasted::none("it cannot be checked");
                left_out.push(verdict(&asked_of, unjudged, Simulated::Missing, basis));
            }
            (Err(fault), _) => return Err(fault),
        }
    }
    if ready.is_empty() && !notes.is_empty() {
        return Err(Fault::Input(notes));
    }
    notes.iter().for_each(|note| say("note", note));
    let (checked, interrupted) = check_all(ready, basis)?;
    let result = args.format.write(
        || text::report(&checked, units),
        || json::report(&checked, several),
        || csv::report(&checked, several),
    )?;
    // A check of which no run came to an end is no answer.
    let failed = !interrupted && checked.iter().any(|c| c.counted() == 0);
    let verdict =
        args.verdict.code(checked.iter().filter_map(|c| c.verdict.as_ref()).chain(&left_out));
    Ok(Output { result, failed, verdict, interrupted, ..Output::default() })
}

impl CheckArgs {
    /// The scene of one run of the layout that the flags give.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub(in crate::cli) fn scene(&self) -> Result<SceneSpec, Fault> {
        let inputs = Inputs::of_check(self.geometry.clone(), self.question.clone());
        let wires = Wires::read(self.mesh_file.as_deref(), self.law.as_deref())?;
        let case = inputs.alone()?;
        Ok(prepare(self, &inputs, &wires, case)?.spec)
    }
}

/// Finds all that can be wrong before anything is run.
fn prepare(
    args: &CheckArgs,
    inputs: &Inputs,
    wires: &Wires,
    NamedCase { name, mut case, check }: NamedCase,
) -> Result<Ready, Fault> {
    let other_net = wires.other_net(&case.mesh);
    let plan = args.plan();
    let spec = SceneSpec {
        layout: case.layout,
        test: args.test,
        wire: wires.for_mesh(&case.mesh)?,
        phase: plan.phase.unwrap_or(PLAIN_PHASE),
        seed: plan.seed,
        arrangement: first_arrangement(&case, args.test),
    };
    let controls = args.controls()?;
    let placed = |found: Vec<Problem>| {
        let found = found.into_iter().map(|p| p.renamed(flags::CONTROL_FLAGS)).collect();
        inputs.placed(found, name.as_deref())
    };
    let scene = Scene::new(&spec).map_err(placed)?;
    controls.scheme(&scene).map_err(placed)?;
    let mut forecast = forecast_of(&case, args.test)?;
    if let Some(mesh) = other_net {
        // The laboratory record is the other mesh's, and so would the forecast be.
        forecast = Forecast { other_net: true, ..Forecast::default() };
        case.mesh = Arc::new(mesh);
    }
    let former = Former::of(check.as_ref(), &case).filter(|_| args.test == Test::Anchored);
    let stretch = case.layout.turned(scene.lattice.stretch);
    Ok(Ready { name, case, spec, controls, plan, stretch, forecast, former })
}

/// The first arrangement that is simulated, with which all that can be wrong is found.
fn first_arrangement(case: &Case, test: Test) -> Arrangement {
    let first = blocks::arrangements(&case.layout).into_iter().next();
    first.filter(|_| test == Test::Anchored).unwrap_or_default()
}

/// The closed form of the same test: the field values, or Eqs. 1-2 for a panel with the standard
/// punch at its centre.
fn forecast_of(case: &Case, test: Test) -> Result<Forecast, Fault> {
    let (layout, f) = (&case.layout, case.forecast()?);
    let none = Forecast { outside: f.field.err(), ..Forecast::default() };
    Ok(match test {
        Test::Anchored => {
            let field = f.field.ok();
            Forecast { values: field.map(|field| field.values), field, ..none }
        }
        Test::Laboratory => {
            let covered = layout.punch == STANDARD_PUNCH && (layout.ex, layout.ey) == (0.0, 0.0);
            let values = covered.then(|| laboratory::to_panel(f.laboratory, layout.spacing));
            Forecast { values, ..none }
        }
    })
}

/// The verdict by the check beside the forecast; nothing where nothing is asked, and of a laboratory
/// test, which is no panel on a slope.
fn judged(c: &Checked, basis: Basis) -> Option<Verdict> {
    if !c.test_is_anchored() {
        return None;
    }
    let Plan { runs, seed, .. } = c.plan;
    let fidelity = c.run_fidelity().map_or(Exactness::Auto, Exactness::from);
    let wanted = Wanted { fidelity, runs, seed };
    let result = CheckResult::from_ensemble(&c.ensemble, &wanted, c.fingerprint);
    let forecast = match c.forecast.other_net {
        true => Forecasted::none("the forecast is of another net"),
        false => Forecasted::from(&c.case.derive()),
    };
    let found = verdict(&c.case, forecast, Simulated::Current(&result), basis);
    (found.finding() != Finding::NotAsked).then_some(found)
}

/// Runs them one after the other; tells if the user ended it early. What was not begun by then is
/// left out.
fn check_all(ready: Vec<Ready>, basis: Basis) -> Result<(Vec<Checked>, bool), Fault> {
    let watch = Watch::start();
    let parts = ready.len();
    let mut checked: Vec<Checked> = Vec::new();
    for (part, one) in ready.into_iter().enumerate() {
        if watch.cancelled() && part > 0 {
            say("note", &format!("{} of {parts} layouts were not begun", parts - part));
            break;
        }
        let Ready { name, case, spec, controls, plan, stretch, forecast, former } = one;
        let label = match &name {
            Some(name) if parts > 1 => format!("layout {name:?} ({} of {parts})", part + 1),
            _ => "check".to_string(),
        };
        // Until the first run has ended, its end is expected where the forecast has it.
        let guess = expected_break(&spec.layout, forecast.values);
        watch.begin(&label, part, parts, guess + controls.after_break);
        let tell = |now| watch.tell(now);
        let mut made = blocks::run(&spec, &controls, &plan, &tell, &|_, _| {})?.into_iter();
        let Some(stood) = made.next() else { continue };
        let (words, arrangement, ensemble) = (stood.words(), stood.arrangement, stood.ensemble);
        let fingerprint = of_ensemble(&spec, &controls, &plan);
        let mut one = Checked {
            name,
            case,
            spec,
            controls,
            plan,
            ensemble,
            arrangement,
            words,
            others: made.collect(),
            stretch,
            forecast,
            fingerprint,
            remarks: Vec::new(),
            verdict: None,
            former,
        };
        one.remarks = remarks::of(&one);
        one.verdict = judged(&one, basis);
        checked.push(one);
    }
    let runs: usize = checked.iter().map(|c| c.ensemble.runs.len()).sum();
    watch.finish(&format!("{runs} {}", if runs == 1 { "run" } else { "runs" }));
    Ok((checked, watch.cancelled()))
}

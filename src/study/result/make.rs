//! Making a result: the anchored test of a layout, watched from outside.

use super::relief::Relief;
use super::{CheckResult, Wanted};
use crate::dem::{Arrangement, Flow, PLAIN_PHASE, Scene, SceneSpec, Test};
use crate::fingerprint::Fingerprint;
use crate::layout::{Blocks, Layout};
use crate::mesh::MeshType;
use crate::mesh::wire::WireData;
use crate::problem::Problem;
use crate::study::blocks;
use crate::study::ensemble::{EnsembleProgress, Run};
use crate::study::inputs::of_ensemble;
use crate::study::sampling::Sample;

/// What a check tells while it runs.
#[derive(Debug, Clone, Copy)]
pub enum Told<'a> {
    /// How far it has come.
    Progress(EnsembleProgress),
    /// A run, by its number, has ended.
    Finished(usize, &'a Run),
}

/// A result with the shape of the net, which is not kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// The figures, as the project keeps them.
    pub result: CheckResult,
    /// The net at the first break of the first run.
    pub relief: Option<Relief>,
}

/// The anchored test of a layout.
fn spec(layout: &Layout, wire: &WireData, wanted: &Wanted) -> SceneSpec {
    SceneSpec {
        layout: *layout,
        test: Test::Anchored,
        wire: wire.clone(),
        phase: PLAIN_PHASE,
        seed: wanted.seed,
        arrangement: Arrangement::default(),
    }
}

/// The wires of a mesh.
///
/// # Errors
/// The mesh has none.
pub fn wires(mesh: &MeshType) -> Result<&WireData, Vec<Problem>> {
    mesh.wire.as_ref().ok_or_else(|| {
        vec![
            Problem::new("mesh", "this mesh has no wire data, which the check needs")
                .value(mesh.id.clone())
                .advice("add them to the mesh, or pick the reference mesh"),
        ]
    })
}

/// Fingerprint of all inputs of a layout's check.
pub fn fingerprint(layout: &Layout, wire: &WireData, wanted: &Wanted) -> Fingerprint {
    of_ensemble(&spec(layout, wire, wanted), &wanted.controls(), &wanted.plan(1))
}

/// Where the runs of a layout's check stand, of each arrangement that it simulates.
///
/// # Errors
/// What is wrong with the layout or its wires.
pub(crate) fn samples(
    layout: &Layout,
    wire: &WireData,
    wanted: &Wanted,
) -> Result<Vec<Sample>, Vec<Problem>> {
    let spec = spec(layout, wire, wanted);
    let arrangements = blocks::arrangements(layout).into_iter();
    let of = |arrangement| {
        let scene = Scene::new(&SceneSpec { arrangement, ..spec.clone() })?;
        Ok(Sample::of(&scene, &wanted.plan(1)))
    };
    arrangements.map(of).collect()
}

/// Checks a layout. `tell` is called from several threads and may end it; what is done by then is kept.
///
/// # Errors
/// What is wrong with the layout or its wires.
pub fn make(
    layout: &Layout,
    mesh: &MeshType,
    wanted: &Wanted,
    threads: usize,
    tell: &(dyn Fn(Told) -> Flow + Sync),
) -> Result<Made, Vec<Problem>> {
    let spec = spec(layout, wires(mesh)?, wanted);
    let (controls, plan) = (wanted.controls(), wanted.plan(threads));
    let finished = |k: usize, run: &Run| {
        tell(Told::Finished(k, run));
    };
    let progress = |now: EnsembleProgress| tell(Told::Progress(now));
    let made = blocks::run(&spec, &controls, &plan, &progress, &finished)?;
    // There is one arrangement at least: the list that is run is never empty.
    let Some(stood) = made.into_iter().next() else {
        return Err(vec![Problem::new("blocks", "there is nothing to simulate")]);
    };
    let (words, ensemble) = (stood.words(), stood.ensemble);
    let first = ensemble.runs.first().and_then(|run| run.outcome.net.as_ref());
    let relief = first.map(|net| Relief::from_net(net, layout));
    let inputs = of_ensemble(&spec, &controls, &plan);
    let mut result = CheckResult::from_ensemble(&ensemble, wanted, inputs);
    let plain = matches!(layout.blocks, Blocks::Paper | Blocks::Repeated);
    result.field.arrangement = (!plain).then_some(words);
    Ok(Made { result, relief })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;
    use crate::mesh::catalogue;
    use crate::mesh::wire::CurvePoint;
    use crate::study::exactness::Exactness;
    use crate::units::to_kn;

    #[test]
    fn a_result_ends_where_its_mean_first_break_is() {
        let layout = Layout { spacing: 1.5, punch: 0.5, ..REFERENCE };
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(3), seed: 1 };
        let mesh = catalogue::reference();
        let seen = std::sync::Mutex::new(Vec::new());
        let made = make(&layout, &mesh, &wanted, 2, &|told| {
            if let Told::Finished(k, _) = told {
                seen.lock().unwrap().push(k);
            }
            Flow::Continue
        })
        .unwrap();
        let mut seen = seen.into_inner().unwrap();
        seen.sort_unstable();
        assert_eq!(seen, [0, 1, 2]);
        let v = &made.result;
        assert_eq!((v.runs, v.breaks.len(), v.slipped), (3, 3, 0));
        assert!(v.curve.deflection.len() <= super::super::mean::POINTS);
        assert!(v.curve.deflection.windows(2).all(|w| w[0] < w[1]));
        let end = v.curve.failure.unwrap();
        // Two means of the same numbers, each rounded to five digits: one unit of the last.
        assert!((to_kn(end.force) / to_kn(v.force.mean) - 1.0).abs() < 1e-4);
        assert!((end.deflection / v.deflection.mean - 1.0).abs() < 1e-4);
        assert!((v.band[1].last().unwrap() / v.force.band[1] - 1.0).abs() < 1e-4);
        assert_eq!(v.inputs, fingerprint(&layout, wires(&mesh).unwrap(), &wanted));
        assert!(v.current(v.inputs) && !v.partial());
        let relief = made.relief.unwrap();
        // The punch is at the centre, and it is the highest place.
        assert!((relief.at(0.0, 0.0) - relief.highest).abs() < 0.1 * relief.highest);
        assert!(relief.at(0.7, 0.7) < 0.1 * relief.highest, "the corner is held");
    }

    #[test]
    fn the_prints_of_checks_in_users_files_stay_as_they_are() {
        // From files that are out, under the wires that the catalogue had then: new inputs must add nothing to
        // these (see `crate::fingerprint`).
        let curve = |points: &[(f64, f64)]| points.iter().map(|p| CurvePoint(p.0, p.1)).collect();
        let mut wire = catalogue::reference().wire.clone().unwrap();
        wire.single = curve(&[
            (0.001918632, 249.4192),
            (0.009543139, 321.2021),
            (0.02312759, 382.0304),
            (0.06723295, 511.0001),
            (0.1113383, 557.2424),
            (0.133391, 564.5355),
            (0.1554437, 564.5355),
        ]);
        wire.double_twist = curve(&[
            (0.001285484, 167.1109),
            (0.00503625, 215.2054),
            (0.01047003, 255.9604),
            (0.02811218, 342.3701),
            (0.04575432, 373.3524),
            (0.05457539, 378.2388),
            (0.06339646, 378.2388),
        ]);
        wire.distortion.lambda_u = 0.03;
        let wanted = Wanted { fidelity: Exactness::Quick, runs: Some(2), seed: 0 };
        let centred =
            Layout { plate: 0.25, spacing: 1.5, punch: 0.5, ex: 0.0, ey: 0.0, ..REFERENCE };
        let eccentric = Layout { spacing: 1.6, ex: 0.3, ey: 0.2, ..centred };
        for (layout, print) in [(centred, "28a5ca5d22413d32"), (eccentric, "980cac6d0df6e3b9")] {
            let now = fingerprint(&layout, &wire, &wanted);
            assert_eq!(now.to_string(), print);
        }
    }

    #[test]
    fn a_check_that_is_ended_at_once_has_nothing() {
        let wanted = Wanted { runs: Some(2), ..Wanted::default() };
        let made =
            make(&REFERENCE, &catalogue::reference(), &wanted, 1, &|_| Flow::Cancel).unwrap();
        assert!(made.result.partial() && !made.result.broke() && made.result.runs == 0);
        assert!(made.result.curve.deflection.is_empty());
    }
}

//! Error against each numerical knob, with the observed order, and against the quality figures.

use super::bench::{errors, scene};
use crate::dem::fast::{Fast, FastOptions, Path};
use crate::dem::run::drive;
use crate::dem::{Controls, Fidelity, Flow, Outcome, Scene, SceneSpec, check};
use crate::problem::Problem;
use serde::Serialize;

/// One row of a table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// Scene.
    pub scene: String,
    /// Which knob: `speed`, `step`, `damping`, `precision`, `unloading`.
    pub knob: String,
    /// Its value: punch travel per step in m, step factor, part of velocity lost per step; for
    /// precision and unloading 1 for the shortcut.
    pub value: f64,
    /// Errors, %.
    #[serde(rename = "F_error_pct")]
    pub force: f64,
    /// Errors, %.
    #[serde(rename = "delta_error_pct")]
    pub deflection: f64,
    /// Errors, %.
    #[serde(rename = "curve_error_pct")]
    pub curve: f64,
    /// Observed order of the curve's error from the row before, where there is one.
    pub order: Option<f64>,
    /// Error estimate of the run itself, %.
    #[serde(rename = "error_estimate_pct")]
    pub estimate: f64,
    /// Largest kinetic over internal energy.
    pub kinetic_over_internal: f64,
}

/// The tables of the scenes named. `tell` is told what is being run.
///
/// # Errors
/// What is wrong with a scene.
pub fn tables(names: &[&str], tell: &mut dyn FnMut(&str)) -> Result<Vec<Row>, Vec<Problem>> {
    let mut rows: Vec<Row> = Vec::new();
    let base = Controls { after_break: 0.0, ..Controls::default() };
    for name in names {
        let Some(spec) = scene(name) else { continue };
        tell(&format!("scene {name}: reference"));
        let exact = Controls { fidelity: Fidelity::Reference, ..base.clone() };
        let reference = check(&spec, &exact, &mut |_| Flow::Continue)?;
        let mut push = |knob: &str, value: f64, outcome: &Outcome, steps: bool| {
            let Some(e) = errors(outcome, &reference) else { return };
            let before = rows.last().filter(|r| steps && r.knob == knob && r.scene == *name);
            let order = before.map(|r| (r.curve / (100.0 * e.curve)).ln() / (r.value / value).ln());
            rows.push(Row {
                scene: name.to_string(),
                knob: knob.to_string(),
                value,
                force: 100.0 * e.force,
                deflection: 100.0 * e.deflection,
                curve: 100.0 * e.curve,
                order,
                estimate: 100.0 * outcome.quality.error_estimate,
                kinetic_over_internal: outcome.quality.kinetic_over_internal,
            });
        };
        tell(&format!("scene {name}: speed, step, damping"));
        for speed in [4.0e-4, 2.0e-4, 1.0e-4, 5.0e-5, 2.5e-5] {
            let c = Controls { speed: Some(speed), ..base.clone() };
            push("speed", speed, &check(&spec, &c, &mut |_| Flow::Continue)?, true);
        }
        for step in [1.0, 0.8, 0.6, 0.4] {
            let c = Controls { step_factor: step, speed: Some(1.0e-4), ..base.clone() };
            push("step", step, &check(&spec, &c, &mut |_| Flow::Continue)?, true);
        }
        for damping in [0.008, 0.004, 0.002, 0.001] {
            let c = Controls { damping: Some(damping), speed: Some(1.0e-4), ..base.clone() };
            push("damping", damping, &check(&spec, &c, &mut |_| Flow::Continue)?, true);
        }
        tell(&format!("scene {name}: precision and unloading"));
        push("precision", 1.0, &with(&spec, false, false, 2.5e-5)?, false);
        push("precision", 0.0, &with(&spec, true, false, 2.5e-5)?, false);
        push("unloading", 1.0, &with(&spec, true, false, 1.0e-5)?, false);
        push("unloading", 0.0, &with(&spec, true, true, 1.0e-5)?, false);
    }
    Ok(rows)
}

/// A run in this precision and with this unloading at this speed.
fn with(
    spec: &SceneSpec,
    double: bool,
    true_unloading: bool,
    travel: f64,
) -> Result<Outcome, Vec<Problem>> {
    let scene = Scene::new(spec)?;
    let controls = Controls { after_break: 0.0, ..Controls::default() };
    let mut scheme = controls.scheme(&scene)?;
    scheme.travel = travel;
    scheme.factors.translation = 1.0;
    let options = FastOptions {
        factors: scheme.factors,
        damping: scheme.damping,
        true_unloading,
        path: Path::best(),
    };
    let mut go = |_| Flow::Continue;
    Ok(if double {
        drive(&scene, &mut Fast::<f64>::new(&scene, options), &scheme, &controls, &mut go)
    } else {
        drive(&scene, &mut Fast::<f32>::new(&scene, options), &scheme, &controls, &mut go)
    })
}

//! A layout of a project with its forecast and its design answer, ready to be written.

use crate::fingerprint::Fingerprint;
use crate::forecast::design::{Answer, Question, answer};
use crate::forecast::fingerprint::of_inputs;
use crate::forecast::{Forecast, forecast};
use crate::mesh::MeshType;
use crate::problem::Problem;
use crate::project::{NamedLayout, Project};
use std::sync::Arc;

/// One layout and what follows from it.
#[derive(Debug, Clone)]
pub struct Case {
    /// The layout as it stands in the project.
    pub entry: NamedLayout,
    /// Its mesh.
    pub mesh: Arc<MeshType>,
    /// Its forecast.
    pub forecast: Forecast,
    /// What is asked of it.
    pub question: Question,
    /// The answer; missing where nothing is asked or there is no field value.
    pub design: Option<Answer>,
    /// Fingerprint of the forecast's inputs, the same as in the result of `meshcast forecast`.
    pub fingerprint: Fingerprint,
}

impl Case {
    /// The case of one layout of a project.
    ///
    /// # Errors
    /// What makes no sense, by its place in the layout of that name.
    pub(crate) fn of(project: &Project, entry: &NamedLayout) -> Result<Case, Vec<Problem>> {
        let placed = |found: Vec<Problem>| -> Vec<Problem> {
            let place = format!("layout {:?}", entry.name);
            found.into_iter().map(|p| p.under(&place)).collect()
        };
        entry.check().map_err(placed)?;
        let Some(mesh) = project.mesh(entry) else {
            return Err(placed(vec![
                Problem::new("mesh", "the project and the catalogue have no such mesh")
                    .value(format!("{:?}", entry.mesh)),
            ]));
        };
        let question = Question {
            force: entry.design_force,
            deflection: entry.allowable_deflection,
            gamma_resistance: entry.gamma_resistance,
            gamma_load: entry.gamma_load,
        };
        let layout = entry.layout();
        let forecast = forecast(&layout, &mesh, entry.branch).map_err(placed)?;
        let asked = question != Question::default();
        let design = forecast.field.filter(|_| asked).map(|field| answer(&field, &question));
        let fingerprint = of_inputs(&layout, &mesh, entry.branch);
        Ok(Case { entry: entry.clone(), mesh, forecast, question, design, fingerprint })
    }
}

/// The cases of all layouts of a project, in its order.
///
/// # Errors
/// Everything that makes no sense, by layout.
pub fn cases(project: &Project) -> Result<Vec<Case>, Vec<Problem>> {
    let (mut good, mut bad) = (Vec::new(), Vec::new());
    for entry in &project.layouts {
        match Case::of(project, entry) {
            Ok(case) => good.push(case),
            Err(found) => bad.extend(found),
        }
    }
    if bad.is_empty() { Ok(good) } else { Err(bad) }
}

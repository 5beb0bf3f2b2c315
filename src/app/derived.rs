//! What follows from a project's inputs: forecast and design answer of every layout.

use crate::forecast::design::{self, Answer, Question};
use crate::forecast::{Forecast, forecast};
use crate::mesh::MeshType;
use crate::problem::Problem;
use crate::project::schema::{NamedLayout, Project};
use std::sync::Arc;

/// The results of one layout.
#[derive(Debug, Clone)]
pub struct Derived {
    /// The mesh, if the project or the catalogue has it.
    pub mesh: Option<Arc<MeshType>>,
    /// The forecast, or what is wrong with the inputs.
    pub forecast: Result<Forecast, Vec<Problem>>,
    /// The answer to the layout's design question; missing without a field value.
    pub design: Option<Answer>,
}

impl Derived {
    /// The forecast, if the inputs are sound.
    pub fn forecast(&self) -> Option<&Forecast> {
        self.forecast.as_ref().ok()
    }
}

/// The design question of a layout.
pub(crate) fn question(layout: &NamedLayout) -> Question {
    Question {
        force: layout.design_force,
        deflection: layout.allowable_deflection,
        gamma_resistance: layout.gamma_resistance,
        gamma_load: layout.gamma_load,
    }
}

/// The results of one layout of a project.
pub(crate) fn one(project: &Project, layout: &NamedLayout) -> Derived {
    let mesh = project.mesh(layout);
    let result = match &mesh {
        Some(mesh) => forecast(&layout.layout(), mesh, layout.branch),
        None => Err(vec![
            Problem::new("mesh", "the project and the catalogue have no such mesh")
                .value(layout.mesh.clone()),
        ]),
    };
    let field = result.as_ref().ok().and_then(|f| f.field);
    Derived { design: field.map(|f| design::answer(&f, &question(layout))), mesh, forecast: result }
}

/// The results of all layouts of a project, in order.
pub(crate) fn all(project: &Project) -> Vec<Derived> {
    project.layouts.iter().map(|layout| one(project, layout)).collect()
}

//! What follows from a project's inputs, for every layout.

use crate::case::{Case, Derived};
use crate::forecast::Forecast;
use crate::forecast::design::Answer;
use crate::mesh::MeshType;
use crate::problem::Problem;
use crate::project::schema::{NamedLayout, Project};
use crate::study::verdict::{Finding, Simulated, Verdict, verdict};
use std::sync::Arc;

/// What follows from one layout as it stands, or why nothing does.
#[derive(Debug, Clone)]
pub struct LayoutResult {
    /// The layout as a case, if the project or the catalogue has its mesh.
    pub(crate) case: Option<Case>,
    /// What follows from it, or what is wrong with the inputs.
    pub(crate) derived: Result<Derived, Vec<Problem>>,
    /// Whether it is enough; missing with its mesh.
    pub(crate) verdict: Option<Verdict>,
}

impl LayoutResult {
    /// The results of one layout of a project.
    pub(crate) fn new(project: &Project, layout: &NamedLayout) -> LayoutResult {
        match project.case(layout) {
            Ok(case) => {
                let derived = case.derive();
                let kept = Simulated::of(layout.check.as_deref(), &case);
                let verdict = Some(verdict(&case, &derived, kept, project.basis));
                LayoutResult { derived, verdict, case: Some(case) }
            }
            Err(problem) => LayoutResult { derived: Err(vec![problem]), verdict: None, case: None },
        }
    }

    /// Its verdict, where anything is asked.
    pub(crate) fn asked_verdict(&self) -> Option<&Verdict> {
        self.verdict.as_ref().filter(|v| v.finding() != Finding::NotAsked)
    }

    /// Its mesh, if there is one.
    pub(crate) fn mesh(&self) -> Option<&Arc<MeshType>> {
        self.case.as_ref().map(|case| &case.mesh)
    }

    /// The forecast, if the inputs are sound.
    pub fn forecast(&self) -> Option<&Forecast> {
        self.derived.as_ref().ok().map(|derived| &derived.forecast)
    }

    /// The answer to the layout's design question; missing without a field value.
    pub fn answer(&self) -> Option<&Answer> {
        self.derived.as_ref().ok().and_then(|derived| derived.answer.as_ref())
    }
}

/// The results of all layouts of a project, in order.
pub(crate) fn all(project: &Project) -> Vec<LayoutResult> {
    project.layouts.iter().map(|layout| LayoutResult::new(project, layout)).collect()
}

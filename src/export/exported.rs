//! A layout of a project with what follows from it, ready to be written.

use crate::case::{Case, Derived};
use crate::forecast::Forecast;
use crate::forecast::design::Answer;
use crate::problem::Problem;
use crate::project::{NamedLayout, Project};
use crate::study::verdict::{Simulated, Verdict, verdict};

/// One layout and what follows from it.
#[derive(Debug, Clone)]
pub struct ExportedLayout {
    /// The layout as it stands in the project.
    pub entry: NamedLayout,
    /// The same as a case.
    pub case: Case,
    /// What follows from it.
    pub derived: Derived,
    /// Whether it is enough, by its forecast and by the check that is kept.
    pub verdict: Verdict,
}

impl ExportedLayout {
    /// One layout of a project.
    ///
    /// # Errors
    /// What makes no sense, by its place in the layout of that name.
    pub(crate) fn new(
        project: &Project,
        entry: &NamedLayout,
    ) -> Result<ExportedLayout, Vec<Problem>> {
        let made = || {
            entry.check()?;
            let case = project.case(entry).map_err(|problem| vec![problem])?;
            let derived = case.derive()?;
            let kept = Simulated::of(entry.check.as_deref(), &case);
            let verdict = verdict(&case, &derived.forecast, kept, project.basis);
            Ok(ExportedLayout { entry: entry.clone(), case, derived, verdict })
        };
        made().map_err(|found: Vec<Problem>| {
            let place = format!("layout {:?}", entry.name);
            found.into_iter().map(|p| p.under(&place)).collect()
        })
    }

    pub fn forecast(&self) -> &Forecast {
        &self.derived.forecast
    }

    /// The answer to its question; missing where nothing is asked or there is no field value.
    pub(crate) fn design(&self) -> Option<Answer> {
        self.derived.answer.filter(|_| self.case.question.asks())
    }
}

/// All layouts of a project, in its order.
///
/// # Errors
/// Everything that makes no sense, by layout.
pub fn exported(project: &Project) -> Result<Vec<ExportedLayout>, Vec<Problem>> {
    let (mut good, mut bad) = (Vec::new(), Vec::new());
    for entry in &project.layouts {
        match ExportedLayout::new(project, entry) {
            Ok(one) => good.push(one),
            Err(found) => bad.extend(found),
        }
    }
    if bad.is_empty() { Ok(good) } else { Err(bad) }
}

//! Design questions, the displacement-based and the hybrid use that Pol & Gabrieli (2021, section 5)
//! name: a design force asks for deflection and utilisation, an allowable deflection for the force.
//!
//! Partial factors: gamma_load multiplies the design force, gamma_resistance divides F_a; both are 1
//! unless the user says otherwise, and stand beside every number they act on.

use super::Field;

/// What an engineer asks of a layout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// Design force of the load, N, above 0, without its factor.
    pub force: Option<f64>,
    /// Allowable deflection, m, above 0.
    pub deflection: Option<f64>,
    /// Partial factor on resistance, dimensionless, at least 1 in most codes; default 1.
    pub gamma_resistance: f64,
    /// Partial factor on load, dimensionless; default 1.
    pub gamma_load: f64,
}

impl Default for Question {
    fn default() -> Self {
        Question { force: None, deflection: None, gamma_resistance: 1.0, gamma_load: 1.0 }
    }
}

impl Question {
    /// Whether anything is asked beyond the forecast itself.
    pub(crate) fn asks(&self) -> bool {
        *self != Question::default()
    }
}

/// The answer; the parts not asked for are missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Answer {
    /// Factored resistance F_a / gamma_resistance, N.
    pub resistance: f64,
    /// Answer for the design force.
    pub at_force: Option<AtForce>,
    /// Answer for the allowable deflection.
    pub at_deflection: Option<AtDeflection>,
}

/// What a design force needs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtForce {
    /// Factored load gamma_load F_design, N.
    pub load: f64,
    /// Utilisation gamma_load F_design / (F_a / gamma_resistance); above 1 the panel is not enough.
    pub utilisation: f64,
    /// Resistance less load, N; negative when the panel is not enough.
    pub margin: f64,
    /// Deflection at the factored load on the unfactored curve, m; missing beyond failure.
    pub deflection: Option<f64>,
    /// Whether that deflection is within the allowable one, where both are given.
    pub within_allowable: Option<bool>,
}

/// What an allowable deflection gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtDeflection {
    /// Force mobilised at the allowable deflection, N, F_a beyond failure.
    pub(crate) force: f64,
    /// The same over gamma_resistance, N.
    pub(crate) design_force: f64,
    /// Energy absorbed up to there, J.
    pub(crate) energy: f64,
    /// Whether the panel fails before the allowable deflection is reached.
    pub(crate) beyond_failure: bool,
}

/// Answers a design question for a panel.
pub(crate) fn answer(field: &Field, question: &Question) -> Answer {
    let resistance = field.values.force / question.gamma_resistance;
    let at_force = question.force.map(|force| {
        let load = question.gamma_load * force;
        let deflection = field.deflection_at(load);
        AtForce {
            load,
            utilisation: load / resistance,
            margin: resistance - load,
            deflection,
            within_allowable: question
                .deflection
                .map(|allowable| deflection.is_some_and(|reached| reached <= allowable)),
        }
    });
    let at_deflection = question.deflection.map(|deflection| {
        let reached = deflection.min(field.values.deflection);
        let force = field.force_at(reached);
        AtDeflection {
            force,
            design_force: force / question.gamma_resistance,
            energy: field.energy_to(reached),
            beyond_failure: deflection > field.values.deflection,
        }
    });
    Answer { resistance, at_force, at_deflection }
}

//! Design questions, the displacement-based and the hybrid use that Pol & Gabrieli (2021, section 5)
//! name: a design force asks for deflection and utilisation, an allowable deflection for the force.
//!
//! Partial factors: gamma_load multiplies the design force, gamma_resistance divides F_a; both are 1
//! unless the user says otherwise, and stand beside every number they act on.

use super::Field;
use crate::layout::Layout;

/// What an engineer asks of a layout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// Design force of the load, N, above 0, without its factor.
    pub force: Option<f64>,
    /// Load per area of face, N/m2, above 0, without its factor; instead of the force, never beside it.
    pub pressure: Option<f64>,
    /// What an anchor can take, N, above 0.
    pub anchor_resistance: Option<f64>,
    /// Allowable deflection, m, above 0.
    pub deflection: Option<f64>,
    /// Partial factor on resistance, dimensionless, at least 1 in most codes; default 1.
    pub gamma_resistance: f64,
    /// Partial factor on load, dimensionless; default 1.
    pub gamma_load: f64,
}

impl Default for Question {
    fn default() -> Self {
        Question {
            force: None,
            pressure: None,
            anchor_resistance: None,
            deflection: None,
            gamma_resistance: 1.0,
            gamma_load: 1.0,
        }
    }
}

impl Question {
    /// Whether anything is asked beyond the forecast itself.
    pub(crate) fn asks(&self) -> bool {
        *self != Question::default()
    }

    /// The same question with the load as a force on this panel: a pressure acts on the area of the
    /// cell, and so follows the spacing.
    pub(crate) fn on(&self, layout: &Layout) -> Question {
        let of_area = self.pressure.map(|p| p * layout.area());
        Question { force: self.force.or(of_area), pressure: None, ..*self }
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
    /// Deflection at the design force without its factor, m; missing beyond failure.
    pub service_deflection: Option<f64>,
    /// Whether the panel fails before the factored load is reached.
    pub(crate) beyond_failure: bool,
    /// Whether the service deflection is within the allowable deflection, where one is given.
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
        let at = |force| field.end()?.deflection_at(force);
        let (deflection, service) = (at(load), at(force));
        AtForce {
            load,
            utilisation: load / resistance,
            margin: resistance - load,
            deflection,
            service_deflection: service,
            // The failure force itself is on the curve, rounding of a quotient included.
            beyond_failure: load / field.values.force > 1.0 + 1e-12,
            within_allowable: question
                .deflection
                .filter(|_| field.end().is_some())
                .map(|allowed| service.is_some_and(|v| v <= allowed)),
        }
    });
    let curve = question.deflection.zip(field.end());
    let at_deflection = curve.map(|(deflection, end)| {
        let reached = deflection.min(end.deflection);
        let force = end.force_at(reached);
        AtDeflection {
            force,
            design_force: force / question.gamma_resistance,
            energy: end.energy_to(reached),
            beyond_failure: deflection > end.deflection,
        }
    });
    Answer { resistance, at_force, at_deflection }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forecast::field::Branch;
    use crate::forecast::{Values, master};

    /// A panel of 20 kN at 0.5 m.
    fn panel() -> Field {
        let branch = Branch::LargePunch;
        let values = Values::new(20_000.0, 0.5).into();
        Field {
            values,
            regime: branch,
            branch,
            other_branch: None,
            method: None,
            published: None,
            variation: 0.07,
        }
    }

    fn at(force: f64, deflection: Option<f64>) -> AtForce {
        let question = Question { force: Some(force), deflection, ..Question::default() };
        answer(&panel(), &question).at_force.unwrap()
    }

    #[test]
    fn the_service_deflection_leaves_the_factors_out() {
        // A factor on the load moves the design deflection only; a panel that fails under the factored
        // load still says how far it gives under the plain one.
        let plain = at(16_000.0, None);
        let question = Question { force: Some(16_000.0), gamma_load: 1.3, ..Question::default() };
        let factored = answer(&panel(), &question).at_force.unwrap();
        assert_eq!(factored.service_deflection, plain.deflection);
        assert_eq!(factored.deflection, None);
        // By the master curve: at that deflection it holds the force.
        let reached = plain.service_deflection.unwrap();
        assert!((20_000.0 * master::force(reached / 0.5) - 16_000.0).abs() < 1e-6);
    }

    #[test]
    fn the_allowed_deflection_is_compared_with_the_service_deflection() {
        // 10 kN of 20 kN are reached well beyond 0.1 m; 30 kN are beyond failure, whatever is allowed.
        let within = |force, allowed| at(force, Some(allowed)).within_allowable;
        assert_eq!([within(10_000.0, 0.1), within(10_000.0, 0.5)], [Some(false), Some(true)]);
        assert_eq!(
            (within(30_000.0, 2.0), at(10_000.0, None).within_allowable),
            (Some(false), None)
        );
    }
}

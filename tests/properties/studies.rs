//! What holds of the studies whatever the layout and the question.

use super::{clear_layouts, close, layouts, meshes, rules};
use meshcast::case::{Case, Input};
use meshcast::forecast::design::Question;
use meshcast::layout::{BranchRule, Layout};
use meshcast::mesh::MeshType;
use meshcast::study::sensitivity::{Change, Sensitivity, cases, sensitivity};
use meshcast::study::solve::{Requirement, RequirementKind, solve};
use meshcast::study::sweep::{SweepAxis, SweepGrid, sweep};
use meshcast::study::verdict::Basis;
use proptest::prelude::*;
use std::sync::Arc;

fn questions() -> impl Strategy<Value = Question> {
    let factor = || 0.8..2.0_f64;
    let one = |range| proptest::option::of(range);
    (one(1.0e3..1.0e5_f64), one(0.05..1.5_f64), factor(), factor()).prop_map(
        |(force, deflection, gamma_resistance, gamma_load)| Question {
            pressure: None,
            anchor_resistance: None,
            force,
            deflection,
            gamma_resistance,
            gamma_load,
        },
    )
}

fn case(layout: Layout, mesh: MeshType, rule: BranchRule, question: Question) -> Case {
    Case { layout, mesh: Arc::new(mesh), rule, question }
}

fn change(s: &Sensitivity, input: Input, raised: bool) -> Option<Change> {
    let bar = s.bars.iter().find(|b| b.input == input)?;
    if raised { bar.raised.change } else { bar.lowered.change }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, failure_persistence: None, ..ProptestConfig::default() })]

    /// The punch to the left is the punch to the right: its steps change sides, all else is the same.
    #[test]
    fn a_sensitivity_is_even_in_the_offsets(
        layout in clear_layouts(), mesh in meshes(), rule in rules(), question in questions(),
    ) {
        let of = |layout| sensitivity(&case(layout, mesh.clone(), rule, question));
        let (here, there) = (of(layout), of(Layout { ex: -layout.ex, ..layout }));
        for input in Input::VARIED {
            for raised in [false, true] {
                let side = if input == Input::OffsetX { !raised } else { raised };
                let (a, b) = (change(&here, input, raised), change(&there, input, side));
                prop_assert_eq!(a.is_some(), b.is_some());
                if let (Some(a), Some(b)) = (a, b) {
                    prop_assert!((a.force_part - b.force_part).abs() < 1e-9, "{:?}", input);
                    let parts = a.deflection_part.zip(b.deflection_part);
                    prop_assert!(parts.is_some_and(|(a, b)| (a - b).abs() < 1e-9));
                }
            }
        }
    }

    /// Ten per cent of the laboratory's values is ten per cent of the panel's, whatever the rest.
    #[test]
    fn laboratory_values_pass_through(
        layout in clear_layouts(), mesh in meshes(), rule in rules(), question in questions(),
    ) {
        let s = sensitivity(&case(layout, mesh, rule, question));
        for raised in [false, true] {
            let part = if raised { 0.1 } else { -0.1 };
            if let Some(c) = change(&s, Input::LabForce, raised) {
                prop_assert!((c.force_part - part).abs() < 1e-9);
                prop_assert!(c.deflection_part.is_some_and(|p| p.abs() < 1e-9));
            }
            if let Some(c) = change(&s, Input::LabDeflection, raised) {
                prop_assert!(c.deflection_part.is_some_and(|p| (p - part).abs() < 1e-9));
                prop_assert!(c.force_part.abs() < 1e-9);
            }
        }
    }

    /// The cases that a study gives out are those it forecasts itself.
    #[test]
    fn a_study_gives_out_its_own_cases(layout in layouts(), rule in rules(), question in questions()) {
        let base = case(layout, (*meshcast::mesh::catalogue::reference()).clone(), rule, question);
        let s = sensitivity(&base);
        let steps = s.bars.iter().flat_map(|b| [&b.lowered, &b.raised]);
        for (step, case) in steps.zip(cases(&base)) {
            prop_assert_eq!(&step.outcome, &case.outcome());
        }
        let axis = |input, from, to| SweepAxis { input, from, to, steps: 4 };
        let second = Some(axis(Input::LabDeflection, 0.3, 0.9));
        let grid = SweepGrid::new(axis(Input::Spacing, 0.5, 6.0), second).unwrap();
        for (index, point) in sweep(&base, grid.clone()).points.iter().enumerate() {
            prop_assert_eq!(point, &grid.case(&base, index).outcome());
        }
    }

    /// What is solved for meets the question in its own forecast, and the neighbour does not; a
    /// crossing that is no jump meets it to rounding; inside a span it is met, outside it is not.
    #[test]
    fn solutions_meet_what_is_asked(
        layout in clear_layouts(), mesh in meshes(), rule in rules(), question in questions(),
        at in 0.0..1.0_f64,
    ) {
        let base = case(layout, mesh, rule, question);
        for requirement in Requirement::asked(&question) {
            for input in [Input::Plate, Input::Spacing, Input::Punch] {
                let s = solve(&base, input, requirement, Basis::Mean).unwrap();
                for c in &s.crossings {
                    let there = base.with(input, c.value);
                    let point = there.outcome().unwrap();
                    let margin = requirement.margin(&there, &point, Basis::Mean).unwrap();
                    prop_assert!(margin >= 0.0);
                    if requirement == Requirement::Force {
                        let used = point.utilisation().unwrap();
                        prop_assert!(used <= 1.0);
                        if c.kind == RequirementKind::Exact {
                            prop_assert!(close(used, 1.0, 1e-9), "{used}");
                        }
                    }
                    if let Some(rounded) = c.rounded {
                        prop_assert!((rounded - c.value).abs() <= 0.001 + 1e-9);
                    }
                }
                prop_assert!(s.spans.iter().all(|p| p.from <= p.to));
                prop_assert_eq!(s.never() , s.spans.is_empty());
                let value = s.range.min + (s.range.max - s.range.min) * at;
                let there = base.with(input, value);
                let met = there.outcome().ok().is_some_and(|p| {
                    requirement.margin(&there, &p, Basis::Mean).is_some_and(|m| m >= 0.0)
                });
                let inside = s.spans.iter().any(|p| (p.from..=p.to).contains(&value));
                // At a crossing the two may differ by rounding.
                let edge = s.crossings.iter().any(|c| (c.value - value).abs() < 1e-9);
                prop_assert!(met == inside || edge, "{input:?} {requirement:?} {value}: {met}");
            }
        }
    }
}

//! Which inputs a forecast was made from.

use super::design::Question;
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::layout::{BranchRule, Layout, MethodChoice, Twists};
use crate::mesh::MeshType;
use crate::mesh::adopted::{Adopted, KeptMethod};
use crate::words::Choice;

/// Fingerprint of all that decides a forecast: layout, branch rule, and of the mesh what the closed form
/// uses. The design question is none of it: it asks something of a forecast and changes no number of it.
/// What a mesh is called or where its values come from decides nothing but its identifier, which stands
/// in the result. The map and the equations are the program's own; its version, which a printed result
/// carries, stands for them.
pub(crate) fn of_inputs(layout: &Layout, mesh: &MeshType, rule: BranchRule) -> Fingerprint {
    let lab = &mesh.laboratory;
    let own = mesh.ratios.as_ref();
    let derived = layout.method == MethodChoice::Derived;
    Fingerprinter::new("forecast")
        .number(layout.plate)
        .number(layout.spacing)
        .number(layout.punch)
        .text(&mesh.id)
        .number(lab.force)
        // No record may have the 0 that stands for a missing deflection.
        .number(lab.deflection.unwrap_or(0.0))
        .text(lab.statistic.word())
        .number(lab.panel)
        .number(lab.punch)
        .with("ex", layout.ex, 0.0)
        .with("ey", layout.ey, 0.0)
        .given("Ly", layout.grid.up.filter(|up| *up != layout.spacing))
        .with("stagger", layout.grid.stagger, false)
        .with("twists", layout.grid.twists.word(), Twists::Down.word())
        .with("branch", rule.word(), BranchRule::Published.word())
        .with("method", layout.method.word(), MethodChoice::Published.word())
        .given("blocks", (layout.method == MethodChoice::Derived).then(|| layout.blocks.word()))
        .with("reference", mesh.reference, false)
        .with("example", mesh.example, false)
        .given("alpha_F", own.map(|r| r.force))
        .given("alpha_delta", own.map(|r| r.deflection))
        .given("adopted", mesh.adopted.as_ref().filter(|_| derived).map(adopted))
        .given("methods", Some(&mesh.methods.0).filter(|all| derived && !all.is_empty()).map(named))
        .finish()
}

/// Print of what an adopted mesh brings: its range and its methods.
fn adopted(adopted: &Adopted) -> String {
    // Plain data of finite numbers can always be written.
    let text = serde_json::to_string(adopted).unwrap_or_default();
    Fingerprinter::new("adopted").text(&text).finish().to_string()
}

/// Print of methods that are named by file.
fn named(methods: &Vec<KeptMethod>) -> String {
    let text = serde_json::to_string(methods).unwrap_or_default();
    Fingerprinter::new("methods").text(&text).finish().to_string()
}

/// Fingerprint of a forecast, given by its own, with what is asked of it: of a study's answer, which
/// depends on both.
pub(crate) fn of_question(forecast: Fingerprint, question: &Question) -> Fingerprint {
    Fingerprinter::new("question")
        .text(&forecast.to_string())
        .given("force", question.force)
        .given("pressure", question.pressure)
        .given("anchor_resistance", question.anchor_resistance)
        .given("deflection", question.deflection)
        .with("gamma_resistance", question.gamma_resistance, 1.0)
        .with("gamma_load", question.gamma_load, 1.0)
        .finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;
    use crate::mesh::{RatioRecord, catalogue};

    #[test]
    fn every_input_counts() {
        let mesh = catalogue::reference();
        let rule = BranchRule::Published;
        let base = of_inputs(&REFERENCE, &mesh, rule);
        assert_eq!(base, of_inputs(&REFERENCE, &mesh.clone(), rule));
        let swapped = Layout { ex: 0.1, ..REFERENCE };
        let other = Layout { ey: 0.1, ..REFERENCE };
        let mut stronger = (*mesh).clone();
        stronger.laboratory.force += 1.0;
        let mut mixed = (*mesh).clone();
        mixed.ratios = Some(RatioRecord { force: 2.0, deflection: 1.5, source: String::new() });
        let mut example = (*mesh).clone();
        example.example = true;
        let derived = Layout { method: MethodChoice::Derived, ..REFERENCE };
        let mirrored = Layout { blocks: crate::layout::Blocks::Mirrored, ..derived };
        let all = [
            base,
            of_inputs(&derived, &mesh, rule),
            of_inputs(&mirrored, &mesh, rule),
            of_inputs(&swapped, &mesh, rule),
            of_inputs(&other, &mesh, rule),
            of_inputs(&REFERENCE, &stronger, rule),
            of_inputs(&REFERENCE, &mesh, BranchRule::Conservative),
            of_inputs(&REFERENCE, &mixed, rule),
            of_inputs(&REFERENCE, &example, rule),
        ];
        let [none, plain] = [Question::default(); 2];
        let factored = Question { gamma_load: 1.5, ..none };
        let asked = Question { force: Some(1000.0), ..none };
        let allowed = Question { deflection: Some(1000.0), ..none };
        assert_eq!(of_question(base, &none), of_question(base, &plain));
        let all =
            all.into_iter().chain([none, factored, asked, allowed].map(|q| of_question(base, &q)));
        let all: Vec<Fingerprint> = all.collect();
        let different: std::collections::BTreeSet<u64> = all.iter().map(|f| f.0).collect();
        assert_eq!(different.len(), all.len());
    }
}

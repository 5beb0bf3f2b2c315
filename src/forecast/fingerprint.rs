//! Which inputs a forecast was made from.

use super::design::Question;
use crate::fingerprint::{Fingerprint, Fingerprinter};
use crate::layout::{BranchRule, Layout};
use crate::mesh::MeshType;

/// Fingerprint of all that decides a forecast and its design answer: layout, branch rule, question,
/// and of the mesh what the closed form uses. What a mesh is called or where its values come from
/// decides nothing but its identifier, which stands in the result. The map and the equations are
/// the program's own; its version stands for them.
pub(crate) fn of_inputs(
    layout: &Layout,
    mesh: &MeshType,
    rule: BranchRule,
    question: &Question,
) -> Fingerprint {
    let lab = &mesh.laboratory;
    let own = mesh.ratios.as_ref();
    Fingerprinter::new("forecast")
        .number(layout.plate)
        .number(layout.spacing)
        .number(layout.punch)
        .number(layout.ex)
        .number(layout.ey)
        .text(rule.word())
        .text(&mesh.id)
        .flag(mesh.reference)
        .flag(mesh.example)
        .number(lab.force)
        .number(lab.deflection)
        .text(lab.statistic.word())
        .number(lab.panel)
        .number(lab.punch)
        .optional(own.map(|r| r.force))
        .optional(own.map(|r| r.deflection))
        .optional(question.force)
        .optional(question.deflection)
        .number(question.gamma_resistance)
        .number(question.gamma_load)
        .finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::REFERENCE;
    use crate::mesh::catalogue;

    #[test]
    fn every_input_counts() {
        let mesh = catalogue::reference();
        let (rule, question) = (BranchRule::Published, Question::default());
        let base = of_inputs(&REFERENCE, &mesh, rule, &question);
        assert_eq!(base, of_inputs(&REFERENCE, &mesh.clone(), rule, &question));
        let swapped = Layout { ex: 0.1, ..REFERENCE };
        let other = Layout { ey: 0.1, ..REFERENCE };
        let mut stronger = (*mesh).clone();
        stronger.laboratory.force += 1.0;
        let asked = Question { force: Some(1000.0), ..question };
        let all = [
            base,
            of_inputs(&swapped, &mesh, rule, &question),
            of_inputs(&other, &mesh, rule, &question),
            of_inputs(&REFERENCE, &stronger, rule, &question),
            of_inputs(&REFERENCE, &mesh, BranchRule::Conservative, &question),
            of_inputs(&REFERENCE, &mesh, rule, &asked),
        ];
        let different: std::collections::BTreeSet<u64> = all.iter().map(|f| f.0).collect();
        assert_eq!(different.len(), all.len());
    }
}

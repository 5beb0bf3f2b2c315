//! What the report says of the method: its equations and its limits.

use super::document::{Block, ReportDocument, ours};
use crate::export::ExportedLayout;
use crate::forecast::eccentricity::published;
use crate::forecast::warning::{PANEL, PLATE, PUNCH, SPACING};
use crate::method::DerivedMethod;
use crate::project::schema::MethodFile;
use crate::units::{Units, shortest, significant};

/// The equations, in the order in which they are used.
pub(crate) fn equations(document: &mut ReportDocument) {
    document.chapter("Method");
    document.say("Pol, A. and Gabrieli, F. (2021): A simple tool for forecasting the mechanical response of anchored wire mesh panels. Numbers of equations are those of that paper; * marks reference values, lengths are in m.");
    document.say("Laboratory. The punch test of the mesh gives {F_l*} and {delta_l*} for the standard panel of 3.0 m and the punch of 1.0 m. A test on a square panel of another side {L_l} is brought to the standard one by");
    push(document, "{F_l} = (0.89 + 0.11 {L_l} / 3.0) {F_l*}", "1");
    push(document, "{delta_l} = (0.15 + 0.85 {L_l} / 3.0) {delta_l*}", "2");
    document.say("Step 1, from the laboratory to the field reference ({d} = 0.32 m, {L} = 3.0 m, {D} = 1.0 m):");
    push(document, "{F_a*} = {alpha_F} {F_l*},  {delta_a*} = {alpha_delta} {delta_l*}", "step 1");
    document.say("For the double-twist reference mesh {alpha_F} = 29.1/73.3 (printed as 0.40) and {alpha_delta} = 1.08.");
    document.say("Step 2, the layout of a centred block; the first line for {D} ≤ {d} (small punch), the second for {D} > {d} (large punch):");
    push(
        document,
        "{F_a} = 2.47 {D} (0.48 {d} / 0.32 + 0.45) (0.16 {L} / 3 + 0.84) {F_a*}",
        "A.1, small punch",
    );
    push(
        document,
        "{F_a} = (0.06 {D} + 0.94) (0.48 {d} / 0.32 + 0.45) (0.16 {L} / 3 + 0.84) {F_a*}",
        "A.1, large punch",
    );
    push(
        document,
        "{delta_a} = 0.98 ({L} / 3) (0.72 {D} + 0.78) (0.02 {d} / 0.32 + 0.98) {delta_a*}",
        "A.2, small punch",
    );
    push(
        document,
        "{delta_a} = 0.98 ({L} / 3) (0.03 {D}² - 0.16 {D} + 1.13) (0.02 {d} / 0.32 + 0.98) {delta_a*}",
        "A.2, large punch",
    );
    document.say("The published branch rule takes the line by the size of the punch; the conservative one takes the line with the lower {F_a}, and {delta_a} of the same line. An eccentric punch multiplies {F_a} and {delta_a} by two factors that depend on {e_x}/{L} and {e_y}/{L} alone (Fig. A1).");
    document.say(
        "Step 3, the curve, with {x} = {delta} / {delta_a} and {y} = {F} / {F_a} from 0 to 1:",
    );
    push(document, "{y} = 1.312 {x}³ - 0.385 {x}² + 0.073 {x}", "3");
    document.say("The deflection at a force is the exact inverse of Eq. 3, stiffness its slope, energy its area. Design: utilisation = {gamma_F} F / ({F_a} / {gamma_R}), with the design force F, the partial factor {gamma_F} on the load and {gamma_R} on the resistance; the deflection under the design force is read at {gamma_F} F on the curve without a factor.");
    document.say("The eccentricity factors come from a map that stands for Fig. A1, with the uncertainty of each value. Its sources:");
    let sources = published().sources().iter().map(|s| s.as_str().into()).collect();
    document.blocks.push(Block::List(sources));
}

/// The derived methods that some of these layouts take; nothing where none does.
pub(crate) fn derived(
    cases: &[ExportedLayout],
    files: &[MethodFile],
    document: &mut ReportDocument,
) {
    let mut methods: Vec<&DerivedMethod> = Vec::new();
    for field in cases.iter().filter_map(|case| case.forecast().field.as_ref().ok()) {
        let Some(method) = field.method else { continue };
        if !methods.contains(&method) {
            methods.push(method);
        }
    }
    if methods.is_empty() {
        return;
    }
    document.say("Derived methods. A layout whose method is derived takes the same three steps with relations made of simulations of the mesh instead of Eqs. A.1, A.2, the map of Fig. A1 and Eq. 3. Where its blocks are `worst` the lower of the repeated and the mirrored method counts. Dotted lines in its chart hold 90 % of the simulated curves.");
    let items = methods.iter().map(|method| {
        let [a, b, c] = method.master.cubic;
        let [plate, spacing, punch] =
            method.ranges.map(|[from, to]| format!("{} to {} m", shortest(from), shortest(to)));
        let named = files.iter().find(|f| f.method.is_some_and(|kept| kept.0 == *method));
        let from = named.map_or(String::new(), |f| format!(" (file {:?})", f.file));
        ours(&format!(
            "{}{from}: {} of {} runs of random layouts ({}, {}), {{d}} {plate}, {{L}} {spacing}, {{D}} {punch}; {{alpha_F}} = {}, {{alpha_delta}} = {}; size relations: {}; offset: a sum of cosines of {} runs; {{y}} = {} {{x}}³ {} {{x}}² {} {{x}}.",
            method.name,
            method.runs.used,
            method.runs.asked,
            method.revisions,
            method.fidelity,
            significant(method.alpha.force, 4),
            significant(method.alpha.deflection, 4),
            method.sizes.form,
            method.offsets.runs,
            significant(a, 4),
            signed(b),
            signed(c),
        ))
    });
    document.blocks.push(Block::List(items.collect()));
}

/// A number behind another one: `- 0.138`, `+ 0.0230`.
fn signed(value: f64) -> String {
    let sign = if value < 0.0 { "-" } else { "+" };
    format!("{sign} {}", significant(value.abs(), 3))
}

/// Where the method ends.
pub(crate) fn limits(document: &mut ReportDocument) {
    document.chapter("What the numbers are, and are not");
    let ranges = format!(
        "Published ranges: plate {{d}} {}, spacing {{L}} {}, block {{D}} {}, laboratory panel {{L_l}} {}. A number outside them is extrapolated and marked as such.",
        PLATE.text(Units::METRES),
        SPACING.text(Units::METRES),
        PUNCH.text(Units::METRES),
        PANEL.text(Units::METRES)
    );
    document.blocks.push(Block::List(vec![
        ours("The lowest of the arrangements computed, with a block in every cell of the mesh: where the same block repeats each anchor carries the whole force of its cell, where blocks face each other across a line of anchors the one between them carries more. It is not the answer for one block on a large mesh."),
        ours("The published relations are for anchors on a square grid. Rectangular grids (two spacings in the tables) and staggered ones (s) have none: no forecast, the check by simulation answers."),
        ours(&ranges),
        ours("{F_a} jumps where {D} = {d}. Near it both values are given, and a layout may choose the conservative one."),
        ours("At their own reference point the published relations return 0.93 {F_a*} and 0.98 {delta_a*} (27.1 kN and 0.635 m for the reference mesh). They are used as published."),
        ours("A block that overlaps an anchor plate is outside the method: there is no field value."),
        ours("Partial factors are those stated with each layout; they are 1 unless the project says otherwise."),
        ours("The laboratory curve in the charts has the published end point only; its shape is that of Eq. 3."),
    ]));
}

fn push(document: &mut ReportDocument, template: &str, number: &'static str) {
    document.blocks.push(Block::Equation(ours(template), number));
}

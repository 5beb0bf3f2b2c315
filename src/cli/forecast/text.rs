//! A forecast as a text for people: at most 24 lines of 80 columns a layout.

use super::Answered;
use crate::cli::output::wrapped;
use crate::cli::page::{BASIS, MARGIN, Page, WIDTH};
use crate::forecast::field::Branch;
use crate::forecast::warning::Warning;
use crate::forecast::{Field, Values};
use crate::show::say;
use crate::units::{Units, energy_text, force_text, stiffness_text};
use crate::words::Choice;

/// Most lines a layout.
const HEIGHT: usize = 24;
/// The reports of all layouts, an empty line between them.
pub(crate) fn report(answered: &[Answered], unit: Units) -> String {
    if answered.is_empty() {
        return "The project has no layouts.\n".to_string();
    }
    let all: Vec<String> = answered.iter().map(|a| one(a, unit).join("\n") + "\n").collect();
    all.join("\n")
}

fn one(a: &Answered, unit: Units) -> Vec<String> {
    let mut page = Page::new(unit);
    page.inputs("forecast", a.name.as_deref(), a.case.fingerprint(), &a.case);
    laboratory(&mut page, a);
    match &a.forecast.field {
        Ok(field) => {
            values(&mut page, a, field);
            eccentricity(&mut page, a);
            match field.end() {
                Some(end) => curve(&mut page, &end),
                None => page.line("curve", "none: the laboratory record has no deflection"),
            }
            let (which, said) = say::anchors(&a.case.layout, field.values.force, page.unit);
            page.line(which, said);
            if let Some(answer) = &a.design {
                page.design(answer, &a.case.asked());
            }
        }
        Err(why) => page.line("field", why.sentence()),
    }
    if a.case.question.asks() {
        page.verdict(&a.case, &a.verdict);
    }
    page.line("basis", BASIS);
    warnings(&mut page, &a.forecast.warnings);
    page.lines
}

fn laboratory(page: &mut Page, a: &Answered) {
    let (f, record) = (&a.forecast, &a.case.mesh.laboratory);
    let text = format!(
        "F_l* {}, delta_l* {}, {}; panel {}, punch {}",
        force_text(f.laboratory.force, page.unit),
        page.maybe_length(f.laboratory.deflection),
        record.statistic.word(),
        page.entry(record.panel),
        page.entry(record.punch)
    );
    page.line("laboratory", text);
    let text = format!(
        "alpha_F {:.3}, alpha_delta {:.3}{}; F_a* {}, delta_a* {}",
        f.ratios.force,
        f.ratios.deflection,
        if f.ratios.default { "" } else { " (the mesh's own)" },
        force_text(f.reference.force, page.unit),
        page.maybe_length(f.reference.deflection)
    );
    page.line("ratios", text);
}

fn words(branch: Branch) -> &'static str {
    match branch {
        Branch::SmallPunch => "small punch",
        Branch::LargePunch => "large punch",
    }
}

fn values(page: &mut Page, a: &Answered, field: &Field) {
    let mark = if a.forecast.extrapolated() { " (extrapolated)" } else { "" };
    let ratios = [a.forecast.force_over_lab(), a.forecast.deflection_over_lab()];
    let ratios: Vec<_> = ratios.iter().flatten().map(|ratio| format!("{ratio:.3}")).collect();
    let text = format!(
        "F_a {}, delta_a {}{mark}; {} of the laboratory's",
        force_text(field.values.force, page.unit),
        page.maybe_length(field.values.deflection),
        ratios.join(" and ")
    );
    page.line("FIELD", text);
    if let Some(method) = field.method {
        page.line("method", say::derived(method, field, page.unit));
        if let Some(published) = field.published {
            page.line("published", say::beside(published, field.values, page.unit));
        }
        return;
    }
    let mut text = format!(
        "{} rule, {} by size, relation of the {}",
        a.forecast.rule.word(),
        words(field.regime),
        words(field.branch)
    );
    if let Some(other) = field.other_branch {
        text.push_str(&format!(
            "; the other gives {}, {}",
            force_text(other.force, page.unit),
            page.maybe_length(other.deflection)
        ));
    }
    page.line("branch", text);
}

fn eccentricity(page: &mut Page, a: &Answered) {
    let e = &a.forecast.eccentricity;
    let text = format!(
        "{:.3} +- {:.3} on F, {:.3} +- {:.3} on delta",
        e.force, e.force_sd, e.deflection, e.deflection_sd
    );
    let centred = (a.forecast.layout.folded()) == (0.0, 0.0);
    page.line(
        "eccentricity",
        if centred { "none, the block is centred".to_string() } else { text },
    );
}

fn curve(page: &mut Page, values: &Values) {
    let end = values.deflection;
    let text = format!(
        "at failure: tangent {}, secant {}; {} absorbed",
        page.unit.stiffness_number(values.tangent_at(end)),
        stiffness_text(values.secant_at(end), page.unit),
        energy_text(values.energy_to(end), page.unit)
    );
    page.line("stiffness", text);
}

/// The warnings, the heaviest first, in whole sentences, in few words where those do not fit, and as
/// many as fit.
fn warnings(page: &mut Page, warnings: &[Warning]) {
    let mut warnings: Vec<&Warning> = warnings.iter().collect();
    warnings.sort_by_key(|w| std::cmp::Reverse(w.weight()));
    let room = HEIGHT.saturating_sub(page.lines.len());
    if warnings.is_empty() {
        return page.line("warnings", "none");
    }
    let unit = page.unit;
    let lines = |text: fn(&Warning, Units) -> String| -> Vec<Vec<String>> {
        warnings
            .iter()
            .map(|w| wrapped(&format!("{:<MARGIN$}", w.weight().word()), &text(w, unit), WIDTH))
            .collect()
    };
    let whole = lines(Warning::sentence).concat();
    if whole.len() <= room {
        page.lines.extend(whole);
        return;
    }
    let mut short = lines(Warning::short).concat();
    if short.len() > room {
        short.truncate(room.saturating_sub(1));
        let left = warnings.len() - short.len();
        short.push(format!("{:<MARGIN$}{left} more, see --format json", "and"));
    }
    page.lines.extend(short);
}

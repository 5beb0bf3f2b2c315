//! What a study's text says about its checks.

use crate::cli::page::Page;
use crate::remark::Weight;
use crate::study::checks::{CheckAnswer, NoCheck};
use crate::study::remark::CheckRemark;
use crate::study::result::Wanted;
use crate::words::Choice;

/// What all checks of a study have in common.
pub(crate) fn plan(page: &mut Page, wanted: &Wanted) {
    let runs = match wanted.runs {
        Some(1) => "1 run each".to_string(),
        Some(n) => format!("{n} runs each"),
        None => "as many runs as needed".to_string(),
    };
    page.line(
        "DEM",
        format!(
            "{} fidelity, {runs}, seed {}; the same slack in all cases",
            wanted.fidelity.word(),
            wanted.seed
        ),
    );
}

/// What to know of the answers, each named.
pub(crate) fn notes<'a>(
    page: &mut Page,
    answers: impl Iterator<Item = (String, &'a CheckAnswer)> + Clone,
) {
    let missing = |why: &NoCheck| {
        let of = |a: &(String, &CheckAnswer)| a.1.as_ref().is_err_and(|e| e.code() == why.code());
        answers.clone().filter(of).map(|a| a.0).collect::<Vec<String>>()
    };
    if !missing(&NoCheck::Laboratory).is_empty() {
        page.line("no DEM", NoCheck::Laboratory.sentence());
    }
    let names = missing(&NoCheck::NotMade);
    if !names.is_empty() {
        page.line("not made", format!("{}: {}", listed(&names), NoCheck::NotMade.sentence()));
    }
    let impossible = NoCheck::Impossible(Vec::new());
    let names = missing(&impossible);
    let first =
        answers.clone().find_map(|a| a.1.as_ref().err().filter(|e| e.code() == impossible.code()));
    if let Some(first) = first {
        page.line("no DEM", format!("{}: {}", listed(&names), first.sentence()));
    }
    let mut kinds: Vec<(CheckRemark, Vec<String>)> = Vec::new();
    for (name, answer) in answers {
        let Ok(result) = answer else { continue };
        for remark in result.remarks().iter().filter(|r| said_here(r)) {
            let remark = remark.general();
            match kinds.iter_mut().find(|(kind, _)| *kind == remark) {
                Some((_, names)) => names.push(name.clone()),
                None => kinds.push((remark, vec![name.clone()])),
            }
        }
    }
    for (remark, names) in kinds {
        let text = format!("{}: {}", listed(&names), remark.sentence(page.unit));
        page.line(remark.weight().word(), text);
    }
}

/// Whether a remark is worth a line: how well the means are known stands beside them.
fn said_here(remark: &CheckRemark) -> bool {
    remark.weight() > Weight::Note && !matches!(remark, CheckRemark::StandardError(_))
}

/// Some names; of many the first.
fn listed(names: &[String]) -> String {
    const SHOWN: usize = 6;
    let mut text = names.iter().take(SHOWN).cloned().collect::<Vec<String>>().join(", ");
    if names.len() > SHOWN {
        text.push_str(&format!(" and {} more", names.len() - SHOWN));
    }
    text
}

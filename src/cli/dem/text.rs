//! What a study's text says about its checks.

use crate::cli::page::Page;
use crate::study::checks::{CheckAnswer, NoCheck};
use crate::study::result::{CheckResult, Wanted};

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
            "{} fidelity, {runs}, seed {}; the same alignments and slack in all cases",
            wanted.fidelity.word(),
            wanted.seed
        ),
    );
}

/// A word in front, what is said, and of which results.
type Remark<'a> = (&'a str, &'a str, &'a dyn Fn(&CheckResult) -> bool);

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
        page.line("no DEM", NoCheck::Laboratory.reason());
    }
    let names = missing(&NoCheck::NotMade);
    if !names.is_empty() {
        page.line("not made", format!("{}: {}", listed(&names), NoCheck::NotMade.reason()));
    }
    let impossible = NoCheck::Impossible(Vec::new());
    let names = missing(&impossible);
    let first =
        answers.clone().find_map(|a| a.1.as_ref().err().filter(|e| e.code() == impossible.code()));
    if let Some(first) = first {
        page.line("no DEM", format!("{}: {}", listed(&names), first.reason()));
    }
    let has = |v: &CheckResult, code: &str| v.warnings.iter().any(|w| w == code);
    let warned: [Remark; 6] = [
        ("cancelled", "ended early, the mean is of the runs that were whole", &|v| {
            has(v, "cancelled")
        }),
        ("diverged", "runs diverged and are not counted", &|v| has(v, "diverged")),
        (
            "bifurcation",
            "the block can stay on a wire or slip off it; only the ensemble counts",
            &|v| has(v, "bifurcation"),
        ),
        ("slipped", "runs slipped through: in the band by their peak, not in the mean", &|v| {
            v.slipped > 0
        }),
        (
            "no break",
            "runs came to the displacement limit: in the band by their peak, not in the mean",
            &|v| v.breaks.len() + v.slipped < v.runs,
        ),
        ("inexact", "estimated error of a run above twice what the fidelity aims at", &|v| {
            v.quality.error_estimate > 2.0 * v.wanted.fidelity.aim()
        }),
    ];
    for (head, text, of) in warned {
        let names: Vec<String> =
            answers.clone().filter(|a| a.1.as_ref().is_ok_and(of)).map(|a| a.0).collect();
        if !names.is_empty() {
            page.line(head, format!("{}: {text}", listed(&names)));
        }
    }
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

//! What a study's text says about its checks.

use crate::cli::page::Page;
use crate::study::checks::{Answer, NoCheck};
use crate::study::verdict::Wanted;

/// What all checks of a study have in common.
pub fn plan(page: &mut Page, wanted: &Wanted) {
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

/// What to know of the answers, each named.
pub fn notes<'a>(page: &mut Page, answers: impl Iterator<Item = (String, &'a Answer)> + Clone) {
    let missing = |why: &NoCheck| {
        let of = |a: &(String, &Answer)| a.1.as_ref().is_err_and(|e| e.code() == why.code());
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
    let warned = [
        ("slipped", "runs slipped through: in the band by their peak, not in the mean"),
        ("diverged", "runs diverged and are not counted"),
        ("cancelled", "ended early: the mean of the runs that are whole"),
        ("bifurcation", "the block can stay on a wire or slip off it; only the ensemble counts"),
    ];
    for (code, text) in warned {
        let of = |a: &(String, &Answer)| {
            a.1.as_ref().is_ok_and(|v| {
                v.warnings.iter().any(|w| w == code) || (code == "slipped" && v.slipped > 0)
            })
        };
        let names: Vec<String> = answers.clone().filter(of).map(|a| a.0).collect();
        if !names.is_empty() {
            page.line(code, format!("{}: {text}", listed(&names)));
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

//! The part of the details that speaks of the check by simulation.

use super::text::TextPage;
use crate::app::App;
use crate::app::work::live::LIVE_RUNS;
use crate::app::work::shown::Standing;
use crate::layout::Blocks;
use crate::show::say;
use crate::study::result::places::Places;
use crate::study::result::sampled::{CHARACTERISTIC, sentence};
use crate::study::result::{CheckResult, Revisions};
use crate::units::{Units, energy_text, force_text, length_text, significant, stiffness_text};

/// All there is to know of the check shown.
pub(super) fn section(page: &mut TextPage, app: &App) {
    page.heading("Check by simulation");
    let Some(shown) = app.shown_check() else {
        page.text("  none yet: c checks this layout, C all of them, l after each edit", 2);
        return;
    };
    let v = shown.result;
    let m = |value: f64| length_text(value, app.units());
    page.row(
        "stands",
        &match shown.standing {
            Standing::Current => "for the inputs as they are".to_string(),
            Standing::Live(_) => format!("live, {LIVE_RUNS} quick runs; c makes one that is kept"),
            Standing::Stale if v.by != Revisions::CURRENT => {
                format!("stale: made by {}, now {}; c makes it again", v.by, Revisions::CURRENT)
            }
            Standing::Stale => "stale: the inputs have changed since; c makes it again".into(),
        },
    );
    let asked = v.wanted.runs.map_or("until the mean is known".to_string(), |n| n.to_string());
    page.row("runs", &format!("{} ({asked}), seed {}", v.runs, v.wanted.seed));
    page.row("fidelity", &v.wanted.fidelity_said());
    if v.broke() {
        let kn = |value: f64| app.units().force_number(value, 3);
        page.row(
            "force at the first break",
            &format!(
                "{} +- {} (deviation); standard error {}",
                force_text(v.force.mean, app.units()),
                kn(v.force.deviation),
                kn(v.force.error)
            ),
        );
        page.row(
            "deflection there",
            &format!("{} +- {}", m(v.deflection.mean), m(v.deflection.deviation)),
        );
        if v.breaks.len() > 1 {
            page.row(
                "5 to 95 %",
                &format!(
                    "{} to {}, {} to {}",
                    kn(v.force.band[0]),
                    force_text(v.force.band[1], app.units()),
                    m(v.deflection.band[0]),
                    m(v.deflection.band[1])
                ),
            );
        }
    }
    if let Some(force) = v.characteristic() {
        page.row(
            "characteristic force",
            &format!("{}; {CHARACTERISTIC}", force_text(force, app.units())),
        );
    }
    if let Some(patterns) = sentence(&v.catches(), app.units()) {
        page.row("patterns", &patterns);
    }
    if let Some(arrangement) = &v.field.arrangement {
        let lowest = app.layout().layout.blocks == Blocks::Worst;
        let of = if lowest { ", the lowest of the arrangements computed" } else { "" };
        page.row("blocks", &format!("{arrangement}{of}"));
    }
    if let Some(a) = v.anchor() {
        let [normal, largest] = [a.normal, a.largest].map(|v| force_text(v, app.units()));
        let in_plane = force_text(a.in_plane, app.units());
        page.row(
            "worst anchor",
            &format!("{normal} out of the plane, {in_plane} in it; largest {largest}"),
        );
    }
    page.row(
        "peak",
        &format!("{} at {}", force_text(v.peak.force, app.units()), m(v.peak.deflection)),
    );
    page.row("stiffness at 75 %", &stiffness_text(v.k75, app.units()));
    page.row("energy to the first break", &energy_text(v.energy, app.units()));
    let places = Places::from_result(v, &app.layout().layout);
    if !v.breaks.is_empty() && !shown.stale() {
        page.row("first wires broke at", &format!("{}; twists {}", places.text(), places.twists));
    }
    quality(page, v);
    remarks(page, v, app.units());
    page.row("inputs", &format!("{} (fingerprint)", v.inputs));
}

/// What the solver's or the sampling's new revision changed, of each layout that this session made again.
pub(super) fn remade(page: &mut TextPage, app: &App) {
    let formers: Vec<_> = app
        .project()
        .layouts
        .iter()
        .filter_map(|layout| Some((layout, app.former(layout.uid)?)))
        .collect();
    if formers.is_empty() {
        return;
    }
    page.heading(&format!("Checks made again, now by {}", Revisions::CURRENT));
    for (layout, former) in formers {
        let now = layout.check.as_ref().and_then(|check| check.mean_break());
        let now_text = now.map_or("no break".to_string(), |p| {
            format!(
                "{}, {}",
                force_text(p.force, app.units()),
                length_text(p.deflection, app.units())
            )
        });
        page.text(
            &format!(
                "  {}: {now_text}; was {}",
                layout.name,
                say::former(former, now, app.units())
            ),
            4,
        );
    }
}

fn quality(page: &mut TextPage, v: &CheckResult) {
    let q = &v.quality;
    let percent = |part: f64| format!("{} %", significant(100.0 * part, 2));
    let chosen = v.wanted.run_fidelity().is_none();
    let whole = if chosen { ", by itself" } else { "" };
    page.row("error estimate, worst run", &format!("{}{whole}", percent(q.error_estimate)));
    page.row("kinetic over internal energy", &percent(q.kinetic_over_internal));
    page.row("energy out of balance", &percent(q.energy_balance));
    page.row("support over punch force", &significant(q.support_over_punch, 3));
}

fn remarks(page: &mut TextPage, v: &CheckResult, unit: Units) {
    for remark in v.remarks() {
        page.text(&format!("  ! {}", remark.sentence(unit)), 4);
    }
}

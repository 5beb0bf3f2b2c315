//! A check as JSON: SI with kN, one object a layout.

use super::Checked;
use crate::cli::output::{Fault, json_list};
use crate::dem::lattice::Role;
use crate::dem::outcome::{AnchorForce, Break, Quality, RunOutcome};
use crate::show::objects::{curve, ends, head, inputs, maybe_pair, pair, remark};
use crate::show::value::{Object, Value, exact, kn, word};
use crate::show::verdict;
use crate::study::bias::Bias;
use crate::study::blocks::{Stood, word as word_of};
use crate::study::ensemble::{Run, Spread};
use crate::study::result::WorstAnchor;
use crate::study::result::remade::Former;
use crate::study::result::sampled::Catch;
use crate::units::{Units, to_kn};
use crate::words::Choice;

/// One object, or a list of them with one line each.
pub(crate) fn report(checked: &[Checked], several: bool) -> Result<String, Fault> {
    json_list(checked.iter().map(one), several)
}

/// The check that another solver or sampling made, with the parts by which it has moved.
fn former(former: &Former, c: &Checked) -> Object {
    let (was, moved) = (former.mean(), former.moved(c.mean_break()));
    Object::new()
        .with("made_by", former.result.by.to_string())
        .with("fidelity", former.result.wanted.fidelity.word())
        .with("same_inputs", former.same_inputs)
        .with("mean", maybe_pair(was.map(|p| (p.force, Some(p.deflection)))))
        .with("change_F", moved.map(|d| d.force))
        .with("change_delta", moved.and_then(|d| d.deflection))
}

fn one(c: &Checked) -> Object {
    let e = &c.ensemble;
    let (broken, counted) = (c.broken(), c.counted() > 0);
    let both = |there: bool, part: fn(&Spread) -> f64| {
        maybe_pair(there.then(|| (part(&e.force), part(&e.deflection))))
    };
    let band = Object::new()
        .with("F_kN", ends(counted.then(|| e.force.band.map(to_kn))))
        .with("delta_m", ends(counted.then_some(e.deflection.band)));
    let remarks = c.remarks.iter().map(|r| remark(r.code(), r.weight(), r.sentence(Units::METRES)));
    head(c.name.as_deref(), c.fingerprint, inputs(&c.case))
        .with("test", word(c.spec.test))
        .with("fidelity", c.fidelity_word())
        .with("bias", c.ensemble.bias.map(bias))
        .with("law", c.spec.wire.source.clone())
        .with("stretch", exact(c.stretch))
        .with("runs", e.runs.iter().map(run).collect::<Value>())
        .with("mean", both(broken > 0, |s| s.mean))
        .with("mean_peak", maybe_pair(counted.then_some((e.peak[0], e.peak[1]))))
        // Of a single run nothing is known of the scatter.
        .with("standard_error", both(broken > 1, |s| s.error))
        .with("standard_deviation", both(broken > 1, |s| s.deviation))
        .with("slipped", e.slipped)
        .with("band", band)
        .with("characteristic_F_kN", c.characteristic().map(kn))
        .with("patterns", c.catches().into_iter().map(catch).collect::<Value>())
        .with("arrangement", c.test_is_anchored().then(|| word_of(c.arrangement)))
        .with("arrangement_words", c.test_is_anchored().then(|| c.words.clone()))
        .with("other_arrangements", c.others.iter().map(other).collect::<Value>())
        .with("worst_anchor", c.anchor().map(anchor))
        .with("forecast", maybe_pair(c.forecast.values.map(|v| (v.force, v.deflection))))
        .maybe("kept_before", c.former.as_ref().map(|f| former(f, c)))
        .maybe("verdict", c.verdict.as_ref().map(|v| verdict::object(&c.case, v)))
        .with("warnings", remarks.collect::<Value>())
}

/// What was taken out of quick members, by how many pairs.
fn bias(b: Bias) -> Object {
    let [force, delta] = b.factors;
    let [force_error, delta_error] = b.errors;
    Object::new()
        .with("pairs", b.pairs)
        .with("F_factor", force)
        .with("delta_factor", delta)
        .with("F_error", force_error)
        .with("delta_error", delta_error)
}

/// On how much of the slope a plate catches how many nodes.
fn catch(c: Catch) -> Object {
    Object::new()
        .with("nodes", c.nodes)
        .with("part", c.part)
        .with("F_kN", ends(c.force.map(|f| f.map(to_kn))))
}

/// Another arrangement that was simulated.
fn other(stood: &Stood) -> Object {
    let e = &stood.ensemble;
    Object::new()
        .with("arrangement", word_of(stood.arrangement))
        .with("mean", pair(e.force.mean, e.deflection.mean))
        .with("standard_error", pair(e.force.error, e.deflection.error))
        .with("runs", e.runs.len())
}

/// The worst anchor of the runs: means of its parts, and the largest force in any run.
fn anchor(a: WorstAnchor) -> Object {
    Object::new()
        .with("normal_kN", kn(a.normal))
        .with("in_plane_kN", kn(a.in_plane))
        .with("largest_kN", kn(a.largest))
}

/// The worst anchor of a run.
fn anchor_of_run(a: AnchorForce) -> Object {
    let [normal, in_plane] = a.parts();
    Object::new()
        .with("normal_kN", kn(normal))
        .with("in_plane_kN", kn(in_plane))
        .with("x_kN", kn(a.force[0]))
        .with("y_kN", kn(a.force[1]))
        .with("x_m", a.place[0])
        .with("y_m", a.place[1])
}

/// The word for a bond.
pub(super) fn kind(role: Role) -> &'static str {
    match role {
        Role::Twist => "double_twist",
        Role::Left | Role::Right => "single_wire",
    }
}

fn bond(b: &Break) -> Object {
    Object::new().with("kind", kind(b.role)).with("x_m", b.place[0]).with("y_m", b.place[1])
}

/// A number that is not finite cannot stand in JSON; it is one only of a diverged run.
fn finite(v: f64) -> f64 {
    if v.is_finite() { v } else { 0.0 }
}

fn run(run: &Run) -> Object {
    let o = &run.outcome;
    let first =
        o.first_break.map(|p| pair(p.force, p.deflection).with("bond", o.breaks.first().map(bond)));
    Object::new()
        .with("seed", Value::Count(run.seed))
        .with("phase", exact(run.phase))
        .with("stop", word(o.stop))
        .with("first_break", first)
        .with(
            "breaks",
            o.breaks.iter().map(|b| bond(b).with("delta_m", b.deflection)).collect::<Value>(),
        )
        .with("peak", pair(o.peak.force, o.peak.deflection))
        .with("energy_J", finite(o.energy))
        .with("k75_kN_per_m", (o.k75 > 0.0).then(|| kn(o.k75)))
        .with("worst_anchor", o.worst_anchor().map(anchor_of_run))
        .with("anchors_carrying_90_pct", o.anchors_carrying(0.9))
        .with("anchors", o.anchors.iter().copied().map(anchor_of_run).collect::<Value>())
        .with("curve", curve(&o.curve))
        .with("quality", quality(&o.quality))
        .with("cost", cost(run.wall, o))
        // Whether it was repeated with a shorter step.
        .with("repeated", o.repeated)
        // Whether a snap decides it, and no single run is better than a tenth.
        .with("snap", o.snaps())
        .with("skipped", o.skipped.iter().cloned().map(Value::from).collect::<Value>())
}

fn quality(q: &Quality) -> Object {
    Object::new()
        .with("kinetic_over_internal", finite(q.kinetic_over_internal))
        .with("energy_balance", finite(q.energy_balance))
        .with("support_over_punch", finite(q.support_over_punch))
        .with("error_estimate", finite(q.error_estimate))
}

/// What a run cost; `wall` in s.
fn cost(wall: f64, o: &RunOutcome) -> Object {
    Object::new()
        .with("wall_ms", 1000.0 * wall)
        .with("steps", o.cost.steps)
        .with("steps_to_first_break", o.cost.steps_to_break)
        .with("nodes", o.cost.nodes)
        .with("bonds", o.cost.bonds)
}

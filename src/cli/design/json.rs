//! Design solutions as JSON: SI with kN.

use super::{Solved, side};
use crate::cli::output::{Fault, json_list};
use crate::cli::page::BASIS;
use crate::show::columns::{PointRow, point};
use crate::show::objects::{self, design, head, inputs};
use crate::show::value::{Object, Value};
use crate::show::verdict;
use crate::study::solve::{Crossing, Place, Solution};
use crate::units::to_kn;

/// One object, or a list of them with one line each.
pub(crate) fn report(solved: &[Solved], several: bool) -> Result<String, Fault> {
    json_list(solved.iter().map(one), several)
}

fn one(s: &Solved) -> Object {
    let point = s.outcome.as_ref().ok();
    let q = &s.case.asked();
    let question = Object::new()
        .with("F_kN", q.force.map(to_kn))
        .with("delta_m", q.deflection)
        .with("gamma_load", q.gamma_load)
        .with("gamma_resistance", q.gamma_resistance);
    head(s.name.as_deref(), s.case.question_fingerprint(), inputs(&s.case))
        .with("question", question)
        .with("field", point.map(|p| objects::values(p.values())))
        .with("design", point.map(|p| design(&p.answer, q)))
        .with("verdict", verdict::object(&s.case, &s.verdict))
        .with("solutions", s.solutions.iter().map(solution).collect::<Value>())
        .with("warnings", objects::warnings(PointRow::from(&s.outcome).warnings))
        .with("basis", BASIS)
}

/// Whether a requirement is met in the range: `everywhere`, `nowhere` or `partly`.
fn met(s: &Solution) -> &'static str {
    if s.always() {
        "everywhere"
    } else if s.never() {
        "nowhere"
    } else {
        "partly"
    }
}

fn solution(s: &Solution) -> Object {
    let spans = s.spans.iter().map(|p| Object::new().with("from_m", p.from).with("to_m", p.to));
    Object::new()
        .with("solve", s.input.word())
        .with("requirement", s.requirement.word())
        .with("met", met(s))
        .with("range_m", Value::Numbers(vec![s.range.min, s.range.max]))
        .with("spans", spans.collect::<Value>())
        .with("crossings", s.crossings.iter().map(crossing).collect::<Value>())
        .with("ends", s.ends.iter().map(place).collect::<Value>())
        .with("best", s.best.as_ref().map(place))
}

fn crossing(c: &Crossing) -> Object {
    Object::new()
        .with("value_m", c.value)
        // The nearest whole millimetre that meets it.
        .with("rounded_m", c.rounded)
        .with("met", side(c))
        .with("kind", c.kind.word())
        // Anchors farther apart are no cure for want of strength.
        .with("advised", c.advised)
        .columns(&point(), &PointRow::from(&c.point))
        .with("beyond", Object::new().columns(&point(), &PointRow::from(&c.beyond)))
}

fn place(p: &Place) -> Object {
    Object::new()
        .with("value_m", p.value)
        .with("met", p.met())
        .with("margin", p.margin)
        .columns(&point(), &PointRow::from(&p.outcome))
}

//! Older formats, brought to the current one as text, so that comments and lines stay. The file itself
//! changes with the next save.
//!
//! - Version 0 was the working format before the first release. It spelt a layout's sizes out and
//!   gave forces in newtons: `plate`, `spacing`, `punch` for what is now `d`, `L`, `D`, and `force`
//!   in N for what is now `design_force` in kN. All else is as in version 1.
//! - Version 1 is that of the first release. All that it has means the same in version 2.
//!   Without `basis`, which only version 2 has, verdicts go by the mean.
//! - Version 2 has room for more: its names are reserved ([`super::words::RESERVED`]), and a kept check
//!   may have notes of later versions. A program that knows version 1 only would refuse those one by
//!   one as slips of the keyboard; so it refuses the file as a whole, and leaves it as it is:
//!
//!   ```text
//!   error: road-cut.ron cannot be opened
//!     line 7, column 5: version = 2
//!       the file was written by a newer meshcast and this one cannot read it
//!       allowed: 0 to 1
//!       use the newer meshcast; the file is left as it is
//!   ```

use super::decode::LAYOUT_FIELDS;
use super::error::Found;
use super::patch::Edit;
use super::schema::CURRENT_VERSION;
use super::text::{Node, NodeKind, Tree};
use super::write;
use crate::problem::Problem;
use crate::units::Quantity;

/// Names of version 0 and what they are called now.
const RENAMED_IN_1: &[(&str, &str)] =
    &[("plate", "d"), ("spacing", "L"), ("punch", "D"), ("force", "design_force")];

/// The text in the current version. Every line stays in its place.
///
/// # Errors
/// What stands in the way, at its place in the old text.
pub(crate) fn to_current(text: &str, tree: &Tree, version: u32) -> Result<String, Vec<Found>> {
    let mut edits = Vec::new();
    let mut found = Vec::new();
    if let Some(entry) = tree.root.field("version") {
        edits.push((entry.value.unwrapped().span, CURRENT_VERSION.to_string()));
    }
    if version == 0 {
        from_0(&tree.root, &mut edits, &mut found);
    }
    if found.is_empty() { Ok(super::patch::apply(text, edits)) } else { Err(found) }
}

/// A problem of the migrated text in the words of the file's own version.
pub(crate) fn in_old_words(mut problem: Problem, version: u32) -> Problem {
    if version != 0 {
        return problem;
    }
    let Some((layout, field)) = problem.field.rsplit_once("].") else { return problem };
    if let Some((was, now)) = RENAMED_IN_1.iter().find(|r| r.1 == field) {
        problem.advice = problem.advice.replace(&format!("add {now}:"), &format!("add {was}:"));
        problem.field = format!("{layout}].{was}");
    }
    if problem.allowed == LAYOUT_FIELDS.join(", ") {
        problem.advice = "format version 0 has plate, spacing, punch, force for d, L, D, \
                          design_force"
            .to_string();
    }
    problem
}

fn from_0(root: &Node, edits: &mut Vec<Edit>, found: &mut Vec<Found>) {
    let layouts = root.field("layouts").and_then(|e| e.value.unwrapped().items());
    for (index, layout) in layouts.unwrap_or_default().iter().enumerate() {
        let Some(group) = layout.value.unwrapped().group() else { continue };
        for entry in &group.entries {
            let Some((key, span)) = &entry.key else { continue };
            if let Some((was, _)) = RENAMED_IN_1.iter().find(|r| r.1 == key) {
                let problem = Problem::new(
                    format!("layouts[{index}].{key}"),
                    format!("format version 0 calls this field {was}"),
                )
                .advice(format!(
                    "if the file is of the current format, write version: {CURRENT_VERSION}"
                ));
                found.push(Found::new(span.start, problem));
            }
            if let Some((_, now)) = RENAMED_IN_1.iter().find(|r| r.0 == key) {
                edits.push((*span, (*now).to_string()));
            }
            if key == "force" {
                edits.extend(newtons(entry.value.unwrapped()));
            }
        }
    }
}

/// A force without a unit, which is in newtons, for a file in which it would be kilonewtons.
fn newtons(value: &Node) -> Option<Edit> {
    match &value.kind {
        NodeKind::Number(newton) if newton.is_finite() => {
            Some((value.span, write::number(*newton, Quantity::Force)))
        }
        NodeKind::Text(bare) if bare.trim().parse::<f64>().is_ok() => {
            Some((value.span, format!("\"{} N\"", bare.trim())))
        }
        // Text with a unit means the same in both; anything else is reported when it is read.
        _ => None,
    }
}

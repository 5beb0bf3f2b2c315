//! What differs between two states of a project, by layout and field, for people.

use super::schema::{NamedLayout, Project};
use crate::case::Input;
use crate::units::LengthUnit;

/// What the second has that the first has not, a line for the project and each layout: `bench 1: L 2.5 to
/// 2.61 m`. Layouts are the same by their uid.
pub fn difference(from: &Project, to: &Project) -> Vec<String> {
    let unit = from.display.length_unit;
    let mut lines = Vec::new();
    lines.extend(line("the project", project_fields(from, to)));
    let same = |l: &NamedLayout, others: &[NamedLayout]| others.iter().any(|o| o.uid == l.uid);
    for layout in &to.layouts {
        match from.layouts.iter().find(|l| l.uid == layout.uid) {
            Some(before) => lines.extend(line(&before.name, layout_fields(before, layout, unit))),
            None => lines.push(format!("{}: added", layout.name)),
        }
    }
    for layout in from.layouts.iter().filter(|l| !same(l, &to.layouts)) {
        lines.push(format!("{}: deleted", layout.name));
    }
    let order = |of: &Project, other: &Project| -> Vec<u64> {
        of.layouts.iter().filter(|l| same(l, &other.layouts)).map(|l| l.uid).collect()
    };
    if order(from, to) != order(to, from) {
        lines.push("the order of the layouts".to_owned());
    }
    lines
}

fn line(name: &str, fields: Vec<String>) -> Option<String> {
    (!fields.is_empty()).then(|| format!("{name}: {}", fields.join(", ")))
}

fn project_fields(from: &Project, to: &Project) -> Vec<String> {
    let mut fields = Vec::new();
    let mut add = |differs: bool, word: &str| {
        if differs {
            fields.push(word.to_owned());
        }
    };
    add(from.name != to.name, "name");
    add(from.site != to.site, "site");
    add(from.notes != to.notes, "notes");
    add(from.meshes != to.meshes, "meshes");
    add(from.display != to.display, "unit of lengths");
    fields
}

fn layout_fields(from: &NamedLayout, to: &NamedLayout, unit: LengthUnit) -> Vec<String> {
    let mut fields = Vec::new();
    for input in Input::LAYOUT {
        let (before, after) = (from.get(input), to.get(input));
        if before != after {
            let text = |value: Option<f64>| {
                value.map_or("none".to_owned(), |value| input.entry_text(value, unit))
            };
            let change = format!("{} {} to {}", input.word(), text(before), text(after));
            fields.push(format!("{change} {}", input.unit(unit)).trim_end().to_owned());
        }
    }
    let mut add = |differs: bool, word: &str| {
        if differs {
            fields.push(word.to_owned());
        }
    };
    add(from.name != to.name, "name");
    add(from.mesh != to.mesh, "mesh");
    add(from.branch != to.branch, "branch");
    add(from.overlay != to.overlay, "overlay");
    add(from.note != to.note, "note");
    add(from.check != to.check, "check");
    fields
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_named_by_layout_and_layouts_by_name() {
        let from = Project::starter("Road");
        assert_eq!(difference(&from, &from), Vec::<String>::new());
        let mut to = from.clone();
        to.site = "north".into();
        to.layouts[0].layout.spacing = 2.61;
        to.layouts[0].question.force = Some(20_000.0);
        to.layouts[0].note = "seen".into();
        to.layouts.insert(0, from.layouts[0].duplicate("portal"));
        let words = [
            "the project: site",
            "portal: added",
            "reference: L 3.00 to 2.61 m, Fd none to 20 kN, note",
        ];
        assert_eq!(difference(&from, &to), words);
        assert_eq!(difference(&to, &from)[2], "portal: deleted");
        let mut turned = to.clone();
        turned.layouts.swap(0, 1);
        assert_eq!(difference(&to, &turned), ["the order of the layouts"]);
    }
}

//! What differs between two states of a project, by layout and field, for people.

use super::schema::{NamedLayout, Project};
use crate::case::Input;
use crate::layout::{Grid, Layout};
use crate::units::Units;

/// What the second has that the first has not, a line for the project and each layout: `bench 1: L 2.5 to
/// 2.61 m`. Layouts are the same by their uid.
pub fn difference(from: &Project, to: &Project) -> Vec<String> {
    let unit = from.display.units;
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

/// The words of what differs. Those who ask take the whole apart by its fields, so that a new one cannot
/// be forgotten here.
fn words<const N: usize>(fields: [(bool, &str); N]) -> impl Iterator<Item = String> {
    fields.into_iter().filter(|(differs, _)| *differs).map(|(_, word)| word.to_owned())
}

fn project_fields(from: &Project, to: &Project) -> Vec<String> {
    // Layouts are told one by one.
    let Project {
        version: _,
        name,
        site,
        title,
        notes,
        basis,
        method_files,
        meshes,
        layouts: _,
        display,
    } = from;
    let fields = words([
        (*name != to.name, "name"),
        (*site != to.site, "site"),
        (*title != to.title, "head of the report"),
        (*notes != to.notes, "notes"),
        (*basis != to.basis, "basis of verdicts"),
        (*method_files != to.method_files, "files of methods"),
        (*meshes != to.meshes, "meshes"),
        (*display != to.display, "units shown"),
    ]);
    fields.collect()
}

fn layout_fields(from: &NamedLayout, to: &NamedLayout, unit: Units) -> Vec<String> {
    // Sizes and the question are the inputs.
    let NamedLayout { uid: _, name, layout, mesh, branch, question: _, overlay, note, check } =
        from;
    let Layout { plate: _, spacing: _, punch: _, ex: _, ey: _, blocks, method, grid, shape } =
        layout;
    // The second spacing is an input.
    let Grid { up: _, stagger, twists } = grid;
    let place = &to.layout;
    let changed = Input::LAYOUT.into_iter().filter(|input| from.get(*input) != to.get(*input));
    let inputs = changed.map(|input| {
        let text = |value: Option<f64>| {
            value.map_or("none".to_owned(), |value| input.entry_text(value, unit))
        };
        let (before, after) = (text(from.get(input)), text(to.get(input)));
        let change = format!("{} {before} to {after} {}", input.word_in(place), input.unit(unit));
        change.trim_end().to_owned()
    });
    let fields = words([
        (*name != to.name, "name"),
        (*blocks != to.layout.blocks, "blocks"),
        (*shape != to.layout.shape, "shape"),
        (*method != to.layout.method, "method"),
        (*stagger != to.layout.grid.stagger, "stagger"),
        (*twists != to.layout.grid.twists, "twists"),
        (*mesh != to.mesh, "mesh"),
        (*branch != to.branch, "branch"),
        (*overlay != to.overlay, "overlay"),
        (*note != to.note, "note"),
        (*check != to.check, "check"),
    ]);
    inputs.chain(fields).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::Blocks;
    use crate::study::verdict::Basis;

    #[test]
    fn fields_are_named_by_layout_and_layouts_by_name() {
        let from = Project::starter("Road");
        assert_eq!(difference(&from, &from), Vec::<String>::new());
        let mut to = from.clone();
        to.site = "north".into();
        to.title.author = "A. Engineer".into();
        to.basis = Basis::Mean;
        to.layouts[0].layout.spacing = 2.61;
        to.layouts[0].question.force = Some(20_000.0);
        to.layouts[0].note = "seen".into();
        to.layouts[0].layout.blocks = Blocks::Mirrored;
        to.layouts.insert(0, from.layouts[0].duplicate("portal"));
        let words = [
            "the project: site, head of the report, basis of verdicts",
            "portal: added",
            "reference: L 3.00 to 2.61 m, Fd none to 20 kN, blocks, note",
        ];
        assert_eq!(difference(&from, &to), words);
        assert_eq!(difference(&to, &from)[2], "portal: deleted");
        let mut turned = to.clone();
        turned.layouts.swap(0, 1);
        assert_eq!(difference(&to, &turned), ["the order of the layouts"]);
    }
}

//! Net and wires of a mesh in a file of their own, for the discrete element check: the `wire: (...)`
//! of a mesh type as the whole of a RON file. `projects/wire/dt-8x10-2.7.ron` is one.

use super::error::{Cause, FileFault, Found, LoadError};
use super::load::{decode_utf8, read_bytes};
use super::text::{Tree, parser};
use super::{read, words};
use crate::mesh::wire::WireData;
use crate::problem::Problem;
use std::path::Path;

/// Reads wire data from a file and checks them.
///
/// # Errors
/// All that is wrong, with line and field, as a message that fits one screen.
pub(crate) fn load_wire(path: &Path) -> Result<WireData, LoadError> {
    let shown = path.display().to_string();
    let bytes = read_bytes(path).map_err(|mut error| {
        if error.cause == Cause::NotFound {
            let advice = "meshcast calibrate --out FILE.ron writes one to start from".to_string();
            error.faults = vec![FileFault::whole("there is no such file", advice)];
        }
        error
    })?;
    parse_wire(&decode_utf8(bytes, &shown)?, &shown)
}

/// Reads wire data from a text; `shown` is the file's name for messages.
fn parse_wire(text: &str, shown: &str) -> Result<WireData, LoadError> {
    let refuse = |found: Vec<Found>, tree: Option<&Tree>| {
        let faults = found.into_iter().map(|f| FileFault::placed(text, tree, f)).collect();
        LoadError::new(shown, Cause::BadInput, faults)
    };
    if text.trim_start_matches('\u{feff}').trim().is_empty() {
        let advice = "wire data start with (net: (opening: ...".to_string();
        let fault = FileFault::whole("the file is empty", advice);
        return Err(LoadError::new(shown, Cause::BadInput, vec![fault]));
    }
    let tree = parser::parse(text).map_err(|e| refuse(vec![e.into()], None))?;
    if ["net", "single", "double_twist"].iter().all(|name| tree.root.field(name).is_none()) {
        let problem = Problem::new("", "these are no wire data")
            .value(words::shorten(tree.root.span.slice(text)))
            .advice("wire data start with (net: (opening: ...");
        return Err(refuse(vec![Found::new(tree.root.span.start, problem)], None));
    }
    let wire: WireData =
        read::values(text, &tree.root, "").map_err(|found| refuse(found, Some(&tree)))?;
    wire.check().map_err(|problems| {
        let found = |p: Problem| Found::located(&tree.root, p);
        refuse(problems.into_iter().map(found).collect(), Some(&tree))
    })?;
    Ok(wire)
}

#[cfg(test)]
mod tests {
    use super::super::write::commented;
    use super::*;
    use crate::mesh::laws;

    #[test]
    fn wire_data_come_back_from_their_file_to_the_last_bit() {
        for law in ["bench", "yade", "reference"] {
            let wire = laws::find(law).unwrap();
            let text = commented(&wire, "two\nlines").unwrap();
            assert!(text.starts_with("// two\n// lines\n("), "{text}");
            assert_eq!(parse_wire(&text, "f").unwrap(), wire, "{law}");
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_line_and_field() {
        let good = commented(&laws::bench(), "").unwrap();
        let said = |from: &str, to: &str| {
            assert!(good.contains(from), "{good}");
            parse_wire(&good.replacen(from, to, 1), "w.ron").unwrap_err().to_string()
        };
        let e = said("opening: 0.08", "opening: -0.08");
        assert!(
            e.contains("line 3") && e.contains("net.opening") && e.contains("from 0.005"),
            "{e}"
        );
        let e = said("opening: 0.08,", "");
        assert!(e.contains("net.opening") && e.contains("missing"), "{e}");
        let e = said("twist:", "twits:");
        assert!(e.contains("net.twits") && e.contains("no field of this name"), "{e}");
        let e = said("(0.0019231, 250.0)", "(0,0019231, 250.0)");
        assert!(e.contains("single[0]") && e.contains("comma"), "{e}");
        let e = said("Fixed(1.0)", "Fixed(3.0)");
        assert!(e.contains("slack") && e.contains("up to 1"), "{e}");
        let deep = good.replacen("net: (", &format!("net: {}", "{".repeat(50_000)), 1);
        assert!(parse_wire(&deep, "w.ron").unwrap_err().to_string().contains("nested too deep"));
        assert!(parse_wire(" \n", "w.ron").unwrap_err().to_string().contains("empty"));
    }
}

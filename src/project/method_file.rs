//! A derived method in a file of its own, as `meshcast derive --out FILE` writes it.

use super::write;
use crate::method::DerivedMethod;

/// A method as a file, with a comment on top.
pub(crate) fn method_text(method: &DerivedMethod, comment: &str) -> Option<String> {
    let head: String = comment.lines().map(|line| format!("// {line}\n")).collect();
    Some(format!("{head}{}\n", write::pretty(method).ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::canned;

    #[test]
    fn a_method_comes_back_from_its_file_to_the_last_bit() {
        let method = canned::method();
        let text = method_text(&method, "two\nlines").unwrap();
        assert!(text.starts_with("// two\n// lines\n("), "{text}");
        assert_eq!(DerivedMethod::from_ron(&text).unwrap(), method);
        let wrong = text.replacen("format: 1", "format: 99", 1);
        assert!(DerivedMethod::from_ron(&wrong).unwrap_err().contains("derive it again"));
        assert!(DerivedMethod::from_ron("(format: 1)").is_err());
    }
}

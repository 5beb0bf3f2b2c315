//! The forms in which something can be written, and the endings of their files: one list, so that no
//! file gets an ending that says another form than the one inside.

use std::path::Path;

/// How a file is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// Values separated by commas, a line a row.
    Csv,
    /// One page for a browser.
    Html,
    /// CommonMark with tables.
    Markdown,
    /// A drawing.
    Svg,
}

impl Form {
    /// Its name among people.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Form::Csv => "CSV",
            Form::Html => "HTML",
            Form::Markdown => "Markdown",
            Form::Svg => "SVG",
        }
    }

    /// The endings that its files may have, small letters, the usual one first.
    pub(crate) fn endings(self) -> &'static [&'static str] {
        match self {
            Form::Csv => &["csv", "txt"],
            Form::Html => &["html", "htm"],
            Form::Markdown => &["md", "markdown", "txt"],
            Form::Svg => &["svg"],
        }
    }

    /// The form among these that the ending of a path says; the first of them where it has none.
    ///
    /// # Errors
    /// The ending says another form: a sentence that names those that can be written.
    pub(crate) fn of_path(path: Option<&Path>, among: &[Form]) -> Result<Option<Form>, String> {
        let Some((path, ending)) = path.and_then(|p| Some((p, p.extension()?))) else {
            return Ok(among.first().copied());
        };
        let ending = ending.to_string_lossy().to_ascii_lowercase();
        let says = |form: &&Form| form.endings().contains(&ending.as_str());
        match among.iter().find(says) {
            Some(form) => Ok(Some(*form)),
            None => Err(refusal(path, &ending, among)),
        }
    }
}

fn refusal(path: &Path, ending: &str, among: &[Form]) -> String {
    let forms: Vec<String> = among
        .iter()
        .map(|form| {
            let endings: Vec<String> = form.endings().iter().map(|e| format!(".{e}")).collect();
            format!("{} ({})", form.word(), endings.join(", "))
        })
        .collect();
    format!(
        "{}: a file that ends in .{ending} is not what is written here; allowed: {}",
        path.display(),
        forms.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ending_says_its_form_and_no_other() {
        let form = |name: &str, among: &[Form]| Form::of_path(Some(Path::new(name)), among);
        assert_eq!(form("a/b.SVG", &[Form::Svg]), Ok(Some(Form::Svg)));
        assert_eq!(form("t.txt", &[Form::Html, Form::Markdown]), Ok(Some(Form::Markdown)));
        assert_eq!(form("plain", &[Form::Html, Form::Markdown]), Ok(Some(Form::Html)));
        assert_eq!(Form::of_path(None, &[Form::Csv]), Ok(Some(Form::Csv)));
        for (name, among) in [
            ("c.png", &[Form::Svg][..]),
            ("t.xlsx", &[Form::Csv]),
            ("r.pdf", &[Form::Html, Form::Markdown]),
            ("r.docx", &[Form::Html, Form::Markdown]),
            ("c.html", &[Form::Svg]),
        ] {
            let said = form(name, among).unwrap_err();
            for known in among {
                assert!(said.contains(known.word()), "{said}");
                assert!(said.contains(&format!(".{}", known.endings()[0])), "{said}");
            }
        }
    }
}

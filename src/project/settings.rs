//! The file of settings: a flat list of names, each with one word, such as `fidelity: quick`. Which
//! names and words there are is for the caller to say ([`KnownSettings`]); here is how the file is read,
//! changed and kept. Comments and order of a file stay; a file that cannot be read is never replaced,
//! but put aside.

use super::draft::write_atomically;
use super::error::{Cause, FileFault, Found, LoadError};
use super::hold::rewrite;
use super::home::Home;
use super::load;
use super::read::{Path, Reader};
use super::save::resolve;
use super::text::{NodeKind, Tree, parser};
use super::words;
use std::io;
use std::path::PathBuf;

/// A setting that the file may hold.
#[derive(Debug, Clone)]
pub(crate) struct KnownSettings {
    pub(crate) name: &'static str,
    /// What it may be, for messages and comments.
    pub(crate) allowed: String,
    /// What it is, for the comment in a new file.
    pub(crate) about: &'static str,
    /// Whether a word is one of its values.
    pub(crate) takes: fn(&str) -> bool,
}

/// Names and words, as the file has them.
pub(crate) type SettingWords = Vec<(String, String)>;

/// Reads a text; `shown` names the file in messages.
///
/// # Errors
/// All that is wrong, each at its line with what is allowed there.
pub(crate) fn read(
    text: &str,
    shown: &str,
    known: &[KnownSettings],
) -> Result<SettingWords, LoadError> {
    let (tree, words, found) = decode(text, known)
        .map_err(|found| LoadError::new(shown, Cause::BadInput, vec![placed(text, None, found)]))?;
    if found.is_empty() {
        return Ok(words);
    }
    let faults = found.into_iter().map(|f| placed(text, Some(&tree), f)).collect();
    Err(LoadError::new(shown, Cause::BadInput, faults))
}

fn placed(text: &str, tree: Option<&Tree>, found: Found) -> FileFault {
    FileFault::placed(text, tree, found)
}

/// The text as a tree, its words, and what is wrong with them.
fn decode(text: &str, known: &[KnownSettings]) -> Result<(Tree, SettingWords, Vec<Found>), Found> {
    let tree = parser::parse(text)?;
    let names: Vec<&str> = known.iter().map(|k| k.name).collect();
    let reader = Reader::new(text);
    let mut read = SettingWords::new();
    if let Ok(mut fields) = reader.at(&tree.root, &Path::Root("")).fields("Settings", Some(&names))
    {
        while let Some(field @ (name, entry)) = fields.next_field() {
            let node = entry.value.unwrapped();
            let word = match &node.kind {
                NodeKind::Text(word) => word.clone(),
                _ => node.span.slice(text).to_string(),
            };
            match known.iter().find(|k| k.name == name) {
                Some(setting) if !(setting.takes)(&word) => {
                    fields.note(field, words::unknown_word(setting.allowed.clone()));
                }
                _ => read.push((name.to_string(), word)),
            }
        }
    }
    let mut found = reader.found();
    for whole in found.iter_mut().filter(|f| f.problem.field.is_empty()) {
        whole.problem.advice = "settings are names and words: (fidelity: quick)".to_string();
    }
    Ok((tree, read, found))
}

/// A text with other words: the old one with nothing but the changes made, or a new one.
fn render(old: Option<&str>, wanted: &[(&str, String)], known: &[KnownSettings]) -> String {
    let Some(old) = old else { return fresh(wanted, known) };
    let Ok((tree, read, found)) = decode(old, known) else { return fresh(wanted, known) };
    if !found.is_empty() {
        return fresh(wanted, known);
    }
    let mut text = old.to_string();
    // From the back, so that the places in front stay where they are.
    let mut changes = Vec::new();
    for (name, word) in wanted {
        match read.iter().find(|(n, _)| n == name) {
            Some((_, now)) if now == word => {}
            Some(_) => changes.push((tree.root.locate(name), word.clone())),
            // A field that an older version did not have.
            None => return fresh(wanted, known),
        }
    }
    changes.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    for (span, word) in changes {
        text.replace_range(span.start..span.end, &word);
    }
    // What was changed must be what is read.
    let good = read_as(&text, known).is_some_and(|words| {
        wanted.iter().all(|(name, word)| words.iter().any(|(n, w)| n == name && w == word))
    });
    if good { text } else { fresh(wanted, known) }
}

fn read_as(text: &str, known: &[KnownSettings]) -> Option<SettingWords> {
    decode(text, known).ok().filter(|(.., found)| found.is_empty()).map(|(_, words, _)| words)
}

fn fresh(wanted: &[(&str, String)], known: &[KnownSettings]) -> String {
    let mut out = "// Settings of meshcast; :set in the program changes them too.\n(\n".to_string();
    for (name, word) in wanted {
        if let Some(k) = known.iter().find(|k| k.name == *name) {
            out.push_str(&format!("    // {}\n    // one of: {}\n", k.about, k.allowed));
        }
        out.push_str(&format!("    {name}: {word},\n"));
    }
    out.push_str(")\n");
    out
}

impl LoadError {
    /// The first thing wrong in one line: file, line, field, what is allowed.
    pub(crate) fn in_one_line(&self) -> String {
        let name = self.file.rsplit(['/', '\\']).next().unwrap_or(&self.file);
        let Some(fault) = self.faults.first() else { return format!("{name} cannot be read") };
        let p = &fault.problem;
        let line = fault.line.map_or(String::new(), |line| format!(" line {line}"));
        let field = if p.field.is_empty() { String::new() } else { format!(", {}", p.field) };
        let said = if p.allowed.is_empty() {
            p.message.clone()
        } else {
            format!(
                "{} is none of {}",
                if p.value.is_empty() { "this" } else { &p.value },
                p.allowed
            )
        };
        format!("{name}{line}{field}: {said}")
    }
}

impl Home {
    /// The words of the file of settings; nothing where there is no file.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub(crate) fn settings(
        &self,
        known: &[KnownSettings],
    ) -> Result<Option<SettingWords>, LoadError> {
        let Some(path) = self.settings_file() else { return Ok(None) };
        let shown = path.display().to_string();
        match load::read_within(&path, load::LARGEST_OWN_FILE) {
            Ok(bytes) => read(&load::decode_utf8(bytes, &shown)?, &shown, known).map(Some),
            Err(error) if error.cause == Cause::NotFound => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Changes one setting in the file, in one step. The others stay as the file has them, for another
    /// session may have changed them; `session` says what they are where the file does not. A file that
    /// could not be read is put aside first; its new name is returned. Without a place for the file
    /// nothing happens.
    ///
    /// # Errors
    /// What the system said.
    pub(crate) fn keep_setting(
        &self,
        changed: &str,
        session: &[(&str, String)],
        known: &[KnownSettings],
    ) -> io::Result<Option<PathBuf>> {
        let Some(path) = self.settings_file() else { return Ok(None) };
        // A link to the file, as people with dotfiles have, stays a link.
        let path = resolve(&path).unwrap_or(path);
        let mut aside = None;
        rewrite(&path, |old| {
            let small = old.filter(|bytes| bytes.len() as u64 <= load::LARGEST_OWN_FILE);
            let text = small.and_then(|bytes| std::str::from_utf8(bytes).ok());
            let words = text.and_then(|text| read_as(text, known));
            if let (Some(bad), None) = (old, &words) {
                let place = path.with_extension("ron.unread");
                write_atomically(&place, bad)?;
                aside = Some(place);
            }
            let words = words.unwrap_or_default();
            let wanted: Vec<(&str, String)> = session
                .iter()
                .map(|(name, word)| {
                    let kept = words.iter().find(|(n, _)| n == name && name != &changed);
                    (*name, kept.map_or(word, |(_, word)| word).clone())
                })
                .collect();
            let readable = text.filter(|text| read_as(text, known).is_some());
            Ok(Some(render(readable, &wanted, known).into_bytes()))
        })?;
        Ok(aside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn known() -> Vec<KnownSettings> {
        let word = |w: &str| ["quick", "fine"].contains(&w);
        let number = |w: &str| w == "auto" || w.parse::<u32>().is_ok();
        vec![
            KnownSettings {
                name: "speed",
                allowed: "quick, fine".into(),
                about: "how fast",
                takes: word,
            },
            KnownSettings {
                name: "runs",
                allowed: "auto or a number".into(),
                about: "n",
                takes: number,
            },
        ]
    }

    fn wanted(speed: &str, runs: &str) -> [(&'static str, String); 2] {
        [("speed", speed.to_string()), ("runs", runs.to_string())]
    }

    #[test]
    fn a_bad_word_is_told_with_file_line_field_and_what_is_allowed() {
        let text = "(\n  speed: fast, // hm\n  runs: 3,\n  live: on,\n)";
        let error = read(text, "/home/a/settings.ron", &known()).unwrap_err();
        assert_eq!(error.faults.len(), 2);
        let said = error.in_one_line();
        assert_eq!(said, "settings.ron line 2, speed: fast is none of quick, fine");
        let whole = error.to_string();
        assert!(whole.contains("line 4, column 3: live"), "{whole}");
        for bad in ["", "(", "[1]", "3", "(speed: quick, speed: fine)", "(speed: (a: 1))"] {
            assert!(read(bad, "s", &known()).is_err(), "{bad:?}");
        }
        assert!(read(&"{".repeat(50_000), "s", &known()).is_err());
        assert_eq!(read("()", "s", &known()).unwrap(), []);
        let quoted = read("(speed: \"fine\", runs: 12)", "s", &known()).unwrap();
        assert_eq!(quoted, [("speed".into(), "fine".into()), ("runs".into(), "12".into())]);
    }

    #[test]
    fn comments_stay_and_new_files_explain_themselves() {
        let first = render(None, &wanted("quick", "auto"), &known());
        assert!(
            first.contains("// how fast\n    // one of: quick, fine\n    speed: quick,\n"),
            "{first}"
        );
        let old = "// mine\n(runs: 3, /* why */ speed: quick)\n";
        let now = render(Some(old), &wanted("fine", "auto"), &known());
        assert_eq!(now, "// mine\n(runs: auto, /* why */ speed: fine)\n");
    }

    #[test]
    fn a_change_does_not_revert_that_of_another_session() {
        let dir = tempfile::tempdir().unwrap();
        let home = Home::at(Some(dir.path().to_path_buf()));
        // Both began with quick and auto.
        home.keep_setting("speed", &wanted("fine", "auto"), &known()).unwrap();
        home.keep_setting("runs", &wanted("quick", "12"), &known()).unwrap();
        let kept = home.settings(&known()).unwrap().unwrap();
        assert_eq!(kept, [("speed".into(), "fine".into()), ("runs".into(), "12".into())]);
    }

    #[test]
    fn a_file_that_cannot_be_read_is_put_aside() {
        let dir = tempfile::tempdir().unwrap();
        let home = Home::at(Some(dir.path().join("new")));
        assert_eq!(home.settings(&known()).unwrap(), None);
        assert_eq!(home.keep_setting("speed", &wanted("fine", "2"), &known()).unwrap(), None);
        let kept = home.settings(&known()).unwrap().unwrap();
        assert_eq!(kept, [("speed".into(), "fine".into()), ("runs".into(), "2".into())]);
        let file = home.settings_file().unwrap();
        fs::write(&file, "(speed: fast)").unwrap();
        assert!(home.settings(&known()).is_err());
        let aside = home.keep_setting("runs", &wanted("quick", "2"), &known()).unwrap().unwrap();
        assert_eq!(fs::read_to_string(aside).unwrap(), "(speed: fast)");
        assert!(home.settings(&known()).unwrap().is_some());
        assert_eq!(
            Home::at(None).keep_setting("runs", &wanted("quick", "2"), &known()).unwrap(),
            None
        );
    }
}

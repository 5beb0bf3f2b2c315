//! The screen that asks which project to open: a list, found by typed letters.

use super::entry::{EditTarget, LineEntry};
use super::fuzzy;
use super::key::Key;
use super::message::FoundProject;

/// The screen that asks which project to open.
#[derive(Debug, Clone)]
pub struct Picker {
    /// The letters typed.
    pub(crate) entry: LineEntry,
    /// What there is; nothing until it was found.
    pub(crate) found: Vec<FoundProject>,
    /// The marked one, an index of [`Picker::matches`].
    pub(crate) index: usize,
    /// Why the last one could not be opened.
    pub(crate) error: Option<String>,
}

impl Picker {
    pub(super) fn new(error: Option<String>) -> Picker {
        let entry = LineEntry::new(EditTarget::File, "");
        Picker { entry, found: Vec::new(), index: 0, error }
    }

    /// What fits the letters typed, the best first; all, in their order, where nothing is typed.
    pub(crate) fn matches(&self) -> Vec<&FoundProject> {
        let typed = self.entry.text();
        let fits = self.found.iter().filter_map(|f| Some((fuzzy::score(typed, &f.shown)?, f)));
        let mut fits: Vec<(i64, &FoundProject)> = fits.collect();
        if !typed.trim().is_empty() {
            fits.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
        }
        fits.into_iter().map(|(_, f)| f).collect()
    }

    /// Marks the first one worth it: not gone, and not the one that is open.
    fn mark_first(&mut self) {
        let matches = self.matches();
        let open = |f: &&FoundProject| !f.missing && !f.current;
        let first = matches.iter().position(open);
        self.index = first.or(matches.iter().position(|f| !f.missing)).unwrap_or(0);
    }

    /// Moves the mark; what is gone is passed over.
    pub(super) fn step(&mut self, lines: isize) {
        let there: Vec<bool> = self.matches().iter().map(|f| !f.missing).collect();
        let target = self.index.saturating_add_signed(lines).min(there.len().saturating_sub(1));
        let mut ahead: Box<dyn Iterator<Item = usize>> =
            if lines > 0 { Box::new(target..there.len()) } else { Box::new((0..=target).rev()) };
        if let Some(next) = ahead.find(|i| there.get(*i) == Some(&true)) {
            self.index = next;
        }
    }

    /// The projects were found.
    pub(super) fn found(&mut self, found: Vec<FoundProject>) {
        self.found = found;
        self.mark_first();
    }

    /// The one that was taken cannot be opened.
    pub(super) fn refuse(&mut self, why: String) {
        self.error = Some(why);
    }

    /// A key that is part of the text.
    pub(super) fn key(&mut self, key: Key) {
        let before = self.entry.text().to_string();
        self.entry.key(key);
        if self.entry.text() != before {
            self.error = None;
            self.mark_first();
        }
    }

    /// Pasted text.
    pub(super) fn paste(&mut self, text: &str) {
        self.entry.paste(text);
        self.mark_first();
    }
}

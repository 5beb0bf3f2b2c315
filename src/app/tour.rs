//! The first-run tour: a few short screens in the order in which a new user works.

use super::key::{Code, Key};
use super::keymap::{self, Context};
use super::message::Command;
use super::settings::SettingItem;
use super::{App, Mode};

/// One screen of the tour.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TourStop {
    /// Its heading.
    pub title: &'static str,
    /// Its lines, few enough for the smallest screen.
    pub lines: Vec<String>,
}

/// A line of the tour.
enum Line {
    /// A sentence.
    Text(&'static str),
    /// Keys, how they are printed, a word of what the key map says of them, and what they do. Where
    /// the key map says something else, the line is left out.
    Keys(Key, &'static str, &'static str, &'static str),
}

use Line::{Keys, Text};

const STOPS: &[(&str, &[Line])] = &[
    (
        "a layout and its answer",
        &[
            Text(
                "A layout is one panel: plates d, spacing L, block D. Its answer is the force F_a and \
                 the deflection delta_a at failure: with a block in every cell, so with its force on each anchor.",
            ),
            Keys(Key::plain(Code::Tab), "Tab", "layout", "the next layout"),
            Keys(Key::char('i'), "i", "warnings", "all numbers; ! marks a doubtful one"),
        ],
    ),
    (
        "turn an input",
        &[
            Keys(Key::plain(Code::Down), "Up, Down", "input", "choose an input"),
            Keys(
                Key::plain(Code::Right),
                "Left, Right",
                "increase",
                "turn it; < and > turn it faster",
            ),
            Keys(Key::plain(Code::Enter), "Enter", "type", "type a value: 0.25, 250mm"),
            Keys(Key::char('u'), "u, U", "undo", "undo, redo: try anything"),
            Text("The curve and the answer follow at once."),
        ],
    ),
    (
        "check it by simulation",
        &[
            Keys(Key::char('c'), "c", "simulation", "push a block through a simulated net"),
            Keys(Key::char('C'), "C", "check all", "all layouts; Esc ends a check"),
            Keys(Key::char('f'), "f", "exact", "quicker or finer"),
            Keys(Key::char('l'), "l", "live", "a quick check follows each edit"),
            Text(
                "The net falls differently over the block each time: 9 of 10 runs lie in the band. \
                 Doubt a forecast outside of it.",
            ),
        ],
    ),
    (
        "weigh and choose",
        &[
            Keys(Key::char('s'), "s", "sensitiv", "which input matters most"),
            Keys(Key::char('w'), "w", "sweep", "sweep an input over a range"),
            Keys(Key::char('v'), "v", "compar", "the layouts side by side"),
            Keys(Key::char('g'), "g", "design", "find the input that is just enough"),
        ],
    ),
    (
        "keep and share",
        &[
            Keys(Key::ctrl('s'), "Ctrl+S", "save", "save; :w does the same"),
            Keys(Key::char('e'), "e", "export", "export a chart, a table, a report"),
            Keys(Key::char('y'), "y, Y", "copy", "copy the answer, the table"),
            Keys(Key::char('O'), "O", "open", "open another project"),
            Text("Settings: :set. This tour again: :tour"),
            Keys(Key::char('?'), "?", "help", "the keys, on any screen"),
        ],
    ),
];

/// The screens, in order.
pub fn stops() -> Vec<TourStop> {
    let holds = |key: &Key, word: &str| {
        let mut bindings = keymap::of(Context::Main).filter(|b| b.keys.contains(key));
        bindings.any(|b| b.help.to_lowercase().contains(word))
    };
    let stop = |(title, lines): &(&'static str, &[Line])| {
        let shown: Vec<&Line> = lines
            .iter()
            .filter(|line| match line {
                Text(_) => true,
                Keys(key, _, word, _) => holds(key, word),
            })
            .collect();
        // The keys stand in a column as wide as the widest.
        let widest = shown.iter().map(|line| match line {
            Text(_) => 0,
            Keys(_, label, ..) => label.len(),
        });
        let column = widest.max().unwrap_or(0);
        let text = |line: &&Line| match line {
            Text(text) => text.to_string(),
            Keys(_, label, _, says) => format!("{label:<column$}  {says}"),
        };
        TourStop { title, lines: shown.iter().map(text).collect() }
    };
    STOPS.iter().map(stop).filter(|stop| !stop.lines.is_empty()).collect()
}

impl App {
    pub(super) fn start_tour(&mut self) {
        self.screen.show(Mode::Tour { stop: 0 });
    }

    /// The next screen of the tour, or its end.
    pub(super) fn next_stop(&mut self) -> Vec<Command> {
        let last = stops().len().saturating_sub(1);
        match *self.screen.mode() {
            Mode::Tour { stop } if stop < last => {
                self.screen.scroll(1, last);
                Vec::new()
            }
            _ => self.end_tour(),
        }
    }

    /// The screen before.
    pub(super) fn previous_stop(&mut self) {
        self.screen.scroll(-1, usize::MAX);
    }

    /// Ends the tour; it is not shown at the next start.
    pub(super) fn end_tour(&mut self) -> Vec<Command> {
        self.screen.show(Mode::Main);
        self.inform("? shows the keys, :tour this tour again");
        if self.preferences().kept.tour_seen {
            return Vec::new();
        }
        self.choose(SettingItem::Tour, "seen")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_most_five_short_screens() {
        let stops = stops();
        assert!((4..=5).contains(&stops.len()), "{}", stops.len());
        for stop in stops {
            assert!((1..=8).contains(&stop.lines.len()), "{}", stop.title);
            let letters: usize = stop.lines.iter().map(String::len).sum();
            assert!(letters <= 260, "{}: {letters}", stop.title);
        }
    }
}

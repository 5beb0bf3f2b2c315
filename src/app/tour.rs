//! The first-run tour: a few short screens in the order in which a new user works.

use super::message::Effect;
use super::settings::Item;
use super::{App, Mode};

/// One screen of the tour.
#[derive(Debug, Clone, Copy)]
pub struct Stop {
    /// Its heading.
    pub title: &'static str,
    /// Its lines, short enough for the smallest screen; a key stands first where one is to be pressed.
    pub lines: &'static [&'static str],
}

/// The screens, in order.
pub const STOPS: &[Stop] = &[
    Stop {
        title: "a layout and its answer",
        lines: &[
            "A layout is one panel: plates d, spacing L, block D.",
            "The answer is the force F_a and deflection delta_a at failure: a lower bound, and the load of each anchor.",
            "Tab   the next layout",
            "i     all numbers and warnings; ! marks a doubtful one",
        ],
    },
    Stop {
        title: "turn an input",
        lines: &[
            "Up, Down      choose an input",
            "Left, Right   turn it; < and > in large steps",
            "Enter         type a value: 0.25, 250mm",
            "u, U          undo, redo: try anything",
            "The curve and the answer follow at once.",
        ],
    },
    Stop {
        title: "check it by simulation",
        lines: &[
            "c   pushes a block through the simulated net",
            "C   checks every layout; Esc cancels",
            "f   quicker or finer; l follows your edits",
            "The band holds 9 of 10 runs: how the wires fall matters. A forecast outside of it deserves doubt.",
        ],
    },
    Stop {
        title: "weigh and choose",
        lines: &[
            "s   which input matters most",
            "w   sweep an input over a range",
            "v   compare the layouts side by side",
            "g   design: find the input that is just enough",
        ],
    },
    Stop {
        title: "keep and share",
        lines: &[
            "Ctrl+S or :w   save",
            "x              export a chart, table or report",
            "y, Y           copy the answer, the table",
            "O, :set        open a project, settings",
            "?              the keys of any screen; :tour",
        ],
    },
];

impl App {
    /// Starts the tour.
    pub(super) fn start_tour(&mut self) {
        self.mode = Mode::Tour { stop: 0 };
    }

    /// The next screen of the tour, or its end.
    pub(super) fn next_stop(&mut self) -> Vec<Effect> {
        match self.mode {
            Mode::Tour { stop } if stop + 1 < STOPS.len() => {
                self.mode = Mode::Tour { stop: stop + 1 };
                Vec::new()
            }
            _ => self.end_tour(),
        }
    }

    /// The screen before.
    pub(super) fn previous_stop(&mut self) {
        if let Mode::Tour { stop } = &mut self.mode {
            *stop = stop.saturating_sub(1);
        }
    }

    /// Ends the tour; it is not shown at the next start.
    pub(super) fn end_tour(&mut self) -> Vec<Effect> {
        self.mode = Mode::Main;
        self.inform("? shows the keys, :tour this tour again");
        if self.preferences.kept.tour_seen {
            return Vec::new();
        }
        // The word is one of the setting's own.
        self.set_setting(Item::Tour, "seen").unwrap_or_default()
    }
}

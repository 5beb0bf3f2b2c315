//! The help: made from the key map, the section of the screen it was asked on first. It lies over
//! any screen and gives it back.

use super::method;
use super::text::{PageLine, TextPage};
use crate::app::Mode;
use crate::app::keymap::{self, Context};

/// Where the help was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Topic {
    /// On a screen with keys of its own.
    Screen(Context),
    /// While a line of text was typed.
    Typing,
}

impl Topic {
    /// What the help on a screen is about.
    pub(super) fn of(mode: &Mode, empty: bool) -> Topic {
        match mode.context() {
            Some(Context::Main) if empty => Topic::Screen(Context::Empty),
            context => context.map_or(Topic::Typing, Topic::Screen),
        }
    }
}

/// What words and symbols mean that stand on the screens, in the order in which they are met.
const WORDS: [(&str, &str); 20] = [
    ("d", "side of the square anchor plates"),
    ("L", "spacing of the anchors; Lx and Ly of a grid with two (P)"),
    (
        "D",
        "diameter of the block that pushes; `punch` is its name in the laboratory test and in the paper",
    ),
    (
        "ex, ey",
        "offset of the block from the middle between four anchors, across and up the slope; the plan is drawn so",
    ),
    (
        "F_l*, delta_l*",
        "force and deflection of the mesh's laboratory punch test, brought to the standard panel of 3 m",
    ),
    ("alpha_F, alpha_delta", "ratios of field to laboratory, for the reference panel"),
    ("F_a, delta_a", "force and deflection at which the anchored panel fails: the forecast"),
    ("gamma_F, gL", "partial factor on the load; the deflection is asked at the load without it"),
    ("gamma_R, gR", "partial factor on the resistance"),
    ("use", "demand over capacity; above 100 % it is not enough"),
    ("at Fd, at F", "deflection at the design force with its factor, and without it"),
    (
        "basis",
        "which capacity verdicts go by: the mean, or the characteristic value that 95 % exceed",
    ),
    (
        "check, DEM",
        "a simulation of the net, wire by wire (discrete element method), for comparison with the forecast",
    ),
    ("alignment", "where the net's openings lie to anchors and block; checks draw several"),
    ("band", "from the 5 to the 95 % point of the runs of a check"),
    ("stale", "a check of other inputs than those there are now, or of another version"),
    ("slack", "how much longer than its chord a wire is before it pulls; drawn wire by wire"),
    ("first break", "force and deflection when the first wire breaks; the peak may come later"),
    (
        "double twist",
        "where two wires are turned round each other; the net hangs with them down the slope",
    ),
    ("extrapolated", "outside the ranges that were published"),
];

/// Columns of the keys.
const KEYS: usize = 18;

/// The help of a width, the section of a topic first.
pub(super) fn help(width: usize, topic: Topic) -> Vec<PageLine> {
    let mut page = TextPage::new(width);
    match topic {
        Topic::Typing => typing(&mut page),
        Topic::Screen(context) => keys(&mut page, context, true),
    }
    // A project without layouts is rare: its keys are told where it is one.
    let others = Context::ALL.into_iter().filter(|c| *c != Context::Empty);
    for context in others.filter(|c| Topic::Screen(*c) != topic) {
        keys(&mut page, context, false);
    }
    if topic != Topic::Typing {
        typing(&mut page);
    }
    page.heading("Commands");
    for c in keymap::COMMANDS {
        page.text(&format!("  :{:<w$} {}", c.form, c.help, w = KEYS - 1), KEYS + 3);
    }
    page.heading("Signs");
    page.text("  ! beside a number: something to know about it; i says what", 2);
    page.text("  X on the chart: failure of this layout. A to D: overlaid layouts, by the letter in the list. o: mean first break of the check by simulation, with its curve in dashes and its 5 to 95 % band in dots; x in the plan: where the first wire of each run broke, and lines of equal height of the net at 20, 40, 60 and 80 % of its largest. Dotted: the laboratory test; only its end point was published, its shape is that of Eq. 3", 2);
    page.heading("Words");
    for (word, meaning) in WORDS {
        page.text(&format!("  {word:<KEYS$} {meaning}"), KEYS + 3);
    }
    page.heading("The method");
    method(&mut page);
    page.lines
}

/// The keys of a screen; unless all are wanted, without those that other screens like it share.
fn keys(page: &mut TextPage, context: Context, all: bool) {
    page.heading(context.heading());
    // What holds on every screen is said once, with the main screen.
    let said = |action| {
        let shared = !all && keymap::shared(context, action);
        shared || !matches!(context, Context::Main | Context::Empty) && keymap::everywhere(action)
    };
    for b in keymap::of(context).filter(|b| !said(b.action)) {
        let keys: Vec<String> = b.keys.iter().map(std::string::ToString::to_string).collect();
        page.text(&format!("  {:<KEYS$} {}", keys.join(" "), b.help), KEYS + 3);
    }
}

fn typing(page: &mut TextPage) {
    page.heading("While typing");
    page.text("  Enter takes the text, Esc or Ctrl+G drops it. A refused text stays, with the reason. Ctrl+A and Ctrl+E go to the ends, Ctrl+U clears. F1 shows this help.", 2);
}

//! Styles by meaning. Colour is never the only sign: each style also differs by weight, reverse or a
//! letter, so the same screen reads without it.

use crate::app::look::{ColorMode, Glyphs, Look};
use crate::show::picture::Ink;
use ratatui::style::{Color, Modifier, Style};

/// The styles of a look.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Theme {
    /// Ordinary text.
    pub(crate) text: Style,
    /// Headings and rules.
    pub(crate) heading: Style,
    /// The title line.
    pub(crate) title: Style,
    /// What is selected.
    pub(crate) selected: Style,
    /// The selected layout's curve and its answer.
    pub(crate) forecast: Style,
    /// The check by simulation.
    pub(crate) check: Style,
    /// Overlaid curves.
    pub(crate) overlay: Style,
    /// The laboratory curve.
    pub(crate) laboratory: Style,
    /// Design lines.
    pub(crate) design: Style,
    /// What to distrust.
    pub(crate) caution: Style,
    /// What was refused.
    pub(crate) error: Style,
    /// A key in the hint bar.
    pub(crate) key: Style,
    /// Signs for charts and rules.
    pub(crate) glyphs: Glyphs,
}

impl Theme {
    /// The theme of a look.
    pub(crate) fn new(look: Look) -> Theme {
        let plain = Style::new();
        let bold = plain.add_modifier(Modifier::BOLD);
        let reverse = plain.add_modifier(Modifier::REVERSED);
        let colored = |style: Style, color: Color| match look.color {
            ColorMode::Basic16 => style.fg(color),
            ColorMode::None => style,
        };
        Theme {
            text: plain,
            heading: colored(plain, Color::Cyan),
            title: bold,
            selected: reverse,
            forecast: colored(bold, Color::Blue),
            check: colored(plain, Color::Green),
            overlay: colored(plain, Color::Magenta),
            laboratory: plain,
            design: colored(plain, Color::Yellow),
            caution: colored(bold, Color::Yellow),
            error: colored(reverse, Color::Red),
            key: bold,
            glyphs: look.glyphs,
        }
    }

    /// The style of what a drawing shows.
    pub(crate) fn ink(&self, ink: Ink) -> Style {
        match ink {
            Ink::Text => self.text,
            Ink::Heading => self.heading,
            Ink::Title => self.title,
            Ink::Selected => self.selected,
            Ink::Forecast => self.forecast,
            Ink::Check => self.check,
            Ink::Overlay => self.overlay,
            Ink::Laboratory => self.laboratory,
            Ink::Design => self.design,
            Ink::Caution => self.caution,
        }
    }
}

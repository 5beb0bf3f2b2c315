//! Seen: a screen reader, a braille line and an input method found the cursor wherever the last byte
//! was drawn, and hidden.
//!
//! Cause: the place of the selection was told by colours and signs alone.

use crate::cost::Bench;
use crate::program::with_sample;
use meshcast::app::key::{Code, Key};
use meshcast::app::look::Look;

/// The row with the cursor, and its text from the cursor on.
fn at_cursor(bench: &Bench) -> String {
    let (row, column) = bench.emulator().screen().cursor_position();
    let rows: Vec<String> = bench.emulator().screen().rows(column, u16::MAX).collect();
    rows[usize::from(row)].clone()
}

#[test]
fn the_cursor_stands_on_what_is_selected_in_every_screen() {
    for size in [(80, 24), (120, 40), (70, 20), (40, 12)] {
        let mut bench = Bench::new(Look::default(), size);
        bench.watch();
        for (keys, from) in [
            // Inputs, and one typed.
            ("", "0.25 m"),
            ("J", "2.50 m"),
            ("jk2.5", "_"),
            // Lists.
            ("m", ">* dt-8x10-2.7"),
            (":set\r", "> "),
            ("e", "> "),
            // Text.
            ("?", "Main screen"),
            ("i", ""),
            ("O", "_"),
            (":", "_"),
            ("r", "_"),
            // Pages of studies.
            ("v", ">"),
            ("w", "L]"),
            ("g", ""),
            ("s", ""),
        ] {
            for key in keys.chars() {
                let key = match key {
                    '\r' => Key::plain(Code::Enter),
                    'J' => Key::plain(Code::Down),
                    'K' => Key::plain(Code::Up),
                    key => Key::char(key),
                };
                bench.press(key);
            }
            let screen = bench.emulator().screen();
            assert!(!screen.hide_cursor(), "{keys:?} at {size:?}");
            let text = at_cursor(&bench);
            // A cursor behind typed text stands on a blank.
            let found = if from == "_" { text.starts_with(' ') } else { text.starts_with(from) };
            assert!(found, "{keys:?} at {size:?}: {text:?}\n{}", screen.contents());
            for key in [Code::Esc, Code::Esc] {
                bench.press(Key::plain(key));
            }
        }
    }
}

#[test]
fn after_every_key_the_cursor_is_back() {
    let (launch, _) = with_sample();
    let pty = launch.start();
    pty.wait_for("bench 1");
    pty.settle();
    let place = || pty.screen(|screen| (screen.cursor_position(), screen.hide_cursor()));
    let ((row, column), hidden) = place();
    assert!(!hidden);
    for (keys, rows) in [("\x1b[B", 1), ("\x1b[C", 1), ("\x1b[B", 2), ("\x1b[A\x1b[A", 0)] {
        pty.send(keys);
        pty.wait_until("the cursor on its row", |screen| {
            screen.cursor_position() == (row + rows, column) && !screen.hide_cursor()
        });
    }
}

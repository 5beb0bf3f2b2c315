//! How much goes over the line: bytes a key, measured with the painter that the program uses.
//!
//! The limits are those of a slow serial line or a bad SSH connection: 1,500 bytes for an edit of a
//! value at 80x24, 4,000 for any other key, nothing where nothing changed.

use crate::harness::*;
use meshcast::app::App;
use meshcast::app::look::Look;
use meshcast::app::message::Message;
use meshcast::term::{Charset, Painter};

const EDIT: usize = 1_500;
const OTHER: usize = 4_000;

struct Line {
    app: App,
    painter: Painter,
}

impl Line {
    fn new(look: Look) -> Line {
        let app = start(road_cut(), (80, 24), look);
        let mut line = Line { app, painter: Painter::new(Charset::Utf8) };
        line.bytes();
        line
    }

    /// Bytes of the next frame.
    fn bytes(&mut self) -> usize {
        let Line { app, painter } = self;
        painter.paint(app.size(), app.look().color, |buf| meshcast::ui::draw(app, buf)).len()
    }

    /// The largest frame of a key script, a frame a key.
    fn largest(&mut self, script: &str) -> usize {
        let mut largest = 0;
        for key in keys(script) {
            self.app.update(Message::Key(key));
            largest = largest.max(self.bytes());
        }
        largest
    }
}

const LOOKS: [(&str, Look); 3] = [("color", COLOR), ("mono", MONO), ("ascii", ASCII)];

#[test]
fn an_edit_of_a_value_stays_small() {
    for (word, look) in LOOKS {
        let mut line = Line::new(look);
        // Every input of every layout, stepped finely and coarsely both ways, and typed.
        let mut largest = 0;
        for _ in 0..5 {
            for _ in 0..9 {
                for script in ["<Right>", "<Right>", "<Left>", ">", "<lt>", "<Del>", "u"] {
                    largest = largest.max(line.largest(script));
                }
                line.largest("<Down>");
            }
            line.largest(&"<Up>".repeat(9));
            line.largest("<Tab>");
        }
        for script in ["0.31<Enter>", "<Down>3.1m<Enter>", "<Down>700mm<Enter>"] {
            largest = largest.max(line.largest(script));
        }
        println!("{word}: largest frame of an edit {largest} bytes");
        assert!(largest < EDIT, "{word}: {largest} bytes");
    }
}

#[test]
fn any_other_key_stays_bounded() {
    for (word, look) in LOOKS {
        let mut line = Line::new(look);
        let script = "<Tab><Tab><Tab><Tab>o<Tab>o<Tab>o<Tab>t?  <Esc>i <Esc>m<Esc>rxx<Esc>:units m<Enter>byJKxuUa<Right>q<Esc>";
        let largest = line.largest(script);
        println!("{word}: largest frame of any key {largest} bytes");
        assert!(largest < OTHER, "{word}: {largest} bytes");
    }
}

#[test]
fn nothing_changed_sends_nothing() {
    let mut line = Line::new(COLOR);
    assert_eq!(line.bytes(), 0);
    // The last input has none below, and Ctrl with a letter of no meaning only says so once.
    line.largest("<Down><Down><Down><Down><Down><Down><Down><Down>");
    assert_eq!(line.largest("<Down>"), 0);
    line.app.update(Message::Resize { width: 80, height: 24 });
    assert_eq!(line.bytes(), 0);
}

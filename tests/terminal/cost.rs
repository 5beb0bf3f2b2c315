//! What the program's own screens cost on the line, in bytes a key.

use meshcast::app::key::{Code, Key};
use meshcast::app::look::{ColorMode, Glyphs, Look};
use meshcast::app::message::Message;
use meshcast::app::settings::Preferences;
use meshcast::app::{App, Start};
use meshcast::term::{Charset, Painter, Program};
use std::path::Path;
use std::sync::Arc;

/// Most bytes for an edit of a value at 80x24.
const EDIT: usize = 1500;
/// Most bytes for any other key at 80x24.
const OTHER: usize = 4000;

const LOOKS: [Look; 3] = [
    Look { color: ColorMode::Basic16, glyphs: Glyphs::Braille },
    Look { color: ColorMode::None, glyphs: Glyphs::Block },
    Look { color: ColorMode::None, glyphs: Glyphs::Ascii },
];

/// The program with its painter, without a terminal, or with one that shows what was painted.
pub(crate) struct Bench {
    app: App,
    painter: Painter,
    size: (u16, u16),
    emulator: Option<vt100::Parser>,
}

impl Bench {
    pub(crate) fn new(look: Look, size: (u16, u16)) -> Bench {
        // The sample as it is, design lines on the chart included.
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("projects/road-cut.ron");
        let project = meshcast::project::load(&file).unwrap().project;
        let app = App::new(Start {
            project: Arc::new(project),
            path: Some("/site/road-cut.ron".into()),
            note: None,
            kept: None,
            holder: None,
            look,
            units: meshcast::units::ChosenUnits::default(),
            size,
            preferences: Preferences::default(),
        });
        let painter = Painter::new(Charset::Utf8);
        let mut bench = Bench { app, painter, size, emulator: None };
        bench.paint();
        bench
    }

    /// An emulator follows from here on.
    pub(crate) fn watch(&mut self) {
        let mut emulator = emulator(self.size);
        emulator.process(&without_selectors(&self.whole()));
        self.emulator = Some(emulator);
    }

    /// What follows the program's screen.
    pub(crate) fn emulator(&self) -> &vt100::Parser {
        self.emulator.as_ref().expect("an emulator was asked for")
    }

    /// The screen as the emulator shows it after all that was painted.
    pub(crate) fn shown(&self) -> Vec<String> {
        rows(self.emulator())
    }

    /// The screen as it would be if all of it were drawn now.
    pub(crate) fn fresh(&self) -> Vec<String> {
        let mut emulator = emulator(self.size);
        emulator.process(&without_selectors(&self.whole()));
        rows(&emulator)
    }

    /// The bytes of the whole screen.
    fn whole(&self) -> Vec<u8> {
        let mut painter = Painter::new(Charset::Utf8);
        let color = self.app.look().color;
        painter.paint(self.size, color, |buffer| Program::draw(&self.app, buffer)).to_vec()
    }

    fn paint(&mut self) -> usize {
        let Bench { app, painter, size, emulator } = self;
        let bytes = painter.paint(*size, app.look().color, |buffer| Program::draw(app, buffer));
        if let Some(emulator) = emulator {
            emulator.process(&without_selectors(bytes));
        }
        bytes.len()
    }

    /// Bytes that a key costs.
    pub(crate) fn press(&mut self, key: Key) -> usize {
        self.app.update(Message::Key(key));
        self.paint()
    }
}

fn emulator((width, height): (u16, u16)) -> vt100::Parser {
    let size = |n| std::num::NonZeroU16::new(n).unwrap();
    vt100::Parser::new(size(height), size(width), 0)
}

/// What a terminal without variation selectors, such as tmux 3.3, takes of the bytes.
fn without_selectors(bytes: &[u8]) -> Vec<u8> {
    String::from_utf8_lossy(bytes).replace('\u{fe0f}', "").into_bytes()
}

fn rows(emulator: &vt100::Parser) -> Vec<String> {
    let rows = emulator.screen().rows(0, u16::MAX);
    rows.map(|row| row.trim_end().to_owned()).collect()
}

fn plain(code: Code) -> Key {
    Key::plain(code)
}

#[test]
fn an_edit_of_a_value_is_cheap() {
    for look in LOOKS {
        let mut most = (0, String::new());
        let mut count = |bytes: usize, what: String| {
            if bytes > most.0 {
                most = (bytes, what);
            }
        };
        let mut bench = Bench::new(look, (80, 24));
        for layout in 0..5 {
            for field in 0..5 {
                for key in [
                    plain(Code::Right),
                    plain(Code::Left),
                    plain(Code::Left),
                    Key::char('>'),
                    Key::char('>'),
                    Key::char('<'),
                ] {
                    count(bench.press(key), format!("{key} at field {field} of layout {layout}"));
                }
                for text in ["0.5", "1.1", "250mm", "2.75"] {
                    bench.press(plain(Code::Enter));
                    for _ in 0..8 {
                        bench.press(plain(Code::Backspace));
                    }
                    for c in text.chars() {
                        count(bench.press(Key::char(c)), format!("typing {c} of {text}"));
                    }
                    let taken = bench.press(plain(Code::Enter));
                    count(taken, format!("{text} in field {field} of layout {layout}"));
                    bench.press(plain(Code::Esc));
                }
                bench.press(plain(Code::Down));
            }
            bench.press(plain(Code::Tab));
        }
        println!("{look:?}: dearest edit {} bytes ({})", most.0, most.1);
        assert!(most.0 < EDIT, "{look:?}: {most:?}");
    }
}

#[test]
fn no_key_is_dear() {
    let keys: Vec<Key> = meshcast::app::keymap::all()
        .flat_map(|binding| binding.keys.iter().copied())
        .chain("0123456789.m:abc".chars().map(Key::char))
        .chain([plain(Code::Enter), plain(Code::Esc), plain(Code::Backspace)])
        .collect();
    for look in LOOKS {
        let mut bench = Bench::new(look, (80, 24));
        let mut most = (0, Key::char(' '));
        let mut random = 0x2545_f491_u64;
        for _ in 0..4000 {
            random = random
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let key = keys[(random >> 33) as usize % keys.len()];
            let bytes = bench.press(key);
            if bytes > most.0 {
                most = (bytes, key);
            }
            assert_eq!(bench.paint(), 0, "nothing changed after {key}");
        }
        println!("{look:?}: dearest key {} bytes ({})", most.0, most.1);
        assert!(most.0 < OTHER, "{look:?}: {most:?}");
    }
}

#[test]
fn the_first_screen() {
    for (size, budget) in [((80, 24), 4000), ((120, 40), 8000), ((200, 60), 16000)] {
        for look in LOOKS {
            let bench = Bench::new(look, size);
            let bytes = bench.painter.meter().last;
            println!("{look:?} at {size:?}: first screen {bytes} bytes");
            assert!(bytes < budget);
        }
    }
}

//! Drives the program's state by key scripts and dumps its screens with styles.

use crate::canned::news;
use meshcast::app::key::{Code, Key};
use meshcast::app::look::{ColorMode, Glyphs, Look};
use meshcast::app::message::{Command, Message};
use meshcast::app::settings::Preferences;
use meshcast::app::{App, Start};
use meshcast::job::Order;
use meshcast::layout::{Layout, REFERENCE};
use meshcast::mesh::REFERENCE_ID;
use meshcast::project::schema::{NamedLayout, Project};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier};
use std::path::PathBuf;
use std::sync::Arc;

/// Five layouts, the rows of Table 1 of Pol & Gabrieli (2021).
pub(crate) fn road_cut() -> Project {
    let rows = [
        ("bench 2", [0.25, 2.5, 0.60, 0.0, 0.0]),
        ("shelf", [0.32, 2.5, 0.20, 0.0, 0.0]),
        ("bench 3", [0.40, 3.0, 1.25, 0.0, 0.0]),
        ("portal", [0.40, 4.0, 1.20, 2.0, 0.20]),
        ("gully", [0.25, 3.5, 0.80, 0.55, 1.15]),
    ];
    let mut project = Project::starter("Road cut");
    project.layouts = rows
        .into_iter()
        .map(|(name, [plate, spacing, punch, ex, ey])| {
            NamedLayout::new(
                name,
                Layout { plate, spacing, punch, ex, ey, ..REFERENCE },
                REFERENCE_ID,
            )
        })
        .collect();
    project
}

/// The state at the start, with a file that was never written.
pub(crate) fn start(project: Project, size: (u16, u16), look: Look) -> App {
    App::new(Start {
        project: Arc::new(project),
        path: Some(PathBuf::from("/site/road-cut.ron")),
        note: None,
        kept: None,
        holder: None,
        look,
        units: meshcast::units::ChosenUnits::default(),
        size,
        preferences: Preferences::default(),
    })
}

/// Colours and braille, as a UTF-8 terminal has them.
pub(crate) const COLOR: Look = Look { color: ColorMode::Basic16, glyphs: Glyphs::Braille };
/// No colour, block signs.
pub(crate) const MONO: Look = Look { color: ColorMode::None, glyphs: Glyphs::Block };
/// No colour, plain ASCII.
pub(crate) const ASCII: Look = Look { color: ColorMode::None, glyphs: Glyphs::Ascii };

/// How a main screen is pictured: four sizes in one look, and the other looks at the standard size. All
/// others are pictured once, at 80x24.
pub(crate) const PICTURES: [(&str, (u16, u16), Look); 6] = [
    ("40x12_color", (40, 12), COLOR),
    ("80x24_color", (80, 24), COLOR),
    ("120x40_color", (120, 40), COLOR),
    ("200x60_color", (200, 60), COLOR),
    ("80x24_mono", (80, 24), MONO),
    ("80x24_ascii", (80, 24), ASCII),
];

/// The keys of a script: characters stand for themselves, `<...>` names a key: `<Enter>`, `<Esc>`,
/// `<Tab>`, `<Up>`, `<PgDn>`, `<C-s>`, `<S-Left>`, `<lt>` for the sign itself.
pub(crate) fn keys(script: &str) -> Vec<Key> {
    let mut keys = Vec::new();
    let mut rest = script;
    while let Some(c) = rest.chars().next() {
        if c == '<'
            && let Some(end) = rest.find('>')
        {
            keys.push(named(&rest[1..end]));
            rest = &rest[end + 1..];
        } else {
            keys.push(Key::char(c));
            rest = &rest[c.len_utf8()..];
        }
    }
    keys
}

fn named(name: &str) -> Key {
    let code = |n: &str| match n {
        "Enter" => Code::Enter,
        "Esc" => Code::Esc,
        "Tab" => Code::Tab,
        "BackTab" => Code::BackTab,
        "BS" => Code::Backspace,
        "Del" => Code::Delete,
        "Up" => Code::Up,
        "Down" => Code::Down,
        "Left" => Code::Left,
        "Right" => Code::Right,
        "PgUp" => Code::PageUp,
        "PgDn" => Code::PageDown,
        "Home" => Code::Home,
        "End" => Code::End,
        "F1" => Code::F(1),
        "lt" => Code::Char('<'),
        other => panic!("no key {other}"),
    };
    if let Some(c) = name.strip_prefix("C-") {
        return Key::ctrl(c.chars().next().unwrap());
    }
    match name.strip_prefix("S-") {
        Some(n) => Key::shift(code(n)),
        None => Key::plain(code(name)),
    }
}

/// Presses the keys of a script; returns all effects.
pub(crate) fn press(app: &mut App, script: &str) -> Vec<Command> {
    keys(script).into_iter().flat_map(|key| app.update(Message::Key(key))).collect()
}

/// The screen of a size.
pub(crate) fn screen(app: &App) -> Buffer {
    let (width, height) = app.size();
    let mut buf = Buffer::empty(Rect { x: 0, y: 0, width, height });
    meshcast::ui::draw(app, &mut buf);
    buf
}

/// The characters of a screen, a line a row, blanks at the end left out.
pub(crate) fn text(app: &App) -> String {
    let buf = screen(app);
    rows(&buf)
        .map(|row| {
            row.iter().map(ratatui::buffer::Cell::symbol).collect::<String>().trim_end().to_string()
                + "\n"
        })
        .collect()
}

fn rows(buf: &Buffer) -> impl Iterator<Item = &[ratatui::buffer::Cell]> {
    buf.content().chunks(usize::from(buf.area.width))
}

/// The screen with its styles: the characters, then a map of the same shape with a letter for each
/// style that is not plain, then what the letters mean.
pub(crate) fn styled(app: &App) -> String {
    let buf = screen(app);
    let mut legend: Vec<(Color, Modifier)> = Vec::new();
    let mut map = String::new();
    for row in rows(&buf) {
        let line: String = row
            .iter()
            .map(|cell| {
                let style = (cell.fg, cell.modifier);
                if style == (Color::Reset, Modifier::empty()) {
                    return ' ';
                }
                let at = legend.iter().position(|s| *s == style).unwrap_or_else(|| {
                    legend.push(style);
                    legend.len() - 1
                });
                char::from(b'a' + at as u8)
            })
            .collect();
        map.push_str(line.trim_end());
        map.push('\n');
    }
    let legend: String = legend
        .iter()
        .enumerate()
        .map(|(i, (color, modifier))| {
            format!("{} = {color:?} {modifier:?}\n", char::from(b'a' + i as u8))
        })
        .collect();
    format!("{}----\n{map}----\n{legend}", text(app))
}

/// Two small cells, and one that cannot be checked: the block is on a plate.
pub(crate) fn small() -> Project {
    let layout = |spacing, ex| Layout { plate: 0.25, spacing, punch: 0.4, ex, ey: ex, ..REFERENCE };
    let mut project = Project::starter("Small");
    project.layouts = vec![
        NamedLayout::new("one", layout(1.3, 0.0), REFERENCE_ID),
        NamedLayout::new("two", layout(1.4, 0.0), REFERENCE_ID),
        NamedLayout::new("on a plate", layout(1.4, 0.7), REFERENCE_ID),
    ];
    project
}

/// Takes the work among some effects as done and tells the state of it, see [`crate::canned`]; the
/// orders, as they were.
pub(crate) fn work(app: &mut App, effects: Vec<Command>) -> Vec<Order> {
    let ordered = |effect| match effect {
        Command::Work(order) => Some(order),
        _ => None,
    };
    let orders: Vec<Order> = effects.into_iter().filter_map(ordered).collect();
    for order in &orders {
        for news in news(order) {
            let more = app.update(Message::Work(news));
            assert!(more.is_empty(), "{more:?}");
        }
    }
    orders
}

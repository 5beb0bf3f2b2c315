//! The encoder against a terminal emulator: whatever sequence of screens is painted, the emulator must
//! end up showing the last one.

use super::*;
use proptest::prelude::*;
use ratatui::style::{Color, Modifier, Style};
use std::num::NonZeroU16;

fn terminal(width: u16, height: u16) -> vt100::Parser {
    let size = |n| NonZeroU16::new(n).unwrap();
    vt100::Parser::new(size(height), size(width), 0)
}

/// The number of a colour as the emulator tells it.
fn color(color: vt100::Color) -> Option<u8> {
    match color {
        vt100::Color::Default => None,
        vt100::Color::Idx(n) => Some(n),
        vt100::Color::Rgb(..) => panic!("no such colour was sent"),
    }
}

/// Everything visible of a cell in the emulator: text, colours, attributes.
type Visible = (String, Option<u8>, Option<u8>, [bool; 5]);

fn visible(
    text: &str,
    fg: Option<u8>,
    bg: Option<u8>,
    [bold, dim, italic, underline, inverse]: [bool; 5],
) -> Visible {
    let text = if text.is_empty() { " " } else { text };
    if text == " " && !underline && !inverse {
        return (text.to_owned(), None, bg, [false; 5]);
    }
    (text.to_owned(), fg, bg, [bold, dim, italic, underline, inverse])
}

fn on_terminal(cell: &vt100::Cell) -> Visible {
    visible(
        cell.contents(),
        color(cell.fgcolor()),
        color(cell.bgcolor()),
        [cell.bold(), cell.dim(), cell.italic(), cell.underline(), cell.inverse()],
    )
}

fn number(color: Color) -> Option<u8> {
    const NAMED: [Color; 16] = [
        Color::Black,
        Color::Red,
        Color::Green,
        Color::Yellow,
        Color::Blue,
        Color::Magenta,
        Color::Cyan,
        Color::Gray,
        Color::DarkGray,
        Color::LightRed,
        Color::LightGreen,
        Color::LightYellow,
        Color::LightBlue,
        Color::LightMagenta,
        Color::LightCyan,
        Color::White,
    ];
    NAMED.iter().position(|named| *named == color).map(|n| n as u8)
}

/// Compares every cell of the emulator with the buffer.
fn assert_shown(terminal: &vt100::Parser, buffer: &Buffer, mode: ColorMode) {
    let colored = mode == ColorMode::Basic16;
    for y in 0..buffer.area.height {
        let mut x = 0;
        while x < buffer.area.width {
            let cell = &buffer[(x, y)];
            let width = unicode_width::UnicodeWidthStr::width(cell.symbol()) as u16;
            let cut = x + width > buffer.area.width;
            let modifier = cell.modifier;
            let wanted = visible(
                if cut { " " } else { cell.symbol() },
                number(cell.fg).filter(|_| colored),
                number(cell.bg).filter(|_| colored),
                [
                    modifier.contains(Modifier::BOLD),
                    modifier.contains(Modifier::DIM),
                    modifier.contains(Modifier::ITALIC),
                    modifier.contains(Modifier::UNDERLINED),
                    modifier.contains(Modifier::REVERSED),
                ],
            );
            let found = on_terminal(terminal.screen().cell(y, x).unwrap());
            assert_eq!(found, wanted, "column {x}, row {y}");
            x += if cut { 1 } else { width };
        }
    }
}

/// A stroke of random text at a random place.
#[derive(Debug, Clone)]
struct Stroke {
    x: u16,
    y: u16,
    text: String,
    style: Style,
}

const WIDTH: u16 = 24;
const HEIGHT: u16 = 7;

fn style() -> impl Strategy<Value = Style> {
    let color = prop_oneof![
        4 => Just(Color::Reset),
        1 => Just(Color::Red),
        1 => Just(Color::Cyan),
        1 => Just(Color::DarkGray),
        1 => Just(Color::White),
    ];
    let modifier = prop_oneof![
        6 => Just(Modifier::empty()),
        1 => Just(Modifier::BOLD),
        1 => Just(Modifier::DIM),
        1 => Just(Modifier::REVERSED),
        1 => Just(Modifier::UNDERLINED | Modifier::BOLD),
        1 => Just(Modifier::ITALIC | Modifier::REVERSED),
    ];
    (color.clone(), color, modifier)
        .prop_map(|(fg, bg, modifier)| Style::new().fg(fg).bg(bg).add_modifier(modifier))
}

fn stroke() -> impl Strategy<Value = Stroke> {
    let symbols = prop::sample::select(vec![
        " ", " ", " ", "a", "7", "-", "⣿", "⠁", "─", "█", "δ", "網", "金", "e\u{301}", "~",
    ]);
    let text = prop::collection::vec(symbols, 1..30).prop_map(|symbols| symbols.concat());
    (0..WIDTH, 0..HEIGHT, text, style()).prop_map(|(x, y, text, style)| Stroke {
        x,
        y,
        text,
        style,
    })
}

fn screens() -> impl Strategy<Value = Vec<Vec<Stroke>>> {
    prop::collection::vec(prop::collection::vec(stroke(), 0..14), 1..7)
}

/// A screen without a cursor.
fn copy(next: &mut Buffer, buffer: &Buffer) -> Option<Position> {
    next.clone_from(buffer);
    None
}

/// Paints each screen on top of the one before or on an empty one, and checks the emulator each time.
fn replay(screens: &[Vec<Stroke>], mode: ColorMode, on_top: bool) {
    let mut painter = Painter::new(Charset::Utf8);
    let mut emulator = terminal(WIDTH, HEIGHT);
    emulator.process(b"left over from before\x1b[5;5H\x1b[41mmore");
    let mut buffer = Buffer::empty(Rect::new(0, 0, WIDTH, HEIGHT));
    for strokes in screens {
        if !on_top {
            buffer.reset();
        }
        for stroke in strokes {
            buffer.set_string(stroke.x, stroke.y, &stroke.text, stroke.style);
        }
        // The emulator takes bold and dim as two settings of one thing.
        for cell in &mut buffer.content {
            if cell.modifier.contains(Modifier::BOLD) {
                cell.modifier.remove(Modifier::DIM);
            }
        }
        let bytes = painter.paint((WIDTH, HEIGHT), mode, |next| copy(next, &buffer));
        if mode == ColorMode::None {
            assert!(!has_color(bytes), "{}", String::from_utf8_lossy(bytes).escape_debug());
        }
        emulator.process(bytes);
        assert_shown(&emulator, &buffer, mode);
        let again = painter.paint((WIDTH, HEIGHT), mode, |next| copy(next, &buffer));
        assert!(again.is_empty());
    }
}

/// Whether any graphic rendition in the bytes sets a colour, or is the bare `ESC[m`.
fn has_color(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes).into_owned();
    text.split("\x1b[").skip(1).any(|part| {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != ';').unwrap_or(part.len());
        part[end..].starts_with('m')
            && part[..end].split(';').any(|code| code.parse().map_or(true, |n: u8| n >= 30))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_terminal_shows_what_was_painted(screens in screens(), on_top: bool) {
        replay(&screens, ColorMode::Basic16, on_top);
    }

    #[test]
    fn without_colours_no_colour_is_sent(screens in screens(), on_top: bool) {
        replay(&screens, ColorMode::None, on_top);
    }
}

fn paint(painter: &mut Painter, draw: impl FnOnce(&mut Buffer)) -> String {
    let draw = |buffer: &mut Buffer| {
        draw(buffer);
        None
    };
    let bytes = painter.paint((WIDTH, HEIGHT), ColorMode::Basic16, draw);
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn the_first_frame_clears_and_an_equal_one_sends_nothing() {
    let mut painter = Painter::new(Charset::Utf8);
    let draw = |buffer: &mut Buffer| buffer.set_string(0, 0, "31.0 kN", Style::new());
    assert_eq!(paint(&mut painter, draw), "\x1b[0m\x1b[H\x1b[2J31.0 kN");
    assert_eq!(paint(&mut painter, draw), "");
    assert_eq!(painter.meter(), Meter { frames: 1, bytes: 18, last: 0, largest: 18 });
}

#[test]
fn a_changed_digit_costs_a_move_and_the_digit() {
    let mut painter = Painter::new(Charset::Utf8);
    let draw = |text: &'static str| {
        move |buffer: &mut Buffer| buffer.set_string(2, 3, text, Style::new().bold())
    };
    paint(&mut painter, draw("31.0 kN"));
    assert_eq!(paint(&mut painter, draw("31.5 kN")), "\x1b[4D5");
}

#[test]
fn a_row_that_empties_is_cleared_at_once() {
    let mut painter = Painter::new(Charset::Utf8);
    paint(&mut painter, |buffer| {
        buffer.set_string(0, 1, "a long line of words", Style::new().red());
    });
    assert_eq!(paint(&mut painter, |_| {}), "\r\x1b[K");
}

#[test]
fn a_clear_leaves_no_colour_behind() {
    let mut painter = Painter::new(Charset::Utf8);
    let mut emulator = terminal(WIDTH, HEIGHT);
    let mut buffer = Buffer::empty(Rect::new(0, 0, WIDTH, HEIGHT));
    buffer.set_string(0, 0, "xxxxxxxxxxxxxxxx", Style::new().on_red().reversed());
    emulator
        .process(painter.paint((WIDTH, HEIGHT), ColorMode::Basic16, |next| copy(next, &buffer)));
    buffer.reset();
    buffer.set_string(0, 0, "x", Style::new().on_blue());
    emulator
        .process(painter.paint((WIDTH, HEIGHT), ColorMode::Basic16, |next| copy(next, &buffer)));
    assert_shown(&emulator, &buffer, ColorMode::Basic16);
}

#[test]
fn a_new_size_or_colour_mode_draws_all_of_it() {
    let mut painter = Painter::new(Charset::Utf8);
    let draw = |buffer: &mut Buffer| {
        buffer.set_string(0, 0, "x", Style::new().red());
        None
    };
    painter.paint((10, 2), ColorMode::Basic16, draw);
    assert_eq!(painter.paint((12, 2), ColorMode::Basic16, draw), b"\x1b[0m\x1b[H\x1b[2J\x1b[31mx");
    assert_eq!(painter.paint((12, 2), ColorMode::None, draw), b"\x1b[0m\x1b[H\x1b[2Jx");
    painter.forget();
    let again = painter.paint((12, 2), ColorMode::None, draw);
    assert_eq!(again, b"\x1b[0m\x1b[H\x1b[2Jx\x1b[?25l");
    assert_eq!(painter.paint((12, 2), ColorMode::None, draw), b"");
}

#[test]
fn odd_sizes_do_no_harm() {
    let mut painter = Painter::new(Charset::Utf8);
    for size in [(0, 0), (1, 0), (0, 5), (1, 1), (300, 1), (1, 300)] {
        painter.paint(size, ColorMode::Basic16, |buffer| {
            buffer.content.iter_mut().for_each(|cell| {
                cell.set_symbol("網");
            });
            Some(Position::new(5, 5))
        });
    }
}

#[test]
fn a_buffer_of_another_size_does_no_harm() {
    let mut painter = Painter::new(Charset::Utf8);
    for area in [Rect::new(0, 0, 3, 2), Rect::new(0, 0, 40, 9), Rect::new(5, 5, 4, 4)] {
        painter.paint((10, 4), ColorMode::Basic16, |buffer| {
            *buffer = Buffer::filled(area, ratatui::buffer::Cell::new("x"));
            Some(Position::new(9, 3))
        });
    }
}

#[test]
fn a_terminal_without_utf8_gets_ascii() {
    let mut painter = Painter::new(Charset::Ascii);
    let bytes = painter.paint((10, 2), ColorMode::Basic16, |buffer| {
        buffer.set_string(0, 0, "Hütte 網 ⣿", Style::new());
        None
    });
    assert!(bytes.is_ascii());
    assert!(bytes.ends_with(b"H?tte ?  ?"), "{}", String::from_utf8_lossy(bytes));
}

/// The bytes of a frame with the cursor somewhere, or nowhere.
fn paint_with(painter: &mut Painter, text: &str, place: Option<(u16, u16)>) -> String {
    let bytes = painter.paint((WIDTH, HEIGHT), ColorMode::Basic16, |buffer| {
        buffer.set_string(0, 0, text, Style::new());
        place.map(Position::from)
    });
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn the_cursor_rests_where_it_is_wanted_and_moves_at_the_price_of_a_move() {
    let mut painter = Painter::new(Charset::Utf8);
    let first = paint_with(&mut painter, "abc", Some((1, 2)));
    assert_eq!(first, "\x1b[0m\x1b[H\x1b[2Jabc\x1b[3;2H\x1b[?25h");
    assert_eq!(paint_with(&mut painter, "abc", Some((1, 2))), "");
    assert_eq!(paint_with(&mut painter, "abc", Some((1, 3))), "\x1b[B");
    // A change elsewhere, and back.
    assert_eq!(paint_with(&mut painter, "abd", Some((1, 3))), "\x1b[1;3Hd\x1b[4;2H");
    assert_eq!(paint_with(&mut painter, "abd", None), "\x1b[?25l");
    // Beyond the screen is nowhere.
    assert_eq!(paint_with(&mut painter, "abd", Some((WIDTH, 0))), "");
}

#[test]
fn after_the_terminal_was_taken_anew_the_cursor_is_shown_again() {
    let mut painter = Painter::new(Charset::Utf8);
    paint_with(&mut painter, "abc", Some((1, 2)));
    painter.forget();
    assert!(paint_with(&mut painter, "abc", Some((1, 2))).ends_with("\x1b[?25h"));
}

/// Terminals that draw a picture in one column and those that draw it in two: neither keeps anything
/// of the screen before.
#[test]
fn around_a_picture_nothing_is_left_of_the_former_screen() {
    for picture in ["🏔\u{fe0f}", "♻\u{fe0f}", "👍", "🇮🇹", "👨\u{200d}👩\u{200d}👧"]
    {
        let mut painter = Painter::new(Charset::Utf8);
        paint_with(&mut painter, "bench valley road", None);
        let sent = paint_with(&mut painter, &format!("bench {picture}ley road"), None);
        // Both cells are written, the second one as a blank or with what follows.
        let base = picture.chars().next().unwrap();
        let wide = unicode_width::UnicodeWidthChar::width(base) == Some(2);
        let wanted = if wide { format!("  \u{8}\u{8}{base}") } else { format!("{base}\x1b[1;8H ") };
        assert!(sent.contains(&wanted), "{}", sent.escape_debug());
    }
}

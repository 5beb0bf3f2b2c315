//! What goes over the line, and when.

use crate::pty::Launch;
use crate::toy::toy;

#[test]
fn an_idle_program_sends_nothing() {
    let pty = toy().start();
    pty.wait_for("count 0");
    let before = pty.settle();
    std::thread::sleep(std::time::Duration::from_millis(1200));
    assert_eq!(pty.settle() - before, 0);
}

#[test]
fn a_key_that_changes_nothing_sends_nothing() {
    let pty = toy().start();
    pty.wait_for("count 0");
    assert_eq!(pty.cost_of("n"), 0);
    assert_eq!(pty.cost_of("d"), 0);
    assert_eq!(pty.cost_of("ndndnd"), 0);
    let before = pty.settle();
    pty.send("+");
    pty.wait_for("count 1");
    let sent = pty.received()[before..].to_vec();
    assert_eq!(String::from_utf8(sent).unwrap(), "\x1b[1;19H\x1b[0;1;96m1");
}

#[test]
fn a_held_key_is_drawn_in_few_frames() {
    let pty = toy().start();
    pty.wait_for("count 0");
    let cost = pty.cost_of(&"+".repeat(200));
    pty.wait_for("count 200");
    assert!(cost < 200 * 4, "{cost} bytes");
}

#[test]
fn a_new_size_draws_the_whole_screen() {
    let pty = toy().size(80, 24).start();
    pty.wait_for("toy 80x24");
    pty.settle();
    for (width, height) in [(120, 40), (40, 12), (20, 3), (1, 1), (100, 30)] {
        pty.resize(width, height);
        if width >= 20 {
            pty.wait_for(&format!("toy {width}x{height}"));
            pty.wait_until("the last cell", |screen| {
                (0..3).all(|n| {
                    let cell = screen.cell(height - 1, width - 3 + n);
                    cell.is_some_and(vt100::Cell::inverse)
                })
            });
        }
    }
}

#[test]
fn redraw_repairs_the_screen() {
    let pty = toy().start();
    pty.wait_for("count 0");
    let before = pty.settle();
    assert!(pty.cost_of("r") > 80 * 23);
    let again = pty.received()[before..].to_vec();
    assert!(again.starts_with(b"\x1b[0m\x1b[H\x1b[2J"));
    pty.wait_for("row 23");
}

#[test]
fn keys_and_pastes_arrive() {
    let pty = toy().start();
    pty.wait_for("count 0");
    for (bytes, name) in [
        ("\x1b[A", "Up"),
        ("\x1bOB", "Down"),
        ("\x1b[1;2C", "Shift+Right"),
        ("\x1b[1;5D", "Ctrl+Left"),
        ("\x1b[Z", "Shift+Tab"),
        ("\x13", "Ctrl+S"),
        ("\x07", "Ctrl+G"),
        ("\x11", "Ctrl+Q"),
        ("\r", "Enter"),
        ("\n", "Enter"),
        ("\x7f", "Backspace"),
        ("\x08", "Backspace"),
        ("\x1b[3~", "Delete"),
        ("\x1b[5~", "PgUp"),
        ("\x1b[H", "Home"),
        ("\x1b[11~", "F1"),
        ("\x1bOP", "F1"),
        ("\x1b[1;3C", "Alt+Right"),
        ("\x1b\x1b[D", "Alt+Left"),
        ("?", "?"),
        ("é", "é"),
        ("\x1b", "Esc"),
    ] {
        // Something else in between, so that an old answer cannot be taken for the new one.
        pty.send("_");
        pty.wait_for("key _");
        pty.send(bytes);
        pty.wait_for(&format!("key {name}"));
    }
    pty.send("\x1b[200~0.25 m\x1b[201~");
    pty.wait_for("pasted 0.25 m");
}

#[test]
fn any_terminal_will_do() {
    for term in ["", "xterm", "screen", "tmux", "putty", "vt100", "linux", "dumb"] {
        let pty = toy().env("TERM", term).start();
        pty.wait_for("count 0");
        pty.settle();
        let mut sent = pty.received();
        let colors = ["", "vt100", "dumb"].contains(&term) == has(&sent, b"\x1b[1m");
        assert!(colors, "{term}: {}", String::from_utf8_lossy(&sent).escape_debug());
        if term == "vt100" {
            // What the harness prints before is not ours.
            sent.drain(..sent.windows(8).position(|w| w == b"\x1b[?1049h").unwrap());
            assert!(sent.is_ascii());
        }
    }
}

#[test]
fn no_color_keeps_attributes() {
    let pty = toy().env("NO_COLOR", "1").start();
    pty.wait_for("count 0");
    pty.settle();
    pty.screen(|screen| {
        let cell = screen.cell(0, 0).unwrap();
        assert!(cell.bold());
        assert_eq!(cell.fgcolor(), vt100::Color::Default);
        assert!(screen.cell(23, 79).unwrap().inverse());
    });
    assert!(!has(&pty.received(), b"\x1b[m"));
}

#[test]
fn a_worker_can_write_to_the_program() {
    let pty = toy().start();
    pty.wait_for("count 0");
    pty.send("m");
    pty.wait_for("a letter");
}

#[test]
fn the_mouse_is_left_alone() {
    let pty = toy().start();
    pty.wait_for("count 0");
    pty.screen(|screen| {
        assert_eq!(screen.mouse_protocol_mode(), vt100::MouseProtocolMode::None);
        assert!(screen.alternate_screen() && screen.hide_cursor() && screen.bracketed_paste());
    });
    assert!(!pty.is_cooked());
}

#[test]
fn helpers_reach_a_plain_program() {
    let mut pty = Launch::program("/bin/echo").arg("hello").size(40, 5).start();
    pty.wait_for("hello");
    assert!(pty.wait_exit().success());
    assert!(pty.dump().starts_with("hello"));
}

fn has(bytes: &[u8], part: &[u8]) -> bool {
    bytes.windows(part.len()).any(|window| window == part)
}

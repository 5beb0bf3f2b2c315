//! Keys of the terminal library to keys of the program.

use crate::app::key::{Code, Key};
use crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

/// The key the program knows for this event; `None` for releases and for keys it has no name for.
pub(crate) fn key_from(event: KeyEvent) -> Option<Key> {
    if event.kind == KeyEventKind::Release {
        return None;
    }
    let ctrl = event.modifiers.contains(KeyModifiers::CONTROL);
    let alt = event.modifiers.contains(KeyModifiers::ALT);
    let mut shift = event.modifiers.contains(KeyModifiers::SHIFT);
    let code = match event.code {
        // Serial lines and some terminals send ^H for Backspace and ^J for Enter.
        KeyCode::Char('h') if ctrl && !alt => return Some(Key::plain(Code::Backspace)),
        KeyCode::Char('j') if ctrl && !alt => return Some(Key::plain(Code::Enter)),
        KeyCode::Char(c) if c.is_control() => return None,
        KeyCode::Char(c) => {
            shift = false;
            let c = if ctrl { c.to_lowercase().next().unwrap_or(c) } else { c };
            Code::Char(c)
        }
        KeyCode::Enter => Code::Enter,
        KeyCode::Esc => Code::Esc,
        KeyCode::Tab if shift => {
            shift = false;
            Code::BackTab
        }
        KeyCode::Tab => Code::Tab,
        KeyCode::BackTab => {
            shift = false;
            Code::BackTab
        }
        KeyCode::Backspace => Code::Backspace,
        KeyCode::Delete => Code::Delete,
        KeyCode::Up => Code::Up,
        KeyCode::Down => Code::Down,
        KeyCode::Left => Code::Left,
        KeyCode::Right => Code::Right,
        KeyCode::PageUp => Code::PageUp,
        KeyCode::PageDown => Code::PageDown,
        KeyCode::Home => Code::Home,
        KeyCode::End => Code::End,
        KeyCode::F(n) => Code::F(n),
        _ => return None,
    };
    Some(Key { code, ctrl, alt, shift })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(code: KeyCode, modifiers: KeyModifiers) -> Option<Key> {
        key_from(KeyEvent::new(code, modifiers))
    }

    #[test]
    fn printable_keys_carry_no_shift() {
        assert_eq!(key(KeyCode::Char('G'), KeyModifiers::SHIFT), Some(Key::char('G')));
        assert_eq!(key(KeyCode::Char('?'), KeyModifiers::NONE), Some(Key::char('?')));
    }

    #[test]
    fn control_letters_are_lower_case() {
        let both = KeyModifiers::CONTROL | KeyModifiers::SHIFT;
        assert_eq!(key(KeyCode::Char('S'), both), Some(Key::ctrl('s')));
        assert_eq!(key(KeyCode::Char('z'), KeyModifiers::CONTROL), Some(Key::ctrl('z')));
    }

    #[test]
    fn shift_stays_with_arrows_and_is_part_of_back_tab() {
        assert_eq!(key(KeyCode::Left, KeyModifiers::SHIFT), Some(Key::shift(Code::Left)));
        assert_eq!(key(KeyCode::BackTab, KeyModifiers::SHIFT), Some(Key::plain(Code::BackTab)));
        assert_eq!(key(KeyCode::Tab, KeyModifiers::SHIFT), Some(Key::plain(Code::BackTab)));
    }

    #[test]
    fn serial_backspace_and_enter() {
        let ctrl = KeyModifiers::CONTROL;
        assert_eq!(key(KeyCode::Char('h'), ctrl), Some(Key::plain(Code::Backspace)));
        assert_eq!(key(KeyCode::Char('j'), ctrl), Some(Key::plain(Code::Enter)));
    }

    #[test]
    fn releases_and_unknown_keys_are_dropped() {
        let mut event = KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE);
        event.kind = KeyEventKind::Release;
        assert_eq!(key_from(event), None);
        event.kind = KeyEventKind::Repeat;
        assert_eq!(key_from(event), Some(Key::plain(Code::Enter)));
        assert_eq!(key(KeyCode::Insert, KeyModifiers::NONE), None);
        assert_eq!(key(KeyCode::Char('\u{7}'), KeyModifiers::NONE), None);
    }
}

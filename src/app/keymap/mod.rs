//! The one key map: which key does what, in which screen, and how help and hint bar say it.
//!
//! - [`mod@action`]: what a key can ask for; [`context`]: the screens.
//! - [`table`]: the keys, a line each; [`commands`]: the commands of the `:` line.

mod action;
mod commands;
mod context;
mod table;

pub use action::{Action, Ask, StudyPage};
pub use commands::COMMANDS;
pub use context::Context;

use super::key::Key;

/// One line of the key map.
#[derive(Debug, Clone, Copy)]
pub struct Binding {
    /// What it does.
    pub action: Action,
    /// Its keys; the first is the one to teach.
    pub keys: &'static [Key],
    /// What it does, for the help.
    pub help: &'static str,
    /// A word for the hint bar, for the bindings that belong there.
    pub hint: Option<&'static str>,
}

/// What a key does in a screen.
pub(crate) fn action(context: Context, key: Key) -> Option<Action> {
    of(context).find(|b| b.keys.contains(&key)).map(|b| b.action)
}

/// The bindings of a screen, in order: its own, then those that hold everywhere, then those of all
/// pages of studies.
pub fn of(context: Context) -> impl Iterator<Item = &'static Binding> {
    // The main screen says the same at its own place.
    let own = matches!(context, Context::Main | Context::Empty);
    let common = if own { &[] } else { table::EVERYWHERE };
    let pages = if context.is_study() { table::PAGES } else { &[] };
    table::own(context).iter().chain(common).chain(pages)
}

/// Whether an action has the same keys on every screen.
pub(crate) fn everywhere(action: Action) -> bool {
    table::EVERYWHERE.iter().any(|b| b.action == action)
}

/// Whether a page of a study has an action from the keys that hold on all of them, which the help
/// lists with the first one.
pub(crate) fn shared(context: Context, action: Action) -> bool {
    let later = context.is_study() && context != Context::Sensitivity;
    later && table::PAGES.iter().any(|b| b.action == action)
}

/// The bindings of all screens.
pub fn all() -> impl Iterator<Item = &'static Binding> {
    Context::ALL.into_iter().flat_map(of)
}

#[cfg(test)]
mod tests {
    use super::super::key::Code;
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_key_has_two_meanings_in_one_screen() {
        let mut seen = HashSet::new();
        for context in Context::ALL {
            for key in of(context).flat_map(|b| b.keys) {
                assert!(seen.insert((context, *key)), "{key} twice in {context:?}");
            }
        }
    }

    #[test]
    fn every_action_can_be_reached_by_a_key_that_every_terminal_sends() {
        // Function keys, Alt and Shift with arrows do not arrive everywhere; control keys may be
        // eaten by serial hops, and saving and leaving have the command line for that case.
        let plain = |k: &Key| !k.alt && !k.shift && !matches!(k.code, Code::F(_));
        for b in all() {
            assert!(b.keys.iter().any(plain), "{:?}", b.action);
        }
    }

    #[test]
    fn what_holds_everywhere_has_the_same_keys_on_the_main_screen() {
        for common in table::EVERYWHERE {
            let main = of(Context::Main).find(|b| b.action == common.action).unwrap();
            assert_eq!(main.keys, common.keys, "{:?}", common.action);
        }
    }

    #[test]
    fn every_screen_has_help() {
        for context in Context::ALL {
            let help = action(context, Key::char('?'));
            assert_eq!(help, Some(Action::Help), "{context:?}");
        }
    }

    #[test]
    fn every_screen_can_be_left_without_escape() {
        // Escape is slow or lost on some links.
        for context in Context::ALL {
            let leave = [Action::Close, Action::Quit];
            assert!(
                of(context).any(|b| leave.contains(&b.action)
                    && b.keys.iter().any(|k| k.code != Code::Esc && k.code != Code::Enter)),
                "{context:?}"
            );
        }
    }
}

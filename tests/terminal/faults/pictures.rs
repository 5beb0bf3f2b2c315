//! Seen: beside a name with an emoji and a variation selector letters of the former screen stayed:
//! `bench 🏔️v`.
//!
//! Cause: the sign was taken as two columns wide, as the selector asks, while the terminal drew one and
//! left the next cell as it was.

use crate::cost::Bench;
use meshcast::app::key::{Code, Key};
use meshcast::app::look::Look;

#[test]
fn nothing_of_the_former_screen_stays_beside_a_picture() {
    for name in ["bench 🏔\u{fe0f} top", "♻\u{fe0f}♻\u{fe0f}x", "1\u{fe0f}\u{20e3} 👍\u{1f3fd}"]
    {
        let mut bench = Bench::new(Look::default(), (80, 24));
        bench.watch();
        for key in [Key::char('r'), Key::ctrl('u')] {
            bench.press(key);
        }
        name.chars().for_each(|c| {
            bench.press(Key::char(c));
        });
        for key in "\rvqsqvq".chars() {
            let key = if key == '\r' { Key::plain(Code::Enter) } else { Key::char(key) };
            bench.press(key);
            assert_eq!(bench.shown(), bench.fresh(), "after {key} with {name:?}");
        }
    }
}

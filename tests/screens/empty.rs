//! A project without layouts: whatever is pressed, typed or pasted, the screen can be drawn.

use crate::harness::*;
use meshcast::app::message::{Command, Message};
use meshcast::app::{App, keymap};
use meshcast::project::schema::Project;
use std::collections::HashSet;

fn empty() -> App {
    let mut project = Project::starter("Quarry");
    project.layouts.clear();
    start(project, (80, 24), MONO)
}

/// Draws every screen there is.
fn draw(app: &mut App) {
    for (width, height) in [(39, 11), (40, 12), (80, 24), (120, 40), (200, 60)] {
        app.update(Message::Resize { width, height });
        screen(app);
    }
    app.update(Message::Resize { width: 80, height: 24 });
}

#[test]
fn the_screen_offers_to_add_a_layout_and_undo_goes_back_to_it() {
    let mut app = empty();
    assert!(text(&app).contains("no layouts yet: a adds one"), "{}", text(&app));
    press(&mut app, "a");
    assert_eq!(app.layout().name, "layout");
    // From a page of a study too, which has nothing to show then.
    press(&mut app, "su");
    assert!(text(&app).contains("no layouts yet"), "{}", text(&app));
    press(&mut app, "?");
    assert!(text(&app).contains("a project without layouts"), "{}", text(&app));
}

#[test]
fn every_key_is_safe_on_it() {
    let all: HashSet<_> = keymap::all().flat_map(|binding| binding.keys).copied().collect();
    for key in &all {
        for after in &all {
            let mut app = empty();
            app.update(Message::Key(*key));
            app.update(Message::Key(*after));
            screen(&app);
        }
        let mut app = empty();
        app.update(Message::Key(*key));
        draw(&mut app);
    }
}

#[test]
fn every_command_and_paste_is_safe_on_it() {
    let commands = [
        "1",
        "0",
        "mesh dt-8x10-2.7",
        "mesh x",
        "check",
        "check all",
        "live on",
        "export chart",
        "export plan",
        "export table",
        "name x",
        "site y",
        "units mm",
        "undo",
        "redo",
        "set",
        "tour",
    ];
    for command in commands {
        let mut app = empty();
        for effect in press(&mut app, &format!(":{command}<Enter>")) {
            assert!(!matches!(effect, Command::Work(_)), "{command}");
        }
        draw(&mut app);
    }
    let mut app = empty();
    app.update(Message::Paste("2.5".into()));
    app.update(Message::Burst(keys("2.5<Enter>")));
    draw(&mut app);
    press(&mut app, ":check<Enter>");
    assert!(text(&app).contains("no layouts yet; a adds one"), "{}", text(&app));
    assert!(!app.edited());
}

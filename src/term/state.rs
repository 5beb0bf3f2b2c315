//! The program's state as the loop sees it.

use super::program::Program;
use crate::app::look::Look;
use crate::app::message::{Command, Message};
use crate::app::{App, Start};
use crate::project::Project;
use crate::ui;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Arc;

/// Whether a project can be taken up and drawn without bringing out a fault of the program. Nothing is
/// said of one; call it before there are other threads.
pub(crate) fn can_be_shown(project: &Project) -> bool {
    let said = take_hook();
    set_hook(Box::new(|_| {}));
    // Everything that a fault could leave half done is dropped with it.
    let shown = catch_unwind(AssertUnwindSafe(|| {
        let app = App::new(Start::of(project.clone()));
        let (width, height) = app.size();
        ui::draw(&app, &mut Buffer::empty(Rect { x: 0, y: 0, width, height }));
    }));
    set_hook(said);
    shown.is_ok()
}

impl Program for App {
    fn update(&mut self, message: Message) -> Vec<Command> {
        App::update(self, message)
    }

    fn draw(&self, buffer: &mut Buffer) -> Option<Position> {
        ui::draw(self, buffer)
    }

    fn take_dirty(&mut self) -> bool {
        App::take_dirty(self)
    }

    fn unsaved(&self) -> Option<Arc<Project>> {
        App::unsaved(self)
    }

    fn look(&self) -> Look {
        App::look(self)
    }
}

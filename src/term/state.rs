//! The program's state as the loop sees it.

use super::program::Program;
use crate::app::App;
use crate::app::look::Look;
use crate::app::message::{Command, Message};
use crate::project::Project;
use crate::ui;
use ratatui::buffer::Buffer;
use ratatui::layout::Position;
use std::sync::Arc;

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

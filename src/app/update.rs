//! What each message does to the state.

use super::entry::{EditTarget, LineEntry, LineKey};
use super::key::{Code, Key};
use super::keymap::{self, Action};
use super::message::{Command, Message};
use super::{App, Mode, settings};
use crate::case::{Input, StepSize};
use crate::units::Quantity;
use std::path::Path;

impl App {
    /// Takes a message; returns what is to be done.
    pub fn update(&mut self, message: Message) -> Vec<Command> {
        self.dirty = true;
        let mut effects = self.take(message);
        effects.extend(self.follow_edit());
        self.follow_page();
        self.files.note(&effects);
        effects
    }

    fn take(&mut self, message: Message) -> Vec<Command> {
        match message {
            Message::Key(key) => self.key(key),
            Message::Paste(text) => {
                self.paste(&text);
                Vec::new()
            }
            Message::Burst(keys) => self.burst(&keys),
            Message::Resize { width, height } => {
                self.size = (width, height);
                Vec::new()
            }
            Message::Saved(result) => self.saved(result),
            Message::HangUp => {
                let mut effects = Vec::new();
                if let Some(project) = self.unsaved() {
                    effects.push(Command::Recover { project });
                }
                effects.push(Command::Quit);
                effects
            }
            Message::Exported(result) => {
                self.files.written(result.is_ok());
                self.exported(result);
                self.go_on()
            }
            Message::Work(news) => {
                self.news(news);
                Vec::new()
            }
            Message::Resumed => vec![Command::Redraw],
            Message::Projects(found) => {
                self.found_projects(found);
                Vec::new()
            }
            Message::Opened(result) => self.opened(result),
            Message::SettingsKept(result) => {
                self.files.written(result.is_ok());
                match result {
                    Ok(Some(note)) => self.inform(note),
                    Ok(None) => {}
                    Err(why) => self.complain(why),
                }
                self.go_on()
            }
            Message::Trouble(text) => {
                self.complain(text);
                Vec::new()
            }
        }
    }

    pub(super) fn key(&mut self, key: Key) -> Vec<Command> {
        self.status = None;
        if let Mode::Entry(entry) = &mut self.mode {
            // A question mark is text here.
            if key == Key::plain(Code::F(1)) {
                self.toggle_help();
                return Vec::new();
            }
            return match entry.key(key) {
                LineKey::Typing => Vec::new(),
                LineKey::Drop => {
                    self.mode = self.behind();
                    Vec::new()
                }
                LineKey::Take => self.take_entry(),
            };
        }
        let Some(context) = self.context() else { return Vec::new() };
        match keymap::action(context, key) {
            Some(action) => self.act(action),
            None => {
                match &mut self.mode {
                    Mode::Main => self.start_typing(key),
                    Mode::Open(picker) => picker.key(key),
                    Mode::Study(page) => {
                        let page = *page;
                        self.study_key(page, key);
                    }
                    _ => {}
                }
                Vec::new()
            }
        }
    }

    /// A digit, a point or a minus on the main screen starts a value.
    fn start_typing(&mut self, key: Key) {
        let Key { code: Code::Char(c), ctrl: false, alt: false, .. } = key else { return };
        if c.is_ascii_digit()
            || c == '.'
            || (c == '-' && self.field.row().quantity == Quantity::Length)
        {
            self.mode = Mode::Entry(LineEntry::new(EditTarget::Value(self.field), c));
        } else {
            self.inform(format!("{key} does nothing here; ? shows the keys"));
        }
    }

    fn act(&mut self, action: Action) -> Vec<Command> {
        if let Mode::Study(page) = self.mode
            && let Some(effects) = self.study_act(page, action)
        {
            return effects;
        }
        match action {
            Action::FieldUp => self.select_field(false),
            Action::FieldDown => self.select_field(true),
            Action::StepUp => self.step_field(StepSize::Fine, true),
            Action::StepDown => self.step_field(StepSize::Fine, false),
            Action::CoarseUp => self.step_field(StepSize::Coarse, true),
            Action::CoarseDown => self.step_field(StepSize::Coarse, false),
            Action::Type => {
                let text = self.layout().get(self.field);
                let text = text.map_or(String::new(), |v| self.field.entry_text(v, self.units()));
                self.mode = Mode::Entry(LineEntry::new(EditTarget::Value(self.field), text));
            }
            Action::Clear if self.field.clearable() => self.set_field(None),
            Action::Clear => {
                self.inform(format!("{} needs a value; type one", self.field.word()));
            }
            Action::NextLayout => self.select_layout(true),
            Action::PreviousLayout => self.select_layout(false),
            Action::Add => self.add_layout(),
            Action::Duplicate => self.duplicate_layout(),
            Action::Rename => {
                self.mode =
                    Mode::Entry(LineEntry::new(EditTarget::Name, self.layout().name.clone()));
            }
            Action::Note => {
                self.mode =
                    Mode::Entry(LineEntry::new(EditTarget::Note, self.layout().note.clone()));
            }
            Action::Delete => self.delete_layout(),
            Action::MoveUp => self.move_layout(false),
            Action::MoveDown => self.move_layout(true),
            Action::Overlay => self.toggle_overlay(),
            Action::PickMesh => {
                let index = self.meshes().iter().position(|c| c.mesh.id == self.layout().mesh);
                self.mode = Mode::MeshPicker { index: index.unwrap_or(0) };
            }
            Action::Branch => self.toggle_branch(),
            Action::Units => self.set_units(self.units().other()),
            Action::Undo => self.undo(),
            Action::Redo => self.redo(),
            Action::Save => return self.save(None, false),
            Action::Command => self.mode = Mode::Entry(LineEntry::new(EditTarget::Command, "")),
            Action::Details => self.mode = Mode::Details { scroll: 0 },
            Action::Help => self.toggle_help(),
            Action::Suspend => return vec![Command::Suspend],
            Action::Redraw => return vec![Command::Redraw],
            Action::Quit => return self.ask_to_quit(),
            Action::Up => self.scroll(-1),
            Action::Down => self.scroll(1),
            Action::PageUp => self.scroll(-self.page()),
            Action::PageDown => self.scroll(self.page()),
            Action::Take if matches!(self.mode, Mode::Open(_)) => return self.take_project(),
            Action::Take if matches!(self.mode, Mode::Export { .. }) => {
                return self.take_export();
            }
            Action::Take => self.take_mesh(),
            // Going on without a decision would let new edits take the place of the kept ones.
            Action::Close if matches!(self.mode, Mode::ConfirmRecovery { .. }) => {
                return self.quit(None);
            }
            Action::Close if matches!(self.mode, Mode::Tour { .. }) => return self.end_tour(),
            Action::Close if matches!(self.mode, Mode::Help { .. }) => self.toggle_help(),
            Action::Close => {
                if let Mode::Open(_) = self.mode {
                    self.files.stop_opening();
                }
                self.mode = self.behind();
            }
            Action::SaveAndQuit => return self.save_and_quit(),
            Action::Discard => return self.discard(),
            Action::Overwrite => return self.overwrite(),
            Action::Restore => self.restore(),
            Action::Open => return self.show_picker(None),
            Action::SaveAndOpen => return self.save_and_open(),
            Action::CopyAnswer => return self.copy_answer(),
            Action::CopyTable => return self.copy_table(),
            Action::CopyPage => return self.copy_page(),
            Action::NextStop => return self.next_stop(),
            Action::PreviousStop => self.previous_stop(),
            Action::Check => return self.start_check(false),
            Action::CheckAll => return self.start_check(true),
            Action::Live => return self.toggle_live(),
            Action::Fidelity => return self.next_fidelity(),
            Action::Stop => return self.stop_work(),
            Action::Export => self.mode = Mode::Export { index: 0 },
            Action::NextWord => return self.change_marked_setting(true),
            Action::PreviousWord => return self.change_marked_setting(false),
            Action::Study(ask) => self.study_ask(ask),
        }
        Vec::new()
    }

    fn select_field(&mut self, down: bool) {
        let at = Input::LAYOUT.iter().position(|f| *f == self.field).unwrap_or(0);
        let last = Input::LAYOUT.len() - 1;
        self.field = Input::LAYOUT[if down { (at + 1).min(last) } else { at.saturating_sub(1) }];
    }

    fn select_layout(&mut self, next: bool) {
        let count = self.project.layouts.len();
        self.selected = (self.selected + if next { 1 } else { count - 1 }) % count;
    }

    /// Lines of a page of the pager.
    fn page(&self) -> isize {
        isize::from(self.size.1 as i16).saturating_sub(4).max(1)
    }

    fn scroll(&mut self, lines: isize) {
        let meshes = self.meshes().len();
        let last = self.pager_lines().saturating_sub(self.page() as usize);
        match &mut self.mode {
            Mode::Help { scroll } | Mode::Details { scroll } => {
                *scroll = scroll.saturating_add_signed(lines).min(last);
            }
            Mode::Export { index } => {
                let kinds = crate::export::ExportKind::ALL.len() as isize;
                *index = (*index as isize + lines).rem_euclid(kinds) as usize;
            }
            Mode::MeshPicker { index } => {
                *index = (*index as isize + lines).rem_euclid(meshes as isize) as usize;
            }
            Mode::Open(_) => self.step_picker(lines),
            Mode::Settings { index } => {
                let last = settings::SettingItem::ALL.len() - 1;
                *index = index.saturating_add_signed(lines).min(last);
            }
            _ => {}
        }
    }

    fn take_mesh(&mut self) {
        if let Mode::MeshPicker { index } = self.mode
            && let Some(choice) = self.meshes().get(index)
        {
            self.mode = Mode::Main;
            // The choice came from the list, so the mesh is known.
            if let Err(refusal) = self.set_mesh(&choice.mesh.id) {
                self.complain(refusal);
            }
        }
    }

    /// Enter in a line of text: a text that is refused stays, with the reason.
    fn take_entry(&mut self) -> Vec<Command> {
        let behind = self.behind();
        let Mode::Entry(entry) = std::mem::replace(&mut self.mode, behind) else {
            return Vec::new();
        };
        let text = entry.text().to_string();
        let result = match entry.target {
            EditTarget::Value(field) => {
                field.read(&text, &self.layout().layout, self.units()).map(|value| {
                    self.set_field(value);
                    Vec::new()
                })
            }
            EditTarget::Name => self.rename_layout(&text).map(|()| Vec::new()),
            EditTarget::Note => {
                self.set_note(&text);
                Ok(Vec::new())
            }
            EditTarget::Command => self.command(&text),
            EditTarget::File => Ok(self.ask_to_open(Path::new(&text))),
            EditTarget::Study(typed) => self.take_typed(typed, &text).map(|()| Vec::new()),
        };
        result.unwrap_or_else(|refusal| {
            self.mode = Mode::Entry(LineEntry { error: Some(refusal), ..entry });
            Vec::new()
        })
    }

    fn restore(&mut self) {
        match std::mem::replace(&mut self.mode, Mode::Main) {
            Mode::ConfirmRecovery { kept } => {
                self.edit("kept edits taken back", |project| *project = (*kept).clone());
                self.inform("the kept edits are back, not saved yet; u undoes this");
            }
            other => self.mode = other,
        }
    }
}

//! What each message does to the state.

use super::entry::{EditTarget, LineEntry, LineKey};
use super::key::{Code, Key};
use super::keymap::{self, Action};
use super::mesh_form::MeshForm;
use super::message::{Command, Message};
use super::settings::SettingItem;
use super::{App, Mode};
use crate::case::{Input, StepSize};
use crate::export::ExportKind;
use crate::job::news::What;
use crate::units::Quantity;
use std::path::Path;

impl App {
    /// Takes a message; returns what is to be done.
    pub fn update(&mut self, message: Message) -> Vec<Command> {
        self.screen.touch();
        let mut effects = self.take(message);
        if self.editor.empty() {
            self.screen.leave_layout();
        }
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
                self.screen.resize(width, height);
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
                match news.what {
                    What::FormRefused(problems) => self.form_refused(&problems),
                    What::Adopted { uid, mesh, remarks } => {
                        self.adopted((news.number, uid), &mesh, &remarks);
                    }
                    _ => {
                        if let Some(said) = self.work.news(&mut self.editor, news) {
                            self.screen.say(said);
                        }
                    }
                }
                Vec::new()
            }
            Message::Resumed => vec![Command::Redraw],
            Message::Projects(found) => {
                if let Some(picker) = self.screen.picker() {
                    picker.found(found);
                }
                Vec::new()
            }
            Message::Opened(result) => self.opened(result),
            Message::MethodRead { of, result } => {
                self.method_read(&of, result);
                Vec::new()
            }
            Message::Held(holder) => {
                self.held(holder);
                Vec::new()
            }
            Message::Kept(kept) => {
                self.screen.show(Mode::ConfirmRecovery { kept });
                Vec::new()
            }
            Message::ChangedOnDisk(changed) => {
                self.changed(changed);
                Vec::new()
            }
            Message::KeptAtHome(result) => {
                self.files.written(result.is_ok());
                match result {
                    Ok(Some(note)) => self.inform(note),
                    Ok(None) => {}
                    Err(why) => self.complain(why),
                }
                self.go_on()
            }
            Message::StillAtFiles { seconds } => {
                self.still_at_files(seconds);
                Vec::new()
            }
            Message::Trouble(text) => {
                self.complain(text);
                Vec::new()
            }
        }
    }

    pub(super) fn key(&mut self, key: Key) -> Vec<Command> {
        self.screen.hush();
        if let Some(entry) = self.screen.entry() {
            // A question mark is text here.
            if key == Key::plain(Code::F(1)) {
                self.screen.toggle_help();
                return Vec::new();
            }
            return match entry.key(key) {
                LineKey::Typing => Vec::new(),
                LineKey::Drop => {
                    self.screen.close();
                    Vec::new()
                }
                LineKey::Take => self.take_entry(),
            };
        }
        let Some(context) = self.context() else { return Vec::new() };
        match keymap::action(context, key) {
            Some(action) => self.act(action),
            None => {
                match self.screen.mode() {
                    Mode::Main if self.editor.empty() => self.no_key(key),
                    Mode::Main => self.start_typing(key),
                    Mode::Study(page) => self.study_key(*page, key),
                    _ => {
                        if let Some(picker) = self.screen.picker() {
                            picker.key(key);
                        } else if let Some(form) = self.screen.mesh_form() {
                            form.key(key);
                        }
                    }
                }
                Vec::new()
            }
        }
    }

    /// A digit, a point or a minus on the main screen starts a value.
    fn start_typing(&mut self, key: Key) {
        let Key { code: Code::Char(c), ctrl: false, alt: false, .. } = key else { return };
        let field = self.field();
        let signed = field.row().quantity == Quantity::Length;
        if c.is_ascii_digit() || c == '.' || (c == '-' && signed) {
            self.screen.type_into(EditTarget::Value(field), c);
        } else {
            self.no_key(key);
        }
    }

    /// A key that has no meaning where the user is.
    pub(super) fn no_key(&mut self, key: Key) {
        self.inform(format!("{key} does nothing here; ? shows the keys"));
    }

    pub(super) fn act(&mut self, action: Action) -> Vec<Command> {
        if let Mode::Study(page) = *self.screen.mode()
            && let Some(effects) = self.study_act(page, action)
        {
            return effects;
        }
        match action {
            Action::FieldUp => self.editor.select_next_field(false),
            Action::FieldDown => self.editor.select_next_field(true),
            Action::Select(field) => {
                self.editor.select_field(field);
                if field == Input::Plate {
                    self.inform("d, the side of the plates; A duplicates the layout");
                }
            }
            Action::First => self.scroll(isize::MIN),
            Action::Last => self.scroll(isize::MAX),
            Action::Find => self.screen.type_sought(),
            Action::FindNext => self.find(""),
            Action::StepUp => self.step_field(StepSize::Fine, true),
            Action::StepDown => self.step_field(StepSize::Fine, false),
            Action::CoarseUp => self.step_field(StepSize::Coarse, true),
            Action::CoarseDown => self.step_field(StepSize::Coarse, false),
            Action::Type => {
                let field = self.field();
                self.screen.type_into(EditTarget::Value(field), self.editor.field_text(field));
            }
            Action::Clear if self.field().clearable() => self.editor.set_field(None),
            Action::Clear => {
                self.inform(format!("{} needs a value; type one", self.field().word()));
            }
            Action::NextLayout => self.editor.select_neighbour(true),
            Action::PreviousLayout => self.editor.select_neighbour(false),
            Action::Add => {
                let said = self.editor.add_layout();
                self.tell(said);
            }
            Action::Duplicate => {
                let said = self.editor.duplicate_layout();
                self.tell(said);
            }
            Action::Rename => {
                self.screen.type_into(EditTarget::Name, self.editor.layout().name.clone());
            }
            Action::Note => {
                self.screen.type_into(EditTarget::Note, self.editor.layout().note.clone());
            }
            Action::Delete => {
                let said = self.editor.delete_layout();
                self.tell(said);
            }
            Action::MoveUp => self.editor.move_layout(false),
            Action::MoveDown => self.editor.move_layout(true),
            Action::Overlay => {
                let said = self.editor.toggle_overlay();
                self.tell(said);
            }
            Action::PickMesh => {
                // A mesh that is not known is not in the list; the mark begins at its top then.
                let index = self.meshes().iter().position(|c| c.mesh.id == self.layout().mesh);
                self.screen.show(Mode::MeshPicker { index: index.unwrap_or(0) });
            }
            Action::AddMesh => {
                self.screen.show(Mode::MeshForm(Box::new(MeshForm::record())));
            }
            Action::AdoptMesh => self.show_adopt_form(),
            Action::KeepMesh => return self.keep_mesh(),
            Action::Branch => {
                let said = self.editor.toggle_branch();
                self.inform(said);
            }
            Action::Blocks => {
                let said = self.editor.turn_blocks();
                self.inform(said);
            }
            Action::Grid => {
                let said = self.editor.turn_grid();
                self.inform(said);
            }
            Action::Twists => {
                let said = self.editor.set_twists(self.layout().layout.grid.twists.other());
                self.inform(said);
            }
            Action::Method => {
                let said = self.editor.toggle_method();
                self.inform(said);
            }
            Action::Units => {
                let length = Some(self.units().length.other());
                self.editor.set_units(crate::units::ChosenUnits { length, force: None });
            }
            Action::Basis => {
                let said = self.editor.set_basis(self.project().basis.other());
                self.inform(said);
            }
            Action::Undo => self.undo(),
            Action::Redo => self.redo(),
            Action::Save => return self.save(None, false),
            Action::Command => self.screen.type_into(EditTarget::Command, ""),
            Action::Details => self.screen.show(Mode::Details { scroll: 0 }),
            Action::Help => self.screen.toggle_help(),
            Action::Suspend => return vec![Command::Suspend],
            Action::Redraw => return vec![Command::Redraw],
            Action::Quit => return self.ask_to_quit(),
            Action::Up => self.scroll(-1),
            Action::Down => self.scroll(1),
            Action::PageUp => self.scroll(-(self.screen.page_lines() as isize)),
            Action::PageDown => self.scroll(self.screen.page_lines() as isize),
            Action::Take => return self.take_marked(),
            Action::Close => return self.close(),
            Action::SaveAndQuit => return self.save_and_quit(),
            Action::Discard => return self.discard(),
            Action::Overwrite => return self.overwrite(),
            Action::Restore => return self.restore(),
            Action::TakeOver => return self.take_over(),
            Action::Reload => return self.reload(),
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
            Action::Export => self.screen.show(Mode::Export { index: 0 }),
            Action::NextWord => return self.change_marked_setting(true),
            Action::PreviousWord => return self.change_marked_setting(false),
            Action::Study(ask) => self.study_ask(ask),
        }
        Vec::new()
    }

    fn step_field(&mut self, size: StepSize, up: bool) {
        if let Err(refusal) = self.editor.step_field(size, up) {
            self.complain(refusal);
        }
    }

    /// Moves the mark of what is shown, or scrolls it.
    fn scroll(&mut self, lines: isize) {
        match self.screen.mode() {
            Mode::Help { .. } | Mode::Details { .. } => {
                let last = self.page_lines().len().saturating_sub(self.screen.page_lines());
                self.screen.scroll(lines, last);
            }
            Mode::Settings { .. } => self.screen.scroll(lines, SettingItem::ALL.len() - 1),
            Mode::Main => {
                let ends = [Input::LAYOUT.first(), Input::LAYOUT.last()];
                if let Some(field) = ends[usize::from(lines > 0)] {
                    self.editor.select_field(*field);
                }
            }
            Mode::Export { .. } => self.screen.turn(lines, ExportKind::ALL.len()),
            Mode::MeshPicker { .. } => {
                let meshes = self.meshes().len();
                self.screen.turn(lines, meshes);
            }
            _ => {
                if let Some(picker) = self.screen.picker() {
                    picker.step(lines);
                } else if let Some(form) = self.screen.mesh_form() {
                    form.step(lines);
                }
            }
        }
    }

    /// The marked entry is taken.
    fn take_marked(&mut self) -> Vec<Command> {
        match *self.screen.mode() {
            Mode::Open(_) => return self.take_project(),
            Mode::Export { .. } => return self.take_export(),
            Mode::MeshForm(_) => return self.take_mesh_form(),
            Mode::MeshPicker { index } => {
                if let Some(choice) = self.meshes().get(index) {
                    self.screen.show(Mode::Main);
                    if let Err(refusal) = self.editor.set_mesh(&choice.mesh.id) {
                        self.complain(refusal);
                    }
                }
            }
            _ => {}
        }
        Vec::new()
    }

    /// What is shown is closed.
    fn close(&mut self) -> Vec<Command> {
        match self.screen.mode() {
            // Going on without a decision would let new edits take the place of the kept ones.
            Mode::ConfirmRecovery { .. } => return self.quit(None),
            Mode::Tour { .. } => return self.end_tour(),
            Mode::Help { .. } => self.screen.toggle_help(),
            Mode::MeshForm(_) => return self.leave_mesh_form(),
            Mode::Open(_) => {
                self.files.stop_opening();
                self.screen.close();
            }
            _ => self.screen.close(),
        }
        Vec::new()
    }

    /// Enter in a line of text: a text that is refused stays, with the reason.
    fn take_entry(&mut self) -> Vec<Command> {
        let Some(entry) = self.screen.take_entry() else { return Vec::new() };
        let text = entry.text().to_string();
        let result = match entry.target {
            EditTarget::Value(field) => self.editor.read_field(field, &text).map(|()| Vec::new()),
            EditTarget::Name => self.editor.rename_layout(&text).map(|()| Vec::new()),
            EditTarget::Note => {
                self.editor.set_note(&text);
                Ok(Vec::new())
            }
            EditTarget::Command => self.command(&text),
            EditTarget::File => Ok(self.ask_to_open(Path::new(&text))),
            // The form takes its lines itself.
            EditTarget::Mesh => Ok(Vec::new()),
            EditTarget::Find => {
                self.find(&text);
                Ok(Vec::new())
            }
            EditTarget::Study(typed) => self.take_typed(typed, &text).map(|()| Vec::new()),
        };
        result.unwrap_or_else(|refusal| {
            self.screen.show(Mode::Entry(LineEntry { error: Some(refusal), ..entry }));
            Vec::new()
        })
    }
}

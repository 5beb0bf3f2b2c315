//! What keys and typed texts do on the pages of studies.

use super::super::entry::{EditTarget, Slot, Typed};
use super::super::key::{Code, Key};
use super::super::keymap::{Action, Ask, StudyPage};
use super::super::message::Command;
use super::super::{App, Mode};
use crate::case::{Case, Input};

impl App {
    /// What a key asks for on a page of a study; nothing where it means what it means elsewhere.
    pub(in crate::app) fn study_act(
        &mut self,
        page: StudyPage,
        action: Action,
    ) -> Option<Vec<Command>> {
        match action {
            Action::Up => self.studies.step(page, -1),
            Action::Down => self.studies.step(page, 1),
            Action::PageUp => self.studies.step(page, -(self.screen.page_lines() as isize)),
            Action::PageDown => self.studies.step(page, self.screen.page_lines() as isize),
            Action::First => self.studies.step(page, isize::MIN),
            Action::Last => self.studies.step(page, isize::MAX),
            Action::Check => return Some(self.start_study(page)),
            Action::Stop if self.work.campaign().is_some() => return None,
            Action::Stop => self.screen.show(Mode::Main),
            Action::Fidelity if !matches!(page, StudyPage::Compare | StudyPage::Tolerance) => {
                let said = self.studies.next_fidelity();
                self.inform(said);
            }
            Action::Take => self.study_take(page),
            Action::Type if page == StudyPage::Sweep => self.type_slot(None),
            Action::Type if page == StudyPage::Tolerance => self.type_off(""),
            _ => return None,
        }
        Some(Vec::new())
    }

    /// What a key of the pages asks for.
    pub(in crate::app) fn study_ask(&mut self, ask: Ask) {
        if let Ask::Open(page) = ask {
            self.screen.show(Mode::Study(page));
            if page == StudyPage::Compare {
                self.studies.compare.mark(self.editor.selected());
            }
            return;
        }
        let asked = self.layout().asked().force.is_some();
        match self.screen.page() {
            Some(StudyPage::Sensitivity) => self.studies.sensitivity.ask(ask, asked),
            Some(StudyPage::Sweep) => self.sweep_ask(ask, asked),
            Some(StudyPage::Compare) => {
                if let Some(said) = self.studies.compare.ask(ask) {
                    self.inform(said);
                }
            }
            Some(StudyPage::Design) => self.design_ask(ask),
            Some(StudyPage::Tolerance) => self.studies.tolerance.ask(ask),
            None => {}
        }
    }

    /// A key that has no meaning on a page: a digit starts a value where one can be typed.
    pub(in crate::app) fn study_key(&mut self, page: StudyPage, key: Key) {
        let Key { code: Code::Char(c), ctrl: false, alt: false, .. } = key else {
            return self.no_key(key);
        };
        match page {
            _ if !(c.is_ascii_digit() || matches!(c, '.' | '-')) => self.no_key(key),
            StudyPage::Sweep => self.type_slot(Some(c)),
            StudyPage::Design => self.type_design(Input::DesignForce, c),
            StudyPage::Tolerance => self.type_off(c),
            StudyPage::Sensitivity | StudyPage::Compare => self.no_key(key),
        }
    }

    fn study_take(&mut self, page: StudyPage) {
        match page {
            StudyPage::Compare => {
                self.editor.select(self.studies.compare.marked());
                self.screen.show(Mode::Main);
            }
            StudyPage::Design => match self.studies.design.taken() {
                Some(Ok((case, symbol))) => self.take_into_layout(&case, symbol),
                Some(Err(said)) => self.screen.say(said),
                None => {}
            },
            StudyPage::Sensitivity | StudyPage::Sweep | StudyPage::Tolerance => {}
        }
    }

    /// Orders the checks of a page.
    fn start_study(&mut self, page: StudyPage) -> Vec<Command> {
        // A layout's own check is the one that the project keeps.
        if page == StudyPage::Compare {
            return self.start_check(true);
        }
        let runs = self.settings().runs;
        match self.studies.check(page, &self.editor, &mut self.work, runs) {
            Ok(order) => vec![order],
            Err(said) => {
                self.screen.say(said);
                Vec::new()
            }
        }
    }

    /// Makes the selected layout's sizes those of a case, as an edit that can be undone.
    fn take_into_layout(&mut self, case: &Case, words: &str) {
        let said = self.editor.take_sizes(case.layout, words);
        self.tell(said);
    }

    fn sweep_ask(&mut self, ask: Ask, asked: bool) {
        match ask {
            Ask::NextColumn | Ask::PreviousColumn => {
                let case = self.editor.case(self.editor.selected());
                if let Some(case) = case
                    && let Err(why) = self.studies.sweep.change_slot(case, ask == Ask::NextColumn)
                {
                    self.complain(why);
                }
            }
            Ask::NextValue => self.studies.sweep.show_next(asked),
            Ask::MarkNext => self.studies.sweep.mark(1),
            Ask::MarkPrevious => self.studies.sweep.mark(-1),
            Ask::Two if self.studies.sweep.slot().1 != Slot::Input => self.type_slot(Some('2')),
            Ask::SecondInput | Ask::Two => {
                let said = self.studies.sweep.toggle_second();
                self.inform(said);
            }
            Ask::Layer => self.studies.sweep.toggle_layer(),
            Ask::Adopt => match self.studies.sweep.point() {
                Some(Ok((case, words))) => self.take_into_layout(&case, &words),
                Some(Err(why)) => self.complain(why),
                None => {}
            },
            _ => {}
        }
    }

    /// Begins to type into the chosen slot.
    fn type_slot(&mut self, first: Option<char>) {
        let (axis, slot) = self.studies.sweep.slot();
        let text = match (first, slot) {
            (_, Slot::Input) => {
                return self.inform("Left and Right choose the input; Down goes to its range");
            }
            (Some(c), _) => Some(c.to_string()),
            (None, _) => self.studies.sweep.slot_text(self.editor.units()),
        };
        if let Some(text) = text {
            self.screen.type_into(EditTarget::Study(Typed::Range(axis, slot)), text);
        }
    }

    fn design_ask(&mut self, ask: Ask) {
        let field = match ask {
            Ask::NextColumn | Ask::PreviousColumn => {
                if let Err(why) = self.studies.design.next_requirement(ask == Ask::NextColumn) {
                    self.inform(why);
                }
                return;
            }
            Ask::DesignForce => Input::DesignForce,
            Ask::AllowableDeflection => Input::AllowableDeflection,
            Ask::LoadFactor => Input::GammaLoad,
            Ask::ResistanceFactor => Input::GammaResistance,
            _ => return,
        };
        let text = self.editor.field_text(field);
        self.type_design(field, text);
    }

    /// Begins to type a design value.
    fn type_design(&mut self, field: Input, text: impl Into<String>) {
        self.screen.type_into(EditTarget::Study(Typed::Design(field)), text);
    }

    fn typed_for(&self) -> Result<Case, String> {
        let case = self.editor.case(self.editor.selected()).cloned();
        case.ok_or_else(|| "the mesh of this layout is not known".to_string())
    }

    /// Begins to type how far an input may be off.
    fn type_off(&mut self, text: impl Into<String>) {
        self.screen.type_into(EditTarget::Study(Typed::Off), text);
    }

    /// Takes a text that was typed on a page.
    ///
    /// # Errors
    /// Why it is refused.
    pub(in crate::app) fn take_typed(&mut self, typed: Typed, text: &str) -> Result<(), String> {
        match typed {
            Typed::Design(field) => self.editor.read_field(field, text),
            Typed::Range(axis, slot) => {
                let (case, unit) = (self.typed_for()?, self.editor.units());
                self.studies.sweep.take_slot(&case, axis, slot, text, unit)
            }
            Typed::Off => {
                let (case, unit) = (self.typed_for()?, self.editor.units());
                self.studies.tolerance.take(&case, text, unit)
            }
        }
    }
}

//! The pages of studies: what each shows, what a key does on it, and the checks behind it.
//!
//! - [`sensitivity`], [`sweep`], [`compare`], [`design`]: a page each, with its state and what it shows.
//! - [`typed`]: what is typed on them.
//! - [`campaign`]: the checks of a page's cases: what runs, what is kept and what it is worth now.
//!
//! What a page shows is made anew after each message while the page is open, and never while drawing.

pub(crate) mod campaign;
pub(crate) mod compare;
pub(crate) mod design;
pub(crate) mod sensitivity;
pub(crate) mod sweep;
pub(crate) mod typed;

use super::entry::{EditTarget, LineEntry};
use super::key::{Code, Key};
use super::keymap::{Action, Ask, StudyPage};
use super::message::Command;
use super::{App, Mode};
use crate::case::Case;
use crate::case::Input;
use crate::dem::Fidelity;
use crate::problem::summary;
use crate::study::sensitivity::Effect as Shown;
use crate::units::significant;
use crate::words::Choice;
use campaign::Campaigns;
use std::sync::Arc;

/// All that the state knows of studies. It outlives the pages, so that a page comes back as it was.
#[derive(Debug, Default)]
pub(crate) struct Studies {
    campaigns: Campaigns,
    /// How exactly the checks of studies compute; quick where nothing was said.
    fidelity: Option<Fidelity>,
    sensitivity: sensitivity::SensitivityState,
    sweep: sweep::SweepState,
    compare: compare::CompareState,
    design: design::DesignState,
}

impl App {
    /// The page that is open, also while a text for it is typed.
    pub fn page_open(&self) -> Option<StudyPage> {
        match &self.mode {
            Mode::Study(page) => Some(*page),
            Mode::Entry(LineEntry { target: EditTarget::Study(typed), .. }) => Some(typed.page()),
            _ => None,
        }
    }

    /// What is under the text that is typed, or the list that lies over everything now.
    pub(super) fn behind(&self) -> Mode {
        let page = match self.mode {
            Mode::Entry(_) => self.page_open(),
            _ => None,
        };
        page.map_or(Mode::Main, Mode::Study)
    }

    /// A layout as a case of a study; nothing where its mesh is not known.
    pub(crate) fn case(&self, index: usize) -> Option<Case> {
        self.results.get(index)?.case.clone()
    }

    /// What a key asks for on a page of a study; nothing where it means what it means elsewhere.
    pub(super) fn study_act(&mut self, page: StudyPage, action: Action) -> Option<Vec<Command>> {
        match action {
            Action::Up => self.study_move(page, -1),
            Action::Down => self.study_move(page, 1),
            Action::Check => return Some(self.start_study(page)),
            Action::Stop if self.campaign().is_some() => return None,
            Action::Stop => self.mode = Mode::Main,
            Action::Fidelity if page != StudyPage::Compare => self.next_study_fidelity(),
            Action::Take => self.study_take(page),
            Action::Type if page == StudyPage::Sweep => return Some(self.type_slot(None)),
            _ => return None,
        }
        Some(Vec::new())
    }

    /// What a key of the pages asks for.
    pub(super) fn study_ask(&mut self, ask: Ask) {
        if let Ask::Open(page) = ask {
            return self.open_page(page);
        }
        match self.page_open() {
            Some(StudyPage::Sensitivity) => self.sensitivity_ask(ask),
            Some(StudyPage::Sweep) => self.sweep_ask(ask),
            Some(StudyPage::Compare) => self.compare_ask(ask),
            Some(StudyPage::Design) => self.design_ask(ask),
            None => {}
        }
    }

    /// A key that has no meaning on a page: a digit starts a value where one can be typed.
    pub(super) fn study_key(&mut self, page: StudyPage, key: Key) {
        if let Key { code: Code::Char(c), ctrl: false, alt: false, .. } = key
            && (c.is_ascii_digit() || matches!(c, '.' | '-'))
        {
            match page {
                StudyPage::Sweep => {
                    self.type_slot(Some(c));
                    return;
                }
                StudyPage::Design => return self.type_design(Input::DesignForce, c),
                StudyPage::Sensitivity | StudyPage::Compare => {}
            }
        }
        self.inform(format!("{key} does nothing here; ? shows the keys"));
    }

    fn open_page(&mut self, page: StudyPage) {
        self.mode = Mode::Study(page);
        if page == StudyPage::Compare {
            self.studies.compare.marked = self.selected;
        }
    }

    fn study_move(&mut self, page: StudyPage, lines: isize) {
        match page {
            StudyPage::Sensitivity => self.sensitivity_move(lines),
            StudyPage::Sweep => self.sweep_move(lines),
            StudyPage::Compare => self.compare_move(lines),
            StudyPage::Design => self.design_move(lines),
        }
    }

    fn study_take(&mut self, page: StudyPage) {
        match page {
            StudyPage::Compare => self.compare_take(),
            StudyPage::Design => self.design_take(),
            StudyPage::Sensitivity | StudyPage::Sweep => {}
        }
    }

    /// Orders the checks of a page.
    fn start_study(&mut self, page: StudyPage) -> Vec<Command> {
        match page {
            // A layout's own check is the one that the project keeps.
            StudyPage::Compare => self.start_check(true),
            StudyPage::Sensitivity => {
                let cases = self.studies.sensitivity.cases();
                self.start_campaign(self.purpose(page, 0), cases)
            }
            StudyPage::Sweep => match self.studies.sweep.cases() {
                Ok(cases) => {
                    let question = self.studies.sweep.question();
                    self.start_campaign(self.purpose(page, question), cases)
                }
                Err(why) => {
                    self.complain(why);
                    Vec::new()
                }
            },
            StudyPage::Design => {
                let cases = self.studies.design.cases();
                self.start_campaign(self.purpose(page, 0), cases)
            }
        }
    }

    /// Makes what the open page shows anew.
    pub(super) fn follow_page(&mut self) {
        match self.page_open() {
            Some(StudyPage::Sensitivity) => self.make_sensitivity(),
            Some(StudyPage::Sweep) => self.make_sweep(),
            Some(StudyPage::Compare) => self.make_comparison(),
            Some(StudyPage::Design) => self.make_design(),
            None => {}
        }
    }

    /// Makes the selected layout's sizes those of a case, as an edit that can be undone.
    fn take_into_layout(&mut self, case: Case, words: &str) {
        if let Err(problems) = case.layout.check() {
            return self.complain(summary(&problems));
        }
        let at = self.selected;
        let to = case.layout;
        let label = format!("{words} of {}", self.layout().name);
        let before = self.project.clone();
        self.edit(label, |project| {
            project.layouts[at].layout = to;
        });
        let name = self.layout().name.clone();
        if Arc::ptr_eq(&before, &self.project) {
            self.inform(format!("{name} is like that already"));
        } else {
            self.inform(format!("{words} of {name} set; u undoes it"));
        }
    }

    /// How exactly the checks of studies compute.
    pub(crate) fn study_fidelity(&self) -> Fidelity {
        self.studies.fidelity.unwrap_or(Fidelity::Quick)
    }

    fn next_study_fidelity(&mut self) {
        let next = match self.study_fidelity() {
            Fidelity::Quick => Fidelity::Standard,
            Fidelity::Standard => Fidelity::Fine,
            _ => Fidelity::Quick,
        };
        self.studies.fidelity = Some(next);
        let aim = significant(100.0 * next.aim(), 1);
        self.inform(format!("checks of studies are {}: errors within {aim} %", next.word()));
    }
}

/// The values that studies speak of, in the order in which a key goes through them.
const SHOWN: [Shown; 3] = [Shown::Force, Shown::Deflection, Shown::Utilisation];

/// The neighbour of a value; the utilisation is left out where no design force is set.
fn neighbour(shown: Shown, next: bool, asked: bool) -> Shown {
    let count = if asked { 3 } else { 2 };
    let at = SHOWN.iter().position(|s| *s == shown).unwrap_or(0).min(count - 1);
    SHOWN[(at + if next { 1 } else { count - 1 }) % count]
}

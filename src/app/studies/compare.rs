//! All layouts side by side, sorted by any column.

use super::super::keymap::Ask;
use super::given::Given;
use crate::case::Input;
use crate::study::checks::figures::Figures;
use crate::study::compare::{Column, Comparison, LayoutToCompare, compare};
use crate::study::verdict::Simulated;
use crate::words::Choice;
use std::cmp::Ordering;

/// A column of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnHead {
    /// One of the comparison of forecasts.
    Of(Column),
    /// Mean force of the check, N.
    DemForce,
    /// How far it is from F_a, as a part.
    DemOverForce,
    /// Mean deflection of the check, m.
    DemDeflection,
    /// How far it is from delta_a, as a part.
    DemOverDeflection,
    /// Utilisation by the mean force of the check.
    DemUtilisation,
}

impl ColumnHead {
    /// All columns in the order of the table, the name first.
    pub(crate) const ALL: [ColumnHead; 20] = [
        ColumnHead::Of(Column::Name),
        ColumnHead::Of(Column::Size(Input::Plate)),
        ColumnHead::Of(Column::Size(Input::Spacing)),
        ColumnHead::Of(Column::Size(Input::Punch)),
        ColumnHead::Of(Column::Size(Input::OffsetX)),
        ColumnHead::Of(Column::Size(Input::OffsetY)),
        ColumnHead::Of(Column::Force),
        ColumnHead::Of(Column::Deflection),
        ColumnHead::Of(Column::Use),
        ColumnHead::Of(Column::ServiceDeflection),
        ColumnHead::DemForce,
        ColumnHead::DemOverForce,
        ColumnHead::Of(Column::ForceRatio),
        ColumnHead::Of(Column::DeflectionRatio),
        ColumnHead::Of(Column::Utilisation),
        ColumnHead::Of(Column::DesignDeflection),
        ColumnHead::DemDeflection,
        ColumnHead::DemOverDeflection,
        ColumnHead::DemUtilisation,
        ColumnHead::Of(Column::Mesh),
    ];
}

/// The check of a row.
#[derive(Debug, Clone, Copy)]
pub struct CheckedLine {
    /// What it says beside the forecast.
    pub figures: Figures,
    /// Whether its inputs are not the layout's any more.
    pub stale: bool,
    /// Whether it was ended before all runs were made.
    pub partial: bool,
}

/// What the page shows.
#[derive(Debug)]
pub struct CompareView {
    /// The layouts whose mesh is known, in the project's order.
    pub comparison: Comparison,
    /// Of each row, the layout's place in the project.
    pub layouts: Vec<usize>,
    /// Of each row, the check that the project keeps.
    pub checked: Vec<Option<CheckedLine>>,
    /// The rows in the order shown.
    pub order: Vec<usize>,
    /// Layouts that are left out.
    pub unknown: usize,
}

impl CompareView {
    /// Letter of a row's curve, by its place in the project; none for the many.
    pub(crate) fn letter(&self, row: usize) -> Option<char> {
        let place = u8::try_from(*self.layouts.get(row)?).ok()?;
        (place < 26).then(|| char::from(b'A' + place))
    }

    /// What stands in a column of the checks.
    pub(crate) fn number(&self, row: usize, head: ColumnHead) -> Option<f64> {
        let checked = self.checked.get(row)?.as_ref()?;
        let figures = &checked.figures;
        // A stale check is of another panel than the forecast beside it.
        let difference = figures.difference.filter(|_| !checked.stale);
        match head {
            ColumnHead::Of(_) => None,
            ColumnHead::DemForce => figures.mean.map(|v| v.force),
            ColumnHead::DemOverForce => difference.map(|d| d.force),
            ColumnHead::DemDeflection => figures.mean.map(|v| v.deflection),
            ColumnHead::DemOverDeflection => difference.and_then(|d| d.deflection),
            ColumnHead::DemUtilisation => figures.utilisation.filter(|_| !checked.stale),
        }
    }
}

/// Where the user is on the page.
#[derive(Debug, Default)]
pub(crate) struct CompareState {
    /// The marked layout, by its place in the project.
    marked: usize,
    /// The column it is sorted by, by its place; nothing for the project's order.
    sort: Option<usize>,
    falling: bool,
    /// First column shown behind the name.
    first: usize,
    view: Option<CompareView>,
}

impl CompareState {
    /// What the page shows.
    pub(in crate::app) fn view(&self) -> Option<&CompareView> {
        self.view.as_ref()
    }

    /// The marked layout, by its place in the project.
    pub(in crate::app) fn marked(&self) -> usize {
        self.marked
    }

    /// Marks a layout, by its place in the project.
    pub(super) fn mark(&mut self, layout: usize) {
        self.marked = layout;
    }

    /// The column it is sorted by, and whether falling.
    pub(in crate::app) fn sort(&self) -> Option<(ColumnHead, bool)> {
        Some((*ColumnHead::ALL.get(self.sort?)?, self.falling))
    }

    /// The first column that is shown behind the name, by its place in [`ColumnHead::ALL`] less 1.
    pub(in crate::app) fn first(&self) -> usize {
        self.first
    }

    /// Makes what the page shows anew.
    pub(super) fn follow(&mut self, given: &Given) {
        let layouts: Vec<usize> = given.cases().map(|(index, ..)| index).collect();
        let cases = given.cases().map(|(_, layout, case)| LayoutToCompare {
            name: layout.name.clone(),
            case: case.clone(),
            simulated: Simulated::of(layout.check.as_deref(), case),
        });
        let comparison = compare(cases, given.editor.project().basis);
        let checked = layouts.iter().zip(&comparison.rows).map(|(index, row)| {
            let shown = given.kept(*index)?;
            Some(CheckedLine {
                figures: Figures::of(shown.result, row.values().ok(), &row.case.asked()),
                stale: shown.stale(),
                partial: shown.result.partial(),
            })
        });
        let all = given.editor.layouts().len();
        let mut view = CompareView {
            checked: checked.collect(),
            order: (0..layouts.len()).collect(),
            unknown: all - layouts.len(),
            comparison,
            layouts,
        };
        if let Some((head, falling)) = self.sort() {
            view.order = sorted(&view, head, falling);
        }
        self.marked = self.marked.min(all.saturating_sub(1));
        self.view = Some(view);
    }

    /// What a key asks for; what to say.
    pub(super) fn ask(&mut self, ask: Ask) -> Option<String> {
        let last = ColumnHead::ALL.len() - 1;
        match ask {
            Ask::NextColumn => self.first = (self.first + 1).min(last - 1),
            Ask::PreviousColumn => self.first = self.first.saturating_sub(1),
            Ask::SortNext => self.sort = Some(self.sort.map_or(0, |at| (at + 1).min(last))),
            Ask::SortPrevious => self.sort = self.sort.and_then(|at| at.checked_sub(1)),
            Ask::Reverse => self.falling = !self.falling,
            _ => return None,
        }
        if !matches!(ask, Ask::SortNext | Ask::SortPrevious | Ask::Reverse) {
            return None;
        }
        let way = if self.falling { "falling" } else { "rising" };
        Some(match self.sort() {
            Some((head, _)) => format!("sorted by {}, {way}; - turns it round", words(head)),
            None => "in the project's order".to_string(),
        })
    }

    /// Marks another row.
    pub(super) fn step(&mut self, lines: isize) {
        let Some(view) = &self.view else { return };
        let at = view.order.iter().position(|row| view.layouts.get(*row) == Some(&self.marked));
        let last = view.order.len().saturating_sub(1);
        let to = at.map_or(0, |at| at.saturating_add_signed(lines).min(last));
        if let Some(layout) = view.order.get(to).and_then(|row| view.layouts.get(*row)) {
            self.marked = *layout;
        }
    }
}

/// A column in words.
fn words(head: ColumnHead) -> &'static str {
    match head {
        ColumnHead::Of(column) => column.word(),
        ColumnHead::DemForce => "F of the check",
        ColumnHead::DemOverForce => "the check's F over the forecast's",
        ColumnHead::DemDeflection => "delta of the check",
        ColumnHead::DemOverDeflection => "the check's delta over the forecast's",
        ColumnHead::DemUtilisation => "utilisation by the check",
    }
}

/// The rows sorted by a column; those that have nothing there stand at the end either way.
fn sorted(view: &CompareView, head: ColumnHead, falling: bool) -> Vec<usize> {
    if let ColumnHead::Of(column) = head {
        return view.comparison.sorted(column, falling);
    }
    let mut order: Vec<usize> = (0..view.comparison.rows.len()).collect();
    let way = |o: Ordering| if falling { o.reverse() } else { o };
    order.sort_by(|a, b| match (view.number(*a, head), view.number(*b, head)) {
        (Some(a), Some(b)) => way(a.total_cmp(&b)),
        (a, b) => b.is_some().cmp(&a.is_some()),
    });
    order
}

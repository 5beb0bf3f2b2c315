//! What a result keeps of where its runs stood among all alignments of the net.

use super::rounded;
use crate::dem::RunOutcome;
use crate::study::ensemble::{Ensemble, Run, counts};
use crate::study::sampling::{Kind, Pattern};
use crate::units::{Units, from_kn, significant, to_kn};
use std::collections::BTreeMap;

/// The patterns of caught nodes and the points of the distribution; both missing in results of older
/// programs, the patterns also where they did not decide.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sampled {
    /// A row for each pattern: nodes that a plate catches, part of all alignments, number of the group of
    /// patterns that shared runs, then the places of its runs in [`super::CheckResult::breaks`].
    pub strata: Option<Vec<Vec<f64>>>,
    /// A row for each point of the distribution of the force at the first break: part that falls below it
    /// (0.05 is the characteristic value), kN.
    pub fractiles: Option<Vec<Vec<f64>>>,
}

/// Alignments in which a plate catches the same number of nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Catch {
    /// That number; the mean of the plates where they differ.
    pub(crate) nodes: f64,
    /// Part of all alignments, which is that of the slope.
    pub(crate) part: f64,
    /// Lowest and highest mean force at the first break of its patterns, N; nothing without a run.
    pub(crate) force: Option<[f64; 2]>,
}

impl Catch {
    /// In words: `32 nodes on 80 % (26.1 to 29.3 kN)`.
    pub(crate) fn words(&self, unit: Units) -> String {
        let nodes = significant(self.nodes, 3);
        let nodes = nodes.strip_suffix(".0").unwrap_or(&nodes);
        let part = significant(100.0 * self.part, 2);
        let kn = |v: f64| unit.force_number(v, 3);
        let force = self.force.map(|[low, high]| match kn(low) == kn(high) {
            true => format!(" ({} {})", kn(low), unit.force_symbol()),
            false => format!(" ({} to {} {})", kn(low), kn(high), unit.force_symbol()),
        });
        format!("{nodes} nodes on {part} %{}", force.unwrap_or_default())
    }
}

/// Catches as a sentence without a final stop; nothing of none.
pub(crate) fn sentence(catches: &[Catch], unit: Units) -> Option<String> {
    let words: Vec<String> = catches.iter().map(|c| c.words(unit)).collect();
    (!words.is_empty()).then(|| format!("a plate catches {} of the slope", words.join(", ")))
}

/// What is said of a characteristic force wherever it is shown.
pub(crate) const CHARACTERISTIC: &str =
    "5 % fall below it: alignment and slack only, without the scatter of the mesh's production";

/// The 5 % point of an ensemble's force at the first break, N: alignment and slack only. Nothing for one
/// run or one alignment.
pub(crate) fn characteristic(ensemble: &Ensemble, runs: usize) -> Option<f64> {
    let known = ensemble.sample.kind != Kind::Pinned && runs > 1 && ensemble.force.mean > 0.0;
    known.then_some(ensemble.force.band[0])
}

/// On how much of the slope a plate catches how many nodes, with what an ensemble makes of it.
pub(crate) fn catches(ensemble: &Ensemble) -> Vec<Catch> {
    let counted: Vec<&Run> = ensemble.runs.iter().filter(|run| counts(run)).collect();
    let broken = counted.iter().filter(|run| whole(&run.outcome));
    let forces: Vec<f64> =
        broken.filter_map(|run| run.outcome.first_break).map(|p| p.force).collect();
    Sampled::of(ensemble, &counted).catches(&forces)
}

/// Whether a run has a first break with its place.
fn whole(outcome: &RunOutcome) -> bool {
    outcome.first_break.is_some() && !outcome.breaks.is_empty()
}

impl Sampled {
    /// Of an ensemble, of which these runs count.
    pub(super) fn of(ensemble: &Ensemble, counted: &[&Run]) -> Sampled {
        let sample = &ensemble.sample;
        let breaks: Vec<&&Run> = counted.iter().filter(|run| whole(&run.outcome)).collect();
        let row = |(p, pattern): (usize, &Pattern)| {
            let group = sample.group_of(p).unwrap_or(0);
            let runs = breaks.iter().enumerate().filter(|(_, run)| run.pattern == Some(p));
            let head = [rounded(pattern.nodes), rounded(pattern.area), group as f64];
            head.into_iter().chain(runs.map(|(k, _)| k as f64)).collect()
        };
        let strata = || sample.patterns.iter().enumerate().map(row).collect();
        let lower = characteristic(ensemble, counted.len());
        Sampled {
            strata: (sample.kind == Kind::Patterns).then(strata),
            fractiles: lower.map(|force| vec![vec![0.05, rounded(to_kn(force))]]),
        }
    }

    /// The characteristic force, N.
    pub(crate) fn characteristic(&self) -> Option<f64> {
        let row = self.fractiles.as_ref()?.iter().find(|row| row.first() == Some(&0.05))?;
        row.get(1).copied().map(from_kn)
    }

    /// What each of so many first breaks weighs in the mean; 1 together.
    pub(crate) fn weights(&self, breaks: usize) -> Vec<f64> {
        let equal = || vec![1.0 / breaks.max(1) as f64; breaks];
        let Some(strata) = &self.strata else { return equal() };
        // Area and breaks of each group.
        let mut groups: BTreeMap<u64, (f64, Vec<usize>)> = BTreeMap::new();
        for row in strata {
            let [_, area, group, runs @ ..] = row.as_slice() else { return equal() };
            let (whole, places) = groups.entry(*group as u64).or_default();
            *whole += area;
            places.extend(runs.iter().map(|k| *k as usize));
        }
        let mut weights = vec![0.0; breaks];
        for (area, places) in groups.values() {
            for k in places.iter().filter(|k| **k < breaks) {
                weights[*k] += area / places.len() as f64;
            }
        }
        let sum: f64 = weights.iter().sum();
        if sum <= 0.0 || weights.contains(&0.0) {
            return equal();
        }
        weights.iter().map(|w| w / sum).collect()
    }

    /// On how much of the slope a plate catches how many nodes, fewest first, with the forces (N) of the
    /// first breaks.
    pub(crate) fn catches(&self, forces: &[f64]) -> Vec<Catch> {
        let mut list: Vec<Catch> = Vec::new();
        for row in self.strata.iter().flatten() {
            let [nodes, area, _, runs @ ..] = row.as_slice() else { continue };
            let values: Vec<f64> =
                runs.iter().filter_map(|k| forces.get(*k as usize)).copied().collect();
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let force = (!values.is_empty()).then_some([mean; 2]);
            match list.iter_mut().find(|c| c.nodes == *nodes) {
                Some(same) => {
                    same.part += area;
                    same.force = match (same.force, force) {
                        (Some(a), Some(b)) => Some([a[0].min(b[0]), a[1].max(b[1])]),
                        (a, b) => a.or(b),
                    };
                }
                None => list.push(Catch { nodes: *nodes, part: *area, force }),
            }
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sampled() -> Sampled {
        // Two patterns of 12 nodes with two runs and one, one of 16 without a run that shares those of
        // another with 16.
        let strata = vec![
            vec![12.0, 0.4, 0.0, 0.0, 1.0],
            vec![12.0, 0.3, 1.0, 2.0],
            vec![16.0, 0.1, 2.0],
            vec![16.0, 0.2, 2.0, 3.0],
        ];
        Sampled { strata: Some(strata), fractiles: Some(vec![vec![0.05, 21.5]]) }
    }

    #[test]
    fn weights_and_catches_worked_by_hand() {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        let weights = sampled().weights(4);
        assert!(weights.iter().zip([0.2, 0.2, 0.3, 0.3]).all(|(a, b)| close(*a, b)), "{weights:?}");
        assert_eq!(Sampled::default().weights(4), [0.25; 4]);
        let list = sampled().catches(&[20.0, 22.0, 24.0, 30.0]);
        assert_eq!(list.len(), 2);
        assert!(close(list[0].part, 0.7) && close(list[1].part, 0.3));
        assert_eq!((list[0].nodes, list[0].force), (12.0, Some([21.0, 24.0])));
        assert_eq!((list[1].nodes, list[1].force), (16.0, Some([30.0, 30.0])));
        assert_eq!(sampled().characteristic(), Some(21_500.0));
        assert_eq!(Sampled::default().characteristic(), None);
    }

    #[test]
    fn rows_that_make_no_sense_weigh_all_alike() {
        for strata in [vec![vec![1.0]], vec![vec![12.0, 1.0, 0.0, 7.0]], Vec::new()] {
            let odd = Sampled { strata: Some(strata), fractiles: None };
            assert_eq!(odd.weights(2), [0.5; 2]);
            assert!(odd.catches(&[1.0, 2.0]).len() < 2);
        }
    }
}

//! Where the runs of an ensemble are placed among all alignments of the net, and what follows from them.
//!
//! The scatter of an ensemble is for the most part which nodes the plates catch: of 6 to 8 % about 1 % is
//! left within a pattern of caught nodes. The patterns and their areas are known exactly ([`pattern`]), so
//! runs are not drawn but allotted to them ([`groups`]): six to twelve tell the mean as well as a hundred
//! at random. Within its pattern a run's alignment is uniform. Where patterns say little (a small block,
//! whose own alignment with the net counts as much) or do not exist (the laboratory), alignments are those
//! of a lattice ([`lattice`]). The mean is unbiased in both for any number of runs; [`mod@figures`] has its
//! standard error and the band.
//!
//! Which pattern and which alignment run k has follows from the seed and its number alone. An ensemble that
//! grows makes a second, third, ... round of the same number of runs, allotted alike and drawn anew.

mod figures;
mod groups;
mod lattice;
mod pattern;
pub(crate) mod plan;
pub(crate) mod spread;

pub(crate) use figures::{Placed, figures, weights};
pub(crate) use groups::Group;
pub(crate) use pattern::Pattern;

use crate::dem::hash::{hash, uniform};
use crate::dem::{Scene, Test};
use plan::{LEAST, MOST, Plan, TARGET};

/// How alignments are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// All have the one that was asked for.
    Pinned,
    /// By the patterns of caught nodes.
    Patterns,
    Lattice,
}

/// Diameter of the block from which on the patterns tell most of the scatter, m.
const LARGE_PUNCH: f64 = 0.4;

/// Runs made at least where patterns say how many are needed: with fewer nothing is seen of the scatter.
const LEAST_PLACED: usize = 6;

/// Runs made at least on a lattice: half as many say little of their own error.
const LEAST_LATTICE: usize = 16;

/// Part of the standard error aimed at that is planned for: what is assumed may be too little.
const PLANNED: f64 = 0.75;
/// Runs made at least where the ensemble chooses their fidelity: none is left over for a second look, the
/// scatter within patterns is then the assumed one.
const LEAST_AUTO: usize = 4;

/// The places of an ensemble's runs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Sample {
    /// How they are placed.
    pub(crate) kind: Kind,
    /// The patterns of caught nodes, fewest nodes first; none where they do not decide.
    pub(crate) patterns: Vec<Pattern>,
    /// Which of them share runs, those of the largest area first.
    pub(crate) groups: Vec<Group>,
    /// Runs of a round.
    pub(crate) round: usize,
    plan: Plan,
}

/// Where a run stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Member {
    /// Seed of its slack.
    pub(crate) seed: u64,
    /// Its alignment.
    pub(crate) phase: [f64; 2],
    /// Number of its pattern, where there are patterns.
    pub(crate) pattern: Option<usize>,
}

/// Counters far beyond any bond's number, so that slack and alignment are unrelated.
const ALIGNMENT: [u64; 2] = [u64::MAX, u64::MAX - 1];
/// Counters of what all runs share, far below those and far above run numbers.
const SHARED: u64 = 1 << 60;

impl Sample {
    /// The places of a scene's runs under a plan.
    pub(crate) fn of(scene: &Scene, plan: &Plan) -> Sample {
        let mut sample = Sample {
            kind: Kind::Pinned,
            patterns: Vec::new(),
            groups: Vec::new(),
            round: plan.runs.map_or(LEAST, |n| n.max(1)),
            plan: plan.clone(),
        };
        if plan.phase.is_some() {
            return sample;
        }
        let laboratory = scene.spec.test == Test::Laboratory;
        if laboratory || scene.spec.layout.punch < LARGE_PUNCH {
            sample.kind = Kind::Lattice;
            return sample;
        }
        sample.by_patterns(pattern::patterns(scene));
        sample
    }

    fn by_patterns(&mut self, patterns: Vec<Pattern>) {
        (self.kind, self.patterns) = (Kind::Patterns, patterns);
        let areas = self.areas();
        self.groups = match self.plan.runs {
            Some(n) => groups::groups(&areas, n.max(1), groups::REPEATS),
            None => {
                let (least, repeats) = match self.plan.auto {
                    true => (LEAST_AUTO, 0),
                    false => (LEAST_PLACED, groups::REPEATS),
                };
                let aim = PLANNED * TARGET;
                let enough = |g: &Vec<Group>| groups::predicted(g, &areas) <= aim * aim;
                let tried = (least..=MOST).map(|n| groups::groups(&areas, n, repeats));
                let mut last = Vec::new();
                tried.inspect(|g| last.clone_from(g)).find(enough).unwrap_or(last)
            }
        };
        self.round = self.groups.iter().map(|g| g.runs).sum();
    }

    /// Runs that are to be there next after `count` are; `count` itself where these are all.
    pub(crate) fn goal(&self, count: usize) -> usize {
        let next = match (self.plan.runs, self.kind) {
            (Some(n), _) => n.max(1),
            // A lattice is whole at these numbers only.
            (None, Kind::Lattice) => (2 * count).max(LEAST_LATTICE),
            (None, _) => count + self.round,
        };
        if self.plan.runs.is_none() && next > MOST { count } else { next }
    }

    pub(super) fn areas(&self) -> Vec<f64> {
        self.patterns.iter().map(|p| p.area).collect()
    }

    /// The group of a pattern.
    pub(crate) fn group_of(&self, pattern: usize) -> Option<usize> {
        self.groups.iter().position(|g| g.patterns.contains(&pattern))
    }

    /// Where run `k` stands.
    pub(crate) fn member(&self, k: usize) -> Member {
        let seed = hash(self.plan.seed, k as u64);
        let plain = |phase| Member { seed, phase, pattern: None };
        let shared = |n: u64| uniform(self.plan.seed, SHARED + n);
        match (self.kind, self.plan.phase) {
            (Kind::Pinned, phase) => plain(phase.unwrap_or_default()),
            (Kind::Lattice, _) => plain(lattice::point(k, self.plan.runs, [shared(0), shared(1)])),
            (Kind::Patterns, _) => {
                let (round, k) = (k / self.round, k % self.round);
                let (group, place) = self.place_in_group(k);
                let counter = (round * self.groups.len() + group) as u64;
                let group = &self.groups[group];
                let at = (place as f64 + shared(counter)) / group.runs as f64;
                let (pattern, rectangle) = self.at(group, at * group.area);
                let parts = ALIGNMENT.map(|counter| uniform(seed, counter));
                let phase = self.patterns[pattern].rectangles[rectangle].at(parts);
                Member { seed, phase, pattern: Some(pattern) }
            }
        }
    }

    /// The group of a run of a round, and which of its runs it is.
    fn place_in_group(&self, k: usize) -> (usize, usize) {
        let mut left = k;
        for (number, group) in self.groups.iter().enumerate() {
            if left < group.runs {
                return (number, left);
            }
            left -= group.runs;
        }
        (0, 0)
    }

    /// The pattern of a group, and its rectangle, at this much of the group's area.
    fn at(&self, group: &Group, area: f64) -> (usize, usize) {
        let all = group.patterns.iter().flat_map(|p| {
            let rectangles = self.patterns[*p].rectangles.iter();
            rectangles.enumerate().map(move |(n, r)| (*p, n, r.area()))
        });
        let (mut sum, mut found) = (0.0, (0, 0));
        for (pattern, rectangle, part) in all {
            found = (pattern, rectangle);
            sum += part;
            if area < sum {
                break;
            }
        }
        found
    }
}

#[cfg(test)]
mod tests;

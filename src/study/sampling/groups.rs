//! How many runs which patterns get: groups of patterns, each with its own number of runs.
//!
//! With every pattern in a group of its own the areas are exact and only slack scatters: the variance of
//! the mean is the sum of A^2 w^2 / k over the groups, A the area, k the runs, w the scatter within a
//! pattern. Where there are fewer runs than patterns, small ones are put together, and a run of such a
//! group stands for one of them, drawn by its area: then their differences come in too, with
//! b^2 (1 - sum of p^2), p the parts of the group, b the scatter between patterns. Both scatters are
//! assumed here, so that nothing depends on results and the mean is unbiased for any number of runs.

/// Scatter of the force within a pattern, over its mean: 1.0 to 1.8 % on nine layouts with D of 0.4 m and
/// more, 240 or 160 runs each.
pub(super) const WITHIN: f64 = 0.013;
/// Scatter between patterns: 5 to 8 % on the same.
pub(super) const BETWEEN: f64 = 0.065;

/// Patterns that share runs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Group {
    /// Their numbers.
    pub(crate) patterns: Vec<usize>,
    /// Area of all of them.
    pub(crate) area: f64,
    /// Runs of a round that stand for it.
    pub(crate) runs: usize,
}

impl Group {
    /// Chance that two draws from it are of different patterns.
    pub(super) fn mixed(&self, areas: &[f64]) -> f64 {
        let part = |p: &usize| areas[*p] / self.area;
        1.0 - self.patterns.iter().map(part).map(|p| p * p).sum::<f64>()
    }

    /// Its share in the variance of the mean, times its runs.
    fn variance(&self, areas: &[f64]) -> f64 {
        let scatter = WITHIN * WITHIN + BETWEEN * BETWEEN * self.mixed(areas);
        self.area * self.area * scatter
    }

    fn with(&self, other: &Group) -> Group {
        let mut patterns = self.patterns.clone();
        patterns.extend(&other.patterns);
        patterns.sort_unstable();
        Group { patterns, area: self.area + other.area, runs: 1 }
    }
}

/// Runs that are left over at least, where there are enough, so that some patterns are run twice and the
/// scatter within patterns is seen and not only assumed.
pub(super) const REPEATS: usize = 2;

/// The groups of `runs` runs over patterns of these areas, largest first; as many runs as asked for,
/// unless there is no pattern; so many of them are left over for a second look.
pub(crate) fn groups(areas: &[f64], runs: usize, repeats: usize) -> Vec<Group> {
    let single = |p: usize| Group { patterns: vec![p], area: areas[p], runs: 1 };
    let mut groups: Vec<Group> = (0..areas.len()).map(single).collect();
    let most = if runs > 2 * repeats { runs - repeats } else { runs.max(1) };
    let mut best: Option<(f64, Vec<Group>)> = None;
    while !groups.is_empty() {
        if groups.len() <= most {
            let tried = allotted(groups.clone(), areas, runs);
            let variance = predicted(&tried, areas);
            if best.as_ref().is_none_or(|(least, _)| variance < *least) {
                best = Some((variance, tried));
            }
        }
        if !join_cheapest(&mut groups, areas) {
            break;
        }
    }
    let mut groups = best.map_or(Vec::new(), |(_, groups)| groups);
    groups.sort_by(|a, b| b.area.total_cmp(&a.area).then(a.patterns.cmp(&b.patterns)));
    groups
}

/// Puts the two groups together that add least to the variance; false where there is only one.
fn join_cheapest(groups: &mut Vec<Group>, areas: &[f64]) -> bool {
    let mut cheapest: Option<(f64, usize, usize)> = None;
    for b in 1..groups.len() {
        for a in 0..b {
            let apart = groups[a].variance(areas) + groups[b].variance(areas);
            let cost = groups[a].with(&groups[b]).variance(areas) - apart;
            if cheapest.is_none_or(|(least, _, _)| cost < least) {
                cheapest = Some((cost, a, b));
            }
        }
    }
    let Some((_, a, b)) = cheapest else { return false };
    let taken = groups.remove(b);
    groups[a] = groups[a].with(&taken);
    true
}

/// Gives each group one run and the others where they help most.
fn allotted(mut groups: Vec<Group>, areas: &[f64], runs: usize) -> Vec<Group> {
    for _ in groups.len()..runs {
        let gain = |g: &Group| g.variance(areas) / (g.runs * (g.runs + 1)) as f64;
        let (mut most, mut at) = (f64::NEG_INFINITY, 0);
        for (k, group) in groups.iter().enumerate() {
            if gain(group) > most {
                (most, at) = (gain(group), k);
            }
        }
        groups[at].runs += 1;
    }
    groups
}

/// Variance of the mean over its square, with the assumed scatters.
pub(super) fn predicted(groups: &[Group], areas: &[f64]) -> f64 {
    groups.iter().map(|g| g.variance(areas) / g.runs as f64).sum()
}

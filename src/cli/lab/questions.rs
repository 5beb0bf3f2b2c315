//! `meshcast bench --questions` and `--pairs` as texts.

use crate::cli::output::wrapped;
use crate::lab::bench::BenchRow;
use crate::lab::questions::{LAYOUTS, PairTable, QuestionRow, QuestionTable, RANDOM};
use std::fmt::Write;

/// The four layouts as points of a plot of time and error.
pub(super) fn points(table: &QuestionTable) -> Vec<BenchRow> {
    let named = table.rows.iter().filter(|r| LAYOUTS.contains(&r.layout.as_str()));
    let point = |r: &QuestionRow| BenchRow {
        scene: r.layout.clone(),
        fidelity: r.way.into(),
        wall_ms: r.ms,
        steps: 0,
        force_error: r.rms_pct,
        deflection_error: 0.0,
        curve_error: 0.0,
        estimate: r.told_pct,
        faster: r.faster,
        force: 0.0,
        deflection: 0.0,
    };
    named.map(point).collect()
}

/// The questions as a text; the plot stands below.
pub(super) fn text(table: &QuestionTable) -> String {
    let mut out = String::from(
        "layout  way       runs  time, ms  rms %  mean %  told %  beyond  random/this\n",
    );
    let mut last = "";
    for r in &table.rows {
        let new = r.layout != last;
        last = &r.layout;
        let name = if new { r.layout.as_str() } else { "" };
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "{name:<7} {:<8} {:>5.1} {:>9.1} {:>6.2} {:>7.2} {:>7.2} {:>7} {:>12.2}",
            r.way, r.runs, r.ms, r.rms_pct, r.mean_pct, r.told_pct, r.beyond, r.faster
        );
    }
    out.push('\n');
    for r in table.rows.iter().filter(|r| r.way == RANDOM) {
        let _ = writeln!(out, "{:<3} {}", r.layout, r.flags);
    }
    let drawn = |r: &&QuestionRow| !LAYOUTS.contains(&r.layout.as_str());
    let mut ways: Vec<&str> = table.rows.iter().map(|r| r.way).collect();
    ways.dedup();
    ways.truncate(4);
    for way in ways.into_iter().filter(|way| *way != RANDOM) {
        let rows: Vec<&QuestionRow> =
            table.rows.iter().filter(drawn).filter(|r| r.way == way).collect();
        if rows.is_empty() {
            break;
        }
        let squares: f64 = rows.iter().map(|r| r.rms_pct * r.rms_pct).sum();
        let _ = writeln!(
            out,
            "{way}, {} drawn layouts: time of random over this {:.2} in the median, rms error {:.2} %, largest {:.2} %",
            rows.len(),
            median(rows.iter().map(|r| r.faster)),
            (squares / rows.len() as f64).sqrt(),
            rows.iter().map(|r| r.rms_pct).fold(0.0, f64::max)
        );
    }
    let legend = "random: standard runs of random alignment to a standard error below 2 %, as before runs were \
                  placed. rms and mean: of the mean force about the truth. told: the standard error that the check \
                  tells. beyond: checks off by more than twice that.";
    let _ = write!(out, "\n{}\n", wrapped("", legend, 80).join("\n"));
    out
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    let middle = |k: usize| sorted.get(k).copied().unwrap_or(0.0);
    let n = sorted.len();
    if n % 2 == 1 {
        middle(n / 2)
    } else {
        (middle((n / 2).saturating_sub(1)) + middle(n / 2)) / 2.0
    }
}

pub(super) fn pairs_text(table: &PairTable) -> String {
    let mut out = String::from(
        "standard over quick, %: bias of F and delta, scatter from pair to pair; estimate of quick, %\n",
    );
    for r in &table.rows {
        let ([f, d], [a, b]) = (r.bias_pct, r.pair_pct);
        let _ = writeln!(
            out,
            "{f:>6.2} {d:>6.2}  {a:>5.2} {b:>5.2}  {:>6.2}  {:<10} {}",
            r.estimate_pct, r.test, r.flags
        );
    }
    for test in ["anchored", "laboratory"] {
        let over =
            |of: &dyn Fn(&crate::lab::questions::PairRow) -> f64| table.over_estimate(test, of);
        let _ = write!(
            out,
            "\n{test}, over the estimate (20 % at most), root mean square: bias of F {:.3}, of delta {:.3}; \
             pair to pair {:.3}, {:.3}",
            over(&|r| r.bias_pct[0]),
            over(&|r| r.bias_pct[1]),
            over(&|r| r.pair_pct[0]),
            over(&|r| r.pair_pct[1])
        );
    }
    out.push('\n');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawn_layouts_are_summed_up_and_the_named_ones_plotted() {
        let row = |layout: &str, way, faster, rms_pct| QuestionRow {
            layout: layout.into(),
            flags: "-d 1".into(),
            way,
            runs: 6.0,
            ms: 10.0,
            rms_pct,
            mean_pct: 0.0,
            told_pct: 1.0,
            beyond: 0,
            faster,
        };
        let ways = |layout: &str, faster, rms| {
            [row(layout, RANDOM, 1.0, 2.0), row(layout, "auto", faster, rms)]
        };
        let rows = [ways("A", 3.0, 0.5), ways("1", 2.0, 0.3), ways("2", 2.5, 0.4)].concat();
        let table = QuestionTable { rows, part: false };
        let said = text(&table);
        // The median of 2 and 2.5; the root of (0.09 + 0.16)/2.
        let due = "auto, 2 drawn layouts: time of random over this 2.25 in the median, rms error 0.35 %, largest 0.40 %";
        assert!(said.contains(due), "{said}");
        assert_eq!(points(&table).len(), 2);
    }
}

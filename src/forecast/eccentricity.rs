//! Effect of the punch's eccentricity on F_a and delta_a: the map that stands for Fig. A1 of Pol &
//! Gabrieli (2021), whose picture is lost. The data and their sources are in `assets/eccentricity.ron`;
//! another map replaces that file, not this code.
//!
//! How the surface is made from the table: a sum of cosines cos(2 pi i ex/L) cos(2 pi j ey/L), i and j
//! up to 3, hence even, periodic and smooth, fitted by weighted least squares with a weight on
//! smoothness and exactly 1 at the centre; times a local correction that meets the fixed points
//! exactly. Its uncertainty is the table's standard deviation away from the fixed points and the size
//! of the correction at them.

use crate::layout::Layout;
use serde::Deserialize;
use std::f64::consts::TAU;
use std::sync::OnceLock;

const TEXT: &str = include_str!("../../assets/eccentricity.ron");

/// Harmonics of the surface in each direction.
const HARMONICS: usize = 4;
/// Coefficients of the surface, without the one of the constant.
const TERMS: usize = HARMONICS * HARMONICS - 1;

/// Factors on F_a and delta_a of an eccentric punch, with their uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eccentricity {
    /// Factor on F_a, dimensionless; 1 at the centre.
    pub force: f64,
    /// Factor on delta_a, dimensionless; 1 at the centre.
    pub deflection: f64,
    /// Standard uncertainty of the factor on F_a, dimensionless, 0 at the centre.
    pub force_sd: f64,
    /// Standard uncertainty of the factor on delta_a, dimensionless, 0 at the centre.
    pub deflection_sd: f64,
    /// Whether the map has data around this point; false where the table's punch reached a plate.
    pub supported: bool,
}

impl Eccentricity {
    /// A centred punch.
    pub(crate) const CENTRED: Eccentricity = Eccentricity {
        force: 1.0,
        deflection: 1.0,
        force_sd: 0.0,
        deflection_sd: 0.0,
        supported: true,
    };
}

/// The file as it stands.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MapFile {
    sources: Vec<String>,
    columns: Vec<f64>,
    rows: Vec<f64>,
    force: Vec<Vec<Option<(f64, f64)>>>,
    deflection: Vec<Vec<Option<(f64, f64)>>>,
    smoothing: f64,
    least_sd: LeastSd,
    correction_length: f64,
    fixed: Vec<FixedPoint>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct LeastSd {
    force: f64,
    deflection: f64,
}

/// A point that the map meets exactly.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct FixedPoint {
    ex: f64,
    ey: f64,
    spacing: f64,
    force: f64,
    deflection: f64,
    #[allow(dead_code, reason = "says where the point comes from, for readers of the file")]
    source: String,
}

/// The map, ready to be asked.
#[derive(Debug)]
pub(crate) struct Map {
    sources: Vec<String>,
    columns: Vec<f64>,
    rows: Vec<f64>,
    centres: Vec<(f64, f64)>,
    correction_length: f64,
    force: Surface,
    deflection: Surface,
}

/// One of the two surfaces.
#[derive(Debug)]
struct Surface {
    table: Vec<Vec<Option<(f64, f64)>>>,
    /// Largest standard deviation of the table.
    largest_sd: f64,
    smooth: [f64; TERMS],
    correction: Vec<f64>,
    /// Value of the corrected surface at the centre, 1 to rounding; dividing by it makes it exact.
    at_centre: f64,
}

/// The map shipped with the program.
pub(crate) fn published() -> &'static Map {
    static MAP: OnceLock<Map> = OnceLock::new();
    // The text is part of the program and a test builds the map, so a broken one is never shipped.
    MAP.get_or_init(|| {
        Map::from_ron(TEXT).unwrap_or_else(|e| panic!("assets/eccentricity.ron: {e}"))
    })
}

impl Map {
    /// Builds a map from the text of a map file.
    ///
    /// # Errors
    /// A sentence that says what is wrong with the text.
    pub(crate) fn from_ron(text: &str) -> Result<Map, String> {
        let options = ron::Options::default()
            .with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
        let file: MapFile = options.from_str(text).map_err(|e| e.to_string())?;
        let rising = |axis: &[f64]| {
            axis.first() == Some(&0.0)
                && axis.last() == Some(&0.5)
                && axis.windows(2).all(|w| w[0] < w[1])
        };
        if !rising(&file.columns) || !rising(&file.rows) {
            return Err("columns and rows must rise from 0 to 0.5".into());
        }
        for (name, table) in [("force", &file.force), ("deflection", &file.deflection)] {
            let shaped = table.len() == file.rows.len()
                && table.iter().all(|row| row.len() == file.columns.len());
            let sound = table
                .iter()
                .flatten()
                .flatten()
                .all(|(v, sd)| v.is_finite() && *v > 0.0 && sd.is_finite() && *sd >= 0.0);
            if !shaped || !sound || table[0][0].map(|e| e.0) != Some(1.0) {
                return Err(format!(
                    "table {name}: one entry a row and column, positive, 1 at the centre"
                ));
            }
        }
        let folded: Vec<(f64, f64)> =
            file.fixed.iter().map(|p| (fold(p.ex / p.spacing), fold(p.ey / p.spacing))).collect();
        // The centre is met like a fixed point, so that the other corrections do not move it.
        let mut centres = vec![(0.0, 0.0)];
        centres.extend(folded);
        let surface =
            |table: &Vec<Vec<Option<(f64, f64)>>>, least: f64, value: fn(&FixedPoint) -> f64| {
                let mut targets = vec![1.0];
                targets.extend(file.fixed.iter().map(value));
                Surface::build(&file, table, least, &centres, &targets)
            };
        Ok(Map {
            force: surface(&file.force, file.least_sd.force, |p| p.force)?,
            deflection: surface(&file.deflection, file.least_sd.deflection, |p| p.deflection)?,
            centres,
            correction_length: file.correction_length,
            sources: file.sources,
            columns: file.columns,
            rows: file.rows,
        })
    }

    /// Where the map's values come from.
    pub(crate) fn sources(&self) -> &[String] {
        &self.sources
    }

    /// The factors of a layout on a square grid; the map's x is across the twists. Offsets are periodic with L
    /// and even; a centred punch has exactly 1.
    pub(crate) fn at(&self, layout: &Layout) -> Eccentricity {
        let [ex, ey] = layout.turned([layout.ex, layout.ey]);
        self.at_ratio(ex / layout.spacing, ey / layout.spacing)
    }

    /// The factors at offsets ex/L, ey/L.
    pub(crate) fn at_ratio(&self, ex: f64, ey: f64) -> Eccentricity {
        let (x, y) = (fold(ex), fold(ey));
        if x == 0.0 && y == 0.0 {
            return Eccentricity::CENTRED;
        }
        let basis = Basis::at(x, y);
        let kernels: Vec<f64> =
            self.centres.iter().map(|c| kernel((x, y), *c, self.correction_length)).collect();
        let cell = Cell::at(x, y, &self.columns, &self.rows);
        let nearness = kernels.iter().copied().fold(0.0, f64::max).min(1.0);
        let one = |s: &Surface| {
            let smooth = s.smooth_value(&basis);
            let corrected = smooth * s.correction_value(&kernels) / s.at_centre;
            let sd = cell.interpolate(s) * (1.0 - nearness);
            (corrected, libm::sqrt(sd * sd + (corrected - smooth) * (corrected - smooth)))
        };
        let (force, force_sd) = one(&self.force);
        let (deflection, deflection_sd) = one(&self.deflection);
        Eccentricity {
            force,
            deflection,
            force_sd,
            deflection_sd,
            supported: cell.supported(&self.force.table),
        }
    }
}

impl Surface {
    fn build(
        file: &MapFile,
        table: &[Vec<Option<(f64, f64)>>],
        least_sd: f64,
        centres: &[(f64, f64)],
        targets: &[f64],
    ) -> Result<Surface, String> {
        // Normal equations of the weighted fit; the weight on smoothness grows with the harmonic.
        let mut matrix = vec![vec![0.0; TERMS]; TERMS];
        let mut right = vec![0.0; TERMS];
        for (row, &y) in table.iter().zip(&file.rows) {
            for (entry, &x) in row.iter().zip(&file.columns) {
                let Some((value, sd)) = entry else { continue };
                let weight = 1.0 / (sd.max(least_sd) * sd.max(least_sd));
                let basis = Basis::at(x, y).0;
                for i in 0..TERMS {
                    right[i] += weight * basis[i] * (value - 1.0);
                    for j in 0..TERMS {
                        matrix[i][j] += weight * basis[i] * basis[j];
                    }
                }
            }
        }
        for (k, row) in matrix.iter_mut().enumerate() {
            let (i, j) = harmonic(k);
            let roughness = (i * i + j * j) as f64;
            row[k] += file.smoothing * roughness * roughness;
        }
        let solution = solve(matrix, right).ok_or("the table does not determine the surface")?;
        let mut smooth = [0.0; TERMS];
        smooth.copy_from_slice(&solution);

        let mut surface = Surface {
            table: table.to_vec(),
            largest_sd: table.iter().flatten().flatten().map(|e| e.1).fold(0.0, f64::max),
            smooth,
            correction: Vec::new(),
            at_centre: 1.0,
        };
        let matrix: Vec<Vec<f64>> = centres
            .iter()
            .map(|at| centres.iter().map(|c| kernel(*at, *c, file.correction_length)).collect())
            .collect();
        let right: Vec<f64> = centres
            .iter()
            .zip(targets)
            .map(|(at, target)| target / surface.smooth_value(&Basis::at(at.0, at.1)) - 1.0)
            .collect();
        surface.correction =
            solve(matrix, right).ok_or("two fixed points are the same or too close together")?;
        let kernels: Vec<f64> =
            centres.iter().map(|c| kernel((0.0, 0.0), *c, file.correction_length)).collect();
        surface.at_centre =
            surface.smooth_value(&Basis::at(0.0, 0.0)) * surface.correction_value(&kernels);
        Ok(surface)
    }

    /// The fitted sum of cosines.
    fn smooth_value(&self, basis: &Basis) -> f64 {
        let mut sum = 0.0;
        for (c, b) in self.smooth.iter().zip(&basis.0) {
            sum += c * b;
        }
        1.0 + sum
    }

    /// The local correction, a factor.
    fn correction_value(&self, kernels: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (c, k) in self.correction.iter().zip(kernels) {
            sum += c * k;
        }
        1.0 + sum
    }
}

/// Values of cos(2 pi i x) cos(2 pi j y) - 1, which vanish at the centre.
struct Basis([f64; TERMS]);

impl Basis {
    fn at(x: f64, y: f64) -> Basis {
        let (cx, cy) = (cosines(x), cosines(y));
        let mut values = [0.0; TERMS];
        for (k, v) in values.iter_mut().enumerate() {
            let (i, j) = harmonic(k);
            *v = cx[i] * cy[j] - 1.0;
        }
        Basis(values)
    }
}

/// Harmonics (i, j) of term k; the constant (0, 0) is left out.
fn harmonic(k: usize) -> (usize, usize) {
    ((k + 1) / HARMONICS, (k + 1) % HARMONICS)
}

/// 1, cos t, cos 2t, cos 3t with t = 2 pi x.
fn cosines(x: f64) -> [f64; HARMONICS] {
    let c = libm::cos(TAU * x);
    [1.0, c, 2.0 * c * c - 1.0, (4.0 * c * c - 3.0) * c]
}

/// Offset over L brought to 0..0.5 by periodicity and evenness.
fn fold(e: f64) -> f64 {
    (e - e.round()).abs()
}

/// Bell of the given length around a centre, made even and periodic by its images.
fn kernel(at: (f64, f64), centre: (f64, f64), length: f64) -> f64 {
    let line = |x: f64, c: f64| {
        let bell = |r: f64| libm::exp(-(r / length) * (r / length));
        // A centre on a mirror line is its own image and counts once.
        if c == 0.0 {
            bell(x) + bell(1.0 - x)
        } else if c == 0.5 {
            bell(x - c) + bell(x + c)
        } else {
            bell(x - c) + bell(x + c) + bell(1.0 - x - c)
        }
    };
    line(at.0, centre.0) * line(at.1, centre.1)
}

/// The table's cell around a point, for interpolation between its four corners.
struct Cell {
    column: usize,
    row: usize,
    u: f64,
    v: f64,
}

impl Cell {
    fn at(x: f64, y: f64, columns: &[f64], rows: &[f64]) -> Cell {
        let place = |axis: &[f64], e: f64| {
            let k = (axis.partition_point(|a| *a <= e)).clamp(1, axis.len() - 1) - 1;
            (k, ((e - axis[k]) / (axis[k + 1] - axis[k])).clamp(0.0, 1.0))
        };
        let ((column, u), (row, v)) = (place(columns, x), place(rows, y));
        Cell { column, row, u, v }
    }

    fn corners(&self) -> [(usize, usize, f64); 4] {
        let (u, v) = (self.u, self.v);
        [
            (self.row, self.column, (1.0 - u) * (1.0 - v)),
            (self.row, self.column + 1, u * (1.0 - v)),
            (self.row + 1, self.column, (1.0 - u) * v),
            (self.row + 1, self.column + 1, u * v),
        ]
    }

    /// Whether all corners that count have data.
    fn supported(&self, table: &[Vec<Option<(f64, f64)>>]) -> bool {
        self.corners().iter().all(|&(r, c, w)| w < 1e-9 || table[r][c].is_some())
    }

    /// The standard deviation between the corners; a corner without data takes the largest of the
    /// table, because nothing is known there.
    fn interpolate(&self, surface: &Surface) -> f64 {
        let sd = |r: usize, c: usize| surface.table[r][c].map_or(surface.largest_sd, |e| e.1);
        self.corners().iter().map(|&(r, c, w)| w * sd(r, c)).sum()
    }
}

/// Solves a small dense system by elimination with row exchange; nothing if it is singular.
pub(crate) fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| matrix[a][k].abs().total_cmp(&matrix[b][k].abs()))?;
        if matrix[pivot][k].abs() < 1e-12 {
            return None;
        }
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        let above = matrix[k].clone();
        for (i, row) in matrix.iter_mut().enumerate().skip(k + 1) {
            let factor = row[k] / above[k];
            for (entry, over) in row.iter_mut().zip(&above).skip(k) {
                *entry -= factor * over;
            }
            right[i] -= factor * right[k];
        }
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            right[k] -= matrix[k][j] * right[j];
        }
        right[k] /= matrix[k][k];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exactly_one_at_the_centre_and_near_one_beside_it() {
        let map = published();
        assert_eq!(map.at_ratio(0.0, 0.0), Eccentricity::CENTRED);
        assert_eq!(map.at_ratio(1.0, -2.0), Eccentricity::CENTRED);
        let beside = map.at_ratio(1e-7, 0.0);
        assert!((beside.force - 1.0).abs() < 1e-9 && (beside.deflection - 1.0).abs() < 1e-9);
        assert!(beside.force_sd < 1e-4);
    }

    #[test]
    fn meets_the_fixed_points_of_table_1() {
        let map = published();
        for (ex, ey, force, deflection) in
            [(2.0 / 4.0, 0.2 / 4.0, 1.139, 0.815), (0.55 / 3.5, 1.15 / 3.5, 0.628, 0.850)]
        {
            let e = map.at_ratio(ex, ey);
            // Rounding of a 3 x 3 solution.
            assert!((e.force - force).abs() < 1e-12 && (e.deflection - deflection).abs() < 1e-12);
        }
    }

    #[test]
    fn even_and_periodic() {
        let map = published();
        for (x, y) in [(0.13, 0.31), (0.5, 0.07), (0.44, 0.18)] {
            let e = map.at_ratio(x, y);
            assert_eq!(map.at_ratio(-x, y), e);
            assert_eq!(map.at_ratio(x, -y), e);
            // Folding 1 + x back loses one bit of x.
            let shifted = map.at_ratio(x + 1.0, y - 1.0);
            assert!((shifted.force - e.force).abs() < 1e-12);
        }
    }

    #[test]
    fn smooth_across_the_mirror_lines() {
        // The slope across x = 0 and x = 0.5 is zero: a step of 1e-4 changes nothing but second order.
        let map = published();
        for y in [0.0, 0.05, 0.2] {
            for x in [0.0, 0.5] {
                let (here, beside) = (map.at_ratio(x, y), map.at_ratio(x - 1e-4, y));
                assert!((here.force - beside.force).abs() < 1e-5, "{x} {y}");
            }
        }
    }

    #[test]
    fn the_smooth_surface_stays_within_the_tables_scatter() {
        let map = published();
        for (surface, least) in [(&map.force, 0.02), (&map.deflection, 0.01)] {
            for (row, &y) in surface.table.iter().zip(&map.rows) {
                for (entry, &x) in row.iter().zip(&map.columns) {
                    let Some((value, sd)) = *entry else { continue };
                    let off = surface.smooth_value(&Basis::at(x, y)) - value;
                    assert!(off.abs() <= f64::max(sd, least), "{x} {y}: {off:+.3}");
                }
            }
            // Where the table has no data the surface stays between sensible bounds.
            for i in 0..=20 {
                for j in 0..=20 {
                    let v =
                        surface.smooth_value(&Basis::at(f64::from(i) / 40.0, f64::from(j) / 40.0));
                    assert!((0.3..1.2).contains(&v), "{i} {j}: {v}");
                }
            }
        }
    }

    #[test]
    fn uncertainty_at_a_fixed_point_is_the_size_of_the_correction() {
        let map = published();
        let (x, y) = (0.55 / 3.5, 1.15 / 3.5);
        let smooth = map.force.smooth_value(&Basis::at(x, y));
        let e = map.at_ratio(x, y);
        // 1 - nearness is not quite 0 there because the centre of the bell has images.
        assert!((e.force_sd - (0.628 - smooth).abs()).abs() < 0.005);
        assert!(!map.at_ratio(0.45, 0.45).supported && map.at_ratio(0.15, 0.15).supported);
    }

    #[test]
    fn broken_maps_are_refused() {
        assert!(Map::from_ron("()").is_err());
        assert!(Map::from_ron(&TEXT.replacen("(1.00, 0.00)", "(1.01, 0.00)", 1)).is_err());
        assert!(Map::from_ron(&TEXT.replacen("0.3, 0.4, 0.5]", "0.3, 0.4]", 1)).is_err());
    }
}

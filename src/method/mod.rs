//! A derived method: what a campaign of simulations says in place of the paper's relations.
//!
//! The data and what they give for a layout; how they are found is left to `lab::derive`, and how a
//! forecast uses them to `forecast`.
//!
//! - this file: the whole file of a method; [`sizes`]: force and deflection of a centred block;
//!   [`offset`]: what an offset does to them.

#[cfg(test)]
pub(crate) mod canned;
pub(crate) mod offset;
pub(crate) mod sizes;

use crate::layout::Blocks;
use crate::units;
use offset::Offsets;
use serde::{Deserialize, Serialize};
use sizes::{Product, Sizes};

/// Form of the file.
pub(crate) const FORMAT: u32 = 1;

/// A derived method as its file has it. Forces in kN, lengths in m.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DerivedMethod {
    /// Form of the file.
    pub(crate) format: u32,
    pub(crate) name: String,
    /// Identifier of the mesh.
    pub(crate) mesh: String,
    /// Print of the mesh's net and wires.
    pub(crate) wires: String,
    /// How the blocks stood.
    pub(crate) blocks: Blocks,
    /// Revisions of solver and sampling that made the runs.
    pub(crate) revisions: String,
    /// How exactly they were computed.
    pub(crate) fidelity: String,
    pub(crate) campaigns: Vec<Source>,
    /// What became of their runs.
    pub(crate) runs: Counts,
    /// Ranges of d, L and D, m.
    pub(crate) ranges: [[f64; 2]; 3],
    /// The standard laboratory test.
    pub(crate) laboratory: Anchor,
    /// The anchored reference panel: F_a*, delta_a*.
    pub(crate) reference: Anchor,
    /// alpha_F and its standard error, alpha_delta and its.
    pub(crate) alpha: Alpha,
    /// Size relations in the published form, refitted.
    pub(crate) refitted: Product,
    /// Those in the best form found, which the method uses.
    pub(crate) sizes: Sizes,
    /// What an offset does.
    pub(crate) offsets: Offsets,
    /// The normalised curve.
    pub(crate) master: MasterCurve,
    /// Standard deviation of a single run over the method's value.
    pub(crate) scatter: Scatter,
    /// Errors of the forms that were compared: each run by fits that did not see it.
    pub(crate) compared: Vec<FormError>,
    /// Single runs over the method's value, each by fits that did not see it.
    pub(crate) cross_validated: Vec<HeldOut>,
}

impl DerivedMethod {
    /// Reads a method's file.
    ///
    /// # Errors
    /// A sentence that says what is wrong with the text, and where.
    pub(crate) fn from_ron(text: &str) -> Result<DerivedMethod, String> {
        let options = ron::Options::default()
            .with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
        let method: DerivedMethod = options.from_str(text).map_err(|e| e.to_string())?;
        method.check().map(|()| method)
    }

    /// What is wrong with a file that could be read: numbers of another form than this program evaluates.
    pub(crate) fn check(&self) -> Result<(), String> {
        if self.format != FORMAT {
            return Err(format!("its form is {} and not {FORMAT}: derive it again", self.format));
        }
        let offsets = &self.offsets;
        let due = offsets.through.map(|form| offset::count(offsets.harmonics, form));
        if [offsets.force.len(), offsets.deflection.len()] != due {
            let [force, deflection] = due;
            return Err(format!("offsets: {force} and {deflection} coefficients are needed"));
        }
        let [a, b, c] = self.master.cubic;
        if !(a > 0.0 && c > b * b / (3.0 * a) && (a + b + c - 1.0).abs() < 1.0e-9) {
            return Err("master: the cubic must rise everywhere, to 1 at 1".into());
        }
        let positive = [self.alpha.force, self.alpha.deflection, self.sizes.sharpness];
        if !positive.iter().all(|v| v.is_finite() && *v > 0.0) {
            return Err("alpha and sharpness must be above 0".into());
        }
        Ok(())
    }
}

/// A campaign that a method was derived from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Source {
    pub(crate) seed: u64,
    /// Its runs of random layouts.
    pub(crate) runs: usize,
    /// Share of them with an offset.
    pub(crate) eccentric: f64,
}

/// What became of the runs of random layouts.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Counts {
    pub(crate) asked: usize,
    /// In the fits.
    pub(crate) used: usize,
    /// Slipped through.
    pub(crate) slipped: usize,
    pub(crate) diverged: usize,
    /// Not run or without a break, by reason.
    pub(crate) left_out: Vec<(String, usize)>,
}

/// Means of runs of one scene, with their standard errors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Anchor {
    /// Force at the first break, N (kN in files).
    #[serde(with = "units::file::force")]
    pub(crate) force: f64,
    /// Its standard error, N (kN in files).
    #[serde(with = "units::file::force")]
    pub(crate) force_error: f64,
    /// Deflection there, m.
    pub(crate) deflection: f64,
    /// Its standard error, m.
    pub(crate) deflection_error: f64,
    pub(crate) runs: usize,
}

/// Ratios of the anchored reference to the laboratory.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Alpha {
    /// alpha_F.
    pub(crate) force: f64,
    /// Its standard error.
    pub(crate) force_error: f64,
    /// alpha_delta.
    pub(crate) deflection: f64,
    /// Its standard error.
    pub(crate) deflection_error: f64,
}

/// The normalised curve: a x^3 + b x^2 + c x, and what runs scatter about it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MasterCurve {
    /// a, b, c: 1 at 1 and rising everywhere.
    pub(crate) cubic: [f64; 3],
    /// The same without either condition, as the paper fitted it.
    pub(crate) free: [f64; 3],
    /// Points of the runs at equal steps from 0 to 1: 5 %, 50 % and 95 % of them lie below.
    pub(crate) envelope: Vec<[f64; 3]>,
}

/// Standard deviation of a single run over the method's value: alignment and slack, and what the method
/// misses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Scatter {
    /// Of force and deflection where the block decides, centred.
    pub(crate) small: [f64; 2],
    /// Likewise where the anchors decide.
    pub(crate) large: [f64; 2],
    /// With an offset, where the block decides.
    pub(crate) small_offset: [f64; 2],
    /// With an offset, where the anchors decide.
    pub(crate) large_offset: [f64; 2],
}

/// Error of a form of the size relations.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FormError {
    /// The form in words.
    pub(crate) form: String,
    /// Root mean square of run over form, less 1, of force and deflection, for D below 0.4 m.
    pub(crate) below: [f64; 2],
    /// The same for D above it.
    pub(crate) above: [f64; 2],
}

/// Values over the method's, of one part of the layouts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct HeldOut {
    /// Which part.
    pub(crate) part: String,
    /// How many.
    pub(crate) n: usize,
    /// 10 %, 50 % and 90 % points of the force's quotients.
    pub(crate) force: [f64; 3],
    /// The same of the deflection's.
    pub(crate) deflection: [f64; 3],
}

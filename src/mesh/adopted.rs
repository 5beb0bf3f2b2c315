//! What a mesh carries that was adopted from its own tests: how well its law is known, and the methods of
//! forecasts that simulations with it gave.

use crate::layout::Blocks;
use crate::method::DerivedMethod;
use crate::problem::Problem;
use crate::units::{self, shortest, to_kn};
use crate::words::Choice;
use serde::de::Error as _;
use serde::ser::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::sync::{Mutex, PoisonError};

/// Part of the middle value up to which the laws that fit may differ before no verdict is a plain pass.
const WIDE: f64 = 0.15;
/// Standard deviations from the middle of a normal distribution to its 5 % point.
const FIVE_PER_CENT: f64 = 1.645;

/// How a mesh was adopted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Adopted {
    /// What its law rests on.
    pub(crate) quality: AdoptedQuality,
    /// Force of the anchored reference panel that 5 % of the laws that fit fall below, N (kN in files).
    #[serde(with = "units::file::force")]
    pub(crate) low: f64,
    /// The force that half of them fall below.
    #[serde(with = "units::file::force")]
    pub(crate) middle: f64,
    /// The force that 95 % of them fall below.
    #[serde(with = "units::file::force")]
    pub(crate) high: f64,
    /// Its methods, by how the blocks stand; the one for repeated blocks at least.
    pub(crate) methods: Vec<KeptMethod>,
}

/// What the law of an adopted mesh rests on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum AdoptedQuality {
    /// A punch test and one more: a tensile test, a curve, another panel.
    TwoTests,
    /// A punch test, and what is known of steel wire.
    OneTestAndPrior,
    /// The force of a punch test alone.
    ForceOnly,
}

impl Choice for AdoptedQuality {
    const ALL: &'static [AdoptedQuality] =
        &[AdoptedQuality::TwoTests, AdoptedQuality::OneTestAndPrior, AdoptedQuality::ForceOnly];

    fn word(self) -> &'static str {
        match self {
            AdoptedQuality::TwoTests => "two tests",
            AdoptedQuality::OneTestAndPrior => "one test and prior",
            AdoptedQuality::ForceOnly => "force only",
        }
    }
}

/// A method that a mesh holds. It lives as long as the program, so that a forecast may point to it: a project
/// has a handful, and the same one is kept once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct KeptMethod(pub(crate) &'static DerivedMethod);

impl KeptMethod {
    /// Keeps a method, its numbers as they come back from a file.
    pub(crate) fn keep(mut method: DerivedMethod) -> KeptMethod {
        // kN and N: a number that went to a file and back may have moved by its last bit, once.
        for _ in 0..4 {
            match text(&method).and_then(|text| DerivedMethod::from_ron(&text).ok()) {
                Some(again) if again != method => method = again,
                _ => break,
            }
        }
        static KEPT: Mutex<Vec<&'static DerivedMethod>> = Mutex::new(Vec::new());
        // Nothing here panics while it holds the lock, and the list stays whole if it did.
        let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(same) = kept.iter().find(|same| ***same == method) {
            return KeptMethod(same);
        }
        let new: &'static DerivedMethod = Box::leak(Box::new(method));
        kept.push(new);
        KeptMethod(new)
    }
}

/// Methods that a project names by file, of one mesh.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NamedMethods(pub(crate) Vec<KeptMethod>);

impl NamedMethods {
    /// The one for an arrangement.
    pub(crate) fn method(&self, blocks: Blocks) -> Option<&'static DerivedMethod> {
        of_blocks(&self.0, blocks)
    }
}

fn of_blocks(list: &[KeptMethod], blocks: Blocks) -> Option<&'static DerivedMethod> {
    list.iter().map(|kept| kept.0).find(|method| method.blocks == blocks)
}

/// A method's file on one line. Within another file it stands as this text: it is made and read by programs, and
/// whoever wants to see it has `meshcast derive`.
fn text(method: &DerivedMethod) -> Option<String> {
    ron::ser::to_string(method).ok()
}

impl Serialize for KeptMethod {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let text = text(self.0).ok_or_else(|| S::Error::custom("the method cannot be written"))?;
        serializer.serialize_str(&text)
    }
}

impl<'de> Deserialize<'de> for KeptMethod {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        DerivedMethod::from_ron(&text).map(KeptMethod::keep).map_err(D::Error::custom)
    }
}

impl Adopted {
    /// The method of its own for an arrangement.
    pub(crate) fn method(&self, blocks: Blocks) -> Option<&'static DerivedMethod> {
        of_blocks(&self.methods, blocks)
    }

    /// Coefficient of variation of a force over the laws that fit.
    pub(crate) fn variation(&self) -> f64 {
        libm::log(self.high / self.low) / (2.0 * FIVE_PER_CENT)
    }

    /// Whether the laws that fit differ so much that no verdict is a plain pass.
    pub(crate) fn wide(&self) -> bool {
        self.high > (1.0 + WIDE) * self.middle || self.low < (1.0 - WIDE) * self.middle
    }

    /// What is wrong with it.
    pub(super) fn problem(&self) -> Option<Problem> {
        let order = 0.0 < self.low && self.low <= self.middle && self.middle <= self.high;
        if !(order && self.high.is_finite()) {
            let kn = |v: f64| shortest(to_kn(v));
            return Some(
                Problem::new("adopted.low", "the range of an adopted mesh is no range")
                    .value(format!("{}, {}, {} kN", kn(self.low), kn(self.middle), kn(self.high)))
                    .allowed("low, middle and high above 0, none below the one before"),
            );
        }
        self.method(Blocks::Repeated).is_none().then(|| {
            Problem::new("adopted.methods", "a method for repeated blocks is missing")
                .advice("meshcast adopt makes it")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::canned;

    #[test]
    fn a_method_comes_back_from_its_text_and_is_kept_once() {
        let mut method = canned::method();
        // A force that kN and back moves by a bit.
        method.laboratory.force = 73_299.999_999_999_99;
        let kept = KeptMethod::keep(method);
        let back: KeptMethod = ron::from_str(&ron::ser::to_string(&kept).unwrap()).unwrap();
        assert!(std::ptr::eq(kept.0, back.0));
        assert!(ron::from_str::<KeptMethod>("\"(format: 1)\"").is_err());
    }

    #[test]
    fn the_range_is_a_variation_and_wide_from_fifteen_per_cent_on() {
        let of = |low: f64, high: f64| Adopted {
            quality: AdoptedQuality::ForceOnly,
            low: 1000.0 * low,
            middle: 20_000.0,
            high: 1000.0 * high,
            methods: vec![KeptMethod::keep(canned::method())],
        };
        assert!(!of(17.1, 22.9).wide() && of(16.9, 20.0).wide() && of(20.0, 23.1).wide());
        // By hand: ln(24.2/20)/(2 x 1.645) = 0.190620/3.29 = 0.05794.
        assert!((of(20.0, 24.2).variation() - 0.057_94).abs() < 1e-5);
        assert!(of(17.1, 22.9).problem().is_none() && of(21.0, 22.9).problem().is_some());
        assert!(Adopted { methods: vec![], ..of(17.1, 22.9) }.problem().is_some());
    }
}

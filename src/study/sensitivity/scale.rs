//! Changes as texts that stand under each other.

use super::Effect;
use crate::units::{LengthUnit, to_kn};

/// Changes with as many decimals as the largest of them needs for three digits, so that they stand
/// under each other.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EffectScale {
    /// The value whose changes they are.
    pub(crate) effect: Effect,
    unit: LengthUnit,
    decimals: usize,
}

impl EffectScale {
    /// For changes up to `most`, SI, in a unit of length.
    pub(crate) fn new(effect: Effect, unit: LengthUnit, most: f64) -> EffectScale {
        let largest = in_unit(most, effect, unit);
        // From none for hundreds to six for what is next to nothing.
        let decimals = if largest > 0.0 { 2.0 - largest.log10().floor() } else { 0.0 };
        EffectScale { effect, unit, decimals: decimals.clamp(0.0, 6.0) as usize }
    }

    /// A change with its sign.
    pub(crate) fn text(&self, change: f64) -> String {
        let text = format!("{:+.*}", self.decimals, in_unit(change, self.effect, self.unit));
        // What is rounded to nothing has no sign.
        if text.chars().all(|c| "+-0.".contains(c)) { "0".to_string() } else { text }
    }

    /// A size without a sign.
    pub(crate) fn size(&self, change: f64) -> String {
        self.text(change.abs()).trim_start_matches('+').to_string()
    }
}

/// A change in the unit that is shown.
fn in_unit(change: f64, effect: Effect, unit: LengthUnit) -> f64 {
    match effect {
        Effect::Force => to_kn(change),
        Effect::Deflection => change * unit.per_metre(),
        Effect::Utilisation => change * 100.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_have_the_decimals_of_the_largest() {
        let m = EffectScale::new(Effect::Deflection, LengthUnit::Metre, 0.0712);
        assert_eq!([m.text(0.0712), m.text(-0.000_27)], ["+0.0712", "-0.0003"]);
        assert_eq!([m.text(-0.000_01), m.size(-0.0142)], ["0", "0.0142"]);
        let mm = EffectScale::new(Effect::Deflection, LengthUnit::Millimetre, 0.0712);
        assert_eq!(mm.text(-0.0712), "-71.2");
        let kn = EffectScale::new(Effect::Force, LengthUnit::Metre, 123.0e3);
        assert_eq!([kn.text(99.6e3), kn.text(0.0)], ["+100", "0"]);
        assert_eq!(EffectScale::new(Effect::Force, LengthUnit::Metre, 0.0).text(0.0), "0");
    }
}

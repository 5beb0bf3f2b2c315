//! The value that a study shows, read from forecast and check, in the unit shown and in words.

use crate::case::CasePoint;
use crate::study::checks::figures::Figures;
use crate::study::sensitivity::Effect;
use crate::units::{Units, percent, significant};

/// The value of a forecast, SI.
pub(crate) fn read(point: &CasePoint, effect: Effect) -> Option<f64> {
    match effect {
        Effect::Force => Some(point.values().force),
        Effect::Deflection => point.values().deflection,
        Effect::Utilisation => point.utilisation(),
        Effect::Service => point.service_deflection(),
    }
}

/// The value of a check, SI, where a run broke.
pub(crate) fn found(figures: &Figures, effect: Effect) -> Option<f64> {
    match effect {
        Effect::Force => figures.mean.map(|v| v.force),
        Effect::Deflection => figures.mean.map(|v| v.deflection),
        Effect::Utilisation => figures.utilisation,
        Effect::Service => None,
    }
}

/// The band of a check, SI, where the value has one.
pub(crate) fn band(figures: &Figures, effect: Effect) -> Option<[f64; 2]> {
    match effect {
        Effect::Force => figures.force_band,
        Effect::Deflection => figures.deflection_band,
        Effect::Utilisation | Effect::Service => None,
    }
}

/// The paper's symbol, without saying whose value it is.
pub(crate) fn symbol(effect: Effect) -> &'static str {
    match effect {
        Effect::Force => "F",
        Effect::Deflection => "delta",
        Effect::Utilisation => "use",
        Effect::Service => "delta at F",
    }
}

/// The symbol of the forecast's value, or of the check's.
pub(crate) fn whose(effect: Effect, check: bool) -> &'static str {
    match (effect, check) {
        (Effect::Force, false) => "F_a",
        (Effect::Deflection, false) => "delta_a",
        (Effect::Utilisation, false) => "use",
        (Effect::Service, _) => "delta at F",
        (Effect::Force, true) => "DEM F",
        (Effect::Deflection, true) => "DEM delta",
        (Effect::Utilisation, true) => "DEM use",
    }
}

/// The unit shown.
pub(crate) fn unit(effect: Effect, unit: Units) -> &'static str {
    match effect {
        Effect::Force => unit.force_symbol(),
        Effect::Deflection | Effect::Service => unit.symbol(),
        Effect::Utilisation => "%",
    }
}

/// An SI value in the unit shown.
pub(crate) fn in_unit(value: f64, effect: Effect, unit: Units) -> f64 {
    match effect {
        Effect::Force => unit.force(value),
        Effect::Deflection | Effect::Service => value * unit.per_metre(),
        Effect::Utilisation => value * 100.0,
    }
}

/// An SI value as a number in the unit shown.
pub(crate) fn number(value: f64, effect: Effect, unit: Units) -> String {
    match effect {
        Effect::Force => unit.force_number(value, 3),
        Effect::Deflection | Effect::Service => deflection(value, unit),
        Effect::Utilisation => percent(value),
    }
}

/// A deflection, m, in the unit shown, without its symbol.
pub(crate) fn deflection(metres: f64, unit: Units) -> String {
    unit.length_number(metres)
}

/// The same of one that may be missing, `-`.
pub(crate) fn maybe_deflection(metres: Option<f64>, unit: Units) -> String {
    metres.map_or("-".into(), |metres| deflection(metres, unit))
}

/// How changes of a value are written.
#[derive(Debug, Clone, Copy)]
pub(crate) struct EffectScale {
    effect: Effect,
    unit: Units,
    /// Decimals of all; nothing for three digits each.
    decimals: Option<usize>,
}

impl EffectScale {
    /// Three digits each.
    pub(crate) fn digits(effect: Effect, unit: Units) -> EffectScale {
        EffectScale { effect, unit, decimals: None }
    }

    /// With as many decimals as the largest of them, `most` (SI), needs for three digits, so that they
    /// stand under each other.
    pub(crate) fn aligned(effect: Effect, unit: Units, most: f64) -> EffectScale {
        let largest = in_unit(most, effect, unit);
        // From none for hundreds to six for what is next to nothing.
        let decimals = if largest > 0.0 { 2.0 - largest.log10().floor() } else { 0.0 };
        EffectScale { effect, unit, decimals: Some(decimals.clamp(0.0, 6.0) as usize) }
    }

    /// A change, SI, with its sign.
    pub(crate) fn text(&self, change: f64) -> String {
        let value = in_unit(change, self.effect, self.unit);
        let Some(decimals) = self.decimals else {
            let sign = if value < 0.0 { "-" } else { "+" };
            let digits = || format!("{sign}{}", significant(value.abs(), 3));
            return if value.abs() < 5e-10 { "0".to_string() } else { digits() };
        };
        let text = format!("{value:+.decimals$}");
        // What is rounded to nothing has no sign.
        if text.chars().all(|c| "+-0.".contains(c)) { "0".to_string() } else { text }
    }

    /// A size, SI, without a sign.
    pub(crate) fn size(&self, change: f64) -> String {
        self.text(change.abs()).trim_start_matches('+').to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_have_the_decimals_of_the_largest_or_three_digits_each() {
        let m = EffectScale::aligned(Effect::Deflection, Units::METRES, 0.0712);
        assert_eq!([m.text(0.0712), m.text(-0.000_27)], ["+0.0712", "-0.0003"]);
        assert_eq!([m.text(-0.000_01), m.size(-0.0142)], ["0", "0.0142"]);
        let mm = EffectScale::aligned(Effect::Deflection, Units::MILLIMETRES, 0.0712);
        assert_eq!(mm.text(-0.0712), "-71.2");
        let kn = EffectScale::aligned(Effect::Force, Units::METRES, 123.0e3);
        assert_eq!([kn.text(99.6e3), kn.text(0.0)], ["+100", "0"]);
        assert_eq!(EffectScale::aligned(Effect::Force, Units::METRES, 0.0).text(0.0), "0");
        let each = EffectScale::digits(Effect::Deflection, Units::METRES);
        assert_eq!([each.text(-0.000_27), each.text(0.0)], ["-0.000270", "0"]);
    }
}

//! What simulating laws gave, in the order in which they were asked for: a search is the same each time, so that
//! one that was cut off goes on where it was by being told again what it had been told.

use super::family::LawParameters;
use super::rows::Ended;
use crate::dem::Flow;
use std::collections::VecDeque;
use std::fmt::Write;

/// What a law gave: some figures, or nothing where it cannot be run.
pub(crate) type Gave = Option<Vec<f64>>;

/// A law that was tried, what of it was asked for, and what it gave.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TriedLaw {
    /// Its parameters, and behind them whether the field was asked for too (1) or not (0).
    key: Vec<f64>,
    gave: Gave,
}

/// Laws tried before, and where new ones are kept.
pub(crate) struct LawMemory<'a> {
    known: VecDeque<TriedLaw>,
    keep: &'a mut dyn FnMut(&TriedLaw) -> Flow,
}

impl<'a> LawMemory<'a> {
    /// Of laws tried before in the same search, in their order. `keep` gets each new one, and may end it all.
    pub(crate) fn new(
        known: Vec<TriedLaw>,
        keep: &'a mut dyn FnMut(&TriedLaw) -> Flow,
    ) -> LawMemory<'a> {
        LawMemory { known: known.into(), keep }
    }

    /// What a law gave before, or gives now.
    ///
    /// # Errors
    /// Why it was ended.
    pub(super) fn ask(
        &mut self,
        law: &LawParameters,
        field: bool,
        try_it: impl FnOnce() -> Result<Gave, Ended>,
    ) -> Result<Gave, Ended> {
        let mut key = law.values().to_vec();
        key.push(f64::from(u8::from(field)));
        match self.known.pop_front() {
            Some(known) if known.key == key => return Ok(known.gave),
            // Another search wrote what follows.
            Some(_) => self.known.clear(),
            None => {}
        }
        let tried = TriedLaw { key, gave: try_it()? };
        match (self.keep)(&tried) {
            Flow::Continue => Ok(tried.gave),
            Flow::Cancel => Err(Ended::Cancelled),
        }
    }
}

impl TriedLaw {
    /// Its line in a file. Numbers stand as they come back to the last bit.
    pub(crate) fn line(&self) -> String {
        let mut line = String::new();
        // Writing to a text cannot fail.
        for value in &self.key {
            let _ = write!(line, "{value} ");
        }
        line.push(':');
        match &self.gave {
            Some(values) => values.iter().for_each(|value| {
                let _ = write!(line, " {value}");
            }),
            None => line.push_str(" nothing"),
        }
        line.push('\n');
        line
    }

    /// A law from its line; nothing where it is none.
    pub(crate) fn read(line: &str) -> Option<TriedLaw> {
        let numbers = |text: &str| -> Option<Vec<f64>> {
            text.split_whitespace().map(|word| word.parse().ok()).collect()
        };
        let (key, gave) = line.strip_suffix('\n')?.split_once(':')?;
        let gave = if gave == " nothing" { None } else { Some(numbers(gave)?) };
        Some(TriedLaw { key: numbers(key)?, gave })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(stress: f64) -> LawParameters {
        LawParameters::of([stress, 0.4, 0.14, 0.67, 0.16, 0.03])
    }

    #[test]
    fn a_law_comes_back_from_its_line_to_the_last_bit_and_a_torn_line_is_none() {
        let mut lines = Vec::new();
        let mut keep = |tried: &TriedLaw| {
            lines.push(tried.clone());
            Flow::Continue
        };
        let mut memory = LawMemory::new(Vec::new(), &mut keep);
        let gave = Some(vec![73_299.999_999_999_99, 0.1 + 0.2, 1.0e-300]);
        assert_eq!(memory.ask(&law(1.0 / 3.0), true, || Ok(gave.clone())), Ok(gave));
        assert_eq!(memory.ask(&law(2.0), false, || Ok(None)), Ok(None));
        for tried in &lines {
            let line = tried.line();
            assert_eq!(TriedLaw::read(&line).as_ref(), Some(tried));
            for cut in 0..line.len() {
                assert_eq!(TriedLaw::read(&line[..cut]), None, "{cut}");
            }
        }
        assert_eq!(lines.len(), 2);
    }

    #[test]
    fn what_was_tried_before_is_not_tried_again_until_another_law_is_asked_for() {
        let known = |stress: f64, gave: f64| TriedLaw {
            key: [&law(stress).values()[..], &[0.0]].concat(),
            gave: Some(vec![gave]),
        };
        let mut kept = 0;
        let mut keep = |_: &TriedLaw| {
            kept += 1;
            if kept == 2 { Flow::Cancel } else { Flow::Continue }
        };
        let mut memory = LawMemory::new(vec![known(1.0, 10.0), known(2.0, 20.0)], &mut keep);
        let never = || panic!("it is known");
        assert_eq!(memory.ask(&law(1.0), false, never), Ok(Some(vec![10.0])));
        // The same law with the field is another question; what stood behind is of another search.
        assert_eq!(memory.ask(&law(2.0), true, || Ok(Some(vec![5.0]))), Ok(Some(vec![5.0])));
        let ended = memory.ask(&law(2.0), false, || Ok(Some(vec![6.0])));
        assert_eq!(ended, Err(Ended::Cancelled));
    }
}

//! How much something that a result has to say of itself weighs. Each kind of result has an enum of its
//! remarks, and each remark a stable `code` for programs, a `weight`, a few words (`short`) for a narrow
//! panel and a `sentence` without a final stop. Whoever shows one prints these and words nothing.

/// How much a remark weighs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Weight {
    /// Good to know; the number stands.
    Note,
    /// The number is extrapolated, uncertain or rests on an assumption.
    Caution,
    /// There is no number.
    Outside,
}

impl Weight {
    /// The word in output: `note`, `caution` or `outside`.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Weight::Note => "note",
            Weight::Caution => "caution",
            Weight::Outside => "outside",
        }
    }
}

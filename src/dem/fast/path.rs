//! The instruction set of the kernel.

use std::fmt;

/// Instruction set of the kernel. The answer has the same bits with each.
///
/// One can only be had from this file, which gives none that the processor was not seen to have: that
/// is what makes it sound to run the kernel of a path that somebody hands over.
///
/// ```compile_fail,E0423
/// let any = meshcast::dem::fast::Path(todo!());
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Path(Set);

/// The set inside of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Set {
    /// AVX-512F, 16 lanes.
    #[cfg(target_arch = "x86_64")]
    Avx512,
    /// AVX2, 8 lanes.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// SSE2, 4 lanes: every x86-64 processor.
    #[cfg(target_arch = "x86_64")]
    Sse2,
    /// No instructions of its own: any processor.
    Portable,
}

impl Path {
    /// The words for all of them, on whatever processor, the widest first.
    pub(crate) const WORDS: [&str; 4] = ["avx512", "avx2", "sse2", "portable"];

    /// The paths that this processor has, the widest first.
    pub fn available() -> Vec<Path> {
        let mut paths = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512f") {
                paths.push(Path(Set::Avx512));
            }
            if is_x86_feature_detected!("avx2") {
                paths.push(Path(Set::Avx2));
            }
            paths.push(Path(Set::Sse2));
        }
        paths.push(Path::portable());
        paths
    }

    /// The widest path that this processor has.
    pub fn best() -> Path {
        Path::available()[0] // Never empty: the portable one is always pushed.
    }

    /// The path that every processor has.
    pub fn portable() -> Path {
        Path(Set::Portable)
    }

    /// The path of a word; nothing where this processor does not have it.
    pub(crate) fn from_word(word: &str) -> Option<Path> {
        Path::available().into_iter().find(|path| path.word() == word)
    }

    fn word(self) -> &'static str {
        match self.0 {
            #[cfg(target_arch = "x86_64")]
            Set::Avx512 => "avx512",
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => "avx2",
            #[cfg(target_arch = "x86_64")]
            Set::Sse2 => "sse2",
            Set::Portable => "portable",
        }
    }

    /// The set, for the kernel.
    pub(super) fn set(self) -> Set {
        self.0
    }
}

impl fmt::Debug for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_gives_a_path_only_where_the_processor_has_it() {
        let had: Vec<Option<Path>> = Path::WORDS.iter().map(|w| Path::from_word(w)).collect();
        assert_eq!(had.iter().flatten().copied().collect::<Vec<_>>(), Path::available());
        assert_eq!(Path::from_word("portable"), Some(Path::portable()));
        assert_eq!(Path::from_word("mmx"), None);
    }
}

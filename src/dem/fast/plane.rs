//! A plane of numbers that starts at a cache line, so that whole vectors do not straddle two.

use std::ops::{Deref, DerefMut};

/// Bytes in a cache line.
const LINE: usize = 64;

/// Numbers in a row, the first at a multiple of 64 bytes.
#[derive(Debug)]
pub(super) struct Plane<R> {
    all: Vec<R>,
    start: usize,
    len: usize,
}

impl<R: Copy> Plane<R> {
    /// `len` numbers, all `value`.
    pub(super) fn new(value: R, len: usize) -> Plane<R> {
        let spare = LINE / size_of::<R>();
        let all = vec![value; len + spare];
        // Where no place is aligned any start is right.
        let start = all.as_ptr().align_offset(LINE).min(spare);
        Plane { all, start, len }
    }
}

impl<R: Copy> Clone for Plane<R> {
    fn clone(&self) -> Plane<R> {
        match self.first() {
            Some(&first) => {
                let mut copy = Plane::new(first, self.len);
                copy.copy_from_slice(self);
                copy
            }
            None => Plane { all: Vec::new(), start: 0, len: 0 },
        }
    }
}

impl<R> Deref for Plane<R> {
    type Target = [R];
    fn deref(&self) -> &[R] {
        &self.all[self.start..self.start + self.len]
    }
}

impl<R> DerefMut for Plane<R> {
    fn deref_mut(&mut self) -> &mut [R] {
        &mut self.all[self.start..self.start + self.len]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_and_their_copies_start_at_a_cache_line() {
        for len in [1, 7, 1000] {
            let mut plane = Plane::new(1.0_f32, len);
            plane[len - 1] = 2.0;
            let copy = plane.clone();
            assert_eq!(copy.as_ptr() as usize % LINE, 0);
            assert_eq!(plane.as_ptr() as usize % LINE, 0);
            assert_eq!((copy[len - 1], copy.len()), (2.0, len));
        }
        assert!(Plane::new(0.0_f64, 0).clone().is_empty());
    }
}

//! Step 3 of the method: the master curve, Eq. 3 of Pol & Gabrieli (2021) or one with other coefficients, its
//! exact inverse, slope and area. Normalised: deflection over delta_a, force over F_a, from 0 to 1.

/// A cubic a x^3 + b x^2 + c x that is 1 at 1 and rises everywhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Master {
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) c: f64,
}

/// Eq. 3. Its slope is at least 0.035 everywhere.
pub(crate) const PUBLISHED: Master = Master { a: 1.312, b: -0.385, c: 0.073 };

impl Master {
    /// Normalised force at a normalised deflection `x` (0 at first touch, 1 at failure).
    pub(crate) fn force(&self, x: f64) -> f64 {
        x * (self.c + x * (self.b + x * self.a))
    }

    /// Slope dF/dx; above 0 everywhere, so the curve rises and has an inverse.
    pub(crate) fn slope(&self, x: f64) -> f64 {
        self.c + x * (2.0 * self.b + x * 3.0 * self.a)
    }

    /// Area under the curve from 0 to `x`: normalised absorbed energy.
    pub(crate) fn area(&self, x: f64) -> f64 {
        x * x * (self.c / 2.0 + x * (self.b / 3.0 + x * self.a / 4.0))
    }

    /// Exact inverse: the normalised deflection at a normalised force `y`.
    ///
    /// The cubic has one real root because its slope has none; Cardano's formula gives it, and two steps
    /// of Newton's method remove the rounding.
    pub(crate) fn deflection(&self, y: f64) -> f64 {
        if y == 0.0 {
            return 0.0;
        }
        let Master { a, b, c } = *self;
        // x = t - b/(3a) turns a x^3 + b x^2 + c x - y into a (t^3 + p t + q).
        let shift = b / (3.0 * a);
        let p = c / a - 3.0 * shift * shift;
        let q = 2.0 * shift * shift * shift - shift * c / a - y / a;
        // p > 0, so the root is real without cases.
        let root = libm::sqrt(q * q / 4.0 + p * p * p / 27.0);
        // The larger of the two cube roots, and the smaller from their product -p/3: no cancellation.
        let large = libm::cbrt(if q > 0.0 { -q / 2.0 - root } else { -q / 2.0 + root });
        let mut x = large - p / (3.0 * large) - shift;
        for _ in 0..2 {
            x -= (self.force(x) - y) / self.slope(x);
        }
        x
    }
}

/// Eq. 3: normalised force at a normalised deflection.
pub fn force(x: f64) -> f64 {
    PUBLISHED.force(x)
}

/// Slope of Eq. 3.
pub fn slope(x: f64) -> f64 {
    PUBLISHED.slope(x)
}

/// Area under Eq. 3 from 0 to `x`.
pub fn area(x: f64) -> f64 {
    PUBLISHED.area(x)
}

/// Exact inverse of Eq. 3.
pub fn deflection(y: f64) -> f64 {
    PUBLISHED.deflection(y)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn worked_by_hand() {
        assert!((force(1.0) - 1.0).abs() < 1e-15);
        // 1.312/8 - 0.385/4 + 0.073/2 = 0.164 - 0.09625 + 0.0365 = 0.10425
        assert!((force(0.5) - 0.10425).abs() < 1e-15);
        // 1.312/4 - 0.385/3 + 0.073/2 = 0.328 - 0.128333... + 0.0365
        assert!((area(1.0) - 0.236_166_666_666_666_7).abs() < 1e-15);
        // 3.936 - 0.77 + 0.073
        assert!((slope(1.0) - 3.239).abs() < 1e-14);
    }

    #[test]
    fn the_curve_rises_everywhere() {
        let least = (0..=1000).map(|i| slope(f64::from(i) / 1000.0)).fold(f64::MAX, f64::min);
        // Minimum at x = 0.385/3.936: 0.073 - 0.385^2/3.936 = 0.0353
        assert!((least - 0.0353).abs() < 1e-4);
    }

    #[test]
    fn the_inverse_is_exact() {
        for i in 0..=2000 {
            let x = f64::from(i) / 1000.0;
            // Rounding only: the slope is at least 0.035, so 1e-16 in y is 3e-15 in x.
            assert!((deflection(force(x)) - x).abs() < 1e-14, "{x}");
        }
    }

    #[test]
    fn the_inverse_of_a_cubic_that_starts_nearly_flat_is_exact_too() {
        let flat = Master { a: 1.107, b: -0.122, c: 0.015 };
        for i in 0..=1000 {
            let x = f64::from(i) / 1000.0;
            // The slope is at least 0.01: 1e-16 in y is 1e-14 in x.
            assert!((flat.deflection(flat.force(x)) - x).abs() < 1e-13, "{x}");
        }
    }
}

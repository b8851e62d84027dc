//! Transcendental functions with the same bits natively and in wasm.
//!
//! std's `exp`, `ln`, `pow`, `sin` come from the platform and differ in the last bit between
//! targets; `libm` is compiled from the same source everywhere. The pure layers take these
//! functions from here only (`clippy.toml` holds that). `sqrt`, `abs`, `floor` and the four
//! operations are exact by IEEE 754 and may be used from std.

pub use libm::{acos, cos, exp, log as ln, pow, sin, tanh};

/// Euler's number, e.
pub const E: f64 = std::f64::consts::E;
/// Half a turn, in radians.
pub const PI: f64 = std::f64::consts::PI;
/// A full turn, in radians.
pub const TAU: f64 = std::f64::consts::TAU;

/// Largest magnitude of a whole exponent that [`power`] multiplies out.
pub const MAX_WHOLE: f64 = 64.0;
/// Largest magnitude of a half exponent (1/2, 3/2, 5/2 ...) that [`power`] multiplies out.
pub const MAX_HALF: f64 = 32.0;

/// x^y, the one definition of `^` in a formula: in a search, in the loop and in what is exported.
///
/// | y | x^y |
/// |---|---|
/// | whole, at most 64 in magnitude | products ([`whole_power`]); for a negative y 1 over that of -y |
/// | half of an odd number, at most 32 in magnitude | that product for the whole part times sqrt(x); likewise |
/// | any other, x > 0 | exp(y ln x) |
/// | any other, x = 0 | 0 for y > 0, otherwise infinity |
/// | any other, x < 0 | NaN |
///
/// Exact where people expect it, x^2 = x x, and elsewhere no more than two functions that every program has;
/// [`pow`] is none of these.
#[must_use]
#[inline]
pub fn power(x: f64, y: f64) -> f64 {
    let magnitude = y.abs();
    let product = if magnitude <= MAX_WHOLE && magnitude.fract() == 0.0 {
        whole_power(x, whole(magnitude))
    } else if magnitude <= MAX_HALF && magnitude.fract() == 0.5 {
        whole_power(x, whole(magnitude)) * x.sqrt()
    } else {
        return other_power(x, y);
    };
    if y < 0.0 { 1.0 / product } else { product }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0..=64")]
fn whole(magnitude: f64) -> u32 {
    magnitude as u32
}

fn other_power(x: f64, y: f64) -> f64 {
    if x > 0.0 {
        exp(y * ln(x))
    } else if x == 0.0 && !y.is_nan() {
        if y > 0.0 { 0.0 } else { f64::INFINITY }
    } else {
        f64::NAN
    }
}

/// x^n by products, from the lowest binary digit of n up: x^13 = (x x^4) x^8; x^0 = 1.
#[must_use]
#[inline]
pub fn whole_power(x: f64, n: u32) -> f64 {
    let (mut product, mut square, mut rest) = (1.0, x, n);
    while rest > 0 {
        if rest & 1 == 1 {
            product *= square;
        }
        rest >>= 1;
        if rest > 0 {
            square *= square;
        }
    }
    product
}

/// Limits `x` to `low..=high`; unlike [`f64::clamp`] it never panics: with `low > high` it gives
/// `high`, and NaN gives `low`. By comparison, since `f64::max` may return either of two zeros.
#[must_use]
#[inline]
pub fn limit(x: f64, low: f64, high: f64) -> f64 {
    let x = if x >= low { x } else { low };
    if x > high { high } else { x }
}

/// Least and largest of `values`; infinities the wrong way round where there are none.
#[must_use]
pub fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}

/// `x` where it is positive, otherwise (also for NaN and -0) exactly +0.
#[must_use]
#[inline]
pub fn positive(x: f64) -> f64 {
    if x > 0.0 { x } else { 0.0 }
}

/// The arc tangent of `x` in radians, within one unit in the last place.
///
/// Cephes' rational approximation (Moshier; `atan.c`) without branches: a network's neurons fall
/// into all of its intervals at random, and `libm`'s branches, mispredicted, cost three times as
/// much. Only the four operations and comparisons, so the bits are the same everywhere.
#[must_use]
#[inline]
pub fn atan(x: f64) -> f64 {
    const TAN_3_PI_8: f64 = 2.414_213_562_373_095;
    let t = x.abs();
    let (large, middle) = (t > TAN_3_PI_8, t > 0.66);
    let (numerator, denominator, offset) = match (large, middle) {
        (true, _) => (-1.0, t, PI / 2.0),
        (_, true) => (t - 1.0, t + 1.0, PI / 4.0),
        _ => (t, 1.0, 0.0),
    };
    let r = numerator / denominator;
    let z = r * r;
    let p = (((-8.750_608_600_031_904e-1 * z - 1.615_753_718_733_365e1) * z
        - 7.500_855_792_314_705e1)
        * z
        - 1.228_866_684_490_136_2e2)
        * z
        - 6.485_021_904_942_025e1;
    let q = ((((z + 2.485_846_490_142_306_3e1) * z + 1.650_270_098_316_988_6e2) * z
        + 4.328_810_604_912_903e2)
        * z
        + 4.853_903_996_359_137e2)
        * z
        + 1.945_506_571_482_614e2;
    (offset + (r + r * (z * p / q))).copysign(x)
}

/// x^(-1/5) for a positive normal `x`, to some 2e-15 of itself, by exact operations alone and
/// in a fraction of the time of `pow`.
#[must_use]
#[inline]
pub fn inverse_fifth_root(x: f64) -> f64 {
    // The exponent divided by -5 through the bits, within 4 %; the constant centres the error.
    let mut root = f64::from_bits(0x4cb8_9800_0000_0000 - x.to_bits() / 5);
    // The series of (1 - e)^(-1/5) with e = 1 - x root^5, twice: e falls from 0.16 to 3e-5 to 0.
    let error = |root: f64| {
        let squared = root * root;
        1.0 - x * (squared * squared * root)
    };
    let e = error(root);
    root += root * (e * (0.2 + e * (0.12 + e * (0.088 + e * 0.0704))));
    let e = error(root);
    root + root * (e * (0.2 + e * 0.12))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arc_tangent_is_within_one_unit_of_the_reference() {
        for i in -40_000..=40_000 {
            let x = f64::from(i) * 1e-4 * (1.0 + f64::from(i).abs() * 1e-3);
            let reference = libm::atan(x);
            assert!((atan(x) - reference).abs() <= 2.3e-16 * reference.abs(), "{x}");
        }
        assert_eq!(atan(f64::INFINITY), PI / 2.0);
        assert_eq!(atan(-0.0).to_bits(), (-0.0_f64).to_bits());
        assert!(atan(f64::NAN).is_nan());
        assert!((atan(-1e-300) + 1e-300).abs() < 1e-315);
    }

    #[test]
    fn powers_are_products_where_people_expect_them_and_exponentials_elsewhere() {
        for x in [-7.3, -1.0, 0.3, 1.7, 12.0] {
            assert_eq!(power(x, 0.0), 1.0);
            assert_eq!(power(x, 1.0), x);
            assert_eq!(power(x, 2.0), x * x);
            assert_eq!(power(x, 3.0), x * (x * x));
            assert_eq!(
                power(x, 13.0),
                x * ((x * x) * (x * x)) * (((x * x) * (x * x)) * ((x * x) * (x * x)))
            );
            assert_eq!(power(x, -2.0), 1.0 / (x * x));
            assert_eq!(power(x, 64.0).to_bits(), whole_power(x, 64).to_bits());
            assert_eq!(power(x, 0.3).is_nan(), x < 0.0);
            assert_eq!(power(x, 65.0).is_nan(), x < 0.0, "no product any more");
        }
        assert_eq!(power(5.0, 0.5), 5.0_f64.sqrt());
        assert_eq!(power(5.0, 2.5), 25.0 * 5.0_f64.sqrt());
        assert_eq!(power(5.0, -1.5), 1.0 / (5.0 * 5.0_f64.sqrt()));
        assert_eq!(power(5.0, 33.5), exp(33.5 * ln(5.0)), "no product any more");
        assert_eq!(power(3.0, 0.245), exp(0.245 * ln(3.0)));
        assert_eq!([power(0.0, 0.3), power(0.0, -0.3)], [0.0, f64::INFINITY]);
        assert_eq!([power(0.0, 2.0), power(0.0, -2.0)], [0.0, f64::INFINITY]);
        assert!(power(-2.0, 0.5).is_nan() && power(0.0, f64::NAN).is_nan());
        for i in 1..2000 {
            let (x, y) = (f64::from(i) * 0.01, f64::from(i % 97) * 0.13 - 6.0);
            let reference = pow(x, y);
            assert!((power(x, y) - reference).abs() <= 1e-14 * reference, "{x}^{y}");
        }
    }

    #[test]
    fn the_inverse_fifth_root_is_exact_to_a_few_bits() {
        for i in -4000..4000 {
            let x = pow(1.07, f64::from(i));
            let root = inverse_fifth_root(x);
            let one = x * root * root * root * root * root;
            assert!((one - 1.0).abs() < 1.5e-14, "{x}: {root}");
        }
    }
}

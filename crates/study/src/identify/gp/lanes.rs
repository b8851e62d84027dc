//! Functions over lanes of rows, without branches, so that the compiler can work at several rows at once.
//!
//! `ln` and `exp` are the polynomials of fdlibm (Sun Microsystems, 1993), as `libm` has them: plain
//! operations in the same order, so that a lane and [`math`] agree bit for bit on every machine. What
//! those do by branches (zero, subnormal numbers, overflow) is left to them, row by row.

use crate::base::math;

/// Rows of a lane: what a program of some 20 nodes needs then stays in the nearest memory.
pub const LANE: usize = 128;

/// One value for each row of a block.
pub type Lane = [f64; LANE];

/// ln x of a positive normal number.
#[inline]
fn ln_normal(x: f64) -> f64 {
    const LN2_HI: f64 = 6.931_471_803_691_238e-1;
    const LN2_LO: f64 = 1.908_214_929_270_587_7e-10;
    let bits = x.to_bits();
    let high = ((bits >> 32) as u32).wrapping_add(0x3ff0_0000 - 0x3fe6_a09e);
    let k = f64::from((high >> 20) as i32 - 0x3ff);
    let high = (high & 0x000f_ffff).wrapping_add(0x3fe6_a09e);
    let f = f64::from_bits((u64::from(high) << 32) | (bits & 0xffff_ffff)) - 1.0;
    let half = 0.5 * f * f;
    let s = f / (2.0 + f);
    let z = s * s;
    let w = z * z;
    let even = w
        * (3.999_999_999_940_942e-1
            + w * (2.222_219_843_214_978_4e-1 + w * 1.531_383_769_920_937_3e-1));
    let odd = z
        * (6.666_666_666_666_735e-1
            + w * (2.857_142_874_366_239e-1
                + w * (1.818_357_216_161_805e-1 + w * 1.479_819_860_511_658_6e-1)));
    let r = odd + even;
    s * (half + r) + k * LN2_LO - half + f + k * LN2_HI
}

/// e^x of a number within 708 of 0.
#[inline]
fn exp_near(x: f64) -> f64 {
    const LN2_HI: f64 = 6.931_471_803_691_238e-1;
    const LN2_LO: f64 = 1.908_214_929_270_587_7e-10;
    let size = (x.to_bits() >> 32) as u32 & 0x7fff_ffff;
    let half = if x < 0.0 { -0.5 } else { 0.5 };
    let unit = if x < 0.0 { -1.0 } else { 1.0 };
    let far = (std::f64::consts::LOG2_E * x + half) as i32;
    let k = if size >= 0x3ff0_a2b2 { f64::from(far) } else { unit };
    let k = if size > 0x3fd6_2e42 { k } else { 0.0 };
    let hi = x - k * LN2_HI;
    let lo = k * LN2_LO;
    let reduced = hi - lo;
    let square = reduced * reduced;
    let c = reduced
        - square
            * (1.666_666_666_666_660_2e-1
                + square
                    * (-2.777_777_777_701_559_3e-3
                        + square
                            * (6.613_756_321_437_934e-5
                                + square
                                    * (-1.653_390_220_546_525_2e-6
                                        + square * 4.138_136_797_057_238_5e-8))));
    let y = 1.0 + (reduced * c / (2.0 - c) - lo + hi);
    // Within these bounds the power of two is a normal number.
    let scale = f64::from_bits(((k as i64 + 1023) as u64) << 52);
    if size > 0x3e30_0000 { y * scale } else { 1.0 + x }
}

/// Whether [`ln_normal`] does.
#[inline]
fn is_normal(x: f64) -> bool {
    (f64::MIN_POSITIVE..=f64::MAX).contains(&x) & (x != 1.0)
}

/// Whether [`exp_near`] does.
#[inline]
fn is_near(x: f64) -> bool {
    x.abs() < 708.0
}

/// `to = ln from`; NaN for negative numbers, as [`math::ln`].
pub fn ln(to: &mut [f64], from: &[f64]) {
    let mut odd = false;
    for (to, x) in to.iter_mut().zip(from) {
        odd |= !is_normal(*x);
        *to = ln_normal(*x);
    }
    if odd {
        for (to, x) in to.iter_mut().zip(from) {
            if !is_normal(*x) {
                *to = math::ln(*x);
            }
        }
    }
}

/// `to = e^from`, as [`math::exp`].
pub fn exp(to: &mut [f64], from: &[f64]) {
    let mut odd = false;
    for (to, x) in to.iter_mut().zip(from) {
        odd |= !is_near(*x);
        *to = exp_near(*x);
    }
    if odd {
        for (to, x) in to.iter_mut().zip(from) {
            if !is_near(*x) {
                *to = math::exp(*x);
            }
        }
    }
}

/// Least and largest whole exponent that is multiplied out.
const WHOLE: f64 = 64.0;

/// `base^whole` by squaring, for a whole number of at most 64.
fn whole_power(to: &mut [f64], base: &[f64], whole: u32, square: &mut [f64]) {
    to.fill(1.0);
    square.copy_from_slice(base);
    let mut left = whole;
    while left > 0 {
        if left & 1 == 1 {
            for (to, square) in to.iter_mut().zip(square.iter()) {
                *to *= square;
            }
        }
        left >>= 1;
        if left > 0 {
            for square in square.iter_mut() {
                *square *= *square;
            }
        }
    }
}

/// `to = from^exponent` for one exponent: whole ones multiplied out, halves with a root, others by
/// logarithm. `spare` is room of the same length.
pub fn power(to: &mut [f64], from: &[f64], exponent: f64, spare: &mut [f64]) {
    let size = exponent.abs();
    let whole = size.floor();
    let half = size - whole == 0.5;
    if size <= WHOLE && size == whole || half && 2.0 * size <= WHOLE {
        whole_power(to, from, whole as u32, spare);
        if half {
            for (to, x) in to.iter_mut().zip(from) {
                *to *= x.sqrt();
            }
        }
        if exponent < 0.0 {
            for to in to.iter_mut() {
                *to = 1.0 / *to;
            }
        }
        return;
    }
    ln(spare, from);
    for log in spare.iter_mut() {
        *log *= exponent;
    }
    exp(to, spare);
    for (to, x) in to.iter_mut().zip(from) {
        if *x == 0.0 {
            *to = if exponent > 0.0 { 0.0 } else { f64::INFINITY };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::rng::Stream;

    #[test]
    fn lanes_agree_with_the_scalar_functions_bit_for_bit() {
        let stream = Stream::new(1, "lanes");
        let odd =
            [0.0, -0.0, 1.0, -1.0, f64::NAN, f64::INFINITY, 1e-310, 709.9, -746.0, -720.0, 1e-9];
        for block in 0..400_u64 {
            let (mut wide, mut narrow) = ([0.0; LANE], [0.0; LANE]);
            for i in 0..LANE {
                let draw = stream.bits(block * 1000 + i as u64);
                wide[i] = f64::from_bits(draw & 0x7fff_ffff_ffff_ffff);
                narrow[i] = (stream.uniform(block * 1000 + 500 + i as u64) - 0.5) * 1400.0
                    / if block % 2 == 0 { 1.0 } else { 700.0 };
            }
            let at = (block % 100) as usize;
            (wide[at], narrow[at]) = (odd[block as usize % 11], odd[block as usize % 11]);
            let mut to = [0.0; LANE];
            ln(&mut to, &wide);
            for (x, y) in wide.iter().zip(&to) {
                let expected = math::ln(*x);
                assert!(
                    y.to_bits() == expected.to_bits() || y.is_nan() && expected.is_nan(),
                    "{x}"
                );
            }
            exp(&mut to, &narrow);
            for (x, y) in narrow.iter().zip(&to) {
                let expected = math::exp(*x);
                assert!(
                    y.to_bits() == expected.to_bits() || y.is_nan() && expected.is_nan(),
                    "{x}"
                );
            }
        }
    }
}

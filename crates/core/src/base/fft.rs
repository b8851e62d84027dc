//! Fast Fourier transform of a power of two, and the convolution by it. The bits are the same on
//! every target: only the four operations and `libm`'s sine and cosine.

use nalgebra::Complex;

use super::math;

/// sum over k of x_k e^{+2 pi i j k/n} for every j, in place: the inverse transform without its 1/n.
/// The length must be a power of two; of another one only the largest power of two within is done.
pub fn synthesise(data: &mut [Complex<f64>]) {
    let n = if data.is_empty() { return } else { 1 << data.len().ilog2() };
    let data = &mut data[..n];
    for i in 0..n {
        let j = i.reverse_bits().checked_shr(usize::BITS - n.ilog2()).unwrap_or(0);
        if i < j {
            data.swap(i, j);
        }
    }
    let turn = |k: usize| {
        let angle = math::TAU * k as f64 / n as f64;
        Complex::new(math::cos(angle), math::sin(angle))
    };
    let turns: Vec<Complex<f64>> = (0..n / 2).map(turn).collect();
    let mut half = 1;
    while half < n {
        let stride = n / (2 * half);
        for block in data.chunks_exact_mut(2 * half) {
            let (low, high) = block.split_at_mut(half);
            for (k, (a, b)) in low.iter_mut().zip(high).enumerate() {
                let turned = *b * turns[k * stride];
                *b = *a - turned;
                *a += turned;
            }
        }
        half *= 2;
    }
}

/// Kernels up to this length are summed directly: faster than two transforms.
const SHORT: usize = 16;

/// The part of the convolution of `signal` with a `kernel` for which the
/// kernel lies wholly on the signal; empty where it does not fit.
#[must_use]
pub fn convolve_valid(signal: &[f64], kernel: &[f64]) -> Vec<f64> {
    if kernel.is_empty() || kernel.len() > signal.len() {
        return Vec::new();
    }
    if kernel.len() <= SHORT {
        let at = |window: &[f64]| window.iter().rev().zip(kernel).map(|(x, w)| x * w).sum();
        return signal.windows(kernel.len()).map(at).collect();
    }
    let n = signal.len().next_power_of_two();
    // Two real series in one complex transform.
    let real = |series: &[f64], i: usize| series.get(i).copied().unwrap_or(0.0);
    let mut both: Vec<Complex<f64>> =
        (0..n).map(|i| Complex::new(real(signal, i), real(kernel, i))).collect();
    synthesise(&mut both);
    let product = |i: usize| {
        let (z, mirrored) = (both[i], both[(n - i) % n].conj());
        let (a, b) = (z + mirrored, z - mirrored);
        // a/2 belongs to the signal, b/(2i) to the kernel; back by the conjugate.
        (a * b * Complex::new(0.0, -0.25)).conj()
    };
    let mut result: Vec<Complex<f64>> = (0..n).map(product).collect();
    synthesise(&mut result);
    (kernel.len() - 1..signal.len()).map(|i| result[i].re / n as f64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::rng::Stream;

    fn noise(n: usize, label: &str) -> Vec<f64> {
        let stream = Stream::new(1, label);
        (0..n).map(|i| stream.normal(i as u64)).collect()
    }

    #[test]
    fn the_transform_is_the_sum_that_it_stands_for() {
        for n in [1_usize, 2, 8, 64] {
            let (re, im) = (noise(n, "re"), noise(n, "im"));
            let mut data: Vec<Complex<f64>> =
                re.iter().zip(&im).map(|(a, b)| Complex::new(*a, *b)).collect();
            let before = data.clone();
            synthesise(&mut data);
            for (j, value) in data.iter().enumerate() {
                let sum: Complex<f64> = (0..n)
                    .map(|k| {
                        let angle = math::TAU * (j * k) as f64 / n as f64;
                        before[k] * Complex::new(math::cos(angle), math::sin(angle))
                    })
                    .sum();
                assert!((sum - value).norm_sqr() < 1e-22, "{n} {j}");
            }
        }
    }

    #[test]
    fn the_convolution_is_the_direct_one() {
        for (n, m) in [(50, 7), (50, 17), (64, 64), (33, 1), (1000, 301)] {
            let (signal, kernel) = (noise(n, "signal"), noise(m, "kernel"));
            let fast = convolve_valid(&signal, &kernel);
            assert_eq!(fast.len(), n - m + 1);
            for (i, value) in fast.iter().enumerate() {
                let direct: f64 = (0..m).map(|k| signal[i + m - 1 - k] * kernel[k]).sum();
                assert!((direct - value).abs() < 1e-11, "{n} {m} {i}");
            }
        }
        assert!(convolve_valid(&[1.0], &[1.0, 1.0]).is_empty());
        assert!(convolve_valid(&[], &[]).is_empty());
    }
}

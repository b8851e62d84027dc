//! Sizes of noise and ripple in a force that was recorded (`steadycut identify noise`), as the loop's own noise has them
//! ([`crate::blocks::cutting::disturbance`]).
//!
//! ```text
//! F(t) = m + d t + a_z sin(2 pi z n t + ..) + a_1 sin(2 pi n t + ..) + rest(t)
//! S(f) = w G_w(f) + b G_b(f) + i G_i(f)            white, band-limited and slow; every G has the area 1
//! ```
//!
//! Mean, drift and the sines of tooth passing and spindle by least squares; the variances w, b, i of the rest from its
//! periodogram by Whittle's likelihood (P. Whittle, Arkiv för Matematik 2, 1953), whose maximum Fisher's scoring finds: least
//! squares weighted by 1/S^2. Its information gives the intervals of 95 %. The shapes are those of the loop, with corners
//! and correlation length as given: where the recorded noise has others, so do the variances mean others.

use nalgebra::{Complex, Matrix3, SMatrix, SVector, Vector3};

use super::EstimatedValue;
use super::estimate::explained;
use crate::base::fft::synthesise;
use crate::base::language::tr;
use crate::base::math;
use crate::base::settings::{SettingError, Value};
use crate::base::stats;
use crate::base::units::rev_s_from_rpm;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;

/// Fewest and most samples.
const SAMPLES: [usize; 2] = [256, 1 << 21];
/// Standard deviations of half a 95 % interval.
const OF_95: f64 = 1.959_963_984_540_054;
/// Steps of the scoring at most, and change of the variances at which it ends.
const STEPS: usize = 100;
const SETTLED: f64 = 1e-9;
/// Places of the material's field in a millimetre.
const CELLS_PER_MM: f64 = 10.0;
/// Lines of the periodogram about a sine that was taken out, and at its beginning, which are not used; in 1/duration.
const TAKEN_OUT: f64 = 1.5;

/// Forces that were recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseRecording {
    /// Distance of two samples, s.
    pub period_s: f64,
    /// Samples in a steady cut, N.
    pub cut_n: Vec<f64>,
    /// Samples with the tool in the air, N, if there are any.
    pub rest_n: Vec<f64>,
}

/// What is known of the cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoisyCut {
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Number of teeth.
    pub teeth: u32,
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Corners of the band-limited noise, Hz.
    pub band_hz: [f64; 2],
    /// Correlation length of the material, mm.
    pub correlation_mm: f64,
}

/// What was identified.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseFit {
    /// Mean force in the cut, N.
    pub mean_n: f64,
    /// Drift in the cut, N/s.
    pub drift_n_s: f64,
    /// Standard deviation of the white noise in the cut, N.
    pub white_n: EstimatedValue,
    /// Standard deviation of the white noise at rest, N, and drift there, N/s; where rest was recorded.
    pub rest: Option<(EstimatedValue, f64)>,
    /// Standard deviation of the band-limited noise in percent of the force.
    pub band_percent: EstimatedValue,
    /// Standard deviation of the slow inhomogeneity in percent of the force.
    pub inhomogeneity_percent: EstimatedValue,
    /// Amplitude at tooth passing in percent of the force; none where the samples are too slow for it.
    pub tooth_percent: Option<EstimatedValue>,
    /// Amplitude at the spindle's turns in percent of the force, which no noise setting has: that of a run-out.
    pub spindle_percent: Option<EstimatedValue>,
    /// Samples in the cut.
    pub samples: usize,
    /// Root mean square of what mean, drift and sines leave, N, and the share of the force's variation that they explain.
    pub rest_n: f64,
    /// See `rest_n`.
    pub r2: f64,
    /// Density of the rest over frequency: Hz, as measured, by the fit; N^2/Hz, each the mean of neighbouring lines.
    pub spectrum: Vec<[f64; 3]>,
}

/// Mean, slope and sines of given frequencies in Hz, and the rest.
struct Lines {
    mean: f64,
    slope_s: f64,
    amplitudes: Vec<f64>,
    rest: Vec<f64>,
}

fn lines(samples: &[f64], period_s: f64, frequencies_hz: &[f64]) -> Option<Lines> {
    let middle_s = 0.5 * (samples.len() - 1) as f64 * period_s;
    let half_s = middle_s.max(period_s);
    // Mean, slope, and at most two sines.
    let row = |i: usize| {
        let time_s = i as f64 * period_s;
        let mut row = SVector::<f64, 6>::zeros();
        (row[0], row[1]) = (1.0, (time_s - middle_s) / half_s);
        for (k, frequency_hz) in frequencies_hz.iter().take(2).enumerate() {
            let angle = math::TAU * frequency_hz * time_s;
            (row[2 + 2 * k], row[3 + 2 * k]) = (math::sin(angle), math::cos(angle));
        }
        row
    };
    let used = 2 + 2 * frequencies_hz.len().min(2);
    let (mut normal, mut right) = (SMatrix::<f64, 6, 6>::zeros(), SVector::<f64, 6>::zeros());
    for (i, sample) in samples.iter().enumerate() {
        let row = row(i);
        normal += row * row.transpose();
        right += row * *sample;
    }
    for k in used..6 {
        normal[(k, k)] = 1.0;
    }
    let x = normal.cholesky()?.solve(&right);
    let amplitude = |k: usize| {
        let (s, c) = (x[2 + 2 * k], x[3 + 2 * k]);
        (s * s + c * c).sqrt()
    };
    Some(Lines {
        mean: x[0],
        slope_s: x[1] / half_s,
        amplitudes: (0..frequencies_hz.len().min(2)).map(amplitude).collect(),
        rest: samples.iter().enumerate().map(|(i, sample)| sample - x.dot(&row(i))).collect(),
    })
}

/// Shapes of the three spectra at a frequency in Hz of samples `period_s` apart, not yet of area 1.
fn shapes(cut: &NoisyCut, frequency_hz: f64, period_s: f64) -> [f64; 3] {
    let turned = |by: f64| Complex::new(math::cos(by), -math::sin(by));
    let z = turned(math::TAU * frequency_hz * period_s);
    let [low_hz, high_hz] = cut.band_hz;
    let pole = |corner_hz: f64| math::exp(-math::TAU * corner_hz * period_s);
    // 1/(1 - p z^-1), and what is left of it behind its own low pass: q (1 - z^-1)/(1 - q z^-1).
    let one = Complex::new(1.0, 0.0);
    let (p, q) = (pole(high_hz), pole(low_hz));
    let band = (one - z).norm_sqr() / ((one - z * p).norm_sqr() * (one - z * q).norm_sqr());
    // The field goes on linearly between its cells.
    let cell_s = 60.0 / (CELLS_PER_MM * cut.feed_mm_min);
    let decay = math::exp(-1.0 / (CELLS_PER_MM * cut.correlation_mm));
    let angle = math::TAU * frequency_hz * cell_s;
    let half = 0.5 * angle;
    let sinc = if half == 0.0 { 1.0 } else { math::sin(half) / half };
    let slow = sinc * sinc * sinc * sinc / (one - turned(angle) * decay).norm_sqr();
    [1.0, band, slow]
}

/// Most places of the spectrum that is told.
const TOLD: usize = 160;

/// Variances of the three, and the inverse of their information.
struct Variances {
    values: Vector3<f64>,
    covariance: Matrix3<f64>,
    /// Areas of the shapes, Hz.
    areas: [f64; 3],
    /// See [`NoiseFit::spectrum`].
    spectrum: Vec<[f64; 3]>,
}

impl Variances {
    /// Density of the rest at a frequency with these shapes, N^2 s.
    fn density(&self, shapes: &[f64; 3]) -> f64 {
        (0..3).map(|k| self.values[k] * shapes[k] / self.areas[k]).sum()
    }
}

/// The variances of a rest by Whittle's likelihood; lines about the frequencies in Hz are not used.
fn variances(rest: &[f64], period_s: f64, cut: &NoisyCut, without_hz: &[f64]) -> Option<Variances> {
    let count = rest.len().next_power_of_two();
    let mut data: Vec<Complex<f64>> =
        (0..count).map(|i| Complex::new(rest.get(i).copied().unwrap_or(0.0), 0.0)).collect();
    synthesise(&mut data);
    let step_hz = 1.0 / (count as f64 * period_s);
    let last = count / 2;
    let all: Vec<[f64; 3]> =
        (0..=last).map(|j| shapes(cut, j as f64 * step_hz, period_s)).collect();
    // Area 1 over frequencies of both signs.
    let area = |k: usize| {
        let inner: f64 = all[1..last].iter().map(|g| g[k]).sum();
        step_hz * (all[0][k] + 2.0 * inner + all[last][k])
    };
    let areas = [area(0), area(1), area(2)];
    let duration_s = rest.len() as f64 * period_s;
    let used = |j: &usize| {
        let frequency_hz = *j as f64 * step_hz;
        let far = |line_hz: &f64| (frequency_hz - line_hz).abs() > TAKEN_OUT / duration_s;
        frequency_hz > TAKEN_OUT / duration_s && without_hz.iter().all(far)
    };
    let places: Vec<usize> = (1..last).filter(used).collect();
    let shape = |j: usize| Vector3::from_fn(|k, _| all[j][k] / areas[k]);
    let power = |j: usize| data[j].norm_sqr() * period_s / rest.len() as f64;
    let mean_square = rest.iter().map(|x| x * x).sum::<f64>() / rest.len() as f64;
    let largest = rest.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest < 1e-9 || places.is_empty() {
        return None;
    }
    let floor = 1e-12 * mean_square;
    let mut values = Vector3::repeat(mean_square / 3.0);
    // As many ordinates are independent as there are samples.
    let share = rest.len() as f64 / count as f64;
    let mut information = Matrix3::zeros();
    for _ in 0..STEPS {
        let mut right = Vector3::zeros();
        information = Matrix3::zeros();
        for j in &places {
            let g = shape(*j);
            let density = g.dot(&values);
            let weight = share / (density * density);
            information += g * g.transpose() * weight;
            right += g * (weight * power(*j));
        }
        let before = values;
        values = not_negative(&information, &right, floor)?;
        if (values - before).amax() <= SETTLED * mean_square {
            break;
        }
    }
    let told = |group: &[usize]| {
        let mean = |of: &dyn Fn(usize) -> f64| {
            group.iter().map(|j| of(*j)).sum::<f64>() / group.len() as f64
        };
        // Both signs of the frequency together.
        [mean(&|j| j as f64 * step_hz), 2.0 * mean(&power), 2.0 * mean(&|j| shape(j).dot(&values))]
    };
    let spectrum = places.chunks(places.len().div_ceil(TOLD)).map(told).collect();
    Some(Variances { values, covariance: information.try_inverse()?, areas, spectrum })
}

/// The solution of the normal equations none of whose parts is below `floor`: what would be is held there.
fn not_negative(normal: &Matrix3<f64>, right: &Vector3<f64>, floor: f64) -> Option<Vector3<f64>> {
    let mut held = [false; 3];
    for _ in 0..3 {
        let (mut n, mut r) = (*normal, *right);
        for k in (0..3).filter(|k| held[*k]) {
            for l in 0..3 {
                r[l] -= normal[(l, k)] * floor;
                (n[(k, l)], n[(l, k)]) = (0.0, 0.0);
            }
        }
        for k in (0..3).filter(|k| held[*k]) {
            (n[(k, k)], r[k]) = (1.0, floor);
        }
        let x = n.cholesky()?.solve(&r);
        let Some(below) = (0..3).find(|k| x[*k] < floor) else { return Some(x) };
        held[below] = true;
    }
    Some(Vector3::repeat(floor))
}

fn checked(samples: &[f64], what: &str) -> Result<(), String> {
    let [least, most] = SAMPLES;
    if !(least..=most).contains(&samples.len()) {
        return Err(tr!(
            "{what}: {count} samples: allowed are {least} to {most}",
            what = what,
            count = samples.len(),
            least = least,
            most = most
        ));
    }
    match samples.iter().position(|x| !x.is_finite()) {
        Some(i) => Err(tr!("{what}: sample {sample} is no number", what = what, sample = i + 1)),
        None => Ok(()),
    }
}

/// A standard deviation over `size`, from a variance with that of its estimate.
fn deviation(variance: f64, of_estimate: f64, size: f64) -> EstimatedValue {
    let root = variance.max(0.0).sqrt();
    let half = OF_95 * of_estimate.max(0.0).sqrt() / (2.0 * root);
    EstimatedValue { value: root * size, half: half.is_finite().then_some(half * size) }
}

/// Sizes of noise and ripple in a recording.
///
/// # Errors
/// Too few samples or some that are no numbers; no force in the cut; a speed, feed, corner or length that is not above 0.
pub fn identify_noise(recording: &NoiseRecording, cut: &NoisyCut) -> Result<NoiseFit, String> {
    let NoiseRecording { period_s, cut_n, rest_n } = recording;
    checked(cut_n, tr("the cut"))?;
    let positive = [
        *period_s,
        cut.speed_rpm,
        cut.feed_mm_min,
        cut.band_hz[0],
        cut.band_hz[1],
        cut.correlation_mm,
    ];
    if positive.iter().any(|x| !(*x > 0.0 && x.is_finite())) || cut.teeth == 0 {
        return Err(tr(
            "expected are a period, speed, feed, corners of the band and a correlation length above 0, and a tooth",
        )
        .to_owned());
    }
    let spindle_hz = rev_s_from_rpm(cut.speed_rpm);
    let teeth_hz = f64::from(cut.teeth) * spindle_hz;
    let most_hz = 0.5 / period_s;
    // Of one tooth both are the same.
    let frequencies: Vec<f64> = [teeth_hz, spindle_hz]
        .into_iter()
        .filter(|hz| *hz < 0.95 * most_hz)
        .take(if cut.teeth == 1 { 1 } else { 2 })
        .collect();
    let no_fit = || tr("the force does not vary: nothing is told of its noise").to_owned();
    let found = lines(cut_n, *period_s, &frequencies).ok_or_else(no_fit)?;
    if found.mean <= 0.0 {
        return Err(tr!(
            "the mean force is {mean:.2} N: expected is a cut, with a force above 0",
            mean = found.mean
        ));
    }
    let noise = variances(&found.rest, *period_s, cut, &frequencies).ok_or_else(no_fit)?;
    let percent = 100.0 / found.mean;
    let variance = |k: usize, size: f64| deviation(noise.values[k], noise.covariance[(k, k)], size);
    let duration_s = cut_n.len() as f64 * period_s;
    let line = |frequency_hz: f64| {
        let place = frequencies.iter().position(|hz| *hz == frequency_hz)?;
        let density = noise.density(&shapes(cut, frequency_hz, *period_s));
        let half = OF_95 * (2.0 * density / duration_s).sqrt();
        Some(EstimatedValue {
            value: percent * found.amplitudes[place],
            half: Some(percent * half),
        })
    };
    let rest = if rest_n.is_empty() {
        None
    } else {
        checked(rest_n, tr("at rest"))?;
        let still = lines(rest_n, *period_s, &[]).ok_or_else(no_fit)?;
        let freedom = (rest_n.len() - 2) as f64;
        let variance = still.rest.iter().map(|x| x * x).sum::<f64>() / freedom;
        Some((deviation(variance, 2.0 * variance * variance / freedom, 1.0), still.slope_s))
    };
    Ok(NoiseFit {
        mean_n: found.mean,
        drift_n_s: found.slope_s,
        white_n: variance(0, 1.0),
        rest,
        band_percent: variance(1, percent),
        inhomogeneity_percent: variance(2, percent),
        tooth_percent: line(teeth_hz),
        spindle_percent: if cut.teeth == 1 { None } else { line(spindle_hz) },
        samples: cut_n.len(),
        rest_n: stats::rms(found.rest.iter().copied()).unwrap_or(0.0),
        r2: explained(cut_n, &found.rest),
        spectrum: noise.spectrum,
    })
}

/// A scenario with the sizes that were found: the settings, and the text of its file.
///
/// # Errors
/// A size that the program does not take.
pub fn noisy_scenario(
    scenario: &Scenario,
    edits: &Edits,
    fit: &NoiseFit,
    source: &str,
) -> Result<(Vec<(String, Value)>, String), SettingError> {
    let float = |path: &str, value: f64| (path.to_owned(), Value::Float(value));
    let sensor = fit.rest.map_or(fit.white_n, |(white, _)| white);
    let mut changes = vec![
        float("noise.level", 1.0),
        float("noise.sensor_n", sensor.value),
        float("noise.band_percent", fit.band_percent.value),
        float("noise.inhomogeneity_percent", fit.inhomogeneity_percent.value),
    ];
    if let Some(ripple) = fit.tooth_percent {
        changes.push(float("noise.ripple_percent", ripple.value));
    }
    let mut noisy = scenario.clone();
    noisy.set_all(&changes)?;
    let told = |x: EstimatedValue| {
        let half = x.half.map_or("not told".to_owned(), |half| format!("+- {half:.3}"));
        format!("{:.3} {half}", x.value)
    };
    let ripple = fit.tooth_percent.map_or("not seen".to_owned(), told);
    let mut text = format!(
        "# Noise identified by `steadycut identify noise`: {source}.\n\
         # {} samples about {:.2} N; +- is half a 95 % interval.\n\
         # sensor {} N; band {} %; inhomogeneity {} %; ripple of the teeth {ripple} %\n",
        fit.samples,
        fit.mean_n,
        told(sensor),
        told(fit.band_percent),
        told(fit.inhomogeneity_percent),
    );
    text.push_str(&scenario_file::write(&noisy, edits));
    Ok((changes, text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::rng::Stream;
    use crate::blocks::cutting::disturbance::{DynamicForce, NoiseSettings};

    const CUT: NoisyCut = NoisyCut {
        speed_rpm: 1592.0,
        teeth: 2,
        feed_mm_min: 300.0,
        band_hz: [2.0, 40.0],
        correlation_mm: 3.0,
    };

    fn settings() -> NoiseSettings {
        NoiseSettings {
            level: 1.0,
            band_percent: 3.0,
            ripple_percent: 1.5,
            inhomogeneity_percent: 2.5,
            sensor_n: 4.0,
            ..NoiseSettings::default()
        }
    }

    /// Sixty seconds of 180 N at 1 kHz with the loop's own noise, and four at rest.
    fn recorded(settings: &NoiseSettings, seed: u32) -> NoiseRecording {
        let mut dynamic = DynamicForce::new(settings, CUT.teeth, seed, 1e-3);
        let sensor = Stream::new(u64::from(seed), "sensor");
        let cut_n = (0..60_000_u64).map(|tick| {
            let position_mm = CUT.feed_mm_min / 60.0 * tick as f64 * 1e-3;
            let factor = dynamic.update(tick, position_mm, CUT.speed_rpm);
            180.0 * factor + settings.sensor_n * sensor.normal(tick)
        });
        let at_rest = |tick: u64| {
            2.0 + 1e-4 * tick as f64 + settings.sensor_n * sensor.normal(1_000_000 + tick)
        };
        NoiseRecording {
            period_s: 1e-3,
            cut_n: cut_n.collect(),
            rest_n: (0..4000).map(at_rest).collect(),
        }
    }

    #[test]
    fn the_loop_s_own_noise_comes_back_in_its_parts() {
        let seeds = 12;
        let mut sums = [0.0; 3];
        let mut held = 0;
        for seed in 1..=seeds {
            let fit = identify_noise(&recorded(&settings(), seed), &CUT).unwrap();
            let told = format!("{fit:?}");
            assert!((fit.mean_n / 180.0 - 1.0).abs() < 0.02, "{told}");
            assert!((fit.white_n.value / 4.0 - 1.0).abs() < 0.03, "{told}");
            let (rest, drift_n_s) = fit.rest.unwrap();
            assert!(
                (rest.value / 4.0 - 1.0).abs() < 0.05 && (drift_n_s - 0.1).abs() < 0.25,
                "{told}"
            );
            let ripple = fit.tooth_percent.unwrap();
            assert!((ripple.value / 1.5 - 1.0).abs() < 0.1, "{told}");
            let parts =
                [(fit.white_n, 4.0), (fit.band_percent, 3.0), (fit.inhomogeneity_percent, 2.5)];
            for (sum, (x, known)) in sums.iter_mut().zip(parts) {
                *sum += x.value / known / f64::from(seeds);
                held += u32::from((x.value - known).abs() <= x.half.unwrap());
            }
        }
        for (mean, most) in sums.iter().zip([0.005, 0.03, 0.12]) {
            assert!((mean - 1.0).abs() < most, "{sums:?}");
        }
        assert!(held >= 30, "{held} of 36 intervals hold the truth");
    }

    #[test]
    fn what_is_not_there_is_found_to_be_small() {
        let only = NoiseSettings {
            band_percent: 0.0,
            ripple_percent: 0.0,
            inhomogeneity_percent: 0.0,
            ..settings()
        };
        let fit = identify_noise(&recorded(&only, 1), &CUT).unwrap();
        assert!((fit.white_n.value / 4.0 - 1.0).abs() < 0.03, "{fit:?}");
        assert!(fit.band_percent.value < 0.2 && fit.inhomogeneity_percent.value < 0.2, "{fit:?}");
        assert!(fit.tooth_percent.unwrap().value < 0.05, "{fit:?}");
    }

    #[test]
    fn the_scenario_has_the_sizes_that_were_found() {
        let fit = identify_noise(&recorded(&settings(), 1), &CUT).unwrap();
        let (changes, text) =
            noisy_scenario(&Scenario::default(), &Edits::none(), &fit, "from a test").unwrap();
        let (read, _) = scenario_file::parse(&text).unwrap();
        assert_eq!(read.noise.band_percent, fit.band_percent.value);
        assert_eq!(read.noise.sensor_n, fit.rest.unwrap().0.value);
        assert_eq!(changes.len(), 5);
    }

    #[test]
    fn recordings_that_tell_nothing_are_refused() {
        let sound = recorded(&settings(), 1);
        let with = |cut_n: Vec<f64>| NoiseRecording { cut_n, ..sound.clone() };
        let mut holed = sound.cut_n.clone();
        holed[3] = f64::INFINITY;
        for (recording, part) in [
            (with(sound.cut_n[..255].to_vec()), "the cut: 255 samples: allowed are 256"),
            (with(holed), "the cut: sample 4 is no number"),
            (with(sound.cut_n.iter().map(|x| x - 200.0).collect()), "expected is a cut"),
            (with(vec![1.0; 512]), "does not vary"),
            (NoiseRecording { rest_n: vec![0.0; 9], ..sound.clone() }, "at rest: 9 samples"),
            (NoiseRecording { period_s: 0.0, ..sound.clone() }, "above 0"),
        ] {
            let error = identify_noise(&recording, &CUT).unwrap_err();
            assert!(error.contains(part), "{part}: {error}");
        }
    }
}

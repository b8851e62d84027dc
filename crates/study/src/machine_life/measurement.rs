//! A virtual measurement of the sound: the model's trend and spectrum with noise. The paper's figures
//! R = 0.993 and 0.684 are settings of that noise, not a validation: no measurement is published.

use serde::Serialize;

use crate::base::rng::Stream;
use crate::base::stats::{self, correlation};
use crate::models::machine_trend::{LifeSettings, TrendLine, TrendPoint};

/// A measured life.
#[derive(Clone, Debug, Serialize)]
pub struct MeasuredTrend {
    /// The trend, in the unit of the calculated one.
    pub trend: Vec<f64>,
    /// Its correlation with the calculated trend.
    pub trend_r: Option<f64>,
    /// The spectrum of the sharp tool.
    pub spectrum: Vec<f64>,
    /// Its correlation with the calculated spectrum.
    pub spectrum_r: Option<f64>,
}

/// Measures a life second by second: white noise on the trend in percent of the sharp tool's sound,
/// and on the lines of its spectrum as fractions of their deviation.
#[must_use]
pub fn measure(
    points: &[TrendPoint],
    spectrum: &[TrendLine],
    settings: &LifeSettings,
    seed: u64,
) -> MeasuredTrend {
    let noisy = |calculated: &[f64], deviation: f64, label: &str| -> Vec<f64> {
        let stream = Stream::new(seed, label);
        let draw = |(i, value): (usize, &f64)| value + deviation * stream.normal(i as u64);
        calculated.iter().enumerate().map(draw).collect()
    };
    let calculated: Vec<f64> = points.iter().map(|point| point.sound).collect();
    let first = calculated.first().copied().unwrap_or(0.0);
    let trend = noisy(&calculated, settings.white_percent / 100.0 * first, "life.trend");
    let lines: Vec<f64> = spectrum.iter().map(|line| line.sound).collect();
    let mean = stats::mean(lines.iter().copied()).unwrap_or(0.0);
    let about_mean = stats::rms(lines.iter().map(|x| x - mean)).unwrap_or(0.0);
    let measured = noisy(&lines, settings.spectrum_ratio * about_mean, "life.spectrum");
    MeasuredTrend {
        trend_r: correlation(&calculated, &trend),
        spectrum_r: correlation(&lines, &measured),
        trend,
        spectrum: measured,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine_life::{LifeJob, model};
    use crate::run::job::Job;
    use crate::run::scenario::Scenario;

    #[test]
    fn the_default_noise_gives_the_papers_figures_in_the_mean() {
        let scenario = Scenario::default();
        let mut job = LifeJob::new(model(&scenario), 10.0);
        job.to_end();
        let spectrum: Vec<TrendLine> = job.model().spectrum(0.0).collect();
        let seeds = 40;
        let mut sums = [0.0; 2];
        for seed in 0..seeds {
            let measured = measure(job.points(), &spectrum, &scenario.life, seed);
            sums[0] += measured.trend_r.unwrap() / seeds as f64;
            sums[1] += measured.spectrum_r.unwrap() / seeds as f64;
        }
        assert!((sums[0] - 0.993).abs() < 5e-4, "{sums:?}");
        assert!((sums[1] - 0.684).abs() < 0.015, "{sums:?}");
    }

    #[test]
    fn without_noise_the_measurement_is_the_calculation() {
        let mut scenario = Scenario::default();
        scenario.change(|s| (s.life.white_percent, s.life.spectrum_ratio) = (0.0, 0.0)).unwrap();
        let mut job = LifeJob::new(model(&scenario), 0.2);
        job.to_end();
        let spectrum: Vec<TrendLine> = job.model().spectrum(0.0).collect();
        let measured = measure(job.points(), &spectrum, &scenario.life, 1);
        assert!(
            measured.trend_r.unwrap() > 1.0 - 1e-12 && measured.trend[0] == job.points()[0].sound
        );
        assert!(measured.spectrum_r.unwrap() > 1.0 - 1e-12);
    }
}

//! What a controller sees of a channel: its values or its peaks at the ends of control periods.

use super::low_pass::low_passed;
use super::{even, fault, filled};
use crate::base::language::tr;
use crate::channel::{MeasuredChannel, SampleTimes};
use crate::fault::DataFault;

/// Room for the rounding of times, in periods.
const HAIR: f64 = 1e-9;
/// Cut-off before samples are thinned, in new sample rates: what is above half of one would come back as something else.
const BEFORE_THINNING: f64 = 0.4;
/// Most samples of a channel that is made.
const MAX_SAMPLES: f64 = 1e8;

fn period_of(channel: &MeasuredChannel, period_s: f64) -> Result<f64, DataFault> {
    let sound = period_s > 0.0 && period_s.is_finite();
    sound.then_some(period_s).ok_or_else(|| {
        fault(channel, tr!("a period of {period} s", period = period_s), tr("above 0"))
    })
}

/// The channel with one sample in every period, in s, from its first time on: on the line between two samples. Where that
/// thins even samples, they are low-passed before, at 0.4 of the new rate.
///
/// # Errors
/// Its times are not known, or do not go on.
pub fn resampled(channel: &MeasuredChannel, period_s: f64) -> Result<MeasuredChannel, DataFault> {
    let period_s = period_of(channel, period_s)?;
    let values = match channel.times.rate_hz() {
        Some(rate_hz) if rate_hz * period_s > 1.0 + HAIR => {
            low_passed(channel, BEFORE_THINNING / period_s)?
        }
        Some(_) | None => filled(channel)?.0,
    };
    let times: Option<Vec<f64>> = (0..values.len()).map(|i| channel.times.at(i)).collect();
    let times =
        times.filter(|times| times.windows(2).all(|pair| pair[0] <= pair[1])).ok_or_else(|| {
            let found = tr("times that are not known, or do not go on").to_owned();
            fault(channel, found, tr("a sample rate: rate_hz in the layout"))
        })?;
    let (first_s, last_s) = (times[0], times[times.len() - 1]);
    let count = ((last_s - first_s) / period_s + HAIR).floor();
    if count > MAX_SAMPLES {
        let found = tr!("{count} samples", count = count);
        return Err(fault(channel, found, tr!("at most {most}", most = MAX_SAMPLES)));
    }
    let mut at = 0;
    let value = |k: usize| {
        let time_s = first_s + k as f64 * period_s;
        while at + 2 < times.len() && times[at + 1] <= time_s {
            at += 1;
        }
        let next = (at + 1).min(times.len() - 1);
        let span_s = times[next] - times[at];
        let share =
            if span_s > 0.0 { ((time_s - times[at]) / span_s).clamp(0.0, 1.0) } else { 0.0 };
        values[at] + share * (values[next] - values[at])
    };
    let values = (0..=count as usize).map(value).collect();
    let times = SampleTimes::Even { rate_hz: 1.0 / period_s, first_s };
    Ok(MeasuredChannel { name: channel.name.clone(), unit: channel.unit.clone(), times, values })
}

/// The largest force across the tool in every whole period, at its end, as the simulator's `PeakWindow` gives it to a
/// controller:
/// max sqrt(x^2 + y^2) over the samples of the period.
///
/// # Errors
/// The two do not have the same even times.
pub fn peaks(
    x: &MeasuredChannel,
    y: &MeasuredChannel,
    period_s: f64,
) -> Result<MeasuredChannel, DataFault> {
    let period_s = period_of(x, period_s)?;
    let (rate_hz, first_s) = even(x)?;
    if x.times != y.times || x.values.len() != y.values.len() {
        let found = tr!("other times than those of `{name}`", name = x.name);
        return Err(fault(y, found, tr("the same")));
    }
    let count = x.values.len() as f64 / (rate_hz * period_s);
    if count > MAX_SAMPLES {
        let found = tr!("{count} samples", count = count);
        return Err(fault(x, found, tr!("at most {most}", most = MAX_SAMPLES)));
    }
    let (x_values, _) = filled(x)?;
    let (y_values, _) = filled(y)?;
    let mut peaks: Vec<f64> = Vec::new();
    let mut running: Option<(usize, f64)> = None;
    for (i, (x, y)) in x_values.iter().zip(&y_values).enumerate() {
        let period = (i as f64 / (rate_hz * period_s) + HAIR) as usize;
        let force = (x * x + y * y).sqrt();
        running = match running {
            Some((of, largest)) if of == period => Some((of, largest.max(force))),
            Some((_, largest)) => {
                // A period without a sample of its own holds what it was.
                peaks.resize(period, largest);
                Some((period, force))
            }
            None => Some((period, force)),
        };
    }
    // The last period counts where its samples reach its end.
    let whole = ((x_values.len() as f64) / (rate_hz * period_s) + HAIR) as usize;
    if let Some((_, largest)) = running {
        peaks.resize(whole, largest);
    }
    let name = format!("peak of {} and {}", x.name, y.name);
    let times = SampleTimes::Even { rate_hz: 1.0 / period_s, first_s: first_s + period_s };
    Ok(MeasuredChannel { name, unit: x.unit.clone(), times, values: peaks })
}

#[cfg(test)]
mod tests {
    use super::super::tests::channel;
    use super::*;
    use crate::base::math;

    #[test]
    fn a_line_stays_a_line_at_any_period_and_fast_waves_do_not_come_back_slow() {
        let line = channel("F", 1000.0, (0..1001).map(|i| 3.0 + 0.5 * f64::from(i)).collect());
        for period_s in [0.02, 0.003, 0.0004] {
            let found = resampled(&line, period_s).unwrap();
            for (k, x) in found.values.iter().enumerate() {
                let known = 3.0 + 500.0 * k as f64 * period_s;
                assert!((x - known).abs() < 1e-6, "{period_s} {k}: {x} {known}");
            }
            assert_eq!(found.values.len(), (1.0 / period_s + 1e-9) as usize + 1);
        }
        // 49 Hz in samples of 20 ms would look like 1 Hz; the filter of 20 Hz leaves a sixteenth of it.
        let wave = (0..4000).map(|i| math::sin(math::TAU * 49.0 * f64::from(i) / 1000.0)).collect();
        let found = resampled(&channel("F", 1000.0, wave), 0.02).unwrap();
        let largest = found.values[5..195].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(largest < 1.0 / 16.0, "{largest}");
        let uneven = MeasuredChannel {
            times: SampleTimes::Given([0.0, 1.0, 4.0].into()),
            ..channel("F", 1.0, vec![0.0, 10.0, 40.0])
        };
        assert_eq!(resampled(&uneven, 0.5).unwrap().values[6], 30.0);
        let error = peaks(&line, &line, 1e-12).unwrap_err().to_string();
        assert!(error.contains("at most"), "{error}");
        let error = resampled(&line, 0.0).unwrap_err().to_string();
        assert!(error.contains("a period of 0 s"), "{error}");
    }
}

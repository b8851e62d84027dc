//! Zero and drift: what a channel shows while nothing is measured, before the cut and after it.

use super::fault;
use crate::base::language::tr;
use crate::channel::MeasuredChannel;
use crate::fault::DataFault;

/// Mean time in s and mean value of a channel between two times in s.
///
/// # Errors
/// No sample lies there.
fn mean_of(channel: &MeasuredChannel, [from_s, to_s]: [f64; 2]) -> Result<[f64; 2], DataFault> {
    let samples =
        channel.values.iter().enumerate().filter_map(|(i, x)| Some((channel.times.at(i)?, *x)));
    let within = samples.filter(|(time_s, x)| (from_s..=to_s).contains(time_s) && !x.is_nan());
    let (mut count, mut time, mut value) = (0.0, 0.0, 0.0);
    for (time_s, x) in within {
        (count, time, value) = (count + 1.0, time + time_s, value + x);
    }
    if count == 0.0 {
        let found = tr!("no sample from {from} to {to} s", from = from_s, to = to_s);
        let ends = [channel.times.at(0), channel.times.at(channel.values.len().saturating_sub(1))];
        let expected = match ends {
            [Some(first), Some(last)] => {
                tr!("times from {from} to {to} s", from = first, to = last)
            }
            [None, _] | [_, None] => tr("a sample rate: rate_hz in the layout").to_owned(),
        };
        return Err(fault(channel, found, expected));
    }
    Ok([time / count, value / count])
}

/// The samples without what the channel shows on average in `idle`, between two times in s; with a second such time,
/// without the line through both.
///
/// # Errors
/// No sample lies there, or both are at the same time.
pub fn corrected(
    channel: &MeasuredChannel,
    idle: [f64; 2],
    later: Option<[f64; 2]>,
) -> Result<Vec<f64>, DataFault> {
    let [time_s, zero] = mean_of(channel, idle)?;
    let slope = match later {
        None => 0.0,
        Some(later) => {
            let [later_s, value] = mean_of(channel, later)?;
            if later_s == time_s {
                let found = tr!("twice the time {time} s", time = time_s);
                return Err(fault(channel, found, tr("two times apart")));
            }
            (value - zero) / (later_s - time_s)
        }
    };
    let at = |i: usize| channel.times.at(i).map_or(0.0, |time| slope * (time - time_s));
    Ok(channel.values.iter().enumerate().map(|(i, x)| x - zero - at(i)).collect())
}

#[cfg(test)]
mod tests {
    use super::super::tests::channel;
    use super::*;

    #[test]
    fn a_line_through_two_idle_times_is_taken_off() {
        // 5 N of zero and 2 N/s of drift; a cut of 100 N from 3 s to 6 s.
        let cut = |i: usize| if (30..60).contains(&i) { 100.0 } else { 0.0 };
        let values = (0..100).map(|i| 5.0 + 0.2 * i as f64 + cut(i)).collect();
        let force = channel("Fx", 10.0, values);
        let straight = corrected(&force, [0.0, 2.0], Some([7.0, 9.0])).unwrap();
        for (i, x) in straight.iter().enumerate() {
            assert!((x - cut(i)).abs() < 1e-9, "{i}: {x}");
        }
        let zeroed = corrected(&force, [0.0, 0.0], None).unwrap();
        assert_eq!((zeroed[0], zeroed[10]), (0.0, 2.0));
        let error = corrected(&force, [20.0, 30.0], None).unwrap_err().to_string();
        assert!(
            error.contains("`Fx`: no sample from 20 to 30 s") && error.contains("from 0 to 9.9 s"),
            "{error}"
        );
        let error = corrected(&force, [0.0, 1.0], Some([0.0, 1.0])).unwrap_err().to_string();
        assert!(error.contains("two times apart"), "{error}");
    }
}

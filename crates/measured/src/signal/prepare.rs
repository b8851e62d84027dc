//! The steps in their order: zero and drift, axes, filter, peaks, periods.

use super::drift::corrected;
use super::low_pass::low_passed;
use super::periods::{peaks, resampled};
use super::rotate::rotated;
use crate::base::language::tr;
use crate::channel::MeasuredChannel;
use crate::fault::{DataFault, shown};

/// What is done with the channels of a measurement; nothing by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Preparation {
    /// Times in s between which nothing is measured: all channels are made zero there.
    pub idle_s: Option<[f64; 2]>,
    /// A second such time behind the cut: the line through both is taken off.
    pub idle_later_s: Option<[f64; 2]>,
    /// Two forces across the spindle's axis by their names, and the angle in degrees by which their axes are turned.
    pub rotation: Option<(String, String, f64)>,
    /// Cut-off of the low-pass filter of all channels, Hz.
    pub low_pass_hz: Option<f64>,
    /// Two forces across the spindle's axis by their names, whose peak in every period becomes a channel in the place
    /// of all.
    pub peaks: Option<(String, String)>,
    /// One value in so many s.
    pub period_s: Option<f64>,
}

impl Preparation {
    /// Whether it leaves all as it is.
    #[must_use]
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// The channels as they are after it.
    ///
    /// # Errors
    /// A channel is not there, has no sample rate where it needs one, or no sample where it is to be zero; a value that is
    /// not allowed; peaks without a period.
    pub fn of(&self, channels: &[MeasuredChannel]) -> Result<Vec<MeasuredChannel>, DataFault> {
        let mut channels = channels.to_vec();
        match (self.idle_s, self.idle_later_s) {
            (Some(idle), later) => {
                for channel in &mut channels {
                    channel.values = corrected(channel, idle, later)?;
                }
            }
            (None, Some(_)) => {
                let found = tr("drift without a time before the cut");
                return Err(DataFault::of_file(found, tr("two times")));
            }
            (None, None) => {}
        }
        if let Some((x, y, angle_deg)) = &self.rotation {
            let [x, y] = [place(&channels, x)?, place(&channels, y)?];
            if channels[x].values.len() != channels[y].values.len() || !angle_deg.is_finite() {
                let found = tr!("`{x}` and `{y}`", x = channels[x].name, y = channels[y].name);
                return Err(DataFault::of_file(
                    found,
                    tr("two forces of one length, and an angle"),
                ));
            }
            let turned = rotated(&channels[x].values, &channels[y].values, *angle_deg);
            (channels[x].values, channels[y].values) = turned;
        }
        if let Some(cut_off_hz) = self.low_pass_hz {
            for channel in &mut channels {
                channel.values = low_passed(channel, cut_off_hz)?;
            }
        }
        match (&self.peaks, self.period_s) {
            (Some((x, y)), Some(period_s)) => {
                let [x, y] = [place(&channels, x)?, place(&channels, y)?];
                Ok(vec![peaks(&channels[x], &channels[y], period_s)?])
            }
            (Some(_), None) => {
                let found = tr("peaks without a period");
                Err(DataFault::of_file(found, tr("a period in s")))
            }
            (None, Some(period_s)) => {
                channels.iter().map(|channel| resampled(channel, period_s)).collect()
            }
            (None, None) => Ok(channels),
        }
    }
}

/// The place of a channel.
fn place(channels: &[MeasuredChannel], name: &str) -> Result<usize, DataFault> {
    channels.iter().position(|channel| channel.name == name).ok_or_else(|| {
        let names: Vec<&str> =
            channels.iter().map(|channel| channel.name.as_str()).take(20).collect();
        let found = tr!("there is no channel {name}", name = shown(name));
        DataFault::of_file(found, tr!("one of {names}", names = names.join(", ")))
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::channel;
    use super::*;
    use crate::base::math;

    /// Forces of a tooth that turns, in the axes of a dynamometer that is turned by 30 degrees, with zero and drift.
    fn measured() -> [Vec<MeasuredChannel>; 2] {
        let rate_hz = 10_000.0;
        let cut = |i: usize| if (10_000..30_000).contains(&i) { 1.0 } else { 0.0 };
        let wave = |i: usize, size: f64, phase: f64| {
            cut(i) * size * math::sin(math::TAU * 50.0 * i as f64 / rate_hz + phase)
        };
        let x: Vec<f64> = (0..40_000).map(|i| wave(i, 200.0, 0.0)).collect();
        let y: Vec<f64> = (0..40_000).map(|i| wave(i, 80.0, 1.0)).collect();
        let (turned_x, turned_y) = rotated(&x, &y, -30.0);
        let drifting = |values: Vec<f64>, zero: f64| -> Vec<f64> {
            values.iter().enumerate().map(|(i, x)| x + zero + 1e-4 * i as f64).collect()
        };
        [
            vec![channel("Fx", rate_hz, x), channel("Fy", rate_hz, y)],
            vec![
                channel("Fx", rate_hz, drifting(turned_x, 7.0)),
                channel("Fy", rate_hz, drifting(turned_y, -3.0)),
            ],
        ]
    }

    #[test]
    fn the_steps_bring_back_what_was_there_before_the_dynamometer() {
        let [truth, seen] = measured();
        let preparation = Preparation {
            idle_s: Some([0.1, 0.9]),
            idle_later_s: Some([3.1, 3.9]),
            rotation: Some(("Fx".to_owned(), "Fy".to_owned(), 30.0)),
            ..Preparation::default()
        };
        for (found, known) in preparation.of(&seen).unwrap().iter().zip(&truth) {
            for (found, known) in found.values.iter().zip(&known.values) {
                assert!((found - known).abs() < 1e-8, "{found} {known}");
            }
        }
        let peaked = Preparation {
            peaks: Some(("Fx".to_owned(), "Fy".to_owned())),
            period_s: Some(0.02),
            ..preparation
        };
        let [of_seen, of_truth] = [
            peaked.of(&seen).unwrap(),
            Preparation { idle_s: None, idle_later_s: None, rotation: None, ..peaked.clone() }
                .of(&truth)
                .unwrap(),
        ];
        assert_eq!(of_seen[0].values.len(), 200);
        for (found, known) in of_seen[0].values.iter().zip(&of_truth[0].values) {
            assert!((found - known).abs() < 1e-7, "{found} {known}");
        }
    }

    #[test]
    fn what_does_not_go_together_is_told() {
        let [_, seen] = measured();
        let one = |preparation: Preparation| preparation.of(&seen).unwrap_err().to_string();
        let names = || (String::from("Fx"), String::from("Fq"));
        assert!(
            one(Preparation { peaks: Some(names()), ..Preparation::default() })
                .contains("peaks without a period")
        );
        let error = one(Preparation {
            peaks: Some(names()),
            period_s: Some(0.1),
            ..Preparation::default()
        });
        assert!(error.contains("no channel `Fq`") && error.contains("Fx, Fy"), "{error}");
        let error = one(Preparation { idle_later_s: Some([0.0, 1.0]), ..Preparation::default() });
        assert!(error.contains("drift without"), "{error}");
        assert!(
            one(Preparation { low_pass_hz: Some(1e4), ..Preparation::default() })
                .contains("below 4000 Hz")
        );
    }
}

use super::*;
use crate::base::rng::Stream;
use crate::blocks::cnc::dead_time::DeadTime;
use crate::models::feed_drive::{DriveState, ExactDrive, FeedDriveKind};

/// A step from 200 to 400 mm/min after 0.1 s through the project's own dead time and drive, with noise of a share of the
/// step.
fn recorded(kind: FeedDriveKind, dead_ticks: usize, noise: f64, seed: u64) -> DriveRecording {
    let period_s = 1e-3;
    let drive = ExactDrive::new(kind, period_s);
    let mut channel = DeadTime::new(dead_ticks, [200.0, 0.0]);
    let mut state = DriveState::settled(200.0);
    let stream = Stream::new(seed, "recorded");
    let mut recording = DriveRecording { period_s, command: vec![200.0], feed: vec![200.0] };
    for k in 1..1200_u64 {
        let command = if k > 100 { 400.0 } else { 200.0 };
        drive.advance(&mut state, channel.pass([command, 0.0])[0]);
        recording.command.push(command);
        recording.feed.push(state.feed_mm_min() + noise * 200.0 * stream.normal(k));
    }
    recording
}

/// The lag of a drive, s: a1/a0.
fn lag_s(kind: FeedDriveKind) -> f64 {
    let (a, order) = kind.denominator();
    if order == 1 { 1.0 / a[0] } else { a[1] / a[0] }
}

#[test]
fn dead_time_order_and_lag_of_every_drive_come_back_out_of_two_percent_of_noise() {
    for (kind, structure) in [
        (FeedDriveKind::Eq3Of2007, DriveStructure::First),
        (FeedDriveKind::SecondOrder2013, DriveStructure::Critical),
        (FeedDriveKind::Measured3Hz, DriveStructure::Critical),
    ] {
        for (dead_ticks, seed) in [(80, 1), (40, 2), (0, 3)] {
            let fits = identify_drive(&recorded(kind, dead_ticks, 0.02, seed)).unwrap();
            let best = &fits[0];
            let told = format!("{} {dead_ticks}: {best:?}", kind.id());
            let told = &told[..told.len().min(600)];
            assert_eq!(best.structure, structure, "{told}");
            let dead_time_s = dead_ticks as f64 * 1e-3;
            assert!((best.dead_time_s.value - dead_time_s).abs() <= 1e-3, "{told}");
            assert!((best.lag_s.value / lag_s(kind) - 1.0).abs() < 0.03, "{told}");
            assert!((best.gain.value - 1.0).abs() < 0.005, "{told}");
            assert!((best.rest / 4.0 - 1.0).abs() < 0.1, "noise of 4 mm/min: {told}");
        }
    }
}

#[test]
fn without_noise_the_drives_are_found_as_they_are() {
    for (kind, structure) in [
        (FeedDriveKind::Eq3Of2007, DriveStructure::First),
        (FeedDriveKind::Eq2Of2007, DriveStructure::Third),
    ] {
        let fits = identify_drive(&recorded(kind, 80, 0.0, 1)).unwrap();
        let of = fits.iter().find(|fit| fit.structure == structure).unwrap();
        assert!((of.dead_time_s.value - 0.08).abs() < 1e-5, "{:?}", of.dead_time_s);
        assert!((of.lag_s.value / lag_s(kind) - 1.0).abs() < 1e-3, "{:?}", of.lag_s);
        assert!(of.rest < 1e-2, "{}", of.rest);
    }
    // The third order's: -14 and -77.5 +- 171.74i rad/s.
    let fits = identify_drive(&recorded(FeedDriveKind::Eq2Of2007, 80, 0.0, 1)).unwrap();
    let poles = &fits.iter().find(|fit| fit.structure == DriveStructure::Third).unwrap().poles;
    for (found, known) in poles.iter().zip([[-14.0, 0.0], [-77.5, 171.74], [-77.5, -171.74]]) {
        assert!(
            (found[0] - known[0]).abs() < 0.1 && (found[1] - known[1]).abs() < 0.1,
            "{poles:?}"
        );
    }
}

#[test]
fn nine_of_ten_intervals_and_more_hold_the_truth() {
    let (mut dead_times, mut lags) = (0, 0);
    let seeds = 40;
    for seed in 0..seeds {
        let fits =
            identify_drive(&recorded(FeedDriveKind::Eq3Of2007, 80, 0.02, 100 + seed)).unwrap();
        let fit = fits.iter().find(|fit| fit.structure == DriveStructure::First).unwrap();
        let holds = |x: EstimatedValue, truth: f64| (x.value - truth).abs() <= x.half.unwrap();
        dead_times += u32::from(holds(fit.dead_time_s, 0.08));
        lags += u32::from(holds(fit.lag_s, 1.0 / 14.0));
    }
    assert!(dead_times >= 34 && lags >= 34, "{dead_times} and {lags} of {seeds}");
}

#[test]
fn a_recording_that_tells_nothing_is_refused() {
    let sound = recorded(FeedDriveKind::Eq3Of2007, 10, 0.0, 1);
    for (recording, part) in [
        (DriveRecording { command: vec![1.0; 1200], ..sound.clone() }, "never changes"),
        (
            DriveRecording { command: vec![1.0; 3], feed: vec![1.0; 3], ..sound.clone() },
            "3 samples",
        ),
        (DriveRecording { period_s: 0.0, ..sound.clone() }, "a period of 0 s"),
        (DriveRecording { feed: vec![f64::NAN; 1200], ..sound }, "no numbers"),
    ] {
        let error = identify_drive(&recording).unwrap_err();
        assert!(error.contains(part), "{part}: {error}");
    }
}

//! Peaks of a measurement against those that the simulator's controllers see of the same forces.

use steadycut_core::blocks::sensing::peak::PeakWindow;
use steadycut_measured::base::math;
use steadycut_measured::channel::{MeasuredChannel, SampleTimes};
use steadycut_measured::signal::periods::peaks;

#[test]
fn peaks_are_those_that_the_simulators_controllers_see() {
    // The simulator's own: 28.8 kHz, 576 samples in 20 ms.
    let rate_hz = 28_800.0;
    let wave = |k: f64, size: f64| -> Vec<f64> {
        (0..5000).map(|i| size * math::sin(0.01 * k * f64::from(i)) + 0.01 * f64::from(i)).collect()
    };
    let channel = |name: &str, values: Vec<f64>| MeasuredChannel {
        name: name.to_owned(),
        unit: "N".to_owned(),
        times: SampleTimes::Even { rate_hz, first_s: 0.0 },
        values,
    };
    let (x, y) = (wave(1.0, 200.0), wave(1.7, 80.0));
    let mut window = PeakWindow::new(0.0, 1, 576, 1.0 / rate_hz);
    let mut seen = Vec::new();
    for (i, (x, y)) in x.iter().zip(&y).enumerate() {
        let peak = window.push(i as u64, [*x, *y]);
        if (i + 1) % 576 == 0 {
            seen.push(peak.true_n);
        }
    }
    let found = peaks(&channel("Fx", x), &channel("Fy", y), 0.02).unwrap();
    assert_eq!(found.values, seen);
    assert_eq!(found.times, SampleTimes::Even { rate_hz: 50.0, first_s: 0.02 });
}

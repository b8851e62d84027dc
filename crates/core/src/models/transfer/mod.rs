//! A drive of one's own as a transfer function without zeros, discretised exactly for held commands.
//!
//! ```text
//! G(s) = K / product over the poles of (1 - s/p)
//! ```
//!
//! Realised as a chain of lags: of a real pole y' = a (u - y), a = -p; of a pair with w = |p|, zeta = -Re p / w
//! y' = w v, v' = w (u - y) - 2 zeta w v. The chain's matrix is as well scaled as its poles, so that a step is one
//! matrix exponential of it with the held command beside it.

mod setting;

pub use setting::{LARGEST_RAD_S, SLOWEST_RAD_S, TransferPoles};

use crate::base::dense::exponential;

/// Highest order: a step costs the order's square and every snapshot of a run keeps the state, and no recorded step
/// tells more poles apart.
pub const MAX_ORDER: usize = 8;

/// A transfer function discretised for one step length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactTransfer {
    order: usize,
    gain: f64,
    /// The chain's last state is the output.
    phi: [[f64; MAX_ORDER]; MAX_ORDER],
    gamma: [f64; MAX_ORDER],
    /// Which states are outputs of a lag: at rest they stand at the command, the others at 0.
    outputs: [bool; MAX_ORDER],
    /// The output among the states.
    last: usize,
}

/// State of a transfer function's chain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransferState([f64; MAX_ORDER]);

impl ExactTransfer {
    /// Discretises poles with a gain for steps of `dt_s` seconds; at least one pole is asked for.
    #[must_use]
    pub fn new(poles: &TransferPoles, gain: f64, dt_s: f64) -> Self {
        let order = poles.order().min(MAX_ORDER);
        let size = order + 1;
        let mut matrix = vec![0.0; size * size];
        let mut outputs = [false; MAX_ORDER];
        // What drives the next lag: the command, which stands last, then the output of the lag before.
        let (mut input, mut at) = (order, 0);
        for [re, im] in poles.all() {
            if *im == 0.0 {
                matrix[at * size + at] = *re * dt_s;
                matrix[at * size + input] = -*re * dt_s;
                outputs[at] = true;
                (input, at) = (at, at + 1);
            } else {
                let w = (re * re + im * im).sqrt();
                let (y, v) = (at, at + 1);
                matrix[y * size + v] = w * dt_s;
                matrix[v * size + y] = -w * dt_s;
                matrix[v * size + v] = 2.0 * re * dt_s;
                matrix[v * size + input] = w * dt_s;
                outputs[y] = true;
                (input, at) = (y, at + 2);
            }
        }
        let step = exponential(&matrix, size);
        let mut exact = Self {
            order,
            gain,
            phi: [[0.0; MAX_ORDER]; MAX_ORDER],
            gamma: [0.0; MAX_ORDER],
            outputs,
            last: if input < order { input } else { 0 },
        };
        for i in 0..order {
            exact.phi[i][..order].copy_from_slice(&step[i * size..i * size + order]);
            exact.gamma[i] = step[i * size + order];
        }
        exact
    }

    /// At rest with the output at a value.
    #[must_use]
    pub fn settled(&self, output: f64) -> TransferState {
        TransferState(self.outputs.map(|is_output| if is_output { output } else { 0.0 }))
    }

    /// The output that a held command leads to.
    #[must_use]
    pub fn at_rest(&self, command: f64) -> f64 {
        self.gain * command
    }

    /// One step with the command held over it.
    #[inline]
    pub fn advance(&self, state: &mut TransferState, command: f64) {
        let (x, command) = (state.0, self.gain * command);
        for i in 0..self.order {
            let mut sum = self.gamma[i] * command;
            for (factor, x) in self.phi[i][..self.order].iter().zip(&x) {
                sum += factor * x;
            }
            state.0[i] = sum;
        }
    }

    /// The output.
    #[must_use]
    #[inline]
    pub fn output(&self, state: &TransferState) -> f64 {
        state.0[self.last]
    }
}

/// A drive of one's own with its state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransferDrive {
    exact: ExactTransfer,
    state: TransferState,
}

impl TransferDrive {
    /// The drive of these poles at rest with its output at a value, for steps of `dt_s`; none without poles.
    #[must_use]
    pub fn new(poles: &TransferPoles, gain: f64, dt_s: f64, output: f64) -> Option<Self> {
        let exact = (!poles.is_empty()).then(|| ExactTransfer::new(poles, gain, dt_s))?;
        Some(Self { exact, state: exact.settled(output) })
    }

    /// At rest where it is asked for `command`.
    pub fn settle(&mut self, command: f64) {
        self.state = self.exact.settled(self.exact.at_rest(command));
    }

    /// Goes on as it stands where `before` is the same drive.
    #[must_use]
    pub fn going_on(self, before: Option<Self>) -> Self {
        before.filter(|before| before.exact == self.exact).unwrap_or(self)
    }

    /// The output after a step with the command held over it.
    #[inline]
    pub fn advance(&mut self, command: f64) -> f64 {
        self.exact.advance(&mut self.state, command);
        self.output()
    }

    /// The output.
    #[must_use]
    #[inline]
    pub fn output(&self) -> f64 {
        self.exact.output(&self.state)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math;
    use crate::models::feed_drive::{DriveState, ExactDrive, FeedDriveKind};

    fn poles(list: &[[f64; 2]]) -> TransferPoles {
        TransferPoles::new(list.to_vec()).unwrap()
    }

    #[test]
    fn the_papers_drives_come_out_as_the_loop_has_them() {
        for (kind, list) in [
            (FeedDriveKind::Eq3Of2007, vec![[-14.0, 0.0]]),
            (
                FeedDriveKind::Eq2Of2007,
                vec![[-14.0, 0.0], [-77.5, (35_500.0_f64 - 77.5 * 77.5).sqrt()]],
            ),
            (FeedDriveKind::SecondOrder2013, vec![[-31.25, 0.0], [-31.25, 0.0]]),
        ] {
            for dt_s in [1e-4, 1e-3, 0.02] {
                let (own, known) =
                    (ExactTransfer::new(&poles(&list), 1.0, dt_s), ExactDrive::new(kind, dt_s));
                let (mut x, mut y) = (own.settled(200.0), DriveState::settled(200.0));
                for k in 0..(0.5 / dt_s) as u32 {
                    let command = if k % 70 < 40 { 400.0 } else { 150.0 };
                    own.advance(&mut x, command);
                    known.advance(&mut y, command);
                    let gap = (own.output(&x) - y.feed_mm_min()).abs();
                    assert!(gap < 1e-6, "{} {dt_s} {k}: {gap:e}", kind.id());
                }
            }
        }
    }

    #[test]
    fn eight_equal_lags_meet_the_analytic_step() {
        // Of n equal lags: 1 - e^-at sum of (at)^k / k!.
        let own = ExactTransfer::new(&poles(&[[-50.0, 0.0]; MAX_ORDER]), 0.9, 2e-3);
        let mut state = own.settled(0.0);
        for step in 1..=300 {
            own.advance(&mut state, 10.0);
            let at = 50.0 * 2e-3 * f64::from(step);
            let (mut term, mut sum) = (1.0, 0.0);
            for k in 0..MAX_ORDER {
                sum += term;
                term *= at / (k + 1) as f64;
            }
            let known = 9.0 * (1.0 - math::exp(-at) * sum);
            assert!((own.output(&state) - known).abs() < 1e-11, "{step}");
        }
        assert_eq!(own.at_rest(10.0), 9.0);
    }

    #[test]
    fn at_rest_nothing_moves_and_the_steps_length_does_not_matter() {
        let list = [[-30.0, 0.0], [-20.0, 90.0], [-200.0, 10.0]];
        let own = ExactTransfer::new(&poles(&list), 1.2, 1e-3);
        let mut state = own.settled(own.at_rest(300.0));
        for _ in 0..100 {
            own.advance(&mut state, 300.0);
        }
        assert!((own.output(&state) - 360.0).abs() < 1e-9);
        let coarse = ExactTransfer::new(&poles(&list), 1.2, 1e-2);
        let (mut x, mut y) = (own.settled(0.0), coarse.settled(0.0));
        (0..10).for_each(|_| own.advance(&mut x, 1.0));
        coarse.advance(&mut y, 1.0);
        assert!((own.output(&x) - coarse.output(&y)).abs() < 1e-12);
    }
}

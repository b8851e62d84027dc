//! The clock of the loop: whole plant steps, and which of them the controller samples.

/// Plant steps counted from the start of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    dt_s: f64,
    steps_per_control: u64,
    tick: u64,
    to_control: u64,
}

impl Clock {
    /// Before the first step of `dt_s`; the count is the steps in a control period.
    #[must_use]
    pub fn new(dt_s: f64, steps_per_control: u32) -> Self {
        Self { dt_s, steps_per_control: u64::from(steps_per_control), tick: 0, to_control: 0 }
    }

    /// Number of the control sample that the step to come begins with, if it does.
    #[must_use]
    #[inline]
    pub fn control_sample(&self) -> Option<u64> {
        (self.to_control == 0).then(|| self.tick / self.steps_per_control)
    }

    /// A step is done; gives the number of steps done.
    #[inline]
    pub fn advance(&mut self) -> u64 {
        if self.to_control == 0 {
            self.to_control = self.steps_per_control;
        }
        self.to_control -= 1;
        self.tick += 1;
        self.tick
    }

    /// Steps done so far.
    #[must_use]
    #[inline]
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// Time since the start, s.
    #[must_use]
    #[inline]
    pub fn time_s(&self) -> f64 {
        self.tick as f64 * self.dt_s
    }

    /// Plant step, s.
    #[must_use]
    pub fn dt_s(&self) -> f64 {
        self.dt_s
    }

    /// Control period, s.
    #[must_use]
    pub fn period_s(&self) -> f64 {
        self.dt_s * self.steps_per_control as f64
    }
}

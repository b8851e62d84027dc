//! Displacement between tooth and work under the cutting force, with regeneration.
//!
//! ```text
//! q_r+ = a_r q_r + g_r F ,  a = e^{l dt} ,  g = (a - 1) / l                 r = 1..4, F held
//! ubar = c1.q + d1 F        mean displacement of the interval:
//!        c1_r = R_r (a - 1) / (l dt) ,  d1 = 1/k3 + sum 2 Re[ R_r ((a - 1)/(l dt) - 1) / l ]
//! vbar = cv.q + dv F        mean velocity: cv_r = R_r (a - 1) / dt , dv = sum 2 Re[ R_r g_r ] / dt
//! F = F_s - kappa (ubar - udel) - c vbar >= 0 ,  udel = ubar one tooth period ago, or as many as it takes
//! ```
//!
//! F_s is the mean over the interval of the force without vibration, kappa that of the cut's
//! stiffness (chip gain times chip direction), c that of process damping. The force of the interval
//! stands on both sides, once: the equation is solved for F, so the step is implicit without
//! iteration. udel is interpolated by a cubic where the tooth period is no whole number of steps; where run-out
//! leaves teeth out of the cut it is the mean of the surfaces that are really cut ([`LeftBy`]).
//! When contact is lost (F = 0) the surface stays where the tooth before left it.

use crate::base::math;
use crate::models::mechanistic::MAX_TEETH;
use crate::models::structure::Complex;
use crate::models::structure::reduction::Reduction;

/// What drives the machine for one step: averages over its interval.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CutForce {
    /// Force without vibration F_s, N.
    pub static_n: f64,
    /// Stiffness of the cut kappa, N/m; 0 leaves the given force alone.
    pub stiffness_n_m: f64,
    /// Process damping c, N s/m.
    pub damping_n_s_m: f64,
    /// Tooth period, s.
    pub delay_s: f64,
}

/// Shares of the stiffness that cut the surface of the tooth before, of the second one before, ...; together 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftBy(pub [f64; MAX_TEETH]);

impl LeftBy {
    /// The shares of what of the edges cuts each surface; of the tooth before alone where nothing cuts.
    #[must_use]
    pub fn shares(cutting: &[f64; MAX_TEETH]) -> Self {
        let sum: f64 = cutting.iter().sum();
        if sum > 0.0 { Self(cutting.map(|part| part / sum)) } else { Self::default() }
    }
}

impl Default for LeftBy {
    /// Every tooth cuts the surface of the one before.
    fn default() -> Self {
        Self(std::array::from_fn(|k| if k == 0 { 1.0 } else { 0.0 }))
    }
}

/// What the machine did in one step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Cutting force, N.
    pub force_n: f64,
    /// Mean displacement of the tooth off the work, m.
    pub displacement_m: f64,
    /// Mean velocity, m/s.
    pub velocity_m_s: f64,
    /// The tooth jumped out of the cut.
    pub lost_contact: bool,
}

/// One complex number per mode, real and imaginary parts apart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Row {
    re: [f64; 4],
    im: [f64; 4],
}

impl Row {
    fn of(values: [Complex; 4]) -> Self {
        Self { re: values.map(|z| z.re), im: values.map(|z| z.im) }
    }

    /// sum of 2 Re(self q).
    #[inline]
    fn times(&self, q: &Self) -> f64 {
        let mut sum = 0.0;
        for r in 0..4 {
            sum += self.re[r] * q.re[r] - self.im[r] * q.im[r];
        }
        2.0 * sum
    }
}

/// The machine, discretised exactly for steps of one length, with its memory of the surface.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalResponse {
    dt_s: f64,
    a: Row,
    g: Row,
    c1: Row,
    cv: Row,
    /// d1 without the tooth's 1/k3.
    d1_modes: f64,
    dv: f64,
    feedthrough_m_n: f64,
    holds_contact: bool,
    q: Row,
    /// Surface of the last steps, a ring; `newest` is the last one written.
    surface_m: Vec<f64>,
    newest: usize,
    delay_s: f64,
    tooth_before: Delay,
}

/// A time back in the memory.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Delay {
    /// Steps back to the first of four interpolated values, and their weights.
    back: usize,
    weights: [f64; 4],
}

impl Delay {
    /// So many steps back, at least 2, in a memory of `kept` steps.
    fn new(steps: f64, kept: usize) -> Self {
        // The value wanted lies between the second and third of four, all of the past.
        let steps = math::limit(steps, ModalResponse::FEWEST_STEPS, (kept - 3) as f64);
        let whole = steps.floor();
        let x = steps - whole;
        Self {
            back: whole as usize - 2,
            weights: [
                x * (x - 1.0) * (x - 2.0) / -6.0,
                (x + 1.0) * (x - 1.0) * (x - 2.0) / 2.0,
                (x + 1.0) * x * (x - 2.0) / -2.0,
                (x + 1.0) * x * (x - 1.0) / 6.0,
            ],
        }
    }
}

impl ModalResponse {
    /// Fewest steps in a tooth period: a shorter one counts as so long. Whoever asks for it marks that.
    pub const FEWEST_STEPS: f64 = 2.0;

    /// The machine at rest, for steps of `dt_s`, with a memory of `longest_delay_s`: what lies further back
    /// counts as its oldest value. Whoever asks for it marks that.
    #[must_use]
    pub fn new(machine: &Reduction, dt_s: f64, longest_delay_s: f64) -> Self {
        let one = Complex::from(1.0);
        let of = |value: &dyn Fn(usize, Complex, Complex, Complex) -> Complex| {
            [0, 1, 2, 3].map(|r| {
                let l = machine.poles[r];
                let size = math::exp(l.re * dt_s);
                let angle = l.im * dt_s;
                let a = Complex::new(size * math::cos(angle), size * math::sin(angle));
                value(r, l, a, machine.residues[r])
            })
        };
        let held = of(&|_, l, a, _| (a - one) / l);
        let d1 = of(&|_, l, a, residue| residue * ((a - one) / (l * dt_s) - one) / l);
        let dv = of(&|_, l, a, residue| residue * (a - one) / l / dt_s);
        let twice = |values: [Complex; 4]| 2.0 * values.iter().map(|z| z.re).sum::<f64>();
        let steps = (longest_delay_s / dt_s).ceil().max(2.0) as usize;
        let mut response = Self {
            dt_s,
            a: Row::of(of(&|_, _, a, _| a)),
            g: Row::of(held),
            c1: Row::of(of(&|_, l, a, residue| residue * (a - one) / (l * dt_s))),
            cv: Row::of(of(&|_, _, a, residue| residue * (a - one) / dt_s)),
            d1_modes: twice(d1),
            dv: twice(dv),
            feedthrough_m_n: machine.feedthrough_m_n,
            holds_contact: false,
            q: Row::default(),
            surface_m: vec![0.0; (steps + 4).next_power_of_two()],
            newest: 0,
            delay_s: 0.0,
            tooth_before: Delay { back: 1, weights: [0.0; 4] },
        };
        response.set_delay(longest_delay_s);
        response
    }

    /// The same machine in a cut that never loses contact: a negative force counts as a fraction of a
    /// larger one. For the growth of small disturbances.
    #[must_use]
    pub fn holding_contact(mut self) -> Self {
        self.holds_contact = true;
        self
    }

    /// The tooth's spring now, N/m: it weakens with wear.
    pub fn set_tooth_stiffness(&mut self, stiffness_n_m: f64) {
        self.feedthrough_m_n = 1.0 / stiffness_n_m;
    }

    fn set_delay(&mut self, delay_s: f64) {
        self.delay_s = delay_s;
        self.tooth_before = Delay::new(delay_s / self.dt_s, self.surface_m.len());
    }

    #[inline]
    fn back(&self, delay: &Delay) -> f64 {
        let mask = self.surface_m.len() - 1;
        let first = self.newest + self.surface_m.len() - delay.back;
        let mut sum = 0.0;
        for (i, weight) in delay.weights.iter().enumerate() {
            sum += weight * self.surface_m[(first - i) & mask];
        }
        sum
    }

    /// The surface that is cut, m.
    #[inline]
    fn surface_before(&self, left_by: &LeftBy) -> f64 {
        let [first, others @ ..] = &left_by.0;
        let mut sum = first * self.back(&self.tooth_before);
        if *first != 1.0 {
            for (i, share) in others.iter().enumerate().filter(|(_, share)| **share > 0.0) {
                let steps = (i + 2) as f64 * self.delay_s / self.dt_s;
                sum += share * self.back(&Delay::new(steps, self.surface_m.len()));
            }
        }
        sum
    }

    /// One step in which every tooth cuts the surface of the one before.
    #[inline]
    pub fn update(&mut self, cut: &CutForce) -> Motion {
        if cut.delay_s != self.delay_s {
            self.set_delay(cut.delay_s);
        }
        self.step(cut, self.back(&self.tooth_before))
    }

    /// One step in which the teeth cut the surfaces of those that have left them.
    #[inline]
    pub fn update_on(&mut self, cut: &CutForce, left_by: &LeftBy) -> Motion {
        if cut.delay_s != self.delay_s {
            self.set_delay(cut.delay_s);
        }
        self.step(cut, self.surface_before(left_by))
    }

    #[inline]
    fn step(&mut self, cut: &CutForce, before: f64) -> Motion {
        let CutForce { static_n, stiffness_n_m: kappa, damping_n_s_m: damping, .. } = *cut;
        let d1 = self.feedthrough_m_n + self.d1_modes;
        let (free, free_velocity) = (self.c1.times(&self.q), self.cv.times(&self.q));
        let wanted = (static_n - kappa * (free - before) - damping * free_velocity)
            / (1.0 + kappa * d1 + damping * self.dv);
        let lost_contact = kappa > 0.0 && wanted < 0.0 && !self.holds_contact;
        let force_n = if self.holds_contact { wanted } else { math::positive(wanted) };
        let displacement_m = free + d1 * force_n;
        for r in 0..4 {
            let (re, im) = (self.q.re[r], self.q.im[r]);
            self.q.re[r] = self.a.re[r] * re - self.a.im[r] * im + self.g.re[r] * force_n;
            self.q.im[r] = self.a.re[r] * im + self.a.im[r] * re + self.g.im[r] * force_n;
        }
        let surface = match lost_contact {
            true => displacement_m.min(before + static_n / kappa),
            false => displacement_m,
        };
        self.newest = (self.newest + 1) & (self.surface_m.len() - 1);
        self.surface_m[self.newest] = surface;
        let velocity_m_s = free_velocity + self.dv * force_n;
        Motion { force_n, displacement_m, velocity_m_s, lost_contact }
    }

    /// The bits of all coefficients, for the test that they are equal natively and in wasm.
    #[must_use]
    pub fn coefficient_bits(&self) -> Vec<u64> {
        let rows = [self.a, self.g, self.c1, self.cv];
        let rows = rows.iter().flat_map(|row| row.re.iter().chain(&row.im));
        rows.chain(&[self.d1_modes, self.dv]).map(|x| x.to_bits()).collect()
    }
}

#[cfg(test)]
mod tests;

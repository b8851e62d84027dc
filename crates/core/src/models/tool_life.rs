//! Prediction of the tool's life from the trend of its sound: a function of time with two unknowns.
//!
//! ```text
//! E(a) = E0 g(w(a/T))                      g(0) = 1, g(1) = lambda: the criterion, from the model
//! r_i(T) = ln E_i - ln g(w(a_i/T)),        ln E0 = mean r: eliminated
//! J(T) = sum (r_i - mean r)^2/(sigma^2 n_c) + (ln(T/T_Taylor)/s_T)^2
//! p(ln T) ~ exp(-J/2),  T > a;             T_hat = exp(mean of ln T),  remaining = T_hat - a
//! ```
//!
//! a is the age: the time in cut, or under changing conditions the time that would wear the tool as
//! much at the reference conditions, so a/T is the fraction x of the life. The minimum of parameters,
//! T among them, is what the 2019 paper asks of a predictive model; its own is not printed.
//! Samples are means of a minute. The posterior is held on a grid in ln T and grows sample by sample.

use super::formula_model::OwnFormula;
use super::machine_trend::{LifeSettings, MachineTrend};
use super::wear::WearSettings;
use crate::base::math;

/// Points of the grid.
const GRID: usize = 401;
/// Half width of the grid in spreads of the prior.
const REACH: f64 = 4.5;
/// Steps of wear at which a calibrated trend is known.
const KNOTS: usize = 32;

/// How the sound grows with wear: E/E0 over w.
#[derive(Clone, Debug, PartialEq)]
pub struct Growth {
    /// Values at equal steps of w from 0 to 1; the first is 1.
    knots: Vec<f64>,
}

impl Growth {
    /// E/E0 = 1 + (lambda - 1) w: the closed form with the criterion alone.
    #[must_use]
    pub fn linear(lambda: f64) -> Self {
        Self { knots: vec![1.0, lambda] }
    }

    /// What the machine's model gives between a sharp tool and the end of its life.
    #[must_use]
    pub fn calibrated(model: &MachineTrend) -> Self {
        let mut by_wear = model.clone();
        // Wear itself in place of the fraction of life: w(x) = x.
        by_wear.wear.break_in_share = 0.0;
        by_wear.wear.failure_share = 0.0;
        by_wear.wear.curve = OwnFormula::default();
        let sharp = by_wear.at(0.0).sound;
        let knots = (0..=KNOTS).map(|i| by_wear.at(i as f64 / KNOTS as f64).sound / sharp);
        Self { knots: knots.collect() }
    }

    /// E/E0 at wear `w`, carried on beyond the last knot.
    #[must_use]
    pub fn at(&self, w: f64) -> f64 {
        let steps = self.knots.len() - 1;
        let place = math::positive(w) * steps as f64;
        let i = (place as usize).min(steps - 1);
        let value = self.knots[i] + (place - i as f64) * (self.knots[i + 1] - self.knots[i]);
        value.max(0.01)
    }

    /// The criterion lambda: E/E0 at the end of life.
    #[must_use]
    pub fn lambda(&self) -> f64 {
        self.knots[self.knots.len() - 1]
    }
}

/// A prediction of the tool's life.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct LifePrediction {
    /// Age of the tool, min.
    pub age_min: f64,
    /// Predicted life, min.
    pub life_min: f64,
    /// The 5 % and 95 % quantiles of the belief, min.
    pub life_range_min: [f64; 2],
    /// Sound of the sharp tool as estimated.
    pub first_sound: f64,
    /// The sound has reached lambda times that of the sharp tool.
    pub alarm: bool,
}

impl LifePrediction {
    /// Remaining useful life, min.
    #[must_use]
    pub fn remaining_min(&self) -> f64 {
        math::positive(self.life_min - self.age_min)
    }
}

/// The belief about one tool.
#[derive(Clone, Debug)]
pub struct Predictor {
    wear: WearSettings,
    growth: Growth,
    /// Of a residual: sigma^2 n_c.
    variance: f64,
    log_life: Vec<f64>,
    life_min: Vec<f64>,
    log_prior: Vec<f64>,
    mean: Vec<f64>,
    squares: Vec<f64>,
    samples: f64,
    age_min: f64,
    last_sound: f64,
}

impl Predictor {
    /// The belief about a new tool, whose life Taylor's equation puts at `prior_min`.
    #[must_use]
    pub fn new(
        wear: &WearSettings,
        growth: &Growth,
        settings: &LifeSettings,
        prior_min: f64,
    ) -> Self {
        let sigma = settings.sigma_percent / 100.0;
        let center = math::ln(math::limit(prior_min, 1e-3, 1e6));
        let step = 2.0 * REACH / (GRID - 1) as f64;
        let offset = |i: usize| i as f64 * step - REACH;
        let log_life: Vec<f64> =
            (0..GRID).map(|i| center + settings.prior_spread * offset(i)).collect();
        Self {
            wear: wear.clone(),
            growth: growth.clone(),
            life_min: log_life.iter().map(|log_life| math::exp(*log_life)).collect(),
            variance: sigma * sigma * settings.correlated_min,
            log_life,
            log_prior: (0..GRID).map(|i| offset(i) * offset(i)).collect(),
            mean: vec![0.0; GRID],
            squares: vec![0.0; GRID],
            samples: 0.0,
            age_min: 0.0,
            last_sound: 0.0,
        }
    }

    /// Takes the mean sound of a minute whose middle the tool reached at `age_min`; what is not
    /// finite and positive is left out.
    pub fn observe(&mut self, age_min: f64, sound: f64) {
        if !(sound > 0.0 && sound.is_finite() && age_min >= self.age_min) {
            return;
        }
        self.age_min = age_min;
        self.last_sound = sound;
        self.samples += 1.0;
        let log_sound = math::ln(sound);
        for i in 0..GRID {
            let x = (age_min / self.life_min[i]).min(1.0);
            let residual = log_sound - math::ln(self.growth.at(self.wear.wear(x)));
            let before = residual - self.mean[i];
            self.mean[i] += before / self.samples;
            self.squares[i] += before * (residual - self.mean[i]);
        }
    }

    /// The present belief; `None` once the tool is older than all that was thought possible.
    #[must_use]
    pub fn prediction(&self) -> Option<LifePrediction> {
        let cost = |i: usize| self.squares[i] / self.variance + self.log_prior[i];
        // The lives of the grid rise; the tool has lived beyond the first ones.
        let possible = self.life_min.partition_point(|life_min| *life_min <= self.age_min)..GRID;
        let least = possible.clone().map(cost).fold(f64::INFINITY, f64::min);
        let mut weights = [0.0; GRID];
        for i in possible.clone() {
            weights[i] = math::exp(0.5 * (least - cost(i)));
        }
        let weights = &weights[possible.clone()];
        let total: f64 = weights.iter().sum();
        if possible.is_empty() || !total.is_finite() {
            return None;
        }
        let mean_of = |values: &[f64]| {
            let values = &values[possible.clone()];
            values.iter().zip(weights).map(|(value, weight)| value * weight).sum::<f64>() / total
        };
        let quantile = |probability: f64| {
            let mut sum = 0.0;
            let reached = possible.clone().zip(weights).find(|(_, weight)| {
                sum += **weight;
                sum >= probability * total
            });
            self.life_min[reached.map_or(GRID - 1, |(i, _)| i)]
        };
        let first_sound = math::exp(mean_of(&self.mean));
        Some(LifePrediction {
            age_min: self.age_min,
            life_min: math::exp(mean_of(&self.log_life)),
            life_range_min: [quantile(0.05), quantile(0.95)],
            first_sound,
            alarm: self.samples > 0.0 && self.last_sound >= self.growth.lambda() * first_sound,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn predictor() -> Predictor {
        let (wear, life) = (WearSettings::default(), LifeSettings::default());
        Predictor::new(&wear, &Growth::linear(1.844), &life, 240.0)
    }

    /// A tool that lives `life_min` and sounds like the closed form, observed until the fraction `used` of it.
    fn observed(life_min: f64, used: f64) -> Predictor {
        let (wear, growth) = (WearSettings::default(), Growth::linear(1.844));
        let mut predictor = predictor();
        for minute in 0..(life_min * used) as u32 {
            let age_min = f64::from(minute) + 0.5;
            predictor.observe(age_min, 3.7 * growth.at(wear.wear(age_min / life_min)));
        }
        predictor
    }

    #[test]
    fn without_sound_the_prediction_is_taylors_life_with_its_spread() {
        let prediction = predictor().prediction().unwrap();
        assert!((prediction.life_min / 240.0 - 1.0).abs() < 1e-9);
        // Ninety percent of a normal distribution: 1.645 spreads to each side.
        for (limit, sign) in prediction.life_range_min.into_iter().zip([-1.0, 1.0]) {
            let expected = 240.0 * math::exp(sign * 1.645 * 0.3);
            assert!((limit / expected - 1.0).abs() < 0.01, "{limit} {expected}");
        }
        assert!(!prediction.alarm);
    }

    #[test]
    fn a_clean_trend_gives_the_life_and_the_sound_of_the_sharp_tool() {
        for life_min in [160.0, 240.0, 380.0] {
            let [early, late] =
                [0.5, 0.95].map(|used| observed(life_min, used).prediction().unwrap());
            assert!((late.life_min / life_min - 1.0).abs() < 0.01, "{late:?}");
            assert!((late.first_sound / 3.7 - 1.0).abs() < 0.01);
            assert!((early.life_min / life_min - 1.0).abs() < 0.15, "{early:?}");
            let width = |f: &LifePrediction| f.life_range_min[1] / f.life_range_min[0];
            assert!(width(&late) < 0.5 * width(&early) + 0.5, "{early:?} {late:?}");
            assert!(late.life_range_min[0] < life_min && life_min < late.life_range_min[1]);
            assert!(!early.alarm && !late.alarm);
        }
    }

    #[test]
    fn the_alarm_comes_at_lambda_and_does_not_know_the_life() {
        let mut predictor = observed(240.0, 0.6);
        predictor.observe(145.0, 3.7 * 1.9);
        assert!(predictor.prediction().unwrap().alarm);
    }

    #[test]
    fn what_cannot_be_observed_changes_nothing_and_an_immortal_tool_has_no_prediction() {
        let mut predictor = observed(240.0, 0.3);
        let before = predictor.prediction();
        for (age, sound) in [(f64::NAN, 1.0), (80.0, f64::NAN), (80.0, -1.0), (1.0, 3.7)] {
            predictor.observe(age, sound);
        }
        assert_eq!(predictor.prediction(), before);
        predictor.observe(1e7, 3.7);
        assert_eq!(predictor.prediction(), None);
    }
}

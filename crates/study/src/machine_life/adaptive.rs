//! The adaptive use: the cutting speed is adjusted so that the tool reaches the desired tool life.
//!
//! ```text
//! vc_new = vc [ R/R_des ]^n,   R = (T_hat - a) T(vc)/T(vc0),   R_des = T_des - t
//! ```
//!
//! R is the remaining life predicted at the present speed, R_des the remaining life wanted. The feed per
//! tooth stays. The age a counts in minutes at the programmed speed vc0. Taken as known: Taylor's
//! exponents. Unknown: how long this very tool lives. The sound is taken relative to that of a sharp
//! tool in the same cut, so that the speed itself is not mistaken for wear (chosen).

use serde::Serialize;

use super::model;
use super::monte_carlo::MinuteNoise;
use crate::base::language::text;
use crate::base::math;
use crate::base::rng::Stream;
use crate::blocks::control::speed_supervisor::{PERIOD_MIN, adjusted};
use crate::models::machine_trend::MachineTrend;
use crate::models::tool_life::{Growth, LifePrediction, Predictor};
use crate::models::wear::WearCut;
use crate::run::job::{Budget, Job, Progress};
use crate::run::scenario::Scenario;

/// Multiple of the desired life after which a tool is given up.
const LONGEST: f64 = 10.0;

/// One minute of the tool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Minute {
    /// Time in cut, min.
    pub time_min: f64,
    /// True fraction of the life.
    pub x: f64,
    /// Cutting speed, m/min.
    pub cutting_speed_m_min: f64,
    /// Measured sound relative to the sharp tool.
    pub sound: f64,
    /// Predicted remaining life at the present speed, min.
    pub remaining_min: Option<f64>,
    /// The 5 % and 95 % quantiles of the remaining life, min.
    pub remaining_range_min: Option<[f64; 2]>,
}

/// The life of one tool, minute by minute.
#[derive(Clone, Debug)]
pub struct AdaptiveLife {
    model: MachineTrend,
    growth: Growth,
    predictor: Predictor,
    noise: MinuteNoise,
    adjusts: bool,
    cut: WearCut,
    age_min: f64,
    x: f64,
    minutes: Vec<Minute>,
    /// When the life ended, min.
    end_min: Option<f64>,
}

impl AdaptiveLife {
    /// The tool of a scenario, sharp; `adjusts` switches the adjustment of the speed on.
    #[must_use]
    pub fn new(scenario: &Scenario, adjusts: bool) -> Self {
        let model = model(scenario);
        let growth = Growth::calibrated(&model);
        let prior_min = model.wear.usual_life_min(&model.cut);
        let stream = Stream::new(u64::from(scenario.run.seed), "life.adaptive");
        Self {
            predictor: Predictor::new(&model.wear, &growth, &model.life, prior_min),
            noise: MinuteNoise::new(&model.life, stream),
            cut: model.cut,
            growth,
            model,
            adjusts,
            age_min: 0.0,
            x: 0.0,
            minutes: Vec::new(),
            end_min: None,
        }
    }

    /// Life at the present speed over that at the programmed one.
    fn life_ratio(&self) -> f64 {
        let wear = &self.model.wear;
        wear.usual_life_min(&self.cut) / wear.usual_life_min(&self.model.cut)
    }

    /// Whether it is worn out, or has outlived every wish and is given up.
    fn is_over(&self) -> bool {
        let given_up = LONGEST * self.model.life.tool_life_min;
        self.end_min.is_some() || self.minutes.len() as f64 >= given_up
    }

    fn minute(&mut self) {
        let wear = &self.model.wear;
        let (before, rate) = (self.x, 1.0 / wear.life_min(&self.cut));
        let passed = 1.0 / self.life_ratio();
        let time_min = self.minutes.len() as f64;
        let sound = self.growth.at(wear.wear(before + 0.5 * rate)) * self.noise.factor();
        self.x = before + rate;
        if self.x >= 1.0 {
            self.end_min = Some(time_min + (1.0 - before) / rate);
        }
        self.predictor.observe(self.age_min + 0.5 * passed, sound);
        self.age_min += passed;
        let prediction = self.predictor.prediction();
        self.minutes.push(Minute {
            time_min: time_min + 1.0,
            x: self.x,
            cutting_speed_m_min: self.cut.cutting_speed_m_min,
            sound,
            remaining_min: prediction
                .map(|prediction| prediction.remaining_min() * self.life_ratio()),
            remaining_range_min: prediction.map(|prediction| {
                let remaining = |life_min: f64| math::positive(life_min - prediction.age_min);
                prediction.life_range_min.map(|life_min| remaining(life_min) * self.life_ratio())
            }),
        });
        if let Some(prediction) = prediction.filter(|_| self.adjusts) {
            self.adjust(&prediction);
        }
    }

    fn adjust(&mut self, prediction: &LifePrediction) {
        if !self.minutes.len().is_multiple_of(PERIOD_MIN as usize) {
            return;
        }
        let wanted_min = self.model.life.tool_life_min - self.minutes.len() as f64;
        let remaining_min = prediction.remaining_min() * self.life_ratio();
        let (speed, programmed) =
            (self.cut.cutting_speed_m_min, self.model.cut.cutting_speed_m_min);
        let lives_min = [remaining_min, wanted_min];
        let exponent = self.model.wear.taylor_exponent;
        if let Some(speed) = adjusted(speed, programmed, lives_min, exponent) {
            self.cut.cutting_speed_m_min = speed;
        }
    }

    /// The minutes so far.
    #[must_use]
    pub fn minutes(&self) -> &[Minute] {
        &self.minutes
    }

    /// When the life ended, min; `None` before, and for a tool that was given up.
    #[must_use]
    pub fn end_min(&self) -> Option<f64> {
        self.end_min
    }
}

/// A tool's life so far.
#[derive(Clone, Debug, PartialEq)]
pub struct AdaptiveSoFar {
    /// The minutes.
    pub minutes: Vec<Minute>,
    /// See [`AdaptiveLife::end_min`].
    pub end_min: Option<f64>,
}

/// A step is a minute in the cut.
impl Job for AdaptiveLife {
    type Partial = AdaptiveSoFar;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while !self.is_over() && budget.step() {
            self.minute();
        }
        self.is_over()
    }

    fn progress(&self) -> Progress {
        // How long it will be is not known before; what share of it is used is.
        let done = if self.is_over() { 100.0 } else { (100.0 * self.x).clamp(0.0, 100.0) };
        Progress { done, total: 100.0, unit: text!("percent of the life") }
    }

    fn partial(&self) -> AdaptiveSoFar {
        AdaptiveSoFar { minutes: self.minutes.clone(), end_min: self.end_min }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lived(tool_life_factor: f64, adjusts: bool) -> AdaptiveLife {
        let mut scenario = Scenario::default();
        scenario.change(|s| s.wear.tool_life_factor = tool_life_factor).unwrap();
        let taylor_min = model(&scenario).wear.usual_life_min(&model(&scenario).cut).round();
        scenario.change(|s| s.life.tool_life_min = taylor_min).unwrap();
        let mut life = AdaptiveLife::new(&scenario, adjusts);
        life.to_end();
        life
    }

    #[test]
    fn tools_better_and_worse_than_taylor_reach_the_desired_tool_life() {
        for factor in [0.7, 1.0, 1.4] {
            let [fixed, adjusted] = [false, true].map(|adjusts| lived(factor, adjusts));
            let wanted = adjusted.model.life.tool_life_min;
            let error = |life: &AdaptiveLife| (life.end_min().unwrap() / wanted - 1.0).abs();
            assert!((error(&fixed) - (factor - 1.0).abs()).abs() < 0.01);
            assert!(error(&adjusted) < 0.05, "{factor}: {}", error(&adjusted));
            let speeds = adjusted.minutes().iter().map(|minute| minute.cutting_speed_m_min);
            let [least, most] = math::extent(speeds);
            let programmed = adjusted.model.cut.cutting_speed_m_min;
            assert!(least >= 0.5 * programmed && most <= 1.5 * programmed);
        }
    }

    #[test]
    fn slices_change_nothing() {
        let mut scenario = Scenario::default();
        scenario.change(|s| s.wear.tool_life_factor = 0.4).unwrap();
        let [mut whole, mut sliced] = [true, true].map(|_| AdaptiveLife::new(&scenario, true));
        whole.advance_by(60);
        (0..12).for_each(|_| {
            sliced.advance_by(5);
        });
        assert_eq!(whole.minutes(), sliced.minutes());
        assert_eq!(whole.minutes().len(), 60);
    }
}

//! The controller with preview: it knows the programmed part and sends the feed that the force will
//! allow where the command is going to act.
//!
//! ```text
//! K(x)    believed force at 100 % and place x, in units of F_ref    (preview/believed_part.rs)
//! e       = ln y - ln K(x_m) - alpha ln(v / v_prog)                 v, x_m: mean feed and middle of the
//!                                                                   last period, by the machine's reading
//! ln g   += k (e - ln g)      k = p / (p + r)                       Kalman filter of a random walk:
//! p       = (1 - k) (p + q)   r = s^2 + (d K'/K)^2                 an uncertain place says little on a slope
//! x_h     = x + way until a command has its effect                  dead time, commands on their way, lag
//! u       = [aim / (g max K(x_h - m .. x_h + m))]^(1/alpha)
//! ```
//!
//! The gain g is what the belief does not know: hardness, wear, errors of depth. e is the mean of two
//! periods, since with run-out the two teeth's peaks alternate. Because e is taken from the feed that
//! was really reached, neither the limits nor the dead time disturb the estimate: that is the
//! anti-windup, and dead time only decides how far the preview looks. The filter and the rule are
//! textbook forms, their numbers chosen.

mod believed_part;

use believed_part::BelievedPart;

use super::ControlSetup;
use super::law::{AtRest, ControlMoment};
use super::override_loop::{ForceController, ForceLaw, ForceSample, LEAST};
use crate::base::equation::number;
use crate::base::language::text;
use crate::base::math::{self, limit};
use crate::base::units::{mm_s_from_mm_min, ratio_from_percent};
use crate::models::printed::Printed;

crate::settings! {
    /// Settings of the controller with preview.
    pub struct PreviewSettings {
        /// Measured force aimed at, of the reference: the largest of a period's samples tooth by tooth
        /// carries some three deviations of the sensor's noise, and 102 % of it are the reference.
        aim_percent: f64 = 100.0, [50.0, 120.0], "%", live, "Force aimed at";
        /// Exponent alpha of the feed in the force.
        exponent: f64 = 0.8, [0.2, 1.5], "", live, "Exponent of feed";
        /// Standard deviation of the force at the first contact about the believed one.
        doubt_percent: f64 = 15.0, [1.0, 100.0], "%", live, "Doubt at first";
        /// Standard deviation of the gain's drift in a control period.
        drift_percent: f64 = 1.5, [0.1, 20.0], "%", live, "Drift of gain";
        /// Scatter of the measured gain: run-out, sensor, inhomogeneity; standard deviation.
        scatter_percent: f64 = 5.0, [0.5, 50.0], "%", live, "Scatter of gain";
        /// Half width of the window around the place ahead in which the largest believed force counts.
        margin_mm: f64 = 0.25, [0.0, 5.0], "mm", live, "Margin of place";
        /// Standard deviation of the part's true place about the believed one: a measurement taken where
        /// the believed force is steep weighs less by it.
        place_doubt_mm: f64 = 1.0, [0.0, 5.0], "mm", live, "Doubt of place";
    }
}

/// Least K: what is believed to be air may be a thin cut.
const LEAST_FORCE: f64 = 0.05;
/// Bounds of ln g.
const LOG_GAIN: f64 = 4.0;

/// The controller.
pub type Preview = ForceController<PreviewLaw>;

/// The law with its estimate.
#[derive(Clone, Debug)]
pub struct PreviewLaw {
    settings: PreviewSettings,
    part: BelievedPart,
    log_gain: f64,
    variance: f64,
    /// The last measurement of ln g, if the period before was in contact.
    before: Option<f64>,
    /// Cut and place of the period before.
    place: Option<(usize, f64)>,
}

impl PreviewLaw {
    /// Measurement of the gain from the last period: ln g and its variance.
    fn measured(&self, sample: &ForceSample, level: f64) -> (f64, f64) {
        let (input, PreviewSettings { exponent, place_doubt_mm, .. }) =
            (sample.input, &self.settings);
        let full_mm =
            mm_s_from_mm_min(input.programmed.feed_mm_min) * sample.override_loop.period_s;
        let (way_mm, middle_mm) = match self.place {
            Some((cut, x_mm)) if cut == input.cut => (input.x_mm - x_mm, 0.5 * (input.x_mm + x_mm)),
            _ => (sample.actual * full_mm, input.x_mm),
        };
        let reached = (way_mm / full_mm).max(LEAST);
        let at = |x_mm: f64| (level * self.part.at(input.cut, x_mm)).max(LEAST_FORCE);
        let here = at(middle_mm);
        let error = math::ln(sample.y) - math::ln(here) - exponent * math::ln(reached);
        let scatter = ratio_from_percent(self.settings.scatter_percent);
        let slope = 0.5 * (at(middle_mm + place_doubt_mm) - at(middle_mm - place_doubt_mm)) / here;
        (limit(error, -LOG_GAIN, LOG_GAIN), scatter * scatter + slope * slope)
    }

    fn learn(&mut self, sample: &ForceSample, level: f64) {
        let (error, noise) = self.measured(sample, level);
        let mean = self.before.map_or(error, |before| 0.5 * (before + error));
        self.before = Some(error);
        let drift = ratio_from_percent(self.settings.drift_percent);
        self.variance += drift * drift;
        let gain = self.variance / (self.variance + noise);
        self.log_gain += gain * (mean - self.log_gain);
        self.variance *= 1.0 - gain;
    }

    /// The override that the force allows where a command sent now will act.
    fn allowed(&self, sample: &ForceSample, level: f64) -> f64 {
        let (input, override_loop) = (sample.input, sample.override_loop);
        let full_mm = mm_s_from_mm_min(input.programmed.feed_mm_min) * override_loop.period_s;
        let x_mm = input.x_mm + override_loop.ahead() * full_mm;
        let at = |x_mm: f64| self.part.at(input.cut, x_mm);
        let margin_mm = self.settings.margin_mm;
        let heaviest = at(x_mm - margin_mm).max(at(x_mm)).max(at(x_mm + margin_mm));
        let force = (level * heaviest).max(LEAST_FORCE);
        let force = force / ratio_from_percent(self.settings.aim_percent);
        let log = self.log_gain + math::ln(force);
        math::exp(-log / self.settings.exponent)
    }
}

impl ForceLaw for PreviewLaw {
    type Settings = PreviewSettings;
    const ABOUT: &'static str = "Looks ahead in the programmed part: the feed that the force allows \
                                 where the command will act.";

    fn new(settings: &PreviewSettings, setup: &ControlSetup) -> Self {
        let doubt = ratio_from_percent(settings.doubt_percent);
        Self {
            settings: settings.clone(),
            part: BelievedPart::new(&setup.part, setup.tool, setup.belief),
            log_gain: 0.0,
            variance: doubt * doubt,
            before: None,
            place: None,
        }
    }

    fn configure(&mut self, settings: &PreviewSettings, setup: &ControlSetup) {
        self.settings = settings.clone();
        self.part.configure(&setup.part, setup.tool, setup.belief);
    }

    /// It looks ahead by itself.
    fn smith(_: &PreviewSettings) -> bool {
        false
    }

    fn update(&mut self, sample: &ForceSample) -> f64 {
        let level = self.part.level(sample.input, self.settings.exponent);
        if sample.entered {
            self.before = None;
        }
        self.learn(sample, level);
        self.place = Some((sample.input.cut, sample.input.x_mm));
        self.allowed(sample, level)
    }

    fn in_air(&mut self, sample: &ForceSample) -> f64 {
        let level = self.part.level(sample.input, self.settings.exponent);
        self.place = Some((sample.input.cut, sample.input.x_mm));
        self.allowed(sample, level)
    }

    fn gain(&self) -> f64 {
        math::exp(self.log_gain)
    }

    fn at_rest(_: &PreviewSettings) -> AtRest {
        AtRest::OnReference
    }

    fn believes(_: &PreviewSettings) -> &'static [&'static str] {
        &["feed_drive", "dead_time_s", "depth_error_percent", "position_error_mm"]
    }

    fn printed(_: &PreviewSettings) -> Printed {
        Printed::new(
            "u = [aim / (g max K(x_h))]^{1/α}",
            text!(
                "chosen: a Kalman filter of the gain g over the believed part; no paper prints it"
            ),
        )
    }

    fn explain(settings: &PreviewSettings, moment: &ControlMoment) -> (String, String) {
        let [margin, exponent] = [settings.margin_mm, settings.exponent].map(number);
        let aim = number(ratio_from_percent(settings.aim_percent));
        let formula = format!("u = [{aim} / (g · max K(x_h ± {margin} mm))]^{{1/{exponent}}}");
        (formula, format!("g = {}", number(moment.gain_estimate)))
    }
}

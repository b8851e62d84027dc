//! Constant feed: f_c and n_c stay at fixed overrides of the programmed values. The reference that
//! every adaptive controller is compared with; with the override sliders it is also the manual
//! mode of a machine.

use super::law::{AtRest, ControlLaw, ControlMoment, Explained, Held};
use super::{ControlInput, ControlOutput, ControlSetup, FeedSpeed, Limits};
use crate::base::equation::{Live, number};
use crate::base::language::text;
use crate::base::units::ratio_from_percent;
use crate::models::genetic::ModelSet;
use crate::models::printed::Printed;

crate::settings! {
    /// Settings of constant feed.
    pub struct ConstantFeedSettings {
        /// Feed override, in percent of the programmed feed.
        feed_percent: f64 = 100.0, [0.0, 250.0], "%", live, "Feed override";
        /// Spindle override, in percent of the programmed speed.
        speed_percent: f64 = 100.0, [0.0, 250.0], "%", live, "Spindle override";
    }
}

/// The controller; it has no state.
#[derive(Clone, Debug)]
pub struct ConstantFeed {
    settings: ConstantFeedSettings,
}

impl ControlLaw for ConstantFeed {
    type Settings = ConstantFeedSettings;
    const ABOUT: &'static str = "Programmed feed and speed at fixed overrides: what the papers call conventional, milling without control. At 100 % it cuts as the comparison `constant feed as programmed` does; the safe constant feed is the same at a feed of its own.";
    const HELD: Held = Held::Overrides;

    fn new(settings: &ConstantFeedSettings, _: &ControlSetup, _: FeedSpeed) -> Self {
        Self { settings: settings.clone() }
    }

    fn configure(&mut self, settings: &ConstantFeedSettings, _: &ControlSetup) {
        self.settings = settings.clone();
    }

    fn restart(&mut self, _: FeedSpeed) {}

    fn update(&mut self, input: &ControlInput) -> ControlOutput {
        let feed = ratio_from_percent(self.settings.feed_percent);
        let speed = ratio_from_percent(self.settings.speed_percent);
        ControlOutput {
            request: FeedSpeed {
                feed_mm_min: input.programmed.feed_mm_min * feed,
                speed_rpm: input.programmed.speed_rpm * speed,
            },
            force_setpoint_n: input.force_ref_n,
            gain_estimate: 1.0,
            feed_model_valid: true,
            speed_model_valid: true,
            exceeded: None,
            switched_off: false,
        }
    }

    /// It knows no force model: whoever sets the overrides may go as low as they do.
    fn limits(overrides: Limits) -> Limits {
        overrides
    }

    fn at_rest(_: &ConstantFeedSettings) -> AtRest {
        AtRest::WhereTheLawMeetsThePlant
    }

    fn printed(_: &ConstantFeedSettings, _: ModelSet) -> Vec<Printed> {
        vec![Printed::new(
            "f_c = override · f_p,  n_c = override · n_p",
            text!("conventional milling, which every paper compares with"),
        )]
    }

    fn explain(settings: &ConstantFeedSettings, moment: &ControlMoment) -> Explained {
        let line = |symbol: &str, percent: f64, programmed: f64, unit: &str| {
            let result = programmed * ratio_from_percent(percent);
            Live::everywhere(
                format!("{symbol}_c = override · {symbol}_p"),
                format!(
                    "{symbol}_c = {} % · {} = {} {unit}",
                    number(percent),
                    number(programmed),
                    number(result)
                ),
            )
        };
        let program = moment.programmed;
        Explained {
            lines: vec![
                line("f", settings.feed_percent, program.feed_mm_min, "mm/min"),
                line("n", settings.speed_percent, program.speed_rpm, "1/min"),
            ],
            models_at_n: None,
            beside_name: String::new(),
        }
    }
}

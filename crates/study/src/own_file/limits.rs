//! The section `[limits]` of a machine file: how far the machine goes. Every entry is a setting of the command channel or
//! of the spindle drive, with that setting's range.

use serde::Deserialize;

use super::entry::FileEntry;
use super::machine::WHAT;
use crate::base::language::tr;
use crate::base::settings::{Kind, SettingError, Value};
use crate::run::scenario::param;

const SECTION: &str = "limits";

macro_rules! limits {
    ($( $(#[doc = $doc:literal])+ $key:ident = $path:literal $(, $switch:literal)?; )+) => {
        /// How far a machine goes; what is left out stays as the scenario has it.
        #[derive(Clone, Debug, Default, PartialEq, Deserialize)]
        #[serde(deny_unknown_fields, expecting = "limits of a machine")]
        pub struct OwnLimits {
            $( $(#[doc = $doc])+ pub $key: Option<f64>, )+
        }

        impl OwnLimits {
            /// The entries that are given: name, value, and the setting that it is.
            fn given(&self) -> impl Iterator<Item = (&'static str, f64, &'static str)> {
                let all = [$( (stringify!($key), self.$key, $path), )+];
                all.into_iter().filter_map(|(key, value, path)| Some((key, value?, path)))
            }

            /// The settings that it makes; a limit that is off by default is switched on.
            pub(super) fn changes(&self) -> Vec<(String, Value)> {
                let mut changes = Vec::new();
                $( if let Some(value) = self.$key {
                    $( changes.push(($switch.to_owned(), Value::Bool(true))); )?
                    changes.push(($path.to_owned(), Value::Float(value)));
                } )+
                changes
            }
        }
    };
}

limits! {
    /// Largest feed, mm/min.
    feed_max_mm_min = "cnc.feed_max_mm_min";
    /// Least spindle speed, 1/min.
    speed_min_rpm = "cnc.speed_min_rpm";
    /// Largest spindle speed, 1/min.
    speed_max_rpm = "cnc.speed_max_rpm";
    /// Fastest change of the spindle speed, 1/min in a second.
    speed_rate_rpm_s = "spindle_drive.rate_rpm_s";
    /// Least override, percent.
    override_min_percent = "cnc.override_min_percent";
    /// Largest override, percent.
    override_max_percent = "cnc.override_max_percent";
    /// Fastest change of an override, percent in a second.
    override_rate_percent_s = "cnc.override_rate_percent_s", "cnc.override_rate_limited";
    /// Force that stops the feed, N.
    stop_force_n = "cnc.force_stop_n", "cnc.force_stop";
}

impl OwnLimits {
    /// Checks what was read of a file; `own_spindle` says that the file has poles of a spindle drive, too.
    pub(super) fn checked(self, file: &str, own_spindle: bool) -> Result<Self, SettingError> {
        let at = |key| FileEntry { what: WHAT, text: file, section: SECTION, key };
        for (key, value, path) in self.given() {
            if let Kind::Float { min, max } = param(path)?.spec.allowed {
                at(key).number(value, [min, max])?;
            }
        }
        if let (Some(least), Some(most)) = (self.speed_min_rpm, self.speed_max_rpm)
            && least > most
        {
            let allowed = tr!("at most `speed_max_rpm`, {most} 1/min", most = most);
            return Err(at("speed_min_rpm").refused(&least.to_string(), &allowed));
        }
        if self.speed_rate_rpm_s.is_some() && own_spindle {
            let problem = tr("[spindle_drive] stands in the place of lag and rate limit");
            return Err(at("speed_rate_rpm_s").fault(problem));
        }
        if self == Self::default() {
            return Err(SettingError::Format {
                what: tr(WHAT).to_owned(),
                problem: tr("there is nothing in [limits]").to_owned(),
            });
        }
        Ok(self)
    }
}

//! Why a run is over: an id for programs, what belongs to it in fields of its own, and words for people.

use serde::Serialize;

use super::closed_loop::{Fault, ScriptFault};
use crate::base::language::tr;
use crate::base::settings::SettingError;
use crate::blocks::cnc::overload::Overload;
use crate::blocks::cutting::breakage::Breakage;
use crate::blocks::cutting::crash::Crash;

crate::choice! {
    /// The ids of [`End`].
    pub enum EndId {
        /// The whole path is cut.
        PathDone = "path_done", "Cut finished";
        /// The time limit came first.
        TimeLimit = "time_limit", "Ended by the time limit";
        /// Too large a force stopped the feed; its details are force_n, limit_n, position_mm,
        /// time_s, retracted.
        Overload = "overload", "Stopped by an overload";
        /// The tool was fed into the work without cutting its way; its details are feed_mm_min, speed_rpm,
        /// radius_mm, position_mm, time_s.
        Crash = "crash", "Ended by a crash";
        /// The last tooth broke, or the first one in a machine that counts them; its details are by, load, stands,
        /// broken, position_mm, time_s.
        Breakage = "breakage", "Ended by a broken tool";
        /// A signal stopped being finite; its details are signal, tick.
        Fault = "fault", "Ended by a fault";
        /// An edit does not fit the scenario; its details are path, value, allowed.
        Refused = "refused", "An edit was refused";
        /// The controller's script failed; its details are line, what, time_s.
        Script = "script", "Ended by a fault of the script";
    }
}

/// Why a run is over. As JSON, `end` is the id and `end_details` holds what belongs to it, if anything
/// does.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "end", content = "end_details", rename_all = "snake_case")]
pub enum End {
    /// The whole path is cut.
    PathDone,
    /// The time limit came first.
    TimeLimit,
    /// An overload stopped the feed.
    Overload(Overload),
    /// The tool was fed into the work without cutting its way.
    Crash(Crash),
    /// The tool broke.
    Breakage(Breakage),
    /// A signal stopped being finite.
    Fault(Fault),
    /// An edit does not fit the scenario: it was pushed to the edits of another one.
    Refused(SettingError),
    /// The controller's script failed.
    Script(ScriptFault),
}

impl End {
    /// Its id.
    #[must_use]
    pub fn id(&self) -> EndId {
        match self {
            Self::PathDone => EndId::PathDone,
            Self::TimeLimit => EndId::TimeLimit,
            Self::Overload(_) => EndId::Overload,
            Self::Crash(_) => EndId::Crash,
            Self::Breakage(_) => EndId::Breakage,
            Self::Fault(_) => EndId::Fault,
            Self::Refused(_) => EndId::Refused,
            Self::Script(_) => EndId::Script,
        }
    }

    /// Whether the run failed: what was recorded is right, but it is not the run that was asked for.
    #[must_use]
    pub fn failed(&self) -> bool {
        match self {
            Self::PathDone
            | Self::TimeLimit
            | Self::Overload(_)
            | Self::Crash(_)
            | Self::Breakage(_) => false,
            Self::Fault(_) | Self::Refused(_) | Self::Script(_) => true,
        }
    }
}

/// In words.
impl std::fmt::Display for End {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::PathDone | Self::TimeLimit => f.write_str(tr(self.id().label())),
            Self::Overload(stop) => stop.fmt(f),
            Self::Crash(crash) => crash.fmt(f),
            Self::Breakage(broke) => broke.fmt(f),
            Self::Fault(fault) => fault.fmt(f),
            Self::Refused(refused) => refused.fmt(f),
            Self::Script(fault) => fault.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::control::script::ScriptProblem;
    use crate::blocks::cutting::breakage::BreaksBy;

    #[test]
    fn every_end_is_an_id_with_its_details_in_fields_of_their_own() {
        let overload = Overload {
            force_n: 2100.0,
            limit_n: 2000.0,
            position_mm: 12.0,
            time_s: 1.5,
            retracted: false,
        };
        let [path, value, allowed] = ["target.ra_um", "9 um", "less"].map(str::to_owned);
        let crash = Crash {
            feed_mm_min: 430.0,
            speed_rpm: 9.0,
            radius_mm: 8.0,
            position_mm: 12.0,
            time_s: 1.5,
        };
        let of_overload = ["force_n", "limit_n", "position_mm", "retracted", "time_s"];
        let of_crash = ["feed_mm_min", "position_mm", "radius_mm", "speed_rpm", "time_s"];
        let breakage = Breakage {
            by: BreaksBy::Chip,
            load: 0.7,
            stands: 0.6,
            broken: 2,
            position_mm: 12.0,
            time_s: 1.5,
        };
        let of_breakage = ["broken", "by", "load", "position_mm", "stands", "time_s"];
        let script = ScriptFault {
            problem: ScriptProblem { line: Some(3), what: "no".to_owned() },
            time_s: 1.5,
        };
        let all: [(End, &[&str]); 8] = [
            (End::PathDone, &[]),
            (End::TimeLimit, &[]),
            (End::Overload(overload), &of_overload),
            (End::Crash(crash), &of_crash),
            (End::Breakage(breakage), &of_breakage),
            (End::Fault(Fault { signal: "force_n", tick: 7 }), &["signal", "tick"]),
            (
                End::Refused(SettingError::Refused { path, value, allowed }),
                &["allowed", "error", "path", "value"],
            ),
            (End::Script(script), &["line", "time_s", "what"]),
        ];
        assert_eq!(EndId::ALL, all.each_ref().map(|(end, _)| end.id()), "every id is tried here");
        for (end, details) in all {
            let json = serde_json::to_value(&end).unwrap();
            assert_eq!(json["end"], end.id().id());
            let found = json.get("end_details").and_then(|found| found.as_object());
            let mut found: Vec<&str> =
                found.map_or(Vec::new(), |found| found.keys().map(String::as_str).collect());
            found.sort_unstable();
            assert_eq!(found, details, "{json}");
            assert!(!end.to_string().is_empty());
        }
    }
}

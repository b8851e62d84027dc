//! The shipped missions, in the order in which they teach. A new one is a file in `assets/missions` and a line here.

use super::{Mission, MissionError};
use crate::base::language::tr;

/// A shipped mission.
#[derive(Clone, Copy, Debug)]
pub struct ShippedMission {
    /// Its id.
    pub id: &'static str,
    /// The mission's file.
    pub text: &'static str,
}

macro_rules! missions {
    ($($id:literal,)+) => {
        /// All shipped missions.
        pub const MISSIONS: &[ShippedMission] = &[
            $( ShippedMission {
                id: $id,
                text: include_str!(concat!("../../../../assets/missions/", $id, ".toml")),
            }, )+
        ];
    };
}

missions! {
    "depth-step-at-constant-feed",
    "gain-leaves-an-error",
    "integral-action-holds",
    "dead-time-against-gain",
    "smith-predictor",
    "noise-against-tolerance",
    "another-material",
    "wear-heard-and-seen",
    "choose-for-the-2005-part",
    "beat-it-by-hand",
    "teach-in-feed-control",
    "quiet-speed",
    "plan-and-what-binds",
    "outside-its-range",
    "read-the-errata",
}

/// The mission that comes after the one with this id.
#[must_use]
pub fn after(id: &str) -> Option<&'static ShippedMission> {
    let place = MISSIONS.iter().position(|mission| mission.id == id)?;
    MISSIONS.get(place + 1)
}

/// Whether the last mission has this id.
#[must_use]
pub fn is_last(id: &str) -> bool {
    MISSIONS.last().is_some_and(|mission| mission.id == id)
}

/// The shipped mission with this id.
///
/// # Errors
/// There is none of this id; the message lists all.
pub fn load(id: &str) -> Result<Mission, MissionError> {
    let Some(mission) = MISSIONS.iter().find(|mission| mission.id == id) else {
        let all: Vec<&str> = MISSIONS.iter().map(|mission| mission.id).collect();
        let id: String = id.chars().take(60).collect();
        let problem = tr!(
            "there is none with the id `{id}`; there are {list}",
            id = id,
            list = all.join(", ")
        );
        return Err(MissionError::of_mission(problem));
    };
    Mission::read(mission.text)
}

//! The way as a file, to go on with later with the same bits: its searches, which are most of it. Cuts are measured
//! anew and rows run anew, by the same draws.

use serde::{Deserialize, Serialize};

use super::WaySettings;
use super::job::WayJob;
use super::models::FoundRole;
use crate::base::files::from_json;
use crate::base::language::tr;
use crate::identify::gp::state::GpState;

/// Version of the format.
const VERSION: u64 = 1;

/// What the way is at any time.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a saved way")]
struct WayState {
    version: u64,
    /// How it is gone, but for the number of batches: more may follow.
    settings: String,
    /// A search for each model; none that was not begun.
    searches: Vec<Option<GpState>>,
}

/// What the searches depend on.
fn told(settings: &WaySettings) -> String {
    format!("{:?}", WaySettings { batches: 0, ..settings.clone() })
}

impl WayJob {
    /// The text of a file of it.
    #[must_use]
    pub fn state_text(&self) -> String {
        let state = WayState {
            version: VERSION,
            settings: told(self.settings()),
            searches: self.searches(),
        };
        serde_json::to_string(&state).unwrap_or_default()
    }

    /// Goes on where a file left off; to be asked for before it is begun.
    ///
    /// # Errors
    /// The text is no such file, of another version, or of a way with other settings.
    pub fn resume(&mut self, text: &str) -> Result<(), String> {
        let state: WayState = from_json(text)?;
        if state.version != VERSION {
            let version = state.version;
            return Err(tr!(
                "`version` cannot be {version}: allowed is {allowed}",
                version = version,
                allowed = VERSION
            ));
        }
        let own = told(self.settings());
        if state.settings != own {
            return Err(tr!(
                "it was gone with other settings, and all but the number of batches have to be as they were: with \
                 {found}, not {own}",
                found = state.settings,
                own = own
            ));
        }
        let (count, models) = (state.searches.len(), FoundRole::ALL.len());
        if count != models {
            return Err(tr!(
                "`searches` cannot be {count}: allowed is {allowed}",
                count = count,
                allowed = models
            ));
        }
        self.go_on_with(state.searches);
        Ok(())
    }
}

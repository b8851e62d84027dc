//! A search as a file, to go on with later with the same bits.

use serde::{Deserialize, Serialize};

use super::archive::Archive;
use super::job::GpJob;
use super::problem::GpProblem;
use crate::base::files::from_json;
use crate::base::language::tr;
use crate::run::digest::Digest;

/// Version of the format.
const VERSION: u64 = 1;

/// What a search is at the end of a batch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a saved search")]
pub struct GpState {
    version: u64,
    /// Digest of the rows, columns and settings that the search depends on.
    problem: String,
    pub(super) batch: u64,
    pub(super) evaluations: u64,
    pub(super) gained: u64,
    pub(super) exact: Option<u64>,
    pub(super) islands: Vec<Archive>,
    pub(super) best: Archive,
    pub(super) calm: Archive,
}

/// Digest of what a search depends on besides the number of its batches.
fn digest(problem: &GpProblem, seed: u64) -> String {
    let mut digest = Digest::default();
    digest.word(seed);
    for text in [&problem.target].into_iter().chain(&problem.inputs) {
        text.bytes().for_each(|byte| digest.word(u64::from(byte)));
        digest.word(u64::MAX);
    }
    // Units and the like, as they are printed.
    format!("{:?}{:?}", problem.rule, problem.template)
        .bytes()
        .for_each(|byte| digest.word(u64::from(byte)));
    for text in &problem.told {
        text.bytes().for_each(|byte| digest.word(u64::from(byte)));
    }
    for column in problem.rows.inputs.iter().chain([&problem.rows.target]) {
        column.iter().for_each(|x| digest.word(x.to_bits()));
    }
    digest.hex()
}

impl GpState {
    /// Whether a text looks like a file of a search, sound or not.
    #[must_use]
    pub fn is_meant_by(text: &str) -> bool {
        let read = serde_json::from_str::<serde_json::Value>(text);
        read.is_ok_and(|file| file.get("islands").is_some() && file.get("problem").is_some())
    }
}

impl GpJob {
    /// The search at the end of its last batch; a batch under way is begun anew when it goes on.
    #[must_use]
    pub fn state(&self) -> GpState {
        let search = self.search();
        GpState {
            version: VERSION,
            problem: digest(self.problem(), self.settings().seed),
            batch: search.batch,
            evaluations: search.evaluations,
            gained: search.gained,
            exact: search.exact,
            islands: search.islands.clone(),
            best: search.best.clone(),
            calm: search.calm.clone(),
        }
    }

    /// The text of a file of it.
    #[must_use]
    pub fn state_text(&self) -> String {
        serde_json::to_string(&self.state()).unwrap_or_default()
    }

    /// Goes on where a file left off.
    ///
    /// # Errors
    /// The text is no such file, of another version, or of another table, other columns or another seed.
    pub fn resume(&mut self, text: &str) -> Result<(), String> {
        self.resume_state(from_json(text)?)
    }

    /// Goes on where a state left off.
    ///
    /// # Errors
    /// As [`Self::resume`].
    pub fn resume_state(&mut self, state: GpState) -> Result<(), String> {
        if state.version != VERSION {
            let version = state.version;
            return Err(tr!(
                "`version` cannot be {version}: allowed is {allowed}",
                version = version,
                allowed = VERSION
            ));
        }
        if state.problem != digest(self.problem(), self.settings().seed) {
            let problem = tr(
                "the search was of another table, of other columns, units or another seed: all of these have to be as \
                 they were",
            );
            return Err(problem.to_owned());
        }
        self.search_mut().go_on(state)
    }
}

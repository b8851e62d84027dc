//! Why a setting was refused.

use serde::Serialize;

/// Why a setting was refused; the text names field, value and what is allowed. As JSON, `error` is the
/// id of the case.
#[derive(Clone, Debug, PartialEq, Serialize, thiserror::Error)]
#[serde(tag = "error", rename_all = "snake_case")]
pub enum SettingError {
    /// No setting has this path.
    #[error("unknown setting `{path}`; {}", instead(suggestion.as_deref()))]
    Unknown {
        /// The path given.
        path: String,
        /// The nearest known path.
        suggestion: Option<String>,
    },
    /// The value does not fit.
    #[error("`{path}` cannot be {value}: allowed is {allowed}")]
    Refused {
        /// The setting's path.
        path: String,
        /// The value given.
        value: String,
        /// What is allowed.
        allowed: String,
    },
    /// The text is not in the expected format.
    #[error("{what}: {problem}")]
    Format {
        /// What was read (a file, a link, an argument).
        what: String,
        /// What is wrong with it.
        problem: String,
    },
}

/// What to do about an unknown setting.
fn instead(near: Option<&str>) -> String {
    near.map_or_else(
        || "`list` prints all settings".to_owned(),
        |near| format!("did you mean `{near}`?"),
    )
}

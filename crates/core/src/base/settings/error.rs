//! Why a setting was refused.

use serde::Serialize;

use crate::base::language::tr;

/// Why a setting was refused; the text names field, value and what is allowed. As JSON, `error` is the
/// id of the case.
#[derive(Clone, Debug, PartialEq, Serialize, thiserror::Error)]
#[serde(tag = "error", rename_all = "snake_case")]
pub enum SettingError {
    /// No setting has this path.
    #[error("{}", unknown(path, suggestion.as_deref()))]
    Unknown {
        /// The path given.
        path: String,
        /// The nearest known path.
        suggestion: Option<String>,
    },
    /// The value does not fit.
    #[error("{}", refused(path, value, allowed))]
    Refused {
        /// The setting's path.
        path: String,
        /// The value given.
        value: String,
        /// What is allowed.
        allowed: String,
    },
    /// The setting is not open where it was to be changed, whatever the value.
    #[error("{because}")]
    Closed {
        /// The setting's path.
        path: String,
        /// Why, in words that name the setting and what opens it.
        because: String,
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

/// That a setting is unknown, and what to do about it.
fn unknown(path: &str, near: Option<&str>) -> String {
    match near {
        Some(near) => {
            tr!("unknown setting `{path}`; did you mean `{near}`?", path = path, near = near)
        }
        None => tr!("unknown setting `{path}`; `list` prints all settings", path = path),
    }
}

fn refused(path: &str, value: &str, allowed: &str) -> String {
    tr!(
        "`{path}` cannot be {value}: allowed is {allowed}",
        path = path,
        value = value,
        allowed = allowed
    )
}

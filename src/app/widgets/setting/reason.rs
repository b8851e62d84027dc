//! Why a setting is greyed, in the words of the screen: reasons name other settings by their paths in files, the
//! screen by what stands beside their fields.

use crate::base::language::tr;
use crate::run::scenario::{Param, param, table};

/// A reason, and the settings that it is about.
#[derive(Clone, Debug)]
pub struct Reason {
    /// In words.
    pub text: String,
    /// The settings that decide it, each once.
    pub settings: Vec<&'static Param>,
}

impl Reason {
    /// That of a text with paths and values between backticks.
    #[must_use]
    pub fn of(because: &str) -> Self {
        let mut reason = Self { text: String::new(), settings: Vec::new() };
        for (i, piece) in because.split('`').enumerate() {
            // Every second piece stands between two of them.
            match param(piece).ok().filter(|_| i % 2 == 1) {
                Some(param) => {
                    reason.text += &name(param);
                    if reason.settings.iter().all(|other| other.path != param.path) {
                        reason.settings.push(param);
                    }
                }
                None => reason.text += piece,
            }
        }
        reason
    }
}

/// What stands beside a setting's field; with its path where several have the same.
fn name(param: &Param) -> String {
    let label = param.spec.label;
    let others = table().iter().filter(|other| other.spec.label == label).count() > 1;
    match others {
        true => format!("“{}” ({})", tr(label), param.path),
        false => format!("“{}”", tr(label)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::scenario::{ANOTHER_CONTROLLER, UNUSED};
    use std::collections::BTreeSet;

    #[test]
    fn settings_have_the_names_of_their_fields() {
        let reason = Reason::of(ANOTHER_CONTROLLER);
        assert_eq!(reason.text, "“Controller” is another one");
        assert_eq!(reason.settings.len(), 1);
        assert_eq!(reason.settings[0].path, "controller.kind");
        // Without any, and with a word that is none.
        assert_eq!(Reason::of("nothing vibrates").text, "nothing vibrates");
        assert_eq!(Reason::of("a `word` of files").text, "a word of files");
    }

    /// All that is told between backticks is a setting, so that none of it is left in the language of files.
    #[test]
    fn every_reason_is_read_whole() {
        for row in UNUSED {
            let named: BTreeSet<&str> = row.because.split('`').skip(1).step_by(2).collect();
            let reason = Reason::of(row.because);
            assert_eq!(reason.settings.len(), named.len(), "{}", row.because);
            assert!(!reason.text.contains('`'));
        }
    }
}

//! What of the program a page that embeds it shows and lets be changed: the flags behind `embed=` in a link or after
//! `--embed`, separated by commas: `hide:bar,lock:target.ra_um,screen:learn,lang:en`.

use std::collections::BTreeSet;

use crate::base::language::{Language, tr};
use crate::run::scenario::{param, table};

/// What stands before the flags in a link.
pub const EMBED: &str = "embed=";

/// A part of the program that can be hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FramePart {
    /// The strip at the head.
    Bar,
    /// The list of screens, and every other way to one.
    Screens,
    /// Open, save, export, link.
    Files,
    /// The search.
    Find,
    /// The strip at the foot, with the playhead.
    Transport,
    /// The settings beside the plots of the console.
    Settings,
}

impl FramePart {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Bar, Self::Screens, Self::Files, Self::Find, Self::Transport, Self::Settings];

    /// Its name in links.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Bar => "bar",
            Self::Screens => "screens",
            Self::Files => "files",
            Self::Find => "find",
            Self::Transport => "transport",
            Self::Settings => "settings",
        }
    }
}

/// What is hidden, locked and chosen; nothing of it by default.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Frame {
    hidden: BTreeSet<FramePart>,
    locked: BTreeSet<String>,
    screen: Option<String>,
    language: Option<Language>,
    flags: Vec<String>,
}

impl Frame {
    /// Takes in the flags of a text; gives what is wrong with those that are not obeyed.
    pub fn take(&mut self, text: &str) -> Vec<String> {
        let mut problems = Vec::new();
        for flag in text.split(',').map(str::trim).filter(|flag| !flag.is_empty()) {
            match self.take_one(flag) {
                Ok(()) => self.flags.push(flag.to_owned()),
                Err(problem) => problems.push(problem),
            }
        }
        problems
    }

    fn take_one(&mut self, flag: &str) -> Result<(), String> {
        let shown: String = flag.chars().take(60).collect();
        let (name, value) = flag.split_once(':').unwrap_or((flag, ""));
        match name {
            "hide" => match FramePart::ALL.into_iter().find(|part| part.id() == value) {
                Some(part) => {
                    self.hidden.insert(part);
                    Ok(())
                }
                None => Err(tr!(
                    "embed: `{flag}`: allowed behind hide: are {list}",
                    flag = shown,
                    list = listed(FramePart::ALL.map(FramePart::id))
                )),
            },
            "lock" => match locked_by(value) {
                Some(paths) => {
                    self.locked.extend(paths);
                    Ok(())
                }
                None => Err(tr!(
                    "embed: `{flag}`: allowed behind lock: are all, a setting, or a group of settings: {list}",
                    flag = shown,
                    list = listed(groups())
                )),
            },
            "screen" if !value.is_empty() => {
                self.screen = Some(value.to_owned());
                Ok(())
            }
            "screen" => {
                Err(tr!("embed: `{flag}`: allowed behind screen: is the name of one", flag = shown))
            }
            "lang" => match Language::ALL.iter().find(|language| language.id() == value) {
                Some(language) => {
                    self.language = Some(*language);
                    Ok(())
                }
                None => Err(tr!(
                    "embed: `{flag}`: allowed behind lang: are {list}",
                    flag = shown,
                    list = listed(Language::ALL.iter().map(|language| language.id()))
                )),
            },
            _ => Err(tr!(
                "embed: `{flag}`: allowed are hide, lock, screen and lang, each with a colon and its value",
                flag = shown
            )),
        }
    }

    /// Whether a part is hidden.
    #[must_use]
    pub fn hides(&self, part: FramePart) -> bool {
        self.hidden.contains(&part)
    }

    /// The settings that cannot be changed, by their paths.
    #[must_use]
    pub fn locked(&self) -> &BTreeSet<String> {
        &self.locked
    }

    /// The screen to begin with, if one was named.
    #[must_use]
    pub fn screen(&self) -> Option<&str> {
        self.screen.as_deref()
    }

    /// The language to begin with, if one was named.
    #[must_use]
    pub fn language(&self) -> Option<Language> {
        self.language
    }

    /// The part of a link that says the same, with what is obeyed; empty where there is nothing.
    #[must_use]
    pub fn write(&self) -> String {
        if self.flags.is_empty() {
            String::new()
        } else {
            format!("{EMBED}{}", self.flags.join(","))
        }
    }
}

fn listed(names: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    let names: Vec<String> = names.into_iter().map(|name| name.as_ref().to_owned()).collect();
    names.join(", ")
}

/// The groups of settings, in the order of the table.
fn groups() -> Vec<&'static str> {
    let mut groups: Vec<&str> = Vec::new();
    for param in table() {
        let group = param.path.rsplit_once('.').map_or("", |(group, _)| group);
        if !group.is_empty() && !groups.contains(&group) {
            groups.push(group);
        }
    }
    groups
}

/// The settings that a name stands for: all, those of a group with the groups in it, or one.
fn locked_by(name: &str) -> Option<Vec<String>> {
    if let Ok(param) = param(name) {
        return Some(vec![param.path.clone()]);
    }
    let within = format!("{name}.");
    let paths = table().iter().map(|param| param.path.clone());
    let paths: Vec<String> =
        paths.filter(|path| name == "all" || path.starts_with(&within)).collect();
    (!paths.is_empty()).then_some(paths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_hide_lock_and_choose() {
        let mut frame = Frame::default();
        let flags =
            "hide:bar,hide:transport,lock:target.ra_um,lock:controller,screen:learn,lang:en";
        assert_eq!(frame.take(flags), [""; 0]);
        assert!(frame.hides(FramePart::Bar) && frame.hides(FramePart::Transport));
        assert!(!frame.hides(FramePart::Files));
        for path in ["target.ra_um", "controller.kind", "controller.afc.references_n"] {
            assert!(frame.locked().contains(path), "{path}");
        }
        assert!(!frame.locked().contains("target.force_n"));
        assert_eq!(frame.screen(), Some("learn"));
        assert_eq!(frame.write(), format!("embed={flags}"));
        let mut all = Frame::default();
        assert_eq!(all.take("lock:all"), [""; 0]);
        assert_eq!(all.locked().len(), table().len());
        assert_eq!(Frame::default().write(), "");
    }

    #[test]
    fn what_is_unknown_is_named_with_what_is_allowed_and_the_rest_is_obeyed() {
        for (flag, words) in [
            ("hid:bar", ["`hid:bar`", "hide, lock, screen and lang"]),
            ("hide:foot", ["`hide:foot`", "bar, screens, files, find, transport, settings"]),
            ("hide", ["`hide`", "transport"]),
            ("lock:targt", ["`lock:targt`", "target, "]),
            ("lock:", ["`lock:`", "all, a setting"]),
            ("screen", ["`screen`", "the name of one"]),
            ("lang:fr", ["`lang:fr`", "behind lang: are en, sl, de"]),
        ] {
            let mut frame = Frame::default();
            let problems = frame.take(&format!("{flag},hide:files"));
            let [said] = problems.as_slice() else { panic!("{problems:?}") };
            words.iter().for_each(|word| assert!(said.contains(word), "{said} lacks {word}"));
            assert!(frame.hides(FramePart::Files));
            assert_eq!(frame.write(), "embed=hide:files");
        }
    }
}

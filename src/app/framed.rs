//! What a page that embeds the console hides and locks (see [`crate::study::opening::Frame`]), and what a mission opens
//! and offers.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use egui::{Context, Id};

use super::command::{Command, FileCommand, LibraryCommand, ShellCommand};
use super::session::{LOCKED, MissionLock};
use crate::base::language::tr;
use crate::study::opening::{Frame, FramePart};

fn id() -> Id {
    Id::unique("locked settings")
}

/// Notes which settings are locked, for their editors.
pub fn lock(ctx: &Context, paths: &BTreeSet<String>) {
    let known = ctx.data(|data| data.get_temp::<Arc<BTreeSet<String>>>(id()));
    if known.map_or(!paths.is_empty(), |known| *known != *paths) {
        ctx.data_mut(|data| data.insert_temp(id(), Arc::new(paths.clone())));
    }
}

/// Whether a setting is locked.
#[must_use]
pub fn is_locked(ctx: &Context, path: &str) -> bool {
    let locked = ctx.data(|data| data.get_temp::<Arc<BTreeSet<String>>>(id()));
    locked.is_some_and(|paths| paths.contains(path))
}

/// What the mission under way opens.
#[derive(Clone, Debug, PartialEq)]
struct Opened {
    title: String,
    paths: Vec<String>,
}

fn opened_id() -> Id {
    Id::unique("settings that a mission opens")
}

/// Notes which settings the mission under way opens, for all that changes settings.
pub fn open(ctx: &Context, mission: Option<&MissionLock>) {
    let opened = mission.map(|lock| Opened { title: lock.title.clone(), paths: lock.open.clone() });
    let known = ctx.data(|data| data.get_temp::<Arc<Opened>>(opened_id()));
    if known.as_deref() != opened.as_ref() {
        ctx.data_mut(|data| match opened {
            Some(opened) => {
                data.insert_temp(opened_id(), Arc::new(opened));
            }
            None => data.remove::<Arc<Opened>>(opened_id()),
        });
    }
}

/// Why a setting cannot be changed, in a sentence: it is locked, or the mission under way does not open it.
#[must_use]
pub fn closed(ctx: &Context, path: &str) -> Option<String> {
    if is_locked(ctx, path) {
        return Some(tr!("Cannot be changed: it is {locked}.", locked = tr(LOCKED)));
    }
    let opened = ctx.data(|data| data.get_temp::<Arc<Opened>>(opened_id()))?;
    if opened.paths.iter().any(|open| open == path) {
        return None;
    }
    Some(tr!(
        "Locked: the mission \u{201c}{title}\u{201d} does not open it. Leave the mission to change it.",
        title = tr(&opened.title)
    ))
}

/// The options of settings that are choices, by their paths.
type Offered = BTreeMap<String, Vec<String>>;

fn offered_id() -> Id {
    Id::unique("offered options")
}

/// Notes which options a mission offers, for the editors of the settings.
pub fn offer(ctx: &Context, options: Option<&Offered>) {
    let known = ctx.data(|data| data.get_temp::<Arc<Offered>>(offered_id())).unwrap_or_default();
    let none = Offered::new();
    let options = options.unwrap_or(&none);
    if *known != *options {
        ctx.data_mut(|data| data.insert_temp(offered_id(), Arc::new(options.clone())));
    }
}

/// Whether an option of a setting is offered.
#[must_use]
pub fn is_offered(ctx: &Context, path: &str, id: &str) -> bool {
    let offered = ctx.data(|data| data.get_temp::<Arc<Offered>>(offered_id()));
    let offered = offered.as_ref().and_then(|offered| offered.get(path));
    offered.is_none_or(|options| options.iter().any(|offered| offered == id))
}

/// Why a command is not carried out while the screen `shown` is: a key, a drop or the search leads to what is hidden.
#[must_use]
pub fn refused(frame: &Frame, shown: &str, command: &Command) -> Option<String> {
    let (part, text) = match command {
        Command::Shell(ShellCommand::ShowScreen(id) | ShellCommand::ShowPart(id, _))
            if *id != shown =>
        {
            let text =
                tr("The address that this was opened with hides other screens (hide:screens).");
            (FramePart::Screens, text)
        }
        Command::Shell(ShellCommand::ShowSearch(true)) => {
            let text = tr("The address that this was opened with hides the search (hide:find).");
            (FramePart::Find, text)
        }
        Command::File(
            FileCommand::Open
            | FileCommand::Save
            | FileCommand::ExportCsv
            | FileCommand::CopyLink
            | FileCommand::CopyLinkTo(_)
            | FileCommand::CopyText { .. },
        )
        | Command::Library(
            LibraryCommand::Show { open: true, .. }
            | LibraryCommand::Use(_)
            | LibraryCommand::UseFormula { .. }
            | LibraryCommand::KeepOpened(_)
            | LibraryCommand::KeepPresent(_)
            | LibraryCommand::Begin(_)
            | LibraryCommand::Remove(_)
            | LibraryCommand::Download(_)
            | LibraryCommand::AskFolder
            | LibraryCommand::Choose(_),
        ) => {
            let text =
                tr("The address that this was opened with hides files and links (hide:files).");
            (FramePart::Files, text)
        }
        Command::Session(_)
        | Command::Playback(_)
        | Command::File(_)
        | Command::Shell(_)
        | Command::Library(
            LibraryCommand::Show { open: false, .. }
            | LibraryCommand::Opened(_)
            | LibraryCommand::Kept(_)
            | LibraryCommand::LookAgain,
        ) => return None,
    };
    frame.hides(part).then(|| text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_hidden_is_not_reached_by_keys_either() {
        let mut frame = Frame::default();
        let link = Command::File(FileCommand::CopyLink);
        let screen = |id| Command::Shell(ShellCommand::ShowScreen(id));
        let find = |open| Command::Shell(ShellCommand::ShowSearch(open));
        let mine = Command::Library(LibraryCommand::Show { open: true, kind: None });
        for command in [&link, &screen("plan"), &find(true), &mine] {
            assert_eq!(refused(&frame, "learn", command), None);
        }
        assert_eq!(frame.take("hide:screens,hide:files,hide:find"), [""; 0]);
        for (command, word) in [
            (&link, "hide:files"),
            (&mine, "hide:files"),
            (&screen("plan"), "hide:screens"),
            (&find(true), "hide:find"),
        ] {
            assert!(refused(&frame, "learn", command).is_some_and(|said| said.contains(word)));
        }
        for command in [&screen("learn"), &find(false)] {
            assert_eq!(refused(&frame, "learn", command), None);
        }
    }
}

//! Everything that can be done in the console. Panels read a view and push commands; the console
//! alone carries them out, so buttons, keys, tests and scripts go the same way. Each kind of
//! command is carried out in one place, by a `match` over all of it.

use super::panels::BroughtFile;
use super::playback::Speed;
use crate::base::settings::Value;

/// One thing to do, by the part of the console that does it.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Scenario, edits and messages: [`super::session::Session::execute`].
    Session(SessionCommand),
    /// The playhead: [`super::session::Session::play`].
    Playback(PlaybackCommand),
    /// Files and the clipboard.
    File(FileCommand),
    /// What surrounds the screens.
    Shell(ShellCommand),
}

impl Command {
    /// Sets one setting.
    #[must_use]
    pub fn set(path: &str, value: Value) -> Self {
        Self::Session(SessionCommand::Set { path: path.to_owned(), value })
    }

    /// Sets a formula of one's own, or takes it away.
    #[must_use]
    pub fn set_formula(path: &str, value: Value) -> Self {
        Self::Session(SessionCommand::SetFormula { path: path.to_owned(), value })
    }

    /// Shows a message.
    #[must_use]
    pub fn notify(text: String) -> Self {
        Self::Session(SessionCommand::Notify(text))
    }
}

/// What changes scenario and edits, and what is said about it.
#[derive(Clone, Debug, PartialEq)]
pub enum SessionCommand {
    /// Changes a setting: at the playhead of a running cut if the setting is live, otherwise in
    /// the scenario itself.
    Set {
        /// Path of the setting, as in the table of settings.
        path: String,
        /// The new value; a refused one becomes a notice.
        value: Value,
    },
    /// Sets a formula of one's own, or takes it away, where [`Self::Set`] would; the calibrations that ask for
    /// formulas of models go with it, in one step of undo.
    SetFormula {
        /// Path of the setting.
        path: String,
        /// The new value; a refused one becomes a notice.
        value: Value,
    },
    /// The same with the text of a model file.
    LoadFormula {
        /// Path of the setting.
        path: String,
        /// Where it came from, for messages.
        name: String,
        /// The file's text.
        text: String,
    },
    /// Changes settings of the scenario itself, all or none, in one step of undo, wherever the
    /// playhead stands: paths with their new values. A refused one becomes a notice.
    SetUp(Vec<(String, Value)>),
    /// Loads a shipped scenario and plays it from the start.
    LoadPreset(String),
    /// Loads the text of a scenario file and plays it from the start.
    LoadText {
        /// Where it came from, for messages.
        name: String,
        /// The file's text.
        text: String,
    },
    /// Begins with the networks of a file's text, UNKS chosen.
    LoadNetworks {
        /// Where it came from, for messages.
        name: String,
        /// The file's text.
        text: String,
    },
    /// Shows a message.
    Notify(String),
    /// Takes back the last change; the playhead stays.
    Undo,
    /// Does the change taken back last again.
    Redo,
}

/// What moves the playhead.
#[derive(Clone, Debug, PartialEq)]
pub enum PlaybackCommand {
    /// Play or pause; at the end of the cut: again from the start.
    TogglePlay,
    /// From the start of the cut, playing.
    Restart,
    /// Moves the playhead by control samples and pauses.
    Step(i64),
    /// Moves the playhead by seconds.
    SeekBy(f64),
    /// Moves the playhead to a time in s.
    SeekTo(f64),
    /// Moves the playhead to the end of the cut.
    SeekToEnd,
    /// Sets the speed of the playhead.
    Speed(Speed),
    /// Plots show the last seconds before the playhead (on) or the whole run (off).
    Follow(bool),
}

/// What goes to or comes from files and the clipboard.
#[derive(Clone, Debug, PartialEq)]
pub enum FileCommand {
    /// Asks for a scenario file and loads it.
    Open,
    /// Saves scenario and edits as a scenario file.
    Save,
    /// Saves all signals of the run as CSV.
    ExportCsv,
    /// Saves a table of a part of the run as CSV.
    SaveCsv {
        /// What it is, for the file's name.
        what: String,
        /// The table.
        text: String,
    },
    /// Saves a text under this name.
    SaveText {
        /// The file's name.
        name: String,
        /// Its text.
        text: String,
    },
    /// Asks for a table, for the screen that searches for formulas.
    OpenTable,
    /// Asks for a saved search for a formula, and goes on with it.
    OpenSearch,
    /// Hands a file to the screen that it is for, and shows that.
    Bring(BroughtFile),
    /// Asks for a file of UNKS networks and begins with them.
    OpenNetworks,
    /// Asks for a file of a formula's model and takes it for the setting at this path.
    OpenFormula(String),
    /// Saves the networks as they are at the end of the cut.
    SaveNetworks,
    /// Copies a link (on the desktop: its part after `#`) that holds scenario and edits.
    CopyLink,
}

/// What concerns the window around the screens.
#[derive(Clone, Debug, PartialEq)]
pub enum ShellCommand {
    /// Shows the screen with this id.
    ShowScreen(&'static str),
    /// Shows a part of the screen with this id, by its name.
    ShowPart(&'static str, &'static str),
    /// Light, dark, or as the system has it.
    Theme(egui::ThemePreference),
    /// Shows or hides the sheet of shortcuts.
    ShowShortcuts(bool),
    /// Opens or closes the search.
    ShowSearch(bool),
    /// Removes the message with this number from the screen; it stays in the list.
    Dismiss(u64),
    /// Closes what lies on top: search, sheet, link, or the newest message.
    CloseTopmost,
    /// Puts a link up, for copying it by hand.
    ShowLink(String),
}

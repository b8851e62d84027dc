//! Everything that can be done in the console. Panels read a view and push commands; the console
//! alone carries them out, so buttons, keys, tests and scripts go the same way. Each kind of
//! command is carried out in one place, by a `match` over all of it.

use std::sync::Arc;

use super::overlay::file::MeasuredFile;
use super::panels::BroughtFile;
use super::playback::Speed;
use super::session::MissionLock;
use super::session::hand::KnobScale;
use crate::base::language::Language;
use crate::base::settings::Value;
use crate::models::disturbances::{Disturbance, Zone};
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::library::LibraryKind;
use crate::study::mission::MissionResult;
use crate::study::part::PartPath;

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
    /// Files of one's own.
    Library(LibraryCommand),
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

    /// Drops a disturbance a little ahead of the tool.
    #[must_use]
    pub fn drop(kind: Disturbance) -> Self {
        Self::Session(SessionCommand::Disturb(DisturbCommand::Drop { kind, at_mm: None }))
    }

    /// Drives the cut by hand.
    #[must_use]
    pub fn hand(command: HandCommand) -> Self {
        Self::Session(SessionCommand::Hand(command))
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
    /// Makes the settings at the playhead those of the scenario itself, without its edits, and plays it from the
    /// start; one step of undo.
    CutAgain,
    /// Drops a disturbance into the cut, or says what the next one is like.
    Disturb(DisturbCommand),
    /// Drives the cut by hand.
    Hand(HandCommand),
    /// Hides the cut of the mission under way, at its start, while it is to be predicted; or shows it from there.
    HideCut(bool),
    /// Loads a shipped scenario and plays it from the start.
    LoadPreset(String),
    /// Loads the text of a scenario file and plays it from the start.
    LoadText {
        /// Where it came from, for messages.
        name: String,
        /// The file's text.
        text: String,
    },
    /// Makes a path with its depths the part of the scenario itself, in one step of undo.
    TakePart {
        /// Where it came from, for messages.
        name: String,
        /// The path.
        path: Box<PartPath>,
    },
    /// Takes the settings of a file of one's own: cutter, structure, material or machine.
    LoadOwn {
        /// Where it came from, for messages.
        name: String,
        /// The file's text.
        text: String,
    },
    /// Controls the cut by the script of a file.
    LoadScript {
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
    /// Begins a mission's cut: what the mission does not open cannot be changed until it is left.
    BeginMission {
        /// Its cut, as the learner has it.
        scenario: Box<Scenario>,
        /// The changes during it.
        edits: Edits,
        /// What it opens.
        lock: Box<MissionLock>,
    },
    /// Leaves the mission; the cut stays as it is.
    EndMission,
    /// Shows a message.
    Notify(String),
    /// Takes back the last change; the playhead stays.
    Undo,
    /// Does the change taken back last again.
    Redo,
}

/// What is done with disturbances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DisturbCommand {
    /// Drops one, as long and large as the last one of its kind: a step of undo.
    Drop {
        /// Its kind.
        kind: Disturbance,
        /// Where along the way it begins, mm; none: a little ahead of the tool.
        at_mm: Option<f64>,
    },
    /// How long and large the next one of a kind is.
    Offer {
        /// Its kind.
        kind: Disturbance,
        /// Its length and size; the place is not used.
        zone: Zone,
    },
}

/// What is done with the feed override in the learner's hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HandCommand {
    /// Switches the operator mode on or off.
    Mode(bool),
    /// Switches the operator mode.
    Toggle,
    /// How far the knob goes.
    Scale(KnobScale),
    /// Turns the knob by clicks, up or down.
    Turn(i32),
    /// Turns the knob to the click nearest to an override in percent.
    To(f64),
    /// Takes the feed from the controller that has it, at the override that it sends.
    Take,
    /// Gives the feed back to the controller that had it.
    GiveBack,
    /// Cuts the part from its start without a controller, the override at 100 %.
    CutByHand,
    /// Cuts the part from its start by a way of control, by its id in the comparison.
    CutBy(&'static str),
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
    /// Moves the playhead to 2 s before what went wrong last, and pauses: the next change branches there.
    TryAgain,
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
    /// Saves bytes under this name.
    SaveBytes {
        /// The file's name.
        name: String,
        /// The bytes.
        bytes: Vec<u8>,
    },
    /// Asks for a table, for the screen that searches for formulas.
    OpenTable,
    /// Asks for a part of one's own: a table of depths, or a program.
    OpenPart,
    /// Asks for measured data, and lays them over the plots.
    OpenMeasured,
    /// Remembers what was said of the layout of measured data, or forgets it where nothing is.
    RememberLayout(Box<MeasuredFile>),
    /// Asks for measured data that settings are fitted to.
    OpenFit,
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
    /// Copies a link to this state and puts it up: scenario and edits, the mission under way.
    CopyLink,
    /// The same with a link of another thing, by its part after `#`.
    CopyLinkTo(String),
    /// Copies a text of the link that is put up.
    CopyText {
        /// Which one.
        what: LinkText,
        /// The text.
        text: String,
    },
}

/// What of a link that is put up goes into the clipboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkText {
    /// The link.
    Link,
    /// The command line that repeats its run.
    CommandLine,
}

/// What is done with files of one's own.
#[derive(Clone, Debug, PartialEq)]
pub enum LibraryCommand {
    /// Shows or closes the window on them, with the files of one kind unfolded, or as it was.
    Show {
        /// Whether it is shown.
        open: bool,
        /// The kind.
        kind: Option<LibraryKind>,
    },
    /// Uses a file in the present cut, as if it were dropped.
    Use(String),
    /// Takes the formula of a file for the setting at a path.
    UseFormula {
        /// The file's name.
        name: String,
        /// The setting's path.
        path: String,
    },
    /// A file was opened from elsewhere: it is offered to be kept.
    Opened(OpenedFile),
    /// Keeps one that was opened from elsewhere.
    KeepOpened(String),
    /// Keeps what the present cut has of a kind as a file.
    KeepPresent(LibraryKind),
    /// Begins a file of a kind.
    Begin(LibraryKind),
    /// A file is kept now: by the name that it was opened by, if it was.
    Kept(String),
    /// Removes a file that a browser keeps.
    Remove(String),
    /// Saves such a file elsewhere.
    Download(String),
    /// Asks for another folder.
    AskFolder,
    /// Takes the folder at this path.
    Choose(String),
    /// Reads them again.
    LookAgain,
}

/// A file that was opened from elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenedFile {
    /// Its name.
    pub name: String,
    /// Its bytes.
    pub bytes: Arc<[u8]>,
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
    /// Everything large, for a projector, or of its usual size.
    Projector(bool),
    /// Nothing moves but what shows the cut, or again as usual.
    LessMotion(bool),
    /// Speaks this language from now on, and at the next start.
    Speak(Language),
    /// Shows or hides the sheet of shortcuts.
    ShowShortcuts(bool),
    /// Opens or closes the search.
    ShowSearch(bool),
    /// Removes the message with this number from the screen; it stays in the list.
    Dismiss(u64),
    /// Closes what lies on top: search, sheet, link, or the newest message.
    CloseTopmost,
    /// Puts a link up with its code: an address, or its part from `#` on.
    ShowLink {
        /// The link.
        link: String,
        /// Whether it is in the clipboard.
        copied: bool,
    },
    /// A text of the link that is put up was copied.
    Copied {
        /// Which one.
        what: LinkText,
        /// Whether the clipboard took it.
        copied: bool,
    },
    /// The address of a page of this program, for links of the desktop.
    PageIs(String),
    /// A mission was marked.
    Marked(Box<MissionResult>),
    /// Forgets the stars won in all missions.
    ForgetStars,
}

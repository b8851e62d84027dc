//! The screens. A new one is one file here and one line in the list of [`panels`], which drives
//! the tabs, the keys, the state that pages and tests read, and the snapshot tests.

pub mod equation_cards;
pub mod learning;

use super::command::Command;
use super::jobs::Jobs;
use super::overlay::file::MeasuredFile;
use super::remembered::Remembered;
use super::session::Session;
use super::shortcuts::Host;
use crate::study::opening::{Frame, LinkedMission};

/// What a panel sees of the console; it changes nothing but by commands.
pub struct View<'a> {
    /// Scenario, edits, the run with its constant-feed twin, and the playhead.
    pub session: &'a Session,
    /// Long work, which goes on when a screen is left.
    pub jobs: &'a Jobs,
    /// What is hidden.
    pub frame: &'a Frame,
    /// What is kept from one start to the next.
    pub remembered: &'a Remembered,
    /// Where the console runs, for the names of keys.
    pub place: Host,
    /// Whether the window is as narrow as a phone's.
    pub narrow: bool,
}

/// A file that was opened or dropped for one of the screens.
#[derive(Clone, Debug, PartialEq)]
pub enum BroughtFile {
    /// A table that formulas are searched for in.
    Table {
        /// Where it came from, for messages.
        name: String,
        /// Its text.
        text: String,
    },
    /// A program of a milling machine, to be cut from a blank.
    Program {
        /// Where it came from, for messages.
        name: String,
        /// Its text.
        text: String,
    },
    /// A mission.
    Mission {
        /// Where it came from, for messages.
        name: String,
        /// Its text.
        text: String,
    },
    /// A mission of a link.
    Linked(Box<LinkedMission>),
    /// Measured data, to lie over the plots.
    Measured(Box<MeasuredFile>),
    /// Measured data that settings are fitted to.
    ToFit(Box<MeasuredFile>),
    /// A saved search for a formula.
    Search {
        /// Where it came from, for messages.
        name: String,
        /// Its text.
        text: String,
    },
}

impl BroughtFile {
    /// Id of the screen that it is for.
    #[must_use]
    pub fn screen(&self) -> &'static str {
        match self {
            Self::Mission { .. } | Self::Linked(_) => "learn",
            Self::Measured(_) => "console",
            Self::Program { .. } => "workpiece",
            Self::Table { .. } | Self::Search { .. } | Self::ToFit(_) => "identify",
        }
    }
}

/// What measured data and tables are for that are dropped onto a screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DropTarget {
    /// To lie over the plots, where they have times.
    Plots,
    /// Tables to be searched for formulas.
    Formulas,
    /// Settings to be fitted to them.
    Fits,
}

/// One screen.
pub trait Panel {
    /// Its name in state, commands and snapshot files.
    fn id(&self) -> &'static str;
    /// Its name for people.
    fn title(&self) -> &'static str;
    /// What else it is looked for by, in the search: words of those who do not know its title yet.
    fn words(&self) -> &'static str;
    /// Draws it into the whole of `ui`.
    fn ui(&mut self, ui: &mut egui::Ui, view: &View<'_>, commands: &mut Vec<Command>);
    /// Whether the run's timeline belongs below it. Where not, the playhead rests.
    fn has_timeline(&self) -> bool {
        true
    }
    /// Shows the part of it with this name; a screen without parts is shown as it is.
    fn show_part(&mut self, _part: &str) {}
    /// What a table that is dropped onto it is for.
    fn drop_target(&self) -> DropTarget {
        DropTarget::Plots
    }
    /// Takes a file that was opened or dropped for it.
    fn take(&mut self, _file: &BroughtFile) {}
    /// Another screen is shown from now on.
    fn left(&mut self) {}
    /// Makes the texts anew that it keeps from frame to frame: another language is spoken.
    fn tell_anew(&mut self) {}
}

/// From the list of screens `module::Type` their modules and [`panels`].
macro_rules! screens {
    ($( $module:ident :: $panel:ident, )+) => {
        $( pub mod $module; )+

        /// All screens in the order of the tabs, the first one shown first.
        #[must_use]
        pub fn panels() -> Vec<Box<dyn Panel>> {
            vec![ $( Box::new($module::$panel::default()), )+ ]
        }
    };
}

screens! {
    console::ConsolePanel,
    block_diagram::BlockDiagramPanel,
    workpiece::WorkpiecePanel,
    plan::PlanPanel,
    machine::MachinePanel,
    compare::ComparePanel,
    papers::PapersPanel,
    identify::IdentifyPanel,
    learn::LearnPanel,
}

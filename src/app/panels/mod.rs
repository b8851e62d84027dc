//! The screens. A new one is one file here and two lines in this one: its `pub mod` and its line
//! in [`panels`], which drives the tabs, the keys and the snapshot tests.

// register: module
pub mod block_diagram;
pub mod compare;
pub mod console;
pub mod equation_cards;
pub mod learning;
pub mod machine;
pub mod papers;
pub mod plan;

use super::command::Command;
use super::session::Session;

/// What a panel sees of the console; it changes nothing but by commands.
pub struct View<'a> {
    /// Scenario, edits, the run with its constant-feed twin, and the playhead.
    pub session: &'a Session,
    /// Whether the window is as narrow as a phone's.
    pub narrow: bool,
}

/// One screen.
pub trait Panel {
    /// Its name in state, commands and snapshot files.
    fn id(&self) -> &'static str;
    /// Its name for people.
    fn title(&self) -> &'static str;
    /// Draws it into the whole of `ui`.
    fn ui(&mut self, ui: &mut egui::Ui, view: &View<'_>, commands: &mut Vec<Command>);
    /// Another screen is shown from now on.
    fn left(&mut self) {}
}

/// All screens in the order of the tabs, the first one shown first.
#[must_use]
pub fn panels() -> Vec<Box<dyn Panel>> {
    vec![
        // register: panel
        Box::new(console::ConsolePanel::default()),
        Box::new(block_diagram::BlockDiagramPanel::default()),
        Box::new(plan::PlanPanel::default()),
        Box::new(machine::MachinePanel::default()),
        Box::new(compare::ComparePanel::default()),
        Box::new(papers::PapersPanel::default()),
    ]
}

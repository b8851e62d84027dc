//! The button that leads to files of one's own.

use egui::Ui;

use crate::app::command::{Command, LibraryCommand};
use crate::app::panels::View;
use crate::base::language::tr;
use crate::study::library::LibraryKind;
use crate::study::opening::FramePart;

/// Shows the files of one's own, those of a kind unfolded; not there where files are hidden.
pub fn my_files(
    ui: &mut Ui,
    view: &View<'_>,
    kind: Option<LibraryKind>,
    commands: &mut Vec<Command>,
) {
    if view.frame.hides(FramePart::Files) {
        return;
    }
    let help = tr(
        "Cutters, materials, machines, structures, parts, scripts and more of your own: used, kept, begun",
    );
    if ui.button(tr("My files\u{2026}")).on_hover_text(help).clicked() {
        commands.push(Command::Library(LibraryCommand::Show { open: true, kind }));
    }
}

//! The button that saves a table as CSV.

use egui::{Role, Ui, WidgetInfo};

use super::super::command::{Command, FileCommand};
use crate::study::export::sheet::Sheet;

/// The button of the table that is called `what`, in its file's name too; `sheet` is made when it is clicked.
pub fn save_table(
    ui: &mut Ui,
    what: &str,
    sheet: impl FnOnce() -> Sheet,
    commands: &mut Vec<Command>,
) {
    let button = ui.button("Table as CSV");
    let name = format!("Save {} as CSV", what.replace('-', " "));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
    if button.on_hover_text(name.as_str()).clicked() {
        let text = sheet().csv();
        commands.push(Command::File(FileCommand::SaveCsv { what: what.to_owned(), text }));
    }
}

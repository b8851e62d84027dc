//! The button that saves a table as CSV, under the name of what it is of; a table that is not whole yet says so.

use egui::{Role, Ui, WidgetInfo};

use super::super::command::{Command, FileCommand};
use super::super::files::{called, file_name};
use crate::base::language::{self, tr};
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::export::sheet::Sheet;

/// What a table is of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TableOf<'a> {
    /// The scenario that is open.
    Open,
    /// This scenario.
    Cut(&'a Scenario),
    /// What has this name.
    Named(&'a str),
    /// Nothing with a name.
    Nothing,
}

/// A table, as its file names it.
pub struct SavedTable<'a> {
    /// What it is.
    pub what: &'a str,
    /// What it is of.
    pub of: TableOf<'a>,
    /// How much of it there is, in words, where it is not whole yet. They are asked for once more for the file,
    /// which is English whatever the console's language.
    pub partial: Option<&'a dyn Fn() -> String>,
}

impl SavedTable<'_> {
    /// What saves it.
    fn command(&self, sheet: Sheet) -> FileCommand {
        let (what, sheet) = match &self.partial {
            Some(done) => (format!("{}-partial", self.what), sheet.with("Partial", &done())),
            None => (self.what.to_owned(), sheet),
        };
        let text = sheet.csv();
        match self.of {
            TableOf::Open => FileCommand::SaveCsv { what, text },
            TableOf::Cut(scenario) => named(&called(scenario, &Edits::none()), &what, text),
            TableOf::Named(of) => named(of, &what, text),
            TableOf::Nothing => FileCommand::SaveText { name: format!("{what}.csv"), text },
        }
    }
}

fn named(of: &str, what: &str, text: String) -> FileCommand {
    FileCommand::SaveText { name: file_name(of, &format!("{what}.csv")), text }
}

/// A table as people read of it: its name in files, in words.
fn in_words(what: &str) -> String {
    let of_paper = |begin: &str| what.strip_prefix(begin).map(|paper| paper.replace('-', " "));
    match what {
        "afc-log" => tr("afc log").to_owned(),
        "changed-conditions" => tr("changed conditions").to_owned(),
        "comparison" => tr("comparison").to_owned(),
        "front" => tr("front").to_owned(),
        "load-step" => tr("load step").to_owned(),
        "modes" => tr("modes").to_owned(),
        "passes" => tr("passes").to_owned(),
        "plan" => tr("plan").to_owned(),
        other => {
            if let Some(paper) = of_paper("table-") {
                tr!("table {paper}", paper = paper)
            } else if let Some(paper) = of_paper("claim-") {
                tr!("claim {paper}", paper = paper)
            } else if let Some(paper) = of_paper("deviations-") {
                tr!("deviations {paper}", paper = paper)
            } else if let Some(paper) = of_paper("calibrations-") {
                tr!("calibrations {paper}", paper = paper)
            } else {
                other.replace('-', " ")
            }
        }
    }
}

/// The button; `sheet` is made when it is clicked.
pub fn save_table(
    ui: &mut Ui,
    table: &SavedTable<'_>,
    sheet: impl FnOnce() -> Sheet,
    commands: &mut Vec<Command>,
) {
    save_table_of(ui, table, true, sheet, commands);
}

/// The same over a table that fills: the button stands where no row moves it, and waits for the first one.
pub fn save_table_of(
    ui: &mut Ui,
    table: &SavedTable<'_>,
    has_rows: bool,
    sheet: impl FnOnce() -> Sheet,
    commands: &mut Vec<Command>,
) {
    let button = ui.add_enabled(has_rows, egui::Button::new(tr("Save CSV")));
    let name = tr!("Save {table} as CSV", table = in_words(table.what));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, has_rows, name.clone()));
    let button = button.on_disabled_hover_text(tr("There is no row yet"));
    let done = table.partial.map(|done| done());
    let help = match &done {
        Some(done) => tr!("{name}, not whole yet: {done}", name = name, done = done),
        None => name,
    };
    if button.on_hover_text(help).clicked() {
        if let Some(done) = done {
            commands.push(Command::notify(tr!(
                "The table is not whole yet: {done}. The name of the file and its column “Partial” say so.",
                done = done
            )));
        }
        let save = language::in_english(|| table.command(sheet()));
        commands.push(Command::File(save));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::run::presets;

    fn sheet() -> Sheet {
        let mut sheet = Sheet::new(["Control", "Runs"]);
        sheet.row(["P".into(), 3.0.into()]);
        sheet
    }

    /// The file belongs to what was compared, whichever scenario is open; and what is not whole says so.
    #[test]
    fn a_file_is_named_after_what_it_is_of_and_says_where_it_is_not_whole() {
        let shipped = presets::load("first-cut").expect("shipped");
        let named = |of, partial: Option<&dyn Fn() -> String>| {
            let table = SavedTable { what: "comparison", of, partial };
            let command = table.command(sheet());
            let FileCommand::SaveText { name, text } = command else { panic!("{command:?}") };
            (name, text)
        };
        let (name, text) = named(TableOf::Named("experiment-2"), None);
        assert_eq!(name, "experiment-2.comparison.csv");
        assert_eq!(text, "Control,Runs\nP,3\n");
        assert_eq!(named(TableOf::Nothing, None).0, "comparison.csv");
        let changed = {
            let mut changed = shipped.clone();
            changed.set("target.ra_um", Value::Float(0.5)).expect("allowed");
            changed
        };
        for (scenario, file) in [
            (&shipped, "drag-the-target-roughness.comparison.csv"),
            (&changed, "drag-the-target-roughness-changed.comparison.csv"),
        ] {
            assert_eq!(named(TableOf::Cut(scenario), None).0, file);
        }
        let done = || "3 of 180 runs".to_owned();
        let (name, text) = named(TableOf::Named("experiment-2"), Some(&done));
        assert_eq!(name, "experiment-2.comparison-partial.csv");
        assert_eq!(text, "Control,Runs,Partial\nP,3,3 of 180 runs\n");
    }
}

//! How the console carries commands out: what is not the session's is done here.

use super::command::{Command, FileCommand, SessionCommand, ShellCommand};
#[cfg(target_arch = "wasm32")]
use super::web;
use super::{Console, files};
use crate::run::scenario_file;
use crate::study::export;
use crate::study::unks_passes::learned;

impl Console {
    pub(super) fn execute(&mut self, command: Command, ctx: &egui::Context) {
        match command {
            Command::Session(command) => {
                if matches!(
                    command,
                    SessionCommand::Set { .. }
                        | SessionCommand::SetUp(_)
                        | SessionCommand::SetFormula { .. }
                        | SessionCommand::LoadFormula { .. }
                ) {
                    self.since_change_s = 0.0;
                }
                self.session.execute(command);
            }
            Command::Playback(command) => self.session.play(command),
            Command::File(command) => self.execute_file(command, ctx),
            Command::Shell(command) => self.execute_shell(command, ctx),
        }
    }

    fn execute_shell(&mut self, command: ShellCommand, ctx: &egui::Context) {
        match command {
            ShellCommand::ShowScreen(id) => self.show_screen(id),
            ShellCommand::ShowPart(id, part) => {
                self.show_screen(id);
                self.panels[self.shown].show_part(part);
            }
            ShellCommand::Theme(preference) => ctx.set_theme(preference),
            ShellCommand::ShowShortcuts(show) => self.shortcuts = show,
            ShellCommand::ShowSearch(show) => self.search.show_it(show),
            ShellCommand::Dismiss(number) => self.messages.dismiss(number),
            ShellCommand::ShowLink(link) => self.link = Some(link),
            ShellCommand::CloseTopmost => self.close_topmost(),
        }
    }

    fn show_screen(&mut self, id: &str) {
        let shown = self.panels.iter().position(|p| p.id() == id).unwrap_or(self.shown);
        if shown != self.shown {
            self.panels[self.shown].left();
        }
        self.shown = shown;
    }

    fn close_topmost(&mut self) {
        if self.search.is_open() {
            self.search.show_it(false);
        } else if self.link.take().is_none() && !std::mem::take(&mut self.shortcuts) {
            self.messages.dismiss_newest();
        }
    }

    fn execute_file(&mut self, command: FileCommand, ctx: &egui::Context) {
        match command {
            FileCommand::Open => self.files.open(ctx),
            FileCommand::Save => {
                let text = scenario_file::write(self.session.scenario(), self.session.edits());
                self.save(ctx, "toml", text.into_bytes());
            }
            FileCommand::ExportCsv => self.export_csv(ctx),
            FileCommand::SaveCsv { what, text } => {
                self.save(ctx, &format!("{what}.csv"), text.into_bytes());
            }
            FileCommand::SaveText { name, text } => self.files.save(ctx, &name, text.into_bytes()),
            FileCommand::OpenTable => self.files.open_table(ctx),
            FileCommand::OpenSearch => self.files.open_search(ctx),
            FileCommand::Bring(file) => {
                self.show_screen(file.screen());
                self.panels[self.shown].take(&file);
            }
            FileCommand::OpenNetworks => self.files.open_networks(ctx),
            FileCommand::OpenFormula(path) => self.files.open_formula(ctx, path),
            FileCommand::SaveNetworks => self.save_networks(ctx),
            FileCommand::CopyLink => self.copy_link(ctx),
        }
    }

    fn save(&self, ctx: &egui::Context, extension: &str, bytes: Vec<u8>) {
        let name = files::file_name(&self.session.scenario().info.name, extension);
        self.files.save(ctx, &name, bytes);
    }

    fn export_csv(&mut self, ctx: &egui::Context) {
        let mut bytes = Vec::new();
        match export::csv::write(&mut bytes, self.session.chosen().run().recording()) {
            Ok(()) => self.save(ctx, "csv", bytes),
            Err(error) => self.session.notify(format!("CSV: {error}")),
        }
    }

    /// Saves what the networks have learned at the end of the cut.
    fn save_networks(&mut self, ctx: &egui::Context) {
        match learned(self.session.chosen().run(), 1) {
            Some(stored) => self.save(ctx, "json", stored.write().into_bytes()),
            None => self.session.notify("The chosen controller has no networks that learn."),
        }
    }

    #[cfg(target_arch = "wasm32")]
    fn copy_link(&mut self, ctx: &egui::Context) {
        let said = "The link is in the clipboard: it opens this scenario with its edits.";
        let said = format!("{said} {}", self.repeated());
        self.files.copy(ctx, web::address(&self.fragment()), said);
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn copy_link(&mut self, ctx: &egui::Context) {
        ctx.copy_text(format!("#{}", self.fragment()));
        let said = "The link's part from # on is in the clipboard: append it to the address of \
                    SteadyCut's web page.";
        self.session.notify(format!("{said} {}", self.repeated()));
    }

    /// How the run is repeated elsewhere, and how to see that it is the same.
    pub(super) fn repeated(&self) -> String {
        let run = self.session.chosen().run();
        let digest = match run.end() {
            Some(_) => format!("its digest is {}.", run.recording().digest()),
            None => {
                "copied when the cut is worked out to its end, it comes with the digest.".to_owned()
            }
        };
        format!("`steadycut run 'LINK'` repeats the run on the command line: {digest}")
    }
}

//! How the console carries commands out: what is not the session's is done here.

use super::command::{
    Command, FileCommand, LibraryCommand, LinkText, SessionCommand, ShellCommand,
};
use super::library::{begun, present};
use super::link::{LinkWindow, RunTold};
use super::overlay::file::MeasuredFile;
use super::session::PREDICT_FIRST;
#[cfg(target_arch = "wasm32")]
use super::web;
use super::{Console, files, format, framed, theme};
use crate::base::language::tr;
use crate::run::scenario_file;
use crate::study::export;
use crate::study::mission::MissionResult;
use crate::study::unks_passes::learned;

/// Id of the screen with the operator's view.
const CONSOLE: &str = "console";

impl Console {
    pub(super) fn execute(&mut self, command: Command, ctx: &egui::Context) {
        let shown = self.panels[self.shown].id();
        if let Some(refused) = framed::refused(&self.frame, shown, &command) {
            self.session.notify(refused);
            return;
        }
        match command {
            Command::Session(command) => {
                if matches!(
                    command,
                    SessionCommand::Set { .. }
                        | SessionCommand::SetUp(_)
                        | SessionCommand::SetFormula { .. }
                        | SessionCommand::Disturb(_)
                        | SessionCommand::Hand(_)
                        | SessionCommand::LoadFormula { .. }
                        | SessionCommand::LoadOwn { .. }
                        | SessionCommand::LoadScript { .. }
                ) {
                    self.since_change_s = 0.0;
                }
                let was_on = self.session.hand().is_on();
                let by_hand = matches!(command, SessionCommand::Hand(_));
                self.session.execute(command);
                // The operator's view is on the console.
                if by_hand && !was_on && self.session.hand().is_on() {
                    self.show_screen(CONSOLE);
                }
            }
            Command::Playback(command) => self.session.play(command),
            Command::File(command) => self.execute_file(command, ctx),
            Command::Shell(command) => self.execute_shell(command, ctx),
            Command::Library(command) => self.execute_library(command, ctx),
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
            ShellCommand::Projector(large) => theme::set_large(ctx, large),
            ShellCommand::LessMotion(still) => theme::set_still(ctx, still),
            ShellCommand::Speak(language) => {
                self.speak(language);
                self.remembered.speaks(language);
                // What was said was said in another language; the list keeps it as it was said.
                self.messages.dismiss_all();
            }
            ShellCommand::ShowShortcuts(show) => self.shortcuts = show,
            ShellCommand::ShowSearch(show) => self.search.show_it(show),
            ShellCommand::Dismiss(number) => self.messages.dismiss(number),
            ShellCommand::ShowLink { link, copied } => {
                self.link = Some(LinkWindow::new(link, copied));
            }
            ShellCommand::Copied { what, copied } => {
                if let Some(link) = &mut self.link {
                    link.was_copied(what, copied);
                }
            }
            ShellCommand::PageIs(page) => self.remembered.page_is(&page),
            ShellCommand::Marked(result) => self.marked(*result),
            ShellCommand::ForgetStars => self.remembered.forget_stars(),
            ShellCommand::CloseTopmost => self.close_topmost(),
        }
    }

    /// What is done with files of one's own; where that takes a disk, on a thread.
    fn execute_library(&mut self, command: LibraryCommand, ctx: &egui::Context) {
        let Some(shelf) = self.library.shelf() else {
            if let LibraryCommand::Show { open, kind } = command {
                self.library.show_it(open, kind);
            }
            return;
        };
        match command {
            LibraryCommand::Show { open, kind } => self.library.show_it(open, kind),
            LibraryCommand::Use(name) => self.files.take_kept(ctx, shelf, name),
            LibraryCommand::UseFormula { name, path } => {
                self.files.take_formula(ctx, shelf, name, path);
            }
            LibraryCommand::Opened(file) => self.library.was_opened(file),
            LibraryCommand::KeepOpened(name) => {
                if let Some(file) = self.library.opened(&name) {
                    self.files.keep(ctx, shelf, name, file.bytes.to_vec());
                }
            }
            LibraryCommand::KeepPresent(kind) => match present(kind, &self.session) {
                Ok((name, text)) => self.files.keep(ctx, shelf, name, text.into_bytes()),
                Err(why) => self.session.notify(why),
            },
            LibraryCommand::Begin(kind) => {
                if let Some((name, text)) = begun(kind) {
                    self.files.keep(ctx, shelf, name, text.as_bytes().to_vec());
                }
            }
            LibraryCommand::Kept(name) => self.library.was_kept(&name),
            LibraryCommand::Remove(name) => {
                let gone = shelf.remove(&name);
                self.session.notify(match gone {
                    Ok(()) => tr!("{name} is deleted.", name = name),
                    Err(why) => format!("{name}: {why}"),
                });
                self.library.look_again();
            }
            LibraryCommand::Download(name) => match shelf.read(&name) {
                Ok(bytes) => self.files.save(ctx, &name, bytes),
                Err(why) => self.session.notify(format!("{name}: {why}")),
            },
            LibraryCommand::AskFolder => self.files.ask_folder(ctx),
            LibraryCommand::Choose(folder) => self.files.choose_folder(ctx, shelf, folder),
            LibraryCommand::LookAgain => self.library.look_again(),
        }
    }

    fn show_screen(&mut self, id: &str) {
        let shown = self.panels.iter().position(|p| p.id() == id).unwrap_or(self.shown);
        if shown != self.shown {
            self.panels[self.shown].left();
            self.messages.leave_screen();
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
            FileCommand::ExportCsv if self.session.hides_the_cut() => {
                self.session.notify(tr(PREDICT_FIRST));
            }
            FileCommand::ExportCsv => self.export_csv(ctx),
            FileCommand::SaveCsv { what, text } => {
                self.save(ctx, &format!("{what}.csv"), text.into_bytes());
            }
            FileCommand::SaveText { name, text } => self.files.save(ctx, &name, text.into_bytes()),
            FileCommand::SaveBytes { name, bytes } => self.files.save(ctx, &name, bytes),
            FileCommand::OpenTable => self.files.open_table(ctx),
            FileCommand::OpenPart => self.files.open_part(ctx),
            FileCommand::OpenMeasured => self.files.open_measured(ctx),
            FileCommand::RememberLayout(file) => self.remember_layout(ctx, &file),
            FileCommand::OpenFit => self.files.open_fit(ctx),
            FileCommand::OpenSearch => self.files.open_search(ctx),
            FileCommand::Bring(file) => {
                self.show_screen(file.screen());
                self.panels[self.shown].take(&file);
            }
            FileCommand::OpenNetworks => self.files.open_networks(ctx),
            FileCommand::OpenFormula(path) => self.files.open_formula(ctx, path),
            FileCommand::SaveNetworks => self.save_networks(ctx),
            FileCommand::CopyLink => self.copy_link(ctx, &self.fragment()),
            FileCommand::CopyLinkTo(fragment) => self.copy_link(ctx, &fragment),
            FileCommand::CopyText { what, text } => self.copy_text(ctx, what, text),
        }
    }

    /// Remembers the stars of a mission, and tells the page around, which may hand them to a learning platform.
    fn marked(&mut self, result: MissionResult) {
        self.remembered.won(&result.kept_as(), result.verdict.stars);
        #[cfg(target_arch = "wasm32")]
        web::tell_page("steadycutResult", &result.write());
        self.result = Some(result);
    }

    /// Remembers what was said of a layout for files like it, and beside the file where it has a place.
    fn remember_layout(&mut self, ctx: &egui::Context, file: &MeasuredFile) {
        self.remembered.was_said(&file.alike(), file.said());
        self.files.know(self.remembered.layouts().clone());
        self.files.write_layout(ctx, file);
    }

    fn save(&self, ctx: &egui::Context, extension: &str, bytes: Vec<u8>) {
        let called = files::called(self.session.scenario(), self.session.edits());
        let name = files::file_name(&called, extension);
        self.files.save(ctx, &name, bytes);
    }

    fn export_csv(&mut self, ctx: &egui::Context) {
        let mut bytes = Vec::new();
        match export::csv::write(&mut bytes, self.session.chosen().run().recording()) {
            Ok(()) => {
                // What is not worked out to its end yet says so.
                let over = self.session.chosen().is_over();
                if !over {
                    let until = format::time(self.session.chosen().simulated_s());
                    self.session.notify(tr!(
                        "The signals are those up to {until}: the cut is still being computed. The name of the \
                         file says so.",
                        until = until
                    ));
                }
                self.save(ctx, if over { "csv" } else { "partial.csv" }, bytes);
            }
            Err(error) => self.session.notify(format!("CSV: {error}")),
        }
    }

    /// Saves what the networks have learned at the end of the cut.
    fn save_networks(&mut self, ctx: &egui::Context) {
        match learned(self.session.chosen().run(), 1) {
            Some(stored) => self.save(ctx, "json", stored.write().into_bytes()),
            None => self.session.notify(tr("The chosen controller has no networks that learn.")),
        }
    }

    #[cfg(target_arch = "wasm32")]
    fn copy_link(&self, ctx: &egui::Context, fragment: &str) {
        let link = web::address(fragment);
        self.files.copy(ctx, link, |link, copied| ShellCommand::ShowLink { link, copied });
    }

    #[cfg(target_arch = "wasm32")]
    fn copy_text(&self, ctx: &egui::Context, what: LinkText, text: String) {
        self.files.copy(ctx, text, move |_, copied| ShellCommand::Copied { what, copied });
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn copy_text(&self, ctx: &egui::Context, what: LinkText, text: String) {
        ctx.copy_text(text);
        self.push(Command::Shell(ShellCommand::Copied { what, copied: true }));
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn copy_link(&self, ctx: &egui::Context, fragment: &str) {
        let link = format!("{}#{fragment}", self.remembered.page());
        ctx.copy_text(link.clone());
        self.push(Command::Shell(ShellCommand::ShowLink { link, copied: true }));
    }

    /// The run that is shown, for a link that is put up.
    pub(super) fn told(&self) -> RunTold {
        let run = self.session.chosen().run();
        let digest = run.end().map(|_| run.recording().digest());
        RunTold { fragment: self.fragment(), digest }
    }
}

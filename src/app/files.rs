//! Opening and saving files without stopping the window: answers come later, as commands.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

#[cfg(target_arch = "wasm32")]
use super::command::ShellCommand;
use super::command::{Command, FileCommand, LibraryCommand, OpenedFile, SessionCommand};
use super::library::{LONGEST_OPENED, Shelf};
use super::overlay::file::MeasuredFile;
#[cfg(not(target_arch = "wasm32"))]
use super::overlay::layouts::beside;
use super::overlay::layouts::{KnownLayouts, as_remembered};
use super::panels::{BroughtFile, DropTarget};
use crate::base::language::{self, Catalogue, tr};
use crate::base::text::decode;
use crate::measured::layout::DataLayout;
use crate::run::edits::Edits;
use crate::run::presets;
use crate::run::scenario::Scenario;
use crate::study::library::{
    LibraryKind, MEASURED, PROGRAMS, SPREADSHEETS, TABLES, TEXTS, ends_with_one_of,
};
use crate::study::part::PartPath;

#[cfg(not(target_arch = "wasm32"))]
mod fallback;

/// Answers of file dialogs that are open or were open.
pub struct Files {
    sender: Sender<Command>,
    receiver: Receiver<Command>,
    /// What was said of layouts of measured data.
    layouts: Arc<KnownLayouts>,
}

impl Default for Files {
    fn default() -> Self {
        let (sender, receiver) = channel();
        Self { sender, receiver, layouts: Arc::default() }
    }
}

/// Where an answer goes, and the window that must wake up for it.
struct Answer {
    sender: Sender<Command>,
    ctx: egui::Context,
    /// Of what is said in it: threads that wait for a dialog have none of their own.
    language: Option<&'static Catalogue>,
    layouts: Arc<KnownLayouts>,
}

impl Answer {
    /// Speaks on this thread as the window does.
    fn speak(&self) {
        language::use_catalogue(self.language);
    }

    /// One command of several, or the only one.
    fn tell(&self, command: Command) {
        // The window may be gone by now: then nobody waits for the answer.
        let _ = self.sender.send(command);
    }

    /// What a file that was read becomes, which can be kept from then on.
    fn send_read(
        self,
        (name, path): (&str, Option<PathBuf>),
        bytes: &[u8],
        command: impl FnOnce(String) -> Command,
    ) {
        if bytes.len() <= LONGEST_OPENED
            && LibraryKind::opened_as(name, bytes) != LibraryKind::Unreadable
        {
            let file = OpenedFile { name: name.to_owned(), bytes: bytes.into() };
            self.tell(Command::Library(LibraryCommand::Opened(file)));
        }
        let command = remembering(command(name.to_owned()), path, &self.layouts);
        self.send(command);
    }

    fn send(self, command: Command) {
        self.tell(command);
        self.ctx.request_repaint();
    }
}

impl Files {
    fn answer(&self, ctx: &egui::Context) -> Answer {
        Answer {
            sender: self.sender.clone(),
            ctx: ctx.clone(),
            language: language::catalogue(),
            layouts: Arc::clone(&self.layouts),
        }
    }

    /// What was said of layouts of measured data, for files that are opened from now on.
    pub fn know(&mut self, layouts: KnownLayouts) {
        self.layouts = Arc::new(layouts);
    }

    /// Writes what was said of a layout beside the file, as the command does, or removes that where nothing is; a file
    /// without a place has nothing beside it.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn write_layout(&self, ctx: &egui::Context, file: &MeasuredFile) {
        let Some(place) = file.path().map(beside) else { return };
        let answer = self.answer(ctx);
        let said = file.said().clone();
        spawn(async move {
            answer.speak();
            let done = match said == DataLayout::default() {
                true => crate::disk::remove(&place).map_err(|error| error.to_string()),
                false => crate::disk::write(&place, said.write().as_bytes())
                    .map_err(|error| error.to_string()),
            };
            if let Err(why) = done {
                answer.send(Command::notify(tr!(
                    "The layout is remembered for files like it, but not beside this one: {why}",
                    why = why
                )));
            }
        });
    }

    /// A page has no files beside others.
    #[cfg(target_arch = "wasm32")]
    pub fn write_layout(&self, _: &egui::Context, _: &MeasuredFile) {}

    /// Answers with a command.
    pub fn push(&self, command: Command) {
        // The receiver is beside it.
        let _ = self.sender.send(command);
    }

    /// What has been answered since the last time.
    pub fn answers(&self) -> impl Iterator<Item = Command> + '_ {
        self.receiver.try_iter()
    }

    /// Asks for a scenario file.
    pub fn open(&self, ctx: &egui::Context) {
        self.ask(ctx, tr("SteadyCut scenario"), &["toml"], loaded);
    }

    /// Asks for a file of UNKS networks.
    pub fn open_networks(&self, ctx: &egui::Context) {
        self.ask(ctx, tr("UNKS networks"), &[JSON], loaded);
    }

    /// Asks for a table.
    pub fn open_table(&self, ctx: &egui::Context) {
        self.ask(ctx, tr("Table"), &["csv", "tsv", "txt"], table);
    }

    /// Asks for a part of one's own: a table of depths, or a program.
    pub fn open_part(&self, ctx: &egui::Context) {
        let endings: Vec<&str> = TABLES.into_iter().chain(PROGRAMS).collect();
        self.ask(ctx, tr("Part: table or G-code"), &endings, loaded);
    }

    /// Asks for measured data.
    pub fn open_measured(&self, ctx: &egui::Context) {
        let endings: Vec<&str> = TABLES.into_iter().chain(TEXTS).chain(MEASURED).collect();
        self.ask(ctx, tr("Measured data"), &endings, measured);
    }

    /// Asks for measured data that settings are fitted to.
    pub fn open_fit(&self, ctx: &egui::Context) {
        let endings: Vec<&str> = TABLES.into_iter().chain(TEXTS).chain(MEASURED).collect();
        self.ask(ctx, tr("Measured data"), &endings, to_fit);
    }

    /// Asks for a saved search for a formula.
    pub fn open_search(&self, ctx: &egui::Context) {
        self.ask(ctx, tr("Saved search"), &[JSON], search);
    }

    /// Asks for a file of a formula's model, for the setting at `path`.
    pub fn open_formula(&self, ctx: &egui::Context, path: String) {
        let of_file = move |name: String, bytes: &[u8]| match decode(bytes) {
            Ok(text) => Command::Session(SessionCommand::LoadFormula { path, name, text }),
            Err(error) => Command::notify(format!("{name}: {error}")),
        };
        self.ask(ctx, tr("Model of a formula"), &["toml"], of_file);
    }

    /// Asks for a file, which becomes a command by `read`.
    fn ask(
        &self,
        ctx: &egui::Context,
        what: &str,
        extensions: &[&str],
        read: impl FnOnce(String, &[u8]) -> Command + Send + 'static,
    ) {
        let answer = self.answer(ctx);
        let dialog = rfd::AsyncFileDialog::new().add_filter(what, extensions);
        #[cfg(not(target_arch = "wasm32"))]
        let opened = fallback::Opened::now();
        let picked = dialog.pick_file();
        spawn(async move {
            match picked.await {
                Some(file) => {
                    let name = file.file_name();
                    #[cfg(target_arch = "wasm32")]
                    let path = None;
                    #[cfg(not(target_arch = "wasm32"))]
                    let path = Some(file.path().to_owned());
                    #[cfg(target_arch = "wasm32")]
                    let bytes = Ok::<_, std::io::Error>(file.read().await);
                    // The dialog's own reader panics where a file cannot be read.
                    #[cfg(not(target_arch = "wasm32"))]
                    let bytes = crate::disk::read(file.path());
                    answer.speak();
                    match bytes {
                        Ok(bytes) => {
                            answer.send_read((&name, path), &bytes, |name| read(name, &bytes));
                        }
                        Err(error) => {
                            answer.send(Command::notify(unread(&name, &error.to_string())));
                        }
                    }
                }
                #[cfg(not(target_arch = "wasm32"))]
                None if opened.was_never_shown() => {
                    answer.speak();
                    answer.send(Command::notify(tr(fallback::NO_DIALOG_TO_OPEN).to_owned()));
                }
                // The user has thought better of it.
                None => {}
            }
        });
    }

    /// Reads the files that were dropped onto the window; what tables among them are for, the shown screen says.
    pub fn take_dropped(&self, ctx: &egui::Context, target: DropTarget) {
        for file in ctx.input(|input| input.raw.dropped_files.clone()) {
            let answer = self.answer(ctx);
            let name = file.path().file_name().unwrap_or_default().to_string_lossy().into_owned();
            let path = Some(file.path().to_owned()).filter(|path| path.is_absolute());
            spawn(async move {
                #[cfg(target_arch = "wasm32")]
                let bytes = file.bytes_async().await;
                #[cfg(not(target_arch = "wasm32"))]
                let bytes = file.bytes();
                answer.speak();
                match bytes {
                    Ok(bytes) => {
                        let of = |name| dropped(name, &bytes, target);
                        answer.send_read((&name, path), &bytes, of);
                    }
                    Err(error) => answer.send(Command::notify(unread(&name, &error.to_string()))),
                }
            });
        }
    }

    /// Uses a file of one's own as if it were dropped onto the plots.
    pub fn take_kept(&self, ctx: &egui::Context, shelf: Arc<dyn Shelf>, name: String) {
        let answer = self.answer(ctx);
        spawn(async move {
            answer.speak();
            match shelf.read(&name) {
                Ok(bytes) => {
                    let command = dropped(last_of(&name), &bytes, DropTarget::Plots);
                    let command = remembering(command, shelf.path(&name), &answer.layouts);
                    answer.send(command);
                }
                Err(error) => answer.send(Command::notify(unread(&name, &error))),
            }
        });
    }

    /// Takes the formula of a file of one's own for the setting at `path`.
    pub fn take_formula(
        &self,
        ctx: &egui::Context,
        shelf: Arc<dyn Shelf>,
        name: String,
        path: String,
    ) {
        let answer = self.answer(ctx);
        spawn(async move {
            answer.speak();
            let text = shelf.read(&name).and_then(|bytes| decode(&bytes));
            let name = last_of(&name);
            answer.send(match text {
                Ok(text) => Command::Session(SessionCommand::LoadFormula { path, name, text }),
                Err(error) => Command::notify(unread(&name, &error)),
            });
        });
    }

    /// Keeps a file with one's own.
    pub fn keep(&self, ctx: &egui::Context, shelf: Arc<dyn Shelf>, name: String, bytes: Vec<u8>) {
        let answer = self.answer(ctx);
        spawn(async move {
            answer.speak();
            match shelf.keep(&name, &bytes) {
                Ok(kept) => {
                    let place = shelf.path(&kept).map(|path| path.display().to_string());
                    let text = match place {
                        Some(place) => tr!("Kept: {place}", place = place),
                        None => tr!("{name} is kept in this browser.", name = kept),
                    };
                    answer.tell(Command::Library(LibraryCommand::Kept(name)));
                    answer.send(Command::notify(text));
                }
                Err(why) => answer.send(Command::notify(tr!(
                    "{name} is not kept: {why}",
                    name = name,
                    why = why
                ))),
            }
        });
    }

    /// Takes the folder at a path for one's own files.
    pub fn choose_folder(&self, ctx: &egui::Context, shelf: Arc<dyn Shelf>, folder: String) {
        let answer = self.answer(ctx);
        spawn(async move {
            answer.speak();
            if let Err(why) = shelf.choose(&folder) {
                answer.tell(Command::notify(why));
            }
            answer.send(Command::Library(LibraryCommand::LookAgain));
        });
    }

    /// Asks for the folder of one's own files.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn ask_folder(&self, ctx: &egui::Context) {
        let answer = self.answer(ctx);
        let opened = fallback::Opened::now();
        let picked = rfd::AsyncFileDialog::new().pick_folder();
        spawn(async move {
            match picked.await {
                Some(folder) => {
                    let folder = folder.path().to_string_lossy().into_owned();
                    answer.send(Command::Library(LibraryCommand::Choose(folder)));
                }
                None if opened.was_never_shown() => {
                    answer.speak();
                    let text = tr("No file dialog is available: type the path of the folder.");
                    answer.send(Command::notify(text.to_owned()));
                }
                // The user has thought better of it.
                None => {}
            }
        });
    }

    /// A page has no folders, and no button that asks for one.
    #[cfg(target_arch = "wasm32")]
    pub fn ask_folder(&self, ctx: &egui::Context) {
        let text = tr!("{folder}: a page has no folders", folder = tr("My files"));
        self.answer(ctx).send(Command::notify(text));
    }

    /// Asks where to save, and saves.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn save(&self, ctx: &egui::Context, name: &str, bytes: Vec<u8>) {
        let answer = self.answer(ctx);
        let name = name.to_owned();
        let opened = fallback::Opened::now();
        let picked = rfd::AsyncFileDialog::new().set_file_name(&name).save_file();
        spawn(async move {
            let picked = picked.await;
            answer.speak();
            match picked {
                Some(file) => {
                    let name = file.file_name();
                    // Not with the dialog's own writer: a full disk would spoil the file before.
                    answer.send(Command::notify(match crate::disk::write(file.path(), &bytes) {
                        Ok(()) => tr!("saved as {name}", name = name),
                        Err(error) => tr!("not saved: {error}", error = error.to_string()),
                    }));
                }
                None if opened.was_never_shown() => {
                    let text = std::env::current_dir()
                        .and_then(|folder| fallback::save(&folder, &name, &bytes))
                        .map_or_else(
                            |error| {
                                tr!(
                                    "No file dialog is available, and {name} could not be written: {error}",
                                    name = name,
                                    error = error.to_string()
                                )
                            },
                            |path| {
                                tr!(
                                    "No file dialog is available: saved as {path}",
                                    path = path.display().to_string()
                                )
                            },
                        );
                    answer.send(Command::notify(text));
                }
                // The user has thought better of it.
                None => {}
            }
        });
    }

    /// Hands the file to the browser's downloads.
    #[cfg(target_arch = "wasm32")]
    pub fn save(&self, ctx: &egui::Context, name: &str, bytes: Vec<u8>) {
        let text = match super::web::download(name, &bytes) {
            Ok(()) => tr!("saved as {name} in the browser's downloads", name = name),
            Err(_) => tr!("the browser did not take {name} for download", name = name),
        };
        self.answer(ctx).send(Command::notify(text));
    }
}

#[cfg(target_arch = "wasm32")]
impl Files {
    /// Puts a text into the clipboard, where the browser has one and does not refuse, and then does `copied` with it and
    /// whether it is there.
    pub fn copy(
        &self,
        ctx: &egui::Context,
        text: String,
        copied: impl FnOnce(String, bool) -> ShellCommand + 'static,
    ) {
        let answer = self.answer(ctx);
        spawn(async move {
            let is_there = super::web::copy(&text).await.is_ok();
            answer.send(Command::Shell(copied(text, is_there)));
        });
    }
}

/// Extension of files of networks and of saved searches.
const JSON: &str = "json";

/// The last part of a name that is parted by `/`.
fn last_of(name: &str) -> String {
    name.rsplit('/').next().unwrap_or_default().to_owned()
}

/// A command that brings measured data, with what is remembered of their layout.
fn remembering(command: Command, path: Option<PathBuf>, known: &KnownLayouts) -> Command {
    let Command::File(FileCommand::Bring(brought)) = command else { return command };
    let brought = match brought {
        BroughtFile::Measured(file) => {
            BroughtFile::Measured(Box::new(as_remembered(*file, path, known)))
        }
        BroughtFile::ToFit(file) => BroughtFile::ToFit(Box::new(as_remembered(*file, path, known))),
        other @ (BroughtFile::Table { .. }
        | BroughtFile::Program { .. }
        | BroughtFile::Mission { .. }
        | BroughtFile::Linked(_)
        | BroughtFile::Search { .. }) => other,
    };
    Command::File(FileCommand::Bring(brought))
}

/// That a file could not be read.
fn unread(name: &str, error: &str) -> String {
    tr!("{name} could not be read: {error}", name = name, error = error)
}

/// The command for measured data.
fn measured(name: String, bytes: &[u8]) -> Command {
    let file = MeasuredFile::read(name, bytes.into(), DataLayout::default());
    Command::File(FileCommand::Bring(BroughtFile::Measured(Box::new(file))))
}

/// The command for measured data that settings are fitted to.
fn to_fit(name: String, bytes: &[u8]) -> Command {
    let file = MeasuredFile::read(name, bytes.into(), DataLayout::default());
    Command::File(FileCommand::Bring(BroughtFile::ToFit(Box::new(file))))
}

/// The command for a file that was dropped while a screen was shown: a table with times lies over the plots, unless it is
/// dropped where formulas are searched for or settings are fitted.
#[must_use]
pub fn dropped(name: String, bytes: &[u8], target: DropTarget) -> Command {
    let of_spreadsheet = ends_with_one_of(&name, &TABLES);
    match target {
        DropTarget::Fits
            if of_spreadsheet
                || ends_with_one_of(&name, &MEASURED)
                || ends_with_one_of(&name, &TEXTS) && !is_toml(bytes) =>
        {
            return to_fit(name, bytes);
        }
        DropTarget::Fits | DropTarget::Plots | DropTarget::Formulas => {}
    }
    let is_table = of_spreadsheet && target != DropTarget::Formulas;
    let is_text = ends_with_one_of(&name, &TEXTS);
    let decoded = decode(bytes).ok();
    let is_other = decoded.as_deref().is_some_and(|text| match is_table {
        true => PartPath::is_meant_by(text),
        // What is read as a scenario has its own faults to tell.
        false => is_toml(bytes),
    });
    if (is_table || is_text) && !is_other {
        let file = MeasuredFile::read(name.clone(), bytes.into(), DataLayout::default());
        if file.is_measured() && (is_table || file.contents().is_ok()) {
            return Command::File(FileCommand::Bring(BroughtFile::Measured(Box::new(file))));
        }
    }
    loaded(name, bytes)
}

/// Whether a text can be read as a scenario or another file of the program.
fn is_toml(bytes: &[u8]) -> bool {
    decode(bytes).is_ok_and(|text| text.parse::<toml::Table>().is_ok())
}

/// The command for a file that was read.
#[must_use]
pub fn loaded(name: String, bytes: &[u8]) -> Command {
    let bring = |file| Command::File(FileCommand::Bring(file));
    match LibraryKind::opened_as(&name, bytes) {
        LibraryKind::Part | LibraryKind::Table => part_or_table(name, bytes),
        LibraryKind::Measured => measured(name, bytes),
        LibraryKind::Program => {
            text_of(name, bytes, |name, text| bring(BroughtFile::Program { name, text }))
        }
        LibraryKind::Script => text_of(name, bytes, |name, text| {
            Command::Session(SessionCommand::LoadScript { name, text })
        }),
        LibraryKind::Mission => {
            text_of(name, bytes, |name, text| bring(BroughtFile::Mission { name, text }))
        }
        LibraryKind::Tool
        | LibraryKind::Material
        | LibraryKind::Machine
        | LibraryKind::Structure => text_of(name, bytes, |name, text| {
            Command::Session(SessionCommand::LoadOwn { name, text })
        }),
        LibraryKind::Result => Command::notify(tr!(
            "{name} is the result of a mission: steadycut mission check {name} verifies it.",
            name = name
        )),
        LibraryKind::Search => search(name, bytes),
        LibraryKind::Networks => text_of(name, bytes, |name, text| {
            Command::Session(SessionCommand::LoadNetworks { name, text })
        }),
        // What is none of them has its own faults to tell as a scenario.
        LibraryKind::Scenario | LibraryKind::Formula | LibraryKind::Unreadable => {
            text_of(name, bytes, |name, text| {
                Command::Session(SessionCommand::LoadText { name, text })
            })
        }
    }
}

/// The command for a table that was dropped: the depths of a part, or a table that formulas are searched for in.
fn part_or_table(name: String, bytes: &[u8]) -> Command {
    match decode(bytes) {
        Ok(text) if PartPath::is_meant_by(&text) => match PartPath::read(&text) {
            Ok(path) => Command::Session(SessionCommand::TakePart { name, path: Box::new(path) }),
            Err(error) => Command::notify(format!("{name}: {error}")),
        },
        Ok(_) | Err(_) => table(name, bytes),
    }
}

/// The command for a table that was read.
fn table(name: String, bytes: &[u8]) -> Command {
    if ends_with_one_of(&name, &SPREADSHEETS) {
        return Command::notify(tr!(
            "{name} is a file of a spreadsheet: save it there as CSV, which can be opened and dropped here.",
            name = name
        ));
    }
    let bring = |name, text| Command::File(FileCommand::Bring(BroughtFile::Table { name, text }));
    text_of(name, bytes, bring)
}

/// The command for a saved search that was read.
fn search(name: String, bytes: &[u8]) -> Command {
    let bring = |name, text| Command::File(FileCommand::Bring(BroughtFile::Search { name, text }));
    text_of(name, bytes, bring)
}

fn text_of(name: String, bytes: &[u8], of: impl FnOnce(String, String) -> Command) -> Command {
    match decode(bytes) {
        Ok(text) => of(name, text),
        Err(error) => Command::notify(format!("{name}: {error}")),
    }
}

/// What a file of a scenario with these changes during the cut is called: a shipped one has the words of its title,
/// under which the window shows it, and says like the window where it is not what was shipped any more.
#[must_use]
pub fn called(scenario: &Scenario, edits: &Edits) -> String {
    let name = &scenario.info.name;
    let Some(title) = presets::title(name) else { return name.clone() };
    let words = title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    let changed = !edits.list().is_empty() || presets::is_changed(scenario);
    let words = words.map(str::to_lowercase).chain(changed.then(|| "changed".to_owned()));
    words.collect::<Vec<String>>().join("-")
}

/// A file's name that a scenario's name can become.
#[must_use]
pub fn file_name(scenario_name: &str, extension: &str) -> String {
    let plain = |c: char| if c.is_alphanumeric() || "-_ .".contains(c) { c } else { '_' };
    let name: String = scenario_name.trim().chars().map(plain).collect();
    let name = if name.is_empty() { "scenario".to_owned() } else { name };
    format!("{name}.{extension}")
}

#[cfg(target_arch = "wasm32")]
fn spawn(future: impl Future<Output = ()> + 'static) {
    wasm_bindgen_futures::spawn_local(future);
}

/// Waits for the dialog on a thread of its own: the window goes on.
#[cfg(not(target_arch = "wasm32"))]
#[expect(clippy::disallowed_methods, reason = "a file dialog must not stop the window")]
fn spawn(future: impl Future<Output = ()> + Send + 'static) {
    use std::task::{Context, Poll, Wake, Waker};

    struct Unpark(std::thread::Thread);
    impl Wake for Unpark {
        fn wake(self: std::sync::Arc<Self>) {
            self.0.unpark();
        }
    }

    std::thread::spawn(move || {
        let mut future = std::pin::pin!(future);
        let waker = Waker::from(std::sync::Arc::new(Unpark(std::thread::current())));
        while future.as_mut().poll(&mut Context::from_waker(&waker)) == Poll::Pending {
            std::thread::park();
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::run::edits::Edit;
    use crate::study::own_file::OwnFileKind;

    #[test]
    fn names_of_files_hold_nothing_but_plain_letters() {
        assert_eq!(file_name("../a/b:c", "toml"), ".._a_b_c.toml");
        assert_eq!(file_name("  ", "csv"), "scenario.csv");
    }

    #[test]
    fn a_shipped_scenario_is_saved_under_the_words_of_its_title() {
        let none = Edits::none();
        let mut scenario = presets::load("first-cut").unwrap();
        assert_eq!(called(&scenario, &none), "drag-the-target-roughness");
        let value = Value::Float(0.5);
        let mut edits = Edits::none();
        let edit = Edit { at_s: 1.0, path: "target.ra_um".to_owned(), value: value.clone() };
        edits.push(&scenario, edit).unwrap();
        assert_eq!(called(&scenario, &edits), "drag-the-target-roughness-changed");
        scenario.set("target.ra_um", value).unwrap();
        assert_eq!(called(&scenario, &none), "drag-the-target-roughness-changed");
        scenario.set("name", Value::Text("my own cut".to_owned())).unwrap();
        assert_eq!(called(&scenario, &edits), "my own cut");
        let shipped = presets::PRESETS.iter().map(|preset| presets::load(preset.name).unwrap());
        let names: std::collections::BTreeSet<String> =
            shipped.map(|scenario| called(&scenario, &none)).collect();
        assert_eq!(names.len(), presets::PRESETS.len(), "no two are called the same");
    }

    #[test]
    fn bytes_that_are_no_text_become_a_message() {
        let said = loaded("x.toml".to_owned(), b"Fr\xe4sen");
        let Command::Session(SessionCommand::Notify(said)) = said else { panic!("{said:?}") };
        assert!(said.starts_with("x.toml: ") && said.contains("Latin-1"), "{said}");
        let text = SessionCommand::LoadText { name: "x.toml".to_owned(), text: "x".to_owned() };
        for bytes in [&b"x"[..], b"\xef\xbb\xbfx", b"\xff\xfex\0", b"\xfe\xff\0x"] {
            assert_eq!(loaded("x.toml".to_owned(), bytes), Command::Session(text.clone()));
        }
        let script = loaded("x.rhai".to_owned(), b"x");
        assert!(
            matches!(script, Command::Session(SessionCommand::LoadScript { .. })),
            "{script:?}"
        );
        let plain = loaded("x.txt".to_owned(), b"x");
        assert!(matches!(plain, Command::Session(SessionCommand::LoadText { .. })), "{plain:?}");
        for kind in OwnFileKind::ALL {
            let own = loaded("x.toml".to_owned(), kind.template().as_bytes());
            assert!(matches!(own, Command::Session(SessionCommand::LoadOwn { .. })), "{own:?}");
        }
        assert!(matches!(
            loaded("x.JSON".to_owned(), b"x"),
            Command::Session(SessionCommand::LoadNetworks { .. })
        ));
    }

    #[test]
    fn tables_and_searches_go_to_their_screen() {
        let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
        let bytes = b"a,b\n1,2\n";
        let brought = BroughtFile::Table { name: "x.CSV".to_owned(), text: text(bytes) };
        assert_eq!(loaded("x.CSV".to_owned(), bytes), Command::File(FileCommand::Bring(brought)));
        let part = b"s,a_p,a_e\n0,2,3\n10,0,0\n";
        let Command::Session(SessionCommand::TakePart { name, path }) =
            loaded("x.csv".to_owned(), part)
        else {
            panic!("no part")
        };
        assert_eq!((name.as_str(), path.length_mm), ("x.csv", 10.0));
        let said = loaded("x.csv".to_owned(), b"s,a_p,a_e\n0,99,3\n10,0,0\n");
        let Command::Session(SessionCommand::Notify(said)) = said else { panic!("{said:?}") };
        assert!(said.starts_with("x.csv: line 2, column `a_p`"), "{said}");
        let bytes = b"t,Fx\n0.0,1\n0.1,2\n0.2,3\n";
        for (target, brought) in [
            (DropTarget::Plots, "Measured"),
            (DropTarget::Formulas, "Table"),
            (DropTarget::Fits, "ToFit"),
        ] {
            let said = format!("{:?}", dropped("x.csv".to_owned(), bytes, target));
            assert!(said.contains(&format!("Bring({brought}")), "{said}");
        }
        let said = format!("{:?}", dropped("x.csv".to_owned(), b"a,b\n1,2\n", DropTarget::Plots));
        assert!(said.contains("Bring(Table"), "without times it is a table: {said}");
        let said = format!(
            "{:?}",
            dropped("x.txt".to_owned(), b"t Fx\n0.0 1\n0.1 2\n", DropTarget::Plots)
        );
        assert!(said.contains("Bring(Measured"), "{said}");
        let said = format!("{:?}", dropped("x.txt".to_owned(), b"version = 1\n", DropTarget::Fits));
        assert!(said.contains("LoadText"), "{said}");
        let said = format!("{:?}", loaded("x.TDMS".to_owned(), b"TDSm"));
        assert!(said.contains("Bring(Measured"), "{said}");
        let bytes = b"G0 X1\n";
        let brought = BroughtFile::Program { name: "x.nc".to_owned(), text: text(bytes) };
        assert_eq!(loaded("x.nc".to_owned(), bytes), Command::File(FileCommand::Bring(brought)));
        let said = loaded("x.xlsx".to_owned(), b"PK");
        let Command::Session(SessionCommand::Notify(said)) = said else { panic!("{said:?}") };
        assert!(said.starts_with("x.xlsx is a file of a spreadsheet"), "{said}");
        let said = loaded("x.json".to_owned(), br#"{"format":"steadycut mission result"}"#);
        let Command::Session(SessionCommand::Notify(said)) = said else { panic!("{said:?}") };
        assert!(said.contains("steadycut mission check x.json"), "{said}");
        let bytes = br#"{"version":1,"problem":"00","islands":[]}"#;
        let brought = BroughtFile::Search { name: "x.json".to_owned(), text: text(bytes) };
        assert_eq!(loaded("x.json".to_owned(), bytes), Command::File(FileCommand::Bring(brought)));
    }
}

//! Finds settings, scenarios, screens, commands and words from any screen: a setting found is set there and
//! then.

use egui::{
    Align2, Context, Key, RichText, Role, ScrollArea, TextEdit, ThemePreference, Ui, Vec2,
    WidgetInfo,
};

use super::bar::Tab;
use super::command::{Command, FileCommand, SessionCommand, ShellCommand};
use super::panels::View;
use super::shortcuts;
use super::theme::Palette;
use super::widgets::setting::{Size, setting};
use super::widgets::window;
use crate::run::glossary::{GLOSSARY, Term};
use crate::run::presets::{PRESETS, Preset};
use crate::run::scenario::{Param, table};
use crate::study::uses::Screen;

/// Most results that are shown: whoever sees so many types another word.
const MOST: usize = 14;
/// Width of the window where there is room, points.
const WIDTH: f32 = 520.0;

/// Something that can be found.
#[derive(Clone, Debug)]
enum Entry {
    Setting(&'static Param),
    Scenario(&'static Preset),
    Screen { id: &'static str, title: &'static str, words: &'static str },
    Command { doing: &'static str, words: &'static str, command: Command },
    Word(&'static Term),
}

impl Entry {
    /// Its name, and what else it can be found by.
    fn texts(&self) -> (String, String) {
        match self {
            Self::Setting(param) => {
                (param.spec.label.to_owned(), format!("{} {}", param.path, param.spec.doc))
            }
            Self::Scenario(preset) => {
                (preset.title.to_owned(), format!("{} {}", preset.name, preset.group.label()))
            }
            Self::Screen { id, title, words } => {
                ((*title).to_owned(), format!("screen {id} {words}"))
            }
            Self::Command { doing, words, .. } => ((*doing).to_owned(), (*words).to_owned()),
            Self::Word(term) => (term.spellings.join(", "), term.meaning.to_owned()),
        }
    }

    /// How well it fits the words of a query, in small letters: the less the better; none if it does not.
    fn fit(&self, query: &str) -> Option<u8> {
        let (name, rest) = self.texts();
        let (name, rest) = (name.to_lowercase(), rest.to_lowercase());
        let mut words = query.split_whitespace();
        if !words.clone().all(|word| name.contains(word) || rest.contains(word)) {
            return None;
        }
        Some(match () {
            () if name.starts_with(query) => 0,
            () if name.contains(query) => 1,
            () if words.all(|word| name.contains(word)) => 2,
            () => 3,
        })
    }
}

/// Commands that have no key.
fn without_key() -> Vec<(&'static str, Command)> {
    let file = Command::File;
    let theme = |preference| Command::Shell(ShellCommand::Theme(preference));
    vec![
        ("Search formulas in a table of one's own", file(FileCommand::OpenTable)),
        ("Go on with a saved search for a formula", file(FileCommand::OpenSearch)),
        ("Open networks of UNKS", file(FileCommand::OpenNetworks)),
        ("Save the networks of UNKS", file(FileCommand::SaveNetworks)),
        ("Keys and gestures", Command::Shell(ShellCommand::ShowShortcuts(true))),
        ("Light colours", theme(ThemePreference::Light)),
        ("Dark colours", theme(ThemePreference::Dark)),
        ("Colours as the system has them", theme(ThemePreference::System)),
    ]
}

/// What else a command is looked for by: words of those who do not know its name yet.
fn words(command: &Command) -> &'static str {
    match command {
        Command::File(command) => match command {
            FileCommand::Open => "load toml data own",
            FileCommand::Save => "download keep toml",
            FileCommand::ExportCsv => "save table data results measurements download spreadsheet",
            FileCommand::CopyLink => {
                "digest share address url command line terminal headless repeat reproduce send"
            }
            FileCommand::OpenTable => "identify own data measured measurements csv upload import",
            FileCommand::OpenSearch => "identify resume json",
            FileCommand::OpenNetworks | FileCommand::SaveNetworks => "neural learning weights json",
            FileCommand::SaveCsv { .. }
            | FileCommand::SaveText { .. }
            | FileCommand::Bring(_)
            | FileCommand::OpenFormula(_) => "",
        },
        Command::Shell(ShellCommand::ShowShortcuts(_)) => {
            "help keyboard shortcuts hotkeys touch swipe pinch finger"
        }
        Command::Shell(ShellCommand::Theme(_)) => "theme contrast mode",
        Command::Playback(_) => "playback transport",
        Command::Session(_) | Command::Shell(_) => "",
    }
}

/// All entries, those that are asked for most first.
fn entries(view: &View<'_>, screens: &[Tab]) -> Vec<Entry> {
    let settings = table().iter().map(Entry::Setting);
    let scenarios = PRESETS.iter().map(Entry::Scenario);
    let screens =
        screens.iter().map(|tab| Entry::Screen { id: tab.id, title: tab.title, words: tab.words });
    let commands =
        shortcuts::commands(view.place).into_iter().chain(without_key()).map(|(doing, command)| {
            let words = words(&command);
            Entry::Command { doing, words, command }
        });
    let words = GLOSSARY.iter().map(Entry::Word);
    settings.chain(scenarios).chain(screens).chain(commands).chain(words).collect()
}

/// What fits a query, the best first.
fn found(query: &str, entries: Vec<Entry>) -> Vec<Entry> {
    let query = query.trim().to_lowercase();
    if query.is_empty() {
        return Vec::new();
    }
    let mut fitting: Vec<(u8, Entry)> =
        entries.into_iter().filter_map(|entry| Some((entry.fit(&query)?, entry))).collect();
    fitting.sort_by_key(|(fit, _)| *fit);
    fitting.into_iter().map(|(_, entry)| entry).collect()
}

/// The window.
#[derive(Debug, Default)]
pub struct Finder {
    open: bool,
    /// Whether it was opened in this frame: the field takes the focus.
    opened: bool,
    text: String,
}

impl Finder {
    /// Opens or closes it.
    pub fn show_it(&mut self, open: bool) {
        self.opened = open && !self.open;
        self.open = open;
        if self.opened {
            self.text.clear();
        }
    }

    /// Whether it is open.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.open
    }

    /// Draws it where it is open.
    pub fn ui(
        &mut self,
        ctx: &Context,
        view: &View<'_>,
        screens: &[Tab],
        commands: &mut Vec<Command>,
    ) {
        if !self.open {
            return;
        }
        let screen = ctx.content_rect();
        let mut open = true;
        let window = egui::Window::new("Find")
            .collapsible(false)
            .resizable(false)
            .anchor(Align2::CENTER_TOP, Vec2::new(0.0, 48.0));
        let width = WIDTH.min(screen.width() - 24.0);
        window::closable(ctx, "Find", window, Some(width), &mut open, |ui| {
            self.body(ui, view, screens, commands);
        });
        self.open &= open;
    }

    fn body(&mut self, ui: &mut Ui, view: &View<'_>, screens: &[Tab], commands: &mut Vec<Command>) {
        let field = TextEdit::singleline(&mut self.text)
            .hint_text("Setting, scenario, screen, command or word")
            .desired_width(f32::INFINITY);
        let response = ui.add(field);
        let text = self.text.clone();
        response.widget_info(|| WidgetInfo::text_edit(true, "", &text, "Find"));
        if std::mem::take(&mut self.opened) {
            response.request_focus();
        }
        let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        let found = found(&self.text, entries(view, screens));
        if self.text.trim().is_empty() {
            ui.weak("Type a word: dead time, Kp, chatter, noise, CSV …");
            return;
        }
        if found.is_empty() {
            ui.label("Nothing has these words. Fewer or shorter ones find more.");
            return;
        }
        // Words explain themselves; a setting that fits best is not passed over.
        let best = found.iter().find(|entry| match entry {
            Entry::Setting(_)
            | Entry::Scenario(_)
            | Entry::Screen { .. }
            | Entry::Command { .. } => true,
            Entry::Word(_) => false,
        });
        if entered && let Some(command) = best.and_then(|best| self.choose(best)) {
            commands.push(command);
            return;
        }
        let height = 0.6 * ui.ctx().content_rect().height();
        ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
            for entry in found.iter().take(MOST) {
                ui.separator();
                if self.row(ui, view, entry, commands)
                    && let Some(command) = self.choose(entry)
                {
                    commands.push(command);
                }
            }
            if let Some(more) = found.len().checked_sub(MOST).filter(|more| *more > 0) {
                ui.separator();
                ui.weak(format!("{more} more: another word narrows them down."));
            }
        });
    }

    /// What choosing an entry does, with the window closed; nothing for what is used where it stands.
    fn choose(&mut self, entry: &Entry) -> Option<Command> {
        let command = match entry {
            Entry::Setting(_) | Entry::Word(_) => return None,
            Entry::Scenario(preset) => {
                Command::Session(SessionCommand::LoadPreset(preset.name.to_owned()))
            }
            Entry::Screen { id, .. } => Command::Shell(ShellCommand::ShowScreen(id)),
            Entry::Command { command, .. } => command.clone(),
        };
        self.open = false;
        Some(command)
    }

    /// One result; whether it was chosen.
    fn row(
        &self,
        ui: &mut Ui,
        view: &View<'_>,
        entry: &Entry,
        commands: &mut Vec<Command>,
    ) -> bool {
        let weak = Palette::at(ui).weak;
        let mut button = |kind: &str, name: &str| {
            let response = ui.horizontal_wrapped(|ui| {
                let response = ui.button(name);
                ui.label(RichText::new(kind).color(weak));
                response
            });
            let response = response.inner;
            response
                .widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{kind}: {name}")));
            response.clicked()
        };
        match entry {
            Entry::Setting(param) => {
                setting(
                    ui,
                    Screen::Find,
                    &param.path,
                    view.session.current(),
                    Size::Small,
                    commands,
                );
                ui.label(RichText::new(&param.path).small().color(weak));
                false
            }
            Entry::Scenario(preset) => button("scenario", preset.title),
            Entry::Screen { title, .. } => button("screen", title),
            Entry::Command { doing, .. } => button("command", doing),
            Entry::Word(term) => {
                ui.label(RichText::new(term.spellings.join(", ")).strong());
                ui.label(term.meaning);
                false
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(query: &str) -> Vec<String> {
        let entries = table().iter().map(Entry::Setting).chain(PRESETS.iter().map(Entry::Scenario));
        found(query, entries.collect()).iter().map(|entry| entry.texts().0).collect()
    }

    #[test]
    fn words_find_settings_and_scenarios_the_best_first() {
        assert_eq!(names("dead time")[0], "Dead time");
        assert!(names("dead time").len() > 1, "what the controller believes has one too");
        assert_eq!(names("DEAD TIME"), names("dead time"));
        assert!(names("cnc.dead_time_s").contains(&"Dead time".to_owned()));
        assert_eq!(names("chatter")[0], "A deeper stretch brings chatter");
        assert!(names("table3-5").contains(&"Table 3, simulation 5".to_owned()));
        assert!(names("time dead").contains(&"Dead time".to_owned()), "in any order");
        assert_eq!(names(""), [""; 0]);
        assert_eq!(names("no such word"), [""; 0]);
    }
}

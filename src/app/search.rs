//! Finds settings, scenarios, screens, commands and words from any screen: a setting found is set there and
//! then.

use egui::text::{CCursor, CCursorRange};
use egui::{
    Align2, Context, Id, Key, RichText, Role, ScrollArea, TextEdit, ThemePreference, Ui, Vec2,
    WidgetInfo,
};

use super::bar::Tab;
use super::command::{
    Command, FileCommand, HandCommand, LibraryCommand, PlaybackCommand, SessionCommand,
    ShellCommand,
};
use super::panels::View;
use super::panels::console::{CUT_BY_HAND, group_title};
use super::panels::identify::{FITS, IDENTIFY};
use super::shortcuts;
use super::theme::Palette;
use super::widgets::setting::{Reason, Size, not_used, setting};
use super::widgets::window;
use crate::base::language::{Language, text, tr};
use crate::base::settings::Field;
use crate::blocks::control::ControllerKind;
use crate::run::glossary::{GLOSSARY, Term};
use crate::run::presets::{PRESETS, Preset};
use crate::run::scenario::{Param, Scenario, table};
use crate::study::uses::Screen;

/// Most results that are shown: whoever sees so many types another word.
const MOST: usize = 14;
/// Width of the window where there is room, points.
const WIDTH: f32 = 520.0;

/// Letters from which on a word is also looked for inside of others: "kp" is not meant where "workpiece" stands.
const INSIDE: usize = 4;

/// Whether a word stands in a text, both in small letters.
fn has(text: &str, word: &str) -> bool {
    let begins = |part: &str| part.starts_with(word);
    text.split(|c: char| !c.is_alphanumeric()).any(begins)
        || text.starts_with(word)
        || (word.chars().count() >= INSIDE && text.contains(word))
}

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
    /// Its name, and what else it can be found by, as `said`.
    fn texts(&self, said: fn(&'static str) -> &'static str) -> [String; 2] {
        match self {
            Self::Setting(param) => [
                said(param.spec.label).to_owned(),
                format!("{} {}", param.path, said(param.spec.doc)),
            ],
            Self::Scenario(preset) => [
                said(preset.title).to_owned(),
                format!("{} {}", preset.name, said(preset.group.label())),
            ],
            Self::Screen { id, title, words } => {
                [said(title).to_owned(), format!("{} {id} {}", said(text!("screen")), said(words))]
            }
            Self::Command { doing, words, .. } => [said(doing).to_owned(), said(words).to_owned()],
            Self::Word(term) => [term.written(), said(term.meaning).to_owned()],
        }
    }

    /// How well it fits the words of a query, in small letters: the less the better; none if it does not. What is
    /// English is found whatever the language is: manuals and papers have those words.
    fn fit(&self, query: &str) -> Option<u8> {
        let texts = [tr as fn(&'static str) -> &'static str, |text| text]
            .map(|said| self.texts(said).map(|text| text.to_lowercase()));
        let names = || texts.iter().map(|[name, _]| name);
        let mut words = query.split_whitespace();
        if !words.clone().all(|word| texts.iter().flatten().any(|text| has(text, word))) {
            return None;
        }
        Some(match () {
            () if names().any(|name| name.starts_with(query)) => 0,
            () if names().any(|name| has(name, query)) => 1,
            () if words.all(|word| names().any(|name| has(name, word))) => 2,
            () => 3,
        })
    }
}

/// Commands that have no key.
fn without_key() -> Vec<(&'static str, Command)> {
    let file = Command::File;
    let theme = |preference| Command::Shell(ShellCommand::Theme(preference));
    vec![
        (text!("Search formulas in a table of one's own"), file(FileCommand::OpenTable)),
        (text!("Open a part of one's own: table or G-code"), file(FileCommand::OpenPart)),
        (text!("Lay measured data over the plots"), file(FileCommand::OpenMeasured)),
        (
            text!("My files: cutters, materials, machines, parts and more of one's own"),
            Command::Library(LibraryCommand::Show { open: true, kind: None }),
        ),
        (
            text!("Fit settings to measured data"),
            Command::Shell(ShellCommand::ShowPart(IDENTIFY, FITS)),
        ),
        (text!("Open measured data to fit settings to"), file(FileCommand::OpenFit)),
        (text!("Go on with a saved search for a formula"), file(FileCommand::OpenSearch)),
        (text!("Open networks of UNKS"), file(FileCommand::OpenNetworks)),
        (text!("Save the networks of UNKS"), file(FileCommand::SaveNetworks)),
        (CUT_BY_HAND, Command::hand(HandCommand::CutByHand)),
        (text!("Keys and gestures"), Command::Shell(ShellCommand::ShowShortcuts(true))),
        (text!("Light colours"), theme(ThemePreference::Light)),
        (text!("Dark colours"), theme(ThemePreference::Dark)),
        (text!("Colours as the system has them"), theme(ThemePreference::System)),
        (text!("Large type, for a projector"), Command::Shell(ShellCommand::Projector(true))),
        (text!("Type of the usual size"), Command::Shell(ShellCommand::Projector(false))),
        (text!("Less motion"), Command::Shell(ShellCommand::LessMotion(true))),
        (text!("Motion as usual"), Command::Shell(ShellCommand::LessMotion(false))),
        // Each in its own language: whoever looks for it may read no other.
        ("English", Command::Shell(ShellCommand::Speak(Language::English))),
        ("Slovenščina", Command::Shell(ShellCommand::Speak(Language::Slovenian))),
        ("Deutsch", Command::Shell(ShellCommand::Speak(Language::German))),
    ]
}

/// What fits are looked for by.
const FIT_WORDS: &str = text!(
    "identify own recording measurements drive dead time lag step force coefficients kienzle run-out structure modes impact frequency response noise ripple wear taylor material hardness"
);

/// What else a command is looked for by: words of those who do not know its name yet.
fn words(command: &Command) -> &'static str {
    match command {
        Command::File(command) => match command {
            FileCommand::Open => text!("load toml data own"),
            FileCommand::Save => text!("download keep toml"),
            FileCommand::ExportCsv => {
                text!("save table data results measurements download spreadsheet")
            }
            FileCommand::CopyLink => {
                text!(
                    "qr code class phone digest share address url command line terminal headless repeat reproduce send"
                )
            }
            FileCommand::OpenTable => {
                text!("identify own data measured measurements csv upload import")
            }
            FileCommand::OpenPart => {
                text!("workpiece cam nc gcode program csv depths import own blank")
            }
            FileCommand::OpenMeasured => {
                text!(
                    "own data measurements csv matlab mat tdms labview parquet hdf5 dynamometer channel overlay compare import"
                )
            }
            FileCommand::OpenFit => FIT_WORDS,
            FileCommand::OpenSearch => text!("identify resume json"),
            FileCommand::OpenNetworks | FileCommand::SaveNetworks => {
                text!("neural learning weights json")
            }
            FileCommand::SaveCsv { .. }
            | FileCommand::SaveText { .. }
            | FileCommand::SaveBytes { .. }
            | FileCommand::CopyLinkTo(_)
            | FileCommand::CopyText { .. }
            | FileCommand::Bring(_)
            | FileCommand::RememberLayout(_)
            | FileCommand::OpenFormula(_) => "",
        },
        Command::Shell(ShellCommand::ShowPart(..)) => FIT_WORDS,
        Command::Shell(ShellCommand::ShowShortcuts(_)) => {
            text!("help about introduction keyboard shortcuts hotkeys touch swipe pinch finger")
        }
        Command::Shell(ShellCommand::Theme(_)) => text!("theme contrast mode"),
        Command::Shell(ShellCommand::Projector(_)) => {
            text!("zoom big font size beamer class letters")
        }
        Command::Shell(ShellCommand::Speak(_)) => {
            text!("language sprache jezik slovene slovenian german deutsch en sl de")
        }
        Command::Shell(ShellCommand::LessMotion(_)) => {
            text!("animation reduced accessibility still")
        }
        Command::Playback(PlaybackCommand::TryAgain) => {
            text!("back retry repeat breakage scrap stop crash broken mishap rewind")
        }
        Command::Playback(_) => text!("playback transport"),
        Command::Session(SessionCommand::CutAgain) => {
            text!("restart repeat from the start rerun begin anew keep settings")
        }
        Command::Session(SessionCommand::Disturb(_)) => {
            text!("disturb disturbance fault trouble error hurt accident upset damage")
        }
        Command::Session(SessionCommand::Hand(_)) => {
            text!(
                "operator override manual hand knob panel handwheel wheel drive myself score beat"
            )
        }
        Command::Library(_) => {
            text!(
                "library folder tool material machine structure part script own keep catalogue kept"
            )
        }
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

/// What fits a query, the best first, and what cannot be used as things stand after all that can.
fn found(query: &str, entries: Vec<Entry>, can_be_used: impl Fn(&Entry) -> bool) -> Vec<Entry> {
    let query = query.trim().to_lowercase();
    if query.is_empty() {
        return Vec::new();
    }
    let mut fitting: Vec<((bool, u8), Entry)> = entries
        .into_iter()
        .filter_map(|entry| {
            let fit = entry.fit(&query)?;
            Some(((!can_be_used(&entry), fit), entry))
        })
        .collect();
    fitting.sort_by_key(|(place, _)| *place);
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
    /// Opens or closes it; what was looked for last stands there, to be replaced or used again.
    pub fn show_it(&mut self, open: bool) {
        // Asked for again while it is open, it is to be written in again.
        self.opened = open;
        self.open = open;
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
        // The same window in every language.
        let window = egui::Window::new(tr("Find"))
            .id(Id::unique("Find"))
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
            .id(Id::unique("what is looked for"))
            .hint_text(tr("Setting, scenario, screen, command or word"))
            .desired_width(f32::INFINITY);
        let mut shown = field.show(ui);
        let text = self.text.clone();
        let response = &shown.response;
        response.widget_info(|| WidgetInfo::text_edit(true, "", &text, tr("Find")));
        if std::mem::take(&mut self.opened) {
            response.request_focus();
            let all = CCursorRange::two(CCursor::new(0), CCursor::new(text.chars().count()));
            shown.state.cursor.set_char_range(Some(all));
            shown.state.store(ui.ctx(), response.id);
        }
        let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        let scenario = view.session.current();
        let can_be_used = |entry: &Entry| match entry {
            Entry::Setting(param) => Screen::Find.greyed(scenario, &param.path).is_none(),
            Entry::Scenario(_) | Entry::Screen { .. } | Entry::Command { .. } | Entry::Word(_) => {
                true
            }
        };
        let found = found(&self.text, entries(view, screens), can_be_used);
        if self.text.trim().is_empty() {
            ui.weak(tr("Type a word: dead time, Kp, chatter, noise, CSV …"));
            return;
        }
        if found.is_empty() {
            ui.label(tr("Nothing has these words. Fewer or shorter ones find more."));
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
                ui.weak(tr!("{more} more: another word narrows them down.", more = more));
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
                // Settings of several groups have the same name.
                let group = param.path.rsplit_once('.').map_or("", |(group, _)| group);
                let group = group_title(group).map_or(group, tr);
                let text = tr!("in {group}: {path}", group = group, path = param.path);
                ui.label(RichText::new(text).small().color(weak));
                way_to_use(ui, param, view.session.current(), commands);
                false
            }
            Entry::Scenario(preset) => button(tr("scenario"), tr(preset.title)),
            Entry::Screen { title, .. } => button(tr("screen"), tr(title)),
            Entry::Command { doing, .. } => button(tr("command"), tr(doing)),
            Entry::Word(term) => {
                ui.label(RichText::new(term.written()).strong());
                ui.label(tr(term.meaning));
                false
            }
        }
    }
}

/// Below a setting that nothing uses as things stand: why, and what would use it, to be set there and then.
fn way_to_use(ui: &mut Ui, param: &Param, scenario: &Scenario, commands: &mut Vec<Command>) {
    let Some(because) = Screen::Find.greyed(scenario, &param.path) else { return };
    let reason = Reason::of(&because);
    ui.label(RichText::new(not_used(&reason)).small());
    let of = ControllerKind::ALL.iter().find(|kind| kind.group() == param.group);
    if let Some(kind) = of.filter(|kind| **kind != scenario.controller.kind) {
        let name = tr!("Control by {controller}", controller = tr(kind.label()));
        if ui.button(name).clicked() {
            commands.push(Command::set("controller.kind", kind.to_value()));
        }
        return;
    }
    ui.push_id(&param.path, |ui| {
        for other in reason.settings {
            setting(ui, Screen::Find, &other.path, scenario, Size::Small, commands);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::language;

    fn name(entry: &Entry) -> String {
        let [name, _] = entry.texts(|text| text);
        name
    }

    fn names(query: &str) -> Vec<String> {
        let entries = table().iter().map(Entry::Setting).chain(PRESETS.iter().map(Entry::Scenario));
        found(query, entries.collect(), |_| true).iter().map(name).collect()
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
        let no_dead_time = |entry: &Entry| name(entry) != "Dead time";
        let entries = || table().iter().map(Entry::Setting).collect();
        let last = name(found("dead time", entries(), no_dead_time).last().unwrap());
        assert_eq!(last, "Dead time", "what is greyed comes last");
        assert_eq!(names(""), [""; 0]);
        assert_eq!(names("no such word"), [""; 0]);
    }

    #[test]
    fn words_of_the_chosen_language_find_and_english_ones_as_well() {
        let said = |text: &'static str| if text == "Dead time" { "Totzeit" } else { text };
        let entry = table().iter().map(Entry::Setting).find(|entry| name(entry) == "Dead time");
        assert_eq!(entry.unwrap().texts(said)[0], "Totzeit");
        let missed = |language: Language| {
            language::choose(language);
            let label = |param: &Param| [param.spec.label, tr(param.spec.label)].map(str::to_owned);
            let labels = table().iter().flat_map(label);
            let missed: Vec<String> = labels.filter(|label| names(label).is_empty()).collect();
            language::choose(Language::English);
            missed
        };
        assert_eq!(missed(Language::German), [""; 0]);
        assert_eq!(missed(Language::Slovenian), [""; 0]);
    }
}

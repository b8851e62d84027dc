//! The strip at the head of the window: screens, files, undo and redo, light or dark, messages, and what is
//! worked at.

use egui::{Button, RichText, Role, ThemePreference, Ui, WidgetInfo};

use super::command::{Command, FileCommand, SessionCommand, ShellCommand};
use super::jobs;
use super::messages;
use super::panels::View;
use super::session::MissionLock;
use super::shortcuts;
use super::theme::Palette;
use super::timeline;
use super::widgets::icon::{self, Icon};
use super::widgets::my_files::my_files;
use super::widgets::touch;
use crate::base::language::{self, Language, text, tr};
use crate::study::opening::FramePart;

/// Id of the screen with the missions.
pub const LEARN: &str = "learn";

/// A screen as the tabs show it.
pub struct Tab {
    /// Id of the screen.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// What else it is looked for by.
    pub words: &'static str,
}

/// Name of the program, tabs, and the other commands (in a menu where it is narrow).
pub fn show(ui: &mut Ui, view: &View<'_>, tabs: &[Tab], shown: &str, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let id = egui::Id::unique("room of the commands");
        let room = ui.data(|data| data.get_temp::<Room>(id)).unwrap_or_default();
        let spacing = ui.spacing().clone();
        if view.narrow {
            ui.spacing_mut().item_spacing.x = 3.0;
            ui.spacing_mut().button_padding.x = 5.0;
        }
        let gaps = ui.spacing().item_spacing;
        // Whatever comes and goes beside them, the tabs stay where they are.
        let beside = room.commands + if view.narrow { 0.0 } else { RESERVED };
        let loose = tabs_width(ui, tabs) + beside;
        let tight = loose - tabs.len() as f32 * (gaps.x - TIGHT);
        if !view.narrow {
            name_before(ui, tight);
        }
        if tight <= ui.available_width() {
            if view.narrow {
                name_in(ui, ui.available_width() - loose);
            }
            if loose > ui.available_width() {
                ui.spacing_mut().item_spacing.x = TIGHT;
            }
            for tab in tabs {
                let text = RichText::new(tr(tab.title)).strong();
                if ui.selectable_label(tab.id == shown, text).clicked() {
                    commands.push(Command::Shell(ShellCommand::ShowScreen(tab.id)));
                }
            }
            ui.spacing_mut().item_spacing = gaps;
        } else {
            *ui.spacing_mut() = spacing;
            choice(ui, view, tabs, shown, commands);
            if view.narrow {
                name_in(ui, ui.available_width() - room.all);
            }
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if view.narrow {
                menu(ui, view, commands);
            } else {
                help(ui, commands);
                theme_button(ui, commands);
                language_button(ui, commands);
                find(ui, view, commands);
                ui.separator();
                if !view.frame.hides(FramePart::Files) {
                    // No rule between these: the tabs need the room.
                    file_buttons(ui, view, commands);
                }
                undo_buttons(ui, view, commands);
            }
            let commands = ui.min_rect().width() + GAP;
            // At the end of the row, where nothing moves when they come.
            messages::button(ui, view.session.notices());
            jobs::show(ui, view.jobs);
            let taken = Room { commands, all: ui.min_rect().width() + GAP };
            if taken != room {
                // The tabs beside them are laid out again.
                ui.data_mut(|data| data.insert_temp(id, taken));
                ui.ctx().request_repaint();
            }
        });
    });
}

/// Says on the other screens that a mission is open, and leads back to it: what it locks is refused there.
pub fn open_mission(ui: &mut Ui, view: &View<'_>, lock: &MissionLock, commands: &mut Vec<Command>) {
    let title = tr(&lock.title);
    let words = if view.narrow {
        tr!("Mission: {title}", title = title)
    } else {
        tr!(
            "Mission \u{201c}{title}\u{201d} is open: what it does not let you change is locked",
            title = title
        )
    };
    let from_right = egui::Layout::right_to_left(egui::Align::Center);
    ui.horizontal(|ui| {
        ui.with_layout(from_right, |ui| {
            let help = tr("The cut stays as it is, and all of it can be changed again");
            // On a phone the title needs the room.
            let leave = if view.narrow { tr("Leave") } else { tr("Leave the mission") };
            let leave = ui.add(Button::new(leave).min_size(touch::least(ui)));
            if leave.on_hover_text(help).clicked() {
                commands.push(Command::Session(SessionCommand::EndMission));
            }
            let help = tr("Task, hints and answer of the mission: on the screen Learn");
            if ui.button(tr("Back to the mission")).on_hover_text(help).clicked() {
                commands.push(Command::Shell(ShellCommand::ShowScreen(LEARN)));
            }
            ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                ui.add(egui::Label::new(RichText::new(words).strong()).truncate());
            });
        })
    });
}

/// What the commands beside the tabs take, points: without and with messages and jobs, which come and go.
#[derive(Clone, Copy, Default, PartialEq)]
struct Room {
    commands: f32,
    all: f32,
}

/// The program's name before the tabs, which take `needed` points at least. Where they have room without it alone they are
/// worth more than it.
fn name_before(ui: &mut Ui, needed: f32) {
    /// Space behind the name, points.
    const BEHIND: f32 = 8.0;
    let name = RichText::new("SteadyCut").heading().strong().color(Palette::at(ui).accent);
    let name = egui::WidgetText::from(name);
    let extend = Some(egui::TextWrapMode::Extend);
    let galley = name.clone().into_galley(ui, extend, f32::INFINITY, egui::TextStyle::Body);
    let taken = galley.size().x + ui.spacing().item_spacing.x + BEHIND;
    let room = ui.available_width();
    if needed < room - taken || needed > room {
        ui.label(name);
        ui.add_space(BEHIND);
    }
}

/// The program's name, if it fits in what is left of a narrow row.
fn name_in(ui: &mut Ui, width: f32) {
    let color = Palette::at(ui).accent;
    let name = RichText::new("SteadyCut").strong().color(color);
    let label = egui::Label::new(name).extend().selectable(false);
    let font = egui::TextStyle::Body.resolve(ui.style());
    let needed = ui.painter().layout_no_wrap("SteadyCut".to_owned(), font, color).size().x;
    if needed + 2.0 * ui.spacing().item_spacing.x <= width {
        ui.add(label);
    }
}

/// Room between the tabs and the other commands, points.
const GAP: f32 = 12.0;
/// Room that is kept for messages and jobs beside the tabs, points.
const RESERVED: f32 = 110.0;
/// Space between tabs where there is little of it, points.
const TIGHT: f32 = 1.0;

/// The width of all tabs beside each other.
fn tabs_width(ui: &Ui, tabs: &[Tab]) -> f32 {
    let font = egui::TextStyle::Button.resolve(ui.style());
    let spacing = ui.spacing();
    let around = 2.0 * spacing.button_padding.x + spacing.item_spacing.x;
    let wide = |title: &str| {
        let text = title.to_owned();
        ui.painter().layout_no_wrap(text, font.clone(), egui::Color32::PLACEHOLDER).size().x
    };
    tabs.iter().map(|tab| wide(tr(tab.title)) + around).sum()
}

/// The screens as a list to choose from, where tabs have no room.
fn choice(ui: &mut Ui, view: &View<'_>, tabs: &[Tab], shown: &str, commands: &mut Vec<Command>) {
    let title = tabs.iter().find(|tab| tab.id == shown).map_or("", |tab| tr(tab.title));
    let list = egui::ComboBox::from_id_salt("screen")
        .selected_text(RichText::new(title).strong())
        // All of them at once.
        .height(f32::INFINITY);
    let list = list.show_ui(ui, |ui| {
        for tab in tabs {
            if ui.selectable_label(tab.id == shown, tr(tab.title)).clicked() {
                commands.push(Command::Shell(ShellCommand::ShowScreen(tab.id)));
                // A pointer closes a list by itself, a key or a screen reader does not.
                ui.close();
            }
        }
    });
    let response = list.response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr("Screen")));
    let keys = (0..2).filter_map(|order| shortcuts::screen_key(order, view.place));
    let keys: Vec<String> = keys.map(|keys| shortcuts::named(ui.ctx(), &keys)).collect();
    response.on_hover_text(tr!("Screens ({keys}, …)", keys = keys.join(", ")));
}

fn menu(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let about = tr("Files, undo, colours, keys, search");
    let response = icon::button(ui, Icon::Menu, tr("Menu"), about, true);
    egui::Popup::menu(&response).show(|ui| {
        let before = commands.len();
        ui.horizontal(|ui| {
            undo_buttons(ui, view, commands);
            theme_button(ui, commands);
            help(ui, commands);
            find(ui, view, commands);
        });
        ui.horizontal(|ui| language_menu(ui, commands));
        ui.separator();
        if !view.frame.hides(FramePart::Files) {
            file_buttons(ui, view, commands);
            my_files(ui, view, None, commands);
        }
        // Beside Restart where there is room.
        timeline::cut_again(ui, view, commands);
        if commands.len() > before {
            ui.close();
        }
    });
}

fn find(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    if view.frame.hides(FramePart::Find) {
        return;
    }
    let command = Command::Shell(ShellCommand::ShowSearch(true));
    let keys = shortcuts::hint(ui.ctx(), view.place, &command);
    let help = tr!("Find a setting, scenario, screen, command or word{keys}", keys = keys);
    if ui.add(Button::new(tr("Find")).min_size(touch::least(ui))).on_hover_text(help).clicked() {
        commands.push(command);
    }
}

fn help(ui: &mut Ui, commands: &mut Vec<Command>) {
    let response = ui
        .add(Button::new("?").min_size(touch::least(ui)))
        .on_hover_text(tr("What this is; keys and gestures (?)"));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr("Keys and gestures")));
    if response.clicked() {
        commands.push(Command::Shell(ShellCommand::ShowShortcuts(true)));
    }
}

/// The languages by their own names; `true` where one was chosen.
pub fn languages(ui: &mut Ui, commands: &mut Vec<Command>) -> bool {
    let mut chosen = false;
    for language in Language::ALL.iter().copied() {
        if touch::choice(ui, language == language::chosen(), language.label()).clicked() {
            commands.push(Command::Shell(ShellCommand::Speak(language)));
            chosen = true;
        }
    }
    chosen
}

fn language_menu(ui: &mut Ui, commands: &mut Vec<Command>) {
    if languages(ui, commands) {
        ui.close();
    }
}

/// Opens the list of languages; it shows the one that is chosen, as everybody can read it.
fn language_button(ui: &mut Ui, commands: &mut Vec<Command>) {
    let code = language::chosen().id().to_uppercase();
    let button = ui.add(Button::new(code).min_size(touch::least(ui)));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr("Language")));
    let button = button.on_hover_text("English · Slovenščina · Deutsch");
    egui::Popup::menu(&button).show(|ui| language_menu(ui, commands));
}

fn theme_button(ui: &mut Ui, commands: &mut Vec<Command>) {
    let (sign, name, help, next) = if ui.visuals().dark_mode {
        let help = tr("Light colours; right-click: as the system has it");
        (Icon::Light, tr("Light"), help, ThemePreference::Light)
    } else {
        let help = tr("Dark colours; right-click: as the system has it");
        (Icon::Dark, tr("Dark"), help, ThemePreference::Dark)
    };
    let response = icon::button(ui, sign, name, help, true);
    if response.clicked() {
        commands.push(Command::Shell(ShellCommand::Theme(next)));
    } else if response.secondary_clicked() {
        commands.push(Command::Shell(ShellCommand::Theme(ThemePreference::System)));
    }
}

fn file_buttons(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    // In reading order; a layout from the right turns it round.
    let mut buttons = [
        (
            text!("Open"),
            text!("Open a scenario file; one can also be dropped here"),
            FileCommand::Open,
        ),
        (text!("Save"), text!("Save the scenario with its edits"), FileCommand::Save),
        (text!("Save CSV"), text!("Export all signals of the run as CSV"), FileCommand::ExportCsv),
        (
            text!("Link"),
            text!(
                "Copy a link that holds scenario and edits, and show it with its QR code, the command line that repeats the run, and the digest"
            ),
            FileCommand::CopyLink,
        ),
    ];
    if ui.layout().prefer_right_to_left() {
        buttons.reverse();
    }
    for (name, help, command) in buttons {
        let command = Command::File(command);
        let help = format!("{}{}", tr(help), shortcuts::hint(ui.ctx(), view.place, &command));
        if ui.button(tr(name)).on_hover_text(help).clicked() {
            commands.push(command);
        }
    }
}

fn undo_buttons(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let session = view.session;
    let mut buttons = [
        (
            Icon::Undo,
            text!("Undo"),
            text!("Take the last change back"),
            SessionCommand::Undo,
            session.can_undo(),
        ),
        (Icon::Redo, text!("Redo"), text!("Do it again"), SessionCommand::Redo, session.can_redo()),
    ];
    if ui.layout().prefer_right_to_left() {
        buttons.reverse();
    }
    for (sign, name, help, command, enabled) in buttons {
        let command = Command::Session(command);
        let help = format!("{}{}", tr(help), shortcuts::hint(ui.ctx(), view.place, &command));
        if icon::button(ui, sign, tr(name), &help, enabled).clicked() {
            commands.push(command);
        }
    }
}

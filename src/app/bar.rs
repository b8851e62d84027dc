//! The strip at the head of the window: screens, files, undo and redo, light or dark, messages, and what is
//! worked at.

use egui::{Button, RichText, Role, ThemePreference, Ui, WidgetInfo};

use super::command::{Command, FileCommand, SessionCommand, ShellCommand};
use super::jobs;
use super::messages;
use super::panels::View;
use super::shortcuts;
use super::theme::Palette;
use super::widgets::icon::{self, Icon};
use super::widgets::touch;

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
    let palette = Palette::at(ui);
    ui.horizontal(|ui| {
        if !view.narrow {
            ui.label(RichText::new("SteadyCut").heading().strong().color(palette.accent));
            ui.add_space(8.0);
        }
        let id = egui::Id::unique("room of the commands");
        let room = ui.data(|data| data.get_temp::<f32>(id)).unwrap_or_default();
        let spacing = ui.spacing().clone();
        if view.narrow {
            ui.spacing_mut().item_spacing.x = 3.0;
            ui.spacing_mut().button_padding.x = 5.0;
        }
        if tabs_width(ui, tabs) + room <= ui.available_width() {
            for tab in tabs {
                let text = RichText::new(tab.title).strong();
                if ui.selectable_label(tab.id == shown, text).clicked() {
                    commands.push(Command::Shell(ShellCommand::ShowScreen(tab.id)));
                }
            }
        } else {
            *ui.spacing_mut() = spacing;
            choice(ui, view, tabs, shown, commands);
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            if view.narrow {
                menu(ui, view, commands);
            } else {
                help(ui, commands);
                theme_button(ui, commands);
                find(ui, view, commands);
                ui.separator();
                file_buttons(ui, view, commands);
                ui.separator();
                undo_buttons(ui, view, commands);
            }
            // At the end of the row, where nothing moves when they come.
            messages::button(ui, view.session.notices());
            jobs::show(ui, view.jobs);
            let taken = ui.min_rect().width() + GAP;
            if taken != room {
                // The tabs beside them are laid out again.
                ui.data_mut(|data| data.insert_temp(id, taken));
                ui.ctx().request_repaint();
            }
        });
    });
}

/// Room between the tabs and the other commands, points.
const GAP: f32 = 12.0;

/// The width of all tabs beside each other.
fn tabs_width(ui: &Ui, tabs: &[Tab]) -> f32 {
    let font = egui::TextStyle::Button.resolve(ui.style());
    let spacing = ui.spacing();
    let around = 2.0 * spacing.button_padding.x + spacing.item_spacing.x;
    let wide = |title: &str| {
        let text = title.to_owned();
        ui.painter().layout_no_wrap(text, font.clone(), egui::Color32::PLACEHOLDER).size().x
    };
    tabs.iter().map(|tab| wide(tab.title) + around).sum()
}

/// The screens as a list to choose from, where tabs have no room.
fn choice(ui: &mut Ui, view: &View<'_>, tabs: &[Tab], shown: &str, commands: &mut Vec<Command>) {
    let title = tabs.iter().find(|tab| tab.id == shown).map_or("", |tab| tab.title);
    let list = egui::ComboBox::from_id_salt("screen")
        .selected_text(RichText::new(title).strong())
        // All of them at once.
        .height(f32::INFINITY);
    let list = list.show_ui(ui, |ui| {
        for tab in tabs {
            if ui.selectable_label(tab.id == shown, tab.title).clicked() {
                commands.push(Command::Shell(ShellCommand::ShowScreen(tab.id)));
            }
        }
    });
    let response = list.response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, "Screen"));
    let keys = (0..2).filter_map(|order| shortcuts::screen_key(order, view.place));
    let keys: Vec<String> = keys.map(|keys| ui.ctx().format_shortcut(&keys)).collect();
    response.on_hover_text(format!("Screens ({}, …)", keys.join(", ")));
}

fn menu(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let response = icon::button(ui, Icon::Menu, "Menu", "Files, undo, colours, keys, search", true);
    egui::Popup::menu(&response).show(|ui| {
        ui.horizontal(|ui| {
            undo_buttons(ui, view, commands);
            theme_button(ui, commands);
            help(ui, commands);
            find(ui, view, commands);
        });
        ui.separator();
        file_buttons(ui, view, commands);
    });
}

fn find(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let command = Command::Shell(ShellCommand::ShowSearch(true));
    let keys = shortcuts::hint(ui.ctx(), view.place, &command);
    let help = format!("Find a setting, scenario, screen, command or word{keys}");
    if ui.add(Button::new("Find").min_size(touch::least(ui))).on_hover_text(help).clicked() {
        commands.push(command);
    }
}

fn help(ui: &mut Ui, commands: &mut Vec<Command>) {
    let response =
        ui.add(Button::new("?").min_size(touch::least(ui))).on_hover_text("Keys and gestures (?)");
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "Keys and gestures"));
    if response.clicked() {
        commands.push(Command::Shell(ShellCommand::ShowShortcuts(true)));
    }
}

fn theme_button(ui: &mut Ui, commands: &mut Vec<Command>) {
    let (sign, name, next) = if ui.visuals().dark_mode {
        (Icon::Light, "Light", ThemePreference::Light)
    } else {
        (Icon::Dark, "Dark", ThemePreference::Dark)
    };
    let help = format!("{name} colours; right-click: as the system has it");
    let response = icon::button(ui, sign, name, &help, true);
    if response.clicked() {
        commands.push(Command::Shell(ShellCommand::Theme(next)));
    } else if response.secondary_clicked() {
        commands.push(Command::Shell(ShellCommand::Theme(ThemePreference::System)));
    }
}

fn file_buttons(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    // In reading order; a layout from the right turns it round.
    let mut buttons = [
        ("Open", "Open a scenario file; one can also be dropped here", FileCommand::Open),
        ("Save", "Save the scenario with its edits", FileCommand::Save),
        ("CSV", "Export all signals of the run as CSV", FileCommand::ExportCsv),
        (
            "Link",
            "Copy a link that holds scenario and edits; its message tells the command line that repeats the run, and the digest",
            FileCommand::CopyLink,
        ),
    ];
    if ui.layout().prefer_right_to_left() {
        buttons.reverse();
    }
    for (name, help, command) in buttons {
        let command = Command::File(command);
        let help = help.to_owned() + &shortcuts::hint(ui.ctx(), view.place, &command);
        if ui.button(name).on_hover_text(help).clicked() {
            commands.push(command);
        }
    }
}

fn undo_buttons(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let session = view.session;
    let mut buttons = [
        (Icon::Undo, "Undo", "Take the last change back", SessionCommand::Undo, session.can_undo()),
        (Icon::Redo, "Redo", "Do it again", SessionCommand::Redo, session.can_redo()),
    ];
    if ui.layout().prefer_right_to_left() {
        buttons.reverse();
    }
    for (sign, name, help, command, enabled) in buttons {
        let command = Command::Session(command);
        let help = help.to_owned() + &shortcuts::hint(ui.ctx(), view.place, &command);
        if icon::button(ui, sign, name, &help, enabled).clicked() {
            commands.push(command);
        }
    }
}

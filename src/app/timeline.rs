//! The strip at the foot of the window: the playhead over the whole run, and what moves it.

use egui::{Align, ComboBox, Label, Layout, RichText, Role, Slider, TextWrapMode, Ui, WidgetInfo};

use super::command::{Command, PlaybackCommand};
use super::format;
use super::panels::View;
use super::playback::Speed;
use super::shortcuts::hint;
use super::theme::Palette;
use super::widgets::focus;
use super::widgets::icon::{self, Icon};
use super::widgets::standing::Standing;
use crate::run::one_run::End;

/// The whole strip.
pub fn show(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    if view.narrow {
        ui.spacing_mut().item_spacing.x = 5.0;
        // Beside the bar: below it the buttons need the width.
        ui.horizontal(|ui| {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                time(ui, view);
                scrub(ui, view, commands);
            });
        });
    } else {
        scrub(ui, view, commands);
    }
    ui.horizontal_wrapped(|ui| {
        let playback = view.session.playback();
        if icon::button(ui, Icon::Restart, "Restart", "Again from the start", true).clicked() {
            commands.push(Command::Playback(PlaybackCommand::Restart));
        }
        let (sign, name) =
            if playback.playing { (Icon::Pause, "Pause") } else { (Icon::Play, "Play") };
        if icon::button(ui, sign, name, &format!("{name} (Space)"), true).clicked() {
            commands.push(Command::Playback(PlaybackCommand::TogglePlay));
        }
        let step = Command::Playback(PlaybackCommand::Step(1));
        let help = format!("One control sample on{}", hint(ui.ctx(), view.place, &step));
        if icon::button(ui, Icon::Step, "Step", &help, true).clicked() {
            commands.push(step);
        }
        if icon::button(ui, Icon::End, "End", "To the end of the cut (End)", true).clicked() {
            commands.push(Command::Playback(PlaybackCommand::SeekToEnd));
        }
        if !view.narrow {
            time(ui, view);
        }
        speed(ui, view, commands);
        let mut follow = playback.follow;
        let help = "Plots show the last seconds before the playhead; otherwise the whole run.";
        if ui.checkbox(&mut follow, "Follow").on_hover_text(help).changed() {
            commands.push(Command::Playback(PlaybackCommand::Follow(follow)));
        }
        state(ui, view, commands);
    });
}

/// The time at the playhead and the length of the cut.
fn time(ui: &mut Ui, view: &View<'_>) {
    let at_s = view.session.playback().playhead_s;
    let text = RichText::new(format::time_of(at_s, view.session.length_s())).monospace();
    let text = if view.narrow { text.small() } else { text };
    ui.add(Label::new(text).selectable(false));
}

fn speed(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let now = view.session.playback().speed;
    let short = |speed: Speed| match speed {
        Speed::Max => "max".to_owned(),
        times => times.label(),
    };
    let response = ComboBox::from_id_salt("speed")
        .width(50.0)
        .selected_text(short(now))
        .show_ui(ui, |ui| {
            for speed in Speed::ALL {
                if ui.selectable_label(speed == now, speed.label()).clicked() {
                    commands.push(Command::Playback(PlaybackCommand::Speed(speed)));
                }
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, "Speed"));
    response.on_hover_text("Speed of the playhead");
}

/// What there is to say: that it is still computing, that the cut is over and why.
fn state(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let progress = view.session.progress();
    if let Some(end) = view.session.finished() {
        let swung = view.session.story().has_swung();
        let standing = match end {
            End::PathDone if swung => Standing::Watch,
            End::PathDone => Standing::Good,
            End::TimeLimit => Standing::Watch,
            End::Overload(_) | End::Crash(_) | End::Fault(_) | End::Refused(_) => Standing::Bad,
        };
        // Whole, on the next line where this one has no room for it.
        let how = if swung { ", not steady" } else { "" };
        let text = RichText::new(format!("{end}{how}")).strong();
        standing.line(ui, text, TextWrapMode::Extend);
        if ui.button("Restart the cut").on_hover_text("Space does the same").clicked() {
            commands.push(Command::Playback(PlaybackCommand::Restart));
        }
    } else if progress < 1.0 {
        ui.label(
            RichText::new(format!("computing, {:.0} %", 100.0 * progress)).color(palette.weak),
        );
    }
}

/// The bar of the whole run with the playhead as its handle, and a mark at every edit.
fn scrub(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let length_s = view.session.length_s();
    let now = view.session.playback().playhead_s.min(length_s);
    let mut playhead_s = now;
    ui.spacing_mut().slider_width = ui.available_width();
    let slider = Slider::new(&mut playhead_s, 0.0..=length_s).show_value(false).smart_aim(false);
    let response = ui.add(slider);
    response.widget_info(|| WidgetInfo::slider(true, playhead_s, "Playhead"));
    if response.drag_stopped() {
        focus::leave(&response);
    }
    if playhead_s != now {
        commands.push(Command::Playback(PlaybackCommand::SeekTo(playhead_s)));
    }
    let rail = response.rect.x_range().shrink(0.4 * response.rect.height());
    for edit in view.session.edits().list() {
        let x = egui::lerp(rail.min..=rail.max, (edit.at_s / length_s) as f32);
        let y = egui::Rangef::new(response.rect.top(), response.rect.top() + 6.0);
        ui.painter().vline(x, y, egui::Stroke::new(2.0, palette.ghost));
    }
    let edits = view.session.edits().list().len();
    let help = match edits {
        0 => "The whole run: drag to look back".to_owned(),
        1 => "The whole run: drag to look back. The mark is a change during the cut".to_owned(),
        _ => format!("The whole run: drag to look back. The marks are {edits} changes"),
    };
    response.on_hover_text(help);
}

//! The strip at the foot of the window: the playhead over the whole run, and what moves it.

use egui::{
    Align, Button, ComboBox, Label, Layout, Rect, RichText, Role, Sense, Shape, Slider, TextStyle,
    TextWrapMode, Ui, WidgetInfo, WidgetText,
};

use super::command::{Command, PlaybackCommand, SessionCommand};
use super::format;
use super::panels::View;
use super::playback::Speed;
use super::session::mishap::NO_MISHAP;
use super::shortcuts::{CUT_AGAIN, TRY_AGAIN, hint};
use super::theme::Palette;
use super::widgets::focus;
use super::widgets::icon::{self, Icon};
use super::widgets::standing::Standing;
use super::widgets::touch;
use crate::base::language::tr;
use crate::blocks::reference::Reference;
use crate::run::one_run::End;
use crate::run::story::{CutVerdict, EventKind};

/// Most that is told of runs that are still being computed, percent.
const MOST_PERCENT: f64 = 99.0;
/// Height of the line below the rail that shows how much is computed, and how far it is from the rail, points.
const COMPUTED: [f32; 2] = [2.0, 1.0];

/// The whole strip. What a cut comes to has room of its own in it, used or not, so that nothing moves at its end.
pub fn show(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let id = egui::Id::unique(CONTROLS_END);
    let ends = ui.data(|data| data.get_temp::<f32>(id));
    let wanted = state_width(ui);
    let beside = !view.narrow && ends.is_none_or(|x| x + wanted <= ui.max_rect().right());
    if beside {
        scrub(ui, view, commands);
    } else {
        if view.narrow {
            ui.spacing_mut().item_spacing.x = 5.0;
        }
        // At the right of the bar: below it the buttons need the width.
        ui.horizontal(|ui| {
            let height = ui.spacing().interact_size.y;
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let width = if view.narrow { NARROW_STATE } else { wanted };
                ui.allocate_ui_with_layout(
                    egui::vec2(width, height),
                    Layout::left_to_right(Align::Center),
                    |ui| {
                        ui.set_width(width);
                        match (view.narrow, view.session.finished()) {
                            (true, None) => time(ui, view),
                            (true, Some(_)) | (false, _) => state(ui, view, commands),
                        }
                    },
                );
                scrub(ui, view, commands);
            });
        });
    }
    ui.horizontal_wrapped(|ui| {
        let top = ui.cursor().top();
        let playback = view.session.playback();
        let edits = view.session.edits().list().len();
        let help = match edits {
            0 => tr("Again from the start").to_owned(),
            1 => tr("Again from the start, with the change at its time").to_owned(),
            n => tr!("Again from the start, with {n} changes at their times", n = n),
        };
        if icon::button(ui, Icon::Restart, tr("Restart"), &help, true).clicked() {
            commands.push(Command::Playback(PlaybackCommand::Restart));
        }
        let (sign, name, help) = match playback.playing {
            true => (Icon::Pause, tr("Pause"), tr("Pause (Space)")),
            false => (Icon::Play, tr("Play"), tr("Play (Space)")),
        };
        if icon::button(ui, sign, name, help, true).clicked() {
            commands.push(Command::Playback(PlaybackCommand::TogglePlay));
        }
        let step = Command::Playback(PlaybackCommand::Step(1));
        let help = tr!("One control sample on{keys}", keys = hint(ui.ctx(), view.place, &step));
        if icon::button(ui, Icon::Step, tr("Step"), &help, true).clicked() {
            commands.push(step);
        }
        let help = tr("To the end of the cut (End)");
        if icon::button(ui, Icon::End, tr("End"), help, true).clicked() {
            commands.push(Command::Playback(PlaybackCommand::SeekToEnd));
        }
        if !view.narrow {
            time(ui, view);
        }
        speed(ui, view, commands);
        let mut follow = playback.follow;
        let help = tr("Plots show the last seconds before the playhead, and the whole run at its end; otherwise always the whole run.");
        if ui.checkbox(&mut follow, tr("Follow")).on_hover_text(help).changed() {
            commands.push(Command::Playback(PlaybackCommand::Follow(follow)));
        }
        if !view.narrow {
            // A mission has its own beside its task.
            if view.session.mission().is_none() {
                cut_again(ui, view, commands);
            }
            try_again(ui, view, commands);
            // In a second line there is no room: it begins with what had none in the first one.
            let wraps = ui.cursor().top() > top + 1.0;
            let ends = if wraps { f32::INFINITY } else { ui.cursor().left() };
            // What a cut comes to is not lain upon.
            let free = if view.session.finished().is_some() { f32::INFINITY } else { ends };
            ui.data_mut(|data| {
                data.insert_temp(id, ends);
                data.insert_temp(egui::Id::unique(FREE_FROM), free);
            });
            if beside {
                state(ui, view, commands);
            }
        }
    });
}

/// From where on the strip is free at the right, points from the left, as of a frame before.
pub const FREE_FROM: &str = "free right of the transport";
/// Where the controls of the wide strip end, points from the left: what is known of a frame before.
const CONTROLS_END: &str = "controls of the transport end";
/// Width that a phone has for the time, and for what the cut comes to, points.
const NARROW_STATE: f32 = 132.0;

/// Room that what a cut mostly comes to takes, with its sign and the button behind it, points.
fn state_width(ui: &Ui) -> f32 {
    let share = tr!(", target not held: {share} in tolerance", share = "88.8 %");
    let width = |text: String| {
        let text = WidgetText::from(RichText::new(text).strong());
        let extend = Some(TextWrapMode::Extend);
        text.into_galley(ui, extend, f32::INFINITY, TextStyle::Body).size().x
    };
    let button = width(tr("Play again").to_owned()) + 2.0 * ui.spacing().button_padding.x;
    let sign = Standing::Good.room(TextStyle::Body.resolve(ui.style()).size);
    width(format!("{}{share}", End::PathDone)) + button + sign + 4.0 * ui.spacing().item_spacing.x
}

/// The button that cuts from the start with the settings at the playhead; there is no other cut where nothing was
/// changed in the running one.
pub fn cut_again(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let command = Command::Session(SessionCommand::CutAgain);
    let keys = hint(ui.ctx(), view.place, &command);
    let help = tr!(
        "From the start, with the settings at the playhead as the scenario's own{keys}. Restart repeats the \
         changes made during the cut at their times; this does not.",
        keys = keys
    );
    let changed = !view.session.edits().list().is_empty();
    let button = ui.add_enabled(changed, Button::new(tr(CUT_AGAIN)).min_size(touch::least(ui)));
    let none = tr("Nothing was changed during the cut: Restart does the same");
    if button.on_hover_text(help).on_disabled_hover_text(none).clicked() {
        commands.push(command);
    }
}

/// The button that goes back to before what went wrong last: there at all times, so that nothing moves.
pub fn try_again(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let command = Command::Playback(PlaybackCommand::TryAgain);
    let keys = hint(ui.ctx(), view.place, &command);
    let help = tr!(
        "Back to 2 s before the last broken tooth, stop or scrap{keys}; the next change branches there",
        keys = keys
    );
    let button = Button::new(tr(TRY_AGAIN)).min_size(touch::least(ui));
    // At the start there is nothing to go back to.
    let begun = view.session.playback().playhead_s > 0.0;
    let button = ui.add_enabled(begun && view.session.has_mishap(), button);
    if button.on_hover_text(help).on_disabled_hover_text(tr(NO_MISHAP)).clicked() {
        commands.push(command);
    }
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
        Speed::Max => tr("max").to_owned(),
        times => times.label(),
    };
    // Where there is room it says what it is.
    let named = if view.narrow { short(now) } else { tr!("Speed {speed}", speed = short(now)) };
    let response = ComboBox::from_id_salt("speed")
        .width(50.0)
        .selected_text(named)
        .show_ui(ui, |ui| {
            for speed in Speed::ALL {
                if ui.selectable_label(speed == now, speed.label()).clicked() {
                    commands.push(Command::Playback(PlaybackCommand::Speed(speed)));
                    ui.close();
                }
            }
        })
        .response;
    response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, tr("Speed")));
    response.on_hover_text(tr("Speed of the playhead"));
}

/// What there is to say in what is left of the line: that it is still computing, that the cut is over and why. It is
/// cut off rather than parted: another line would move the buttons as it comes and goes.
fn state(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    if let Some(end) = view.session.finished() {
        let (standing, text, short) = verdict(view, end);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            // On a phone the buttons below begin with one that does the same.
            if !view.narrow {
                let again = ui.button(tr("Play again"));
                if again.on_hover_text(tr("Space does the same")).clicked() {
                    commands.push(Command::Playback(PlaybackCommand::Restart));
                }
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let styled = |text: &str| {
                    let text = RichText::new(format::typeset(text)).strong();
                    if view.narrow { text.small() } else { text }
                };
                let mut text = styled(&text);
                if view.narrow && !short.is_empty() {
                    let size = TextStyle::Small.resolve(ui.style()).size;
                    let extend = Some(TextWrapMode::Extend);
                    let whole = WidgetText::from(text.clone());
                    let whole = whole.into_galley(ui, extend, f32::INFINITY, TextStyle::Small);
                    if whole.size().x + standing.room(size) > ui.available_width() {
                        text = styled(&short);
                    }
                }
                let told = standing.line(ui, text, TextWrapMode::Truncate);
                if let Some(last) = view.session.story().events.last() {
                    told.on_hover_text(format::typeset(&last.sentence));
                }
            });
        });
    } else if let Some(percent) = computed_percent(view) {
        // A phone has the line below the rail alone.
        ui.add(Label::new(RichText::new(computing(percent)).color(palette.weak)).truncate());
    }
}

/// How much of both runs is computed, in whole percent, while that is not all.
fn computed_percent(view: &View<'_>) -> Option<f64> {
    let share = view.session.simulated();
    (share < 1.0).then(|| (100.0 * share).floor().min(MOST_PERCENT))
}

fn computing(percent: f64) -> String {
    format::typeset(&tr!("computing, {percent:.0} %", percent = percent))
}

/// What the whole cut comes to: a tick only where it is done, steady, and its target was held. And what is told of it
/// where that has no room; empty where there is nothing shorter.
fn verdict(view: &View<'_>, end: &End) -> (Standing, String, String) {
    let story = view.session.story();
    let judged = match end {
        End::PathDone | End::TimeLimit => story.verdict(),
        End::Overload(_)
        | End::Crash(_)
        | End::Breakage(_)
        | End::Fault(_)
        | End::Refused(_)
        | End::Script(_) => {
            return (Standing::Bad, end.to_string(), String::new());
        }
    };
    let reference = view.session.current().target.reference;
    // On a phone the share stands in its card, and this in one line with the button.
    let words = |judged: &CutVerdict, held: bool| {
        let Some(inside) = judged.in_tolerance_percent.filter(|_| !view.narrow) else {
            return match (view.session.mission().is_some(), held) {
                (true, _) => String::new(),
                (false, true) => tr("held").to_owned(),
                (false, false) => tr("not held").to_owned(),
            };
        };
        let share = judged.share_text(inside);
        if view.session.mission().is_some() {
            return tr!(", {share} in tolerance", share = share);
        }
        match (reference, held, judged.without_dynamics_percent.is_some()) {
            (Reference::Ra, true, false) => {
                tr!(", target held: {share} in tolerance", share = share)
            }
            (Reference::Ra, false, false) => {
                tr!(", target not held: {share} in tolerance", share = share)
            }
            (Reference::Force, true, false) => {
                tr!(", reference held: {share} in tolerance", share = share)
            }
            (Reference::Force, false, false) => {
                tr!(", reference not held: {share} in tolerance", share = share)
            }
            (Reference::Ra, true, true) => {
                tr!(", target held: {share} in tolerance with dynamics", share = share)
            }
            (Reference::Ra, false, true) => {
                tr!(", target not held: {share} in tolerance with dynamics", share = share)
            }
            (Reference::Force, true, true) => {
                tr!(", reference held: {share} in tolerance with dynamics", share = share)
            }
            (Reference::Force, false, true) => {
                tr!(", reference not held: {share} in tolerance with dynamics", share = share)
            }
        }
    };
    let (standing, held) = match judged.map(|judged| (judged.held, judged)) {
        Some((Some(true), judged)) => (Standing::Good, words(judged, true)),
        Some((Some(false), judged)) => (Standing::Bad, words(judged, false)),
        Some((None, judged)) => match judged.not_judged_percent {
            Some(share) => {
                let share = judged.share_text(share);
                (Standing::Watch, tr!(", {share} not judged", share = share))
            }
            None => (Standing::Plain, String::new()),
        },
        None => (Standing::Plain, String::new()),
    };
    let swung = story.has_swung();
    let how = match (story.has(EventKind::LimitCycle), story.has(EventKind::Chatter)) {
        (true, false) => tr(", unstable"),
        (false, true) => tr(", chattered"),
        (true, true) => tr(", unstable, chattered"),
        (false, false) => "",
    };
    let standing = match (standing, end) {
        (Standing::Good, End::PathDone) if !swung => Standing::Good,
        (Standing::Good | Standing::Plain, _) if swung => Standing::Watch,
        (Standing::Good, _) => Standing::Watch,
        (other, _) => other,
    };
    // A mission has a goal of its own, and says whether that is met.
    let standing = if view.session.mission().is_some() { Standing::Plain } else { standing };
    // A phone has room for the one word that matters; the sentence above says the rest.
    let alone = view.narrow && matches!(judged, Some(judged) if judged.held.is_some());
    let text = match alone && !held.is_empty() {
        // What went wrong comes before the share, which stands in its card as well.
        true => format!("{held}{how}"),
        false => format!("{end}{how}{held}"),
    };
    // That it swung says more than the rest, which the sign says as well.
    let short = how.trim_start_matches([',', ' ']).to_owned();
    (standing, text, short)
}

/// The bar of the whole run with the playhead as its handle, and a mark at every edit.
fn scrub(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let palette = Palette::at(ui);
    let length_s = view.session.length_s();
    let now = view.session.playback().playhead_s.min(length_s);
    let mut playhead_s = now;
    ui.spacing_mut().slider_width = ui.available_width();
    // Below the handle; it is known only with the slider's place.
    let line = ui.painter().add(Shape::Noop);
    let slider = Slider::new(&mut playhead_s, 0.0..=length_s).show_value(false).smart_aim(false);
    let response = ui.add(slider);
    response.widget_info(|| WidgetInfo::slider(true, playhead_s, tr("Playhead")));
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
    let percent = computed_percent(view);
    if let Some(percent) = percent {
        let [height, gap] = COMPUTED;
        let top = response.rect.center().y + 0.5 * ui.spacing().slider_rail_height + gap;
        let right = egui::lerp(rail.min..=rail.max, 0.01 * percent as f32);
        let whole = Rect::from_x_y_ranges(rail, top..=top + height);
        let filled = Rect::from_x_y_ranges(rail.min..=right, top..=top + height);
        ui.painter().set(line, Shape::rect_filled(filled, 1.0, palette.accent));
        // Read aloud where the words have no room.
        let told = ui.interact(whole, response.id.with("computed"), Sense::hover());
        let words = computing(percent);
        told.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, &words));
    }
    let edits = view.session.edits().list().len();
    let help = match edits {
        0 => tr("The whole run: drag to look back").to_owned(),
        1 => tr("The whole run: drag to look back. The mark is a change during the cut").to_owned(),
        n => tr!("The whole run: drag to look back. The marks are {n} changes", n = n),
    };
    let help = match percent {
        Some(percent) => {
            tr!(
                "{help}. {percent:.0} % is computed: the line below",
                help = help,
                percent = percent
            )
        }
        None => help,
    };
    response.on_hover_text(help);
}

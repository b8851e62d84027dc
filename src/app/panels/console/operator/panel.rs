//! The panel with the knob: who has the feed, the knob, its buttons, and how far it goes.

use egui::{Align, Button, Label, Layout, RichText, Role, Ui, Vec2, WidgetInfo, vec2};

use super::super::super::View;
use crate::app::command::{Command, HandCommand};
use crate::app::format;
use crate::app::session::hand::{CLICK_PERCENT, KnobScale, PANEL_PERCENT};
use crate::app::theme::{self, Palette};
use crate::app::widgets::knob::Knob;
use crate::app::widgets::spoken::read_aloud;
use crate::app::widgets::standing::Standing;
use crate::app::widgets::touch;
use crate::base::equation::number;
use crate::base::language::{decimal, tr};

/// Least height of a line that comes and goes, points: nothing below it moves.
const LINE: f32 = 20.0;
/// Size of a button that turns the knob, points.
const STEP: Vec2 = vec2(44.0, 32.0);

/// Shows the panel, the knob in this size.
pub fn panel(ui: &mut Ui, view: &View<'_>, diameter: f32, commands: &mut Vec<Command>) {
    let refused = view.session.hand().refused().is_some();
    if view.narrow && !refused {
        // In one line: from the right the choices and the button, and the name in what they leave.
        let line = vec2(ui.available_width(), touch::least(ui).y.max(LINE));
        ui.allocate_ui_with_layout(line, Layout::right_to_left(Align::Center), |ui| {
            scale(ui, view, commands);
            owner(ui, view, commands);
        });
    } else {
        ui.horizontal_wrapped(|ui| {
            ui.set_min_height(touch::least(ui).y.max(LINE));
            owner(ui, view, commands);
        });
    }
    let session = view.session;
    let stand = session.knob();
    let knob = Knob {
        percent: stand.percent,
        scale_percent: scale_percent(view),
        range: session.knob_range(),
        by_hand: stand.by_hand,
        diameter,
    };
    let [step, gap] = [STEP.max(touch::least(ui)), ui.spacing().item_spacing];
    // At its sides where there is room; else below it.
    let beside = ui.available_width() >= diameter + 2.0 * (step.x + gap.x);
    let width = if beside { diameter + 2.0 * (step.x + gap.x) } else { diameter };
    let row = vec2(ui.available_width(), diameter);
    ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
        ui.add_space((0.5 * (ui.available_width() - width)).max(0.0));
        if beside {
            turn(ui, -1, commands);
        }
        knob.show(ui, commands);
        if beside {
            turn(ui, 1, commands);
        }
    });
    if !beside {
        ui.horizontal(|ui| {
            let width = 2.0 * step.x + gap.x;
            ui.add_space((0.5 * (ui.available_width() - width)).max(0.0));
            turn(ui, -1, commands);
            turn(ui, 1, commands);
        });
    }
    if !theme::fingers(ui.ctx()) {
        let text = tr("Drag around it, wheel, + and -, Page Up and Down");
        ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
    }
    if !view.narrow {
        ui.horizontal_wrapped(|ui| scale(ui, view, commands));
    }
}

/// Where the scale of the knob ends, percent.
fn scale_percent(view: &View<'_>) -> f64 {
    match view.session.hand().scale() {
        KnobScale::Panel => PANEL_PERCENT,
        KnobScale::Whole => view.session.current().cnc.override_max_percent,
    }
}

/// A button that turns the knob by a click.
fn turn(ui: &mut Ui, clicks: i32, commands: &mut Vec<Command>) {
    let percent = decimal(number(CLICK_PERCENT));
    let (text, name) = match clicks > 0 {
        true => (format!("+{percent}"), tr!("Override {percent} % up", percent = percent)),
        false => (format!("-{percent}"), tr!("Override {percent} % down", percent = percent)),
    };
    let size = STEP.max(touch::least(ui));
    let button = ui.add_sized(size, Button::new(RichText::new(text).strong()));
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
    if button.on_hover_text(name.clone()).clicked() {
        commands.push(Command::hand(HandCommand::Turn(clicks)));
    }
}

/// Who has the feed, and how it changes hands; or why the last turn was refused.
fn owner(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let session = view.session;
    let over = session.finished().is_some();
    if let Some(refused) = session.hand().refused() {
        read_aloud(&Standing::Watch.label(ui, refused, |text| text));
        return;
    }
    let (who, give_back) = if session.knob().by_hand {
        let who = if over { tr("The cut is over") } else { tr("You have the feed") };
        let before = session.had_the_feed().filter(|_| !over && session.mission().is_none());
        (who.to_owned(), before)
    } else {
        let controller = tr(session.current().controller.kind.label());
        (tr!("{controller} has the feed", controller = controller), None)
    };
    let mut change = |ui: &mut Ui| match give_back {
        Some(kind) => {
            let text = tr!("Give it back to {controller}", controller = tr(kind.label()));
            let shown = if view.narrow { tr("Give it back") } else { text.as_str() };
            let button = ui.add(Button::new(shown).min_size(touch::least(ui)));
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, &text));
            if button.clicked() {
                commands.push(Command::hand(HandCommand::GiveBack));
            }
        }
        None if session.knob().by_hand => {}
        None => {
            let button = Button::new(tr("Take it")).min_size(touch::least(ui));
            let help = tr("At the override that is sent now; a turn of the knob takes it as well");
            let button = ui.add_enabled(!over, button);
            let ended = tr("The cut is over: Cut by hand begins it again");
            if button.on_hover_text(help).on_disabled_hover_text(ended).clicked() {
                commands.push(Command::hand(HandCommand::Take));
            }
        }
    };
    let who = Label::new(RichText::new(who).strong());
    if ui.layout().prefer_right_to_left() {
        change(ui);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| ui.add(who.wrap()));
    } else {
        ui.add(who);
        change(ui);
    }
}

/// How far the knob goes, where controllers may go further than a panel does.
fn scale(ui: &mut Ui, view: &View<'_>, commands: &mut Vec<Command>) {
    let largest = view.session.current().cnc.override_max_percent;
    if largest <= PANEL_PERCENT {
        return;
    }
    // Where it is narrow the choices must stand in one line with who has the feed.
    if !view.narrow {
        ui.label(RichText::new(tr("Scale to")).color(Palette::at(ui).weak));
    }
    let now = view.session.hand().scale();
    let mut scales = KnobScale::ALL.to_vec();
    if ui.layout().prefer_right_to_left() {
        scales.reverse();
    }
    for scale in scales {
        let (percent, help) = match scale {
            KnobScale::Panel => (PANEL_PERCENT, tr("As on a machine's panel")),
            KnobScale::Whole => (largest, tr("As far as the CNC lets a controller go")),
        };
        let text = format::beside(decimal(number(percent)), "%");
        let choice = touch::choice(ui, scale == now, &text);
        let (is, name) = (scale == now, tr!("Scale to {percent}", percent = text));
        choice.widget_info(|| WidgetInfo::selected(Role::Button, true, is, &name));
        if choice.on_hover_text(help).clicked() {
            commands.push(Command::hand(HandCommand::Scale(scale)));
        }
    }
}

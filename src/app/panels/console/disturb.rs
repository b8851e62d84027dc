//! Disturbances for the running cut: a button each, and a window with their lengths and sizes.

use egui::{Button, Color32, Label, Rect, RichText, Role, TextStyle, Ui, WidgetInfo, vec2};

use super::super::View;
use crate::app::command::{Command, DisturbCommand, SessionCommand};
use crate::app::format;
use crate::app::shortcuts;
use crate::app::theme;
use crate::app::widgets::drop;
use crate::app::widgets::number::NumberField;
use crate::app::widgets::touch;
use crate::app::widgets::window::{self, WindowPlace};
use crate::base::language::{text, tr};
use crate::models::disturbances::{Disturbance, Zone};
use crate::run::scenario::param;

/// What the buttons are for.
const HELP: &str =
    text!("Drops a disturbance into the cut, a little ahead of the tool; Undo takes it back");

/// The window.
#[derive(Default)]
pub struct DisturbWindow {
    /// Whether it is shown.
    pub open: bool,
}

/// A sign for each kind in one row, where there is room for it, and a button for the window with names and sizes.
pub fn buttons(ui: &mut Ui, view: &View<'_>, open: &mut bool, commands: &mut Vec<Command>) {
    /// Room between the signs, points.
    const GAP: f32 = 2.0;
    let count = Disturbance::ALL.len() + 1;
    let room = ui.available_width() - (count - 1) as f32 * GAP;
    let least = vec2(room / count as f32, ui.spacing().interact_size.y).max(touch::least(ui));
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing = vec2(GAP, GAP);
        ui.horizontal_wrapped(|ui| {
            for kind in Disturbance::ALL.iter().copied() {
                let command = Command::drop(kind);
                let keys = shortcuts::hint(ui.ctx(), view.place, &command);
                if drop::sign(ui, kind, least, &keys).clicked() {
                    commands.push(command);
                }
            }
            let dots = Button::new("\u{2026}").min_size(least).frame(true);
            let dots = ui.scope(|ui| {
                ui.spacing_mut().button_padding.x = 0.0;
                ui.add(dots)
            });
            let name = tr("Names and sizes of disturbances");
            dots.inner.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
            if dots.inner.on_hover_text(name).clicked() {
                *open = !*open;
            }
        });
    });
}

/// Opens the window, and closes it: the one button where there is no room for all, at the right end of a line that is
/// there already, so that it is in sight at all times.
pub fn switch(ui: &mut Ui, line: Rect, open: &mut bool) {
    let words = tr("Disturb the cut\u{2026}");
    let font = TextStyle::Button.resolve(ui.style());
    let text = ui.painter().layout_no_wrap(words.to_owned(), font, Color32::PLACEHOLDER);
    let width = text.size().x + 2.0 * ui.spacing().button_padding.x;
    let right = ui.max_rect().right();
    let left = (right - width).max(line.right() + ui.spacing().item_spacing.x);
    let place = Rect::from_x_y_ranges(left..=right, line.y_range());
    if ui.put(place, Button::new(words)).on_hover_text(tr(HELP)).clicked() {
        *open = !*open;
    }
}

fn button(
    ui: &mut Ui,
    view: &View<'_>,
    kind: Disturbance,
    width: f32,
    commands: &mut Vec<Command>,
) {
    let command = Command::drop(kind);
    let keys = shortcuts::hint(ui.ctx(), view.place, &command);
    if drop::button(ui, kind, width, false, keys.trim()).clicked() {
        commands.push(command);
    }
}

impl DisturbWindow {
    /// Shows it, if it is open.
    pub fn show(&mut self, ui: &Ui, view: &View<'_>, commands: &mut Vec<Command>) {
        let size = [theme::OVERLAY_WIDTH, theme::OVERLAY_HEIGHTS[1]];
        let place = WindowPlace { screen: ui.max_rect(), narrow: view.narrow, size, share: 0.42 };
        window::show(ui.ctx(), text!("Disturb the cut"), place, &mut self.open, |ui| {
            ui.label(tr(
                "A press on a name drops that disturbance a little ahead of the tool, as long and as large as set beside it.",
            ));
            for kind in Disturbance::ALL.iter().copied() {
                ui.separator();
                row(ui, view, kind, commands);
            }
        });
    }
}

/// The button of a kind with what the next one is like.
fn row(ui: &mut Ui, view: &View<'_>, kind: Disturbance, commands: &mut Vec<Command>) {
    /// Width of the button, points.
    const BUTTON: f32 = 170.0;
    ui.horizontal_wrapped(|ui| {
        button(ui, view, kind, BUTTON, commands);
        let Some(spec) = param(kind.path()).ok().map(|param| &param.spec) else { return };
        let before = view.session.offered(kind);
        let (mut zone, mut said) = (before, None);
        let bounds = |least: &str, most: &str| {
            spec.allowed.bound(least).zip(spec.allowed.bound(most)).map(|(a, b)| [a, b])
        };
        if let Some(range) = bounds("min_length_mm", "max_length_mm") {
            let name = tr!("Length of the {disturbance}", disturbance = tr(kind.in_text()));
            field(ui, (&name, "mm", tr(" mm long")), range, &mut zone.length_mm, &mut said);
        }
        if let (Some(range), Some(size)) = (bounds("min_size", "max_size"), kind.size()) {
            let name = tr!("Size of the {disturbance}", disturbance = tr(kind.in_text()));
            field(ui, (&name, spec.unit, tr(size.suffix)), range, &mut zone.size, &mut said);
        }
        commands.extend(said.map(Command::notify));
        if zone != before {
            let zone = Zone { at_mm: 0.0, ..zone };
            let offer = DisturbCommand::Offer { kind, zone };
            commands.push(Command::Session(SessionCommand::Disturb(offer)));
        }
    });
}

/// A field with its range behind it.
fn field(
    ui: &mut Ui,
    (name, unit, suffix): (&str, &str, &str),
    range: [f64; 2],
    value: &mut f64,
    said: &mut Option<String>,
) {
    let speed = ((range[1] - range[0]) / 500.0).min(0.25);
    let field = NumberField { name, unit, range, speed, decimals: 2, least: 0, suffix };
    let response = field.show(ui, value, said);
    response.widget_info(|| WidgetInfo {
        label: Some(name.to_owned()),
        ..WidgetInfo::drag_value(true, *value)
    });
    response.on_hover_text(name);
    let [least, most] = range;
    let range = tr!("{least} to {most}", least = least, most = most);
    let range = format::beside(range, &format::unit(unit));
    // Whole: on the next line where this one has no room for it.
    ui.add(Label::new(RichText::new(range).weak()).extend());
}

//! The editor of one setting, made from its entry in the table of settings: slider, number, choice,
//! switch, text, or what a structured setting asks for. Right-click (or a long press) offers the default.

mod formula;
mod reason;
mod script;
mod structured;

use egui::{ComboBox, Response, RichText, Slider, Ui};

use super::super::command::Command;
use super::super::format;
use super::super::framed;
use super::super::theme::Palette;
use super::beside::help_beside;
use super::number::NumberField;
use super::{focus, touch};
use crate::base::language::{decimal, tr};
use crate::base::settings::{Kind, Value};
use crate::models::genetic::FormulaSettings;
use crate::run::scenario::{Param, Scenario, param};
use crate::study::uses::Screen;
pub use reason::Reason;

/// The size of an editor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// A line for name and value, and a slider below over the whole width.
    Large,
    /// One line.
    Small,
}

/// Ranges over more than this many times their least value get a logarithmic slider.
const LOGARITHMIC_FROM: f64 = 50.0;

/// The editor of the setting at `path` on a screen, showing its value in `scenario`. Where nothing on
/// that screen uses the setting as the others stand, or where it is locked, it is greyed and says why.
pub fn setting(
    ui: &mut Ui,
    screen: Screen,
    path: &str,
    scenario: &Scenario,
    size: Size,
    commands: &mut Vec<Command>,
) {
    let (Ok(param), Ok(value)) = (param(path), scenario.get(path)) else { return };
    let (mut changed, mut said) = (None, None);
    let mut change = |value: Value| changed = Some(value);
    let said_here = &mut said;
    let spec = &param.spec;
    // A model's formula is not used before its calibration is chosen, which using it does.
    let greyed = screen.greyed(scenario, path).filter(|_| !FormulaSettings::is_model(path));
    let locked = framed::is_locked(ui.ctx(), path);
    let closed = framed::closed(ui.ctx(), path);
    ui.push_id(path, |ui| {
        if closed.is_some() || greyed.is_some() {
            ui.disable();
        }
        let mut slider = None;
        let response = match (&spec.allowed, &value) {
            (Kind::Float { min, max }, Value::Float(now)) => {
                let mut set = |x: f64| change(Value::Float(x));
                let slider = (size == Size::Large).then_some(&mut slider);
                number(ui, param, [*min, *max], *now, slider, &mut set, said_here)
            }
            (Kind::Int { min, max }, Value::Int(now)) => {
                // Whole numbers are names and counts rather than amounts: no slider.
                let range = [*min as f64, *max as f64];
                let mut set = |x: f64| change(Value::Int(x.round() as i64));
                number(ui, param, range, *now as f64, None, &mut set, said_here)
            }
            (Kind::Bool, Value::Bool(now)) => {
                let mut on = *now;
                let response = ui.checkbox(&mut on, tr(spec.label));
                if response.changed() {
                    change(Value::Bool(on));
                }
                response
            }
            (Kind::Choice { .. }, Value::Text(now)) => choice(ui, param, now, size, &mut change),
            (Kind::Text { .. }, Value::Text(now)) => text(ui, param, now, &mut change),
            (Kind::Structured(shape), now) => {
                let editor = shape.editor();
                structured::edit(ui, param, &editor, now, &mut change, said_here, commands)
            }
            _ => unreachable!("the table pairs kinds with values"),
        };
        let response = match (&closed, &greyed) {
            (Some(closed), _) => response.on_disabled_hover_ui(|ui| {
                describe(ui, param);
                ui.label(closed);
            }),
            (None, Some(because)) => response.on_disabled_hover_ui(|ui| {
                describe(ui, param);
                ui.label(not_used(&Reason::of(because)));
            }),
            (None, None) => response.on_hover_ui(|ui| describe(ui, param)),
        };
        for part in [Some(response), slider].into_iter().flatten() {
            part.context_menu(|ui| {
                let default = match &spec.default {
                    number @ (Value::Float(_) | Value::Int(_)) => decimal(number.to_string()),
                    other @ (Value::Bool(_) | Value::Text(_) | Value::List(_)) => other.to_string(),
                };
                let unit = format::unit(spec.unit);
                let reset = tr!("Reset to {default} {unit}", default = default, unit = unit);
                if ui.button(reset.trim_end()).clicked() {
                    change(spec.default.clone());
                    ui.close();
                }
            });
        }
    });
    if locked {
        ui.label(RichText::new(tr("Locked")).small().color(Palette::at(ui).weak));
    }
    commands.extend(said.map(Command::notify));
    commands.extend(changed.map(|value| {
        if spec.allowed.takes_formula() {
            Command::set_formula(path, value)
        } else {
            Command::set(path, value)
        }
    }));
}

/// What is said of a setting that has no part now.
#[must_use]
pub fn not_used(reason: &Reason) -> String {
    tr!("Not used now: {because}.", because = reason.text)
}

/// The tooltip: what it is, what is allowed, its name in files.
fn describe(ui: &mut Ui, param: &Param) {
    let spec = &param.spec;
    ui.set_max_width(320.0);
    ui.strong(tr(spec.label));
    ui.label(format::typeset(&tr(spec.doc).replace('\n', " ")));
    if let Kind::Choice { options } = &spec.allowed {
        let offered = options.iter();
        let offered: Vec<_> =
            offered.filter(|option| framed::is_offered(ui.ctx(), &param.path, option.id)).collect();
        for option in offered {
            ui.label(format!("{}: {}", tr(option.label), tr(option.doc).replace('\n', " ")));
        }
    } else {
        let allowed = spec.allowed.allowed(&format::unit(spec.unit));
        ui.label(tr!("Allowed: {allowed}.", allowed = allowed));
    }
    let acts = if spec.live {
        tr("acts at once, also during the cut")
    } else {
        tr("belongs to the set-up")
    };
    ui.weak(format!("{} ({acts})", param.path));
}

/// A number to drag or type, and a slider below where there is a place for its response: it has no
/// tooltip, which would hide what is below it.
fn number(
    ui: &mut Ui,
    param: &Param,
    [min, max]: [f64; 2],
    now: f64,
    slider: Option<&mut Option<Response>>,
    set: &mut dyn FnMut(f64),
    said: &mut Option<String>,
) -> Response {
    let spec = &param.spec;
    let mut value = now;
    let unit = format::unit(spec.unit);
    let suffix = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let whole = matches!(spec.allowed, Kind::Int { .. });
    let decimals = if whole { 0 } else { decimals(min, max) };
    let (label, response) = labelled(ui, param, |ui| {
        let field = NumberField {
            name: tr(spec.label),
            unit: spec.unit,
            range: [min, max],
            speed: (now.abs() * 0.004).max((max - min) * 2e-4),
            decimals,
            least: 0,
            suffix: &suffix,
        };
        field.show(ui, &mut value, said)
    });
    if let Some(place) = slider {
        ui.spacing_mut().slider_width = ui.available_width();
        let logarithmic = min > 0.0 && max / min > LOGARITHMIC_FROM;
        let before = value;
        let slider = Slider::new(&mut value, min..=max)
            .show_value(false)
            .logarithmic(logarithmic)
            .max_decimals(decimals);
        let slider = ui.add(slider).labelled_by(label.id);
        touch::only_across(ui, &slider, &mut value, before);
        if slider.drag_stopped() {
            // So that the keys go to the playhead again.
            focus::leave(&slider);
        }
        remember_rect(ui, &param.path, slider.rect);
        *place = Some(slider);
    }
    let value = if whole { value.round() } else { value };
    if value != now && value.is_finite() {
        set(value);
    }
    response.union(label)
}

/// A line with the label at the left and an editor at the right, tied together for screen readers.
fn labelled(
    ui: &mut Ui,
    param: &Param,
    edit: impl FnOnce(&mut Ui) -> Response,
) -> (Response, Response) {
    ui.horizontal(|ui| {
        let label = touch::name(ui, tr(param.spec.label));
        let right = egui::Layout::right_to_left(egui::Align::Center);
        let response = ui.with_layout(right, edit).inner.labelled_by(label.id);
        (label, response)
    })
    .inner
}

/// Digits that a number in this range needs.
fn decimals(min: f64, max: f64) -> usize {
    match max - min {
        span if span <= 1.0 => 4,
        span if span <= 10.0 => 3,
        span if span <= 1000.0 => 2,
        _ => 1,
    }
}

fn choice(
    ui: &mut Ui,
    param: &Param,
    now: &str,
    size: Size,
    change: &mut dyn FnMut(Value),
) -> Response {
    let Kind::Choice { options } = &param.spec.allowed else { unreachable!("kind of a choice") };
    let chosen =
        options.iter().find(|option| option.id == now).map_or(now, |option| tr(option.label));
    let mut combo = |ui: &mut Ui, width: f32| {
        ComboBox::from_id_salt("choice")
            .width(width)
            .truncate()
            .selected_text(chosen)
            .show_ui(ui, |ui| {
                let offered = |id: &str| id == now || framed::is_offered(ui.ctx(), &param.path, id);
                let options: Vec<_> = options.iter().filter(|option| offered(option.id)).collect();
                for option in options {
                    let response = ui.selectable_label(option.id == now, tr(option.label));
                    help_beside(&response, &tr(option.doc).replace('\n', " "));
                    if response.clicked() {
                        ui.close();
                        if option.id != now {
                            change(Value::Text(option.id.to_owned()));
                        }
                    }
                }
            })
            .response
    };
    let fraction = if size == Size::Large { 0.68 } else { 0.52 };
    let room = ui.available_width();
    let wide = |ui: &Ui, text: &str| {
        let font = egui::TextStyle::Body.resolve(ui.style());
        ui.painter().layout_no_wrap(text.to_owned(), font, egui::Color32::PLACEHOLDER).size().x
    };
    let gap = ui.spacing().item_spacing.x;
    // The arrow and the frame of the list take their room as well.
    let around = ui.spacing().icon_width + 3.0 * gap;
    let (name, needed) = (wide(ui, tr(param.spec.label)), wide(ui, chosen) + around);
    if name + gap + needed > room {
        // Below each other, rather than both cut off.
        let label = touch::name(ui, tr(param.spec.label));
        let response = combo(ui, room).labelled_by(label.id);
        return label.union(response);
    }
    let width = needed.max(room * fraction).min(room - name - gap);
    let (label, response) = labelled(ui, param, |ui| combo(ui, width));
    // Under the label's id: a menu under that of the list would be taken for the list.
    label.union(response)
}

fn text(ui: &mut Ui, param: &Param, now: &str, change: &mut dyn FnMut(Value)) -> Response {
    let Kind::Text { max_chars } = param.spec.allowed else { unreachable!("kind of a text") };
    let label = ui.label(tr(param.spec.label));
    // The text being written is kept until the field is left: one step of undo.
    let id = ui.scope_id().with("draft");
    let mut draft = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| now.to_owned());
    let edit =
        egui::TextEdit::singleline(&mut draft).char_limit(max_chars).desired_width(f32::INFINITY);
    let response = ui.add(edit).labelled_by(label.id);
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, draft));
    } else {
        if response.lost_focus() && draft != now {
            change(Value::Text(draft));
        }
        ui.data_mut(|data| data.remove::<String>(id));
    }
    response
}

fn rect_id(path: &str) -> egui::Id {
    egui::Id::unique(("slider", path))
}

fn remember_rect(ui: &Ui, path: &str, rect: egui::Rect) {
    ui.data_mut(|data| data.insert_temp(rect_id(path), rect));
}

/// Where the slider of a setting was drawn last.
#[must_use]
pub fn slider_rect(ctx: &egui::Context, path: &str) -> Option<egui::Rect> {
    ctx.data(|data| data.get_temp(rect_id(path)))
}

//! Editors of structured settings: which one is said by their shape.

use egui::{Response, Ui, WidgetInfo};

use super::super::icon::{self, Icon};
use super::super::number::NumberField;
use super::labelled;
use crate::app::command::Command;
use crate::app::format;
use crate::base::language::tr;
use crate::base::settings::{Editor, Numbers, Rows, Value};
use crate::run::scenario::Param;

/// Most rows that are shown one by one.
const MOST_ROWS: usize = 64;

/// The editor that the shape of a setting asks for.
pub(super) fn edit(
    ui: &mut Ui,
    param: &Param,
    editor: &Editor,
    now: &Value,
    change: &mut dyn FnMut(Value),
    said: &mut Option<String>,
    commands: &mut Vec<Command>,
) -> Response {
    match editor {
        Editor::Rows(shown) => rows(ui, param, shown, now, change, said),
        Editor::Numbers(shown) => numbers(ui, param, shown, now, change, said),
        Editor::Count(what) => count(ui, param, what, now),
        Editor::Presence => presence(ui, param, now, change),
        Editor::Script => super::script::edit(ui, param, now, change),
        Editor::Formula(shape) => super::formula::edit(ui, param, shape, now, change, commands),
    }
}

/// Whether there is something, and a button that removes it; files bring it.
fn presence(ui: &mut Ui, param: &Param, now: &Value, change: &mut dyn FnMut(Value)) -> Response {
    let (label, _) = labelled(ui, param, |ui| {
        if *now == param.spec.default {
            return ui.label(tr("none"));
        }
        let response = ui.button(tr("Remove"));
        let response = response.on_hover_text(tr("Begin with those of the start again"));
        let name = tr!("Remove: {setting}", setting = tr(param.spec.label));
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, name.clone()));
        if response.clicked() {
            change(param.spec.default.clone());
        }
        response
    });
    label
}

/// More rows than anybody edits by hand: how many there are, and a button that removes them; files bring them.
fn many(ui: &mut Ui, param: &Param, count: usize, change: &mut dyn FnMut(Value)) -> Response {
    let (label, _) = labelled(ui, param, |ui| {
        ui.label(count.to_string());
        let response = ui.button(tr("Remove"));
        let name = tr!("Remove: {setting}", setting = tr(param.spec.label));
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, name.clone()));
        if response.clicked() {
            change(param.spec.default.clone());
        }
        response
    });
    label
}

/// Rows of numbers, ascending in the first one.
fn rows(
    ui: &mut Ui,
    param: &Param,
    shown: &Rows,
    now: &Value,
    change: &mut dyn FnMut(Value),
    said: &mut Option<String>,
) -> Response {
    let Rows { row, columns, most, gap, next } = shown;
    let row = tr(row);
    let rows: Option<Vec<Vec<f64>>> =
        now.list().and_then(|list| list.iter().map(Value::numbers).collect());
    let mut rows = rows.unwrap_or_default();
    if rows.len() > MOST_ROWS {
        return many(ui, param, rows.len(), change);
    }
    let response = ui.label(tr(param.spec.label));
    let mut removed = None;
    let mut touched = false;
    for i in 0..rows.len() {
        // Between the neighbours: rows stay in order while they are dragged.
        let [least, largest] = columns[0].range;
        let low = if i == 0 { least } else { rows[i - 1][0] + gap };
        let high = rows.get(i + 1).map_or(largest, |next| next[0] - gap);
        ui.horizontal(|ui| {
            for (c, (value, column)) in rows[i].iter_mut().zip(columns).enumerate() {
                let name = tr!(
                    "{column} of {row} {number}",
                    column = tr(column.name),
                    row = row,
                    number = i + 1
                );
                let field = NumberField {
                    name: &name,
                    unit: param.spec.unit,
                    range: if c == 0 { [low, high] } else { column.range },
                    speed: column.speed,
                    decimals: 3,
                    least: 0,
                    suffix: tr(column.suffix),
                };
                let response = field.show(ui, value, said);
                response.widget_info(|| WidgetInfo {
                    label: Some(name.clone()),
                    ..WidgetInfo::drag_value(true, *value)
                });
                touched |= response.changed();
            }
            let name = tr!("Remove {row} {number}", row = row, number = i + 1);
            if icon::button(ui, Icon::Close, &name, &name, true).clicked() {
                removed = Some(i);
            }
        });
    }
    if let Some(i) = removed {
        rows.remove(i);
        touched = true;
    }
    let mut new = next.clone();
    new[0] += rows.last().map_or(columns[0].range[0], |row| row[0]);
    let room = rows.len() < *most && new[0] <= columns[0].range[1];
    if ui.add_enabled(room, egui::Button::new(tr!("Add a {row}", row = row))).clicked() {
        rows.push(new);
        touched = true;
    }
    if touched {
        change(Value::from(rows));
    }
    response
}

/// A list of numbers, a line for each; a new one is as the last, or in the middle of what is allowed.
fn numbers(
    ui: &mut Ui,
    param: &Param,
    shown: &Numbers,
    now: &Value,
    change: &mut dyn FnMut(Value),
    said: &mut Option<String>,
) -> Response {
    let Numbers { each, range, most } = shown;
    let each = tr(each);
    let mut list = now.numbers().unwrap_or_default();
    let before = list.clone();
    let unit = format::unit(param.spec.unit);
    let response = ui.label(tr(param.spec.label));
    if list.is_empty() {
        ui.weak(tr!("the same for every {each}", each = each));
    }
    let mut removed = None;
    for (i, value) in list.iter_mut().enumerate() {
        ui.horizontal(|ui| {
            let name = format!("{} {}: {}", each, i + 1, tr(param.spec.label));
            let field = NumberField {
                name: &name,
                unit: param.spec.unit,
                range: *range,
                speed: (range[1] - range[0]) * 2e-4,
                decimals: 2,
                least: 0,
                suffix: &format!(" {unit}"),
            };
            ui.label(format!("{each} {}", i + 1));
            let response = field.show(ui, value, said);
            response.widget_info(|| WidgetInfo {
                label: Some(name.clone()),
                ..WidgetInfo::drag_value(true, *value)
            });
            let name = tr!(
                "Remove {setting} of {each} {number}",
                setting = tr(param.spec.label),
                each = each,
                number = i + 1
            );
            if icon::button(ui, Icon::Close, &name, &name, true).clicked() {
                removed = Some(i);
            }
        });
    }
    if let Some(i) = removed {
        list.remove(i);
    }
    let room = list.len() < *most;
    let add = tr!("Add one for {each} {number}", each = each, number = list.len() + 1);
    let button = egui::Button::new(add);
    if ui.add_enabled(room, button).clicked() {
        list.push(list.last().copied().unwrap_or(middle(*range)));
    }
    if list != before {
        change(Value::from(list));
    }
    response
}

/// The middle of a range, by ratio where that is positive.
fn middle([least, largest]: [f64; 2]) -> f64 {
    if least > 0.0 { (least * largest).sqrt().round() } else { 0.5 * (least + largest) }
}

/// How many there are.
fn count(ui: &mut Ui, param: &Param, what: &str, now: &Value) -> Response {
    let text = match (now.list().map_or(0, <[Value]>::len), what) {
        (0, _) => tr("none").to_owned(),
        (1, "cut") => tr("1 cut").to_owned(),
        (n, "cut") => tr!("{n} cuts", n = n),
        (n, _) => format!("{}: {n}", tr(what)),
    };
    labelled(ui, param, |ui| ui.label(text)).0
}

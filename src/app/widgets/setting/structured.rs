//! Editors of structured settings: which one is said by their shape.

use egui::{Response, Ui, WidgetInfo};

use super::super::icon::{self, Icon};
use super::super::number::NumberField;
use super::labelled;
use crate::base::settings::{Editor, Rows, Value};
use crate::run::scenario::{Param, parse_value};

/// The editor that the shape of a setting asks for.
pub(super) fn edit(
    ui: &mut Ui,
    param: &Param,
    editor: &Editor,
    now: &Value,
    change: &mut dyn FnMut(Value),
    said: &mut Option<String>,
) -> Response {
    match editor {
        Editor::Rows(shown) => rows(ui, param, shown, now, change, said),
        Editor::Lines => lines(ui, param, now, change, said),
        Editor::Presence => presence(ui, param, now, change),
    }
}

/// Whether there is something, and a button that removes it; files bring it.
fn presence(ui: &mut Ui, param: &Param, now: &Value, change: &mut dyn FnMut(Value)) -> Response {
    let (label, _) = labelled(ui, param, |ui| {
        if *now == param.spec.default {
            return ui.label("none");
        }
        let response = ui.button("Remove").on_hover_text("Begin with those of the start again");
        let name = format!("Remove: {}", param.spec.label);
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
    let rows: Option<Vec<Vec<f64>>> =
        now.list().and_then(|list| list.iter().map(Value::numbers).collect());
    let mut rows = rows.unwrap_or_default();
    let response = ui.label(param.spec.label);
    let mut removed = None;
    let mut touched = false;
    for i in 0..rows.len() {
        // Between the neighbours: rows stay in order while they are dragged.
        let [least, largest] = columns[0].range;
        let low = if i == 0 { least } else { rows[i - 1][0] + gap };
        let high = rows.get(i + 1).map_or(largest, |next| next[0] - gap);
        ui.horizontal(|ui| {
            for (c, (value, column)) in rows[i].iter_mut().zip(columns).enumerate() {
                let name = format!("{} of {row} {}", column.name, i + 1);
                let field = NumberField {
                    name: &name,
                    unit: param.spec.unit,
                    range: if c == 0 { [low, high] } else { column.range },
                    speed: column.speed,
                    decimals: 3,
                    suffix: column.suffix,
                };
                let response = field.show(ui, value, said);
                response.widget_info(|| WidgetInfo {
                    label: Some(name.clone()),
                    ..WidgetInfo::drag_value(true, *value)
                });
                touched |= response.changed();
            }
            let name = format!("Remove {row} {}", i + 1);
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
    if ui.add_enabled(room, egui::Button::new(format!("Add a {row}"))).clicked() {
        rows.push(new);
        touched = true;
    }
    if touched {
        change(Value::from(rows));
    }
    response
}

/// A list, or lists of lists, as text: taken over when the field is left, faults are answered.
fn lines(
    ui: &mut Ui,
    param: &Param,
    now: &Value,
    change: &mut dyn FnMut(Value),
    said: &mut Option<String>,
) -> Response {
    let label = ui.label(param.spec.label);
    let id = ui.scope_id().with("draft");
    // An entry a line, as long as nothing else is being written.
    let shown = now.to_string().replace("]], [[", "]],\n[[");
    let mut draft = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| shown.clone());
    let edit = egui::TextEdit::multiline(&mut draft).desired_rows(2).desired_width(f32::INFINITY);
    let response = ui.add(edit.code_editor()).labelled_by(label.id);
    if response.has_focus() {
        ui.data_mut(|data| data.insert_temp(id, draft));
    } else {
        if response.lost_focus() && draft != shown {
            match parse_value(&param.path, &draft) {
                Ok(value) => change(value),
                Err(error) => *said = Some(error.to_string()),
            }
        }
        ui.data_mut(|data| data.remove::<String>(id));
    }
    response
}

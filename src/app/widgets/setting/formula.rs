//! The editor of a formula of one's own: it is typed, with the range of each of its inputs, or opened from a file.
//! What is wrong with it is said below it, with its place, before it is used.

use egui::{Button, Response, RichText, Role, TextEdit, Ui, WidgetInfo};

use super::super::super::command::{Command, FileCommand};
use super::super::standing::Standing;
use super::super::touch;
use crate::app::format;
use crate::app::theme::Palette;
use crate::base::equation::number;
use crate::base::formula::{Formula, Interval};
use crate::base::language::{decimal, text, tr};
use crate::base::settings::{FormulaShape, Value};
use crate::models::formula_model::{FormulaInput, FormulaModel};
use crate::run::scenario::Param;

/// Most characters of a formula that is typed.
const MOST_CHARS: usize = 2000;

/// Where a formula that was typed comes from, as files of models say it.
const TYPED: &str = text!("typed in the console");

/// A formula being written.
#[derive(Clone, Debug, PartialEq)]
struct Draft {
    /// What it was begun from: names, units and result of the model.
    like: FormulaModel,
    text: String,
    /// The ends of each input's range as they are typed.
    ranges: Vec<[String; 2]>,
}

impl Draft {
    fn of(model: FormulaModel) -> Self {
        let ends = |input: &FormulaInput| {
            [input.range.low, input.range.high].map(|x| decimal(x.to_string()))
        };
        let ranges = model.inputs().iter().map(ends).collect();
        Self { text: model.formula().to_string(), ranges, like: model }
    }

    /// The model that is written, or what is wrong with it.
    fn model(&self) -> Result<FormulaModel, String> {
        let names: Vec<&str> = self.like.inputs().iter().map(|input| input.name.as_str()).collect();
        let constants = self.like.formula().own_constants();
        let formula = Formula::parse_with(&self.text, &names, &constants)
            .map_err(|error| error.to_string())?;
        let mut inputs = Vec::new();
        for (input, [low, high]) in self.like.inputs().iter().zip(&self.ranges) {
            let end = |text: &String| {
                let number = super::super::number::parse(text, &input.unit.to_string());
                number.ok_or_else(|| {
                    tr!(
                        "range of {input}: `{text}` is not a number",
                        input = input.name,
                        text = text
                    )
                })
            };
            let (low, high) = (end(low)?, end(high)?);
            if low >= high {
                return Err(tr!(
                    "range of {input}: {low} is not below {high}",
                    input = input.name,
                    low = low,
                    high = high
                ));
            }
            inputs.push(FormulaInput { range: Interval::new(low, high), ..input.clone() });
        }
        // What was said of the formula before does not hold of another one.
        let same = self.text == self.like.formula().to_string();
        let source = if same { self.like.source() } else { TYPED };
        FormulaModel::new(formula, inputs, self.like.output().clone(), source.to_owned())
    }
}

/// The editor; `now` is the setting's value.
pub(super) fn edit(
    ui: &mut Ui,
    param: &Param,
    shape: &FormulaShape,
    now: &Value,
    change: &mut dyn FnMut(Value),
    commands: &mut Vec<Command>,
) -> Response {
    let Value::Text(text) = now else { return ui.label(tr(param.spec.label)) };
    let own = FormulaModel::parse(text).ok();
    let id = ui.scope_id().with("formula");
    let draft = ui.data(|data| data.get_temp::<Draft>(id));
    let label = ui.label(tr(param.spec.label));
    if let Some(mut draft) = draft {
        let mut open = true;
        write(ui, param, shape, &mut draft, &mut open, change);
        ui.data_mut(|data| {
            if open {
                data.insert_temp(id, draft);
            } else {
                data.remove::<Draft>(id);
            }
        });
        return label;
    }
    if let Some(model) = &own {
        shown(ui, shape, model);
    }
    ui.horizontal_wrapped(|ui| {
        let what = if own.is_some() { tr("Change") } else { tr("Type") };
        let help = tr("Write the formula and the ranges of its inputs");
        if button(ui, param, what, help, true) {
            let begun = own.clone().or_else(|| FormulaModel::parse(shape.example).ok());
            if let Some(model) = begun {
                ui.data_mut(|data| data.insert_temp(id, Draft::of(model)));
            }
        }
        let help = tr("A file of a formula's model, as `steadycut formula --save` writes it");
        if button(ui, param, tr("Open"), help, true) {
            commands.push(Command::File(FileCommand::OpenFormula(param.path.clone())));
        }
        if own.is_some() && button(ui, param, tr("Remove"), tr("The built-in model again"), true) {
            change(param.spec.default.clone());
        }
    });
    label
}

/// A button of this setting, named with it; whether it was pressed.
fn button(ui: &mut Ui, param: &Param, what: &str, help: &str, enabled: bool) -> bool {
    let least = touch::least(ui);
    let response = ui.add_enabled(enabled, Button::new(what).min_size(least)).on_hover_text(help);
    let name = format!("{what}: {}", tr(param.spec.label));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name.clone()));
    response.clicked()
}

/// A unit as it is shown.
fn unit(text: &str) -> String {
    if text.is_empty() { tr("a number").to_owned() } else { format::unit(text) }
}

/// What is used now, with its ranges.
fn shown(ui: &mut Ui, shape: &FormulaShape, model: &FormulaModel) {
    let palette = Palette::at(ui);
    let text = format!("{} = {}", model.output().name, model.formula());
    ui.label(RichText::new(text).monospace());
    let ranges: Vec<String> = model
        .inputs()
        .iter()
        .map(|input| {
            let Interval { low, high } = input.range;
            let unit = format::unit(&input.unit.to_string());
            let [low, high] = [low, high].map(|end| decimal(number(end)));
            tr!(
                "{input} {low} to {high} {unit}",
                input = input.name,
                low = low,
                high = high,
                unit = unit
            )
            .trim_end()
            .to_owned()
        })
        .collect();
    let told = format!("{}: {}", unit(shape.output), ranges.join(", "));
    ui.label(RichText::new(told).small().color(palette.weak));
    if !model.source().is_empty() {
        ui.label(RichText::new(tr(model.source())).small().color(palette.weak));
    }
}

/// The fields of a formula being written.
fn write(
    ui: &mut Ui,
    param: &Param,
    shape: &FormulaShape,
    draft: &mut Draft,
    open: &mut bool,
    change: &mut dyn FnMut(Value),
) {
    let palette = Palette::at(ui);
    let wanted = tr!("{unit} of {meaning}", unit = unit(shape.output), meaning = tr(shape.meaning));
    ui.label(RichText::new(wanted).small().color(palette.weak));
    let name = tr!("Formula: {setting}", setting = tr(param.spec.label));
    let field = TextEdit::multiline(&mut draft.text)
        .char_limit(MOST_CHARS)
        .desired_rows(2)
        .font(egui::TextStyle::Monospace)
        .desired_width(f32::INFINITY);
    let response = ui.add(field.min_size(touch::least(ui)));
    response.widget_info(|| WidgetInfo {
        label: Some(name.clone()),
        ..WidgetInfo::text_edit(true, "", &draft.text, "")
    });
    for (input, ends) in draft.like.inputs().iter().zip(&mut draft.ranges) {
        ui.horizontal_wrapped(|ui| {
            ui.label(&input.name);
            for (text, end) in ends.iter_mut().zip([tr("from"), tr("to")]) {
                ui.label(end);
                let name = format!("{} {end}: {}", input.name, tr(param.spec.label));
                let least = touch::least(ui);
                let field = TextEdit::singleline(text).char_limit(30).desired_width(64.0);
                let response = ui.add(field.min_size(least));
                response.widget_info(|| WidgetInfo {
                    label: Some(name.clone()),
                    ..WidgetInfo::text_edit(true, "", text.as_str(), "")
                });
            }
            ui.label(format::unit(&input.unit.to_string()));
        });
    }
    let written = draft.model();
    match &written {
        Ok(model) => {
            let Interval { low, high } = model.bounds();
            let unit = format::unit(shape.output);
            let [low, high] = [low, high].map(|end| decimal(number(end)));
            let text =
                tr!("gives {low} to {high} {unit} there", low = low, high = high, unit = unit);
            Standing::Good.label(ui, text.trim_end(), RichText::small);
        }
        Err(problem) => {
            let mut lines = problem.lines();
            Standing::Bad.label(ui, lines.next().unwrap_or_default(), RichText::small);
            // The text with a caret below the fault.
            let picture: Vec<&str> = lines.collect();
            if !picture.is_empty() {
                ui.label(RichText::new(picture.join("\n")).monospace().color(palette.bad));
            }
        }
    }
    ui.horizontal_wrapped(|ui| {
        if button(ui, param, tr("Use"), tr("From now on, in the running cut too"), written.is_ok())
            && let Ok(model) = &written
        {
            change(Value::Text(model.write_line()));
            *open = false;
        }
        *open &= !button(ui, param, tr("Cancel"), tr("As it was before"), true);
    });
    if !*open {
        // Another widget may have the place of the field that was written in, and its id: without this the keys
        // would stay with a text that is gone.
        ui.memory_mut(|memory| {
            if let Some(focused) = memory.focused() {
                memory.surrender_focus(focused);
            }
        });
    }
}

//! The editor of a controller's script: it is written, or begun from a template, and goes into the running cut when it
//! is used. What is wrong with it is said below, with its line, before that.

use egui::{Button, ComboBox, Response, RichText, ScrollArea, TextEdit, Ui};

use super::super::standing::Standing;
use super::super::touch;
use crate::app::theme::Palette;
use crate::base::language::tr;
use crate::base::settings::Value;
use crate::blocks::control::script::{MAX_CODE, MAX_STEPS, ScriptProgram, TEMPLATES};
use crate::run::scenario::Param;

/// Lines that are seen at once.
const LINES: usize = 12;

/// The editor; `now` is the setting's value.
pub(super) fn edit(
    ui: &mut Ui,
    param: &Param,
    now: &Value,
    change: &mut dyn FnMut(Value),
) -> Response {
    let Value::Text(text) = now else { return ui.label(tr(param.spec.label)) };
    let id = ui.scope_id().with("draft of a script");
    let mut draft = ui.data(|data| data.get_temp::<String>(id)).unwrap_or_else(|| text.clone());
    let mut take = None;
    let label = ui
        .horizontal_wrapped(|ui| {
            let label = ui.label(tr(param.spec.label));
            ComboBox::from_id_salt("templates").selected_text(tr("Begin from")).show_ui(ui, |ui| {
                for (name, template) in TEMPLATES {
                    if ui.selectable_label(draft == template, name).clicked() {
                        template.clone_into(&mut draft);
                        ui.close();
                    }
                }
            });
            label
        })
        .inner;
    let height = ui.text_style_height(&egui::TextStyle::Monospace) * LINES as f32;
    ScrollArea::both().id_salt("script").max_height(height).show(ui, |ui| {
        let edit = TextEdit::multiline(&mut draft)
            .code_editor()
            .char_limit(MAX_CODE)
            .desired_rows(LINES)
            .desired_width(f32::INFINITY);
        ui.add(edit).labelled_by(label.id);
    });
    let changed = draft != *text;
    let problem = ScriptProgram::read(&draft).err();
    match &problem {
        Some(problem) => {
            Standing::Bad.label(ui, &problem.to_string(), RichText::small);
        }
        None if changed => {
            let text = tr("It can be read; it runs once it is used.");
            Standing::Plain.label(ui, text, RichText::small);
        }
        None => {
            let text = tr!("It runs: at most {n} steps in a control period.", n = MAX_STEPS);
            ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
        }
    }
    ui.horizontal_wrapped(|ui| {
        let least = touch::least(ui);
        let button = Button::new(tr("Use this script")).min_size(least);
        let help = tr("In the running cut from here on, with a state of its own");
        let can = changed && problem.is_none();
        if ui.add_enabled(can, button).on_hover_text(help).clicked() {
            take = Some(draft.clone());
        }
        let button = Button::new(tr("Discard")).min_size(least);
        if ui.add_enabled(changed, button).clicked() {
            text.clone_into(&mut draft);
        }
    });
    ui.data_mut(|data| {
        if draft == *text || take.is_some() {
            data.remove::<String>(id);
        } else {
            data.insert_temp(id, draft);
        }
    });
    if let Some(code) = take {
        change(Value::Text(code));
    }
    label
}

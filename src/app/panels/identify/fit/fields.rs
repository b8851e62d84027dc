//! Channels in roles with their units, and the options of the fit; what is wrong with one stands below it.

use egui::{CollapsingHeader, RichText, Ui, WidgetInfo};

use super::form::FitForm;
use crate::app::format;
use crate::app::panels::console::measured::choice;
use crate::app::theme::Palette;
use crate::app::widgets::number::NumberField;
use crate::app::widgets::standing::Standing;
use crate::base::language::tr;
use crate::base::settings::Value;
use crate::measured::channel::MeasuredChannel;
use crate::run::scenario::Scenario;
use crate::study::channel_unit::{place_of, units};
use crate::study::identify::fits::{
    ChosenChannel, FitFault, FitOption, FitOptionKind, FitRole, FitValue,
};

/// Change of a number for a point of dragging, of times and where the range is less than so wide; otherwise 1.
const FINE: f64 = 0.01;
const COARSE: f64 = 100.0;
/// Times that can be given, s.
const TIMES: [f64; 2] = [-1e6, 1e6];

/// Shows them.
pub fn show(ui: &mut Ui, form: &mut FitForm, scenario: &Scenario, fault: Option<&FitFault>) {
    let about = form.kind.about();
    ui.label(RichText::new(tr("Which channel is which")).strong());
    for role in about.roles {
        channel(ui, form, role);
        told(ui, role.option, fault);
    }
    if about.options.is_empty() {
        return;
    }
    ui.add_space(6.0);
    let wrong = fault.and_then(|fault| fault.option);
    let here = about.options.iter().any(|option| wrong == Some(option.option));
    let header = CollapsingHeader::new(tr("Options")).id_salt("fit options").default_open(true);
    // What is wrong is never folded away.
    let header = if here { header.open(Some(true)) } else { header };
    header.show_unindented(ui, |ui| {
        for option in about.options {
            ui.push_id(option.option, |ui| {
                let said = self::option(ui, form, option, scenario);
                if let Some(said) = said {
                    Standing::Watch.label(ui, &said, |text| text);
                }
                told(ui, option.option, fault);
            });
        }
    });
}

/// What is wrong with an option, below it.
fn told(ui: &mut Ui, option: &str, fault: Option<&FitFault>) {
    if let Some(fault) = fault.filter(|fault| fault.option == Some(option)) {
        Standing::Bad.label(ui, &fault.text, |text| text);
    }
}

/// The channel in a role, and its unit.
fn channel(ui: &mut Ui, form: &mut FitForm, role: &FitRole) {
    let channels = form.channels();
    let names: Vec<String> = channels.iter().map(|channel| channel.name.clone()).collect();
    let of_file: Vec<String> = channels.iter().map(|channel| channel.unit.clone()).collect();
    let none = match role.needed {
        true => tr("choose"),
        false => tr("none"),
    };
    let titles: Vec<String> = std::iter::once(none.to_owned())
        .chain(channels.iter().map(MeasuredChannel::title))
        .collect();
    let chosen = form.chosen(role).cloned();
    let place = chosen.as_ref().and_then(|chosen| names.iter().position(|n| *n == chosen.channel));
    let label = tr(role.label);
    let response = ui.scope(|ui| choice(ui, label, &titles, Some(place.map_or(0, |at| at + 1))));
    response.response.on_hover_text(tr(role.about));
    if let Some(next) = response.inner {
        let next =
            next.checked_sub(1).map(|at| ChosenChannel { channel: names[at].clone(), unit: None });
        return form.put(role, next);
    }
    let known = units(role.unit);
    let (Some(chosen), Some(place)) = (chosen, place) else { return };
    if known.is_empty() {
        return;
    }
    let unit = chosen.unit.as_ref().unwrap_or(&of_file[place]);
    let is = match unit.as_str() {
        // Where nothing is told, the fit takes its own.
        "" => Some(0),
        unit => place_of(unit, role.unit),
    };
    let shown: Vec<String> = known.iter().map(|unit| format::unit(unit.names[0])).collect();
    let name = tr!("Unit: {channel}", channel = label);
    if let Some(next) = choice(ui, &name, &shown, is) {
        let unit = Some(known[next].names[0].to_owned());
        form.put(role, Some(ChosenChannel { unit, ..chosen }));
    }
}

/// An option; what there is to say of what was typed.
fn option(
    ui: &mut Ui,
    form: &mut FitForm,
    option: &FitOption,
    scenario: &Scenario,
) -> Option<String> {
    let mut said = None;
    let label = tr(option.label);
    let help = tr(option.about);
    match option.kind {
        FitOptionKind::Number { default, .. } => {
            let range = option.range().unwrap_or(TIMES);
            number(ui, form, option, (range, default), "", &mut said);
        }
        FitOptionKind::Setting(path) => {
            let own = match scenario.get(path) {
                Ok(Value::Float(x)) => format::fine(x, option.unit),
                Ok(Value::Int(_) | Value::Bool(_) | Value::Text(_) | Value::List(_)) | Err(_) => {
                    String::new()
                }
            };
            let range = option.range().unwrap_or(TIMES);
            number(ui, form, option, (range, None), &own, &mut said);
        }
        FitOptionKind::Span => span(ui, form, option, &mut said),
        FitOptionKind::Switch => {
            let mut on = form.value(option) == Some(&FitValue::On);
            if ui.checkbox(&mut on, label).on_hover_text(help).changed() {
                form.say(option, on.then_some(FitValue::On));
            }
        }
        FitOptionKind::Choice(options) => {
            let options = options();
            let id = match form.value(option) {
                Some(FitValue::Id(id)) => Some(id.clone()),
                Some(FitValue::Number(_) | FitValue::Span(_) | FitValue::On) | None => None,
            };
            let is = |id: &String| options.iter().position(|(known, _)| known == id);
            let place = id.as_ref().and_then(is).unwrap_or(0);
            let names: Vec<String> = options.iter().map(|(_, name)| name.clone()).collect();
            let response = ui.scope(|ui| choice(ui, label, &names, Some(place)));
            response.response.on_hover_text(help);
            if let Some(next) = response.inner {
                let id = options[next].0.to_owned();
                form.say(option, (next > 0).then_some(FitValue::Id(id)));
            }
        }
    }
    said
}

/// A number, or none.
fn number(
    ui: &mut Ui,
    form: &mut FitForm,
    option: &FitOption,
    (range, default): ([f64; 2], Option<f64>),
    own: &str,
    said: &mut Option<String>,
) {
    let label = tr(option.label);
    let given = match form.value(option) {
        Some(FitValue::Number(x)) => Some(*x),
        Some(FitValue::Span(_) | FitValue::On | FitValue::Id(_)) | None => default,
    };
    let mut value = given;
    ui.horizontal_wrapped(|ui| {
        // A blank field has no unit behind it, either.
        let suffix = match (value, option.unit) {
            (None, _) | (Some(_), "") => String::new(),
            (Some(_), unit) => format!(" {}", format::unit(unit)),
        };
        let field = NumberField {
            name: label,
            unit: option.unit,
            range,
            speed: if option.unit == "s" || range[1] - range[0] < COARSE { FINE } else { 1.0 },
            decimals: 6,
            least: 0,
            suffix: &suffix,
        };
        let response = field.show_or_blank(ui, &mut value, said);
        let now = value.unwrap_or(0.0);
        response.widget_info(|| WidgetInfo {
            label: Some(label.to_owned()),
            ..WidgetInfo::drag_value(true, now)
        });
        response.on_hover_text(tr(option.about));
        ui.label(label);
        if value.is_none() && !own.is_empty() {
            let text = tr!("the scenario's: {value}", value = own);
            ui.label(RichText::new(text).small().color(Palette::at(ui).weak));
        } else if value.is_some() && default.is_none() && ui.small_button(tr("Clear")).clicked() {
            value = None;
        }
    });
    if value != given {
        form.say(option, value.map(FitValue::Number));
    }
}

/// Two times, or none.
fn span(ui: &mut Ui, form: &mut FitForm, option: &FitOption, said: &mut Option<String>) {
    let label = tr(option.label);
    let given = match form.value(option) {
        Some(FitValue::Span(span)) => Some(*span),
        Some(FitValue::Number(_) | FitValue::On | FitValue::Id(_)) | None => None,
    };
    let whole = || {
        let channel = form.channels().first()?;
        let last = channel.values.len().checked_sub(1)?;
        Some([channel.times.at(0)?, channel.times.at(last)?])
    };
    let mut now = given;
    let mut on = given.is_some();
    if ui.checkbox(&mut on, label).on_hover_text(tr(option.about)).changed() {
        now = on.then(|| whole().unwrap_or([0.0, 1.0]));
    }
    if let Some([from, to]) = &mut now {
        ui.horizontal_wrapped(|ui| {
            for (name, value) in
                [(tr!("From, {time}", time = label), from), (tr!("To, {time}", time = label), to)]
            {
                let field = NumberField {
                    name: &name,
                    unit: "s",
                    range: TIMES,
                    speed: FINE,
                    decimals: 6,
                    least: 0,
                    suffix: " s",
                };
                let response = field.show(ui, value, said);
                let shown = *value;
                response.widget_info(|| WidgetInfo {
                    label: Some(name.clone()),
                    ..WidgetInfo::drag_value(true, shown)
                });
            }
        });
    }
    if now != given {
        form.say(option, now.map(FitValue::Span));
    }
}

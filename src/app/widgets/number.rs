//! A field for a number: it is dragged, or typed with a decimal point or comma, with or without
//! its unit. A text that is no number, or one beyond the range, is answered in words.

use std::cell::{Cell, RefCell};

use egui::{Align2, Context, DragValue, Id, Response, TextStyle, Ui};

use super::super::format;
use super::super::theme::Palette;
use super::{focus, touch};
use crate::base::language::{decimal, tr};

/// What a field holds.
#[derive(Clone, Copy, Debug)]
pub struct NumberField<'a> {
    /// Its name, for messages.
    pub name: &'a str,
    /// Its unit as the tables write it; empty for none.
    pub unit: &'a str,
    /// Least and largest value.
    pub range: [f64; 2],
    /// Change of the value for a point of dragging.
    pub speed: f64,
    /// Most digits behind the point.
    pub decimals: usize,
    /// Digits behind the point that are always written, so that those of a column are as many.
    pub least: usize,
    /// Text behind the number.
    pub suffix: &'a str,
}

/// What is seen in a field without a number; it is no part of its text.
const HINT: &str = "\u{2013}";

fn typed() -> Id {
    Id::unique("number being typed")
}

/// Whether a number without a sign is being typed in this frame: a phone then needs its digits only.
#[must_use]
pub fn is_typed(ctx: &Context) -> bool {
    let last = ctx.data(|data| data.get_temp::<u64>(typed()));
    last == Some(ctx.cumulative_frame_nr())
}

impl NumberField<'_> {
    /// The field; what there is to say about a text that was typed goes to `said`.
    pub fn show(&self, ui: &mut Ui, value: &mut f64, said: &mut Option<String>) -> Response {
        let (mut some, before) = (Some(*value), *value);
        let response = self.field(ui, &mut some, said, false);
        *value = some.unwrap_or(before);
        response
    }

    /// The same for a number that may be none yet: that is no zero, and looks like none. It is given letter by letter, so
    /// that what is pressed next finds it; a text that is no number is none, and is told once it is left.
    pub fn show_or_blank(
        &self,
        ui: &mut Ui,
        number: &mut Option<f64>,
        said: &mut Option<String>,
    ) -> Response {
        self.field(ui, number, said, true)
    }

    fn field(
        &self,
        ui: &mut Ui,
        number: &mut Option<f64>,
        said: &mut Option<String>,
        at_once: bool,
    ) -> Response {
        let [min, max] = self.range;
        let is_blank = number.is_none();
        // A text that is no number yet has the field go on with the last one.
        let id = ui.next_auto_id().with("last number");
        let last = ui.data(|data| data.get_temp::<f64>(id)).filter(|_| is_blank);
        // Within the range: what is pulled into it would look like a number that was given.
        let before = number.or(last).unwrap_or(0.0).clamp(min, max);
        let (problem, typed_number) = (RefCell::new(None), Cell::new(None));
        let mut dragged = before;
        let value = &mut dragged;
        let mut drag = DragValue::new(value)
            .range(min..=max)
            .speed(self.speed)
            .min_decimals(self.least)
            .max_decimals(self.decimals)
            .suffix(self.suffix.to_owned())
            .update_while_editing(at_once)
            .custom_parser(|text| match self.read(text) {
                Ok((number, note)) => {
                    *problem.borrow_mut() = note;
                    typed_number.set(Some(number));
                    Some(number)
                }
                Err(_) if is_blank && text.trim().is_empty() => None,
                Err(note) => {
                    *problem.borrow_mut() = Some(note);
                    None
                }
            });
        if is_blank {
            drag = drag.custom_formatter(|_, _| String::new());
        }
        let response = ui.add(drag);
        let has_focus = response.has_focus();
        if is_blank && !has_focus {
            let font = TextStyle::Body.resolve(ui.style());
            let (at, color) = (response.rect.center(), Palette::at(ui).weak);
            ui.painter().text(at, Align2::CENTER_CENTER, HINT, font, color);
        }
        touch::only_across(ui, &response, value, before);
        if response.lost_focus() {
            focus::remember(&response);
        }
        if response.has_focus() && min >= 0.0 {
            let frame = ui.ctx().cumulative_frame_nr();
            ui.data_mut(|data| data.insert_temp(typed(), frame));
        }
        let problem = problem.into_inner();
        let is_none = at_once && has_focus && problem.is_some();
        // What is being typed may become a number still.
        if let Some(note) = problem.filter(|_| !is_none) {
            *said = Some(note);
        }
        // A zero that was typed is one.
        let given = !is_blank || dragged != before || typed_number.get().is_some();
        if is_none {
            *number = None;
            ui.data_mut(|data| data.insert_temp(id, dragged));
        } else if given {
            *number = Some(dragged);
        }
        if at_once && (given && !is_none || !has_focus) {
            ui.data_mut(|data| data.remove::<f64>(id));
        }
        response
    }

    /// The number given by a text, limited to the range, with a message where it was limited.
    fn read(&self, text: &str) -> Result<(f64, Option<String>), String> {
        // More would fill the window.
        const MOST_CHARS: usize = 40;
        let text: String = text.trim().chars().take(MOST_CHARS).collect();
        let name = self.name;
        let [min, max] = self.range.map(readable);
        let unit = format::unit(self.unit);
        let allowed = tr!(
            "allowed is a number from {min} to {max} {unit}",
            min = min,
            max = max,
            unit = unit
        );
        let allowed = allowed.trim_end();
        let Some(number) = parse(&text, self.unit) else {
            return Err(tr!(
                "{name}: “{text}” is not a number: {allowed}",
                name = name,
                text = text,
                allowed = allowed
            ));
        };
        let limited = number.clamp(self.range[0], self.range[1]);
        if limited == number {
            return Ok((number, None));
        }
        let taken = format!("{} {unit}", decimal(readable(limited).to_string()));
        let said = tr!(
            "{name}: “{text}” was limited to {taken}: {allowed}",
            name = name,
            text = text,
            taken = taken.trim_end(),
            allowed = allowed
        );
        Ok((limited, Some(said)))
    }
}

/// Without the noise of sums in the last digits.
fn readable(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// Letters that mean the same become the same.
fn plain(text: &str) -> String {
    let letters = text.chars().filter(|c| !c.is_whitespace() && *c != '^').map(|c| match c {
        '\u{2212}' => '-',
        'µ' | 'μ' => 'u',
        '³' => '3',
        other => other.to_ascii_lowercase(),
    });
    letters.collect()
}

/// The number given by a text: with point or comma, with or without the unit.
#[must_use]
pub fn parse(text: &str, unit: &str) -> Option<f64> {
    let text = plain(text);
    let own = plain(unit);
    let other_names: &[&str] = if own == "1/min" { &["rpm", "min-1"] } else { &[] };
    let mut names = [own.as_str()].into_iter().chain(other_names.iter().copied());
    let bare = names.find_map(|name| text.strip_suffix(name).filter(|_| !name.is_empty()));
    let bare = bare.unwrap_or(&text);
    // With both signs, which one groups thousands is a guess.
    let comma = bare.matches(',').count() == 1 && !bare.contains('.');
    let number = if comma { bare.replace(',', ".") } else { bare.to_owned() };
    number.parse().ok().filter(|number: &f64| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_people_write_them() {
        let read = [
            ("0,8", "um", 0.8),
            ("0.6 um", "um", 0.6),
            ("0,6 µm", "um", 0.6),
            ("1 200", "HB", 1200.0),
            ("\u{2212}5 %", "%", -5.0),
            ("2100 rpm", "1/min", 2100.0),
            ("2100 1/min", "1/min", 2100.0),
            ("3 MM/min", "mm/min", 3.0),
            ("1e-3", "", 1e-3),
        ];
        for (text, unit, number) in read {
            assert_eq!(parse(text, unit), Some(number), "{text}");
        }
        for text in ["", "abc", "1,2,3", "1.2,3", "nan", "inf", "5 kg"] {
            assert_eq!(parse(text, "mm"), None, "{text}");
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_field_text_and_range() {
        let field = NumberField {
            name: "Target Ra",
            unit: "um",
            range: [0.05, 4.0],
            speed: 0.01,
            decimals: 3,
            least: 0,
            suffix: "",
        };
        let said = field.read("abc").unwrap_err();
        assert_eq!(said, "Target Ra: “abc” is not a number: allowed is a number from 0.05 to 4 µm");
        let (number, said) = field.read("9,5").unwrap();
        assert_eq!(number, 4.0);
        let said = said.unwrap();
        assert!(said.starts_with("Target Ra: “9,5” was limited to 4 µm: allowed"), "{said}");
    }
}

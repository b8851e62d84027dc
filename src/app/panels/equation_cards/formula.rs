//! Formulas as text, and their typesetting with raised and lowered parts.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId};

pub use crate::base::equation::number;

/// Terms joined with their signs; a factor 1 before a symbol is left out.
#[must_use]
pub fn sum(terms: &[(f64, &str)]) -> String {
    let mut text = String::new();
    for (i, (factor, symbol)) in terms.iter().enumerate() {
        let sign = match (i, *factor < 0.0) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        text.push_str(sign);
        let size = factor.abs();
        if symbol.is_empty() {
            text.push_str(&number(size));
        } else if size == 1.0 {
            text.push_str(symbol);
        } else {
            text.push_str(&format!("{} {symbol}", number(size)));
        }
    }
    text
}

#[derive(Clone, Copy, PartialEq)]
enum Level {
    Base,
    Lowered,
    Raised,
}

/// The runs of a formula: text and level.
fn runs(formula: &str) -> Vec<(String, Level)> {
    let mut runs: Vec<(String, Level)> = Vec::new();
    let mut push = |c: char, level: Level| match runs.last_mut() {
        Some((text, last)) if *last == level => text.push(c),
        _ => runs.push((c.to_string(), level)),
    };
    let mut rest = formula.chars().peekable();
    while let Some(c) = rest.next() {
        let level = match c {
            '_' => Level::Lowered,
            '^' => Level::Raised,
            _ => {
                push(c, Level::Base);
                continue;
            }
        };
        match rest.next() {
            Some('{') => rest.by_ref().take_while(|c| *c != '}').for_each(|c| push(c, level)),
            // `A_D` in lists of words stays one letter; so do all short indices.
            Some(c) => push(c, level),
            None => push(c, Level::Base),
        }
    }
    runs
}

/// A formula set in `size` points, its raised and lowered parts smaller, but no text below `least`.
#[must_use]
pub fn typeset(formula: &str, size: f32, least: f32, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let runs = runs(formula);
    // What is raised or lowered must be seen to be smaller than what it belongs to.
    let plain = runs.iter().all(|(_, level)| *level == Level::Base);
    let size = if plain { size } else { size.max(1.25 * least) };
    for (text, level) in runs {
        let (scale, valign) = match level {
            Level::Base => (1.0, Align::Center),
            Level::Lowered => (0.7, Align::BOTTOM),
            Level::Raised => (0.68, Align::TOP),
        };
        let font_id = FontId::proportional((size * scale).max(least));
        job.append(&text, 0.0, TextFormat { font_id, color, valign, ..TextFormat::default() });
    }
    job
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_four_digits() {
        let shown = [0.0, 0.81, 12.345, 324.61, 2201.4, -3.0, 0.00012].map(number);
        assert_eq!(shown, ["0", "0.81", "12.35", "324.6", "2201", "-3", "0.00012"]);
    }

    #[test]
    fn terms_are_joined_by_their_signs() {
        assert_eq!(sum(&[(1.0, "s^2"), (-2.0, "s"), (5.0, "")]), "s^2 - 2 s + 5");
    }

    #[test]
    fn indices_and_powers_are_found() {
        let texts: Vec<String> = runs("F_{dyn} = n^3").into_iter().map(|(text, _)| text).collect();
        assert_eq!(texts, ["F", "dyn", " = n", "3"]);
        assert_eq!(typeset("f_c", 14.0, 12.0, Color32::WHITE).text, "fc");
    }
}

//! Formulas in a narrow column: a line is broken between formulas and words rather than within a term.

use egui::{Label, RichText, TextStyle, Ui};

/// The space that no line is broken at.
const FIRM: char = '\u{a0}';

/// How coarsely a formula is broken, the coarsest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Breaks {
    /// Behind commas, semicolons and colons, and between words.
    Words,
    /// Behind relations, too: what is defined keeps to its sign.
    Relations,
    /// Before sums and products that stand in no brackets, too.
    Terms,
}

impl Breaks {
    /// Whether a line may be broken at the space between two pieces, `depth` brackets deep.
    fn allows(self, before: &str, after: &str, depth: usize) -> bool {
        let is_word = |piece: &str| {
            let piece = piece.trim_matches([',', ';', ':']);
            piece.chars().count() > 1 && piece.chars().all(char::is_alphabetic)
        };
        let ends = before.is_empty() || before.ends_with([',', ';', ':']);
        let relation = ["=", "<", ">", "<=", ">="].contains(&before);
        let term = ["+", "-", "*", "/"].contains(&after);
        let words = depth == 0 && (ends || is_word(before) && is_word(after));
        words
            || self != Self::Words && depth == 0 && relation
            || self == Self::Terms && depth == 0 && term
    }
}

/// The formula with firm spaces where no line is to be broken.
fn firm(formula: &str, breaks: Breaks) -> String {
    let mut out = String::new();
    let (mut depth, mut before) = (0_usize, "");
    for (place, piece) in formula.split(' ').enumerate() {
        if place > 0 {
            out.push(if breaks.allows(before, piece, depth) { ' ' } else { FIRM });
        }
        out.push_str(piece);
        let opened = piece.matches(['(', '[']).count();
        depth = (depth + opened).saturating_sub(piece.matches([')', ']']).count());
        before = piece;
    }
    out
}

/// Shows a formula, broken as coarsely as its parts have room.
pub fn show(ui: &mut Ui, formula: &str) {
    let font = TextStyle::Monospace.resolve(ui.style());
    let width = ui.available_width();
    let fits = |text: &str| {
        text.split(' ').all(|part| {
            let color = ui.visuals().text_color();
            let galley = ui.painter().layout_no_wrap(part.to_owned(), font.clone(), color);
            galley.size().x <= width
        })
    };
    let broken = [Breaks::Words, Breaks::Relations, Breaks::Terms].map(|at| firm(formula, at));
    let text = broken.into_iter().find(|text| fits(text)).unwrap_or_else(|| formula.to_owned());
    ui.add(Label::new(RichText::new(text).monospace()).wrap());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_between_formulas_before_they_are_within_them() {
        let shown = |formula, breaks| firm(formula, breaks).replace(FIRM, "~");
        let two = "Ra = K5(F),  F = K4(f, n) A_D / A_D0";
        assert_eq!(shown(two, Breaks::Words), "Ra~=~K5(F),  F~=~K4(f,~n)~A_D~/~A_D0");
        assert_eq!(shown(two, Breaks::Relations), "Ra~= K5(F),  F~= K4(f,~n)~A_D~/~A_D0");
        assert_eq!(shown(two, Breaks::Terms), "Ra~= K5(F),  F~= K4(f,~n)~A_D /~A_D0");
        let words = "F(u f, n) = F(f, n), solved for the override u";
        assert_eq!(shown(words, Breaks::Words), "F(u~f,~n)~=~F(f,~n), solved for the override~u");
    }
}

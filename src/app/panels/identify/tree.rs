//! A formula as a tree: its operations, with what they work on below them.

use egui::{
    Align2, Color32, CornerRadius, FontId, Pos2, Rect, RichText, Role, Sense, Stroke, StrokeKind,
    Ui, Vec2, WidgetInfo, pos2, vec2,
};

use super::symbols::{short, told_number};
use crate::app::theme::{self, Palette};
use crate::app::widgets::scaffold;
use crate::base::formula::{Function, Node, Operator};
use crate::base::language::tr;

/// Height of a part, and from one level to the next, points.
const HEIGHT: f32 = 24.0;
/// See [`HEIGHT`].
const LEVEL: f32 = 44.0;
/// Least width of a part, and room between two leaves, points.
const WIDTH: f32 = 26.0;
/// See [`WIDTH`].
const GAP: f32 = 8.0;
/// Longest name in a part, characters.
const NAME: usize = 18;

/// What a part is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PartKind {
    Operation,
    Input,
    Number,
}

/// A part where it is drawn.
#[derive(Clone, Debug, PartialEq)]
struct Part {
    text: String,
    kind: PartKind,
    /// Middle, from the upper left corner of the tree.
    at: Pos2,
    width: f32,
    /// The part above it.
    above: Option<usize>,
}

fn label(node: &Node, words: &[&str]) -> (String, PartKind) {
    match node {
        Node::Number(x) => (told_number(*x), PartKind::Number),
        Node::Constant(constant) => (short(&constant.name, NAME), PartKind::Number),
        Node::Input(index) => {
            let word = words.get(*index).copied().unwrap_or("?");
            let bare: String = word.chars().filter(|c| !"{}".contains(*c)).collect();
            (short(&bare.replace('_', " "), NAME), PartKind::Input)
        }
        Node::Unary(function, _) => {
            let name = match function {
                Function::Negative => "\u{2212}",
                Function::Ln
                | Function::Exp
                | Function::Sqrt
                | Function::Sin
                | Function::Cos
                | Function::Tanh => function.name(),
            };
            (name.to_owned(), PartKind::Operation)
        }
        Node::Binary(operator, _) => {
            let sign = match operator {
                Operator::Add => "+",
                Operator::Subtract => "\u{2212}",
                Operator::Multiply => "·",
                Operator::Divide => "/",
                Operator::Power => "^",
            };
            (sign.to_owned(), PartKind::Operation)
        }
    }
}

/// Places a part and all below it, leaves from `left` on; gives its middle.
fn place(
    node: &Node,
    words: &[&str],
    (level, above): (usize, Option<usize>),
    width_of: &dyn Fn(&str) -> f32,
    left: &mut f32,
    parts: &mut Vec<Part>,
) -> f32 {
    let (text, kind) = label(node, words);
    let width = width_of(&text).max(WIDTH);
    let number = parts.len();
    let y = 0.5 * HEIGHT + level as f32 * LEVEL;
    parts.push(Part { text, kind, at: pos2(0.0, y), width, above });
    let begin = *left;
    let below: Vec<f32> = node
        .operands()
        .iter()
        .map(|operand| place(operand, words, (level + 1, Some(number)), width_of, left, parts))
        .collect();
    let x = match (below.first(), below.last()) {
        // A part is as wide at least as what stands in it.
        (Some(first), Some(last)) => (0.5 * (first + last)).max(begin + 0.5 * width),
        (_, _) => begin + 0.5 * width,
    };
    *left = left.max(x + 0.5 * width + GAP);
    parts[number].at.x = x;
    x
}

/// The parts of a formula, each where it is drawn, and the size of all.
fn laid_out(root: &Node, words: &[&str], width_of: &dyn Fn(&str) -> f32) -> (Vec<Part>, Vec2) {
    let (mut parts, mut left) = (Vec::new(), 0.0);
    place(root, words, (0, None), width_of, &mut left, &mut parts);
    let bottom = parts.iter().map(|part| part.at.y).fold(0.0, f32::max);
    (parts, vec2(left - GAP, bottom + 0.5 * HEIGHT))
}

/// Draws the tree, scrolled where it is too wide.
pub fn show(ui: &mut Ui, root: &Node, words: &[&str]) {
    let palette = Palette::at(ui);
    ui.label(RichText::new(tr("As a tree")).strong());
    let font = theme::note(ui.ctx());
    let painter = ui.painter().clone();
    let width_of = |text: &str| {
        let galley = painter.layout_no_wrap(text.to_owned(), font.clone(), Color32::PLACEHOLDER);
        galley.size().x + 12.0
    };
    let (parts, size) = laid_out(root, words, &width_of);
    scaffold::across(ui, "tree", |ui| {
        let (rect, response) = ui.allocate_exact_size(size + vec2(2.0, 4.0), Sense::hover());
        paint(ui, &parts, rect.min + vec2(1.0, 1.0), &font, palette);
        let count = parts.len();
        response.widget_info(|| {
            let label = tr!("Tree of the formula, {n} parts", n = count);
            WidgetInfo::labeled(Role::Figure, true, label)
        });
    });
}

fn paint(ui: &Ui, parts: &[Part], origin: Pos2, font: &FontId, palette: &Palette) {
    let painter = ui.painter();
    let at = |part: &Part| origin + part.at.to_vec2();
    for part in parts {
        if let Some(above) = part.above.and_then(|above| parts.get(above)) {
            painter.line_segment([at(above), at(part)], Stroke::new(1.2, palette.weak));
        }
    }
    for part in parts {
        let rect = Rect::from_center_size(at(part), vec2(part.width, HEIGHT));
        let (color, radius) = match part.kind {
            PartKind::Operation => (palette.text, 12),
            PartKind::Input => (palette.produced, 4),
            PartKind::Number => (palette.weak, 4),
        };
        let (fill, stroke) = (ui.visuals().panel_fill, Stroke::new(1.2, color));
        painter.rect(rect, CornerRadius::same(radius), fill, stroke, StrokeKind::Inside);
        let ink = if part.kind == PartKind::Input { palette.produced } else { palette.text };
        painter.text(rect.center(), Align2::CENTER_CENTER, &part.text, font.clone(), ink);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::formula::Formula;

    #[test]
    fn no_two_parts_of_a_tree_touch_each_other() {
        for text in [
            "1",
            "a",
            "exp(a)",
            "a - b / a",
            "ln(0.039*a)/a + exp(b*3)^(a - 2*b) - sqrt(a*a*a*b)",
            "-(a + b)",
        ] {
            let formula = Formula::parse(text, &["a", "b"]).unwrap();
            let names = ["a very long name", "b_{x}"];
            let width_of = |text: &str| 7.0 * text.chars().count() as f32 + 12.0;
            let (parts, size) = laid_out(formula.root(), &names, &width_of);
            assert_eq!(parts.len(), formula.size());
            let rect = |part: &Part| Rect::from_center_size(part.at, vec2(part.width, HEIGHT));
            for (number, part) in parts.iter().enumerate() {
                let room = Rect::from_min_size(Pos2::ZERO, size).expand(0.01);
                assert!(room.contains_rect(rect(part)), "{text}: {part:?} in {size:?}");
                for other in &parts[..number] {
                    assert!(!rect(part).intersects(rect(other)), "{text}: {part:?} {other:?}");
                }
                assert_eq!(part.above.is_none(), number == 0);
                assert!(part.above.is_none_or(|above| parts[above].at.y < part.at.y));
            }
        }
    }
}

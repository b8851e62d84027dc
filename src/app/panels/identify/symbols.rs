//! How formulas are written on the screen: names of columns as symbols with an index, numbers with as many digits as
//! can be read.

use crate::app::format;
use crate::base::equation::number;
use crate::base::formula::{Formula, Node};
use crate::base::language::{decimal, decimal_sign, text, tr};
use crate::study::identify::gp::units::without_unit;

/// A letter, word or index without the signs that mark what is raised or lowered.
fn plain(text: &str) -> String {
    let sign = |c: char| if "_^{}".contains(c) { ' ' } else { c };
    text.chars().map(sign).collect::<String>().trim().to_owned()
}

fn symbol(column: &str) -> String {
    let bare = without_unit(column);
    let (base, index) = bare.split_once('_').unwrap_or((bare, ""));
    match (plain(base), plain(index)) {
        (base, index) if base.is_empty() => index,
        (base, index) if index.is_empty() => base,
        (base, index) => format!("{base}_{{{index}}}"),
    }
}

/// The symbols of some columns: `force_final_n` is force with the index final, and no two are the same.
pub fn symbols(columns: &[&str]) -> Vec<String> {
    let short: Vec<String> = columns.iter().map(|column| symbol(column)).collect();
    let alone = |(place, text): (usize, &String)| {
        let same = short.iter().filter(|other| *other == text).count();
        if same > 1 || text.is_empty() { plain(columns[place]) } else { text.clone() }
    };
    short.iter().enumerate().map(alone).collect()
}

/// The formula with numbers of so many digits, to be shown and for nothing else.
pub fn rounded(formula: &Formula, digits: usize) -> Formula {
    fn of(node: &Node, digits: usize) -> Node {
        match node {
            Node::Number(x) => {
                let short = format!("{x:.*e}", digits.saturating_sub(1));
                Node::Number(short.parse().unwrap_or(*x))
            }
            Node::Input(_) | Node::Constant(_) => node.clone(),
            Node::Unary(function, operand) => Node::unary(*function, of(operand, digits)),
            Node::Binary(operator, pair) => {
                Node::binary(*operator, of(&pair[0], digits), of(&pair[1], digits))
            }
        }
    }
    Formula::new(of(formula.root(), digits), formula.inputs()).unwrap_or_else(|_| formula.clone())
}

/// What columns of the papers' tables and of this program's hold, by their names without a unit.
const HELD: &[(&str, &str)] = &[
    ("sim", text!("Simulation")),
    ("ra", text!("Ra")),
    ("ra_desired", text!("Desired Ra")),
    ("ra_produced", text!("Ra produced")),
    ("f_desired", text!("Desired force")),
    ("force", text!("Force")),
    ("force_initial", text!("Force, start")),
    ("force_final", text!("Force, end")),
    ("feed", text!("Feed")),
    ("feed_initial", text!("Feed, start")),
    ("feed_final", text!("Feed, end")),
    ("spindle", text!("Speed")),
    ("spindle_initial", text!("Speed, start")),
    ("spindle_final", text!("Speed, end")),
    ("axial_depth", text!("Axial depth")),
    ("radial_depth", text!("Radial depth")),
];

/// A column in words where it is known what it holds; the name that its table has otherwise.
pub fn column_words(column: &str) -> &str {
    let bare = without_unit(column);
    HELD.iter().find(|(name, _)| *name == bare).map_or(column, |(_, words)| tr(words))
}

/// An equation to be read: its numbers with the decimal sign of the language.
pub fn in_language(equation: &str) -> String {
    let sign = decimal_sign();
    let letters: Vec<char> = equation.chars().collect();
    let is_digit = |place: usize| letters.get(place).is_some_and(char::is_ascii_digit);
    let within = |place: usize| place > 0 && is_digit(place - 1) && is_digit(place + 1);
    let written = |(place, c): (usize, &char)| if *c == '.' && within(place) { sign } else { *c };
    letters.iter().enumerate().map(written).collect()
}

/// A number in words, with the digits that count.
pub fn told_number(x: f64) -> String {
    format::signed(decimal(number(x)))
}

/// A name that is cut where it is longer than `most` characters.
pub fn short(name: &str, most: usize) -> String {
    if name.chars().count() <= most {
        return name.to_owned();
    }
    let begin: String = name.chars().take(most.saturating_sub(1)).collect();
    format!("{begin}\u{2026}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_shown_with_so_many_digits() {
        let formula = Formula::parse("-1.23456*a + 1234567/a^2 - 2e-7", &["a"]).unwrap();
        assert_eq!(rounded(&formula, 4).to_string(), "-1.235 * a + 1235000 / a^2 - 2e-7");
    }

    #[test]
    fn columns_and_numbers_are_told_in_the_language() {
        use crate::base::language::{Language, choose};
        assert_eq!(column_words("force_final_n"), "Force, end");
        assert_eq!(column_words("my_column_mm"), "my_column_mm");
        assert_eq!(in_language("y = 1.25 \u{b7} x^0.5 + f.a"), "y = 1.25 \u{b7} x^0.5 + f.a");
        choose(Language::German);
        assert_eq!(column_words("force_final_n"), "Kraft, Ende");
        assert_eq!(in_language("y = 1.25 \u{b7} x^0.5 + f.a"), "y = 1,25 \u{b7} x^0,5 + f.a");
        choose(Language::English);
    }

    #[test]
    fn columns_become_symbols_and_stay_apart() {
        let columns = ["force_final_n", "f", "speed_rpm", "feed_mm_min", "feed_mm", "a^b_{c}"];
        let shown = symbols(&columns);
        assert_eq!(shown, ["force_{final}", "f", "speed", "feed mm min", "feed mm", "a b_{c}"]);
        assert_eq!(short("spindle", 7), "spindle");
        assert_eq!(short("spindle_speed", 7), "spindl\u{2026}");
    }
}

//! How formulas are written on the screen: names of columns as symbols with an index, numbers with as many digits as
//! can be read.

use crate::base::formula::{Formula, Node};
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
    fn columns_become_symbols_and_stay_apart() {
        let columns = ["force_final_n", "f", "speed_rpm", "feed_mm_min", "feed_mm", "a^b_{c}"];
        let shown = symbols(&columns);
        assert_eq!(shown, ["force_{final}", "f", "speed", "feed mm min", "feed mm", "a b_{c}"]);
        assert_eq!(short("spindle", 7), "spindle");
        assert_eq!(short("spindle_speed", 7), "spindl\u{2026}");
    }
}

//! The diagram as text: the figure of this crate's documentation and of `steadycut list --diagram`.

use super::super::scenario::Scenario;
use super::{BLOCKS, Block, Wire};

/// A line per box in signal order: what enters it, its name, what leaves it. Where a symbol leaves one
/// box and enters another, a wire joins them.
#[must_use]
pub fn figure(scenario: &Scenario) -> String {
    let symbols = |wires: &mut dyn Iterator<Item = Wire>| {
        wires.map(Wire::plain_symbol).collect::<Vec<String>>().join(", ")
    };
    let lines: Vec<[String; 3]> = BLOCKS
        .iter()
        .map(|info| {
            let block: Block = info.block;
            let [from, to] = [symbols(&mut block.inputs()), symbols(&mut block.outputs())];
            [from, info.title(scenario), to]
        })
        .collect();
    let width = |column: usize| {
        lines.iter().map(|line| line[column].chars().count()).max().unwrap_or_default()
    };
    let (from_width, title_width) = (width(0), width(1));
    lines
        .iter()
        .map(|[from, title, to]| format!("{from:>from_width$} ─▶ {title:<title_width$} ─▶ {to}\n"))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_documentation_shows_this_figure() {
        let figure = figure(&Scenario::default());
        let documented = include_str!("../../lib.md");
        assert!(documented.contains(&figure), "lib.md is to show:\n{figure}");
    }
}

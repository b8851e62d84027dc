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

    /// The figure at the head of the loop is drawn by hand: every box with its models and every wire stands in
    /// it, and nothing else.
    #[test]
    fn the_figure_of_the_loop_has_every_box_wire_and_model_and_no_other() {
        let source = include_str!("../closed_loop/mod.rs");
        let mut rest = source.split("//! ```").nth(1).expect("the figure").to_owned();
        rest = rest.replace("//!", "").replace("text\n", "");
        let mut names: Vec<String> = BLOCKS.iter().map(|info| info.name.to_lowercase()).collect();
        let models = BLOCKS.iter().flat_map(|info| info.models);
        names.extend(models.map(|model| format!("K{model}")));
        names.extend(super::super::WIRES.map(|wire| wire.plain_symbol().replace(" delayed", "")));
        // The longer name first, since it may hold a shorter one.
        names.sort_by_key(|name| std::cmp::Reverse(name.len()));
        let mut gone = Vec::new();
        for name in &names {
            let once = gone.contains(name);
            assert!(once || rest.contains(name), "{name} is not in the figure");
            rest = rest.replace(name, "");
            gone.push(name.clone());
        }
        for beside in ["delayed", "queue"] {
            rest = rest.replace(beside, "");
        }
        let left: String = rest.chars().filter(|c| c.is_alphanumeric()).collect();
        assert_eq!(left, "", "no box, wire or model");
    }
}

//! `steadycut list --diagram`: the block diagram of the loop, as data.

use std::io::Write;
use std::process::ExitCode;

use serde_json::{Value, json};

use super::Outcome;
use crate::run::diagram::text::figure;
use crate::run::diagram::{BLOCKS, BlockInfo, WIRES, Wire};
use crate::run::scenario::Scenario;
use crate::run::signals::signal;

/// Prints the diagram of the default scenario: its controller, model sets and drive.
pub fn print(as_json: bool) -> Outcome {
    let scenario = Scenario::default();
    let mut out = std::io::stdout().lock();
    if as_json {
        let object = json!({
            "blocks": BLOCKS.iter().map(|info| block_json(info, &scenario)).collect::<Vec<_>>(),
            "wires": WIRES.map(wire_json),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(out, "{}", figure(&scenario))?;
    for info in BLOCKS {
        writeln!(out, "{}: {}", info.id, info.title(&scenario))?;
        writeln!(out, "  {}", info.meaning)?;
        for printed in info.block.printed(&scenario) {
            writeln!(out, "  {}\n      {}", printed.formula, printed.source)?;
        }
        let of = |word: &str, names: Vec<String>| match names.as_slice() {
            [] => String::new(),
            names => format!("  {word}: {}\n", names.join("; ")),
        };
        let on = |wires: &mut dyn Iterator<Item = Wire>| wires.map(|wire| wire.name()).collect();
        let labels = |ids: &[&str]| {
            let known = ids.iter().filter_map(|id| signal(id));
            known.map(|info| info.label.to_owned()).collect()
        };
        let settings = info.settings.iter().map(|path| (*path).to_owned()).collect();
        let lines = [
            of("in", on(&mut info.block.inputs())),
            of("own", labels(info.own)),
            of("with the coupled machine", labels(info.of_machine)),
            of("out", on(&mut info.block.outputs())),
            of("settings shown", settings),
        ];
        writeln!(out, "{}", lines.concat())?;
    }
    Ok(ExitCode::SUCCESS)
}

fn block_json(info: &BlockInfo, scenario: &Scenario) -> Value {
    let printed = info.block.printed(scenario);
    let printed: Vec<Value> = printed
        .iter()
        .map(|equation| json!({"formula": equation.formula, "source": equation.source}))
        .collect();
    json!({
        "id": info.id,
        "title": info.title(scenario),
        "meaning": info.meaning,
        "inputs": info.block.inputs().map(wire_json).collect::<Vec<_>>(),
        "outputs": info.block.outputs().map(wire_json).collect::<Vec<_>>(),
        "own_signals": info.own,
        "machine_signals": info.of_machine,
        "printed": printed,
        "settings": info.settings,
    })
}

fn wire_json(wire: Wire) -> Value {
    let info = wire.info();
    json!({
        "signal": wire.signal,
        "symbol": wire.symbol,
        "name": wire.name(),
        "unit": info.unit,
        "delayed": wire.delayed,
        "from": wire.from.map(|block| block.info().id),
        "to": wire.to.iter().map(|block| block.info().id).collect::<Vec<_>>(),
    })
}

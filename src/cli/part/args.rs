//! The arguments of `steadycut part`.

use clap::{Args, Subcommand};

use crate::cli::args::one_of;
use crate::cli::files::{InPath, OutPath, ScenarioPath};
use crate::models::tool::ShippedTool;
use crate::study::part::blank::Blank;

/// Arguments of `part`.
#[derive(Debug, Args)]
pub struct PartArgs {
    /// What to do.
    #[command(subcommand)]
    pub what: PartWhat,
}

/// What `part` does.
#[derive(Debug, Subcommand)]
pub enum PartWhat {
    /// Cut a program (G-code) from a rectangular blank, and tell at each step how deep and how wide the tool is in it.
    FromGcode(PartFromGcodeArgs),
    /// Read a table of depths along a path, and put it into a scenario.
    FromCsv(PartFromCsvArgs),
    /// Write the part of a scenario as a table of depths along its path.
    ToCsv(PartToCsvArgs),
}

/// The scenario that a part goes into.
#[derive(Debug, Args)]
pub struct IntoScenarioArgs {
    /// The scenario that the part goes into: its cutter, feed and controller. A preset's name, a scenario file, or a link
    /// of the console.
    #[arg(long, value_name = "PRESET|FILE|LINK", default_value = "first-cut")]
    pub scenario: ScenarioPath,
    /// Change a setting, for example `--set tool.diameter_mm=10`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Write the scenario with this part, which every command takes.
    #[arg(long, value_name = "FILE.toml")]
    pub save: Option<OutPath>,
}

/// Arguments of `part from-gcode`.
#[derive(Debug, Args)]
pub struct PartFromGcodeArgs {
    /// The program: G0, G1, G2, G3, F, S, G17, G20, G21, G90, G91; what else stands in it is told, and what would change
    /// where the tool goes is refused.
    #[arg(value_name = "FILE")]
    pub file: InPath,
    /// The blank in mm: its size along X, Y and Z, and its corner with the least x, y and z. Without a corner it lies at
    /// x = y = 0 with its top at z = 0.
    #[arg(long, value_name = "X,Y,Z[,x0,y0,z0]", value_parser = blank, allow_hyphen_values = true)]
    pub blank: Blank,
    /// A shipped cutter in place of the scenario's; `--set tool.shape=square` and others change it.
    #[arg(long, value_name = "TOOL", value_parser = one_of(ShippedTool::ALL, ShippedTool::id))]
    pub tool: Option<ShippedTool>,
    /// Step along the way in mm, 0.05 to 10; the grid over the blank is a quarter of it.
    #[arg(long, value_name = "MM", default_value_t = 0.5)]
    pub step: f64,
    /// What it goes into.
    #[command(flatten)]
    pub into: IntoScenarioArgs,
    /// Write the path as CSV: s, x, y, z, a_p, a_e, feed, speed, air, the volume that is removed, the line.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `part from-csv`.
#[derive(Debug, Args)]
pub struct PartFromCsvArgs {
    /// The table: a column s, or x and y, a_p and a_e; units stand in the names, as in `a_p [mm]`; without one it is mm.
    #[arg(value_name = "FILE.csv")]
    pub file: InPath,
    /// What it goes into.
    #[command(flatten)]
    pub into: IntoScenarioArgs,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `part to-csv`.
#[derive(Debug, Args)]
pub struct PartToCsvArgs {
    /// A preset's name, a scenario file, or a link of the console.
    #[arg(value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// Write it to a file; without it, to standard output.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<OutPath>,
}

fn blank(text: &str) -> Result<Blank, String> {
    let numbers: Option<Vec<f64>> =
        text.split(',').map(|part| part.trim().parse::<f64>().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, z]) => Blank::new([x, y, z], None),
        Some(&[x, y, z, x0, y0, z0]) => Blank::new([x, y, z], Some([x0, y0, z0])),
        _ => Err("allowed are three or six numbers in mm: X,Y,Z or X,Y,Z,x0,y0,z0".to_owned()),
    }
}

//! The arguments of `steadycut machine`.

use clap::{Args, Subcommand};

use crate::cli::args::one_of;
use crate::cli::files::{InPath, OutPath};
use crate::cli::own::{OwnCutArgs, OwnStructureArgs};
use crate::models::structure::parameters::Parameters;

/// Arguments of `machine`.
#[derive(Debug, Args)]
pub struct MachineArgs {
    /// What to compute.
    #[command(subcommand)]
    pub what: MachineWhat,
}

/// What `machine` computes.
#[derive(Debug, Subcommand)]
pub enum MachineWhat {
    /// Natural frequencies, damping and shapes.
    Modes(MachineModel),
    /// Frequency response from 0 to 3000 Hz in steps of 10 Hz.
    Frf(MachineModel),
    /// Depth at which the cut chatters over the speed: lobes, interrupted cut, time simulation.
    Stability(StabilityArgs),
    /// The tool's life second by second: trends of sound and roughness, and how alike they are.
    Wear(MachineModel),
    /// Tool life predicted from the sound: many tools, and a speed adjusted to the desired tool life.
    Life(LifeArgs),
    /// Random fraction of the contact force, calibrated on Table 3 of 2007, with its residuals.
    Roughness(MachineModel),
}

/// Arguments of `machine stability`.
#[derive(Debug, Args)]
pub struct StabilityArgs {
    /// Machine and output.
    #[command(flatten)]
    pub model: MachineModel,
    /// Lowest speed, 1/min.
    #[arg(long, default_value_t = 800.0, value_parser = chart_speed)]
    pub from: f64,
    /// Highest speed, 1/min.
    #[arg(long, default_value_t = 4000.0, value_parser = chart_speed)]
    pub to: f64,
    /// Number of speeds.
    #[arg(long, default_value_t = 65, value_parser = clap::value_parser!(u32).range(1..=2000))]
    pub speeds: u32,
    /// Ask the time simulation too; exit with 1 unless it agrees within 5 % at every speed with a
    /// limit, and at 40 speeds or more.
    #[arg(long)]
    pub check: bool,
}

fn chart_speed(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|x| (300.0..=20_000.0).contains(x));
    number.ok_or_else(|| "allowed is a number from 300 to 20000".to_owned())
}

/// The machine and where its results go.
#[derive(Debug, Args)]
pub struct MachineModel {
    /// Parameters: D by the table's rules, T its digits with two exponents corrected, or printed.
    #[arg(long, value_parser = one_of(Parameters::ALL, Parameters::id))]
    pub parameters: Option<Parameters>,
    /// Change a setting, for example `--set machine.variant=B`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Refused, with the reason: the machine is asked about one cut.
    #[arg(long, value_name = "FILE.csv", hide = true)]
    pub part: Option<InPath>,
    /// Cutter and material of one's own.
    #[command(flatten)]
    pub own_cut: OwnCutArgs,
    /// Structure of one's own.
    #[command(flatten)]
    pub own_structure: OwnStructureArgs,
    /// Write the result into a file.
    #[arg(long, value_name = "FILE")]
    pub out: Option<OutPath>,
    /// Print JSON.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `machine life`.
#[derive(Debug, Args)]
pub struct LifeArgs {
    /// Number of tools.
    #[arg(long, default_value_t = 200, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub tools: u32,
    /// The machine, the cut and where the results go.
    #[command(flatten)]
    pub model: MachineModel,
}

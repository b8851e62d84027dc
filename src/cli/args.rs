//! The arguments, in one place.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::base::model::gp::Calibration;
use crate::base::model::machine::parameters::Parameters;
use crate::base::network::Activation;
use crate::blocks::cutting::process::ForceModel;
use crate::study::published::PaperId;
use crate::study::train::recipe::RecipeKind;

/// SteadyCut: milling that keeps its surface finish constant.
#[derive(Debug, Parser)]
#[command(
    version,
    about,
    args_conflicts_with_subcommands = true,
    after_help = "Without a command: opens the console."
)]
pub struct Cli {
    /// Scenario that the console opens: a preset's name or a scenario file.
    #[arg(long, value_name = "PRESET|FILE")]
    pub scenario: Option<String>,
    /// What to do; without it the console opens.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// A subcommand.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a scenario and print its metrics.
    Run(RunArgs),
    /// Re-run a paper's published table and compare.
    Papers(PapersArgs),
    /// Identify the default models from the published tables.
    Identify(IdentifyArgs),
    /// Train the neural force model; repeat the paper's comparison of 40 networks.
    Train(TrainArgs),
    /// Print static peak forces of the mechanistic force model beside published values.
    Force(ForceArgs),
    /// List presets, controllers, models, drives, materials and all settings.
    List(ListArgs),
    /// Plan a cut: the best feed and speed within seven constraints, by particle swarm.
    Plan(PlanArgs),
    /// Check scenario files.
    Check(CheckArgs),
    /// The five-mass machine of 2019: modes, frequency response, stability.
    Machine(MachineArgs),
}

/// Arguments of `run`.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// A preset's name or a scenario file.
    #[arg(value_name = "PRESET|FILE")]
    pub scenario: String,
    /// Change a setting, for example `--set target.ra_um=0.6`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Write all signals as CSV, one column each with its unit in the header.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// A paper whose table can be re-run.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Paper {
    /// SDNRP 2007, Table 3.
    #[value(name = "2007")]
    Sdnrp2007,
    /// Control strategy 2013, Table 1.
    #[value(name = "2013")]
    Strategy2013,
}

impl From<Paper> for PaperId {
    fn from(arg: Paper) -> Self {
        match arg {
            Paper::Sdnrp2007 => Self::Sdnrp2007,
            Paper::Strategy2013 => Self::Strategy2013,
        }
    }
}

/// Calibration as an argument.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum CalibrationArg {
    /// The equations exactly as printed.
    Printed,
    /// The fewest coefficients corrected.
    Restored,
    /// Re-identified from the published table.
    Identified,
}

impl From<CalibrationArg> for Calibration {
    fn from(arg: CalibrationArg) -> Self {
        match arg {
            CalibrationArg::Printed => Self::Printed,
            CalibrationArg::Restored => Self::Restored,
            CalibrationArg::Identified => Self::Identified,
        }
    }
}

fn force_model(text: &str) -> Result<ForceModel, String> {
    let map = ForceModel::MAPS.into_iter().find(|map| map.id() == text);
    map.ok_or_else(|| format!("allowed is {}", ForceModel::MAPS.map(ForceModel::id).join(", ")))
}

/// A paper whose table can be compared with runs.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum ComparedPaper {
    /// Combined system 2005, Table 1: six methods on Experiment 2.
    #[value(name = "2005")]
    Combined2005,
    /// SDNRP 2007, Table 3.
    #[value(name = "2007")]
    Sdnrp2007,
    /// Control strategy 2013, Table 1.
    #[value(name = "2013")]
    Strategy2013,
    /// Dynamic model 2019, Table 1: the five-mass machine.
    #[value(name = "2019")]
    Machine2019,
}

/// Arguments of `papers`.
#[derive(Debug, Args)]
pub struct PapersArgs {
    /// The paper.
    #[arg(long, value_enum)]
    pub paper: ComparedPaper,
    /// Number of noise seeds (2005 only), the same for every method.
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub seeds: u32,
    /// Calibration of plant and controller.
    #[arg(long, value_enum, default_value = "identified")]
    pub calibration: CalibrationArg,
    /// What gives the plant's cutting force.
    #[arg(long, value_parser = force_model, default_value = ForceModel::Formula.id())]
    pub plant: ForceModel,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// What can be identified.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum IdentifyTarget {
    /// The models of a paper from its published table.
    Tables,
}

/// Arguments of `identify`.
#[derive(Debug, Args)]
pub struct IdentifyArgs {
    /// What to identify.
    #[arg(value_enum)]
    pub target: IdentifyTarget,
    /// The paper whose models are identified.
    #[arg(long, value_enum, default_value = "2007")]
    pub paper: Paper,
    /// Another table in the same format (CSV) in place of the shipped one.
    #[arg(long, value_name = "FILE.csv")]
    pub table: Option<PathBuf>,
    /// Where to write the model file; without it, it is compared with the shipped one.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<PathBuf>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `train`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, arg_required_else_help = true)]
pub struct TrainArgs {
    /// Train 40 networks and compare activations, rates, momenta and hidden sizes with the paper's
    /// findings.
    #[arg(long)]
    pub study: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
    /// What to train.
    #[command(subcommand)]
    pub what: Option<TrainWhat>,
}

/// What can be trained.
#[derive(Debug, Subcommand)]
pub enum TrainWhat {
    /// The neural cutting-force model.
    Force(TrainForceArgs),
    /// The three networks of the neural control scheme UNKS.
    Unks(TrainUnksArgs),
}

/// Arguments of `train unks`.
#[derive(Debug, Args)]
pub struct TrainUnksArgs {
    /// Folder to write the three network files into.
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<PathBuf>,
    /// Exit with 1 unless every shipped file is reproduced bit for bit.
    #[arg(long, conflicts_with = "out")]
    pub check: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `train force`: a recipe, and what differs from it.
#[derive(Debug, Args)]
pub struct TrainForceArgs {
    /// Recipe: `improved` and `literal` make the shipped networks, `2005` the four-layer one.
    #[arg(long, default_value = "improved", value_parser = recipe_kind)]
    pub recipe: RecipeKind,
    /// Rows to generate; four fifths are trained on, the others held out.
    #[arg(long, value_parser = clap::value_parser!(u32).range(100..=20_000))]
    pub rows: Option<u32>,
    /// Seed of data, first weights and order.
    #[arg(long)]
    pub seed: Option<u32>,
    /// Neurons of the hidden layers, for example `15` or `5,3,7`.
    #[arg(long, value_delimiter = ',', value_name = "N,...")]
    pub hidden: Option<Vec<usize>>,
    /// Activation: arctan, tanh, sine or sigmoid.
    #[arg(long, value_parser = activation)]
    pub activation: Option<Activation>,
    /// Take logarithms of feed, speed, depths, hardness and diameter.
    #[arg(long, overrides_with = "no_ln")]
    pub ln: bool,
    /// Take all inputs as they are.
    #[arg(long, overrides_with = "ln")]
    pub no_ln: bool,
    /// Learning rate of the first epoch, 0 to 1.
    #[arg(long, value_parser = ratio)]
    pub rate: Option<f64>,
    /// Momentum, 0 to 1.
    #[arg(long, value_parser = ratio)]
    pub momentum: Option<f64>,
    /// The rate of epoch e is rate / (1 + decay e); 0 to 1.
    #[arg(long, value_parser = ratio)]
    pub decay: Option<f64>,
    /// Epochs.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub epochs: Option<u32>,
    /// Where to write the network file.
    #[arg(long, value_name = "FILE.json")]
    pub out: Option<PathBuf>,
    /// Train both shipped networks; exit with 1 unless each file is reproduced bit for bit.
    #[arg(long, conflicts_with_all = ["recipe", "rows", "seed", "hidden", "activation", "ln", "no_ln",
        "rate", "momentum", "decay", "epochs", "out"])]
    pub check: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

fn ratio(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|x| (0.0..=1.0).contains(x));
    number.ok_or_else(|| "allowed is a number from 0 to 1".to_owned())
}

fn one_of<T: Copy>(all: &[T], id: impl Fn(T) -> &'static str, text: &str) -> Result<T, String> {
    let ids: Vec<&str> = all.iter().map(|option| id(*option)).collect();
    let found = all.iter().find(|option| id(**option) == text);
    found.copied().ok_or_else(|| format!("allowed is one of {}", ids.join(", ")))
}

fn recipe_kind(text: &str) -> Result<RecipeKind, String> {
    one_of(RecipeKind::ALL, RecipeKind::id, text)
}

fn activation(text: &str) -> Result<Activation, String> {
    one_of(Activation::ALL, Activation::id, text)
}

/// Arguments of `force`.
#[derive(Debug, Args)]
pub struct ForceArgs {
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `list`.
#[derive(Debug, Args)]
pub struct ListArgs {
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `plan`.
#[derive(Debug, Args)]
pub struct PlanArgs {
    /// A preset's name or a scenario file.
    #[arg(value_name = "PRESET|FILE")]
    pub scenario: String,
    /// Change a setting, for example `--set plan.free_speed=false`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Limits of another machine, in the format of the shipped file of the papers' machine, whose
    /// values are placeholders.
    #[arg(long, value_name = "FILE.toml")]
    pub machine: Option<PathBuf>,
    /// Write the scenario with the optimum as its programmed feed and speed.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<PathBuf>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArgs {
    /// Scenario files.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

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
    /// Tool life foretold from the sound: many tools, and a speed adjusted to the desired durability.
    Life(LifeArgs),
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
    #[arg(long, value_parser = parameters)]
    pub parameters: Option<Parameters>,
    /// Change a setting, for example `--set machine.reading=B`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Write the result into a file.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
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

fn parameters(text: &str) -> Result<Parameters, String> {
    one_of(Parameters::ALL, Parameters::id, text)
}

//! The arguments, in one place.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser, ValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};

use super::afc::args::AfcArgs;
use super::experiment::args::ExperimentArgs;
use super::files::{FormulaPath, InPath, OutFolder, OutPath, ScenarioPath};
use super::identify_drive::IdentifyDriveArgs;
use super::identify_force::IdentifyForceArgs;
use super::identify_material::IdentifyMaterialArgs;
use super::identify_noise::IdentifyNoiseArgs;
use super::identify_structure::IdentifyStructureArgs;
use super::identify_wear::IdentifyWearArgs;
use super::machine::args::MachineArgs;
use super::measured::args::MeasuredArgs;
use super::mission::args::MissionArgs;
use super::own::{OwnArgs, OwnCutArgs, OwnMachineArgs, OwnStructureArgs};
use super::part::args::PartArgs;
use crate::base::network::Activation;
use crate::blocks::control::ControllerKind;
use crate::blocks::cutting::process::ForceModel;
use crate::models::genetic::Calibration;
use crate::models::plan::PlannedSection;
use crate::models::tool::ShippedTool;
use crate::run::scenario::{TwinKind, table};
use crate::study::identify::gp::job::BATCHES;
use crate::study::profilometer::ProfileLine;
use crate::study::published::PaperId;
use crate::study::recommend::EngagementCode;
use crate::study::robust::MAX_RUNS;
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
    /// What the console opens: a preset's name, a scenario file, or a link, which may hold a mission.
    #[arg(long, value_name = "PRESET|FILE|LINK")]
    pub scenario: Option<PathBuf>,
    /// What of the console is hidden and locked, as behind `embed=` in a link: `hide:PART` with bar, screens, files,
    /// find, transport or settings; `lock:NAME` with a setting, a group or all; `screen:ID`; `lang:en`.
    #[arg(long, value_name = "FLAG,...", default_value = "", hide_default_value = true)]
    pub embed: String,
    /// What to do; without it the console opens.
    #[command(subcommand)]
    pub command: Option<CliCommand>,
}

/// A subcommand.
#[derive(Debug, Subcommand)]
pub enum CliCommand {
    /// Run a scenario and print its metrics.
    Run(RunArgs),
    /// Re-run a paper's published table and compare.
    Papers(PapersArgs),
    /// Identify the default models from the published tables and from the milling simulator.
    Identify(IdentifyArgs),
    /// Plan cuts, say what they tell before a chip is cut, make them on the simulator or read a shop's sheet.
    Experiment(ExperimentArgs),
    /// Evaluate a formula on a table, or print it in other languages with derivatives, units and certificate.
    Formula(FormulaArgs),
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
    /// Recommend cutting speed and feed per tooth from a cutting-data table (ANFIS).
    Recommend(RecommendArgs),
    /// Run the combined system of 2005: recommendation, plan and neural control in five steps.
    Combine(CombineArgs),
    /// Cut a part several times with UNKS, its networks learning from pass to pass.
    Unks(UnksArgs),
    /// Adaptive feed control: teach in the reference force of each cut, and the log of a run.
    Afc(AfcArgs),
    /// The five-mass machine of 2019: modes, frequency response, stability, wear, tool life.
    Machine(MachineArgs),
    /// Read measured data of any layout: what was guessed of it, its channels, and the same as plain CSV.
    Measured(MeasuredArgs),
    /// Missions: lessons that are checked; list them, begin one of your own, mark an answer.
    Mission(MissionArgs),
    /// A part of one's own: from G-code over a blank, or a table of depths along a path; into a scenario, and back.
    Part(PartArgs),
    /// Files of your own: begin one for a cutter, a structure, a material or a machine, and check it.
    Own(OwnArgs),
    /// Judge how robust a controller is: many runs with plant and belief drawn at random.
    Robust(RobustArgs),
    /// Print what makes a shell complete this program's commands, options and files.
    Completions(CompletionsArgs),
    /// Print the manual page, or write those of all commands.
    Man(ManArgs),
}

/// Arguments of `run`.
#[derive(Debug, Args)]
pub struct RunArgs {
    /// A preset's name, a scenario file, or a link of the console.
    #[arg(value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// Change a setting, for example `--set target.ra_um=0.6`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// A part of one's own: a table (CSV) with a column s, or x and y, and the depths a_p and a_e, as `steadycut part
    /// from-gcode` writes it too. A row's depths hold up to the next one, the last row ends the path.
    #[arg(long, value_name = "FILE.csv")]
    pub part: Option<InPath>,
    /// Cutter and material of one's own.
    #[command(flatten)]
    pub own_cut: OwnCutArgs,
    /// Drives of one's own.
    #[command(flatten)]
    pub own_machine: OwnMachineArgs,
    /// Structure of one's own.
    #[command(flatten)]
    pub own_structure: OwnStructureArgs,
    /// Networks that UNKS begins with: a file that `steadycut unks --save` or the console wrote.
    #[arg(long, value_name = "FILE.json")]
    pub networks: Option<InPath>,
    /// A formula of one's own for a model, as the file that `steadycut formula --save` writes; it sets the
    /// calibration of the controller to own formulas, and that of the plant for force and ra. ROLE: force_of_ra,
    /// feed, speed, force or ra, for models 1 to 5; material; or a curve of the wear, such as wear.curve, which
    /// asks for no calibration.
    #[arg(long, value_name = "ROLE=FILE", value_parser = role_of)]
    pub formula: Vec<(String, InPath)>,
    /// A controller of one's own, as a script in Rhai with a function `update(now)`; it controls the cut.
    #[arg(long, value_name = "FILE.rhai")]
    pub script: Option<InPath>,
    /// Write all signals as CSV, one column each with its unit in the header.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
    /// Tell what happens in the run, when and why, with what each step makes of it; the same cut at
    /// constant feed is run beside it, the one that `--twin` or the scenario's `twin.kind` says. With
    /// `--json` as `story`.
    #[arg(long, conflicts_with_all = ["revolution", "profile"])]
    pub story: bool,
    /// Compare with the same cut at constant feed: safe, the largest feed that is nowhere rougher than
    /// allowed, which is found by cutting the part at many feeds; or as programmed. With `--json` as `twin`.
    #[arg(long, value_name = "safe|programmed", value_parser = twin_kind,
        conflicts_with_all = ["revolution", "profile"])]
    pub twin: Option<TwinKind>,
    /// Print the forces within the last revolution before a time in s as CSV, a line for every plant
    /// step; tooth by tooth only.
    #[arg(long, value_name = "AT_S", conflicts_with_all = ["json", "out"])]
    pub revolution: Option<f64>,
    /// Measure the machined surface at the end of the run along a line, with the cut-offs of
    /// `profile`: Ra, Rq, Rz. x along the cut from the part's edge, y across it from the tool's axis,
    /// in mm.
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = line, allow_hyphen_values = true,
        conflicts_with_all = ["out", "revolution"])]
    pub profile: Option<ProfileLine>,
    /// Which cut of the part `--profile` measures, counted from 1; without it the last one reached.
    #[arg(long, value_name = "NUMBER", requires = "profile")]
    pub cut: Option<usize>,
}

fn twin_kind(text: &str) -> Result<TwinKind, String> {
    let ids = TwinKind::ALL.iter().map(|kind| kind.id()).collect::<Vec<_>>().join(" or ");
    TwinKind::from_id(text).ok_or_else(|| format!("allowed is {ids}"))
}

/// What a formula of one's own may stand for: the settings that take one, without the `formula.` of the models'.
fn formula_roles() -> impl Iterator<Item = &'static str> {
    let taking = table().iter().filter(|param| param.spec.allowed.takes_formula());
    taking.map(|param| param.path.strip_prefix("formula.").unwrap_or(&param.path))
}

fn role_of(text: &str) -> Result<(String, InPath), String> {
    let roles: Vec<&str> = formula_roles().collect();
    match text.split_once('=') {
        Some((role, file)) if roles.contains(&role) && !file.is_empty() => {
            Ok((role.to_owned(), InPath::new(file)))
        }
        Some(_) | None => Err(format!("allowed is ROLE=FILE with a ROLE of {}", roles.join(", "))),
    }
}

fn line(text: &str) -> Result<ProfileLine, String> {
    let numbers: Option<Vec<f64>> =
        text.split(',').map(|part| part.trim().parse::<f64>().ok()).collect();
    match numbers.as_deref() {
        Some(&[x0, y0, x1, y1]) => Ok(ProfileLine { from_mm: [x0, y0], to_mm: [x1, y1] }),
        _ => Err("allowed are four numbers in mm: X0,Y0,X1,Y1".to_owned()),
    }
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
    /// Found in the published table by genetic programming.
    Genetic,
}

impl From<CalibrationArg> for Calibration {
    fn from(arg: CalibrationArg) -> Self {
        match arg {
            CalibrationArg::Printed => Self::Printed,
            CalibrationArg::Restored => Self::Restored,
            CalibrationArg::Identified => Self::Identified,
            CalibrationArg::Genetic => Self::Genetic,
        }
    }
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
    /// Number of noise seeds (2005 only), the same for every method: 20, and 5 with --robustness.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub seeds: Option<u32>,
    /// Other dead times and another steel without retuning, in place of Table 1 (2005 only).
    #[arg(long)]
    pub robustness: bool,
    /// Feeds per cut and the controller Preview, in place of Table 1 (2005 only).
    #[arg(long, conflicts_with = "robustness")]
    pub beyond: bool,
    /// Calibration of plant and controller.
    #[arg(long, value_enum, default_value = "identified")]
    pub calibration: CalibrationArg,
    /// What gives the plant's cutting force.
    #[arg(long, value_parser = one_of(ForceModel::maps(), ForceModel::id), default_value = ForceModel::Formula.id())]
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
    /// The models of the 2005 milling simulator from static peaks of its force model.
    Milling,
    /// Formulas of a paper's models from its published table, by genetic programming (the calibration
    /// `genetic`).
    Genetic,
}

/// What else can be identified.
#[derive(Debug, Subcommand)]
pub enum IdentifyWhat {
    /// A formula of a table's columns, searched for by genetic programming (symbolic regression).
    Gp(IdentifyGpArgs),
    /// A feed drive's dead time, order and lag from a step that was recorded: several structures compared.
    Drive(IdentifyDriveArgs),
    /// Force coefficients, run-out and angle of a cutter from the forces of a steady cut, tooth by tooth.
    Force(Box<IdentifyForceArgs>),
    /// Taylor's constants from readings of the wear land: life over speed, feed and depth.
    Wear(Box<IdentifyWearArgs>),
    /// Sizes of noise and ripple in the force of a steady cut: sensor, band, inhomogeneity, tooth passing.
    Noise(Box<IdentifyNoiseArgs>),
    /// The force of the material that was cut over that of Ck45, and its hardness.
    Material(Box<IdentifyMaterialArgs>),
    /// The structure at the tool's tip from a measured frequency response: modes, with what is left.
    Structure(IdentifyStructureArgs),
}

/// Whether formulas have to be right in their units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum UnitsArg {
    /// Units are not looked at.
    #[default]
    Free,
    /// Only formulas that are right in their units; constants may have units.
    Strict,
}

/// Arguments of `identify gp`.
#[derive(Debug, Args)]
pub struct IdentifyGpArgs {
    /// The table: CSV with a line of column names.
    #[arg(long, value_name = "FILE.csv")]
    pub data: InPath,
    /// The column that the formula is to give.
    #[arg(long, value_name = "COLUMN")]
    pub target: String,
    /// The columns that it may read.
    #[arg(long, value_name = "A,B,...", value_delimiter = ',', required = true)]
    pub inputs: Vec<String>,
    /// Search as in the paper, too: its functions, constants, population and probabilities, beside the
    /// default search. The report says which of the two found the formula.
    #[arg(long, value_enum)]
    pub paper: Option<Paper>,
    /// What is known of the formula, for example `a + b*n^3 + T(f)`: names that are no columns are constants
    /// to fit, T(...) stands for what is searched for. Without T only the constants are fitted.
    #[arg(long, value_name = "FORMULA")]
    pub template: Option<String>,
    /// Whether formulas have to be right in their units.
    #[arg(long, value_enum, default_value = "free")]
    pub units: UnitsArg,
    /// Unit of a column, for example `feed=mm/min`; without it the one that its name ends with
    /// (`feed_mm_min`). An input with a unit is as positive as its rows; one without may be negative.
    #[arg(long = "unit", value_name = "COLUMN=UNIT")]
    pub unit: Vec<String>,
    /// Seed of all draws.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Most batches of the search; it ends earlier where nothing is gained any more.
    #[arg(long, default_value_t = BATCHES, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub batches: u64,
    /// Go on with a search that `--state` saved: the same data, columns and seed.
    #[arg(long, value_name = "FILE.json")]
    pub resume: Option<InPath>,
    /// Where to save the search when it is over or interrupted, to go on with later.
    #[arg(long, value_name = "FILE.json")]
    pub state: Option<OutPath>,
    /// Where to write the model file of the formula.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Write the formula of this size of the front in place of the one chosen.
    #[arg(long, value_name = "NODES", requires = "out")]
    pub size: Option<usize>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `identify`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct IdentifyArgs {
    /// What else to identify.
    #[command(subcommand)]
    pub what: Option<IdentifyWhat>,
    /// What to identify.
    #[arg(value_enum, required = true)]
    pub target: Option<IdentifyTarget>,
    /// The paper whose models are identified; for `tables` and `genetic`.
    #[arg(long, value_enum, default_value = "2007")]
    pub paper: Paper,
    /// Another table in the same format (CSV) in place of the shipped one; for `tables` and
    /// `genetic`.
    #[arg(long, value_name = "FILE.csv")]
    pub table: Option<InPath>,
    /// The cutter of the simulator; for `milling`. The shipped models are those of the papers' cutter.
    #[arg(long, value_name = "TOOL", default_value = ShippedTool::ALL[0].id(), value_parser = one_of(ShippedTool::ALL, ShippedTool::id))]
    pub tool: ShippedTool,
    /// Where to write the model file; without it, it is compared with the shipped one.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
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
    /// The formula that genetic programming finds on the rows that the neural model is trained on.
    Genetic(TrainGeneticArgs),
    /// The three networks of the neural control scheme UNKS.
    Unks(TrainUnksArgs),
}

/// Arguments of `train genetic`.
#[derive(Debug, Args)]
pub struct TrainGeneticArgs {
    /// Where to write the formula's model file; without it, it is compared with the shipped one.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Exit with 1 unless the shipped file is found again, digit by digit.
    #[arg(long, conflicts_with = "out")]
    pub check: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `train unks`.
#[derive(Debug, Args)]
pub struct TrainUnksArgs {
    /// Folder to write the three network files into.
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<OutFolder>,
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
    #[arg(long, default_value = "improved", value_parser = one_of(RecipeKind::ALL, RecipeKind::id))]
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
    #[arg(long, value_parser = one_of(Activation::ALL, Activation::id))]
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
    pub out: Option<OutPath>,
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

/// Reads one of a closed choice by its id; help and completions list all.
pub(super) fn one_of<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    id: fn(T) -> &'static str,
) -> ValueParser {
    let ids = PossibleValuesParser::new(all.iter().map(|option| id(*option)));
    let find = move |text: String| all.iter().copied().find(|option| id(*option) == text);
    ids.try_map(move |text| find(text).ok_or("no such choice")).into()
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
    /// List the block diagram: its boxes with signals, equations, sources and settings.
    #[arg(long)]
    pub diagram: bool,
    /// List which command and which screen uses which setting, and why another does not.
    #[arg(long, conflicts_with = "diagram")]
    pub uses: bool,
}

/// Arguments of `plan`.
#[derive(Debug, Args)]
pub struct PlanArgs {
    /// A preset's name, a scenario file, or a link of the console.
    #[arg(value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// Change a setting, for example `--set plan.free_speed=false`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// A part of one's own: a table (CSV) of depths along a path; see `steadycut part`.
    #[arg(long, value_name = "FILE.csv")]
    pub part: Option<InPath>,
    /// Cutter and material of one's own.
    #[command(flatten)]
    pub own_cut: OwnCutArgs,
    /// Limits of another machine, in the format of the shipped file of the papers' machine, whose
    /// values are placeholders; or a machine of one's own with a section of limits, as `steadycut own new machine` begins it.
    #[arg(long, value_name = "FILE.toml")]
    pub machine: Option<InPath>,
    /// Plan the feed of every cut for its lightest or its heaviest section, the spindle as
    /// programmed.
    #[arg(long, value_name = "SECTION", value_parser = one_of(PlannedSection::ALL, PlannedSection::id))]
    pub per_cut: Option<PlannedSection>,
    /// Write the scenario with the optimum as its programmed feed and speed, or with the feeds per
    /// cut.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `robust`.
#[derive(Debug, Args)]
pub struct RobustArgs {
    /// A preset's name, a scenario file, or a link of the console.
    #[arg(long, value_name = "PRESET|FILE|LINK", default_value = "experiment-2")]
    pub scenario: ScenarioPath,
    /// The controller; without it the scenario's.
    #[arg(long, value_parser = one_of(ControllerKind::ALL, ControllerKind::id))]
    pub controller: Option<ControllerKind>,
    /// A controller of one's own, as a script in Rhai with a function `update(now)`; it controls every run.
    #[arg(long, value_name = "FILE.rhai", conflicts_with = "controller")]
    pub script: Option<InPath>,
    /// Change a setting, for example `--set belief.dead_time_s=0.08`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// A part of one's own: a table (CSV) of depths along a path; see `steadycut part`.
    #[arg(long, value_name = "FILE.csv")]
    pub part: Option<InPath>,
    /// Cutter and material of one's own.
    #[command(flatten)]
    pub own_cut: OwnCutArgs,
    /// Drives of one's own.
    #[command(flatten)]
    pub own_machine: OwnMachineArgs,
    /// Number of runs.
    #[arg(long, default_value_t = 500, value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_RUNS)))]
    pub runs: u32,
    /// Seed of everything that is drawn.
    #[arg(long, default_value_t = 1)]
    pub seed: u32,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub struct CheckArgs {
    /// Scenario files.
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<InPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `formula`.
#[derive(Debug, Args)]
pub struct FormulaArgs {
    /// A formula, for example `"8973*ln(0.039*f)/f"`, or the file of a formula's model (TOML or JSON).
    #[arg(value_name = "MODEL|TEXT", allow_hyphen_values = true)]
    pub formula: FormulaPath,
    /// A table with a column for every input; it is printed with the column `predicted`, and for a model with
    /// ranges with the column `extrapolated`. Without a table the formula is printed in all its forms.
    #[arg(long, value_name = "FILE.csv")]
    pub data: Option<InPath>,
    /// Where to write the table; without it, it goes to standard output.
    #[arg(long, value_name = "FILE.csv", requires = "data")]
    pub out: Option<OutPath>,
    /// Range of an input of a TEXT, for example `--range f=70..600`; it makes the formula a model, with ranges
    /// for all inputs.
    #[arg(long, value_name = "NAME=LOW..HIGH", value_parser = range_of)]
    pub range: Vec<(String, [f64; 2])>,
    /// Unit of an input of a TEXT, for example `--unit f=mm/min`; without it, it is a plain number.
    #[arg(long, value_name = "NAME=UNIT", value_parser = unit_of)]
    pub unit: Vec<(String, String)>,
    /// Name of the result of a TEXT, and its unit: `F=N`.
    #[arg(long, value_name = "NAME=UNIT", value_parser = unit_of)]
    pub result: Option<(String, String)>,
    /// Write the formula as a model file, which a scenario takes; it needs all ranges.
    #[arg(long, value_name = "FILE.toml")]
    pub save: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

fn range_of(text: &str) -> Result<(String, [f64; 2]), String> {
    let parts = text.rsplit_once('=').and_then(|(name, range)| {
        let (low, high) = range.split_once("..")?;
        Some((name.trim(), low.trim().parse().ok()?, high.trim().parse().ok()?))
    });
    match parts {
        Some((name, low, high)) if !name.is_empty() => Ok((name.to_owned(), [low, high])),
        Some(_) | None => Err("allowed is NAME=LOW..HIGH with two numbers".to_owned()),
    }
}

fn unit_of(text: &str) -> Result<(String, String), String> {
    match text.rsplit_once('=') {
        Some((name, unit)) if !name.trim().is_empty() => {
            Ok((name.trim().to_owned(), unit.trim().to_owned()))
        }
        Some(_) | None => Err("allowed is NAME=UNIT".to_owned()),
    }
}

/// Arguments of `recommend`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct RecommendArgs {
    /// Brinell hardness of the workpiece.
    #[arg(long, value_name = "HB", required = true)]
    pub hb: Option<f64>,
    /// Diameter of the cutter.
    #[arg(long, value_name = "MM", required = true)]
    pub diameter: Option<f64>,
    /// Number of teeth, for the feed of all of them.
    #[arg(long, value_name = "Z", default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..=8))]
    pub teeth: u32,
    /// Engagement: 1 slot, 2 heavy side cut, 3 light side cut, 4 finishing.
    #[arg(long, value_name = "1|2|3|4", required = true, value_parser = one_of(EngagementCode::ALL, EngagementCode::id))]
    pub engagement: Option<EngagementCode>,
    /// Another table in the form of the shipped one, which is synthetic.
    #[arg(long, value_name = "FILE.csv")]
    pub table: Option<InPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
    /// What else there is to do.
    #[command(subcommand)]
    pub what: Option<RecommendWhat>,
}

/// What `recommend` does besides.
#[derive(Debug, Subcommand)]
pub enum RecommendWhat {
    /// Make the shipped table again from its formulas, and compare.
    Table(RecommendTableArgs),
}

/// Arguments of `recommend table`.
#[derive(Debug, Args)]
pub struct RecommendTableArgs {
    /// Where to write the table; without it, it is printed.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<OutPath>,
    /// Exit with 1 unless the shipped table is reproduced exactly.
    #[arg(long, conflicts_with = "out")]
    pub check: bool,
}

/// Arguments of `combine`.
#[derive(Debug, Args)]
pub struct CombineArgs {
    /// A preset's name, a scenario file, or a link of the console.
    #[arg(long, value_name = "PRESET|FILE|LINK", default_value = "experiment-2")]
    pub scenario: ScenarioPath,
    /// Change a setting, for example `--set run.seed=2`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// A part of one's own: a table (CSV) of depths along a path; see `steadycut part`.
    #[arg(long, value_name = "FILE.csv")]
    pub part: Option<InPath>,
    /// The section of the part that the feed is planned for: the controller lowers the feed to
    /// nothing but raises it by half at most, so the lightest one is the faster choice.
    #[arg(long, default_value = PlannedSection::Lightest.id(), value_parser = one_of(PlannedSection::ALL, PlannedSection::id))]
    pub section: PlannedSection,
    /// Another cutting-data table in the form of the shipped one, which is synthetic.
    #[arg(long, value_name = "FILE.csv")]
    pub table: Option<InPath>,
    /// Limits of another machine, in the format of the shipped file, or a machine of one's own.
    #[arg(long, value_name = "FILE.toml")]
    pub machine: Option<InPath>,
    /// Write the scenario with the planned values programmed.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `unks`.
#[derive(Debug, Args)]
pub struct UnksArgs {
    /// A preset's name, a scenario file, or a link of the console.
    #[arg(value_name = "PRESET|FILE|LINK", default_value = "experiment-2")]
    pub scenario: ScenarioPath,
    /// Change a setting, for example `--set run.seed=2`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// A part of one's own: a table (CSV) of depths along a path; see `steadycut part`.
    #[arg(long, value_name = "FILE.csv")]
    pub part: Option<InPath>,
    /// Begin with an untrained inverse model: literal feedback-error learning.
    #[arg(long)]
    pub cold: bool,
    /// How often the part is cut, the learned networks carried on.
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=50))]
    pub passes: u32,
    /// Learning rate from the cold start, or of NM-1 and NM-2 alike, 0 to 0.1.
    #[arg(long)]
    pub rate: Option<f64>,
    /// Begin with the networks of this file.
    #[arg(long, value_name = "FILE.json")]
    pub load: Option<InPath>,
    /// Write the networks as they are after the last pass.
    #[arg(long, value_name = "FILE.json")]
    pub save: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub struct CompletionsArgs {
    /// The shell.
    #[arg(value_enum)]
    pub shell: clap_complete::Shell,
    /// Where to write it; without it, it is printed.
    #[arg(long, value_name = "FILE")]
    pub out: Option<OutPath>,
}

/// Arguments of `man`.
#[derive(Debug, Args)]
pub struct ManArgs {
    /// The command whose page is printed, for example `machine stability`; without it, the program's.
    #[arg(value_name = "COMMAND", conflicts_with = "out")]
    pub of: Vec<String>,
    /// Folder to write the pages of the program and of all its commands into.
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<OutFolder>,
}

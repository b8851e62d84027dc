//! The arguments of `steadycut experiment`.

use clap::{Args, Subcommand, ValueEnum};

use crate::blocks::cutting::material::Material;
use crate::cli::args::one_of;
use crate::cli::files::{InPath, OutFolder, OutPath, ScenarioPath};
use crate::models::tool::ShippedTool;
use crate::study::experiment::terms::DeclaredModel;
use crate::study::experiment::way::{CUTS_2007, WayPlant};
use crate::study::identify::gp::job::BATCHES;

/// A design as an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DesignArg {
    /// All combinations of levels (`--levels`).
    Full,
    /// A regular fraction of the two-level factorial (`--drop` or `--generator`).
    Fraction,
    /// Two-level factorial, stars on the axes, and the middle (`--stars`, `--centre`).
    Composite,
    /// Latin hypercube (`--points`).
    Latin,
}

/// Arguments of `experiment`.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true)]
pub struct ExperimentArgs {
    /// What else there is to do.
    #[command(subcommand)]
    pub what: Option<ExperimentWhat>,
    /// The cut that is varied: a preset's name, a scenario file, or a link of the console.
    #[arg(long, value_name = "PRESET|FILE|LINK", default_value = "first-cut")]
    pub scenario: ScenarioPath,
    /// Change a setting, for example `--set plant.material=42crmo4`; `steadycut list` names all.
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub set: Vec<String>,
    /// Refused, with the reason: every cut of an experiment is of one depth.
    #[arg(long, value_name = "FILE.csv", hide = true)]
    pub part: Option<InPath>,
    /// A factor: feed, speed, axial_depth, radial_depth, hardness or wear with its range, as
    /// `feed=240..600`, or without one over a default; `feed=240..600:4` has four levels in a full factorial;
    /// `tool=ball-6-2,ball-10-2` are cutters.
    #[arg(long, value_name = "NAME=LOW..HIGH", default_values = ["feed", "speed"])]
    pub factor: Vec<String>,
    /// The design.
    #[arg(long, value_enum, default_value = "full")]
    pub design: DesignArg,
    /// Levels of each factor of a full factorial: 2 without it.
    #[arg(long, value_parser = clap::value_parser!(u32).range(2..=20))]
    pub levels: Option<u32>,
    /// Factors dropped from a two-level factorial: 2^(k - DROP) runs by the standard generators of least
    /// aberration. Of `fraction` and `composite`.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=6))]
    pub drop: Option<u32>,
    /// A generator, as `D=ABC` or `D=-ABC`; A is the first factor. Of `fraction` and `composite`.
    #[arg(long, value_name = "D=ABC", conflicts_with = "drop", allow_hyphen_values = true)]
    pub generator: Vec<String>,
    /// Where the stars of a composite design stand: faced (1), rotatable, or a number over the factorial:
    /// faced without it.
    #[arg(long, value_name = "faced|rotatable|NUMBER")]
    pub stars: Option<String>,
    /// Points of a Latin hypercube: 20 without it.
    #[arg(long, value_parser = clap::value_parser!(u32).range(2..=2000))]
    pub points: Option<u32>,
    /// Runs with all factors in the middle: none without it, 4 of a composite design.
    #[arg(long, value_parser = clap::value_parser!(u32).range(0..=100))]
    pub centre: Option<u32>,
    /// How often the whole design is cut.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100))]
    pub replicates: u32,
    /// Seed of the order, of a Latin hypercube and of the measuring noise.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// The runs of a table in place of a design: CSV with columns of factors.
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["scenario", "seed", "factor", "design", "levels", "drop", "generator",
        "stars", "points", "centre", "replicates", "set", "part", "run", "read", "out", "page"])]
    pub table: Option<InPath>,
    /// The model whose terms the runs have to tell apart.
    #[arg(long, value_parser = one_of(DeclaredModel::ALL, DeclaredModel::id), default_value = DeclaredModel::Interactions.id())]
    pub model: DeclaredModel,
    /// A term of a model of one's own, a formula of the columns, as `ln(0.039*feed_mm_min)/feed_mm_min`; a
    /// constant stands beside the terms.
    #[arg(long, value_name = "FORMULA", conflicts_with = "model", allow_hyphen_values = true)]
    pub term: Vec<String>,
    /// Standard deviation of a measured force, N.
    #[arg(long, value_name = "N", default_value_t = 2.0, value_parser = noise_n)]
    pub noise: f64,
    /// Standard deviation of a measured Ra, um.
    #[arg(long, value_name = "UM", default_value_t = 0.02, value_parser = noise_um)]
    pub ra_noise: f64,
    /// Make the cuts on the simulator, and print what is measured.
    #[arg(long)]
    pub run: bool,
    /// Read a sheet of this plan that was filled in: the rows measured are written to `--out`; exit with 1 where
    /// runs are missing.
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["run", "page"])]
    pub read: Option<InPath>,
    /// Where to write the sheet as CSV, with what was measured; `identify gp --data` reads it.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<OutPath>,
    /// Where to write the sheet as a page to print and fill in.
    #[arg(long, value_name = "FILE.html")]
    pub page: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// What `experiment` does besides.
#[derive(Debug, Subcommand)]
pub enum ExperimentWhat {
    /// The whole way: plan cuts, measure them on the simulator, find K1 to K6 by genetic programming, and hold
    /// Ra with SDNRP and Tracking on them in the ten rows of 2007 Table 3.
    Way(WayArgs),
}

/// Arguments of `experiment way`.
#[derive(Debug, Args)]
pub struct WayArgs {
    /// The cutter.
    #[arg(long, value_name = "TOOL", default_value = ShippedTool::ALL[0].id(), value_parser = one_of(ShippedTool::ALL, ShippedTool::id))]
    pub tool: ShippedTool,
    /// The material.
    #[arg(long, value_name = "MATERIAL", default_value = Material::Ck45.id(), value_parser = one_of(Material::ALL, Material::id))]
    pub material: Material,
    /// Its Brinell hardness: that of the material without it.
    #[arg(long, value_name = "HB")]
    pub hardness: Option<f64>,
    /// What gives the true force: without it the papers' formula for their cutter in their steel, tooth by tooth
    /// otherwise.
    #[arg(long, value_parser = one_of(WayPlant::ALL, WayPlant::id))]
    pub plant: Option<WayPlant>,
    /// Axial depth: the papers' 2 mm without it, or tooth by tooth the one that pilot cuts find.
    #[arg(long, value_name = "MM")]
    pub axial_depth: Option<f64>,
    /// Radial depth: the papers' 3 mm without it.
    #[arg(long, value_name = "MM")]
    pub radial_depth: Option<f64>,
    /// Number of cuts: the paper had 185.
    #[arg(long, default_value_t = CUTS_2007)]
    pub cuts: usize,
    /// Standard deviation of a measured force, N.
    #[arg(long, value_name = "N", default_value_t = 2.0, value_parser = noise_n)]
    pub noise: f64,
    /// Standard deviation of a measured Ra, um.
    #[arg(long, value_name = "UM", default_value_t = 0.02, value_parser = noise_um)]
    pub ra_noise: f64,
    /// Seed of plan, noise and search.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Most batches of each search; it ends earlier where nothing is gained any more.
    #[arg(long, default_value_t = BATCHES, value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    pub batches: u64,
    /// Go on with a way that `--state` saved: the same settings, batches excepted.
    #[arg(long, value_name = "FILE.json")]
    pub resume: Option<InPath>,
    /// Where to save the searches when it is over or interrupted, to go on with later.
    #[arg(long, value_name = "FILE.json")]
    pub state: Option<OutPath>,
    /// Folder for the cuts as a table, the models as files, and the scenario with the models.
    #[arg(long, value_name = "FOLDER")]
    pub out: Option<OutFolder>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

fn within(text: &str, most: f64, unit: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|x| (0.0..=most).contains(x));
    number.ok_or_else(|| format!("allowed is a number from 0 to {most} {unit}"))
}

fn noise_n(text: &str) -> Result<f64, String> {
    within(text, 50.0, "N")
}

fn noise_um(text: &str) -> Result<f64, String> {
    within(text, 1.0, "um")
}

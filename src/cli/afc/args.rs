//! The arguments of `steadycut afc`.

use clap::{Args, Subcommand};

use crate::cli::files::{InPath, OutPath, ScenarioPath};

/// Arguments of `afc`.
#[derive(Debug, Args)]
pub struct AfcArgs {
    /// What to do.
    #[command(subcommand)]
    pub what: AfcWhat,
}

/// What `afc` does.
#[derive(Debug, Subcommand)]
pub enum AfcWhat {
    /// Cut the part once at the programmed feed and keep the peak force of each cut as its reference.
    Teach(AfcTeachArgs),
    /// Run a scenario under AFC and print its log: times, peak force and least feed of each cut.
    Log(AfcLogArgs),
}

/// Arguments of `afc teach`.
#[derive(Debug, Args)]
pub struct AfcTeachArgs {
    /// A preset's name, a scenario file, or a link of the console; changes during its cut do not belong to the
    /// teach-in.
    #[arg(value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// A part of one's own: a table (CSV) of depths along a path; see `steadycut part`. It is one cut, whatever depths it goes
    /// through.
    #[arg(long, value_name = "FILE.csv")]
    pub part: Option<InPath>,
    /// Write the scenario under AFC with these references.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `afc log`.
#[derive(Debug, Args)]
pub struct AfcLogArgs {
    /// A preset's name, a scenario file, or a link of the console; its controller is AFC.
    #[arg(value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// A part of one's own: a table (CSV) of depths along a path; see `steadycut part`. It is one cut, whatever depths it goes
    /// through.
    #[arg(long, value_name = "FILE.csv")]
    pub part: Option<InPath>,
    /// Write the log as CSV.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

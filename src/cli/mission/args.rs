//! The arguments of `steadycut mission`.

use clap::{ArgGroup, Args, Subcommand};

use crate::cli::files::{InFolder, InPath, MissionPath, OutPath};

/// Arguments of `mission`.
#[derive(Debug, Args)]
pub struct MissionArgs {
    /// What to do.
    #[command(subcommand)]
    pub what: MissionWhat,
}

/// What `mission` does.
#[derive(Debug, Subcommand)]
pub enum MissionWhat {
    /// List the shipped missions, in the order in which they teach.
    List(MissionListArgs),
    /// Print a mission to begin with, every entry explained.
    New(MissionNewArgs),
    /// Print the file of a shipped mission, as an example or to change it.
    Show(MissionShowArgs),
    /// Check that a mission can be read, and mark an answer to it, or a saved result again; exits with 1 where it is not
    /// passed, or the result is not true.
    Check(MissionCheckArgs),
    /// Pack missions with the whole web page into a zip, for a learning platform: SCORM 1.2 or xAPI.
    Pack(MissionPackArgs),
}

/// Arguments of `mission list`.
#[derive(Debug, Args)]
pub struct MissionListArgs {
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `mission new`.
#[derive(Debug, Args)]
pub struct MissionNewArgs {
    /// Write it to a file; without it, to standard output.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
}

/// Arguments of `mission show`.
#[derive(Debug, Args)]
pub struct MissionShowArgs {
    /// A shipped mission's id.
    #[arg(value_name = "ID")]
    pub id: String,
}

/// Arguments of `mission check`.
#[derive(Debug, Args)]
pub struct MissionCheckArgs {
    /// A shipped mission's id, a mission's file, or the result of a shipped mission that the console saved, which is
    /// marked again: what in it is not so is told.
    #[arg(value_name = "ID|FILE")]
    pub mission: MissionPath,
    /// The answer: predictions, and what was set or changed; `mission new` shows one at its end. Or a result that the
    /// console saved. Without it the mission itself is checked.
    #[arg(long, value_name = "FILE.toml|FILE.json")]
    pub answer: Option<InPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `mission pack`.
#[derive(Debug, Args)]
#[command(group(ArgGroup::new("standard").args(["scorm", "xapi"]).required(true)))]
pub struct MissionPackArgs {
    /// Shipped missions by their ids, and files of missions.
    #[arg(value_name = "ID|FILE", required = true)]
    pub missions: Vec<MissionPath>,
    /// The web page: the folder web/dist that web/build makes.
    #[arg(long, value_name = "FOLDER")]
    pub page: InFolder,
    /// SCORM 1.2: the platform receives score, completion, time and answers.
    #[arg(long)]
    pub scorm: bool,
    /// xAPI: statements go to the store that the platform names when it opens the page, and wait while there is no
    /// network.
    #[arg(long)]
    pub xapi: bool,
    /// The title; without it that of the mission.
    #[arg(long)]
    pub title: Option<String>,
    /// What of the page is hidden and locked, as `--embed` without a command.
    #[arg(long, value_name = "FLAG,...", default_value = "", hide_default_value = true)]
    pub embed: String,
    /// Where to write it.
    #[arg(long, value_name = "FILE.zip")]
    pub out: OutPath,
}

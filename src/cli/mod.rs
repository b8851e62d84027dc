//! The command line: the same simulation without a window.

mod afc;
pub mod args;
mod check;
mod combine;
mod errata;
mod experiment;
mod files;
mod force;
mod formula;
mod formula_told;
mod given;
mod identify;
mod identify_data;
mod identify_drive;
mod identify_force;
mod identify_gp;
mod identify_material;
mod identify_noise;
mod identify_structure;
mod identify_wear;
mod list;
mod machine;
mod manual;
mod measured;
mod mission;
mod own;
mod papers;
mod papers_2005;
mod papers_2019;
mod papers_told;
mod part;
mod plan;
mod profile;
mod progress;
mod recommend;
mod robust;
mod run;
mod scenarios;
mod schedule;
mod story;
mod train;
mod train_genetic;
mod train_unks;
mod twin;
mod unks;

use std::path::Path;
use std::process::ExitCode;

use args::{Cli, CliCommand};
use files::ScenarioPath;

use crate::disk::WriteError;
use crate::study::opening::Opening;

/// Runs a subcommand; prints its result, or its error in one line.
#[must_use]
pub fn execute(command: &CliCommand) -> ExitCode {
    let result = match command {
        CliCommand::Run(args) => run::execute(args),
        CliCommand::Papers(args) => papers::execute(args),
        CliCommand::Identify(args) => identify::execute(args),
        CliCommand::Experiment(args) => experiment::execute(args),
        CliCommand::Formula(args) => formula::execute(args),
        CliCommand::Train(args) => train::execute(args),
        CliCommand::Force(args) => force::execute(args),
        CliCommand::List(args) => list::execute(args),
        CliCommand::Plan(args) => plan::execute(args),
        CliCommand::Check(args) => check::execute(args),
        CliCommand::Recommend(args) => recommend::execute(args),
        CliCommand::Combine(args) => combine::execute(args),
        CliCommand::Unks(args) => unks::execute(args),
        CliCommand::Afc(args) => afc::execute(args),
        CliCommand::Machine(args) => machine::execute(args),
        CliCommand::Measured(args) => measured::execute(args),
        CliCommand::Mission(args) => mission::execute(args),
        CliCommand::Part(args) => part::execute(args),
        CliCommand::Own(args) => own::execute(args),
        CliCommand::Robust(args) => robust::execute(args),
        CliCommand::Completions(args) => manual::completions(args),
        CliCommand::Man(args) => manual::man(args),
    };
    match result {
        Ok(code) => code,
        // A reader that went away (`steadycut list | head`) is no error.
        Err(error) if is_broken_pipe(error.as_ref()) => ExitCode::SUCCESS,
        Err(error) => {
            report_error(error.as_ref());
            let interrupted =
                matches!(error.downcast_ref(), Some(progress::NotDone::Interrupted { .. }));
            ExitCode::from(if interrupted { progress::INTERRUPTED } else { REFUSED })
        }
    }
}

fn is_broken_pipe(error: &(dyn std::error::Error + 'static)) -> bool {
    let io = error.downcast_ref::<std::io::Error>();
    io.is_some_and(|error| error.kind() == std::io::ErrorKind::BrokenPipe)
        || error.downcast_ref().is_some_and(WriteError::is_broken_pipe)
}

/// Prints an error in one line. What has no name of its own could not be printed.
fn report_error(error: &(dyn std::error::Error + 'static)) {
    let what = if error.is::<std::io::Error>() { "standard output: " } else { "" };
    eprintln!("error: {what}{error}");
}

/// Exit code of a command that cannot be done.
const REFUSED: u8 = 2;

/// What a command gives: an exit code, or an error for one line.
type Outcome = Result<ExitCode, Box<dyn std::error::Error>>;

/// The command line as its documents describe it.
fn command() -> clap::Command {
    files::hinted(<Cli as clap::CommandFactory>::command())
}

/// Reads the command line; a wrong one, or files that do not go together, end the program with what is wrong.
#[must_use]
pub fn parse() -> Cli {
    progress::notice_interrupts();
    let command = command();
    let matches = command.clone().get_matches();
    if let Err(error) = files::check(&command, &matches) {
        report_error(error.as_ref());
        std::process::exit(REFUSED.into());
    }
    <Cli as clap::FromArgMatches>::from_arg_matches(&matches).unwrap_or_else(|error| error.exit())
}

/// Opens the console with a preset, a scenario file or a link (the first preset without one) and flags through the
/// front end's `open`; prints what is missing if it cannot.
#[must_use]
pub fn console(
    scenario: Option<&Path>,
    embed: &str,
    open: impl FnOnce(Opening) -> Result<(), String>,
) -> ExitCode {
    let opened = scenarios::opening(scenario.map(ScenarioPath::new), embed);
    match opened.map_err(|error| error.to_string()).and_then(open) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(REFUSED)
        }
    }
}

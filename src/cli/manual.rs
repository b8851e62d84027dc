//! `steadycut completions` and `steadycut man`: made from the arguments themselves, so that they never
//! lag behind them.

use std::process::ExitCode;

use clap::Command;
use clap_mangen::Man;

use super::args::{CompletionsArgs, ManArgs};
use super::{Outcome, command};
use crate::disk::OutFile;

/// Prints or writes a shell's completions.
pub fn completions(args: &CompletionsArgs) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command(), env!("CARGO_PKG_NAME"), &mut script);
    let text = String::from_utf8(script)?;
    match &args.out {
        Some(path) => path.write(&text)?,
        None => OutFile::stdout().keep_text(&text)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// Prints a page, or writes all.
pub fn man(args: &ManArgs) -> Outcome {
    let mut program = without_help(command());
    // Gives every command its whole name.
    program.build();
    if let Some(folder) = &args.out {
        let mut pages = Vec::new();
        all(&program, &mut pages)?;
        let pages: Vec<_> =
            pages.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
        folder.write(&pages)?;
        return Ok(ExitCode::SUCCESS);
    }
    let mut of = &program;
    for word in &args.of {
        of = of.find_subcommand(word).ok_or_else(|| {
            let known: Vec<&str> = of.get_subcommands().map(Command::get_name).collect();
            match known.is_empty() {
                true => format!("`{word}`: {} has no commands", of.get_name()),
                false => format!("`{word}` is no command; there are {}", known.join(", ")),
            }
        })?;
    }
    OutFile::stdout().keep_text(&page(of)?)?;
    Ok(ExitCode::SUCCESS)
}

/// A command without the one that clap adds to it: its pages say what that would.
fn without_help(command: Command) -> Command {
    command.disable_help_subcommand(true).mut_subcommands(without_help)
}

/// The pages of a command and of all below it, by the names of their files.
fn all(of: &Command, pages: &mut Vec<(String, String)>) -> Result<(), Box<dyn std::error::Error>> {
    let name = of.get_display_name().unwrap_or(of.get_name());
    pages.push((format!("{name}.1"), page(of)?));
    of.get_subcommands().try_for_each(|command| all(command, pages))
}

/// A page in roff. No date: the same program makes the same page.
fn page(of: &Command) -> Result<String, Box<dyn std::error::Error>> {
    const VERSION: &str = concat!("steadycut ", env!("CARGO_PKG_VERSION"));
    let mut page = Vec::new();
    Man::new(of.clone()).source(VERSION).manual("SteadyCut").render(&mut page)?;
    Ok(String::from_utf8(page)?)
}

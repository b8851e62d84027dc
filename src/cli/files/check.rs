//! What a command reads and writes, before it begins: nothing is written over what is read, no two results
//! go to one place, standard input is read once, and every place can be written.

use std::any::TypeId;
use std::io::ErrorKind;
use std::path::Path;

use clap::{Arg, ArgMatches, Command, ValueHint};
use same_file::Handle;

use super::{
    FormulaPath, InFolder, InPath, MissionPath, OutFolder, OutPath, STANDARD, ScenarioPath,
};
use crate::disk::{self, OutFile};

/// The files of a command, each with the argument that names it.
#[derive(Default)]
struct Files {
    read: Vec<(String, InPath)>,
    written: Vec<(String, OutPath)>,
    filled: Vec<(String, OutFolder)>,
}

/// Sees to it that a command can read and write its files without harm to any of them.
///
/// # Errors
/// Names both arguments and files that do not go together, or the place that cannot be written.
pub fn check(command: &Command, matches: &ArgMatches) -> Result<(), Box<dyn std::error::Error>> {
    let mut files = Files::default();
    files.collect(command, matches);
    files.check()
}

impl Files {
    fn collect(&mut self, command: &Command, matches: &ArgMatches) {
        for arg in command.get_arguments() {
            let id = arg.get_id().as_str();
            let name = || name(arg);
            // An argument of another type is no file.
            if let Ok(Some(paths)) = matches.try_get_many::<InPath>(id) {
                self.read.extend(paths.map(|path| (name(), path.clone())));
            }
            if let Ok(Some(named)) = matches.try_get_many::<(String, InPath)>(id) {
                self.read.extend(named.map(|(_, path)| (name(), path.clone())));
            }
            if let Ok(Some(paths)) = matches.try_get_many::<ScenarioPath>(id) {
                let files = paths.filter_map(|path| path.source().ok());
                self.read.extend(files.map(|path| (name(), path)));
            }
            if let Ok(Some(paths)) = matches.try_get_many::<FormulaPath>(id) {
                let files = paths.filter_map(|path| path.source().ok());
                self.read.extend(files.map(|path| (name(), path)));
            }
            if let Ok(Some(paths)) = matches.try_get_many::<MissionPath>(id) {
                let files = paths.filter_map(|path| path.source().ok());
                self.read.extend(files.map(|path| (name(), path)));
            }
            if let Ok(Some(folders)) = matches.try_get_many::<InFolder>(id) {
                // One that cannot be read is told by the command.
                let files = folders.filter_map(|folder| folder.paths().ok()).flatten();
                self.read.extend(files.map(|path| (name(), InPath(path))));
            }
            if let Ok(Some(paths)) = matches.try_get_many::<OutPath>(id) {
                self.written.extend(paths.map(|path| (name(), path.clone())));
            }
            if let Ok(Some(folders)) = matches.try_get_many::<OutFolder>(id) {
                self.filled.extend(folders.map(|folder| (name(), folder.clone())));
            }
        }
        if let Some((name, matches)) = matches.subcommand()
            && let Some(command) = command.find_subcommand(name)
        {
            self.collect(command, matches);
        }
    }

    fn check(&self) -> Result<(), Box<dyn std::error::Error>> {
        let mut from_stdin = self.read.iter().filter(|(_, path)| path.is_stdin());
        if let (Some((first, _)), Some((second, _))) = (from_stdin.next(), from_stdin.next()) {
            let problem = "standard input can be read only once";
            return Err(format!("{first} and {second} are both `-`: {problem}").into());
        }
        let read = self.read.iter().filter_map(|(name, path)| {
            let handle = if path.is_stdin() { Handle::stdin() } else { handle(&path.0) };
            there(format!("{name} {path}"), handle)
        });
        let read: Vec<There> = read.collect();
        let mut written = written(&self.written);
        written.extend(there("standard output".to_owned(), Handle::stdout()));
        for output in &written {
            if let Some(input) = read.iter().find(|input| input.handle == output.handle) {
                let problem = "nothing is written over what is read";
                return Err(both(input, output, problem).into());
            }
        }
        distinct(&written)?;
        for (name, OutFolder(folder)) in &self.filled {
            if folder.as_os_str() == STANDARD {
                let problem = "several files do not go to standard output: name a folder";
                return Err(format!("{name} {STANDARD}: {problem}").into());
            }
            disk::can_fill(folder)?;
        }
        let places = self.written.iter().filter(|(_, path)| !path.is_stdout());
        Ok(places.map(|(_, path)| &path.0).try_for_each(|path| OutFile::can_be(path))?)
    }
}

/// Sees to it that files of one folder are not the same one under several names.
///
/// # Errors
/// Names two that are.
pub fn differ(paths: &[OutPath]) -> Result<(), String> {
    let named: Vec<(String, OutPath)> =
        paths.iter().map(|path| ("file".to_owned(), path.clone())).collect();
    distinct(&written(&named))
}

/// The name of an argument as a user writes it, or as the help calls it.
fn name(arg: &Arg) -> String {
    match (arg.get_long(), arg.get_value_names()) {
        (Some(long), _) => format!("--{long}"),
        (None, Some([name, ..])) => name.to_string(),
        (None, _) => arg.get_id().to_string(),
    }
}

/// A file that is there.
struct There {
    name: String,
    handle: Handle,
}

/// A pipe is not opened: that would wait for its other end.
fn handle(path: &Path) -> std::io::Result<Handle> {
    match std::fs::metadata(path)?.is_file() {
        true => Handle::from_path(path),
        false => Err(ErrorKind::Unsupported.into()),
    }
}

/// What is there, if it is a file: a device or a pipe is not lost by being written.
fn there(name: String, handle: std::io::Result<Handle>) -> Option<There> {
    // What cannot be opened to be read is found out where it is.
    let handle = handle.ok()?;
    let is_file = handle.as_file().metadata().is_ok_and(|found| found.is_file());
    is_file.then_some(There { name, handle })
}

fn written(files: &[(String, OutPath)]) -> Vec<There> {
    let files = files.iter().filter(|(_, path)| !path.is_stdout());
    files.filter_map(|(name, path)| there(format!("{name} {path}"), handle(&path.0))).collect()
}

fn both(one: &There, other: &There, problem: &str) -> String {
    format!("{} and {} are the same file: {problem}", one.name, other.name)
}

fn distinct(written: &[There]) -> Result<(), String> {
    for (i, one) in written.iter().enumerate() {
        if let Some(other) = written[..i].iter().find(|other| other.handle == one.handle) {
            return Err(both(other, one, "two results need two files"));
        }
    }
    Ok(())
}

/// Tells the command, for its completions, which arguments are files and folders.
#[must_use]
pub fn hinted(command: Command) -> Command {
    let hint = |arg: Arg| {
        let is = |hinted: TypeId| arg.get_value_parser().type_id() == hinted;
        if is(TypeId::of::<OutFolder>()) || is(TypeId::of::<InFolder>()) {
            arg.value_hint(ValueHint::DirPath)
        } else if [
            TypeId::of::<InPath>(),
            TypeId::of::<ScenarioPath>(),
            TypeId::of::<FormulaPath>(),
            TypeId::of::<MissionPath>(),
            TypeId::of::<OutPath>(),
        ]
        .into_iter()
        .any(is)
        {
            arg.value_hint(ValueHint::FilePath)
        } else {
            arg
        }
    };
    command.mut_args(hint).mut_subcommands(hinted)
}

//! `steadycut own list`: the folder of one's own, as the console lists it.

use std::io::Write;
use std::path::Path;

use serde_json::{Value, json};

use super::OwnListArgs;
use crate::disk::own_folder::{self, FolderContents, OwnFolder};
use crate::study::library::{LibraryFile, LibraryHas, LibraryKind};

/// The files that the program takes, and how many it has no use for.
fn read(folder: &Path, found: &FolderContents) -> (Vec<LibraryFile>, usize) {
    let files = found.files.iter().filter_map(|file| {
        LibraryFile::of(&file.name, file.bytes, || match &file.problem {
            Some(problem) => Err(problem.clone()),
            None => own_folder::read_in(folder, &file.name),
        })
    });
    let mut files: Vec<LibraryFile> = files.collect();
    let others = found.files.len() - files.len();
    files.sort_by(|a, b| (a.kind, &a.name).cmp(&(b.kind, &b.name)));
    (files, others)
}

fn told(file: &LibraryFile) -> Value {
    let settings = match &file.has {
        LibraryHas::Settings(settings) => {
            let one = |(path, value): &(String, _)| (path.clone(), json!(value));
            Value::Object(settings.iter().map(one).collect())
        }
        LibraryHas::Unknown | LibraryHas::Whole(_) | LibraryHas::Formula(..) => Value::Null,
    };
    json!({
        "name": file.name, "kind": file.kind, "bytes": file.bytes, "title": file.title,
        "facts": file.facts, "fault": file.fault, "settings": settings,
    })
}

/// Runs the command.
pub fn execute(args: &OwnListArgs) -> Result<(), Box<dyn std::error::Error>> {
    let folder = match &args.folder {
        Some(folder) => folder.path().to_owned(),
        None => {
            let own = OwnFolder::of_user();
            own.ok_or("the system names no place for a user's files: name a folder")?.place()
        }
    };
    if args.folder.is_some() && !folder.exists() {
        return Err(format!("{}: there is no such folder", folder.display()).into());
    }
    let found = own_folder::list(&folder)?;
    let (files, others) = read(&folder, &found);
    let mut out = std::io::stdout().lock();
    if args.json {
        let told = json!({
            "folder": folder.display().to_string(),
            "files": files.iter().map(told).collect::<Vec<_>>(),
            "others": others,
            "remarks": found.remarks,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(());
    }
    writeln!(out, "{}", folder.display())?;
    if files.is_empty() {
        writeln!(out, "  no files; `steadycut own new tool --out FILE.toml` begins one")?;
    }
    let width = files.iter().map(|file| file.name.chars().count()).max().unwrap_or(0).min(40);
    for kind in LibraryKind::ALL {
        let mut of_kind = files.iter().filter(|file| file.kind == *kind).peekable();
        if of_kind.peek().is_some() {
            writeln!(out, "\n{}", kind.several())?;
        }
        for file in of_kind {
            let parts = [&file.title, &file.facts].into_iter().filter(|text| !text.is_empty());
            let about = parts.map(String::as_str).collect::<Vec<_>>().join("; ");
            match &file.fault {
                None => writeln!(out, "  {:<width$}  {about}", file.name)?,
                Some(fault) => {
                    let fault = fault.trim_end().replace('\n', "\n      ");
                    writeln!(out, "  {:<width$}  faulty: {fault}", file.name)?;
                }
            }
        }
    }
    match others {
        0 => {}
        1 => writeln!(out, "\n1 other file, of no use here")?,
        n => writeln!(out, "\n{n} other files, of no use here")?,
    }
    found.remarks.iter().try_for_each(|remark| writeln!(out, "\nnote: {remark}"))?;
    Ok(())
}

//! `steadycut mission pack`: missions with the whole web page in a zip, as a learning platform takes them.

mod page;
mod scorm;
mod xapi;
mod zip;

use std::io::Write;
use std::process::ExitCode;

use serde::Serialize;

use self::page::{INDEX, NamedFiles, WORKER, WebPage};
use super::args::MissionPackArgs;
use super::{Given, given};
use crate::cli::{Outcome, files};
use crate::run::digest::Digest;
use crate::study::mission::Mission;
use crate::study::opening::Frame;

/// What hands results on, within the page.
const ADAPTER: &str = include_str!("../../../../web/pack/lms.js");

/// Which standard a package follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// SCORM 1.2.
    Scorm,
    /// xAPI 1.0.3, launched as Tin Can packages are.
    Xapi,
}

/// What the adapter is told, in the page's element `pack`.
#[derive(Serialize)]
struct Pack {
    kind: &'static str,
    title: String,
    embed: String,
    missions: Vec<PackedMission>,
}

#[derive(Serialize)]
struct PackedMission {
    id: String,
    title: String,
    about: String,
    digest: String,
    /// Name of the activity in statements.
    activity: String,
    /// Its part of a link.
    link: String,
}

impl PackedMission {
    fn new(mission: &Mission) -> Self {
        let (id, digest) = (mission.id.clone(), mission.digest());
        Self {
            activity: format!("urn:steadycut:mission:{id}:{digest}"),
            title: mission.title.clone(),
            about: mission.about.clone(),
            link: mission.link(),
            id,
            digest,
        }
    }
}

/// Runs the command.
pub fn execute(args: &MissionPackArgs) -> Outcome {
    let kind = if args.scorm { Kind::Scorm } else { Kind::Xapi };
    let pack = pack(args, kind)?;
    let page = WebPage::read(&args.page)?;
    let name = name(&pack, &page);
    let files = packed(kind, &pack, &name, page)?;
    let bytes = zip::zipped(&files)?;
    let mut out = args.out.create()?;
    out.write_all(&bytes).map_err(|error| out.failed(error))?;
    out.keep()?;
    let mut report = files::report(false, Some(&args.out))?;
    let standard = match kind {
        Kind::Scorm => "SCORM 1.2",
        Kind::Xapi => "xAPI",
    };
    writeln!(report, "{}: {standard}, {} files, {} bytes", args.out, files.len(), bytes.len())?;
    for mission in &pack.missions {
        writeln!(report, "  {}: {}", mission.id, mission.title)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The missions, each once, with flags and title.
fn pack(args: &MissionPackArgs, kind: Kind) -> Result<Pack, Box<dyn std::error::Error>> {
    let mut missions: Vec<PackedMission> = Vec::new();
    for path in &args.missions {
        match given(path)? {
            Given::Mission(mission) => missions.push(PackedMission::new(&mission)),
            Given::Result(file, _) => {
                return Err(format!("{file} is a result: allowed are missions").into());
            }
        }
    }
    for (at, mission) in missions.iter().enumerate() {
        if missions[..at].iter().any(|other| other.id == mission.id) {
            let id = &mission.id;
            return Err(
                format!("two missions have the id `{id}`: a package tells them by it").into()
            );
        }
    }
    let mut frame = Frame::default();
    if let Some(problem) = frame.take(&args.embed).into_iter().next() {
        return Err(format!("--{problem}").into());
    }
    let title = match (&args.title, missions.as_slice()) {
        (Some(title), _) if title.trim().is_empty() => {
            return Err("--title is empty: a package has a title".into());
        }
        (Some(title), _) => title.clone(),
        (None, [mission]) => mission.title.clone(),
        (None, all) => format!("SteadyCut: {} missions", all.len()),
    };
    let kind = match kind {
        Kind::Scorm => "scorm12",
        Kind::Xapi => "xapi",
    };
    Ok(Pack { kind, title, embed: frame.write(), missions })
}

/// A digest of all that makes the package what it is.
fn name(pack: &Pack, page: &WebPage) -> String {
    let mut digest = Digest::default();
    digest.text(pack.kind);
    digest.text(&pack.title);
    digest.text(&pack.embed);
    digest.text(page.build());
    digest.text(ADAPTER);
    for mission in &pack.missions {
        digest.text(&mission.activity);
    }
    digest.hex()
}

/// All files of the package, the description first.
fn packed(
    kind: Kind,
    pack: &Pack,
    name: &str,
    page: WebPage,
) -> Result<NamedFiles, Box<dyn std::error::Error>> {
    let adapter = format!("lms.js?v={name}");
    // What ends a script or begins a comment in a page does not stand in it.
    let told = serde_json::to_string(pack)?.replace('<', "\\u003c");
    let scripts = format!(
        "<script type=\"application/json\" id=\"pack\">{told}</script>\n<script src=\"{adapter}\"></script>"
    );
    let worker = serde_json::json!({ "name": name, "page": INDEX, "files": [adapter] }).to_string();
    let mut files = page.with(&scripts, &worker)?;
    files.push(("lms.js".to_owned(), ADAPTER.as_bytes().to_vec()));
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    let (description, text) = match kind {
        Kind::Scorm => ("imsmanifest.xml", scorm::manifest(pack, name, &names)),
        Kind::Xapi => ("tincan.xml", xapi::tincan(pack, name)),
    };
    debug_assert!(names.contains(&INDEX) && names.contains(&WORKER));
    files.insert(0, (description.to_owned(), text.into_bytes()));
    Ok(files)
}

/// A text within XML.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            // XML 1.0 has no other control characters.
            control if control.is_control() && !"\t\n\r".contains(control) => {}
            plain => escaped.push(plain),
        }
    }
    escaped
}

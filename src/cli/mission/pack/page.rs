//! The web page that a package holds: the folder that `web/build` makes, whole and unmixed.

use crate::cli::files::InFolder;

/// The page itself.
pub const INDEX: &str = "index.html";
/// The worker that keeps it for use off line.
pub const WORKER: &str = "sw.js";
/// The program.
const PROGRAM: &str = "steadycut_bg.wasm";
/// All that the page cannot do without.
const NEEDED: [&str; 8] =
    [INDEX, "boot.js", "texts.js", "mirror.js", WORKER, "icon.svg", "steadycut.js", PROGRAM];
/// Where the scripts of a package stand in the page.
const MARK: &str = "<!-- pack: `steadycut mission pack` puts its scripts here -->";
/// Where the worker is told of the package.
const WORKER_MARK: &str = "const PACK = null;";
/// Names that no file of a page may have: the package brings its own.
const OURS: [&str; 3] = ["lms.js", "imsmanifest.xml", "tincan.xml"];

/// Files with their names, folders parted by `/`.
pub type NamedFiles = Vec<(String, Vec<u8>)>;

/// A page that was read.
pub struct WebPage {
    folder: String,
    build: String,
    files: NamedFiles,
}

impl WebPage {
    /// Reads a folder.
    ///
    /// # Errors
    /// It is no page, not whole, or a mixture: what is missing or wrong.
    pub fn read(folder: &InFolder) -> Result<Self, String> {
        let files = folder.files()?;
        let bad = |problem: String| format!("--page {folder}: {problem}");
        let find = |name: &str| {
            let found = files.iter().find(|(file, _)| file == name);
            found.map(|(_, bytes)| bytes.as_slice())
        };
        let missing: Vec<&str> =
            NEEDED.into_iter().filter(|name| find(name).is_none_or(<[u8]>::is_empty)).collect();
        if !missing.is_empty() {
            let missing = missing.join(", ");
            return Err(bad(format!(
                "{missing} is missing or empty: allowed is the folder web/dist that web/build makes"
            )));
        }
        let text = |name: &str| {
            let bytes = find(name).unwrap_or_default();
            std::str::from_utf8(bytes).map_err(|_| bad(format!("{name} is no text")))
        };
        let (index, worker) = (text(INDEX)?, text(WORKER)?);
        for (name, text, mark) in [(INDEX, index, MARK), (WORKER, worker, WORKER_MARK)] {
            if text.matches(mark).count() != 1 {
                return Err(bad(format!(
                    "{name} has no place for a package: it is of another version of SteadyCut, make it anew with web/build"
                )));
            }
        }
        let build = between(worker, "const BUILD = \"", "\"").unwrap_or_default();
        if build.is_empty() || build.contains('@') {
            return Err(bad(format!("{WORKER} names no build: web/build has not finished it")));
        }
        for name in [INDEX, "boot.js"] {
            if !text(name)?.contains(build) {
                return Err(bad(format!("{name} is of another build than {WORKER}, {build}")));
            }
        }
        let program = find(PROGRAM).unwrap_or_default();
        if !program.starts_with(b"\0asm") {
            return Err(bad(format!("{PROGRAM} is no WebAssembly")));
        }
        let told = between(index, "data-wasm-bytes=\"", "\"").unwrap_or_default();
        if told != program.len().to_string() {
            let bytes = program.len();
            return Err(bad(format!(
                "{PROGRAM} has {bytes} bytes, {INDEX} says {told}: a mixture"
            )));
        }
        if let Some((name, _)) = files.iter().find(|(name, _)| OURS.contains(&name.as_str())) {
            return Err(bad(format!("it has a file {name}, which a package brings itself")));
        }
        Ok(Self { folder: folder.to_string(), build: build.to_owned(), files })
    }

    /// The name of the build.
    pub fn build(&self) -> &str {
        &self.build
    }

    /// The files, with scripts in the page and what its worker is told.
    ///
    /// # Errors
    /// The page has lost its places for them, which [`Self::read`] has seen.
    pub fn with(self, scripts: &str, worker: &str) -> Result<NamedFiles, String> {
        let folder = self.folder;
        let put = |(name, bytes): (String, Vec<u8>)| {
            let [mark, by] = match name.as_str() {
                INDEX => [MARK, scripts],
                WORKER => [WORKER_MARK, &format!("const PACK = {worker};")],
                _ => return Ok((name, bytes)),
            };
            let text = String::from_utf8(bytes).map_err(|_| format!("--page {folder}: {name}"))?;
            Ok((name, text.replacen(mark, by, 1).into_bytes()))
        };
        self.files.into_iter().map(put).collect()
    }
}

fn between<'a>(text: &'a str, before: &str, after: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(before)?;
    rest.split_once(after).map(|(found, _)| found)
}

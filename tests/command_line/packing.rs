//! `steadycut mission pack`: packages for learning platforms, from a page that stands for the built one: its own
//! files with their places filled in as `web/build` does it, around a program that is none.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use steadycut::base::crc32::crc32;
use steadycut::study::mission::{Mission, TEMPLATE};

const BUILD: &str = "0123456789abcdef";
const PROGRAM: &[u8] = b"\0asm\x01\0\0\0";

/// Makes the folder of a page.
pub fn page(page: &Path) {
    fs::create_dir_all(page.join("snippets")).unwrap();
    for file in ["index.html", "boot.js", "texts.js", "mirror.js", "sw.js", "icon.svg"] {
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("web").join(file);
        let text = fs::read_to_string(source).unwrap().replace("@BUILD@", BUILD);
        fs::write(page.join(file), text.replace("@WASM_BYTES@", &PROGRAM.len().to_string()))
            .unwrap();
    }
    fs::write(page.join("steadycut.js"), "export default 1;").unwrap();
    fs::write(page.join("steadycut_bg.wasm"), PROGRAM).unwrap();
    fs::write(page.join("snippets").join("a & b.js"), "//").unwrap();
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("packing").join(name);
    // What a run before has left is not read again.
    let _ = fs::remove_dir_all(&folder);
    page(&folder.join("dist"));
    fs::write(folder.join("mine.toml"), TEMPLATE).unwrap();
    folder
}

fn pack(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_steadycut"));
    command.args(["mission", "pack"]).args(args).current_dir(folder).output().unwrap()
}

/// The files of a package that was made.
fn made(folder: &Path, args: &[&str]) -> Vec<(String, String)> {
    let output = pack(folder, args);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    unzipped(&fs::read(folder.join("out.zip")).unwrap())
}

/// The files of a zip, by the directory at its end.
fn unzipped(zip: &[u8]) -> Vec<(String, String)> {
    let number = |at: usize, bytes: usize| {
        let bytes = zip[at..at + bytes].iter().rev();
        bytes.fold(0_usize, |number, byte| (number << 8) | usize::from(*byte))
    };
    let end = zip.len() - 22;
    assert_eq!(&zip[end..end + 4], b"PK\x05\x06");
    let (mut at, mut files) = (number(end + 16, 4), Vec::new());
    for _ in 0..number(end + 10, 2) {
        assert_eq!(&zip[at..at + 4], b"PK\x01\x02");
        let (crc, packed, size) = (number(at + 16, 4), number(at + 20, 4), number(at + 24, 4));
        let [name, extra, comment] = [28, 30, 32].map(|field| number(at + field, 2));
        let title = String::from_utf8(zip[at + 46..][..name].to_vec()).unwrap();
        let local = number(at + 42, 4);
        assert_eq!(&zip[local..local + 4], b"PK\x03\x04");
        let from = local + 30 + number(local + 26, 2) + number(local + 28, 2);
        let bytes = miniz_oxide::inflate::decompress_to_vec(&zip[from..][..packed]).unwrap();
        assert_eq!((bytes.len(), crc32(&bytes) as usize), (size, crc), "{title}");
        files.push((title, String::from_utf8_lossy(&bytes).into_owned()));
        at += 46 + name + extra + comment;
    }
    assert_eq!(at, end, "the directory ends where it says");
    files
}

fn text<'a>(files: &'a [(String, String)], name: &str) -> &'a str {
    &files.iter().find(|(file, _)| file == name).unwrap_or_else(|| panic!("no {name}")).1
}

/// The JSON in the page that the adapter reads.
fn told(files: &[(String, String)]) -> serde_json::Value {
    let (_, rest) = text(files, "index.html").split_once("id=\"pack\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn a_scorm_package_lists_all_that_is_in_it_and_opens_each_mission() {
    let folder = folder("scorm");
    let title = "Grade <5> & \"class\"";
    let args = [
        "quiet-speed",
        "mine.toml",
        "--page",
        "dist",
        "--scorm",
        "--title",
        title,
        "--embed",
        "hide:screens,lock:target",
        "--out",
        "out.zip",
    ];
    let files = made(&folder, &args);
    let manifest = text(&files, "imsmanifest.xml");
    let hrefs: Vec<String> = manifest
        .split("<file href=\"")
        .skip(1)
        .map(|rest| rest.split('"').next().unwrap().replace("&amp;", "&"))
        .collect();
    let mut names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    names.retain(|name| *name != "imsmanifest.xml");
    assert_eq!(hrefs, names, "{manifest}");
    assert!(names.contains(&"snippets/a & b.js") && names.contains(&"steadycut_bg.wasm"));
    for part in [
        "xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\"",
        "<schema>ADL SCORM</schema>",
        "<schemaversion>1.2</schemaversion>",
        "<title>Grade &lt;5&gt; &amp; &quot;class&quot;</title>",
        "identifierref=\"page\" isvisible=\"true\" parameters=\"?mission=quiet-speed\"",
        "parameters=\"?mission=my-mission\"",
        "adlcp:scormtype=\"sco\" href=\"index.html\"",
    ] {
        assert!(manifest.contains(part), "{manifest} lacks {part}");
    }
    let told = told(&files);
    assert_eq!((&told["kind"], &told["title"]), (&"scorm12".into(), &title.into()));
    assert_eq!(told["embed"], "embed=hide:screens,lock:target");
    assert_eq!(told["missions"][0]["link"], "mission=quiet-speed");
    assert_eq!(told["missions"][1]["link"], Mission::read(TEMPLATE).unwrap().link());
    let (index, worker) = (text(&files, "index.html"), text(&files, "sw.js"));
    let (_, adapter) = index.split_once("<script src=\"").unwrap();
    let adapter = adapter.split('"').next().unwrap();
    assert!(adapter.starts_with("lms.js?v="), "{adapter}");
    assert!(worker.contains(&format!("\"files\":[\"{adapter}\"]")), "it works off line too");
    assert!(index.find("lms.js").unwrap() < index.find("type=\"module\"").unwrap());
    let before = fs::read(folder.join("out.zip")).unwrap();
    made(&folder, &args);
    assert_eq!(fs::read(folder.join("out.zip")).unwrap(), before, "the same to the byte");
}

#[test]
fn an_xapi_package_has_an_activity_for_each_mission() {
    let folder = folder("xapi");
    let files = made(&folder, &["quiet-speed", "--page", "dist", "--xapi", "--out", "out.zip"]);
    let tincan = text(&files, "tincan.xml");
    assert!(files.iter().all(|(name, _)| name != "imsmanifest.xml"));
    assert_eq!(tincan.matches("<activity ").count(), 1, "{tincan}");
    let activity = told(&files)["missions"][0]["activity"].as_str().unwrap().to_owned();
    assert!(tincan.contains(&format!("<activity id=\"{activity}\"")), "{tincan}");
    assert!(tincan.contains("<launch lang=\"en\">index.html</launch>"), "{tincan}");
    let several = ["quiet-speed", "mine.toml", "--page", "dist", "--xapi", "--out", "out.zip"];
    let files = made(&folder, &several);
    let tincan = text(&files, "tincan.xml");
    assert_eq!(tincan.matches("<activity ").count(), 3, "{tincan}");
    assert!(tincan.contains("index.html?mission=my-mission"), "{tincan}");
}

#[test]
fn what_is_no_whole_page_is_refused_with_the_reason() {
    let refused = |name: &str, spoil: &dyn Fn(&Path)| {
        let folder = folder(name);
        spoil(&folder.join("dist"));
        let output =
            pack(&folder, &["quiet-speed", "--page", "dist", "--scorm", "--out", "out.zip"]);
        assert_eq!(output.status.code(), Some(2), "{name}");
        assert!(!folder.join("out.zip").exists(), "{name}");
        String::from_utf8(output.stderr).unwrap()
    };
    let replace = |page: &Path, file: &str, from: &str, to: &str| {
        let text = fs::read_to_string(page.join(file)).unwrap();
        fs::write(page.join(file), text.replace(from, to)).unwrap();
    };
    for (name, spoil, words) in [
        (
            "none",
            &(|page: &Path| fs::remove_dir_all(page).unwrap()) as &dyn Fn(&Path),
            ["dist", "No such file"],
        ),
        (
            "incomplete",
            &|page: &Path| fs::remove_file(page.join("steadycut_bg.wasm")).unwrap(),
            ["steadycut_bg.wasm is missing", "web/build"],
        ),
        (
            "unbuilt",
            &|page: &Path| replace(page, "sw.js", BUILD, "@BUILD@"),
            ["sw.js names no build", "web/build"],
        ),
        (
            "mixed",
            &|page: &Path| replace(page, "boot.js", BUILD, "fedcba9876543210"),
            ["boot.js is of another build", BUILD],
        ),
        (
            "cut",
            &|page: &Path| fs::write(page.join("steadycut_bg.wasm"), &PROGRAM[..6]).unwrap(),
            ["has 6 bytes", "says 8"],
        ),
        (
            "old",
            &|page: &Path| replace(page, "index.html", "<!-- pack:", "<!--"),
            ["index.html has no place for a package", "another version"],
        ),
        (
            "packed",
            &|page: &Path| fs::write(page.join("lms.js"), "").unwrap(),
            ["lms.js", "brings itself"],
        ),
    ] {
        let said = refused(name, spoil);
        words.iter().for_each(|word| assert!(said.contains(word), "{said} lacks {word}"));
    }
}

#[test]
fn what_does_not_go_together_is_refused() {
    let folder = folder("wrong");
    let page = ["--page", "dist", "--out", "out.zip"];
    for (args, word) in [
        (&["quiet-speed"][..], "--scorm"),
        (&["quiet-speed", "--scorm", "--xapi"], "cannot be used with"),
        (&["quiet-speed", "quiet-speed", "--scorm"], "two missions have the id `quiet-speed`"),
        (&["quite-speed", "--scorm"], "quiet-speed"),
        (&["quiet-speed", "--scorm", "--embed", "hide:all"], "--embed: `hide:all`"),
        (&["quiet-speed", "--scorm", "--title", " "], "--title is empty"),
        (&["--scorm"], "ID|FILE"),
    ] {
        let output = pack(&folder, &[args, &page].concat());
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(word), "{said} lacks {word}");
    }
    // Nothing is written over the page that is read.
    let over = ["quiet-speed", "--scorm", "--page", "dist", "--out", "dist/index.html"];
    let output = pack(&folder, &over);
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("nothing is written over what is read"), "{said}");
}

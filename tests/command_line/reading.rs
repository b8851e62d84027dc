//! What is read: files of any name, text of any encoding that says what it is, standard input, and tables as
//! spreadsheets of any country write them.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use steadycut::models::unks::UnksStart;
use steadycut::run::edits::Edits;
use steadycut::run::one_run::Run;
use steadycut::run::{presets, scenario_file};
use steadycut::study::part::{EXAMPLE_CSV, EXAMPLE_GCODE};
use steadycut::study::unks_passes::learned;

const SHORT: &str = "workpiece.cuts=[[[4.0, 3.0, 2.0]]]";

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("reading").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs a command with a text on its standard input.
fn fed(folder: &Path, args: &[&OsStr], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_steadycut"))
        .args(args)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A command that is refused reads nothing.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Every argument that reads a file: the command up to it, and the text of a file.
fn readers() -> Vec<(Vec<&'static str>, String)> {
    let mut scenario = presets::load("experiment-2").unwrap();
    scenario.change(|s| s.workpiece.cuts = vec![vec![[4.0, 3.0, 2.0]]]).unwrap();
    let text = scenario_file::write(&scenario, &Edits::none());
    let path = "controller.kind";
    let value = steadycut::run::scenario::parse_value(path, "unks").unwrap();
    scenario.set_all(&[(path.to_owned(), value)]).unwrap();
    assert_eq!(scenario.controller.unks.start, UnksStart::Shipped);
    let networks = learned(&Run::complete(&scenario, &Edits::none()), 1).unwrap().write();
    let machine = include_str!("../../assets/machines/heller_bea_01.toml").to_owned();
    let data = include_str!("../../assets/data/cutting_data_2005.csv").to_owned();
    let table = include_str!("../../assets/data/table3_2007.csv").to_owned();
    let ask = ["recommend", "--hb", "200", "--diameter", "16", "--engagement", "2", "--table"];
    let unks = ["--set", "controller.kind=unks"];
    vec![
        (vec!["run"], text.clone()),
        (vec!["plan"], text.clone()),
        (vec!["unks", "--passes", "1"], text.clone()),
        (vec!["robust", "--runs", "1", "--scenario"], text.clone()),
        (vec!["combine", "--scenario"], text.clone()),
        (vec!["check"], text),
        (
            [&["run", "experiment-2", "--set", SHORT], &unks[..], &["--networks"]].concat(),
            networks.clone(),
        ),
        (vec!["unks", "--passes", "1", "--set", SHORT, "--load"], networks),
        (vec!["plan", "strategy-2013", "--machine"], machine.clone()),
        (vec!["combine", "--set", SHORT, "--machine"], machine),
        (vec!["combine", "--set", SHORT, "--table"], data.clone()),
        (ask.to_vec(), data),
        (vec!["identify", "tables", "--table"], table),
        (vec!["run", "first-cut", "--part"], EXAMPLE_CSV.to_owned()),
        (vec!["part", "from-csv"], EXAMPLE_CSV.to_owned()),
        (vec!["part", "from-gcode", "--blank", "100,60,20"], EXAMPLE_GCODE.to_owned()),
    ]
}

fn arguments<'a>(command: &'a [&'a str], file: &'a OsStr) -> Vec<&'a OsStr> {
    command.iter().map(OsStr::new).chain([file]).collect()
}

/// A text as UTF-16 with its mark.
fn utf_16(text: &str, unit: fn(u16) -> [u8; 2]) -> Vec<u8> {
    format!("\u{feff}{text}").encode_utf16().flat_map(unit).collect()
}

/// What differs between two reports of one text: the name of its file.
fn without_name(output: &[u8], name: &str) -> String {
    String::from_utf8_lossy(output).replace(name, "NAME")
}

#[test]
fn every_file_is_read_from_any_name_encoding_and_standard_input() {
    let folder = folder("every");
    for (command, text) in readers() {
        let read = |name: &OsStr, bytes: &[u8]| {
            fs::write(folder.join(name), bytes).unwrap();
            let output = fed(&folder, &arguments(&command, name), b"");
            assert!(output.status.success(), "{command:?} {name:?}: {}", said(&output));
            without_name(&output.stdout, &name.to_string_lossy())
        };
        let meant = read(OsStr::new("plain.txt"), text.as_bytes());
        assert!(!meant.is_empty());
        #[cfg(unix)]
        {
            let name: OsString =
                std::os::unix::ffi::OsStringExt::from_vec(b"Fr\xe4sen.txt".to_vec());
            assert_eq!(read(&name, text.as_bytes()), meant, "{command:?}");
        }
        // Lines end as they do under Windows, too.
        let marked = format!("\u{feff}{}", text.replace('\n', "\r\n"));
        for (name, bytes) in [
            ("marked.txt", marked.into_bytes()),
            ("little.txt", utf_16(&text, u16::to_le_bytes)),
            ("big.txt", utf_16(&text, u16::to_be_bytes)),
        ] {
            assert_eq!(read(OsStr::new(name), &bytes), meant, "{command:?} {name}");
        }
        let output = fed(&folder, &arguments(&command, OsStr::new("-")), text.as_bytes());
        assert!(output.status.success(), "{command:?} -: {}", said(&output));
        assert_eq!(without_name(&output.stdout, "standard input"), meant, "{command:?} -");
        for (name, bytes, parts) in [
            ("unmarked.txt", &utf_16(&text, u16::to_le_bytes)[2..], ["UTF-16", "byte order mark"]),
            ("latin.txt", &b"# Fr\xe4sen"[..], ["Latin-1", "line 1"]),
            ("sheet.txt", &b"PK\x03\x04\x14\0\0"[..], ["spreadsheet", "CSV"]),
        ] {
            fs::write(folder.join(name), bytes).unwrap();
            let output = fed(&folder, &arguments(&command, OsStr::new(name)), b"");
            assert!(!output.status.success(), "{command:?} {name}");
            let said = said(&output) + String::from_utf8_lossy(&output.stdout).as_ref();
            for part in parts.iter().chain(&[name, "save it"]).take(3) {
                assert!(said.contains(part), "{command:?} {part}: {said}");
            }
        }
    }
}

#[test]
fn standard_input_is_read_once() {
    let folder = folder("once");
    for (args, names) in [
        (&["run", "-", "--networks", "-"][..], ["PRESET|FILE|LINK", "--networks"]),
        (&["plan", "-", "--machine", "-"], ["PRESET|FILE|LINK", "--machine"]),
        (&["combine", "--table", "-", "--machine", "-"], ["--table", "--machine"]),
        (&["unks", "-", "--load", "-"], ["PRESET|FILE|LINK", "--load"]),
        (&["check", "-", "-"], ["FILE", "FILE"]),
    ] {
        let args: Vec<&OsStr> = args.iter().map(OsStr::new).collect();
        let output = fed(&folder, &args, b"version = 1\n");
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        for part in names.iter().chain(&["read only once"]) {
            assert!(said(&output).contains(part), "{args:?} {part}: {}", said(&output));
        }
    }
    // Neither a file without end nor a folder is read.
    for (name, part) in [("/dev/zero", "more than"), (".", "directory")] {
        let output = fed(&folder, &[OsStr::new("run"), OsStr::new(name)], b"");
        assert!(
            output.status.code() == Some(2) && said(&output).contains(part),
            "{}",
            said(&output)
        );
    }
}

/// A table as a spreadsheet writes it where the decimal sign is a comma.
fn european(table: &str) -> String {
    let lines = table.lines().map(|line| match line.starts_with('#') {
        true => line.to_owned(),
        false => line.replace(',', ";").replace('.', ","),
    });
    format!("\u{feff}{}\r\n", lines.collect::<Vec<_>>().join("\r\n"))
}

#[test]
fn european_tables_are_read_as_they_are_meant() {
    let folder = folder("european");
    let shipped = include_str!("../../assets/data/table3_2007.csv");
    let data = include_str!("../../assets/data/cutting_data_2005.csv");
    let identify = ["identify", "tables", "--json", "--table", "table.csv"].map(OsStr::new);
    for table in [shipped.to_owned(), european(shipped)] {
        fs::write(folder.join("table.csv"), table).unwrap();
        let output = fed(&folder, &identify, b"");
        let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(report["equals_shipped"], true);
    }
    let ask = ["recommend", "--hb", "200", "--diameter", "16", "--engagement", "2", "--table", "-"];
    let ask = ask.map(OsStr::new);
    let [meant, read] =
        [data.to_owned(), european(data)].map(|table| fed(&folder, &ask, table.as_bytes()));
    assert!(read.status.success(), "{}", said(&read));
    assert_eq!(read.stdout, meant.stdout);
    // Read in two ways: refused, with what to do.
    let both = european(shipped).replace(";1974;", ";1.974;");
    fs::write(folder.join("table.csv"), both).unwrap();
    let error = said(&fed(&folder, &identify, b""));
    assert!(error.contains("1.974") && error.contains("same decimal sign"), "{error}");
    let commas = shipped
        .lines()
        .map(|line| if line.starts_with('#') { line.to_owned() } else { line.replace('.', ",") });
    fs::write(folder.join("table.csv"), commas.collect::<Vec<_>>().join("\n")).unwrap();
    let error = said(&fed(&folder, &identify, b""));
    assert!(error.contains("line 3") && error.contains("semicolons"), "{error}");
}

#[test]
fn a_table_without_its_columns_is_told_what_was_found_and_what_is_needed() {
    let folder = folder("columns");
    for (args, needed) in [
        (&["identify", "tables", "--table", "-"][..], "feed_initial_mm_min"),
        (&["combine", "--table", "-"], "feed_per_tooth_mm"),
    ] {
        let args: Vec<&OsStr> = args.iter().map(OsStr::new).collect();
        for (text, found) in [
            ("Vorschub;Drehzahl\n1;2\n", "the columns are Vorschub, Drehzahl"),
            ("", "no line with the names"),
        ] {
            let error = said(&fed(&folder, &args, text.as_bytes()));
            for part in ["standard input: ", found, "needed are ", needed] {
                assert!(error.contains(part), "{part}: {error}");
            }
        }
    }
    let header = include_str!("../../assets/data/table3_2007.csv").lines().nth(1).unwrap();
    let args = ["identify", "tables", "--table", "-"].map(OsStr::new);
    let error = said(&fed(&folder, &args, header.as_bytes()));
    assert!(
        error.contains("0 rows; at least 4 are needed, each with sim, ra_desired_um"),
        "{error}"
    );
}

#[test]
fn the_consoles_scenario_may_have_any_name() {
    let folder = folder("console");
    #[cfg(unix)]
    let name: OsString = std::os::unix::ffi::OsStringExt::from_vec(b"Fr\xe4sen.toml".to_vec());
    #[cfg(not(unix))]
    let name = OsString::from("x.toml");
    fs::write(folder.join(&name), "version = 7\n").unwrap();
    for (name, input) in [(name.as_os_str(), &b""[..]), (OsStr::new("-"), b"version = 7\n")] {
        let output = fed(&folder, &[OsStr::new("--scenario"), name], input);
        // It was read: what is wrong with it is said before any window is opened.
        assert!(said(&output).contains("`version` is 7"), "{}", said(&output));
    }
}

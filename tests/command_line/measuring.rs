//! `steadycut measured`: what was guessed is shown, overruled and remembered, and channels come out as plain CSV.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

fn steadycut(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_steadycut")).args(args).output().unwrap()
}

fn printed(args: &[&str]) -> String {
    let output = steadycut(args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&printed(&[args, &["--json"]].concat())).unwrap()
}

/// What is said of arguments that are refused.
fn refused(args: &[&str]) -> String {
    let output = steadycut(args);
    assert_eq!(output.status.code(), Some(2), "{args:?}");
    assert!(output.stdout.is_empty(), "{args:?}");
    String::from_utf8(output.stderr).unwrap()
}

fn sample(name: &str) -> String {
    Path::new("crates/measured/tests/data").join(name).to_str().unwrap().to_owned()
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn every_format_tells_its_layout_and_channels_and_becomes_the_same_csv() {
    let folder = folder("measured-formats");
    let mut tables = Vec::new();
    for (name, format) in [
        ("excel.csv", "text"),
        ("force_v5.mat", "matlab-5"),
        ("lab.tdms", "tdms"),
        ("lab.parquet", "parquet"),
    ] {
        let csv = folder.join(format!("{name}.csv"));
        let args = ["measured", &sample(name), "--out", csv.to_str().unwrap()];
        let told = json(&args);
        assert_eq!(told["format"], format);
        let channels = told["channels"].as_array().unwrap();
        let names: Vec<&str> =
            channels.iter().map(|channel| channel["name"].as_str().unwrap()).collect();
        assert_eq!(names, ["Fx", "Fy", "Fz"]);
        for channel in channels {
            assert_eq!((&channel["rows"], &channel["rate_hz"]), (&2000.into(), &25_000.0.into()));
            let [min, mean, max] = ["min", "mean", "max"].map(|key| channel[key].as_f64().unwrap());
            assert!(min < mean && mean < max, "{channel}");
        }
        let text = printed(&args[..2]);
        for part in ["layout; overrule", "names", "time", "Fx", "25000", "2000"] {
            assert!(text.contains(part), "{part}: {text}");
        }
        let table = fs::read_to_string(&csv).unwrap();
        assert!(table.starts_with("time [s],Fx"), "{}", &table[..40]);
        tables.push(table);
    }
    // MATLAB and TDMS hold the same doubles, and say the same units.
    assert_eq!(tables[1], tables[2]);
    // What was written is read again as it was, to the bit.
    let again = json(&["measured", folder.join("lab.tdms.csv").to_str().unwrap()]);
    let tdms = json(&["measured", &sample("lab.tdms")]);
    assert_eq!(again["channels"], tdms["channels"]);
}

#[test]
fn what_is_overruled_is_remembered_beside_the_file() {
    let folder = folder("measured-remembered");
    let file = folder.join("cut.csv");
    fs::write(&file, "1,5\n2,5\n3,5\n").unwrap();
    let file = file.to_str().unwrap();
    let beside = format!("{file}.layout.toml");
    let guess = json(&["measured", file]);
    assert_eq!(guess["channels"].as_array().unwrap().len(), 2);
    assert!(guess["notes"][0].as_str().unwrap().contains("decimal=comma"), "{guess}");
    assert_eq!(guess["layout"]["separator"]["from"], "guessed");
    let said = ["--layout", "decimal=comma", "--layout", "names=F", "--layout", "rate_hz=10"];
    let told = json(&[&["measured", file], &said[..]].concat());
    assert_eq!(told["layout"]["decimal"], serde_json::json!({ "value": "comma", "from": "said" }));
    assert!(!Path::new(&beside).exists());
    printed(&[&["measured", file, "--remember"], &said[..]].concat());
    let kept = fs::read_to_string(&beside).unwrap();
    assert!(kept.contains("version = 1") && kept.contains("decimal = \"comma\""), "{kept}");
    assert!(!kept.contains("encoding"), "what was guessed stays guessed: {kept}");
    let again = json(&["measured", file]);
    assert_eq!(again["channels"], told["channels"]);
    assert_eq!(again["channels"][0]["max"], 3.5);
    assert_eq!(again["layout"]["names"]["from"], "remembered");
    assert_eq!(again["layout_file"], beside.as_str());
    // One more entry joins those that are there; what is said now counts more.
    printed(&["measured", file, "--layout", "units=kN", "--layout", "names=Fx", "--remember"]);
    let last = json(&["measured", file]);
    assert_eq!(last["channels"][0]["unit"], "kN");
    assert_eq!(last["channels"][0]["name"], "Fx");
    assert_eq!(last["channels"][0]["rate_hz"], 10.0);
    fs::write(&beside, "version = 1\nseperator = \"tab\"\n").unwrap();
    let error = refused(&["measured", file]);
    assert!(
        error.contains("cut.csv.layout.toml") && error.contains("did you mean `separator`"),
        "{error}"
    );
}

#[test]
fn a_record_is_chosen_and_its_facts_told() {
    let told = json(&[
        "measured",
        &sample("mill.mat"),
        "--variable",
        "mill[3]",
        "--layout",
        "rate_hz=250",
    ]);
    assert_eq!(told["channels"].as_array().unwrap().len(), 6);
    assert_eq!(told["contents"][0]["name"], "mill");
    let facts = told["facts"].as_array().unwrap();
    assert!(facts.contains(&serde_json::json!({ "name": "VB", "value": "0.2" })), "{facts:?}");
    let text = printed(&["measured", &sample("mill.mat")]);
    assert!(text.contains("note: record 1 of 3 in `mill`"), "{text}");
}

#[test]
fn standard_input_is_read_and_standard_output_written() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_steadycut"))
        .args(["measured", "-", "--out", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(b"\xff\xfet\0;\0F\0\n\x000\0;\x001\0\n\x001\0;\x002\0\n\0")
        .unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8(output.stdout).unwrap(), "time [s],F\n0,1\n1,2\n");
}

#[test]
fn what_cannot_be_done_is_refused_with_what_can() {
    let folder = folder("measured-refused");
    let file = folder.join("bad.csv");
    fs::write(&file, "t;F\n0,1;5\n0,2;x\n0,3;7\n0,4;8\n0,5;9\n").unwrap();
    let file = file.to_str().unwrap();
    let excel = sample("excel.csv");
    for (args, parts) in [
        (
            &["measured", file][..],
            ["bad.csv: line 3, column 2 (F): `x`", "a number with a decimal comma"],
        ),
        (
            &["measured", &excel, "--layout", "decimals=comma"],
            ["did you mean `decimal`", "separator"],
        ),
        (&["measured", &excel, "--layout", "decimal=x"], ["`decimal` cannot be x", "point, comma"]),
        (&["measured", &excel, "--layout", "decimal"], ["KEY=VALUE", ""]),
        (&["measured", &excel, "--variable", "x"], ["`variable` means nothing", "text"]),
        (&["measured", &excel, "--remember"], ["--remember: nothing was overruled", ""]),
        (&["measured", "-", "--remember", "--layout", "decimal=comma"], ["", "--remember"]),
        (&["measured", "nowhere.csv"], ["nowhere.csv", "No such file"]),
        (&["measured", &excel, "--json", "--out", "-"], ["--json", "standard output"]),
        (&["measured", &excel, "--out", &excel], ["nothing is written over what is read", ""]),
    ] {
        let error = refused(args);
        for part in parts {
            assert!(error.contains(part), "{args:?}: {part}: {error}");
        }
    }
    let beside = format!("{file}.layout.toml");
    fs::write(file, "t;F\n0,1;5\n0,2;6\n").unwrap();
    fs::write(&beside, "version = 1\n").unwrap();
    let error =
        refused(&["measured", file, "--layout", "names=t,F", "--remember", "--out", &beside]);
    assert!(error.contains("two results need two files"), "{error}");
    assert_eq!(fs::read_to_string(&beside).unwrap(), "version = 1\n");
}

#[test]
fn forces_are_turned_filtered_and_peaked_as_controllers_see_them() {
    let excel = sample("excel.csv");
    let plain = json(&["measured", &excel]);
    let turned = json(&["measured", &excel, "--rotate", "Fx,Fy,90"]);
    let of =
        |told: &Value, channel: usize, key: &str| told["channels"][channel][key].as_f64().unwrap();
    for (from, to) in [("min", "min"), ("max", "max"), ("mean", "mean")] {
        // X turned by a quarter is Y, and Y is minus X.
        assert!((of(&plain, 0, from) - of(&turned, 1, to)).abs() < 1e-9);
    }
    assert!((of(&plain, 1, "max") + of(&turned, 0, "min")).abs() < 1e-9);
    // 200 |sin| and 80 sin in N: together sqrt(200^2 + 80^2) = 215.4 N, and the noise of 1 N above it.
    let peaks = json(&["measured", &excel, "--peak", "Fx,Fy", "--period", "0.02"]);
    assert_eq!(peaks["channels"][0]["rows"], 4);
    assert_eq!(peaks["channels"][0]["rate_hz"], 50.0);
    assert!(of(&peaks, 0, "min") > 215.0 && of(&peaks, 0, "max") < 220.0, "{peaks}");
    // Below 40 Hz, little is left of the arches of 210 Hz, and their mean of 200 2/pi N stays.
    let slow = json(&["measured", &excel, "--low-pass", "40"]);
    assert!(of(&slow, 0, "max") < 150.0 && of(&plain, 0, "max") > 200.0, "{slow}");
    assert!((of(&slow, 0, "mean") - of(&plain, 0, "mean")).abs() < 5.0, "{slow}");
    let zeroed = json(&["measured", &excel, "--zero", "0..0.0796"]);
    assert!(of(&zeroed, 0, "mean").abs() < 1.0, "{zeroed}");
    for (args, part) in [
        (&["--peak", "Fx,Fy"][..], "--period"),
        (&["--drift", "0..1"], "--zero"),
        (&["--rotate", "Fx,Fy"], "X,Y,DEG"),
        (&["--zero", "1..0"], "FROM..TO"),
        (&["--low-pass", "20000"], "below 10000 Hz"),
        (&["--rotate", "Fx,Fq,5"], "no channel `Fq`"),
        (&["--zero", "5..6"], "no sample from 5 to 6 s"),
    ] {
        let error = refused(&[&["measured", &excel], args].concat());
        assert!(error.contains(part), "{args:?}: {error}");
    }
}

#[test]
fn a_channel_is_aligned_with_a_run_in_time_and_size() {
    let folder = folder("measured-aligned");
    let trace = folder.join("trace.csv");
    printed(&["run", "depth-step", "--out", trace.to_str().unwrap()]);
    let text = fs::read_to_string(&trace).unwrap();
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let force =
        lines.next().unwrap().iter().position(|title| title.starts_with("force_n ")).unwrap();
    // As a dynamometer would have it that was switched on 0.75 s before the run, and is 10 % off.
    let mut measured = "t [s];F [N]\n".to_owned();
    for k in 0..750 {
        measured += &format!("{};10\n", f64::from(k) / 1000.0);
    }
    for (k, line) in lines.enumerate() {
        let force_n: f64 = line[force].parse().unwrap();
        let noise = ((k * 7919) % 1000) as f64 / 500.0 - 1.0;
        measured +=
            &format!("{:.3};{:.3}\n", 0.75 + k as f64 / 1000.0, 10.0 + 0.9 * force_n + noise);
    }
    let file = folder.join("cut.csv");
    fs::write(&file, measured.replace('.', ",")).unwrap();
    let out = folder.join("aligned.csv");
    let args = ["measured", file.to_str().unwrap(), "--align", "depth-step", "--pair", "F=force_n"];
    let told = json(&[&args[..], &["--out", out.to_str().unwrap()]].concat());
    let of = |key: &str| told["aligned"][key].as_f64().unwrap();
    assert!((of("shift_s") - 0.75).abs() < 1e-3, "{told}");
    assert!((of("scale") - 0.9).abs() < 0.005 && (of("offset") - 10.0).abs() < 1.0, "{told}");
    assert!(of("correlation") > 0.97 && of("rest") < 1.0, "{told}");
    assert!(printed(&args).contains("shift               +0.75"));
    assert!(
        fs::read_to_string(&out).unwrap().starts_with("time [s],F [N],time 2 [s],force_n [N]\n")
    );
    for (pair, part) in
        [("F=force", "no signal `force`"), ("G=force_n", "no channel `G`; there are F")]
    {
        let error =
            refused(&["measured", file.to_str().unwrap(), "--align", "depth-step", "--pair", pair]);
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn a_drive_is_identified_in_the_step_of_a_run_and_written_as_a_file() {
    let folder = folder("measured-drive");
    let trace = folder.join("trace.csv");
    printed(&["run", "table3-5", "--out", trace.to_str().unwrap()]);
    let file = folder.join("drive.toml");
    let columns =
        ["--command", "feed_command_mm_min", "--feed", "feed_mm_min", "--within", "0..1.5"];
    let args = [&["identify", "drive", "--data", trace.to_str().unwrap()], &columns[..]].concat();
    // Names keep their units, which stand behind them in brackets.
    let told = json(&[&args[..], &["--out", file.to_str().unwrap()]].concat());
    let best = &told["fits"][0];
    // 2007 eq. 3 with its dead time: 80 ms, and a lag of 1/14 s.
    let value = |key: &str| best[key]["value"].as_f64().unwrap();
    assert_eq!(best["structure"], "first", "{best}");
    assert!(
        (value("dead_time_s") - 0.08).abs() < 1e-4 && (value("lag_s") - 1.0 / 14.0).abs() < 1e-4
    );
    assert!((value("gain") - 1.0).abs() < 1e-4);
    assert_eq!(told["fits"].as_array().unwrap().len(), 4);
    let text = fs::read_to_string(&file).unwrap();
    let table: toml::Table = text.parse().unwrap();
    assert_eq!(table["version"].as_integer(), Some(1));
    assert!((table["poles"][0][0].as_float().unwrap() + 14.0).abs() < 0.01, "{text}");
    assert!(printed(&args).contains("first order, BIC"));
    for (args, part) in [
        (&["--feed", "feed"][..], "--command"),
        (&["--feed", "feed", "--step", "0,1,2"], "no channel `feed`; there are position_mm"),
        (&["--feed", "feed_mm_min", "--step", "0,1"], "AT_S,FROM,TO"),
        (&["--feed", "feed_mm_min", "--step", "99,1,2"], "never changes"),
    ] {
        let error =
            refused(&[&["identify", "drive", "--data", trace.to_str().unwrap()], args].concat());
        assert!(error.contains(part), "{args:?}: {error}");
    }
}

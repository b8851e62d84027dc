//! The command line as its user meets it.

use steadycut::base::settings::Value;
use steadycut::run::edits::{Edit, Edits};
use steadycut::run::job::Job;
use steadycut::run::one_run::Run;
use steadycut::run::presets::load;
use steadycut::run::scenario_link;

use super::program::{json, refused, steadycut, temporary};

#[test]
fn run_prints_one_json_object_with_the_promised_keys() {
    let report = json(&["run", "table3-5", "--json"]);
    for key in [
        "ra_final_um",
        "ra_deviation_percent",
        "in_tolerance_percent",
        "force_final_n",
        "force_deviation_percent",
        "feed_final_mm_min",
        "spindle_final_rpm",
        "normalized_standard_error",
        "settling_time_s",
        "overshoot_percent",
        "time_of_cut_s",
        "max_force_n",
        "ticks",
        "digest",
    ] {
        assert!(report.get(key).is_some(), "`{key}` is missing");
    }
    assert_eq!(report["ticks"], 15000);
    // The command line and the library run the same bits.
    let run = Run::complete(&load("table3-5").unwrap(), &Edits::none());
    assert_eq!(report["digest"], run.recording().digest());
}

#[test]
fn a_deviation_of_ra_names_what_it_is_one_of() {
    // A target that an edit moves, and one that belongs to a force that is held, are not that of the settings.
    let scenario = load("table3-5").unwrap();
    let mut edits = Edits::none();
    let (path, value) = ("target.ra_um".to_owned(), Value::Float(0.6));
    edits.push(&scenario, Edit { at_s: 5.0, path, value }).unwrap();
    let edited = scenario_link::write(&scenario, &edits);
    let held = temporary("deviation_held.csv");
    let told = |args: &[&str]| {
        let text = String::from_utf8(steadycut(args).stdout).unwrap();
        let line = text.lines().find(|line| line.trim().starts_with("deviation")).unwrap();
        line.split(" of ").nth(1).unwrap().to_owned()
    };
    assert_eq!(told(&["run", &edited]), "0.6 um");
    let of = told(&["run", "combined-2005", "--out", held.to_str().unwrap()]);
    let table = std::fs::read_to_string(&held).unwrap();
    let column =
        table.lines().next().unwrap().split(',').position(|name| name == "ra_target_um [um]");
    let last = table.lines().last().unwrap().split(',').nth(column.unwrap()).unwrap();
    let [of, last] = [of.trim_end_matches(" um"), last].map(|text| text.parse::<f64>().unwrap());
    assert!((of - last).abs() < 1e-3, "{of} and {last}");
}

#[test]
fn a_link_of_the_console_repeats_its_run() {
    let link = scenario_link::write(&load("table3-5").unwrap(), &Edits::none());
    let wanted = json(&["run", "table3-5", "--json"])["digest"].clone();
    for link in [link.clone(), format!("#{link}"), format!("https://example.org/cut/#{link}")] {
        assert_eq!(json(&["run", &link, "--json"])["digest"], wanted, "{link}");
    }
    let error = refused(&["run", "https://example.org/#v=1&target.ra_um=9"]);
    assert!(error.contains("target.ra_um") && error.contains('9'), "{error}");
}

#[test]
fn the_end_of_a_run_is_an_id_with_its_details_beside_it() {
    let ends = json(&["list", "--json"])["ends"].clone();
    let ids: Vec<&str> =
        ends.as_array().unwrap().iter().map(|end| end["id"].as_str().unwrap()).collect();
    let of = |args: &[&str]| {
        let report = json(&[&["run"], args, &["--json"]].concat());
        let end = report["end"].as_str().unwrap().to_owned();
        assert!(ids.contains(&end.as_str()), "{end}");
        assert!(!report["end_text"].as_str().unwrap().is_empty());
        (end, report["end_details"].clone())
    };
    let whole = ["--set", "workpiece.length_mm=5"];
    assert_eq!(
        of(&[&["table3-5"], &whole[..]].concat()),
        ("path_done".to_owned(), serde_json::Value::Null)
    );
    assert_eq!(of(&["table3-5"]), ("time_limit".to_owned(), serde_json::Value::Null));
    let stop = ["--set", "cnc.force_stop=true", "--set", "cnc.force_stop_n=100"];
    let (end, details) = of(&[&["table3-5"], &stop[..]].concat());
    assert_eq!(end, "overload");
    assert_eq!(details["limit_n"], 100.0);
    assert!(details["force_n"].as_f64().unwrap() > 100.0, "{details}");
    for key in ["position_mm", "time_s"] {
        assert!(details[key].is_f64(), "{details}");
    }
}

#[test]
fn set_and_out_work_together() {
    let file = temporary("trace.csv");
    let args = ["run", "table3-5", "--set", "run.duration_s=2", "--set", "target.ra_um=0.6"];
    let output = steadycut(&[&args[..], &["--out", file.to_str().unwrap()]].concat());
    assert!(output.status.success());
    let text = std::fs::read_to_string(&file).unwrap();
    assert_eq!(text.lines().count(), 2002, "a header, the start and 2000 steps");
    let header = text.lines().next().unwrap();
    assert!(header.contains("force_n [N]") && header.contains("feed_mm_min [mm/min]"));
    let shown = String::from_utf8(output.stdout).unwrap();
    assert!(shown.contains("of 0.6 um"), "{shown}");
}

#[test]
fn a_scenario_file_runs_like_its_preset() {
    let file = temporary("scenario.toml");
    let scenario = load("depth-step").unwrap();
    let text = steadycut::run::scenario_file::write(&scenario, &Edits::none());
    std::fs::write(&file, text).unwrap();
    let from_file = json(&["run", file.to_str().unwrap(), "--json"]);
    let from_preset = json(&["run", "depth-step", "--json"]);
    assert_eq!(from_file["digest"], from_preset["digest"]);
    assert!(steadycut(&["check", file.to_str().unwrap()]).status.success());
}

#[test]
fn papers_prints_rows_named_like_the_table() {
    let paper = json(&["papers", "--paper", "2007", "--json"]);
    assert_eq!((&paper["paper"], &paper["calibration"]), (&"2007".into(), &"identified".into()));
    let rows = paper["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 10);
    assert_eq!(rows[0]["sim"], 1);
    assert_eq!(rows[0]["force_final_n"]["printed"], 166.5);
    assert!(rows[0]["force_final_n"]["reproduced"].as_f64().unwrap() > 166.0);
    assert!(rows[9]["note"].as_str().unwrap().contains("190.2"));
    assert_eq!(paper["errata"].as_array().unwrap().len(), 12);
    for calibration in ["printed", "restored"] {
        let paper = json(&["papers", "--paper", "2007", "--calibration", calibration, "--json"]);
        assert_eq!(paper["calibration"], calibration);
    }
    let text = steadycut(&["papers", "--paper", "2007"]).stdout;
    assert!(String::from_utf8(text).unwrap().contains("40 of 40 cells within their bands"));
}

#[test]
fn papers_refuses_what_only_the_comparison_of_2005_has() {
    let error = refused(&["papers", "--paper", "2007", "--robustness"]);
    assert!(error.contains("only `--paper 2005`"), "{error}");
    let error = refused(&["papers", "--paper", "2005", "--seeds", "0"]);
    assert!(error.contains("1..=1000"), "{error}");
}

#[test]
fn papers_2013_prints_eight_rows_and_reports_other_calibrations_as_they_are() {
    let paper = json(&["papers", "--paper", "2013", "--json"]);
    assert_eq!((&paper["paper"], &paper["plant"]), (&"2013".into(), &"formula".into()));
    let rows = paper["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 8);
    assert_eq!(rows[0]["force_start_n"]["printed"], 164.5);
    assert_eq!(rows[0]["force_start_n"]["verdict"], "reported");
    let text = steadycut(&["papers", "--paper", "2013"]).stdout;
    assert!(String::from_utf8(text).unwrap().contains("32 of 32 cells within their bands"));
    let printed = json(&["papers", "--paper", "2013", "--calibration", "printed", "--json"]);
    assert_eq!(printed["rows"][0]["feed_final_mm_min"]["verdict"], "missed");
    let text = steadycut(&["papers", "--paper", "2013", "--calibration", "printed"]).stdout;
    let text = String::from_utf8(text).unwrap();
    assert!(text.contains("m2_outside") && !text.contains("k2_outside"), "{text}");
}

#[test]
fn identify_reproduces_the_shipped_models_of_2013() {
    let file = temporary("identified_2013.toml");
    let args = ["identify", "tables", "--paper", "2013"];
    let output = steadycut(&[&args[..], &["--out", file.to_str().unwrap()]].concat());
    assert!(output.status.success());
    let written = std::fs::read_to_string(&file).unwrap();
    assert_eq!(written, include_str!("../../assets/models/identified_2013.toml"));
    assert_eq!(json(&[&args[..], &["--json"]].concat())["equals_shipped"], true);
}

#[test]
fn identify_reproduces_the_shipped_model_file() {
    let file = temporary("identified.toml");
    let output = steadycut(&["identify", "tables", "--out", file.to_str().unwrap()]);
    assert!(output.status.success());
    let written = std::fs::read_to_string(&file).unwrap();
    assert_eq!(written, include_str!("../../assets/models/identified_2007.toml"));
    let report = json(&["identify", "tables", "--json"]);
    assert_eq!(report["equals_shipped"], true);
    // spec: the quadratic fits the twenty points with 0.26 N rms, K4 is 0.75 N off at worst.
    assert!((report["fits"][0]["rms"].as_f64().unwrap() - 0.26).abs() < 0.01);
    assert!(report["fits"][3]["worst"].as_f64().unwrap() < 0.755);
}

#[test]
fn identify_reproduces_the_shipped_models_of_the_milling_simulator() {
    let file = temporary("identified_milling_2005.toml");
    let output = steadycut(&["identify", "milling", "--out", file.to_str().unwrap()]);
    assert!(output.status.success());
    let written = std::fs::read_to_string(&file).unwrap();
    assert_eq!(written, include_str!("../../assets/models/identified_milling_2005.toml"));
    let report = json(&["identify", "milling", "--json"]);
    assert_eq!(report["equals_shipped"], true);
    assert!(report["fits"][0]["worst"].as_f64().unwrap() < 0.5, "K2 in mm/min");
    assert!(report["fits"][1]["rms"].as_f64().unwrap() < 30.0, "K4 in N");
    let error = refused(&["identify", "milling", "--table", "any.csv"]);
    assert!(error.contains("--table"), "{error}");
}

#[test]
fn identify_follows_the_table_that_it_is_given() {
    let file = temporary("table.csv");
    let table = include_str!("../../assets/data/table3_2007.csv").replace("264.92", "284.92");
    std::fs::write(&file, &table).unwrap();
    let report = json(&["identify", "tables", "--table", file.to_str().unwrap(), "--json"]);
    assert_eq!(report["equals_shipped"], false);
    std::fs::write(&file, table.replace("0.51", "NaN")).unwrap();
    let error = refused(&["identify", "tables", "--table", file.to_str().unwrap()]);
    assert!(error.contains("line 4: `ra_desired_um` cannot be `NaN`"), "{error}");
}

#[test]
fn list_names_everything() {
    let list = json(&["list", "--json"]);
    assert!(list["presets"].as_array().unwrap().len() >= 13);
    assert!(list["materials"].as_array().unwrap().len() >= 8);
    assert_eq!(list["drives"].as_array().unwrap().len(), 5);
    let settings = list["settings"].as_array().unwrap();
    for setting in settings {
        for key in ["path", "label", "unit", "doc", "default", "kind"] {
            assert!(setting.get(key).is_some(), "{setting}: `{key}`");
        }
    }
    let text = String::from_utf8(steadycut(&["list"]).stdout).unwrap();
    for setting in settings {
        assert!(text.contains(setting["path"].as_str().unwrap()));
    }
}

#[test]
fn the_diagram_is_listed_with_every_box_wire_signal_and_source() {
    let diagram = json(&["list", "--diagram", "--json"]);
    let text = String::from_utf8(steadycut(&["list", "--diagram"]).stdout).unwrap();
    let ids: Vec<&str> =
        diagram["blocks"].as_array().unwrap().iter().map(|b| b["id"].as_str().unwrap()).collect();
    assert_eq!(ids.len(), 11);
    for block in diagram["blocks"].as_array().unwrap() {
        for key in ["inputs", "outputs", "printed", "settings"] {
            assert!(!block[key].as_array().unwrap().is_empty(), "{key} of {block}");
        }
        for equation in block["printed"].as_array().unwrap() {
            for key in ["formula", "source"] {
                assert!(text.contains(equation[key].as_str().unwrap()), "{equation}");
            }
        }
        assert!(text.contains(block["title"].as_str().unwrap()), "{block}");
    }
    let wires = diagram["wires"].as_array().unwrap();
    for wire in wires {
        let ends = [&wire["from"]].into_iter().chain(wire["to"].as_array().unwrap());
        for end in ends.filter(|end| !end.is_null()) {
            assert!(ids.contains(&end.as_str().unwrap()), "{wire}");
        }
        assert!(text.contains(wire["name"].as_str().unwrap()), "{wire}");
    }
}

#[test]
fn bad_input_is_answered_by_name() {
    let error = refused(&["run", "table3-11"]);
    assert!(error.contains("table3-11") && error.contains("depth-step"), "{error}");
    let error = refused(&["run", "table3-5", "--set", "target.ra_um=NaN"]);
    assert!(error.contains("target.ra_um") && error.contains("NaN"), "{error}");
    let error = refused(&["run", "table3-5", "--set", "target.ra_um"]);
    assert!(error.contains("PATH=VALUE"), "{error}");
    let error = refused(&["run", "table3-5", "--set", "target.raum=1"]);
    assert!(error.contains("did you mean"), "{error}");
    let error = refused(&["run", "missing.toml"]);
    assert!(error.contains("missing.toml"), "{error}");
    let error = refused(&["run", "table3-5", "--out", "no/such/folder/x.csv"]);
    assert!(error.contains("no/such/folder/x.csv"), "{error}");
    let file = temporary("bad.toml");
    std::fs::write(&file, "version = 1\n[target]\nra_um = -1\n").unwrap();
    let error = refused(&["check", file.to_str().unwrap()]);
    assert!(error.contains("target.ra_um") && error.contains("-1"), "{error}");
}

#[test]
fn the_forces_within_a_revolution_are_printed_as_csv() {
    let output = steadycut(&["run", "experiment-2", "--revolution", "2.5"]);
    assert!(output.status.success());
    let text = String::from_utf8(output.stdout).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap();
    assert_eq!(header, "time_s [s],angle_deg [deg],fx_n [N],fy_n [N],fz_n [N],fxy_n [N]");
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect();
    assert_eq!(rows.len(), 1086, "60 s / 1591.55 at 28.8 kHz");
    assert!(rows.iter().all(|row| row.len() == 6 && row[0] <= 2.5));
    let refused = refused(&["run", "table3-5", "--revolution", "2.5"]);
    assert!(refused.contains("plant.force_model"), "{refused}");
    let refused = self::refused(&["run", "table3-5", "--revolution", "99"]);
    assert!(refused.contains("from 0 to 15 s"), "{refused}");
}

#[test]
fn networks_learned_in_passes_are_saved_and_loaded() {
    let (first, second) = (temporary("unks-1.json"), temporary("unks-2.json"));
    let [one, two] = [first.to_str().unwrap(), second.to_str().unwrap()];
    let short = ["--set", "run.duration_s=6", "--json"];
    let unks = |more: &[&str]| json(&[&["unks"], more, &short[..]].concat());
    let both = unks(&["--cold", "--passes", "2", "--save", two]);
    unks(&["--cold", "--passes", "1", "--save", one]);
    let again = unks(&["--load", one, "--passes", "1", "--save", two]);
    let error = |report: &serde_json::Value, pass: usize| {
        report["passes"][pass]["normalized_standard_error"].as_f64().unwrap()
    };
    assert_eq!(error(&again, 0), error(&both, 1));
    assert_ne!(error(&both, 0), error(&both, 1));
    let run = |more: &[&str]| json(&[&["run", "experiment-2"], more, &short[..]].concat());
    let loaded = run(&["--networks", one]);
    assert_eq!(
        loaded["normalized_standard_error"],
        again["passes"][0]["normalized_standard_error"]
    );

    let still = unks(&["--cold", "--passes", "2", "--rate", "0"]);
    assert_eq!(still["verdict"]["unchanged"], true);
    for (args, named) in [
        (["unks", "--rate", "1"], "`controller.unks.cold_rate`"),
        (["unks", "--load", "missing.json"], "missing.json"),
        (["unks", "--passes", "0"], "1..=50"),
    ] {
        let error = refused(&[&args[..], &["--cold"]].concat());
        assert!(error.contains(named), "{args:?}: {error}");
    }
    let error = refused(&["run", "first-cut", "--networks", one]);
    assert!(error.contains("`controller.kind` is sdnrp"), "{error}");
    std::fs::write(&first, "{}").unwrap();
    let error = refused(&["run", "experiment-2", "--networks", one]);
    assert!(error.contains("unks-1.json") && error.contains("missing field `version`"), "{error}");
}

#[test]
fn a_schedule_is_printed_and_written() {
    let file = temporary("schedule.toml");
    let report = json(&["plan", "experiment-2", "--per-cut", "heaviest", "--json"]);
    let args = ["plan", "experiment-2", "--per-cut", "heaviest", "--out", file.to_str().unwrap()];
    let output = steadycut(&args);
    assert!(output.status.success());
    assert!(String::from_utf8(output.stdout).unwrap().contains("program.cut_feeds_mm_min = ["));
    let text = std::fs::read_to_string(&file).unwrap();
    let (written, _) = steadycut::run::scenario_file::parse(&text).unwrap();
    let feeds = serde_json::to_value(&written.program.cut_feeds_mm_min).unwrap();
    assert_eq!(feeds, report["cut_feeds_mm_min"]);
    assert!(refused(&["plan", "table3-5", "--per-cut", "lightest"]).contains("workpiece.cuts"));
    assert!(refused(&["plan", "experiment-2", "--per-cut", "middle"]).contains("lightest"));
}

#[test]
fn the_study_of_robustness_gives_the_same_on_any_number_of_threads() {
    let args = ["robust", "--controller", "preview", "--runs", "3", "--seed", "5", "--json"];
    let cut = ["--set", "workpiece.cuts=[[[6.0, 3.0, 2.0]]]"];
    let report = json(&[&args[..], &cut].concat());
    assert_eq!(report["findings"]["runs"], 3);
    assert_eq!(report["findings"]["passed"], true);
    // The job of the library, one run after the other.
    let mut scenario = load("experiment-2").unwrap();
    scenario.change(|s| s.workpiece.cuts = vec![vec![[6.0, 3.0, 2.0]]]).unwrap();
    let kind = steadycut::blocks::control::ControllerKind::Preview;
    let mut study = steadycut::study::robust::Robustness::new(&scenario, kind, 3, 5);
    study.to_end();
    assert_eq!(report["outcomes"], serde_json::to_value(study.outcomes()).unwrap());
    assert!(refused(&["robust", "--controller", "best"]).contains("preview"));
}

#[test]
fn machine_prints_modes_and_the_whole_sweep() {
    let sweep = json(&["machine", "frf", "--json"]);
    let sweep = sweep.as_array().unwrap();
    assert_eq!(sweep.len(), 301);
    for (i, row) in sweep.iter().enumerate() {
        assert_eq!(row["f_hz"], 10.0 * i as f64);
        for key in ["h33", "hww", "h3w", "grel"] {
            assert!(row[format!("{key}_re")].is_f64() && row[format!("{key}_im")].is_f64());
        }
    }
    assert_eq!(sweep[0]["grel_im"], 0.0);
    let first = |args: &[&str]| {
        let modes = json(&[&["machine", "modes", "--json"], args].concat());
        modes["undamped"][1]["frequency_hz"].as_f64().unwrap()
    };
    assert!((first(&[]) - 154.485_631).abs() < 1e-5);
    assert!((first(&["--set", "machine.variant=B"]) - 122.600_809).abs() < 1e-5);
    assert!(first(&["--parameters", "T"]) != first(&[]));
    let sharp = json(&["machine", "frf", "--json", "--set", "machine.spindle_quality=17"]);
    assert!((sharp[11]["grel_im"].as_f64().unwrap() / -2.080_003e-6 - 1.0).abs() < 1e-6);

    let file = temporary("frf.csv");
    let shown = steadycut(&["machine", "frf", "--out", file.to_str().unwrap()]);
    assert!(shown.status.success() && shown.stdout.is_empty());
    assert_eq!(std::fs::read_to_string(&file).unwrap().lines().count(), 303);
}

#[test]
fn machine_refuses_what_it_cannot_do() {
    let text = refused(&["machine", "modes", "--set", "machine.spindle_quality=0"]);
    assert!(text.contains("machine.spindle_quality") && text.contains("from 1 to 100"), "{text}");
    let text = refused(&["machine", "frf", "--parameters", "E"]);
    assert!(text.contains("D, T, printed"), "{text}");
    let text = refused(&["machine", "stability", "--parameters", "printed"]);
    assert!(text.contains("overdamped"), "{text}");
    let text = refused(&["machine", "stability", "--from", "3000", "--to", "2000"]);
    assert!(text.contains("below"), "{text}");
}

#[test]
fn papers_2019_lists_table_errata_and_what_cannot_be_reproduced() {
    let report = json(&["papers", "--paper", "2019", "--json"]);
    assert_eq!(report["rows"].as_array().unwrap().len(), 5);
    assert!(report["errata"].as_array().unwrap().len() >= 17);
    let text = String::from_utf8(steadycut(&["papers", "--paper", "2019"]).stdout).unwrap();
    assert!(text.contains("no published curve") && text.contains("unstable"), "{text}");
}

#[test]
fn story_tells_what_happens_in_sentences_and_as_fields() {
    let report = json(&["run", "depth-step", "--story", "--json"]);
    let story = report["story"].as_array().unwrap();
    let step = story.iter().find(|event| event["id"] == "depth_step").unwrap();
    let effect = &step["figures"];
    assert_eq!(effect["causes"][0]["to_mm"], 2.3);
    let sentence = step["sentence"].as_str().unwrap();
    assert!(sentence.starts_with("The part gets 0.30 mm deeper here"), "{sentence}");
    assert!(effect["response"]["settling_time_s"].as_f64().is_some_and(|s| s > 0.1 && s < 2.0));
    assert!((step["position_mm"].as_f64().unwrap() - 45.0).abs() < 0.1);
    let printed = steadycut(&["run", "depth-step", "--story"]);
    let printed = String::from_utf8(printed.stdout).unwrap();
    assert!(printed.contains(sentence) && printed.contains("remaining error"), "{printed}");
    assert!(json(&["run", "depth-step", "--json"]).get("story").is_none());
}

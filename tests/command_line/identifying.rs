//! `steadycut identify gp`.

use super::program::{json, refused, steadycut, temporary};

const K4: &str = "crates/study/tests/data/gp/k4_clean.csv";
const COLUMNS: [&str; 4] = ["--target", "force_n", "--inputs", "feed_mm_min,speed_rpm"];

fn gp<'a>(data: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["identify", "gp", "--data", data], &COLUMNS[..], more].concat()
}

#[test]
fn a_front_is_printed_and_a_search_goes_on_from_its_file() {
    let state = temporary("search.json");
    let state = state.to_str().unwrap();
    let whole = json(&gp(K4, &["--batches", "4", "--seed", "2", "--json"]));
    for entry in whole["front"].as_array().unwrap() {
        assert!(entry["formula"].is_string() && entry["size"].is_u64(), "{entry}");
        assert!(entry["error"].is_f64() && entry["loo_error"].is_f64(), "{entry}");
    }
    let chosen = |report: &serde_json::Value| {
        let front = report["front"].as_array().unwrap();
        front.iter().filter(|entry| entry["chosen"] == true).count()
    };
    assert_eq!(chosen(&whole), 1);
    assert_eq!(whole["batches"], 4);
    json(&gp(K4, &["--batches", "2", "--seed", "2", "--state", state, "--json"]));
    let on = json(&gp(K4, &["--batches", "4", "--seed", "2", "--resume", state, "--json"]));
    assert_eq!(on, whole);
    let text = steadycut(&gp(K4, &["--batches", "2", "--seed", "2"]));
    let text = String::from_utf8(text.stdout).unwrap();
    for part in ["95 % interval", "extrapolation", "digest", "left out"] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn what_cannot_be_told_is_refused() {
    let table = "assets/data/table3_2007.csv";
    let columns = ["--target", "force_final_n", "--inputs", "feed_final_mm_min,spindle_final_rpm"];
    let error = refused(&[&["identify", "gp", "--data", table], &columns[..]].concat());
    assert!(error.contains("-0.995") && error.contains("one line"), "{error}");
    let error = refused(&gp(K4, &["--units", "strict", "--unit", "feed=mm"]));
    assert!(error.contains("`feed`"), "{error}");
    let error = refused(&gp(K4, &["--units", "strict", "--unit", "force_n=furlong"]));
    assert!(error.contains("furlong"), "{error}");
}

#[test]
fn any_formula_of_the_front_becomes_a_model_file() {
    use steadycut::models::formula_model::FormulaModel;
    let file = temporary("found.toml");
    let path = file.to_str().unwrap();
    let front = json(&gp(K4, &["--batches", "2", "--out", path, "--json"]));
    let model = FormulaModel::parse(&std::fs::read_to_string(&file).unwrap()).unwrap();
    let chosen = front["front"].as_array().unwrap().iter().find(|entry| entry["chosen"] == true);
    assert_eq!(model.formula().to_string(), chosen.unwrap()["formula"].as_str().unwrap());
    assert_eq!((model.output().unit.to_string(), model.inputs().len()), ("N".to_owned(), 2));
    assert!(model.inputs()[0].range.low > 150.0);
    let size = front["front"][1]["size"].to_string();
    json(&gp(K4, &["--batches", "2", "--out", path, "--size", &size, "--json"]));
    let model = FormulaModel::parse(&std::fs::read_to_string(&file).unwrap()).unwrap();
    assert_eq!(model.formula().to_string(), front["front"][1]["formula"].as_str().unwrap());
    let error = refused(&gp(K4, &["--batches", "2", "--out", path, "--size", "1000"]));
    assert!(error.contains("--size 1000") && error.contains(&size), "{error}");
}

/// The file carries how sure its constants are; another file without that has no band.
#[test]
fn a_model_file_gives_its_band_on_a_table() {
    let (file, table) = (temporary("banded.toml"), temporary("banded.csv"));
    let path = file.to_str().unwrap();
    json(&gp(K4, &["--batches", "2", "--out", path, "--json"]));
    std::fs::write(&table, "feed_mm_min,speed_rpm\n300,1500\n5000,1500\n").unwrap();
    let data = ["--data", table.to_str().unwrap()];
    let told = json(&[&["formula", path], &data[..], &["--json"]].concat());
    let number = |name: &str| told[name][0].as_f64().unwrap();
    assert!(number("low") < number("predicted") && number("predicted") < number("high"), "{told}");
    assert!(told["low"][1].is_null(), "no band beyond the ranges: {told}");
    let output = steadycut(&[&["formula", path], &data[..]].concat());
    let text = String::from_utf8(output.stdout).unwrap();
    let header = "feed_mm_min,speed_rpm,predicted,low,high,extrapolated";
    assert_eq!(text.lines().next(), Some(header));
    assert!(text.lines().nth(2).unwrap().ends_with(",,,yes"), "{text}");
    let model = std::fs::read_to_string(&file).unwrap();
    let (old, _) = model.split_once("[fit]").unwrap();
    std::fs::write(&file, old).unwrap();
    let output = steadycut(&[&["formula", path], &data[..]].concat());
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().next(), Some("feed_mm_min,speed_rpm,predicted,extrapolated"));
}

#[test]
fn a_declared_structure_takes_the_place_of_a_search() {
    let table = "assets/data/table3_2007.csv";
    let columns = ["--target", "force_final_n", "--inputs", "feed_final_mm_min,spindle_final_rpm"];
    let law = "a + b*spindle_final_rpm^3 + c*ln(0.039*feed_final_mm_min)/feed_final_mm_min";
    let more = ["--template", law, "--json"];
    let report = json(&[&["identify", "gp", "--data", table], &columns[..], &more].concat());
    assert_eq!(report["batches"], 0);
    assert_eq!(report["front"][0]["constants"].as_array().unwrap().len(), 3);
    assert_eq!(report["outliers"][0]["row"], 10);
    let error = refused(&gp(K4, &["--template", "a + speed_rpm^3 + T(feed_mm_min)"]));
    assert!(error.contains("--template") && error.contains("speed_rpm^3"), "{error}");
}

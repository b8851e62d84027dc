//! `steadycut experiment`: plans, sheets, cuts, and the way.

use std::fs;

use super::program::{json, refused, steadycut, temporary};

const FRACTION: [&str; 11] = [
    "experiment",
    "--factor",
    "feed",
    "--factor",
    "speed",
    "--factor",
    "axial_depth",
    "--factor",
    "hardness",
    "--design",
    "fraction",
];

fn text(args: &[&str]) -> String {
    String::from_utf8(steadycut(args).stdout).unwrap()
}

#[test]
fn a_plan_says_what_it_cannot_tell() {
    let report = json(&[&FRACTION[..], &["--generator", "D=ABC", "--json"]].concat());
    assert_eq!(report["fraction"]["resolution"], 4);
    assert_eq!(report["fraction"]["defining"][0], "ABCD");
    assert_eq!(report["runs"].as_array().unwrap().len(), 8);
    assert_eq!(report["assessment"]["rank"], 8);
    let told = text(&[&FRACTION[..], &["--drop", "1"]].concat());
    for part in ["I = ABCD, resolution IV", "AB = CD", "cannot be told apart"] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let table = "assets/data/table3_2007.csv";
    let told = text(&["experiment", "--table", table, "--model", "papers"]);
    assert!(told.contains("HARDLY TOLD") && told.contains("on one line"), "{told}");
    // A term of one's own, at another noise.
    let own = ["experiment", "--design", "latin", "--term", "speed_rpm^3", "--json", "--noise"];
    let errors = ["1", "3"].map(|noise| {
        let report = json(&[&own[..], &[noise]].concat());
        report["assessment"]["terms"][1]["standard_error_n"].as_f64().unwrap()
    });
    assert!((errors[1] / errors[0] - 3.0).abs() < 1e-9, "{errors:?}");
}

#[test]
fn a_sheet_is_printed_filled_in_and_read_back() {
    let [sheet, page, rows] = ["sheet.csv", "sheet.html", "rows.csv"].map(temporary);
    let [sheet, page, rows] = [&sheet, &page, &rows].map(|path| path.to_str().unwrap());
    let plan = ["experiment", "--levels", "3", "--seed", "4"];
    steadycut(&[&plan[..], &["--out", sheet, "--page", page]].concat());
    let printed = fs::read_to_string(page).unwrap();
    assert!(printed.contains("--levels 3") && printed.contains("plan-"), "{printed}");
    // Nothing is filled in yet, then all but one.
    let empty = steadycut(&[&plan[..], &["--read", sheet]].concat());
    assert_eq!(empty.status.code(), Some(1));
    let lines = fs::read_to_string(sheet).unwrap();
    let filled: Vec<String> = lines
        .lines()
        .enumerate()
        .map(|(number, line)| match number {
            0 | 5 => line.to_owned(),
            _ => line.replace(",,,", &format!(",{},0.7{number},", 170 + number)),
        })
        .collect();
    fs::write(sheet, filled.join("\n")).unwrap();
    let read = steadycut(&[&plan[..], &["--read", sheet, "--out", rows]].concat());
    let told = String::from_utf8(read.stdout).unwrap();
    assert_eq!(read.status.code(), Some(1));
    assert!(told.contains("8 of 9 cuts measured") && told.contains("not whole: runs "), "{told}");
    assert_eq!(fs::read_to_string(rows).unwrap().lines().count(), 1 + 8);
    json(&[
        "identify",
        "gp",
        "--data",
        rows,
        "--target",
        "force_n",
        "--inputs",
        "feed_mm_min",
        "--batches",
        "1",
        "--json",
    ]);
    let error = refused(&["experiment", "--levels", "3", "--seed", "5", "--read", sheet]);
    assert!(error.contains("line 2") && error.contains("belongs to `plan-"), "{error}");
}

#[test]
fn cuts_on_the_simulator_go_on_to_the_search() {
    let table = temporary("cuts.csv");
    let table = table.to_str().unwrap();
    let run = ["experiment", "--design", "latin", "--points", "40", "--run", "--seed", "3"];
    let report = json(&[&run[..], &["--json"]].concat());
    assert!(report["measured"].as_array().unwrap().iter().all(|cut| cut["force_n"].is_f64()));
    steadycut(&[&run[..], &["--out", table]].concat());
    let found = json(&[
        "identify",
        "gp",
        "--data",
        table,
        "--target",
        "force_n",
        "--inputs",
        "feed_mm_min,speed_rpm",
        "--batches",
        "3",
        "--json",
    ]);
    // The noise of 2 N, and not much more.
    let error = found["residual_deviation"].as_f64().unwrap();
    assert!((1.2..3.5).contains(&error), "{error}");
}

#[test]
fn what_does_not_go_together_is_refused() {
    for (args, parts) in [
        (&["--factor", "fed"][..], ["--factor `fed`", "feed, speed"]),
        (&["--factor", "feed=1..2"], ["--factor feed: 1 ", "10 to 5000"]),
        (
            &["--factor", "feed", "--set", "program.feed_mm_min=300"],
            ["--factor", "program.feed_mm_min"],
        ),
        (
            &["--factor", "tool=ball-6-2", "--factor", "feed", "--set", "tool.teeth=3"],
            ["--factor tool", "tool.teeth"],
        ),
        (&["--set", "controller.kind=tracking"], ["controller.kind", "has no use for it"]),
        (&["--run", "--set", "controller.kind=tracking"], ["controller.kind", "constant feed"]),
        (&["--levels", "3", "--design", "latin"], ["--levels", "--design full"]),
        (&["--stars", "far", "--design", "composite"], ["--stars far", "rotatable"]),
        (&["--design", "fraction"], ["--drop", "--generator"]),
        (&["--design", "fraction", "--drop", "1"], ["--drop", "for 2 factors there is none"]),
        (
            &["--factor", "feed", "--factor", "wear", "--model", "papers"],
            ["--model", "feed and speed"],
        ),
        (&["--term", "ln(0-feed_mm_min)"], ["--term", "no finite value"]),
        (
            &[
                "--factor",
                "feed=1000..5000:20",
                "--factor",
                "speed=100..200:20",
                "--factor",
                "wear=1..2:20",
                "--factor",
                "hardness=100..200:20",
            ],
            ["plan: 160000 runs", "10000"],
        ),
        (
            &["--factor", "radial_depth=2..8", "--factor", "feed", "--set", "tool.name=ball-6-2"],
            ["radial_depth: 8", "6 mm"],
        ),
        (
            &[
                "--factor",
                "feed",
                "--factor",
                "tool=ball-6-2",
                "--set",
                "workpiece.radial_depth_mm=8",
            ],
            ["run 1", "tool.diameter_mm"],
        ),
    ] {
        let error = refused(&[&["experiment"], args].concat());
        assert!(parts.iter().all(|part| error.contains(part)), "{args:?}: {error}");
    }
    let error = refused(&["experiment", "way", "--cuts", "5"]);
    assert!(error.contains("--cuts: 5") && error.contains("30 to 2000"), "{error}");
    let error = refused(&["experiment", "way", "--tool", "ball-6-2", "--plant", "formula"]);
    assert!(error.contains("ball-6-2") && error.contains("mechanistic"), "{error}");
}

#[test]
fn the_way_writes_what_a_run_takes() {
    let folder = temporary("way");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    let small = ["experiment", "way", "--cuts", "40", "--batches", "2", "--seed", "2"];
    let report = json(&[&small[..], &["--json", "--out", folder.to_str().unwrap()]].concat());
    assert_eq!(
        (report["models"].as_array().unwrap().len(), report["rows"].as_array().unwrap().len()),
        (5, 10)
    );
    let told = text(&small);
    for part in [
        "truth: force: the papers' K4",
        "K5 = K6",
        "outside the ranges",
        report["digest"].as_str().unwrap(),
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let file = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    assert_eq!(fs::read_to_string(file("cuts.csv")).unwrap().lines().count(), 41);
    // The example is the row of 0.81 um with Tracking on these models.
    let run = json(&["run", &file("scenario.toml"), "--set", "run.duration_s=15", "--json"]);
    let row = &report["rows"][4]["outcomes"][3];
    assert_eq!(
        (row["controller"].as_str(), row["models"].as_str()),
        (Some("tracking"), Some("found"))
    );
    let [a, b] = [&run, row]
        .map(|report| report.get("ra_final_um").or(report.get("ra_um")).unwrap().as_f64().unwrap());
    assert!((a / b - 1.0).abs() < 1e-3, "{a} {b}");
    for role in ["force_of_ra", "feed", "speed", "force", "ra"] {
        let model = format!("{role}={}", file(&format!("{role}.toml")));
        json(&["run", "table3-5", "--formula", &model, "--json"]);
    }
}

//! The virtual profilometer on the surface of a run, and from the command line.

use std::process::Command;

use steadycut::blocks::cutting::tool_path::ToolPath;
use steadycut::run::edits::Edits;
use steadycut::run::one_run::Run;
use steadycut::run::presets::load;
use steadycut::run::tooth_marks::MarkedPart;
use steadycut::study::profilometer::{ProfileLine, measure};

const LINE: ProfileLine = ProfileLine { from_mm: [30.0, 3.5], to_mm: [56.0, 3.5] };

#[test]
fn a_measured_profile_has_the_roughness_of_the_run_and_slices_and_the_command_line_agree() {
    let scenario = load("table3-5").unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let rows = run.recording().rows();
    let mut marks = MarkedPart::new(&scenario);
    marks.extend(rows);
    let path = ToolPath::new(&scenario.workpiece, scenario.tool.outline());
    let measured = |marks: &MarkedPart| {
        measure(&marks.cuts()[0].surface, path.of(0), &LINE, &scenario.profile).unwrap()
    };
    let found = measured(&marks);
    assert!(found.lengths >= 30, "{} lengths, more than 20 mm", found.lengths);
    let along = rows.iter().filter(|row| (30.0..=56.0).contains(&row.position_mm));
    let (sum, count) = along.fold((0.0, 0.0), |(sum, n), row| (sum + row.ra_dyn_um, n + 1.0));
    let ra_um = found.roughness.ra_um;
    assert!((ra_um / (sum / count) - 1.0).abs() < 0.1, "{ra_um} against {}", sum / count);
    let run_ra_um = found.run_ra_um.unwrap();
    assert!((run_ra_um / (sum / count) - 1.0).abs() < 0.01, "{run_ra_um}");

    let mut slices = Run::new(&scenario, &Edits::none());
    let mut marked = MarkedPart::new(&scenario);
    while !slices.advance(777) {
        marked.extend(slices.recording().rows());
    }
    marked.extend(slices.recording().rows());
    assert_eq!(measured(&marked), found);

    let output = Command::new(env!("CARGO_BIN_EXE_steadycut"))
        .args(["run", "table3-5", "--profile", "30,3.5,56,3.5", "--json"])
        .output()
        .unwrap();
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for (key, value) in [
        ("ra_um", found.roughness.ra_um),
        ("rq_um", found.roughness.rq_um),
        ("rz_um", found.roughness.rz_um),
        ("run_ra_um", found.run_ra_um.unwrap()),
    ] {
        assert_eq!(report[key].as_f64(), Some(value), "{key}");
    }
}

#[test]
fn the_command_line_says_what_it_cannot_measure() {
    for (args, said) in [
        (["--profile", "1,2,3"], "four numbers in mm"),
        (["--profile", "0.5,3.5,1.5,3.5"], "1.000 mm long"),
        (["--profile", "0.2,3.5,30,3.5"], "x reaches from"),
        (
            ["--profile=-9,3.5,0,3.5", "--cut=1"],
            "the line leaves the machined surface at x = -9.000",
        ),
        (["--profile=0.2,3.5,3,3.5", "--cut=2"], "--cut 2: allowed is 1 to 1"),
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_steadycut"))
            .args(["run", "table3-5", "--set", "run.duration_s=1"])
            .args(args)
            .output()
            .unwrap();
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success() && error.contains(said), "{args:?}: {error}");
    }
}

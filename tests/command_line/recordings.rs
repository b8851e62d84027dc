//! `steadycut identify force`, `wear`, `noise`, `material`: what a run was made with comes back out of its recording, and
//! the scenario that is written runs by it.

use std::fs;

use serde_json::Value;
use steadycut::base::math;

use super::program::{json, refused, steadycut, temporary};

fn printed(args: &[&str]) -> String {
    let output = steadycut(args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// A steady cut tooth by tooth: the papers' cutter at 80 m/min and 0.08 mm a tooth, run-out 3 um.
const TEETH: &str = "version = 1\n[plant]\nforce_model = \"mechanistic\"\n[controller]\nkind = \"constant_feed\"\n\
    [program]\nfeed_mm_min = 254.647909\nspindle_rpm = 1591.549431\n\
    [run]\nsteps_per_control = 576\nrecord_every = 576\nduration_s = 3.0\n";

fn of(told: &Value, pointer: &str) -> f64 {
    told.pointer(pointer).and_then(Value::as_f64).unwrap_or_else(|| panic!("{pointer}: {told}"))
}

#[test]
fn a_cut_s_coefficients_come_back_from_a_turn_of_its_forces_and_the_scenario_has_its_force() {
    let [scenario, forces, found] =
        ["teeth.toml", "teeth-forces.csv", "teeth-found.toml"].map(temporary);
    fs::write(&scenario, TEETH).unwrap();
    let scenario = scenario.to_str().unwrap();
    fs::write(&forces, printed(&["run", scenario, "--revolution", "2.5"])).unwrap();
    let forces = forces.to_str().unwrap();
    let data = ["identify", "force", "--data", forces, "--scenario", scenario];
    let all = [&data[..], &["--fx", "fx_n", "--fy", "fy_n", "--fz", "fz_n"]].concat();
    let told = json(&[&all[..], &["--out", found.to_str().unwrap(), "--json"]].concat());
    // Ck45 at 80 m/min and a rake of 12 deg: 2090.3, 423.7 and 188.3 N/mm^2 with 0.14, 0.45, 0.20.
    for (i, k, m) in [(0, 2090.34, 0.14), (1, 423.72, 0.45), (2, 188.32, 0.20)] {
        let law = &told["laws"][i];
        assert!((of(law, "/k_n_mm2/value") / k - 1.0).abs() < 0.02, "{law}");
        assert!((of(law, "/exponent/value") - m).abs() < 0.01, "{law}");
        assert!(of(law, "/k_n_mm2/half_95") > 0.0, "{law}");
    }
    assert!((of(&told, "/shift_um/value") - 3.0).abs() < 0.3, "{told}");
    assert!((of(&told, "/runout_um/1/value") + 3.0).abs() < 0.3, "{told}");
    // The turn begins where the table of the turn does.
    let first = fs::read_to_string(forces).unwrap();
    let angle: f64 = first.lines().nth(1).unwrap().split(',').nth(1).unwrap().parse().unwrap();
    let off = (of(&told, "/phase_deg/value") - angle + 540.0) % 360.0 - 180.0;
    assert!(off.abs() < 1.0, "{angle}: {off}");
    assert!(of(&told, "/r2") > 0.998, "{told}");
    let text = fs::read_to_string(&found).unwrap();
    for part in ["# k_c1.1 = ", "+- ", "forces.csv", "# run-out, tooth by tooth"] {
        assert!(text.contains(part), "{part}: {}", &text[..600]);
    }
    let peak = |name: &str| of(&json(&["run", name, "--json"]), "/max_force_n");
    let ratio = peak(found.to_str().unwrap()) / peak(scenario);
    assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    let text = printed(&all);
    for part in ["k_c1.1", "tooth 2", "axis shifted", "formula.specific_radial_force = "] {
        assert!(text.contains(part), "{part}: {text}");
    }
    // A dynamometer below the workpiece has them with the other sign: then nothing fits.
    let turned = [&all[..], &["--on-workpiece"]].concat();
    let error = refused(&turned);
    assert!(error.contains("expected are forces on the tool"), "{error}");
    for (args, part) in [
        (&["--fx", "Fx"][..], "--fx: there is no channel `Fx`; there are angle_deg"),
        (&["--fx", "angle_deg"], "`angle_deg` is in deg; expected is a force in N or kN"),
        (&["--fx", "fx_n", "--within", "2.4999..2.5"], "samples: allowed are 60"),
        (&["--fx", "fx_n", "--axial-depth", "0"], "the axial depth is 0 mm"),
        (&["--fx", "fx_n", "--speed", "1e9"], "--speed: "),
        (&[], "--fx"),
    ] {
        let error = refused(&[&data[..], args].concat());
        assert!(error.contains(part), "{args:?}: {error}");
    }
    let formula = ["identify", "force", "--data", forces, "--fx", "fx_n", "--scenario", "table3-5"];
    assert!(refused(&formula).contains("tooth by tooth"));
}

#[test]
fn taylor_s_constants_come_back_from_readings_and_make_a_scenario() {
    let [readings, found] = ["readings.csv", "worn.toml"].map(temporary);
    // T = 20 min at 160 m/min with n = 0.25; the wear land grows evenly to 0.3 mm.
    let mut table = "v;t;VB\n".to_owned();
    for speed in [130.0, 160.0, 200.0] {
        let life_min = 20.0 * math::pow(160.0 / speed, 4.0);
        for k in 1..6 {
            let share = 0.25 * f64::from(k);
            table += format!("{speed};{};{}\n", share * life_min, 0.3 * share).as_str();
        }
    }
    fs::write(&readings, table.replace('.', ",")).unwrap();
    let args =
        ["identify", "wear", "--data", readings.to_str().unwrap(), "--speed", "v", "--time", "t"];
    let args = [&args[..], &["--land", "VB"]].concat();
    let told = json(&[&args[..], &["--out", found.to_str().unwrap(), "--json"]].concat());
    assert!((of(&told, "/exponent/value") - 0.25).abs() < 1e-6, "{told}");
    let constant = 160.0 * math::pow(20.0, 0.25);
    assert!((of(&told, "/constant_m_min/value") / constant - 1.0).abs() < 1e-6, "{told}");
    assert_eq!(told["lives"].as_array().unwrap().len(), 3);
    let run = steadycut(&["check", found.to_str().unwrap()]);
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    assert!(printed(&args).contains("C of v T^n = C"));
    let error = refused(&[&args[..], &["--limit", "0.9"]].concat());
    assert!(error.contains("readings.csv") && error.contains("at least two speeds"), "{error}");
    let error = refused(&args[..4]);
    assert!(error.contains("no column `speed_m_min`; there are v, t, VB"), "{error}");
}

#[test]
fn noise_and_material_of_a_run_come_back_from_its_trace() {
    let [trace, noisy, hard, found] =
        ["noisy.csv", "noisy.toml", "hard.csv", "hard.toml"].map(temporary);
    let [trace, noisy, hard, found] =
        [&trace, &noisy, &hard, &found].map(|path| path.to_str().unwrap());
    let steady = ["run", "table3-5-noise", "--set", "controller.kind=constant_feed"];
    let fast = ["--set", "run.control_period_ms=1", "--set", "run.steps_per_control=1"];
    printed(&[&steady[..], &fast, &["--set", "noise.band_percent=4", "--out", trace]].concat());
    let args = ["identify", "noise", "--data", trace, "--force", "force_measured_n"];
    let args = [&args[..], &["--within", "1..15", "--scenario", "table3-5-noise"]].concat();
    let told = json(&[&args[..], &["--out", noisy, "--json"]].concat());
    for (pointer, known, off) in [
        ("/white_n/value", 2.0, 0.1),
        ("/band_percent/value", 4.0, 0.15),
        ("/tooth_percent/value", 1.5, 0.1),
    ] {
        assert!((of(&told, pointer) / known - 1.0).abs() < off, "{pointer}: {told}");
    }
    assert!((of(&told, "/inhomogeneity_percent/value") - 2.0).abs() < 1.2, "{told}");
    assert!(steadycut(&["check", noisy]).status.success());
    assert!(printed(&args).contains("tooth passing"));
    let error = refused(&[&args[..5], &["feed_mm_min"], &args[6..]].concat());
    assert!(error.contains("expected is a force in N or kN"), "{error}");
    // The same cut in harder steel.
    printed(&[&steady[..], &["--set", "plant.hardness_hb=260", "--out", hard]].concat());
    let args = [
        "identify",
        "material",
        "--data",
        hard,
        "--force",
        "force_measured_n",
        "--feed",
        "feed_mm_min",
        "--speed",
        "spindle_rpm",
        "--within",
        "1..15",
        "--scenario",
        "table3-5-noise",
    ];
    let told = json(&[&args[..], &["--out", found, "--json"]].concat());
    assert!((of(&told, "/hardness_hb/value") / 260.0 - 1.0).abs() < 0.05, "{told}");
    let factor = math::pow(260.0 / 200.0, 0.4);
    assert!((of(&told, "/factor/value") / factor - 1.0).abs() < 0.02, "{told}");
    assert!(steadycut(&["check", found]).status.success());
    assert!(printed(&args).contains("hardness of Ck45"));
    let error = refused(&[&args[..13], &["experiment-1"]].concat());
    assert!(error.contains("identify force"), "{error}");
}

//! `steadycut run --script`: a controller of one's own.

use std::fs;

use super::program::{json, refused, steadycut, temporary};

#[test]
fn a_script_of_a_file_controls_the_cut_and_a_wrong_one_is_refused_with_its_line() {
    let file = temporary("own.rhai");
    let file = file.to_str().unwrap();
    let run = ["run", "first-cut", "--script", file, "--set", "run.duration_s=2"];
    fs::write(file, "fn update(now) {\n    100.0 - 20.0 * now.c\n}\n").unwrap();
    let at = |c: &str| json(&[&run[..], &["--json", "--set", c]].concat())["digest"].clone();
    let [all, less] = ["controller.script.c=0", "controller.script.c=1"].map(at);
    assert_ne!(all, less);
    // At 100 % it is the cut without control.
    let constant = ["run", "first-cut", "--set", "run.duration_s=2", "--json"];
    let constant = [&constant[..], &["--set", "controller.kind=constant_feed"]].concat();
    let [without, with] = [json(&constant), json(&[&run[..], &["--json"]].concat())];
    for figure in ["ra_final_um", "feed_final_mm_min", "time_of_cut_s"] {
        assert!(without[figure].is_f64(), "{figure} in {without}");
        assert_eq!(without[figure], with[figure], "{figure}");
    }
    fs::write(file, "fn update(now) {\n    now.\n}\n").unwrap();
    let said = refused(&run);
    assert!(said.contains("own.rhai: line 3: "), "{said}");
    let twice = refused(&[&run[..], &["--set", "controller.kind=sdnrp"]].concat());
    assert!(twice.contains("--script") && twice.contains("controller.kind"), "{twice}");
    // What fails in the cut ends it; what was recorded is told.
    fs::write(file, "fn update(now) {\n    let x = 0;\n    loop { x += 1; }\n}\n").unwrap();
    let output = steadycut(&run);
    let told = String::from_utf8_lossy(&output.stdout).into_owned()
        + String::from_utf8_lossy(&output.stderr).as_ref();
    assert!(!output.status.success() && told.contains("line 3: more than"), "{told}");
}

//! `steadycut formula`: a formula on a table, and in all its forms.

use std::fs;

use super::program::{json, refused, steadycut, temporary};

const K4: &str = "253.66 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f";
const ABOUT: [&str; 10] = [
    "--range",
    "f=69.7..600",
    "--range",
    "n=800..2500",
    "--unit",
    "f=mm/min",
    "--unit",
    "n=1/min",
    "--result",
    "F=N",
];

fn text(args: &[&str]) -> String {
    let output = steadycut(args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_formula_is_printed_in_all_its_forms_with_units_and_certificate() {
    let told = text(&[&["formula", K4][..], &ABOUT].concat());
    for part in [
        "253.66 - 5.82e-10 * n^3 - 8973 * ln(0.039 * f) / f",
        "16 nodes",
        "by n: -1.746e-9 * n^2",
        "8973                     mm N/min",
        "0.039                    min/mm",
        r"\frac{8973\, \ln\left(0.039\, f\right)}{f}",
        "pub fn formula(f: f64, n: f64) -> f64 {",
        "double formula(double f, double n) {",
        "def formula(f, n):",
        "=253.66-5.82E-10*B2^3-8973*LN(0.039*A2)/A2",
        "F in N: f from 69.7 to 600 in mm/min",
        "finite everywhere, from 1",
        "never rises with n",
        "wider by 30 %",
        "not certified to be finite",
        "the logarithm of 0",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let report = json(&[&["formula", K4, "--json"][..], &ABOUT].concat());
    assert_eq!(report["size"], 16);
    assert_eq!(report["certificates"][0]["finite"], true);
    assert_eq!(report["certificates"][1]["ranges"][0][0], 0.0, "no feed is negative");
    assert_eq!(report["units"]["constants"][3]["unit"], "mm N/min");
    let free = text(&["formula", "-x^2 + 1"]);
    assert!(free.contains("=-(A2^2)+1") && !free.contains("Certain"), "{free}");
}

#[test]
fn a_table_gets_the_values_and_rows_outside_the_ranges_are_marked() {
    let [table, model, made] = ["formula.csv", "formula.toml", "formula_made.csv"].map(temporary);
    let [table, model, made] = [&table, &model, &made].map(|path| path.to_str().unwrap());
    fs::write(table, "name,n,f,F\na,1000,300,180\nb,1000,650,\n").unwrap();
    text(&[&["formula", K4, "--save", model][..], &ABOUT].concat());
    assert!(fs::read_to_string(model).unwrap().contains("253.66 - 5.82e-10 * n^3"));
    let said = text(&["formula", model, "--data", table, "--out", made]);
    assert!(
        said.contains("2 rows; 1 outside") && said.contains("against the column F: rms"),
        "{said}"
    );
    let made = fs::read_to_string(made).unwrap();
    let lines: Vec<&str> = made.lines().collect();
    assert_eq!(lines[0], "name,n,f,F,predicted,extrapolated");
    assert!(lines[1].starts_with("a,1000,300,180,179.5") && lines[1].ends_with(",no"), "{made}");
    assert!(lines[2].ends_with(",yes"), "{made}");
    // A text has no ranges, and so no rows outside them.
    let plain = text(&["formula", "f / n", "--data", table]);
    assert_eq!(plain, "name,n,f,F,predicted\na,1000,300,180,0.3\nb,1000,650,,0.65\n");
    let report = json(&["formula", model, "--data", table, "--json"]);
    assert_eq!(report["extrapolated"], serde_json::json!([false, true]));
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let table = temporary("formula_refused.csv");
    let table = table.to_str().unwrap();
    fs::write(table, "a,b\n1,x\n").unwrap();
    for (args, parts) in [
        (&["formula", "2 x"][..], ["column 3", "a product needs its `*`"]),
        (&["formula", "log(x)"], ["unknown function `log`", "`ln`"]),
        (&["formula", "x + y", "--range", "x=0..1"], ["`y` has no range", "--range y="]),
        (&["formula", "x", "--range", "z=0..1"], ["--range z", "the formula's are x"]),
        (&["formula", "x", "--range", "x=1..1"], ["--range x=1..1", "low below high"]),
        (&["formula", "x", "--range", "x=1"], ["--range", "NAME=LOW..HIGH"]),
        (&["formula", "x", "--unit", "x=furlong"], ["--unit x", "`furlong` is no unit"]),
        (&["formula", "1/x", "--range", "x=-1..1"], ["not certain", "a division by 0"]),
        (&["formula", "x", "--save", "-"], ["--save", "range"]),
        (&["formula", "a + c", "--data", table], ["no column `c`", "a, b"]),
        (&["formula", "a + b", "--data", table], ["line 2", "`b` cannot be `x`"]),
        (&["formula", "no-such.toml"], ["no-such.toml", ""]),
        (&["formula", "x", "--out", "y.csv"], ["--data", ""]),
    ] {
        let said = refused(args);
        for part in parts {
            assert!(said.contains(part), "{args:?}: {part}: {said}");
        }
    }
    let said = refused(&["formula", "a", "--data", table, "--out", table]);
    assert!(said.contains("--out") && said.contains("same file"), "{said}");
}

#[test]
fn a_run_takes_formulas_for_its_models() {
    let [force, ra] = ["own_force.toml", "own_ra.toml"].map(temporary);
    let [force, ra] = [&force, &ra].map(|path| path.to_str().unwrap());
    let model = "354.9 - 182*(f/256)^-0.245 - 0.572*(n/1024)^3.11";
    let about = [
        "--range",
        "n=800..2500",
        "--range",
        "f=150..600",
        "--unit",
        "f=mm/min",
        "--unit",
        "n=1/min",
        "--result",
        "F=N",
        "--save",
        force,
    ];
    text(&[&["formula", model][..], &about].concat());
    let about = ["--range", "F=100..250", "--unit", "F=N", "--result", "Ra=um", "--save", ra];
    text(&[&["formula", "0.0254*(593/(300-F))^2"][..], &about].concat());
    let digest =
        |args: &[&str]| json(&[&["run", "table3-5", "--json"], args].concat())["digest"].clone();
    let own = format!("force={force}");
    let with = digest(&["--formula", &own]);
    assert_ne!(with, digest(&[]));
    let written = fs::read_to_string(force).unwrap();
    let set = format!("formula.force={written}");
    let both = ["--set", "plant.calibration=formula", "--set", "belief.calibration=formula"];
    assert_eq!(with, digest(&[&["--set", &set][..], &both].concat()), "the same as settings");
    let of_ra = format!("ra={ra}");
    assert_ne!(with, digest(&["--formula", &own, "--formula", &of_ra]));
    for (args, parts) in [
        (vec!["--formula", "force"], ["ROLE=FILE", "force_of_ra, feed, speed, force, ra"]),
        (vec!["--formula", "speed=no.toml"], ["no.toml", ""]),
        (vec!["--formula", "ra=own_force.toml"], ["", ""]),
        (
            vec!["--formula", &own, "--set", "plant.calibration=printed"],
            ["--formula", "plant.calibration"],
        ),
        (vec!["--formula", &own, "--set", &set], ["--formula", "formula.force"]),
        (vec!["--formula", &own, "--formula", &own], ["force", "twice"]),
        (vec!["--set", &set], ["formula.force", "is formula"]),
    ] {
        let said = refused(&[&["run", "table3-5"][..], &args].concat());
        for part in parts {
            assert!(said.contains(part), "{args:?}: {part}: {said}");
        }
    }
    let wrong = format!("ra={force}");
    let said = refused(&["run", "table3-5", "--formula", &wrong]);
    assert!(
        said.contains("formula.ra") && said.contains("allowed is um of a force in N"),
        "{said}"
    );
}

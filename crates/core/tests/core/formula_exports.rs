//! A formula written for another program gives the same values there: Python, C and Rust run what is written,
//! a reader of spreadsheets' formulas, independent of the program's own, reads the cell.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use steadycut_core::base::formula::{Formula, FormulaLanguage};
use steadycut_core::base::rng::Stream;

/// Points of the box.
const POINTS: usize = 1000;

/// Text, names of the inputs and their ranges; whether it is bit for bit the same in Rust and C.
type Case = (&'static str, [&'static str; 2], [[f64; 2]; 2], bool);

const FORMULAS: [Case; 6] = [
    (
        "286.44 - 5.82e-10*n^3 - 8973*ln(0.039*f)/f",
        ["f", "n"],
        [[150.0, 600.0], [800.0, 2500.0]],
        true,
    ),
    (
        "387.7 - 182*(a/256)^-0.245 - 0.572*(b/1024)^3.11",
        ["a", "b"],
        [[70.0, 735.0], [290.0, 3010.0]],
        true,
    ),
    ("-x^2 - -y^3 / -(x - 7)^-1.5 - 2^x^0.5", ["x", "y"], [[7.5, 20.0], [-3.0, 3.0]], true),
    (
        "--in * exp(-\"e\"/2) - (in - (\"e\" - 1e-20))",
        ["in", "e"],
        [[-300.0, 300.0], [-1400.0, 600.0]],
        true,
    ),
    (
        "sqrt(\"feed rate\") * ln(\"feed-rate\") * pi",
        ["feed rate", "feed-rate"],
        [[0.0, 9.0], [1e-310, 3.0]],
        true,
    ),
    ("sin(x) + cos(3*y) * tanh(x/2)", ["x", "y"], [[-9.0, 9.0], [-9.0, 9.0]], false),
];

fn points(formula: usize, ranges: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    let rng = Stream::new(formula as u64, "formula exports");
    let within = |[low, high]: [f64; 2], counter: u64| low + (high - low) * rng.uniform(counter);
    let points =
        (0..POINTS as u64).map(|i| [within(ranges[0], 2 * i), within(ranges[1], 2 * i + 1)]);
    points.collect()
}

/// A folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("formula_exports").join(name);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs a program and returns what it prints, one number in a line.
fn run(command: &mut Command) -> Vec<f64> {
    let output = command.stderr(Stdio::piped()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines().map(|line| line.trim().parse().unwrap_or_else(|_| panic!("{line}"))).collect()
}

fn there(program: &str) -> bool {
    let found = Command::new(program).arg("--version").output().is_ok_and(|it| it.status.success());
    if !found {
        println!("{program} is not on this machine: what is written for it is not run");
    }
    found
}

fn judge(language: &str, text: &str, expected: &[f64], found: &[f64], same_bits: bool) {
    assert_eq!(expected.len(), found.len(), "{language}: {text}");
    for (expected, found) in expected.iter().zip(found) {
        let close = if same_bits {
            expected.to_bits() == found.to_bits()
        } else {
            (expected - found).abs() <= 1e-12 * expected.abs() + 1e-13
        };
        assert!(close, "{language}: {text}: {expected:e} and {found:e}");
    }
}

fn each(language: FormulaLanguage, run: impl Fn(usize, &str, &[[f64; 2]]) -> (Vec<f64>, bool)) {
    for (index, (text, names, ranges, exact)) in FORMULAS.into_iter().enumerate() {
        let formula = Formula::parse(text, &names).unwrap_or_else(|error| panic!("{error}"));
        let points = points(index, ranges);
        let expected: Vec<f64> = points.iter().map(|at| formula.value(at)).collect();
        assert!(expected.iter().all(|value| value.is_finite()), "{text}");
        let (found, bits) = run(index, &formula.export(language, "formula"), &points);
        judge(language.id(), text, &expected, &found, exact && bits);
    }
}

#[test]
fn python_gives_the_same_values() {
    if !there("python3") {
        return;
    }
    each(FormulaLanguage::Python, |index, code, points| {
        let file = folder("python").join(format!("f{index}.py"));
        let points: String = points.iter().map(|[a, b]| format!("({a:?}, {b:?}), ")).collect();
        let code = format!("{code}\nfor a, b in [{points}]:\n    print(repr(formula(a, b)))\n");
        std::fs::write(&file, code).unwrap();
        (run(Command::new("python3").arg(&file)), false)
    });
}

#[test]
fn c_gives_the_same_bits() {
    if !there("cc") {
        return;
    }
    each(FormulaLanguage::C, |index, code, points| {
        let folder = folder("c");
        let (file, program) =
            (folder.join(format!("f{index}.c")), folder.join(format!("f{index}")));
        let points: String = points.iter().map(|[a, b]| format!("{{{a:?}, {b:?}}}, ")).collect();
        let code = format!(
            "{code}\n#include <stdio.h>\nint main(void) {{\n    static const double at[][2] = {{{points}}};\n    \
             for (int i = 0; i < {POINTS}; i++) printf(\"%.17g\\n\", formula(at[i][0], at[i][1]));\n}}\n"
        );
        std::fs::write(&file, code).unwrap();
        let strict = ["-std=c99", "-O2", "-Wall", "-Werror", "-ffp-contract=off"];
        run(Command::new("cc").args(strict).arg("-o").args([&program, &file]).arg("-lm"));
        (run(&mut Command::new(&program)), true)
    });
}

#[test]
fn rust_gives_the_same_bits() {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    if !there(&rustc) {
        return;
    }
    each(FormulaLanguage::Rust, |index, code, points| {
        let folder = folder("rust");
        let (file, program) =
            (folder.join(format!("f{index}.rs")), folder.join(format!("f{index}")));
        let points: String = points.iter().map(|[a, b]| format!("({a:?}, {b:?}), ")).collect();
        let code = format!(
            "{code}\nfn main() {{\n    for (a, b) in [{points}] {{\n        println!(\"{{:?}}\", formula(a, b));\n    }}\n}}\n"
        );
        std::fs::write(&file, code).unwrap();
        let strict = ["--edition=2021", "-Dwarnings", "-o"];
        run(Command::new(&rustc).args(strict).args([&program, &file]));
        (run(&mut Command::new(&program)), true)
    });
}

#[test]
fn a_spreadsheet_gives_the_same_values() {
    each(FormulaLanguage::Spreadsheet, |_, cell, points| {
        let value = |at: &[f64; 2]| {
            let mut reader = Sheet { rest: cell.strip_prefix('=').unwrap(), at };
            let value = reader.sum();
            assert!(reader.rest.is_empty(), "{cell}: {}", reader.rest);
            value
        };
        (points.iter().map(value).collect(), false)
    });
}

/// Reads a spreadsheet's formula as spreadsheets do: a sign before anything else, powers from left to right.
struct Sheet<'a> {
    rest: &'a str,
    at: &'a [f64; 2],
}

impl Sheet<'_> {
    fn take(&mut self, signs: &[char]) -> Option<char> {
        let first = self.rest.chars().next().filter(|c| signs.contains(c))?;
        self.rest = &self.rest[1..];
        Some(first)
    }

    fn sum(&mut self) -> f64 {
        let mut value = self.product();
        while let Some(sign) = self.take(&['+', '-']) {
            let next = self.product();
            value = if sign == '+' { value + next } else { value - next };
        }
        value
    }

    fn product(&mut self) -> f64 {
        let mut value = self.power();
        while let Some(sign) = self.take(&['*', '/']) {
            let next = self.power();
            value = if sign == '*' { value * next } else { value / next };
        }
        value
    }

    fn power(&mut self) -> f64 {
        let mut value = self.signed();
        while self.take(&['^']).is_some() {
            value = libm::pow(value, self.signed());
        }
        value
    }

    fn signed(&mut self) -> f64 {
        if self.take(&['-']).is_some() { -self.signed() } else { self.leaf() }
    }

    fn leaf(&mut self) -> f64 {
        if self.take(&['(']).is_some() {
            let value = self.sum();
            assert_eq!(self.take(&[')']), Some(')'));
            return value;
        }
        let end = self.rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '.');
        let mut end = end.unwrap_or(self.rest.len());
        if self.rest[..end].ends_with('E') && self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            end += 1 + self.rest[end + 1..]
                .find(|c: char| !c.is_ascii_digit())
                .unwrap_or(self.rest.len() - end - 1);
        }
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        let function: fn(f64) -> f64 = match word {
            "A2" => return self.at[0],
            "B2" => return self.at[1],
            "LN" => libm::log,
            "EXP" => libm::exp,
            "SQRT" => libm::sqrt,
            "SIN" => libm::sin,
            "COS" => libm::cos,
            "TANH" => libm::tanh,
            number => return number.parse().unwrap_or_else(|_| panic!("{number}")),
        };
        assert!(self.rest.starts_with('('));
        function(self.leaf())
    }
}

//! Prints the golden values as `tests/golden.json` holds them, computed by this build: with every
//! optimisation it must give the same text.

fn main() {
    print!("{}", steadycut_study::golden::to_json());
}

//! Tests of formulas, at random and case by case.

mod facts;
mod judged;
mod random;

use super::Formula;

/// A formula of x and y.
fn read(text: &str) -> Formula {
    Formula::parse(text, &["x", "y"]).unwrap_or_else(|error| panic!("{error}"))
}

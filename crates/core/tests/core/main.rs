//! Tests of the whole `steadycut-core`, in one program: it links once.

mod chip;
mod earlier_versions;
mod edges;
mod formula_exports;
mod inputs;
mod links;
mod matrix;
mod metrics;
mod own_curves;
mod own_formulas;
mod revolution;
mod signals;
mod steps;
mod story;
mod switching;
mod tools;
mod unused;

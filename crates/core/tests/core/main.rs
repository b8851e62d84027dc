//! Tests of the whole `steadycut-core`, in one program: it links once.

mod breakage;
mod chip;
mod disturbances;
mod earlier_versions;
mod edges;
mod formula_exports;
mod inputs;
mod languages;
mod links;
mod matrix;
mod metrics;
mod own_curves;
mod own_formulas;
mod revolution;
mod script;
mod signals;
mod steps;
mod story;
mod switching;
mod tools;
mod unused;

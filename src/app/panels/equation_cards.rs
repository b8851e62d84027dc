//! Equation cards: what each box of the block diagram computes, as its source prints it
//! ([`crate::run::diagram`]), and the same equations with the values of the moment put in. No number here is a result: all come from the
//! models, the scenario and the recorded row.
//!
//! Formulas are plain text; `_d` or `_{dyn}` marks a subscript and `^2` a superscript.

mod control;
pub mod formula;
mod laws;
mod live;
mod machine;
mod models;
mod overrides;

pub use live::{Live, Moment, live};

pub use crate::run::diagram::{BLOCKS, Block};

//! The boxes of the block diagram, in signal order. Blocks do not import each other: values pass
//! only through [`crate::run::closed_loop`].

pub mod reference;

pub mod control;

pub mod cnc;

pub mod cutting;

pub mod machine;

pub mod sensing;

pub mod surface;

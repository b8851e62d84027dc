//! Tests of the whole `steadycut-study`, in one program: it links once.

mod closed_loop;
mod coupled;
mod experiment;
mod found;
mod golden;
mod gp;
mod jobs;
mod learning;
mod milling;
mod per_cut;
mod preview;
mod stability;
mod way;

//! Tests of the whole `steadycut-study`, in one program: it links once.

mod afc;
mod closed_loop;
mod coupled;
mod experiment;
mod found;
mod golden;
mod gp;
mod jobs;
mod learning;
mod milling;
mod missions;
mod part;
mod per_cut;
mod preview;
mod safe_feed;
mod stability;
mod way;

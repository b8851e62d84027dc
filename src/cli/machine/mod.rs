//! `steadycut machine`: the five-mass machine of 2019.

pub mod args;
mod model;
mod modes;
mod stability;
mod wear;

use super::Outcome;
use args::{MachineArgs, MachineWhat};

pub fn execute(args: &MachineArgs) -> Outcome {
    match &args.what {
        MachineWhat::Modes(model) => modes::modes(model),
        MachineWhat::Frf(model) => modes::frf(model),
        MachineWhat::Stability(args) => stability::execute(args),
        MachineWhat::Wear(model) => wear::wear(model),
        MachineWhat::Life(args) => wear::life(args),
        MachineWhat::Roughness(model) => modes::roughness(model),
    }
}

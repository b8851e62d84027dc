//! `steadycut train unks`: pre-trains the networks of UNKS and compares them with the shipped ones.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::args::TrainUnksArgs;
use super::{Outcome, progress};
use crate::models::unks::FILES;
use crate::study::train::unks::{CUTS, NOTE, NetworksJob, PatternsJob, SEED, Trained, WORKPIECES};

/// Names of the shipped files, in their order.
const NAMES: [&str; 3] = ["unks_nmr.json", "unks_nm1.json", "unks_nm2.json"];

pub fn execute(args: &TrainUnksArgs) -> Outcome {
    let mut patterns = PatternsJob::default();
    progress::work(&mut patterns, "patterns", args.json)?;
    let mut training = NetworksJob::new(patterns.patterns());
    progress::work(&mut training, "networks", args.json)?;
    let trained = training.trained();
    let same = |i: usize| trained[i].file == FILES[i];
    let mut out = std::io::stdout().lock();
    if args.json {
        let list: Vec<_> = (0..3).map(|i| to_json(&trained[i], same(i))).collect();
        writeln!(
            out,
            "{}",
            serde_json::to_string_pretty(&json!({"note": NOTE, "networks": list}))?
        )?;
    } else {
        writeln!(out, "{NOTE}.\nseed {SEED}, {WORKPIECES} workpieces of {CUTS} cuts\n")?;
        for (i, network) in trained.iter().enumerate() {
            let Trained { name, patterns, epochs, rms, .. } = network;
            let word = if same(i) { "equals" } else { "differs from" };
            writeln!(
                out,
                "{name}: {patterns} patterns, {epochs} epochs, rms error {rms:.3}; {word} the shipped file"
            )?;
        }
    }
    if let Some(folder) = &args.out {
        let files = NAMES.into_iter().zip(trained.iter().map(|network| network.file.as_str()));
        folder.write(&files.collect::<Vec<_>>())?;
    }
    let failed = args.check && !(0..3).all(same);
    Ok(if failed { ExitCode::from(1) } else { ExitCode::SUCCESS })
}

fn to_json(network: &Trained, same: bool) -> serde_json::Value {
    json!({
        "name": network.name, "patterns": network.patterns, "epochs": network.epochs,
        "rms": network.rms, "equals_shipped": same,
    })
}

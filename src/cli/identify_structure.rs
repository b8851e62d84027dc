//! `steadycut identify structure`.

use std::io::Write;
use std::process::ExitCode;

use clap::Args;
use serde_json::json;

use super::Outcome;
use super::files::{InPath, OutPath, report};
use super::identify_data::told;
use crate::models::tip_modes::{TipAxis, TipModes, TipModesFile};
use crate::study::identify::response::{MeasuredResponse, identify_structure};

/// Arguments of `identify structure`.
#[derive(Debug, Args)]
pub struct IdentifyStructureArgs {
    /// The response along the feed as a table: frequency_hz with real_m_n and imaginary_m_n, or with magnitude_m_n and
    /// phase_deg; in um/N with names that end with _um_n.
    #[arg(long, value_name = "FILE.csv", required_unless_present = "y")]
    pub x: Option<InPath>,
    /// The response across the feed.
    #[arg(long, value_name = "FILE.csv")]
    pub y: Option<InPath>,
    /// Number of modes of each direction; without it as many as there are peaks, up to 8.
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=8))]
    pub modes: Option<u32>,
    /// Where to write the structure's file, which `--structure` reads.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
pub fn execute(args: &IdentifyStructureArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let mut fits = Vec::new();
    for (axis, path) in [(TipAxis::X, &args.x), (TipAxis::Y, &args.y)] {
        let Some(path) = path else { continue };
        let fault = |problem: String| format!("{path}: {problem}");
        let response = MeasuredResponse::read(&path.text()?).map_err(fault)?;
        let count = args.modes.map(|count| count as usize);
        fits.push((axis, path, identify_structure(&response, axis, count).map_err(fault)?));
    }
    let modes = TipModes::new(fits.iter().flat_map(|(_, _, fit)| fit.modes.clone()).collect())?;
    if let Some(path) = &args.out {
        let sources: Vec<String> =
            fits.iter().map(|(axis, path, _)| format!("{} from {path}", axis.id())).collect();
        let title = "Measured modes at the tool's tip".to_owned();
        path.write(&TipModesFile { title, source: sources.join(", "), modes }.write())?;
    }
    if args.json {
        let told: Vec<_> = fits
            .iter()
            .map(|(axis, path, fit)| {
                let modes: Vec<_> = fit
                    .modes
                    .iter()
                    .zip(&fit.estimated)
                    .map(|(mode, [frequency, damping, mass])| {
                        json!({
                            "frequency_hz": mode.frequency_hz, "damping_ratio": mode.damping_ratio,
                            "mass_kg": mode.mass_kg, "stiffness_n_m": mode.stiffness_n_m(),
                            "half_95": {
                                "frequency_hz": frequency.half, "damping_ratio": damping.half,
                                "mass_kg": mass.half,
                            },
                        })
                    })
                    .collect();
                json!({
                    "axis": axis, "data": path.to_string(), "modes": modes,
                    "residual_m_n": fit.residual_m_n, "rest": fit.rest,
                })
            })
            .collect();
        writeln!(out, "{}", serde_json::to_string_pretty(&json!({ "fits": told }))?)?;
        return Ok(ExitCode::SUCCESS);
    }
    for (axis, path, fit) in &fits {
        writeln!(
            out,
            "{}, {path}: {:.2} % of it is left; +- is half a 95 % interval",
            axis.label(),
            100.0 * fit.rest
        )?;
        for (mode, [frequency, damping, mass]) in fit.modes.iter().zip(&fit.estimated) {
            writeln!(
                out,
                "  {:>24}  damping {}  {} kg  {:.4e} N/m",
                told(*frequency, 2, "Hz"),
                told(*damping, 5, ""),
                told(*mass, 6, ""),
                mode.stiffness_n_m()
            )?;
        }
        writeln!(
            out,
            "  flexibility of stiffer modes {:.3e} m/N, which is no mode",
            fit.residual_m_n
        )?;
    }
    if let Some(path) = &args.out {
        writeln!(out, "\nstructure written to {path}")?;
    }
    Ok(ExitCode::SUCCESS)
}

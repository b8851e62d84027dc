//! Modes, frequency response and the calibrated roughness of the machine.

use std::fmt::Write as _;
use std::process::ExitCode;

use serde_json::json;

use super::args::MachineModel;
use super::model::{deliver, name, scenario};
use crate::cli::Outcome;
use crate::models::structure::FiveMass;
use crate::models::structure::frf::{FrequencyResponse, frequencies_hz, gauss};
use crate::models::structure::modes::{damped, undamped};
use crate::models::structure::parameters::NODES;
use crate::study::machine_life::calibration::{CalibratedRow, calibrate};
use crate::study::uses::Reader;

pub(super) fn modes(model: &MachineModel) -> Outcome {
    let scenario = scenario(model, Reader::MachineModes)?;
    let machine = FiveMass::new(&scenario.machine);
    let missing = "the eigenvalues of this machine do not converge";
    let (free, modes) = (undamped(&machine).ok_or(missing)?, damped(&machine).ok_or(missing)?);
    let still = machine.static_compliance();
    let mut text = String::new();
    if model.json {
        let undamped: Vec<_> = free
            .iter()
            .map(|mode| json!({"frequency_hz": mode.frequency_hz, "shape": mode.shape}))
            .collect();
        let damped: Vec<_> = modes
            .iter()
            .map(|mode| {
                json!({
                    "natural_hz": mode.natural_hz(), "damped_hz": mode.damped_hz(),
                    "damping_ratio": mode.damping_ratio(),
                    "pole_re": mode.pole.re, "pole_im": mode.pole.im,
                    "residue_re": mode.residue.re, "residue_im": mode.residue.im,
                })
            })
            .collect();
        let object = json!({
            "variant": scenario.machine.variant.id(),
            "parameters": scenario.machine.parameters.id(),
            "spindle_quality": scenario.machine.spindle_quality,
            "nodes": NODES, "undamped": undamped, "damped": damped,
            "static_compliance_m_n": {
                "h33": still.h33_m_n, "hww": still.hww_m_n,
                "h3w": still.h3w_m_n, "grel": still.grel_m_n,
            },
        });
        writeln!(text, "{object:#}")?;
    } else {
        writeln!(
            text,
            "{}\n\nwithout damping; shapes by the largest displacement",
            name(&scenario)
        )?;
        write!(text, "{:>16}", "Hz")?;
        NODES.iter().try_for_each(|node| write!(text, "{node:>14}"))?;
        for mode in &free {
            write!(text, "\n{:>16.4}", mode.frequency_hz)?;
            let largest = mode.shape.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            mode.shape.iter().try_for_each(|x| write!(text, "{:>14.4}", x / largest))?;
        }
        writeln!(text, "\n\nwith damping\n{:>16}{:>16}{:>14}", "natural Hz", "damped Hz", "ratio")?;
        for mode in &modes {
            let (natural, turning) = (mode.natural_hz(), mode.damped_hz());
            writeln!(text, "{natural:>16.4}{turning:>16.4}{:>14.6}", mode.damping_ratio())?;
        }
        writeln!(text, "\nat rest, m/N")?;
        for (label, value) in [
            ("tooth", still.h33_m_n),
            ("work", still.hww_m_n),
            ("across", still.h3w_m_n),
            ("between tooth and work", still.grel_m_n),
        ] {
            writeln!(text, "  {label:<24}{value:.6e}")?;
        }
    }
    deliver(model, &text)?;
    Ok(ExitCode::SUCCESS)
}

pub(super) fn roughness(model: &MachineModel) -> Outcome {
    let scenario = scenario(model, Reader::MachineRoughness)?;
    let found = calibrate(&scenario);
    let mut text = String::new();
    if model.json {
        writeln!(text, "{:#}", json!(found))?;
    } else {
        writeln!(text, "{}\nr_d calibrated on Table 3 of 2007\n", name(&scenario))?;
        writeln!(
            text,
            "{:>4}{:>10}{:>10}{:>10}{:>10}{:>14}{:>10}",
            "sim", "force N", "Ra um", "K5 um", "off", "vibration um", "off"
        )?;
        for row in &found.rows {
            let CalibratedRow { sim, force_n, ra_printed_um: printed, .. } = *row;
            let (k5, vibration) = (row.ra_k5_um, row.ra_vibration_um);
            writeln!(
                text,
                "{sim:>4}{force_n:>10.2}{printed:>10.3}{k5:>10.3}{:>10.3}{vibration:>14.3}{:>10.3}",
                k5 - printed,
                vibration - printed
            )?;
        }
        writeln!(
            text,
            "\nr_d = {:.4}; rms of the residuals: vibration {:.3} um, K5 {:.3} um\nThe vibration alone \
             does not give the table's Ra: no agreement is claimed. A coupled run adds the change by \
             the teeth's marks to K5.",
            found.random_ratio, found.rms_vibration_um, found.rms_k5_um
        )?;
    }
    deliver(model, &text)?;
    Ok(ExitCode::SUCCESS)
}

const COLUMNS: [&str; 9] =
    ["f_hz", "h33_re", "h33_im", "hww_re", "hww_im", "h3w_re", "h3w_im", "grel_re", "grel_im"];

fn numbers(response: &FrequencyResponse) -> [f64; 9] {
    let FrequencyResponse { f_hz, h33, hww, h3w, grel } = response;
    [*f_hz, h33.re, h33.im, hww.re, hww.im, h3w.re, h3w.im, grel.re, grel.im]
}

pub(super) fn frf(model: &MachineModel) -> Outcome {
    let scenario = scenario(model, Reader::MachineFrf)?;
    let machine = FiveMass::new(&scenario.machine);
    let sweep: Option<Vec<FrequencyResponse>> =
        frequencies_hz().map(|f| gauss(&machine, f)).collect();
    let sweep = sweep.ok_or("this machine's equations are singular")?;
    let mut text = String::new();
    if model.json {
        let row = |response: &FrequencyResponse| {
            let cells = COLUMNS.iter().zip(numbers(response));
            let cells: Vec<String> =
                cells.map(|(name, x)| format!("\"{name}\": {}", json!(x))).collect();
            format!("{{{}}}", cells.join(", "))
        };
        let rows: Vec<String> = sweep.iter().map(row).collect();
        writeln!(text, "[{}]", rows.join(",\n "))?;
    } else {
        writeln!(text, "{}; m/N", name(&scenario))?;
        COLUMNS.iter().try_for_each(|column| write!(text, "{column:>15}"))?;
        for response in &sweep {
            let [f_hz, rest @ ..] = numbers(response);
            write!(text, "\n{f_hz:>15}")?;
            rest.iter().try_for_each(|x| write!(text, "{x:>15.6e}"))?;
        }
        writeln!(text)?;
    }
    deliver(model, &text)?;
    Ok(ExitCode::SUCCESS)
}

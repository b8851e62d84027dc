//! `steadycut machine wear` and `machine life`: the five-mass machine over the tool's life, and the
//! life predicted from its sound.

use std::fmt::Write as _;
use std::process::ExitCode;

use serde::Serialize;
use serde_json::json;

use super::args::{LifeArgs, MachineModel};
use super::model::{deliver, name, scenario};
use crate::cli::{Outcome, progress};
use crate::models::machine_trend::TrendPoint;
use crate::models::roughness_profile::Roughness;
use crate::models::tool_life::Growth;
use crate::run::scenario::Scenario;
use crate::study::machine_life::adaptive::{AdaptiveLife, Minute};
use crate::study::machine_life::measurement::measure;
use crate::study::machine_life::monte_carlo::{
    Judgement, LifeMonteCarlo, REFERENCE_PERCENT, SHARES, Tools,
};
use crate::study::machine_life::surface::surface;
use crate::study::machine_life::{CLAIMS, LifeFindings, LifeJob};
use crate::study::uses::Reader;

/// Fractions of the life at which the trends are printed.
const PRINTED: [f64; 10] = [0.0, 0.02, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95, 1.0];
/// Fractions of the life at which a profile is measured.
const MEASURED: [f64; 3] = [0.0, 0.5, 1.0];

#[derive(Serialize)]
struct Surface {
    x: f64,
    /// Ra, Rq, Rz in um; none where the profile cannot be measured.
    ra_um: Option<f64>,
    rq_um: Option<f64>,
    rz_um: Option<f64>,
}

fn surfaces(scenario: &Scenario, job: &LifeJob) -> Vec<Surface> {
    let at = |x: f64| {
        let (runout_um, seed) = (scenario.tool.runout_um, u64::from(scenario.run.seed));
        let found = surface(job.model(), &scenario.profile, runout_um, x, seed);
        let of = |value: fn(&Roughness) -> f64| found.as_ref().map(value);
        let (ra_um, rq_um) = (of(|found| found.ra_um), of(|found| found.rq_um));
        let rz_um = of(|found| found.rz_um);
        Surface { x, ra_um, rq_um, rz_um }
    };
    MEASURED.into_iter().map(at).collect()
}

fn r(correlation: Option<f64>) -> String {
    correlation.map_or("-".to_owned(), |r| format!("{r:.5}"))
}

pub fn wear(args: &MachineModel) -> Outcome {
    let scenario = scenario(args, Reader::MachineWear)?;
    let mut job = LifeJob::of(&scenario);
    progress::work(&mut job, "tool life", args.json)?;
    let findings = job.findings().ok_or("the life is not over")?;
    let measured = measure(
        job.points(),
        &findings.first_spectrum,
        &scenario.life,
        u64::from(scenario.run.seed),
    );
    let rows: Vec<TrendPoint> = PRINTED.iter().map(|x| job.model().at(*x)).collect();
    let surfaces = surfaces(&scenario, &job);
    let mut text = String::new();
    if args.json {
        let every_minute: Vec<&TrendPoint> = job.points().iter().step_by(60).collect();
        let object = json!({
            "step_s": job.step_s(), "points": job.points().len(), "rows": rows,
            "trend_every_60_steps": every_minute, "findings": findings, "surface": surfaces,
            "measurement": { "trend_r": measured.trend_r, "spectrum_r": measured.spectrum_r,
                "note": "noise is a setting; no measurement is published" },
            "claims_of_the_paper": CLAIMS,
        });
        writeln!(text, "{object:#}")?;
    } else {
        writeln!(text, "{}; {} solutions over the life\n", name(&scenario), job.points().len())?;
        trends(&mut text, &rows, &findings)?;
        writeln!(text, "\nvirtual measurement, its noise a setting and no validation")?;
        writeln!(text, "  sound trend R {}", r(measured.trend_r))?;
        writeln!(text, "  sound spectrum R {}", r(measured.spectrum_r))?;
        writeln!(text, "\nthe paper")?;
        CLAIMS.iter().try_for_each(|claim| writeln!(text, "  {claim}"))?;
        writeln!(
            text,
            "\nprofile with run-out {} um, filtered at {} mm\n{:>6}{:>10}{:>10}{:>10}",
            scenario.tool.runout_um, scenario.profile.long_mm, "x", "Ra um", "Rq um", "Rz um"
        )?;
        for Surface { x, ra_um, rq_um, rz_um } in &surfaces {
            let cell = |um: &Option<f64>| um.map_or("-".to_owned(), |um| format!("{um:.4}"));
            let [ra, rq, rz] = [ra_um, rq_um, rz_um].map(cell);
            writeln!(text, "{x:>6}{ra:>10}{rq:>10}{rz:>10}")?;
        }
    }
    deliver(args, &text)?;
    Ok(ExitCode::SUCCESS)
}

fn trends(text: &mut String, rows: &[TrendPoint], findings: &LifeFindings) -> std::fmt::Result {
    writeln!(
        text,
        "{:>6}{:>10}{:>9}{:>10}{:>14}{:>14}{:>10}",
        "x", "wear", "VB mm", "force N", "sound", "vibration m", "Ra um"
    )?;
    for row in rows {
        writeln!(
            text,
            "{:>6}{:>10.6}{:>9.4}{:>10.3}{:>14.6e}{:>14.6e}{:>10.6}",
            row.x, row.wear, row.flank_mm, row.force_n, row.sound, row.vibration_rms_m, row.ra_um
        )?;
    }
    let LifeFindings { sound_ratio, vibration_ratio, ra_ratio, largest_difference, .. } = findings;
    writeln!(
        text,
        "\nend over start: sound {sound_ratio:.4}, vibration {vibration_ratio:.4}, Ra {ra_ratio:.4}"
    )?;
    writeln!(text, "correlation of sound and roughness {}", r(findings.sound_roughness_r))?;
    writeln!(text, "correlation of sound and vibration {}", r(findings.sound_vibration_r))?;
    writeln!(
        text,
        "largest difference of the two trends, each from 0 to 1: {largest_difference:.3}"
    )
}

/// A group of tools and how well their lives were predicted.
#[derive(Serialize)]
struct Group {
    id: &'static str,
    tools: &'static str,
    prior_error_percent: f64,
    predictions: Vec<Judgement>,
    reference_life_error_percent: Option<[f64; SHARES.len()]>,
}

fn groups(scenario: &Scenario, count: u32, quiet: bool) -> Result<Vec<Group>, progress::NotDone> {
    let model = crate::study::machine_life::model(scenario);
    let calibrated = Growth::calibrated(&model);
    let linear = Growth::linear(calibrated.lambda());
    let group = |[id, tools]: [&'static str; 2],
                 believed: &Growth,
                 truth: &Growth,
                 other_shapes,
                 reference| {
        let setup = Tools {
            wear: model.wear.clone(),
            life: model.life.clone(),
            believed: believed.clone(),
            truth: truth.clone(),
            prior_min: model.wear.usual_life_min(&model.cut),
            other_shapes,
            seed: u64::from(scenario.run.seed),
        };
        let mut study = LifeMonteCarlo::new(setup, count as usize);
        progress::work(&mut study, tools, quiet)?;
        Ok(Group {
            id,
            tools,
            prior_error_percent: study.prior_error_percent(),
            predictions: study.table(),
            reference_life_error_percent: reference,
        })
    };
    let [right, other] = REFERENCE_PERCENT;
    Ok(vec![
        group(["linear", "sound in proportion to wear"], &linear, &linear, false, Some(right))?,
        group(
            ["linear_other_shapes", "the same, every tool of its own shape"],
            &linear,
            &linear,
            true,
            Some(other),
        )?,
        group(
            ["calibrated", "sound of the machine, known"],
            &calibrated,
            &calibrated,
            false,
            None,
        )?,
        group(
            ["calibrated_believed_linear", "sound of the machine, believed in proportion"],
            &linear,
            &calibrated,
            false,
            None,
        )?,
    ])
}

fn lived(
    scenario: &Scenario,
    adjusts: bool,
    quiet: bool,
) -> Result<AdaptiveLife, progress::NotDone> {
    let mut life = AdaptiveLife::new(scenario, adjusts);
    progress::work(&mut life, if adjusts { "adjusted speed" } else { "constant speed" }, quiet)?;
    Ok(life)
}

pub fn life(args: &LifeArgs) -> Outcome {
    let scenario = scenario(&args.model, Reader::MachineLife)?;
    let quiet = args.model.json;
    let groups = groups(&scenario, args.tools, quiet)?;
    let (fixed, adjusted) = (lived(&scenario, false, quiet)?, lived(&scenario, true, quiet)?);
    let wanted_min = scenario.life.tool_life_min;
    let mut text = String::new();
    if args.model.json {
        let object = json!({
            "tools": args.tools, "groups": groups,
            "tool_life": { "desired_min": wanted_min, "reached_fixed_min": fixed.end_min(),
                "reached_adjusted_min": adjusted.end_min(), "minutes": adjusted.minutes() },
        });
        writeln!(text, "{object:#}")?;
    } else {
        writeln!(text, "{}; {} tools a group\n", name(&scenario), args.tools)?;
        groups.iter().try_for_each(|group| print(&mut text, group))?;
        writeln!(
            text,
            "desired tool life {wanted_min} min, this tool lives {} of Taylor's life",
            scenario.wear.tool_life_factor
        )?;
        for (what, life) in [("constant speed", &fixed), ("speed adjusted", &adjusted)] {
            let last: Option<&Minute> = life.minutes().last();
            let speed = last.map_or(0.0, |minute| minute.cutting_speed_m_min);
            let reached = life.end_min().map_or("not worn out".to_owned(), |end_min| {
                let off = 100.0 * (end_min / wanted_min - 1.0);
                format!("worn out after {end_min:.1} min ({off:+.1} %)")
            });
            writeln!(text, "  {what:<16}{reached}, at last {speed:.1} m/min")?;
        }
    }
    deliver(&args.model, &text)?;
    Ok(ExitCode::SUCCESS)
}

fn print(text: &mut String, group: &Group) -> std::fmt::Result {
    writeln!(
        text,
        "{}: median errors in percent; the prior alone {:.1}",
        group.tools, group.prior_error_percent
    )?;
    writeln!(
        text,
        "{:>6}{:>8}{:>12}{:>8}{:>20}",
        "x", "life", "reference", "left", "in the 90 % range"
    )?;
    for (i, row) in group.predictions.iter().enumerate() {
        let reference = group.reference_life_error_percent.map(|errors| errors[i].to_string());
        writeln!(
            text,
            "{:>6}{:>8.1}{:>12}{:>8.1}{:>20.0}",
            row.x,
            row.life_error_percent,
            reference.unwrap_or_default(),
            row.remaining_error_percent,
            row.within_range_percent
        )?;
    }
    writeln!(text)
}

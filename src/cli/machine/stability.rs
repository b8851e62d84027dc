//! `steadycut machine stability`: the depth at which the cut chatters, over the speed.

use std::fmt::Write as _;
use std::process::ExitCode;

use serde_json::json;

use super::args::StabilityArgs;
use super::model::{charted_name, deliver, scenario};
use crate::cli::{Outcome, progress};
use crate::study::stability::chart::{BAND_PERCENT, ChartJob, DT_S, LobePoint, Range};
use crate::study::uses::Reader;

/// Greatest depth that is looked at, in depths that are stable at every speed.
const HIGHEST: f64 = 25.0;
/// Speeds that the check asks for.
const CHECKED_SPEEDS: usize = 40;

pub fn execute(args: &StabilityArgs) -> Outcome {
    if args.from >= args.to && args.speeds > 1 {
        return Err(format!("--from {} must be below --to {}", args.from, args.to).into());
    }
    let scenario = scenario(&args.model, Reader::MachineStability)?;
    let mut range = Range {
        from_rpm: args.from,
        to_rpm: args.to,
        speeds: args.speeds,
        highest_mm: f64::MAX,
        simulate: args.check,
    };
    range.highest_mm = HIGHEST * ChartJob::new(&scenario, range)?.any_speed_mm();
    let mut job = ChartJob::new(&scenario, range)?;
    progress::work(&mut job, "stability", args.model.json)?;
    let points = job.points();
    let worst = [0, 1].map(|which| worst(&points, which));
    let (cut, asked) = (job.cut(), if job.cut().simulates_mean() { 0..2 } else { 1..2 });
    let agreed = worst[asked.clone()].iter().all(|(speeds, _)| *speeds >= CHECKED_SPEEDS)
        && points.iter().all(|point| point.agrees(cut));
    let ([radial_depth_mm, diameter_mm], (teeth, mean_teeth)) = (cut.width_mm(), cut.teeth());
    let mut text = String::new();
    if args.model.json {
        let mut object = json!({
            "variant": scenario.machine.variant.id(),
            "parameters": scenario.machine.parameters.id(),
            "spindle_quality": scenario.machine.spindle_quality,
            "tip_modes": scenario.machine.tip_modes.all().len(),
            "radial_depth_mm": radial_depth_mm,
            "diameter_mm": diameter_mm,
            "teeth": teeth,
            "mean_teeth": mean_teeth,
            "stiffness_per_mm": cut.stiffness_per_mm(),
            "any_speed_mm": job.any_speed_mm(),
            "highest_mm": range.highest_mm,
            "points": points,
        });
        if args.check {
            let verdict = |(speeds, percent): (usize, f64)| json!({"speeds": speeds, "worst_percent": percent});
            object["check"] = json!({
                "mean": cut.simulates_mean().then(|| verdict(worst[0])),
                "interrupted": verdict(worst[1]),
                "agreed": agreed,
            });
        }
        writeln!(text, "{object:#}")?;
    } else {
        writeln!(
            text,
            "{}\ncut: {};\n{:.4} teeth in the cut on the average, {:.4e} N/m per mm of depth",
            charted_name(&scenario),
            cut.engagement_text(),
            mean_teeth,
            cut.stiffness_per_mm()
        )?;
        if job.any_speed_mm().is_finite() {
            writeln!(
                text,
                "stable at every speed up to {:.3} mm; looked at up to {:.1} mm\n",
                job.any_speed_mm(),
                range.highest_mm
            )?;
        } else {
            writeln!(text, "no chatter: the chip does not feel the displacement\n")?;
        }
        print(&mut text, args.check, &points)?;
        if args.check {
            let how = match cut.simulates_mean() {
                true => format!("steps of {DT_S} s"),
                false => "Runge-Kutta, 60 steps to a period of the highest mode".to_owned(),
            };
            for (label, (speeds, percent)) in
                ["mean", "interrupted"].iter().zip(worst).skip(asked.start)
            {
                writeln!(
                    text,
                    "{label}: simulation ({how}) off its chart by at most {percent:+.2} % at \
                     {speeds} of {} speeds",
                    points.len()
                )?;
            }
            for point in points.iter().filter(|point| point.interrupted_beside_mm.is_some()) {
                writeln!(
                    text,
                    "at {} 1/min the limit jumps: {} mm half a percent beside this speed, as simulated",
                    point.speed_rpm,
                    cell(point.interrupted_beside_mm)
                )?;
            }
            let verdict = if agreed { "agreed" } else { "NOT agreed" };
            writeln!(
                text,
                "within {BAND_PERCENT} % at every speed, {CHECKED_SPEEDS} or more of them: {verdict}"
            )?;
        }
    }
    deliver(&args.model, &text)?;
    Ok(if args.check && !agreed { ExitCode::from(1) } else { ExitCode::SUCCESS })
}

/// Number of speeds at which simulation and chart are within the band, and their largest
/// difference there in percent.
fn worst(points: &[LobePoint], which: usize) -> (usize, f64) {
    let found = points.iter().filter_map(|point| point.differences_percent()[which]);
    let within: Vec<f64> = found.filter(|percent| percent.abs() <= BAND_PERCENT).collect();
    let worst = within.iter().copied().max_by(|x, y| x.abs().total_cmp(&y.abs()));
    (within.len(), worst.unwrap_or(0.0))
}

fn cell(value: Option<f64>) -> String {
    value.map_or("-".to_owned(), |x| format!("{x:.3}"))
}

fn print(text: &mut String, simulated: bool, points: &[LobePoint]) -> std::fmt::Result {
    write!(text, "{:>10}{:>12}{:>10}{:>14}", "1/min", "lobes mm", "at Hz", "interrupted")?;
    if simulated {
        write!(text, "{:>14}{:>8}{:>16}{:>8}", "simulated", "%", "sim. interrupted", "%")?;
    }
    writeln!(text)?;
    for point in points {
        write!(
            text,
            "{:>10.1}{:>12}{:>10}{:>14}",
            point.speed_rpm,
            cell(point.mean_mm),
            point.mean_chatter_hz.map_or("-".to_owned(), |f| format!("{f:.2}")),
            cell(point.interrupted_mm)
        )?;
        if simulated {
            let [mean, interrupted] = point
                .differences_percent()
                .map(|x| x.map_or("-".to_owned(), |x| format!("{x:+.2}")));
            write!(
                text,
                "{:>14}{mean:>8}{:>16}{interrupted:>8}",
                cell(point.simulated_mean_mm),
                cell(point.simulated_interrupted_mm)
            )?;
        }
        writeln!(text)?;
    }
    Ok(())
}

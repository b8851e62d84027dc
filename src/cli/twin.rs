//! The constant feed that stands beside a run: found, cut and compared.

use std::io::Write;

use serde::Serialize;

use super::progress;
use crate::run::against_twin::{TimeJudged, compare};
use crate::run::constant_feed_twin::{self, BesideRun};
use crate::run::job::Job;
use crate::run::one_run::Run;
use crate::run::scenario::TwinKind;
use crate::study::safe_feed::{SafeFeed, SafeFeedJob, SafeFeedProblem, twin_scenario};

/// The twin of a run that is over, cut to its end.
pub struct TwinCut {
    twin: Run,
    /// Why there is no safe feed, where one was asked for.
    none_safe: Option<String>,
}

/// What is told of it.
#[derive(Serialize)]
pub struct TwinTold {
    /// Which constant feed it is.
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    no_safe_feed: Option<String>,
    feed_mm_min: f64,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    cut_feeds_mm_min: Vec<f64>,
    spindle_rpm: f64,
    time_of_cut_s: f64,
    path_mm: f64,
    in_tolerance_percent: Option<f64>,
    above_tolerance_percent: Option<f64>,
    /// Whether that is of Ra with dynamics: the machine vibrates in the cut.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    with_dynamics: bool,
    end_text: String,
    /// Whether the run and its twin are nowhere rougher than allowed, but on what a target that is held may miss.
    run_holds: Option<bool>,
    twin_holds: Option<bool>,
    /// On the way that both have done.
    time_saved_s: f64,
    /// None where one of them does not hold.
    time_saved_percent: Option<f64>,
    #[serde(skip)]
    run_above_percent: Option<f64>,
    #[serde(skip)]
    name: &'static str,
}

impl TwinCut {
    /// The twin that the run's scenario asks for.
    pub fn of(run: &Run, quiet: bool) -> Result<Self, Box<dyn std::error::Error>> {
        let safe = match run.scenario().twin.kind {
            TwinKind::Safe => {
                let mut search = SafeFeedJob::new(SafeFeedProblem::of(run));
                progress::work(&mut search, "safe constant feed", quiet)?;
                search.partial()
            }
            TwinKind::Programmed => None,
        };
        let none_safe = match &safe {
            Some(SafeFeed::NoneHolds(none)) => Some(none.to_string()),
            Some(SafeFeed::Found(_)) | None => None,
        };
        let mut beside = BesideRun::of(run, &twin_scenario(run.scenario(), safe.as_ref()));
        progress::work(&mut beside, "constant feed", quiet)?;
        Ok(Self { twin: beside.into_twin(), none_safe })
    }

    /// The twin.
    pub fn run(&self) -> &Run {
        &self.twin
    }

    /// What is told of it beside its run.
    pub fn told(&self, run: &Run) -> TwinTold {
        let scenario = self.twin.scenario();
        let metrics = self.twin.metrics();
        let compared = compare(run, run.recording().rows().len(), &self.twin);
        let percent = match compared.time_judged() {
            TimeJudged::AtEqualQuality(percent) => Some(percent),
            TimeJudged::NotCompared(_) => None,
        };
        TwinTold {
            kind: scenario.twin.kind.id(),
            no_safe_feed: self.none_safe.clone(),
            feed_mm_min: scenario.program.feed_mm_min,
            cut_feeds_mm_min: match scenario.workpiece.cuts.is_empty() {
                true => Vec::new(),
                false => scenario.program.cut_feeds_mm_min.clone(),
            },
            spindle_rpm: scenario.program.spindle_rpm,
            time_of_cut_s: metrics.time_of_cut_s,
            path_mm: metrics.path_mm,
            in_tolerance_percent: metrics.judged_in_tolerance_percent(),
            above_tolerance_percent: metrics.judged_above_tolerance_percent(),
            with_dynamics: metrics.in_tolerance_dyn_percent.is_some(),
            end_text: self.twin.end().map(ToString::to_string).unwrap_or_default(),
            run_holds: compared.chosen.not_above(),
            twin_holds: compared.twin.not_above(),
            time_saved_s: compared.time_saved_s,
            time_saved_percent: percent,
            run_above_percent: compared.chosen.judged_above_tolerance_percent(),
            name: constant_feed_twin::name(scenario),
        }
    }
}

impl TwinTold {
    /// Which twin it is, and its feed.
    fn named(&self) -> String {
        let feeds = match &self.cut_feeds_mm_min[..] {
            [] => format!("{:.0} mm/min", self.feed_mm_min),
            several => {
                let [low, high] = crate::base::math::extent(several.iter().copied());
                format!("{low:.0} to {high:.0} mm/min by cut")
            }
        };
        let programmed = if self.kind == TwinKind::Safe.id() { "" } else { ", as programmed" };
        format!("{}{programmed}: {feeds} at {:.0} 1/min", self.name, self.spindle_rpm)
    }

    /// Prints it in lines as those of the run.
    pub fn print(&self, out: &mut impl Write) -> std::io::Result<()> {
        let share =
            |value: Option<f64>| value.map_or("no contact".to_owned(), |x| format!("{x:.1} %"));
        let held = |holds: Option<bool>| match holds {
            Some(true) => "held it",
            Some(false) => "did not hold it",
            None => "is not known to have held it",
        };
        let above = [self.above_tolerance_percent, self.run_above_percent];
        let most = above.into_iter().flatten().fold(0.0, f64::max);
        let equal = match most {
            none if none < 0.05 => "neither above the tolerance".to_owned(),
            most => format!("at most {most:.1} % above the tolerance"),
        };
        let saved = match self.time_saved_percent {
            Some(saved) if saved.abs() < 0.05 => format!("takes as long, {equal}"),
            Some(saved) if saved > 0.0 => {
                format!("saves {saved:.1} % of the time ({:.2} s), {equal}", self.time_saved_s)
            }
            Some(lost) => {
                format!("takes {:.1} % longer ({:.2} s), {equal}", -lost, -self.time_saved_s)
            }
            None => format!(
                "times are not compared: the run {}, the {} {}",
                held(self.run_holds),
                self.name,
                held(self.twin_holds)
            ),
        };
        if let Some(none) = &self.no_safe_feed {
            writeln!(
                out,
                "  {:<24}{none}; compared with the programmed one",
                "safe constant feed"
            )?;
        }
        for (name, value) in [
            ("compared with", self.named()),
            ("  its time of cut", format!("{:.3} s, {:.2} mm", self.time_of_cut_s, self.path_mm)),
            (
                if self.with_dynamics {
                    "  its Ra, with dynamics"
                } else {
                    "  its Ra in tolerance"
                },
                share(self.in_tolerance_percent),
            ),
            (
                "  above the tolerance",
                format!(
                    "{}; the run {} (at most {:.0} % count as held)",
                    share(self.above_tolerance_percent),
                    share(self.run_above_percent),
                    100.0 - crate::run::metrics::HELD_PERCENT
                ),
            ),
            ("  the run", saved),
        ] {
            writeln!(out, "  {name:<24}{value}")?;
        }
        Ok(())
    }
}

//! What a run of a comparison is judged by.

use serde::Serialize;

use super::outside::Outside;
use crate::base::language::text;
use crate::base::units::percent_from_ratio;
use crate::blocks::control::ControllerKind;
use crate::blocks::reference::Reference;
use crate::run::one_run::{End, Run};
use crate::run::signals::{Row, flag};
use crate::run::story::{EventKind, Story};

/// Samples of the running mean that is judged for recovery: run-out makes one peak high and the
/// next one low, four control periods hold two revolutions.
const MEAN_OF: usize = 4;
/// Half width of the band around the desired force, as a fraction of it (2005: within 10 %).
const BAND: f64 = 0.1;
/// A share of the length from this one on is all of it, percent.
const ALL_PERCENT: f64 = 99.95;

steadycut_core::choice! {
    /// What runs are compared by.
    pub enum Measure {
        /// Normalised standard error of the force: root of the mean of ((F - F_ref) / F_ref)^2 over all
        /// control samples in contact.
        Nsn = "normalized_standard_error", "Nsn";
        /// The same over 20 samples, the paper's form.
        Nsn20 = "normalized_standard_error_20", "Nsn, 20 samples";
        /// Time of the cut; none for a run that did not come to the end of the part.
        Time = "time_of_cut_s", "Time of cut";
        /// Largest force.
        Force = "max_force_kn", "Largest force";
        /// Fraction of the length in contact with the target in tolerance; of Ra with dynamics where the machine
        /// vibrates in the cut.
        InTolerance = "in_tolerance_percent", "In tolerance";
        /// Fraction of the control samples in contact, and not at a limit of the feed, whose force lies
        /// within 10 % of the desired one.
        Held = "held_percent", "Force within 10 %";
        /// Longest time that the mean of four samples stayed more than 10 % above the desired
        /// force, in control periods: how long an overload lasts at worst.
        Recovery = "recovery_periods", "Longest overload";
        /// Travel of the feed override per second: what the control costs the drives.
        Travel = "override_travel_percent_s", "Override travel";
    }
}

impl Measure {
    /// Its name with what it is of, where `reference` is to be held: Ra or the force.
    #[must_use]
    pub fn name(self, reference: Reference) -> &'static str {
        match (self, reference) {
            (Self::InTolerance, Reference::Ra) => text!("Ra in tolerance"),
            (Self::InTolerance, Reference::Force) => text!("Force in tolerance"),
            (
                Self::Nsn
                | Self::Nsn20
                | Self::Time
                | Self::Force
                | Self::Held
                | Self::Recovery
                | Self::Travel,
                _,
            ) => self.label(),
        }
    }

    /// Its unit; empty for a pure number.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Nsn | Self::Nsn20 => "",
            Self::Time => "s",
            Self::Force => "kN",
            Self::InTolerance | Self::Held => "%",
            Self::Recovery => text!("periods"),
            Self::Travel => "%/s",
        }
    }

    /// Whether it counts only for who holds the tolerance: a short time, a low force or a quiet override
    /// outside it is no gain, and what stands at its limit most is held easily in the rest.
    #[must_use]
    pub fn needs_tolerance(self) -> bool {
        match self {
            Self::Nsn | Self::Nsn20 | Self::InTolerance => false,
            Self::Time | Self::Force | Self::Held | Self::Recovery | Self::Travel => true,
        }
    }

    /// Which value is the better one, in words.
    #[must_use]
    pub fn better(self) -> &'static str {
        if self.more_is_better() { text!("More is better.") } else { text!("Less is better.") }
    }

    /// Whether a larger value is the better one.
    #[must_use]
    pub fn more_is_better(self) -> bool {
        matches!(self, Self::InTolerance | Self::Held)
    }
}

/// What one run gave.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// Normalised standard error over all samples in contact; none without contact.
    pub nsn: Option<f64>,
    /// The same over 20 samples.
    pub nsn_20: Option<f64>,
    /// Time of the cut, s; none if the part was not finished.
    pub time_s: Option<f64>,
    /// Largest force, kN.
    pub force_kn: f64,
    /// Fraction of the length in contact with the target in tolerance, percent.
    pub in_tolerance_percent: Option<f64>,
    /// Fraction of the samples that a controller can hold within 10 %, percent; see [`Measure::Held`].
    pub held_percent: Option<f64>,
    /// Longest overload, control periods; see [`Measure::Recovery`].
    pub recovery_periods: f64,
    /// Travel of the feed override, percent per second.
    pub override_travel_percent_s: f64,
    /// Where what is held lies outside its tolerance; none without contact.
    pub outside: Option<Outside>,
    /// Whether the loop was unstable in any stretch, as the run's story judges it.
    pub unstable: bool,
    /// Whether the machine chattered in any stretch, as the run's story judges it.
    pub chattered: bool,
    /// Whether an overload or a crash stopped the machine.
    pub force_stop: bool,
    /// Digest of the run, which anybody can recompute.
    pub digest: String,
}

impl Outcome {
    /// What a finished run gave.
    #[must_use]
    pub fn of(run: &Run) -> Self {
        let metrics = run.metrics();
        let recording = run.recording();
        let samples: Vec<&Row> = recording.samples(usize::MAX).collect();
        let steps = samples
            .windows(2)
            .map(|pair| (pair[1].feed_override_percent - pair[0].feed_override_percent).abs());
        let story = story_of_swings(run);
        let stretches = |kind| story.stretches_until(kind, f64::INFINITY);
        let unstable = stretches(EventKind::LimitCycle);
        let longest_s = metrics.time_of_cut_s.max(run.scenario().control_period_s());
        Self {
            nsn: metrics.normalized_standard_error,
            nsn_20: metrics.normalized_standard_error_20,
            time_s: (run.end() == Some(&End::PathDone)).then_some(metrics.time_of_cut_s),
            force_kn: metrics.max_force_n / 1000.0,
            // Where nothing can be judged, nothing is said, rather than that nothing holds.
            in_tolerance_percent: metrics
                .judged_in_tolerance_percent()
                .filter(|_| metrics.not_judged_percent.is_none_or(|share| share < ALL_PERCENT)),
            held_percent: held_percent(&samples),
            recovery_periods: longest_overload(&samples) as f64,
            override_travel_percent_s: steps.sum::<f64>() / longest_s,
            outside: Outside::of(run, &unstable),
            unstable: !unstable.is_empty(),
            chattered: !stretches(EventKind::Chatter).is_empty(),
            force_stop: matches!(
                run.end(),
                Some(End::Overload(_) | End::Crash(_) | End::Breakage(_))
            ),
            digest: recording.digest(),
        }
    }

    /// One of its values, if the run gave it.
    #[must_use]
    pub fn get(&self, measure: Measure) -> Option<f64> {
        match measure {
            Measure::Nsn => self.nsn,
            Measure::Nsn20 => self.nsn_20,
            Measure::Time => self.time_s,
            Measure::Force => Some(self.force_kn),
            Measure::InTolerance => self.in_tolerance_percent,
            Measure::Held => self.held_percent,
            Measure::Recovery => Some(self.recovery_periods),
            Measure::Travel => Some(self.override_travel_percent_s),
        }
    }
}

/// The stretches of time in s in which the run's story calls it unstable: the console's judgement.
pub(super) fn unstable(run: &Run) -> Vec<[f64; 2]> {
    story_of_swings(run).stretches_until(EventKind::LimitCycle, f64::INFINITY)
}

/// The story of a run that can swing at all, which costs some time; an empty one of any other: a feed that nothing moves
/// cannot swing with the force, nor a machine that does not vibrate with its teeth.
fn story_of_swings(run: &Run) -> Story {
    let scenario = run.scenario();
    let is_still = scenario.controller.kind == ControllerKind::ConstantFeed
        && scenario.coupled_machine().is_none();
    if is_still { Story::default() } else { Story::of(run, None) }
}

/// Force over desired force as running means of four control samples in contact, with the place of
/// the last sample of each; air begins the mean again.
pub(super) fn means(samples: &[&Row]) -> Vec<(usize, f64)> {
    let mut found = Vec::new();
    for (i, window) in samples.windows(MEAN_OF).enumerate() {
        if window.iter().all(|row| !row.has(flag::AIR)) {
            let sum: f64 = window.iter().map(|row| row.force_n / row.force_ref_n).sum();
            found.push((i + MEAN_OF - 1, sum / MEAN_OF as f64));
        }
    }
    found
}

/// A sample's force follows the commands of the periods before it; a limit counts where it held in
/// the sample itself.
fn held_percent(samples: &[&Row]) -> Option<f64> {
    let free = samples.iter().filter(|row| !row.has(flag::AIR | flag::FEED_SATURATED));
    let (mut all, mut held) = (0_u32, 0_u32);
    for row in free {
        all += 1;
        held += u32::from((row.force_n / row.force_ref_n - 1.0).abs() <= BAND);
    }
    (all > 0).then(|| percent_from_ratio(f64::from(held) / f64::from(all)))
}

fn longest_overload(samples: &[&Row]) -> usize {
    let (mut longest, mut length, mut last) = (0, 0, 0);
    for (i, mean) in means(samples) {
        let over = mean > 1.0 + BAND;
        length = match over {
            true if i == last + 1 => length + 1,
            true => 1,
            false => 0,
        };
        last = i;
        longest = longest.max(length);
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::edits::Edits;
    use crate::run::presets;

    /// Constant feed as well as a controller: chatter is the machine's, whoever has the feed.
    #[test]
    fn a_machine_that_chatters_is_told_of_and_one_that_is_quiet_is_not() {
        for kind in [ControllerKind::ConstantFeed, ControllerKind::Sdnrp] {
            let of = |preset: &str| {
                let mut scenario = presets::load(preset).unwrap();
                scenario.change(|settings| settings.controller.kind = kind).unwrap();
                Outcome::of(&Run::complete(&scenario, &Edits::none()))
            };
            assert!(of("chatter").chattered, "{kind:?}");
            assert!(!of("depth-step").chattered, "{kind:?}");
        }
    }

    #[test]
    fn an_overload_is_counted_where_the_mean_of_four_is_high_and_ends_in_the_air() {
        let row = |force_n: f64, air: bool| Row {
            force_n,
            force_ref_n: 100.0,
            state_flags: if air { f64::from(flag::AIR) } else { 0.0 },
            ..Row::default()
        };
        // Run-out alone is no overload.
        let mut rows: Vec<Row> =
            (0..20).map(|i| row(95.0 + 10.0 * f64::from(i % 2), false)).collect();
        assert_eq!(longest_overload(&rows.iter().collect::<Vec<_>>()), 0);
        rows.extend((0..6).map(|_| row(200.0, false)));
        // The first mean of 110.1 % and more has one high sample in it.
        assert_eq!(longest_overload(&rows.iter().collect::<Vec<_>>()), 6);
        rows.push(row(0.0, true));
        rows.extend((0..5).map(|_| row(200.0, false)));
        assert_eq!(longest_overload(&rows.iter().collect::<Vec<_>>()), 6, "the air parts them");
    }
}

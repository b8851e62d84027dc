//! Where a cut lies outside its tolerance, and what is known of why.

use serde::Serialize;

use crate::base::language::tr;
use crate::base::units::{percent_from_ratio, ratio_from_percent};
use crate::blocks::control::ControllerKind;
use crate::blocks::control::law::{AtRest, Held};
use crate::blocks::reference::Reference;
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};
use crate::run::story::{deviation, shaken_deviation};

/// Shares of the length in contact on which what is held lies outside its tolerance, percent: Ra with dynamics where
/// the machine vibrates in the cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Outside {
    /// Above it.
    pub above_percent: f64,
    /// Below it.
    pub below_percent: f64,
    /// With a command at a limit meanwhile; part of the other two.
    pub at_limit_percent: f64,
    /// With the force itself as far off its reference; part of the first two.
    pub off_force_percent: f64,
    /// With Ra without dynamics inside meanwhile; part of the first two, and nothing where no machine vibrates.
    pub by_vibration_percent: f64,
    /// With the loop unstable meanwhile, as the run's story judges it; part of the first two.
    pub unstable_percent: f64,
}

impl Outside {
    /// Those of a run, from one control sample to the next, with the stretches of time in s in which its story calls
    /// it unstable; none without contact.
    #[must_use]
    pub fn of(run: &Run, unstable: &[[f64; 2]]) -> Option<Self> {
        let target = &run.scenario().target;
        let tolerance = ratio_from_percent(target.tolerance_percent);
        let shakes = run.scenario().machine.coupled && target.reference == Reference::Ra;
        let samples: Vec<&Row> = run.recording().samples(usize::MAX).collect();
        let (mut all_mm, mut parts_mm) = (0.0, [0.0; 6]);
        for pair in samples.windows(2).filter(|pair| !pair[1].has(flag::AIR)) {
            let length_mm = pair[1].position_mm - pair[0].position_mm;
            let quiet = deviation(pair[1], target.reference).unwrap_or(0.0);
            let off = if shakes { shaken_deviation(pair[1]).unwrap_or(0.0) } else { quiet };
            all_mm += length_mm;
            let (above, below) = (off > tolerance, off < -tolerance);
            let limit = (above || below) && pair[1].has(flag::SATURATED);
            let force = deviation(pair[1], Reference::Force).unwrap_or(0.0);
            let off_force = (above || below) && force.abs() > tolerance;
            let shaken = (above || below) && quiet.abs() <= tolerance;
            let at_s = pair[1].time_s;
            let unstable = unstable.iter().any(|[from_s, to_s]| (*from_s..=*to_s).contains(&at_s));
            let swings = (above || below) && unstable;
            let all = [above, below, limit, off_force, shaken, swings];
            for (part_mm, is) in parts_mm.iter_mut().zip(all) {
                *part_mm += if is { length_mm } else { 0.0 };
            }
        }
        let [
            above_percent,
            below_percent,
            at_limit_percent,
            off_force_percent,
            by_vibration_percent,
            unstable_percent,
        ] = parts_mm.map(|part_mm| percent_from_ratio(part_mm / all_mm));
        (all_mm > 0.0).then_some(Self {
            above_percent,
            below_percent,
            at_limit_percent,
            off_force_percent,
            by_vibration_percent,
            unstable_percent,
        })
    }

    /// The mean of several; none of none.
    #[must_use]
    pub fn mean(of: &[Self]) -> Option<Self> {
        let mean = |part: fn(&Self) -> f64| of.iter().map(part).sum::<f64>() / of.len() as f64;
        (!of.is_empty()).then(|| Self {
            above_percent: mean(|one| one.above_percent),
            below_percent: mean(|one| one.below_percent),
            at_limit_percent: mean(|one| one.at_limit_percent),
            off_force_percent: mean(|one| one.off_force_percent),
            by_vibration_percent: mean(|one| one.by_vibration_percent),
            unstable_percent: mean(|one| one.unstable_percent),
        })
    }

    /// Where a run of the scenario lies outside and, as far as that is seen in the run or follows from the law, why;
    /// without a full stop.
    #[must_use]
    pub fn why(&self, scenario: &Scenario) -> String {
        let (control, reference) = (&scenario.controller, scenario.target.reference);
        let [above, below] = [self.above_percent, self.below_percent];
        if above < TOLD_PERCENT && below < TOLD_PERCENT {
            return match reference {
                Reference::Ra => tr("Ra lies within its tolerance wherever it is judged"),
                Reference::Force => tr("the force lies within its tolerance wherever it is judged"),
            }
            .to_owned();
        }
        let out = self.above_percent + self.below_percent;
        let cause = if self.by_vibration_percent >= MOSTLY * out {
            tr("the machine's vibration leaves it, without dynamics Ra is inside").to_owned()
        } else if control.kind == ControllerKind::ConstantFeed {
            tr("feed and speed stay as programmed, whatever the cut does").to_owned()
        } else if control.kind == ControllerKind::Afc && control.afc.references_n.is_empty() {
            tr("it is not taught in, so the feed stays as programmed").to_owned()
        } else if self.unstable_percent >= SELDOM * out {
            // Before the limits: they are what bounds the swing.
            let share = percent_from_ratio(self.unstable_percent / out);
            tr!(
                "on {share:.0} % of that it is unstable, feed and force swing without dying down",
                share = share
            )
        } else if self.at_limit_percent >= MOSTLY * out {
            let share = percent_from_ratio(self.at_limit_percent / out);
            tr!("on {share:.0} % of that a command stands at its limit", share = share)
        } else {
            match (control.kind.held(), control.at_rest()) {
                // Where the force lies off as well, it is the loop and not the model.
                (Held::Force, _)
                    if reference == Reference::Ra && self.off_force_percent < SELDOM * out =>
                {
                    tr("it holds the force, and leaves to the model what Ra that gives").to_owned()
                }
                (Held::Overrides | Held::Roughness | Held::Force, at_rest) => match at_rest {
                    AtRest::WhereTheLawMeetsThePlant => {
                        tr("its law does not integrate: an error remains at rest").to_owned()
                    }
                    AtRest::OnReference | AtRest::NearReference | AtRest::Unknown
                        if scenario.noise.level > 0.0 =>
                    {
                        tr("it takes time after each change, and noise moves it").to_owned()
                    }
                    AtRest::OnReference | AtRest::NearReference | AtRest::Unknown => {
                        tr("it takes time after each change").to_owned()
                    }
                },
            }
        };
        let sides = [above, below].map(|share| share >= TOLD_PERCENT);
        match (reference, sides) {
            (Reference::Ra, [true, true]) => tr!(
                "Ra lies above its tolerance on {above:.0} % and below its tolerance on {below:.0} % of the length: {cause}",
                above = above,
                below = below,
                cause = cause
            ),
            (Reference::Ra, [true, false]) => tr!(
                "Ra lies above its tolerance on {share:.0} % of the length: {cause}",
                share = above,
                cause = cause
            ),
            (Reference::Ra, [false, _]) => tr!(
                "Ra lies below its tolerance on {share:.0} % of the length: {cause}",
                share = below,
                cause = cause
            ),
            (Reference::Force, [true, true]) => tr!(
                "the force lies above its tolerance on {above:.0} % and below its tolerance on {below:.0} % of the length: {cause}",
                above = above,
                below = below,
                cause = cause
            ),
            (Reference::Force, [true, false]) => tr!(
                "the force lies above its tolerance on {share:.0} % of the length: {cause}",
                share = above,
                cause = cause
            ),
            (Reference::Force, [false, _]) => tr!(
                "the force lies below its tolerance on {share:.0} % of the length: {cause}",
                share = below,
                cause = cause
            ),
        }
    }
}

/// Shares of less are not told, percent (chosen).
const TOLD_PERCENT: f64 = 0.5;
/// A force counts as held where it is off, and a loop as stable where it is not, on no more than this fraction of what
/// lies outside (chosen).
const SELDOM: f64 = 0.1;
/// A limit is named where a command stands at it on this fraction of what lies outside, or more (chosen).
const MOSTLY: f64 = 0.5;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::outcome::Outcome;
    use crate::compare::tournament::scenario_of;
    use crate::run::edits::Edits;
    use crate::run::presets;
    use crate::run::scenario::Settings;
    use crate::run::story::{EventKind, Story};

    fn of(changes: impl Fn(&mut Settings)) -> (Outside, String, f64) {
        let scenario = presets::load("first-cut").unwrap().with(changes).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let outside = Outcome::of(&run).outside.unwrap();
        let why = outside.why(&scenario);
        (outside, why, run.metrics().in_tolerance_percent.unwrap())
    }

    /// The console calls it unstable: so does the comparison, and no error "at rest" is made of it.
    #[test]
    fn an_unstable_loop_is_called_so_as_its_story_does() {
        let mut seen = 0;
        for kp in [0.5, 1.5, 3.0] {
            let change = |s: &mut Settings| {
                s.noise.level = 0.0;
                s.controller.sdnrp.kp = kp;
                s.cnc.dead_time_s = 0.3;
            };
            let scenario = presets::load("first-cut").unwrap().with(change).unwrap();
            let story = Story::of(&Run::complete(&scenario, &Edits::none()), None);
            let told = story.events.iter().any(|event| event.id == EventKind::LimitCycle);
            // As a comparison runs it, with a row a control period.
            let run = Run::complete(&scenario_of(&scenario, 1), &Edits::none());
            let outcome = Outcome::of(&run);
            assert_eq!(outcome.unstable, told, "gain {kp}");
            let why = outcome.outside.unwrap().why(&scenario);
            assert_eq!(why.contains("it is unstable"), told, "gain {kp}: {why}");
            assert!(!(told && why.contains("at rest")), "gain {kp}: {why}");
            seen += usize::from(told);
        }
        assert!((1..3).contains(&seen), "{seen} of 3 unstable");
    }

    /// Nothing is put down to noise where there is none.
    #[test]
    fn noise_is_named_only_where_there_is_some() {
        for (level, named) in [(0.0, false), (1.0, true)] {
            let (_, why, _) = of(|s| {
                s.noise.level = level;
                s.controller.kind = ControllerKind::Tracking;
                s.target.tolerance_percent = 1.0;
            });
            assert!(why.contains("takes time after each change"), "{why}");
            assert_eq!(why.contains("noise"), named, "{why}");
        }
    }

    #[test]
    fn the_shares_are_what_the_metrics_leave_and_the_cause_is_that_of_the_run() {
        // Programmed feed gives a rougher surface than is asked for.
        let (constant, why, inside) = of(|s| s.controller.kind = ControllerKind::ConstantFeed);
        let out = constant.above_percent + constant.below_percent;
        assert!((out + inside - 100.0).abs() < 0.2, "{constant:?}, {inside} % inside");
        assert!(constant.above_percent > 50.0 && why.contains("as programmed"), "{why}");
        // A feed that may not go below what is programmed stands at its limit.
        let (limited, why, inside) = of(|s| {
            s.noise.level = 0.0;
            s.cnc.override_min_percent = 95.0;
        });
        let out = limited.above_percent + limited.below_percent;
        assert!((out + inside - 100.0).abs() < 0.2, "{limited:?}, {inside} % inside");
        assert!(limited.at_limit_percent > 50.0 && why.contains("at its limit"), "{why}");
        // Half the tolerance beside the target, with no limit in the way.
        let (proportional, why, _) = of(|s| {
            s.noise.level = 0.0;
            s.target.ra_um = 0.5;
        });
        assert!(proportional.at_limit_percent < 1.0 && why.contains("does not integrate"), "{why}");
    }

    #[test]
    fn nobody_is_said_to_hold_a_force_that_is_not_held() {
        // Proportional control of the force leaves it off its reference in the deeper stretch.
        let kind = |s: &mut crate::run::scenario::Settings| {
            s.controller.kind = ControllerKind::Proportional;
        };
        let scenario = presets::load("depth-step").unwrap().with(kind).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let off = Outcome::of(&run).outside.unwrap();
        let why = off.why(&scenario);
        assert!(
            off.off_force_percent > 20.0 && why.contains("does not integrate"),
            "{off:?}: {why}"
        );
        let (_, why, _) = of(|s| s.controller.kind = ControllerKind::Afc);
        assert!(why.contains("not taught in"), "{why}");
    }
}

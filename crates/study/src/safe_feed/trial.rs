//! A trial: the whole part cut at one constant feed, until it is done or something stands against the feed. Nothing
//! is recorded.

use crate::base::language::tr;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::reference::Reference;
use crate::models::feed_speed::{FeedSpeed, STANDSTILL_MM_MIN};
use crate::run::closed_loop::{ClosedLoop, Halt};
use crate::run::constant_feed_twin::{self, PlacedEdit};
use crate::run::end::End;
use crate::run::job::Budget;
use crate::run::metrics::Judged;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

/// Steps of the plant between two looks at whether the job is cancelled.
const LOOK_TICKS: u64 = 1024;
/// A cut that takes so many times as long as at the feed that it is programmed with does not come to its end.
const TOO_LONG: f64 = 4.0;
/// Vibration that leaves the surface rougher than allowed for less than this is a blow that dies away, as where the
/// tool enters, s (chosen).
const SHAKEN_S: f64 = 0.3;
/// Time that the way to the first place and between cuts may take besides, s.
const BESIDES_S: f64 = 60.0;

/// What stands against a feed.
#[derive(Clone, Debug, PartialEq)]
pub enum Broken {
    /// The surface is rougher than allowed, or the force above its tolerance.
    Above {
        /// Where first, mm along the way.
        at_mm: f64,
        /// What is held there: Ra in um, or the force in N.
        value: f64,
        /// Whether it is Ra.
        of_ra: bool,
    },
    /// The machine vibrates, and leaves the surface rougher than allowed.
    Shaken {
        /// Where first, mm along the way.
        at_mm: f64,
        /// Ra with vibration, um.
        ra_um: f64,
    },
    /// The part is not cut to its end.
    Ends(Box<End>),
    /// It cannot be programmed.
    Refused(String),
    /// It would take too long: the machine does not reach the feed.
    NeverDone,
    /// The surface is known nowhere: it lies outside the model on the whole part.
    NotJudged,
}

impl std::fmt::Display for Broken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Above { at_mm, value, of_ra: true } => f.write_str(&tr!(
                "Ra is {value:.2} um at {place:.1} mm, rougher than allowed",
                value = *value,
                place = *at_mm
            )),
            Self::Above { at_mm, value, of_ra: false } => f.write_str(&tr!(
                "the force is {value:.0} N at {place:.1} mm, above its tolerance",
                value = *value,
                place = *at_mm
            )),
            Self::Shaken { at_mm, ra_um } => f.write_str(&tr!(
                "Ra is {value:.2} um with vibration at {place:.1} mm, rougher than allowed",
                value = *ra_um,
                place = *at_mm
            )),
            Self::Ends(end) => {
                f.write_str(&tr!("the part is not cut to its end ({end})", end = end.to_string()))
            }
            Self::Refused(problem) => f.write_str(problem),
            Self::NeverDone => f.write_str(tr(
                "the part is not cut to its end: the machine does not reach the feed",
            )),
            Self::NotJudged => f.write_str(tr(
                "Ra lies outside its model on the whole part, so nothing can be judged",
            )),
        }
    }
}

/// Time in which a length of path is cut at a feed, or else never, s.
pub(super) fn longest_s(path_mm: f64, feed_mm_min: f64) -> f64 {
    BESIDES_S + TOO_LONG * 60.0 * path_mm / feed_mm_min
}

/// See the head of this file.
#[derive(Clone, Debug)]
pub struct FeedTrial {
    /// None where the feed cannot be programmed.
    cut: Option<Box<Cutting>>,
    verdict: Option<Result<f64, Broken>>,
}

#[derive(Clone, Debug)]
struct Cutting {
    closed_loop: ClosedLoop,
    /// As the edits leave it.
    scenario: Scenario,
    edits: Vec<PlacedEdit>,
    next_edit: usize,
    judged: Judged,
    of_ra: bool,
    /// Whether the machine can vibrate in the cut.
    coupled: bool,
    /// How long vibration has left the surface rougher than allowed, steps.
    shaken: u64,
    /// How long it may, steps.
    shaken_most: u64,
    path_mm: f64,
    last_tick: u64,
    /// Whether the surface was known somewhere.
    known: bool,
}

impl FeedTrial {
    /// The part of a scenario at a feed and speed, with changes at their places.
    #[must_use]
    pub fn new(scenario: &Scenario, edits: &[PlacedEdit], at: FeedSpeed) -> Self {
        let scenario = match constant_feed_twin::scenario_at(scenario, at) {
            Ok(scenario) => scenario,
            Err(refused) => {
                return Self {
                    cut: None,
                    verdict: Some(Err(Broken::Refused(refused.to_string()))),
                };
            }
        };
        let path_mm = ToolPath::length_of(&scenario.workpiece);
        let most_s = longest_s(path_mm, at.feed_mm_min);
        let cutting = Cutting {
            closed_loop: ClosedLoop::new(&scenario),
            edits: edits.to_vec(),
            next_edit: 0,
            judged: Judged::by(&scenario, u64::from(scenario.run.steps_per_control)),
            of_ra: scenario.target.reference == Reference::Ra,
            coupled: scenario.machine.coupled,
            shaken: 0,
            shaken_most: scenario.ticks(SHAKEN_S),
            path_mm,
            last_tick: scenario.ticks(most_s),
            known: false,
            scenario,
        };
        let mut trial = Self { cut: Some(Box::new(cutting)), verdict: None };
        if let Some(cut) = &mut trial.cut {
            trial.verdict = cut.judge().err().map(Err);
        }
        trial
    }

    /// Cuts on; `true` once it is over.
    pub fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let Some(cut) = &mut self.cut else { return true };
        while self.verdict.is_none() {
            let granted = budget.spend(LOOK_TICKS);
            if granted == 0 {
                return false;
            }
            for done in 1..=granted {
                self.verdict = cut.step();
                if self.verdict.is_some() {
                    budget.put_back(granted - done);
                    break;
                }
            }
        }
        true
    }

    /// The time of the cut in s, or what stands against the feed; none before its end.
    #[must_use]
    pub fn verdict(&self) -> Option<Result<f64, Broken>> {
        self.verdict.clone()
    }

    /// Share of the way that is done, from 0 to 1.
    #[must_use]
    pub fn share(&self) -> f64 {
        let Some(cut) = &self.cut else { return 0.0 };
        (cut.closed_loop.row().position_mm / cut.path_mm).clamp(0.0, 1.0)
    }
}

impl Cutting {
    /// One step with the changes that are due at its place; the verdict, where it ends the trial.
    fn step(&mut self) -> Option<Result<f64, Broken>> {
        if let Err(refused) = self.meet() {
            return Some(Err(refused));
        }
        if let Err(halt) = self.closed_loop.step() {
            let end = match halt {
                Halt::Crash(crash) => End::Crash(crash),
                Halt::Breakage(broke) => End::Breakage(broke),
                Halt::Fault(fault) => End::Fault(fault),
                Halt::Script(fault) => End::Script(fault),
            };
            return Some(Err(Broken::Ends(Box::new(end))));
        }
        if let Err(broken) = self.judge() {
            return Some(Err(broken));
        }
        let row = self.closed_loop.row();
        if row.position_mm >= self.path_mm {
            return Some(if self.known { Ok(row.time_s) } else { Err(Broken::NotJudged) });
        }
        if let Some(overload) = self.closed_loop.overload()
            && row.feed_mm_min < STANDSTILL_MM_MIN
        {
            return Some(Err(Broken::Ends(Box::new(End::Overload(overload)))));
        }
        (self.closed_loop.tick() >= self.last_tick).then_some(Err(Broken::NeverDone))
    }

    /// Takes over the changes whose place is reached.
    fn meet(&mut self) -> Result<(), Broken> {
        let here_mm = self.closed_loop.row().position_mm;
        let mut met = false;
        while let Some(next) =
            self.edits.get(self.next_edit).filter(|next| next.place_mm <= here_mm)
        {
            let set = self.scenario.set(&next.edit.path, next.edit.value.clone());
            set.map_err(|refused| Broken::Ends(Box::new(End::Refused(refused))))?;
            self.next_edit += 1;
            met = true;
        }
        if met {
            self.closed_loop.reconfigure(&self.scenario);
        }
        Ok(())
    }

    /// Judges what is left here.
    fn judge(&mut self) -> Result<(), Broken> {
        let row: &Row = self.closed_loop.row();
        if row.has(flag::AIR) {
            return Ok(());
        }
        if self.judged.above(row) {
            let value = if self.of_ra { row.ra_um } else { row.force_n };
            return Err(Broken::Above { at_mm: row.position_mm, value, of_ra: self.of_ra });
        }
        let shaken = self.coupled && self.judged.shaken_above(row);
        self.shaken = if shaken { self.shaken + 1 } else { 0 };
        if self.shaken > self.shaken_most {
            return Err(Broken::Shaken { at_mm: row.position_mm, ra_um: row.ra_dyn_um });
        }
        self.known = self.known || self.judged.knows(row);
        Ok(())
    }
}

//! What the console works on: scenario and edits, the chosen run with its constant-feed twin, the
//! playhead, and the way back. Nothing of it knows how it is drawn.
//!
//! Both runs are simulated ahead to their end, a budget of ticks at a time; the playhead reveals
//! them. A live setting changed while the cut is running becomes an edit at the playhead and the
//! run branches there; every other change is one of the scenario itself, and the runs are done
//! again under a playhead that stays.

mod change;

use super::cut::{Cut, Ghost};
use super::playback::Playback;
use super::twin::{self, Comparison};
use crate::run::constant_feed_twin::{self, SharedEdits};
use crate::run::edits::{Edits, Unfit};
use crate::run::one_run::End;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;
use crate::run::story::Story;

/// Ticks that each run is simulated by in one frame: some milliseconds of work.
const TICKS_PER_FRAME: u64 = 60_000;
/// The same tooth by tooth, where a tick costs some ten times as much.
const TOOTH_TICKS_PER_FRAME: u64 = 12_000;
/// Edits that the twin meets in one frame at most: it is cut again from each of them on.
const EDITS_PER_FRAME: usize = 4;
/// Steps of undo that are kept.
const MAX_UNDO: usize = 200;
/// Messages that are kept.
const MAX_NOTICES: usize = 100;
/// Time between two comparisons while playing, s: numbers that change faster can't be read.
const COMPARE_EVERY_S: f64 = 0.2;
/// A comparison walks over all revealed rows: with more than these it is made less often.
const COMPARE_ROWS: usize = 1_000_000;

/// What times may be off by, having been written in decimals, s.
const HAIR_S: f64 = 1e-6;

/// A message.
#[derive(Clone, Debug, PartialEq)]
pub struct Notice {
    /// Its number: larger than those of all before.
    pub number: u64,
    /// Its text.
    pub text: String,
}

/// A scenario with its edits: what undo goes back to.
type Plan = (Scenario, Edits);

/// See the head of this file.
pub struct Session {
    plan: Plan,
    chosen: Cut,
    twin: Cut,
    /// Where the twin meets the edits that it shares.
    shared: SharedEdits,
    /// Counts the edits that the twin has met.
    met: u64,
    ghost: Option<Ghost>,
    playback: Playback,
    undo: Vec<Plan>,
    redo: Vec<Plan>,
    /// The setting that is being changed without a pause: its changes are one step of undo.
    gesture: Option<String>,
    notices: Vec<Notice>,
    notices_so_far: u64,
    /// Why there is no scenario at the playhead, where that was said.
    refused: Option<String>,
    /// Scenario as it stands at the playhead.
    current: Scenario,
    comparison: Comparison,
    compared: Compared,
    since_comparison_s: f64,
    story: Story,
    told: Compared,
    changes: u64,
}

/// What a comparison or a story was made of: number of changes and of edits that the twin has met, rows (of a comparison those revealed),
/// rows of the twin.
type Compared = (u64, usize, usize);

impl Session {
    /// A session at the start of its run, playing.
    #[must_use]
    pub fn new(scenario: Scenario, edits: Edits) -> Self {
        let (edits, unfit) = edits.fitted(&scenario);
        let chosen = Cut::new(&scenario, &edits);
        let twin = Cut::new(&constant_feed_twin::scenario(&scenario), &Edits::none());
        let comparison = twin::compare(chosen.run(), 1, twin.run());
        let mut session = Self {
            current: scenario.clone(),
            plan: (scenario, edits),
            chosen,
            twin,
            shared: SharedEdits::default(),
            met: 0,
            ghost: None,
            playback: Playback::from_start(),
            undo: Vec::new(),
            redo: Vec::new(),
            gesture: None,
            notices: Vec::new(),
            notices_so_far: 0,
            refused: None,
            comparison,
            compared: (0, 1, 0),
            since_comparison_s: 0.0,
            story: Story::default(),
            told: (0, 0, 0),
            changes: 0,
        };
        session.report(&unfit);
        session.refresh();
        session.tell();
        session
    }

    /// The scenario as it is at the start of the run.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.plan.0
    }

    /// The edits.
    #[must_use]
    pub fn edits(&self) -> &Edits {
        &self.plan.1
    }

    /// The scenario as it stands at the playhead: what the controls show.
    #[must_use]
    pub fn current(&self) -> &Scenario {
        &self.current
    }

    /// The run with the chosen controller.
    #[must_use]
    pub fn chosen(&self) -> &Cut {
        &self.chosen
    }

    /// The same cut at constant feed.
    #[must_use]
    pub fn twin(&self) -> &Cut {
        &self.twin
    }

    /// The chosen run as it was before the last change.
    #[must_use]
    pub fn ghost(&self) -> Option<&Ghost> {
        self.ghost.as_ref()
    }

    /// Playhead, speed, follow mode.
    #[must_use]
    pub fn playback(&self) -> &Playback {
        &self.playback
    }

    /// The comparison with the twin, at most a fifth of a second old while playing.
    #[must_use]
    pub fn comparison(&self) -> &Comparison {
        &self.comparison
    }

    /// What happens in the whole run as far as it is simulated, in sentences; as old as
    /// [`Self::comparison`].
    #[must_use]
    pub fn story(&self) -> &Story {
        &self.story
    }

    /// The messages so far, the newest last; old ones are forgotten at last.
    #[must_use]
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// Counts the changes of scenario and edits.
    #[must_use]
    pub fn changes(&self) -> u64 {
        self.changes
    }

    /// Whether there is something to take back.
    #[must_use]
    pub fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    /// Whether there is something to do again.
    #[must_use]
    pub fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    /// Rows of the chosen run that are revealed; at least one.
    #[must_use]
    pub fn revealed(&self) -> &[Row] {
        let recording = self.chosen.run().recording();
        &recording.rows()[..=recording.index_at(self.playback.playhead_s)]
    }

    /// The row at the playhead.
    #[must_use]
    pub fn row(&self) -> &Row {
        let recording = self.chosen.run().recording();
        &recording.rows()[recording.index_at(self.playback.playhead_s)]
    }

    /// Length of the time axis: the end of the run, or the time limit until that is known.
    #[must_use]
    pub fn length_s(&self) -> f64 {
        if self.chosen.is_over() {
            self.chosen.simulated_s()
        } else {
            self.chosen.run().last_tick() as f64 * self.plan.0.dt_s()
        }
    }

    /// Why the cut is over, once the playhead has come to its end.
    #[must_use]
    pub fn finished(&self) -> Option<&End> {
        self.chosen.run().end().filter(|_| self.playback.at_end)
    }

    /// Fraction of both runs that is simulated, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let share = |cut: &Cut| {
            let run = cut.run();
            if cut.is_over() { 1.0 } else { run.ticks() as f64 / run.last_tick() as f64 }
        };
        0.5 * (share(&self.chosen) + share(&self.twin))
    }

    /// Advances by `dt_s` seconds of real time: simulates ahead and moves the playhead.
    pub fn advance(&mut self, dt_s: f64) {
        let by_teeth = self.current.plant.force_model.tooth_by_tooth();
        let ticks = if by_teeth { TOOTH_TICKS_PER_FRAME } else { TICKS_PER_FRAME };
        for cut in [&mut self.chosen, &mut self.twin] {
            if !cut.is_over() {
                cut.advance(ticks);
            }
        }
        self.meet();
        self.playback.advance(dt_s, self.chosen.simulated_s(), self.chosen.is_over());
        self.since_comparison_s += dt_s;
        self.refresh();
        let rows = self.revealed().len();
        let moving = self.playback.playing || !self.chosen.is_over();
        let pause_s = match (moving, rows / COMPARE_ROWS) {
            (false, 0) => 0.0,
            (_, times) => COMPARE_EVERY_S * (1 + times) as f64,
        };
        if self.comparison_is_due() && self.since_comparison_s >= pause_s {
            self.compare();
        }
    }

    /// Whether the comparison is older than what is shown.
    #[must_use]
    pub fn comparison_is_due(&self) -> bool {
        self.compared != self.to_compare()
    }

    fn to_compare(&self) -> Compared {
        let rows = self.twin.run().recording().rows().len();
        (self.changes + self.met, self.revealed().len(), rows)
    }

    /// Ends the step of undo that a drag has opened.
    pub fn end_gesture(&mut self) {
        self.gesture = None;
    }

    /// Says something; what was said before in the same words is said again in its place.
    pub fn notify(&mut self, text: impl Into<String>) {
        let text = text.into();
        self.notices.retain(|notice| notice.text != text);
        self.notices_so_far += 1;
        self.notices.push(Notice { number: self.notices_so_far, text });
        let over = self.notices.len().saturating_sub(MAX_NOTICES);
        self.notices.drain(..over);
    }

    /// Says which edits were left out, and why.
    fn report(&mut self, unfit: &[Unfit]) {
        if let Some(first) = unfit.first() {
            let more = match unfit.len() - 1 {
                0 => String::new(),
                more => format!(" (and {more} more)"),
            };
            self.notify(format!("Left out{more}: {first}"));
        }
    }

    /// Says how many edits are gone, and which.
    fn report_gone(&mut self, count: usize, which: &str) {
        match count {
            0 => {}
            1 => self.notify(format!("Left out: the change {which}. Undo brings it back.")),
            n => self.notify(format!("Left out: {n} changes {which}. Undo brings them back.")),
        }
    }

    fn refresh(&mut self) {
        let (scenario, edits) = &self.plan;
        match edits.scenario_at(scenario, self.playback.playhead_s + HAIR_S) {
            Ok(current) => (self.current, self.refused) = (current, None),
            Err(refused) => {
                // Said once, though it is found in every frame.
                let refused = Some(refused.to_string());
                if refused != self.refused {
                    self.refused.clone_from(&refused);
                    refused.into_iter().for_each(|text| self.notify(text));
                }
            }
        }
    }

    fn compare(&mut self) {
        self.since_comparison_s = 0.0;
        self.compared = self.to_compare();
        let rows = self.revealed().len();
        self.comparison = twin::compare(self.chosen.run(), rows, self.twin.run());
        self.tell();
    }

    /// Lets the twin meet the next edits at their places, once both runs have come there.
    fn meet(&mut self) {
        for _ in 0..EDITS_PER_FRAME {
            if self.shared.place(self.chosen.run(), self.twin.run()).is_none() {
                return;
            }
            self.met += 1;
            self.twin.change(&constant_feed_twin::scenario(&self.plan.0), &self.shared.edits());
            self.twin.advance(TICKS_PER_FRAME);
        }
    }

    /// Tells the story anew where the runs are others or longer than when it was told.
    fn tell(&mut self) {
        let rows = |cut: &Cut| cut.run().recording().rows().len();
        let now = (self.changes + self.met, rows(&self.chosen), rows(&self.twin));
        if self.told != now {
            self.told = now;
            let twin = Some(self.twin.run());
            self.story = Story::told(self.chosen.run(), self.chosen.scan(), twin);
        }
    }
}

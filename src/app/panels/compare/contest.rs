//! What is compared, and the tournaments so far: a set-up once run is kept, and more seeds go on
//! where fewer ended.

use crate::base::settings::{SettingError, Value};
use crate::blocks::cutting::material::Material;
use crate::run::edits::Edits;
use crate::run::job::{Job, Progress};
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::study::compare::entrants::{BEYOND, Method, TABLE_1};
use crate::study::compare::entrants::{experiment_2, experiment_2_per_cut, on, set_dead_time};
use crate::study::compare::load_step::{self, Transient};
use crate::study::compare::robustness::{self, RobustnessRow};
use crate::study::compare::tournament::{Compared, Tournament};

/// Set-ups whose results are kept.
const KEPT: usize = 12;
/// Seeds of the table of changed conditions.
const ROBUST_SEEDS: u32 = 2;
/// Steps of the plant in a frame: at the start, at least and at most.
const TICKS: [u64; 3] = [20_000, 5_000, 400_000];
/// Time that a frame may take, s: the page stays usable.
const FRAME_S: f64 = 0.04;

steadycut_core::choice! {
    /// The part that is milled.
    pub enum ContestPart {
        /// Experiment 2 of 2005, five straight cuts, one programmed feed: that of Table 1.
        Experiment2 = "experiment_2", "Experiment 2";
        /// The same with a programmed feed for every cut, as the plan finds them for the lightest
        /// sections: beyond the paper.
        PerCut = "per_cut", "Experiment 2, feeds per cut";
        /// The scenario that is open in the console, at its start.
        Open = "open", "Open scenario";
    }
}

steadycut_core::choice! {
    /// Dead time of the machine; the controllers know it.
    pub enum ContestDeadTime {
        /// As the part's scenario has it.
        AsIs = "as_is", "as it is";
        /// None.
        None = "none", "0 ms";
        /// 40 ms, of the 2013 paper.
        Short = "short", "40 ms";
        /// 80 ms, of the 2007 paper.
        Long = "long", "80 ms";
    }
}

steadycut_core::choice! {
    /// Material of the part; no controller is retuned for it.
    pub enum Stock {
        /// As the part's scenario has it.
        AsIs = "as_is", "as it is";
        /// Ck45.
        Ck45 = "ck45", "Ck45";
        /// 16MnCrSi5 XM.
        MnCrSi5 = "16mncrsi5", "16MnCrSi5";
    }
}

/// What is compared.
#[derive(Clone, Debug, PartialEq)]
pub struct ContestSetup {
    /// The part.
    pub part: ContestPart,
    /// The dead time.
    pub dead_time: ContestDeadTime,
    /// The material.
    pub stock: Stock,
    /// Who takes part, in the order of [`methods`].
    pub chosen: Vec<bool>,
}

/// Everybody who can take part.
pub fn methods() -> impl Iterator<Item = &'static Method> {
    TABLE_1.iter().chain(BEYOND)
}

impl Default for ContestSetup {
    fn default() -> Self {
        let (part, dead_time, stock) =
            (ContestPart::Experiment2, ContestDeadTime::AsIs, Stock::AsIs);
        Self { part, dead_time, stock, chosen: methods().map(|_| true).collect() }
    }
}

impl ContestSetup {
    /// The part's scenario as it is milled.
    fn base(&self, open: &Scenario) -> Result<Scenario, SettingError> {
        let mut base = match self.part {
            ContestPart::Experiment2 => experiment_2(),
            ContestPart::PerCut => experiment_2_per_cut(),
            ContestPart::Open => open.clone(),
        };
        let dead_time_s = match self.dead_time {
            ContestDeadTime::AsIs => None,
            ContestDeadTime::None => Some(0.0),
            ContestDeadTime::Short => Some(0.04),
            ContestDeadTime::Long => Some(0.08),
        };
        if let Some(dead_time_s) = dead_time_s {
            base.change(|settings| set_dead_time(settings, dead_time_s))?;
        }
        let material = match self.stock {
            Stock::AsIs => None,
            Stock::Ck45 => Some(Material::Ck45),
            Stock::MnCrSi5 => Some(Material::MnCrSi5),
        };
        if let Some(material) = material {
            base.set("plant.material", Value::Text(material.id().to_owned()))?;
        }
        Ok(base)
    }

    /// Whether the printed table belongs to it.
    fn is_table_1(&self) -> bool {
        self.part == ContestPart::Experiment2
            && matches!(self.dead_time, ContestDeadTime::AsIs | ContestDeadTime::Short)
            && self.stock != Stock::MnCrSi5
    }
}

/// A tournament with what it belongs to.
pub struct Contest {
    base: Scenario,
    chosen: Vec<bool>,
    tournament: Tournament,
    /// The load step of each entrant in turn, and the one that is on its way.
    transients: Vec<Transient>,
    stepping: Option<Box<Run>>,
    /// The table, and the number of runs that it is of.
    table: (f64, Vec<Compared>),
}

impl Contest {
    /// The tournament.
    pub fn tournament(&self) -> &Tournament {
        &self.tournament
    }

    /// How the entrants took the load step, as far as they have.
    pub fn transients(&self) -> &[Transient] {
        &self.transients
    }

    /// Whether the load step belongs to the part: it is made of sections that are milled.
    pub fn has_load_step(&self) -> bool {
        !self.base.workpiece.cuts.is_empty()
    }

    /// Advances by `ticks` steps of the plant; `true` when all is done.
    fn advance(&mut self, ticks: u64) -> bool {
        let entrants = self.tournament.entrants();
        let next = entrants.get(self.transients.len()).filter(|_| self.has_load_step());
        let Some(entrant) = next else { return self.tournament.advance_by(ticks) };
        let mut run = self.stepping.take().unwrap_or_else(|| {
            Box::new(Run::new(&load_step::scenario(&entrant.scenario), &Edits::none()))
        });
        if run.advance(ticks) {
            self.transients.push(load_step::judged(&entrant.name, &run));
        } else {
            self.stepping = Some(run);
        }
        false
    }

    /// The table so far.
    pub fn table(&self) -> &[Compared] {
        &self.table.1
    }

    fn refresh(&mut self) {
        let done = self.tournament.progress().done.floor();
        if self.table.0 != done || self.table.1.is_empty() {
            self.table = (done, self.tournament.table());
        }
    }
}

/// Everybody under changed conditions.
#[derive(Default)]
pub struct Robust {
    /// All runs; made when they are first wanted.
    tournament: Option<Tournament>,
    /// Whether it runs.
    pub running: bool,
    /// The rows, and the number of runs that they are of.
    rows: (usize, Vec<RobustnessRow>),
}

impl Robust {
    /// Runs done, the present one by its share, and all runs.
    pub fn progress(&self) -> Progress {
        let all = robustness::CONDITIONS.len() * robustness::methods().count();
        let total = (all * ROBUST_SEEDS as usize) as f64;
        let none = Progress { done: 0.0, total, unit: "runs" };
        self.tournament.as_ref().map_or(none, Tournament::progress)
    }

    /// The rows so far.
    pub fn rows(&self) -> &[RobustnessRow] {
        &self.rows.1
    }

    fn advance(&mut self, ticks: u64) {
        let new = || Tournament::new(robustness::entrants(), ROBUST_SEEDS);
        let tournament = self.tournament.get_or_insert_with(new);
        self.running = !tournament.advance_by(ticks);
        let done = tournament.progress().done as usize;
        if done != self.rows.0 {
            self.rows = (done, robustness::rows(tournament.table()));
        }
    }
}

/// See the head of this file.
pub struct Contests {
    /// What is compared.
    pub setup: ContestSetup,
    /// Number of seeds.
    pub seeds: u32,
    /// Whether it runs.
    pub running: bool,
    /// The table of changed conditions.
    pub robust: Robust,
    kept: Vec<Contest>,
    /// The set-up that is shown, and the open scenario where that is its part.
    followed: Option<(ContestSetup, Option<Scenario>)>,
    /// The one that is shown; none where nobody takes part or the set-up is refused.
    shown: Option<usize>,
    /// Why a set-up is refused.
    pub refused: Option<String>,
    /// What there is to say about a number of seeds that was typed.
    pub said: Option<String>,
    ticks: u64,
}

impl Default for Contests {
    fn default() -> Self {
        Self {
            setup: ContestSetup::default(),
            seeds: 20,
            running: false,
            robust: Robust::default(),
            followed: None,
            kept: Vec::new(),
            shown: None,
            refused: None,
            said: None,
            ticks: TICKS[0],
        }
    }
}

impl Contests {
    /// Shows the tournament of the present set-up, a new one if there is none.
    pub fn follow(&mut self, open: &Scenario) {
        let open_part = (self.setup.part == ContestPart::Open).then_some(open);
        let same = self.followed.as_ref().is_some_and(|(setup, scenario)| {
            *setup == self.setup && scenario.as_ref() == open_part
        });
        if !same {
            self.followed = Some((self.setup.clone(), open_part.cloned()));
            self.show(open);
        }
        if let Some(contest) = self.shown.and_then(|index| self.kept.get_mut(index)) {
            contest.tournament.set_seeds(self.seeds);
            contest.refresh();
        }
    }

    fn show(&mut self, open: &Scenario) {
        self.refused = None;
        self.shown = None;
        if !self.setup.chosen.contains(&true) {
            self.running = false;
            return;
        }
        let base = match self.setup.base(open) {
            Ok(base) => base,
            Err(error) => {
                (self.refused, self.running) = (Some(error.to_string()), false);
                return;
            }
        };
        let same = |one: &Contest| one.chosen == self.setup.chosen && one.base == base;
        let found = self.kept.iter().position(same).unwrap_or_else(|| {
            if self.kept.len() >= KEPT {
                self.kept.remove(0);
            }
            let chosen = methods().zip(&self.setup.chosen).filter(|(_, chosen)| **chosen);
            let chosen: Vec<Method> = chosen.map(|(method, _)| *method).collect();
            let tournament = Tournament::new(on(&base, &chosen), self.seeds);
            let chosen = self.setup.chosen.clone();
            self.kept.push(Contest {
                base,
                chosen,
                tournament,
                transients: Vec::new(),
                stepping: None,
                table: (0.0, Vec::new()),
            });
            self.kept.len() - 1
        });
        self.shown = Some(found);
    }

    /// The tournament that is shown.
    pub fn shown(&self) -> Option<&Contest> {
        self.shown.and_then(|index| self.kept.get(index))
    }

    /// Whether the printed table belongs to what is shown.
    pub fn is_table_1(&self) -> bool {
        self.setup.is_table_1()
    }

    /// Advances for one frame if it runs; the last frame took `frame_s` seconds.
    pub fn advance(&mut self, frame_s: f64) -> bool {
        if !self.running && !self.robust.running {
            return false;
        }
        let ticks = if frame_s > FRAME_S { self.ticks / 2 } else { self.ticks + self.ticks / 8 };
        self.ticks = ticks.clamp(TICKS[1], TICKS[2]);
        match self.shown.and_then(|index| self.kept.get_mut(index)) {
            Some(contest) if self.running => {
                self.running = !contest.advance(self.ticks);
                contest.refresh();
            }
            _ if self.robust.running => self.robust.advance(self.ticks),
            _ => {}
        }
        true
    }
}

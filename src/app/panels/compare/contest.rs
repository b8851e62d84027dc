//! What is compared, and the tournaments so far: a set-up once run is kept, and more seeds go on
//! where fewer ended.

use std::sync::Arc;

use crate::app::jobs::{Jobs, Work};
use crate::base::language::{text, tr};
use crate::base::settings::{SettingError, Value};
use crate::blocks::control::ControllerKind;
use crate::blocks::control::script::ScriptSettings;
use crate::blocks::cutting::material::Material;
use crate::blocks::reference::Reference;
use crate::run::job::Progress;
use crate::run::scenario::Scenario;
use crate::study::compare::contest::{ContestJob, ContestSoFar};
use crate::study::compare::entrants::{Entrant, Method, OWN, ROUGHNESS, SHOP, methods_and_own};
use crate::study::compare::entrants::{experiment_2, experiment_2_per_cut, on, set_dead_time};
use crate::study::compare::load_step::{self, Transient};
use crate::study::compare::robustness::{self, RobustnessRow};
use crate::study::compare::tournament::{Compared, Tournament};

/// Set-ups whose results are kept.
const KEPT: usize = 12;
/// Seeds of the table of changed conditions.
const ROBUST_SEEDS: u32 = 2;
/// Steps of the plant in the first slice.
const FIRST: u64 = 20_000;

steadycut_core::choice! {
    /// The part that is milled.
    pub enum ContestPart {
        /// The cut that is open in the console, from its start, with the settings that the console shows now.
        Open = "open", "The console's cut";
        /// Experiment 2 of 2005, five straight cuts, one programmed feed: that of Table 1.
        Experiment2 = "experiment_2", "Experiment 2";
        /// The same with a programmed feed for every cut, as the plan finds them for the lightest
        /// sections: beyond the paper.
        PerCut = "per_cut", "Experiment 2, feeds per cut";
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
    /// Who takes part in the parts of 2005 and in the console's cut, in the order of [`methods_and_own`].
    takes_part: [Vec<bool>; 2],
    /// The script that the console runs, which then can take part; none where it runs none, or one that came with a file
    /// or a link and was not allowed to run yet.
    script: Option<ScriptSettings>,
}

impl Default for ContestSetup {
    fn default() -> Self {
        let (part, dead_time, stock) = (ContestPart::Open, ContestDeadTime::AsIs, Stock::AsIs);
        // Those of Ra, and what has yet to be taught in, have no place in the part of 2005 until they are
        // asked for.
        let of_2005 = methods_and_own().map(|method| !of_roughness(method) && !of_shop(method));
        let takes_part = [of_2005.collect(), methods_and_own().map(|_| true).collect()];
        Self { part, dead_time, stock, takes_part, script: None }
    }
}

/// Whether a way of control sets feed and speed by what Ra wants.
fn of_roughness(method: &Method) -> bool {
    ROUGHNESS.iter().any(|other| other.id == method.id)
}

/// Whether it is what the control of a machine tool offers.
fn of_shop(method: &Method) -> bool {
    SHOP.iter().any(|other| other.id == method.id)
}

/// Whether it is the user's own script.
pub fn is_own(method: &Method) -> bool {
    OWN.iter().any(|other| other.id == method.id)
}

impl ContestSetup {
    /// Who takes part, in the order of [`methods_and_own`].
    pub fn chosen(&self) -> Vec<bool> {
        let asked = &self.takes_part[usize::from(self.part == ContestPart::Open)];
        let can = methods_and_own().map(|method| !is_own(method) || self.has_script());
        can.zip(asked).map(|(can, asked)| can && *asked).collect()
    }

    /// Whether the console runs a script, which then can take part.
    pub fn has_script(&self) -> bool {
        self.script.is_some()
    }

    /// Who is asked to take part, in the same order.
    pub fn chosen_mut(&mut self) -> &mut [bool] {
        &mut self.takes_part[usize::from(self.part == ContestPart::Open)]
    }

    /// Whether ways of control by Ra are left out of a part of 2005.
    pub fn leaves_roughness_out(&self) -> bool {
        let left_out = |(method, chosen): (&Method, &bool)| of_roughness(method) && !chosen;
        let chosen = self.chosen();
        self.part != ContestPart::Open && methods_and_own().zip(&chosen).any(left_out)
    }

    /// The part's scenario as it is milled.
    fn base(&self, open: &Scenario) -> Result<Scenario, SettingError> {
        let mut base = match self.part {
            ContestPart::Experiment2 => experiment_2(),
            ContestPart::PerCut => experiment_2_per_cut(),
            ContestPart::Open => open.clone(),
        };
        if let Some(script) = &self.script {
            base.change(|settings| settings.controller.script = script.clone())?;
        }
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

/// A contest with what it belongs to. It goes on when another one, or another screen, is shown.
pub struct Contest {
    base: Scenario,
    /// The load step, N.
    load_step_n: [f64; 2],
    chosen: Vec<bool>,
    entrants: Vec<Entrant>,
    seeds: u32,
    /// The work at it.
    pub work: Work<ContestJob>,
    latest: Arc<ContestSoFar>,
}

impl Contest {
    /// Who takes part.
    pub fn entrants(&self) -> &[Entrant] {
        &self.entrants
    }

    /// What is to be held: Ra or the force.
    pub fn reference(&self) -> Reference {
        self.base.target.reference
    }

    /// How many load steps are done and to be done, where they are under way before the runs.
    pub fn load_steps(&self) -> Option<[usize; 2]> {
        let (done, all) = (self.latest.transients.len(), self.latest.stepping);
        (done < all).then_some([done, all])
    }

    /// How the entrants took the load step, as far as they have.
    pub fn transients(&self) -> &[Transient] {
        &self.latest.transients
    }

    /// Whether the load step belongs to the part: it is made of sections that are milled.
    pub fn has_load_step(&self) -> bool {
        !self.base.workpiece.cuts.is_empty()
    }

    /// The load step, N.
    pub fn load_step_n(&self) -> [f64; 2] {
        self.load_step_n
    }

    /// Whether AFC takes part without a reference force: it then cuts as conventional milling does.
    pub fn teaches_in(&self) -> bool {
        let untaught = self.base.controller.afc.references_n.is_empty();
        let mut all = methods_and_own().zip(&self.chosen);
        untaught && all.any(|(method, chosen)| of_shop(method) && *chosen)
    }

    /// The scenario that is compared.
    pub fn scenario(&self) -> &Scenario {
        &self.base
    }

    /// How many of its runs are done, where there are more to do.
    pub fn not_whole(&self) -> Option<String> {
        let runs = self.runs();
        let done = runs.done.floor();
        (done < runs.total)
            .then(|| tr!("{done} of {n} runs done", done = done as u64, n = runs.total as u64))
    }

    /// Control period of everybody, ms.
    pub fn control_period_ms(&self) -> f64 {
        self.base.run.control_period_ms
    }

    /// How far the runs over the seeds are.
    pub fn runs(&self) -> Progress {
        self.latest.runs
    }

    /// The table so far.
    pub fn table(&self) -> &[Compared] {
        &self.latest.table
    }

    fn refresh(&mut self, seeds: u32) {
        if self.seeds != seeds {
            self.seeds = seeds;
            self.work.change(move |contest| contest.set_seeds(seeds));
        }
        self.latest = self.work.partial();
    }
}

/// Everybody under changed conditions.
#[derive(Default)]
pub struct Robust {
    /// The script of one's own that takes part.
    script: Option<ScriptSettings>,
    /// All runs; made when they are first wanted.
    work: Option<Work<Tournament>>,
    /// The rows, and the table that they are of.
    rows: Option<(Arc<Vec<Compared>>, Vec<RobustnessRow>)>,
}

impl Robust {
    /// How far the runs are.
    pub fn progress(&self) -> Progress {
        let all = robustness::CONDITIONS.len() * self.methods();
        let total = (all * ROBUST_SEEDS as usize) as f64;
        let none = Progress { done: 0.0, total, unit: "runs" };
        self.work.as_ref().map_or(none, Work::progress)
    }

    /// Takes the script that the console runs, which then takes part: with another one than before all begins anew.
    /// Without one what was run stays.
    fn follow(&mut self, script: Option<&ScriptSettings>) {
        if script == self.script.as_ref() || (script.is_none() && self.work.is_some()) {
            return;
        }
        *self = Self { script: script.cloned(), work: None, rows: None };
    }

    /// How many take part.
    pub fn methods(&self) -> usize {
        robustness::methods(self.script.is_some()).count()
    }

    /// Whether it goes on.
    pub fn is_running(&self) -> bool {
        self.work.as_ref().is_some_and(Work::is_running)
    }

    /// Begins it, or goes on.
    pub fn go_on(&mut self, jobs: &Jobs) {
        let script = self.script.as_ref();
        let new = || Tournament::new(robustness::entrants(script), ROBUST_SEEDS);
        let work =
            self.work.get_or_insert_with(|| jobs.take(text!("Compare: conditions"), new(), FIRST));
        work.go_on();
    }

    /// Stands still.
    pub fn stop(&self) {
        self.work.iter().for_each(Work::stop);
    }

    /// The rows so far.
    pub fn rows(&mut self) -> &[RobustnessRow] {
        let Some(work) = &self.work else { return &[] };
        let latest = work.partial();
        if !self.rows.as_ref().is_some_and(|(of, _)| Arc::ptr_eq(of, &latest)) {
            let rows = robustness::rows(latest.to_vec());
            self.rows = Some((latest, rows));
        }
        self.rows.as_ref().map_or(&[], |(_, rows)| rows)
    }
}

/// See the head of this file.
pub struct Contests {
    /// What is compared.
    pub setup: ContestSetup,
    /// Number of seeds.
    pub seeds: u32,
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
}

impl Default for Contests {
    fn default() -> Self {
        Self {
            setup: ContestSetup::default(),
            seeds: 20,
            robust: Robust::default(),
            followed: None,
            kept: Vec::new(),
            shown: None,
            refused: None,
            said: None,
        }
    }
}

impl Contests {
    /// Shows the tournament of the present set-up, a new one if there is none. A script of the open scenario takes part
    /// only where it may be run.
    pub fn follow(&mut self, open: &Scenario, may_run_script: bool, jobs: &Jobs) {
        let runs = open.controller.kind == ControllerKind::Script && may_run_script;
        self.setup.script = runs.then(|| open.controller.script.clone());
        self.robust.follow(self.setup.script.as_ref());
        let open_part = (self.setup.part == ContestPart::Open).then_some(open);
        let same = self.followed.as_ref().is_some_and(|(setup, scenario)| {
            *setup == self.setup && scenario.as_ref() == open_part
        });
        if !same {
            self.followed = Some((self.setup.clone(), open_part.cloned()));
            self.show(open, jobs);
        }
        if let Some(contest) = self.shown.and_then(|index| self.kept.get_mut(index)) {
            contest.refresh(self.seeds);
        }
    }

    fn show(&mut self, open: &Scenario, jobs: &Jobs) {
        self.refused = None;
        self.shown = None;
        let chosen = self.setup.chosen();
        if !chosen.contains(&true) {
            return;
        }
        let base = match self.setup.base(open) {
            Ok(base) => base,
            Err(error) => {
                self.refused = Some(error.to_string());
                return;
            }
        };
        let same = |one: &Contest| one.chosen == chosen && one.base == base;
        let found = self.kept.iter().position(same).unwrap_or_else(|| {
            if self.kept.len() >= KEPT {
                self.kept.remove(0);
            }
            let methods = methods_and_own().zip(&chosen).filter(|(_, chosen)| **chosen);
            let methods: Vec<Method> = methods.map(|(method, _)| *method).collect();
            let entrants = on(&base, &methods);
            let of = match self.setup.part {
                ContestPart::Open => base.info.name.as_str(),
                part @ (ContestPart::Experiment2 | ContestPart::PerCut) => tr(part.label()),
            };
            let name = tr!("Compare: {what}", what = of);
            let job = ContestJob::new(entrants.clone(), self.seeds);
            let work = jobs.take(name, job, FIRST);
            let (chosen, latest) = (chosen.clone(), work.partial());
            let load_step_n = load_step::forces_n(&base);
            let seeds = self.seeds;
            self.kept.push(Contest { base, load_step_n, chosen, entrants, seeds, work, latest });
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
}

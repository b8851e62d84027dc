//! Pre-training of the networks of UNKS on the milling simulator (`steadycut train unks`).
//!
//! Ten random workpieces, none of them that of an experiment, are cut with an excited feed: the
//! actual override divided by the normalised force, times e^U with U uniform in +-0.5 and held for
//! 0.16 to 0.8 s. What force came of what override H control periods later teaches NM-1 and, read
//! the other way round, NM-2. NM-R learns F_ref / F from 4000 random pairs.

use std::sync::Arc;

use crate::base::language::text;
use crate::base::math::{self, extent, limit};
use crate::base::network::{
    Activation, LearningParameters, Network, Provenance, ScaledNetwork, Scaling, Training, write,
};
use crate::base::rng::Stream;
use crate::base::units::mm_s_from_mm_min;
use crate::blocks::cnc::dead_time::DeadTime;
use crate::blocks::cutting::disturbance::{DynamicForce, NoiseSettings};
use crate::blocks::cutting::milling::{Milling, MillingSetup};
use crate::blocks::sensing::peak::PeakWindow;
use crate::models::feed_drive::{DriveState, ExactDrive, FeedDriveKind};
use crate::models::mechanistic::{CK45, Cutter, MNCRSI5};
use crate::models::part::{AIR_FRACTION, APPROACH_MM, CutPath, Section};
use crate::models::tool::Tool;
use crate::models::unks::{HORIZON_BEYOND, LEAST_KN, SIZES, log_force};
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, Parts};

/// What the data are, for files and reports.
pub const NOTE: &str = "UNKS of 2005: the paper's networks were never published; trained by \
                        steadycut train unks on cuts of the milling simulator through random \
                        workpieces with an excited feed";
/// Seed of workpieces, excitation, first weights and order.
pub const SEED: u32 = 1;
/// Random workpieces.
pub const WORKPIECES: u64 = 10;
/// Cuts of a workpiece.
pub const CUTS: u64 = 2;
/// Samples of the teeth per control period, and its length in s.
const SAMPLES: u64 = 576;
const PERIOD_S: f64 = 0.02;
/// Dead time of the override in control periods.
const DEAD_PERIODS: usize = 2;
const HORIZON: usize = DEAD_PERIODS + HORIZON_BEYOND;
/// How NM-1 and NM-2 learn, and for how many epochs.
const PROCESS: LearningParameters = LearningParameters { rate: 0.01, momentum: 0.3, decay: 0.05 };
const PROCESS_EPOCHS: u32 = 60;
/// How NM-R learns: until its error is below the level, for RATIO_EPOCHS at most.
const RATIO: LearningParameters = LearningParameters { rate: 0.05, momentum: 0.5, decay: 0.0 };
const RATIO_EPOCHS: u32 = 3000;
const RATIO_LEVEL: f64 = 0.02;
const RATIO_PAIRS: u64 = 4000;

/// One control period of an excited cut: logarithm of the force and actual override; none in the
/// air.
type Period = Option<(f64, f64)>;

/// Draws numbers one after the other.
#[derive(Clone, Debug)]
struct Draws {
    stream: Stream,
    counter: u64,
}

impl Draws {
    fn new(label: &str) -> Self {
        Self { stream: Stream::new(u64::from(SEED), label), counter: 0 }
    }

    fn uniform(&mut self, [low, high]: [f64; 2]) -> f64 {
        self.counter += 1;
        low + (high - low) * self.stream.uniform(self.counter)
    }
}

fn sections(draws: &mut Draws) -> Vec<Section> {
    let count = 3 + draws.uniform([0.0, 4.0]) as usize;
    let mut section =
        || [draws.uniform([8.0, 45.0]), draws.uniform([1.5, 5.0]), draws.uniform([0.0, 3.0])];
    (0..count.min(6)).map(|_| section()).collect()
}

/// One cut with an excited feed.
fn excited(number: u64, setup: &MillingSetup, force_ref_n: f64, draws: &mut Draws) -> Vec<Period> {
    let cut = CutPath::new(&sections(draws));
    let noise = NoiseSettings {
        level: 1.0,
        band_percent: 0.0,
        ripple_percent: 0.0,
        inhomogeneity_percent: 5.0,
        sensor_n: 6.0,
        ..NoiseSettings::default()
    };
    let seed = SEED.wrapping_mul(1000).wrapping_add(number as u32);
    let tool = Tool::default();
    let mut field = DynamicForce::new(&noise, tool.teeth, seed, setup.dt_s);
    let mut window = PeakWindow::new(noise.sensor_deviation_n(), seed, SAMPLES, setup.dt_s);
    let mut milling = Milling::new(setup, cut.depth_max_mm());
    let drive = ExactDrive::new(FeedDriveKind::SecondOrder2013, setup.dt_s);
    let speed_rpm = tool.speed_rpm(80.0);
    let programmed = tool.feed_mm_min(0.08, speed_rpm);
    let mut queue = DeadTime::new(DEAD_PERIODS, [1.0, 0.0]);
    let mut state = DriveState::settled(1.0);
    let (mut x_mm, mut tick, mut command) = (-APPROACH_MM, 0, 1.0);
    let (mut factor, mut hold) = (1.0, 0.0);
    let mut periods = Vec::new();
    while x_mm < cut.length_mm() {
        let [delayed, _] = queue.pass([command, 0.0]);
        let mut peak_n = 0.0;
        for _ in 0..SAMPLES {
            drive.advance(&mut state, delayed);
            let feed = math::positive(state.feed_mm_min()) * programmed;
            x_mm += mm_s_from_mm_min(feed) * setup.dt_s;
            let dynamic = field.update(tick, x_mm + APPROACH_MM, speed_rpm);
            let [x, y, _] = milling.update(feed, speed_rpm, x_mm, &cut, dynamic).forces_n;
            peak_n = window.push(tick, [x, y]).measured_n;
            tick += 1;
        }
        let (actual, y) = (state.feed_mm_min().max(0.02), peak_n / force_ref_n);
        periods.push((y >= AIR_FRACTION).then(|| (log_force(y), actual)));
        if hold <= 0.0 {
            factor = math::exp(draws.uniform([-0.5, 0.5]));
            hold = draws.uniform([0.16, 0.8]);
        }
        hold -= PERIOD_S;
        command = if y >= AIR_FRACTION { limit(actual / y * factor, 0.05, 1.5) } else { 1.5 };
    }
    periods
}

/// A pattern: three features, the fourth input, the output.
pub type Pattern = ([f64; 4], f64);

/// Patterns for NM-1 and NM-2 from one cut.
fn patterns(periods: &[Period]) -> Vec<[Pattern; 2]> {
    let mut found = Vec::new();
    for window in periods.windows(3 + HORIZON) {
        let Some(whole) = window.iter().copied().collect::<Option<Vec<_>>>() else { continue };
        let [(older, _), (old, _), (now, actual)] = [whole[0], whole[1], whole[2]];
        let (later, reached) = whole[2 + HORIZON];
        let features = [now, now - old, now - older];
        let (gain, change) = (later - now, math::ln(reached / actual));
        let with = |last: f64, bound: f64| {
            let [a, b, c] = features;
            [a, b, c, limit(last, -bound, bound)]
        };
        found.push([(with(change, 1.5), gain), (with(gain, 1.2), change)]);
    }
    found
}

/// Patterns of the random workpieces: a job of one cut after the other, since each draws on where the one
/// before has left the random numbers.
#[derive(Clone, Debug)]
pub struct PatternsJob {
    draws: Draws,
    /// Cuts done.
    cuts: u64,
    force_ref_n: f64,
    patterns: Vec<[Pattern; 2]>,
}

impl Default for PatternsJob {
    fn default() -> Self {
        let draws = Draws::new("unks.workpieces");
        Self { draws, cuts: 0, force_ref_n: 0.0, patterns: Vec::new() }
    }
}

impl PatternsJob {
    /// The patterns so far: of NM-1 and NM-2.
    #[must_use]
    pub fn patterns(&self) -> &[[Pattern; 2]] {
        &self.patterns
    }

    fn cut(&mut self) {
        let steel = if (self.cuts / CUTS).is_multiple_of(2) { CK45 } else { MNCRSI5 };
        let tool = Tool::default();
        let setup = MillingSetup {
            cutter: Cutter::new(&tool, 0.003, 0.25),
            steel,
            rake_deg: tool.rake_deg,
            hardness_hb: steel.hardness_hb,
            factor: 1.0,
            dt_s: PERIOD_S / SAMPLES as f64,
        };
        if self.cuts.is_multiple_of(CUTS) {
            self.force_ref_n = self.draws.uniform([400.0, 900.0]);
        }
        let periods = excited(self.cuts, &setup, self.force_ref_n, &mut self.draws);
        self.patterns.extend(patterns(&periods));
        self.cuts += 1;
    }
}

/// A step is a cut.
impl Job for PatternsJob {
    type Partial = Vec<[Pattern; 2]>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.cuts < WORKPIECES * CUTS && budget.step() {
            self.cut();
        }
        self.cuts >= WORKPIECES * CUTS
    }

    fn progress(&self) -> Progress {
        let total = (WORKPIECES * CUTS) as f64;
        Progress { done: self.cuts as f64, total, unit: text!("cuts") }
    }

    fn partial(&self) -> Vec<[Pattern; 2]> {
        self.patterns.clone()
    }
}

/// A trained network, its file and its error.
#[derive(Clone, Debug)]
pub struct Trained {
    /// NM-R, NM-1 or NM-2.
    pub name: &'static str,
    /// The file's text.
    pub file: String,
    /// Patterns learned.
    pub patterns: usize,
    /// Epochs it took.
    pub epochs: u32,
    /// Root mean square error in the unit of the output.
    pub rms: f64,
}

/// How a network is trained: the parameters, most epochs, and the error below which it ends earlier.
type Schedule = (LearningParameters, u32, f64);

/// What a network learns from: inputs and output.
type Lesson = (Vec<f64>, f64);

/// One network in training.
#[derive(Clone, Debug)]
struct NetworkJob {
    name: &'static str,
    lessons: Arc<[Lesson]>,
    schedule: Schedule,
    scaling: Scaling,
    training: Training,
    epochs: u32,
    /// Whether it has ended early.
    level_reached: bool,
}

impl NetworkJob {
    fn new(
        (name, sizes): (&'static str, &[usize]),
        lessons: &Arc<[Lesson]>,
        schedule: Schedule,
    ) -> Result<Self, String> {
        let stream = |label: &str| Stream::new(u64::from(SEED), &format!("{name}.{label}"));
        let network = Network::random(sizes, Activation::Arctan, true, stream("weights"))?;
        let inputs = (0..sizes[0]).map(|i| extent(lessons.iter().map(|(x, _)| x[i])));
        let scaling = Scaling {
            norm: [-1.0, 1.0],
            target: [-1.0, 1.0],
            ln_inputs: vec![false; sizes[0]],
            inputs: inputs.collect(),
            outputs: vec![extent(lessons.iter().map(|(_, y)| *y))],
        };
        let normal = lessons
            .iter()
            .map(|(x, y)| (scaling.normal_inputs(x), scaling.normal_targets(&[*y])))
            .collect();
        let training = Training::new(network, schedule.0, normal, stream("order"));
        let lessons = Arc::clone(lessons);
        Ok(Self { name, lessons, schedule, scaling, training, epochs: 0, level_reached: false })
    }

    fn is_over(&self) -> bool {
        self.level_reached || self.epochs >= self.schedule.1
    }

    fn trained(&self) -> Trained {
        let (learning, ..) = self.schedule;
        let network = self.training.network().clone();
        let scaled = ScaledNetwork { network, scaling: self.scaling.clone() }.as_in_file();
        let off = |(x, y): &Lesson| scaled.predict(x)[0] - y;
        let square: f64 = self.lessons.iter().map(|lesson| off(lesson) * off(lesson)).sum();
        let provenance = Provenance {
            note: NOTE.to_owned(),
            rows: self.lessons.len() as u32,
            seed: SEED,
            epochs: self.epochs,
            rate: learning.rate,
            momentum: learning.momentum,
            decay: learning.decay,
        };
        Trained {
            name: self.name,
            file: write(&scaled, &provenance),
            patterns: self.lessons.len(),
            epochs: self.epochs,
            rms: (square / self.lessons.len() as f64).sqrt(),
        }
    }
}

/// A step is an epoch.
impl Job for NetworkJob {
    type Partial = Trained;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let [slope, _] = self.scaling.output_map(0);
        while !self.is_over() && budget.step() {
            self.epochs += 1;
            self.level_reached = self.training.epoch() * slope.abs() < self.schedule.2;
        }
        self.is_over()
    }

    fn progress(&self) -> Progress {
        let total = f64::from(self.schedule.1);
        let done = if self.is_over() { total } else { f64::from(self.epochs) };
        Progress { done, total, unit: text!("epochs") }
    }

    fn partial(&self) -> Trained {
        self.trained()
    }
}

/// NM-R, NM-1 and NM-2 in training.
#[derive(Clone, Debug)]
pub struct NetworksJob {
    lessons: [Arc<[Lesson]>; 3],
    networks: Parts<NetworkJob, Trained>,
}

/// Names and ways of training, in the order of [`SIZES`].
const NETWORKS: [(&str, Schedule); 3] = [
    ("NM-R", (RATIO, RATIO_EPOCHS, RATIO_LEVEL)),
    ("NM-1", (PROCESS, PROCESS_EPOCHS, 0.0)),
    ("NM-2", (PROCESS, PROCESS_EPOCHS, 0.0)),
];

impl NetworksJob {
    /// The networks, untrained, with the patterns of NM-1 and NM-2; NM-R learns a ratio.
    #[must_use]
    pub fn new(patterns: &[[Pattern; 2]]) -> Self {
        let mut draws = Draws::new("unks.pairs");
        let pairs = (0..RATIO_PAIRS).map(|_| {
            let reference = draws.uniform([0.2, 1.0]);
            let force = draws.uniform([0.1, 2.0]).max(LEAST_KN);
            (vec![reference, force], limit(reference / force, 0.0, 1.5))
        });
        let of = |i: usize| -> Arc<[Lesson]> {
            patterns.iter().map(|both| (both[i].0.to_vec(), both[i].1)).collect()
        };
        Self { lessons: [pairs.collect(), of(0), of(1)], networks: Parts::default() }
    }

    /// The networks that are trained, in this order.
    #[must_use]
    pub fn trained(&self) -> &[Trained] {
        self.networks.done()
    }
}

/// A step is an epoch of one of the networks.
impl Job for NetworksJob {
    type Partial = Vec<Trained>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let lessons = &self.lessons;
        let begin = |index: usize| {
            let (name, schedule) = NETWORKS[index];
            NetworkJob::new((name, SIZES[index]), &lessons[index], schedule)
        };
        let end = |_: usize, job: &NetworkJob| job.trained();
        self.networks.advance(NETWORKS.len(), budget, &Making { begin: &begin, end: &end })
    }

    fn progress(&self) -> Progress {
        let total = NETWORKS.len() as f64;
        Progress { done: self.networks.progress(), total, unit: text!("networks") }
    }

    fn partial(&self) -> Vec<Trained> {
        self.trained().to_vec()
    }

    fn refusal(&self) -> Option<&str> {
        self.networks.refusal()
    }
}

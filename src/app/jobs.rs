//! Long work of the screens: it goes on when its screen is left. On the desktop a pool of threads works at
//! it, in a page every frame at a slice of it; what it gives is the same. A screen keeps a [`Work`] and reads
//! its latest partial result, which costs a frame nothing; what goes on is listed in the bar.

mod list;
#[cfg(not(target_arch = "wasm32"))]
mod pool;

use std::cell::{Cell, RefCell};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::clock::now_s;
use crate::base::language::{self, Catalogue};
use crate::run::job::{Budget, Job, OneThread, Progress, Threads};
pub use list::{show, time as time_left};

/// Least time of a slice in a frame, for all jobs together, s.
const FRAME_SLICE_S: f64 = 0.008;
/// Most of it, s: a frame that takes long shall not take for ever.
const MOST_SLICE_S: f64 = 0.1;
/// Time of a slice over the rest of a frame's: where drawing is slow, a slice of a fast frame would be next to
/// nothing of the time (chosen).
const OF_THE_FRAME: f64 = 0.5;
/// Time of a slice on the pool, s: partial results are as old as that at most.
#[cfg(not(target_arch = "wasm32"))]
const POOL_SLICE_S: f64 = 0.03;
/// A slice is ended after this share of its time. What is begun by then takes its own time, and all of it is to be
/// within the slice's as a rule.
const LATE: f64 = 0.75;
/// Time of work up to which a brief job is not listed, s.
const BRIEF_S: f64 = 0.4;
/// Time between two frames while nothing else moves, s.
#[cfg(not(target_arch = "wasm32"))]
const REDRAW_S: f64 = 0.1;

/// A change that is made to a job between two slices.
type Change<J> = Box<dyn FnOnce(&mut J) + Send>;

/// A job and what is known of it.
struct Slot<J: Job> {
    /// The job; away while it is worked at.
    job: Option<J>,
    changes: Vec<Change<J>>,
    /// Steps of the next slice.
    steps: u64,
    partial: Arc<J::Partial>,
    progress: Progress,
    refusal: Option<String>,
    over: bool,
    /// Whether a slice is due or under way on the pool.
    #[cfg(not(target_arch = "wasm32"))]
    on_pool: bool,
    /// Time worked so far, s.
    worked_s: f64,
    /// The same when it began to come on, and the share then: what is done before the first of what is counted
    /// says nothing of the time that the rest takes.
    came_on: (f64, f64),
}

/// What a screen, the list and the pool share of a job.
struct Shared<J: Job> {
    name: String,
    /// Of the texts that it makes: threads of the pool have none of their own.
    language: Option<&'static Catalogue>,
    /// Time of work from which it is listed, s.
    listed_from_s: f64,
    running: AtomicBool,
    /// Stopped in the list, which keeps the way on.
    halted: AtomicBool,
    /// Nobody wants it any more.
    gone: AtomicBool,
    slot: Mutex<Slot<J>>,
}

impl<J: Job> Shared<J> {
    fn slot(&self) -> MutexGuard<'_, Slot<J>> {
        self.slot.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Goes on where it was stopped.
    fn go_on(&self) {
        if !self.slot().over {
            self.halted.store(false, Ordering::Relaxed);
            self.running.store(true, Ordering::Relaxed);
        }
    }

    /// Time that is left at most, s.
    fn left_s(&self) -> Option<f64> {
        let slot = self.slot();
        let (before_s, from) = slot.came_on;
        slot.progress.left_s(slot.worked_s - before_s, from)
    }

    /// Works at it for a slice that is to take `slice_s` seconds; `true` while there is more to do.
    fn slice(&self, threads: &dyn Threads, slice_s: f64) -> bool {
        let running = &self.running;
        language::use_catalogue(self.language);
        let stopped = || !running.load(Ordering::Relaxed);
        let (mut job, steps) = {
            let mut slot = self.slot();
            let Some(job) = slot.job.take() else { return false };
            (job, slot.steps)
        };
        // No lock is held while it works: a frame never waits for it.
        let begin_s = now_s();
        // Steps may become a thousand times longer from one stage of a job to the next: no frame waits for that.
        let late = AtomicBool::new(false);
        let ended = || {
            if now_s() - begin_s > LATE * slice_s {
                late.store(true, Ordering::Relaxed);
            }
            late.load(Ordering::Relaxed) || stopped()
        };
        let over = job.advance(&Budget::steps(steps).on(threads, &ended));
        let took_s = now_s() - begin_s;
        let mut over = over;
        let mut found = (Arc::new(job.partial()), job.progress());
        let mut slot = self.slot();
        for change in std::mem::take(&mut slot.changes) {
            change(&mut job);
            found = (Arc::new(job.partial()), job.progress());
            over = found.1.done >= found.1.total;
        }
        if took_s > slice_s {
            slot.steps = (steps / 2).max(1);
        } else if took_s < 0.5 * slice_s {
            slot.steps = steps.saturating_mul(2);
        }
        slot.worked_s += took_s;
        if found.1.share() <= slot.came_on.1 {
            slot.came_on.0 = slot.worked_s;
        }
        slot.refusal = job.refusal().map(str::to_owned);
        (slot.partial, slot.progress) = found;
        slot.over = over;
        if over {
            self.running.store(false, Ordering::Relaxed);
        }
        slot.job = Some(job);
        !over && !stopped()
    }
}

/// A job of any kind, as the list and the pump see it.
trait Listed: Send + Sync {
    fn name(&self) -> &str;
    fn is_running(&self) -> bool;
    /// Whether it is shown in the list as being worked at.
    fn is_listed(&self) -> bool;
    /// Whether it is shown there as stopped.
    fn is_halted(&self) -> bool;
    /// Stops it, from the list.
    fn halt(&self);
    /// Goes on where it was stopped.
    fn go_on(&self);
    fn is_gone(&self) -> bool;
    fn progress(&self) -> (Progress, Option<f64>);
    fn frame(&self, slice_s: f64);
    /// Takes it to the pool, unless it is there.
    #[cfg(not(target_arch = "wasm32"))]
    fn claim(&self) -> bool;
    /// A slice on the pool; `true` while there is more to do there.
    #[cfg(not(target_arch = "wasm32"))]
    fn pool_slice(&self, threads: &dyn Threads, slice_s: f64) -> bool;
}

impl<J: Job> Listed for Shared<J>
where
    J::Partial: Send + Sync,
{
    fn name(&self) -> &str {
        &self.name
    }

    fn is_running(&self) -> bool {
        self.running.load(Ordering::Relaxed)
    }

    fn is_listed(&self) -> bool {
        self.is_running() && self.slot().worked_s >= self.listed_from_s
    }

    fn is_halted(&self) -> bool {
        self.halted.load(Ordering::Relaxed) && !self.is_running() && !self.slot().over
    }

    fn halt(&self) {
        self.halted.store(true, Ordering::Relaxed);
        self.running.store(false, Ordering::Relaxed);
    }

    fn go_on(&self) {
        Self::go_on(self);
    }

    fn is_gone(&self) -> bool {
        self.gone.load(Ordering::Relaxed)
    }

    fn progress(&self) -> (Progress, Option<f64>) {
        let left_s = self.left_s();
        (self.slot().progress, left_s)
    }

    fn frame(&self, slice_s: f64) {
        self.slice(&OneThread, slice_s);
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn claim(&self) -> bool {
        let mut slot = self.slot();
        !std::mem::replace(&mut slot.on_pool, true)
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn pool_slice(&self, threads: &dyn Threads, slice_s: f64) -> bool {
        let more = self.is_running() && self.slice(threads, slice_s);
        if !more {
            self.slot().on_pool = false;
        }
        more
    }
}

/// A job that a screen has begun. It is given up with this.
pub struct Work<J: Job> {
    shared: Arc<Shared<J>>,
}

impl<J: Job> Work<J> {
    /// Its latest partial result.
    #[must_use]
    pub fn partial(&self) -> Arc<J::Partial> {
        Arc::clone(&self.shared.slot().partial)
    }

    /// How far it is.
    #[must_use]
    pub fn progress(&self) -> Progress {
        self.shared.slot().progress
    }

    /// Time that is left at most, s; none before it has come anywhere.
    #[must_use]
    pub fn left_s(&self) -> Option<f64> {
        self.shared.left_s()
    }

    /// Whether it goes on.
    #[must_use]
    pub fn is_running(&self) -> bool {
        self.shared.running.load(Ordering::Relaxed)
    }

    /// Whether it has come to its end.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.shared.slot().over
    }

    /// Why it ended before, if it did.
    #[must_use]
    pub fn refusal(&self) -> Option<String> {
        self.shared.slot().refusal.clone()
    }

    /// Stops it between two of its steps; what it has found stays.
    pub fn stop(&self) {
        self.shared.running.store(false, Ordering::Relaxed);
    }

    /// Goes on where it was stopped.
    pub fn go_on(&self) {
        self.shared.go_on();
    }

    /// The job with all it has found, unless it is being worked at.
    #[must_use]
    pub fn into_job(self) -> Option<J> {
        self.shared.slot().job.take()
    }

    /// Changes the job, at once where it rests, otherwise after the present slice; it does not begin to
    /// run by that.
    pub fn change(&self, change: impl FnOnce(&mut J) + Send + 'static) {
        let mut slot = self.shared.slot();
        let Some(job) = &mut slot.job else { return slot.changes.push(Box::new(change)) };
        change(job);
        let (partial, progress) = (Arc::new(job.partial()), job.progress());
        (slot.partial, slot.progress) = (partial, progress);
        slot.over = progress.done >= progress.total;
    }
}

impl<J: Job> Drop for Work<J> {
    fn drop(&mut self) {
        self.shared.running.store(false, Ordering::Relaxed);
        self.shared.gone.store(true, Ordering::Relaxed);
    }
}

/// All long work of the console.
pub struct Jobs {
    all: RefCell<Vec<Arc<dyn Listed>>>,
    in_slices: Cell<bool>,
    /// When the last frame's share of the work ended, s.
    pumped_s: Cell<Option<f64>>,
}

impl Default for Jobs {
    fn default() -> Self {
        let in_slices = Cell::new(cfg!(target_arch = "wasm32"));
        Self { all: RefCell::default(), in_slices, pumped_s: Cell::new(None) }
    }
}

/// Time of a slice in a frame whose rest takes `rest_s`, s.
fn frame_slice_s(rest_s: f64) -> f64 {
    (OF_THE_FRAME * rest_s).clamp(FRAME_SLICE_S, MOST_SLICE_S)
}

impl Jobs {
    /// Works in the frames from now on, as in a page, in place of a pool.
    pub fn work_in_slices(&self) {
        self.in_slices.set(true);
    }

    /// Takes a job that rests until [`Work::go_on`]; `first` are the steps of its first slice, some
    /// milliseconds of work.
    #[must_use]
    pub fn take<J>(&self, name: impl Into<String>, job: J, first: u64) -> Work<J>
    where
        J: Job + 'static,
        J::Partial: Send + Sync,
    {
        self.take_listed(name.into(), job, first, 0.0)
    }

    fn take_listed<J>(&self, name: String, job: J, first: u64, listed_from_s: f64) -> Work<J>
    where
        J: Job + 'static,
        J::Partial: Send + Sync,
    {
        let progress = job.progress();
        let slot = Slot {
            partial: Arc::new(job.partial()),
            progress,
            job: Some(job),
            changes: Vec::new(),
            steps: first.max(1),
            refusal: None,
            over: false,
            #[cfg(not(target_arch = "wasm32"))]
            on_pool: false,
            worked_s: 0.0,
            came_on: (0.0, progress.share()),
        };
        let shared = Arc::new(Shared {
            name,
            language: language::catalogue(),
            listed_from_s,
            running: AtomicBool::new(false),
            halted: AtomicBool::new(false),
            gone: AtomicBool::new(false),
            slot: Mutex::new(slot),
        });
        let listed: Arc<dyn Listed> = Arc::<Shared<J>>::clone(&shared);
        self.all.borrow_mut().push(listed);
        Work { shared }
    }

    /// Takes a job and begins it.
    #[must_use]
    pub fn begin<J>(&self, name: impl Into<String>, job: J, first: u64) -> Work<J>
    where
        J: Job + 'static,
        J::Partial: Send + Sync,
    {
        let work = self.take(name, job, first);
        work.go_on();
        work
    }

    /// The same with a job that is begun again and again and over in a moment mostly: it is listed only
    /// where it takes longer, so that nothing flickers in the bar.
    #[must_use]
    pub fn begin_brief<J>(&self, name: impl Into<String>, job: J, first: u64) -> Work<J>
    where
        J: Job + 'static,
        J::Partial: Send + Sync,
    {
        let work = self.take_listed(name.into(), job, first, BRIEF_S);
        work.go_on();
        work
    }

    /// Whether nothing is worked at.
    #[must_use]
    pub fn is_at_rest(&self) -> bool {
        !self.all.borrow().iter().any(|job| job.is_running() && !job.is_gone())
    }

    /// A frame's share of the work, or none where the pool does it; asks for another frame while
    /// something goes on.
    pub fn pump(&self, ctx: &egui::Context) {
        self.all.borrow_mut().retain(|job| !job.is_gone());
        let all = self.all.borrow();
        let running: Vec<&Arc<dyn Listed>> = all.iter().filter(|job| job.is_running()).collect();
        if running.is_empty() {
            self.pumped_s.set(None);
            return;
        }
        #[cfg(not(target_arch = "wasm32"))]
        if !self.in_slices.get() {
            running.into_iter().for_each(pool::work_at);
            return ctx.request_repaint_after_secs(REDRAW_S as f32);
        }
        let slice_s = frame_slice_s(self.pumped_s.get().map_or(0.0, |ended_s| now_s() - ended_s));
        for job in &running {
            job.frame(slice_s / running.len() as f64);
        }
        self.pumped_s.set(Some(now_s()));
        ctx.request_repaint();
    }
}

#[cfg(test)]
mod tests;

//! The one loop for long work: a job goes to its end on all cores, with a bar that says how far it is and
//! how long it will take. Ctrl+C ends it between two steps: nothing of it is written then.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::disk;
use crate::run::job::{Budget, Job, Progress, Threads};

/// Time that a slice is to take, s: the bar moves that often.
const SLICE_S: f64 = 0.1;
/// Steps of the first slice.
const FIRST_STEPS: u64 = 16;
/// Steps of the bar.
const BAR: f64 = 1000.0;
/// Exit code of a program that Ctrl+C has ended.
pub const INTERRUPTED: u8 = 130;

/// All cores; fewer by the environment variable `RAYON_NUM_THREADS`.
pub struct Cores;

impl Threads for Cores {
    fn count(&self) -> usize {
        rayon::current_num_threads()
    }

    fn run(&self, lanes: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..lanes).into_par_iter().with_max_len(1).for_each(work);
    }
}

/// Why a job did not come to its end.
#[derive(Debug)]
pub enum NotDone {
    /// It cannot be done.
    Refused(String),
    /// Ctrl+C came.
    Interrupted {
        /// What was worked at.
        what: String,
        /// How far it was.
        progress: Progress,
        /// How to go on, where what was done is kept.
        kept: Option<String>,
    },
}

impl std::fmt::Display for NotDone {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Refused(problem) => f.write_str(problem),
            Self::Interrupted { what, progress, kept: Some(kept) } => {
                write!(f, "interrupted: {what}, {progress} done; {kept}")
            }
            Self::Interrupted { what, progress, kept: None } => {
                write!(f, "interrupted: {what}, {progress} done; nothing of it is written")
            }
        }
    }
}

impl std::error::Error for NotDone {}

impl NotDone {
    /// The same, where what was done is kept: how to go on with it.
    #[must_use]
    pub fn kept(self, how: String) -> Self {
        match self {
            Self::Interrupted { what, progress, .. } => {
                Self::Interrupted { what, progress, kept: Some(how) }
            }
            Self::Refused(problem) => Self::Refused(problem),
        }
    }
}

/// Whether Ctrl+C came.
static INTERRUPT: AtomicBool = AtomicBool::new(false);
/// Whether a job is at work that will notice.
static AT_WORK: AtomicBool = AtomicBool::new(false);

/// From now on an interruption (Ctrl+C, or the system's wish that the program ends) ends the job at work, or
/// the program where none is; files that are not whole are removed.
pub fn notice_interrupts() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let set = ctrlc::set_handler(|| {
            let twice = INTERRUPT.swap(true, Ordering::Relaxed);
            if twice || !AT_WORK.load(Ordering::Relaxed) {
                disk::abandon();
                std::process::exit(INTERRUPTED.into());
            }
        });
        // Without a handler Ctrl+C ends the program at once, as it does every other.
        drop(set);
    });
}

/// Works at a job to its end. The bar stands on stderr: none with `quiet`, or where that is no terminal.
///
/// # Errors
/// The job cannot be done, or Ctrl+C came.
pub fn work<J: Job>(job: &mut J, what: &str, quiet: bool) -> Result<(), NotDone> {
    work_telling(job, what, quiet, |job| job.progress().to_string())
}

/// The same, where the bar says what `tells` says of the job.
///
/// # Errors
/// As [`work`].
#[expect(clippy::disallowed_methods, reason = "how long is left needs a clock")]
pub fn work_telling<J: Job>(
    job: &mut J,
    what: &str,
    quiet: bool,
    tells: impl Fn(&J) -> String,
) -> Result<(), NotDone> {
    AT_WORK.store(true, Ordering::Relaxed);
    let bar = bar(what, quiet);
    let (start, from) = (Instant::now(), job.progress().share());
    let cancelled = || INTERRUPT.load(Ordering::Relaxed);
    let mut steps = FIRST_STEPS;
    loop {
        let slice = Instant::now();
        let over = job.advance(&Budget::steps(steps).on(&Cores, &cancelled));
        if over || cancelled() {
            break;
        }
        steps = next_steps(steps, slice.elapsed().as_secs_f64());
        let progress = job.progress();
        bar.set_position((BAR * progress.share()) as u64);
        let left_s = progress.left_s(start.elapsed().as_secs_f64(), from);
        if !bar.is_hidden() {
            bar.set_message(told(&tells(job), left_s));
        }
    }
    bar.finish_and_clear();
    AT_WORK.store(false, Ordering::Relaxed);
    if cancelled() {
        return Err(NotDone::Interrupted {
            what: what.to_owned(),
            progress: job.progress(),
            kept: None,
        });
    }
    job.refusal().map_or(Ok(()), |problem| Err(NotDone::Refused(problem.to_owned())))
}

/// Steps of the next slice, where one of `steps` took `took_s`.
fn next_steps(steps: u64, took_s: f64) -> u64 {
    if took_s > 2.0 * SLICE_S {
        (steps / 2).max(1)
    } else if took_s < 0.5 * SLICE_S {
        steps.saturating_mul(2)
    } else {
        steps
    }
}

fn told(progress: &str, left_s: Option<f64>) -> String {
    let left = left_s.map(|left_s| {
        let left = Duration::try_from_secs_f64(left_s.round()).unwrap_or(Duration::MAX);
        format!(", {} left", HumanDuration(left))
    });
    format!("{progress}{}", left.unwrap_or_default())
}

fn bar(what: &str, quiet: bool) -> ProgressBar {
    // indicatif draws nothing where stderr is no terminal.
    let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(BAR as u64), target);
    let style = ProgressStyle::with_template("{prefix:<16} {wide_bar} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.set_prefix(what.to_owned());
    bar
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slices_grow_and_shrink_towards_their_time() {
        assert_eq!(next_steps(16, 0.001), 32);
        assert_eq!(next_steps(16, 0.1), 16);
        assert_eq!(next_steps(16, 1.0), 8);
        assert_eq!(next_steps(1, 60.0), 1);
        assert_eq!(next_steps(u64::MAX, 0.0), u64::MAX);
    }

    #[test]
    fn the_bar_says_how_far_and_how_long() {
        let progress = Progress { done: 37.4, total: 180.0, unit: "runs" };
        assert_eq!(told(&progress.to_string(), None), "37 of 180 runs");
        assert_eq!(told(&progress.to_string(), Some(12.3)), "37 of 180 runs, 12 seconds left");
        assert_eq!(
            told(&progress.to_string(), Some(f64::INFINITY)).split(',').next(),
            Some("37 of 180 runs")
        );
    }
}

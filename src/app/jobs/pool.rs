//! The pool of threads of the desktop: one fewer than there are cores, so that frames have one to
//! themselves.

use std::sync::{Arc, LazyLock};

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::{Listed, POOL_SLICE_S};
use crate::run::job::{OneThread, Threads};

/// None where the system gives no threads: then frames do the work.
static POOL: LazyLock<Option<ThreadPool>> = LazyLock::new(|| {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let name = |index| format!("job {index}");
    ThreadPoolBuilder::new()
        .num_threads(cores.saturating_sub(1).max(1))
        .thread_name(name)
        .build()
        .ok()
});

/// The threads of the pool, from one of them.
struct Pool;

impl Threads for Pool {
    fn count(&self) -> usize {
        rayon::current_num_threads()
    }

    fn run(&self, lanes: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..lanes).into_par_iter().with_max_len(1).for_each(work);
    }
}

/// Works at a job until it is over or stopped.
pub fn work_at(job: &Arc<dyn Listed>) {
    if !job.claim() {
        return;
    }
    match &*POOL {
        Some(pool) => slice(pool, Arc::clone(job)),
        None => {
            job.pool_slice(&OneThread, super::FRAME_SLICE_S);
        }
    }
}

/// One slice, and then, behind those of the other jobs, the next.
fn slice(pool: &'static ThreadPool, job: Arc<dyn Listed>) {
    pool.spawn_fifo(move || {
        if job.pool_slice(&Pool, POOL_SLICE_S) {
            slice(pool, job);
        }
    });
}

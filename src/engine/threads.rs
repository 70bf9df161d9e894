//! Threads that share one step: fixed stretches of work, no shared sums, so the bits do not depend
//! on how many there are.
//!
//! Workers spin for a short while between steps, then park. The thread that calls takes the first
//! stretch itself. Per-call threads (scoped spawn, about 20 µs) cost more than a step of 600
//! particles, and a general pool cannot promise fixed stretches; hence this small one.
#![allow(
    unsafe_code,
    reason = "lends a borrowed task to workers for the length of one call"
)]

use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;

/// More threads than this are not used.
pub const MAX_THREADS: usize = 64;

/// Fewer items than this per thread are not worth waking one.
const LEAST_SHARE: usize = 256;

/// Rounds a worker spins before it parks: some tens of microseconds.
const SPIN: u32 = 20_000;

/// The items of one part when `total` items are cut into `parts`.
pub fn share(total: usize, parts: usize, part: usize) -> std::ops::Range<usize> {
    total * part / parts..total * (part + 1) / parts
}

/// A borrowed task: a call and its data, both valid until all workers are done.
#[derive(Clone, Copy)]
struct Task {
    // SAFETY: whoever calls it passes the `data` beside it and a part below `parts`, each once.
    call: unsafe fn(*const (), usize),
    data: *const (),
    parts: usize,
}

// SAFETY: `data` points to a `Borrowed` whose closure is `Sync` and whose jobs are `Send`, and
// `Threads::run` keeps it alive until every worker has reported back.
unsafe impl Send for Task {}

struct Shared {
    task: Mutex<Option<Task>>,
    epoch: AtomicU64,
    busy: AtomicUsize,
    failed: AtomicBool,
    stop: AtomicBool,
}

/// A team of threads.
pub struct Threads {
    shared: Arc<Shared>,
    workers: Vec<JoinHandle<()>>,
}

impl Default for Threads {
    fn default() -> Self {
        Self::new(1)
    }
}

impl Threads {
    /// A team of `count` threads, the caller included.
    pub fn new(count: usize) -> Self {
        let shared = Arc::new(Shared {
            task: Mutex::new(None),
            epoch: AtomicU64::new(0),
            busy: AtomicUsize::new(0),
            failed: AtomicBool::new(false),
            stop: AtomicBool::new(false),
        });
        let workers = (1..count.clamp(1, MAX_THREADS))
            .map_while(|part| {
                let shared = Arc::clone(&shared);
                std::thread::Builder::new()
                    .name(format!("ballast-{part}"))
                    .spawn(move || work(&shared, part))
                    .ok()
            })
            .collect();
        Self { shared, workers }
    }

    /// Number of threads.
    pub fn count(&self) -> usize {
        self.workers.len() + 1
    }

    /// Into how many parts so many items are worth cutting.
    pub fn parts(&self, items: usize) -> usize {
        self.count().min(items / LEAST_SHARE).max(1)
    }

    /// Runs `work` on every job, one job per thread, and waits for all.
    ///
    /// # Panics
    /// If a job panicked, or there are more jobs than threads.
    pub fn run<J: Send, F: Fn(&mut J) + Sync>(&self, jobs: &mut [J], work: F) {
        struct Borrowed<J, F> {
            jobs: *mut J,
            work: F,
        }
        // SAFETY: `data` comes from `run` below, which outlives the call; see the block inside.
        unsafe fn call<J, F: Fn(&mut J)>(data: *const (), part: usize) {
            // SAFETY: `run` made `data` from a `Borrowed<J, F>` that outlives the call, and each
            // part, below the number of jobs, is run by one thread only.
            let (borrowed, job) = unsafe {
                let borrowed = &*data.cast::<Borrowed<J, F>>();
                (borrowed, &mut *borrowed.jobs.add(part))
            };
            (borrowed.work)(job);
        }
        assert!(jobs.len() <= self.count(), "one job per thread");
        let parts = jobs.len();
        let borrowed = Borrowed {
            jobs: jobs.as_mut_ptr(),
            work,
        };
        let data = std::ptr::from_ref(&borrowed).cast();
        if parts > 1 {
            let task = Task {
                call: call::<J, F>,
                data,
                parts,
            };
            *self
                .shared
                .task
                .lock()
                .unwrap_or_else(PoisonError::into_inner) = Some(task);
            self.shared
                .busy
                .store(self.workers.len(), Ordering::Relaxed);
            self.shared.epoch.fetch_add(1, Ordering::Release);
            for worker in &self.workers {
                worker.thread().unpark();
            }
        }
        // The borrow must outlive the workers even when the caller's own part panics.
        let wait = Wait {
            shared: &self.shared,
            active: parts > 1,
        };
        if parts > 0 {
            // SAFETY: part 0 exists and no worker runs it.
            unsafe { call::<J, F>(data, 0) };
        }
        drop(wait);
        assert!(
            !self.shared.failed.swap(false, Ordering::Relaxed),
            "a worker thread panicked"
        );
    }
}

struct Wait<'a> {
    shared: &'a Shared,
    active: bool,
}

impl Drop for Wait<'_> {
    fn drop(&mut self) {
        let mut rounds = 0;
        while self.active && self.shared.busy.load(Ordering::Acquire) > 0 {
            rounds += 1;
            if rounds < SPIN {
                std::hint::spin_loop();
            } else {
                std::thread::yield_now();
            }
        }
    }
}

fn work(shared: &Shared, part: usize) {
    let mut seen = 0;
    loop {
        let mut rounds = 0;
        loop {
            if shared.stop.load(Ordering::Acquire) {
                return;
            }
            let epoch = shared.epoch.load(Ordering::Acquire);
            if epoch != seen {
                seen = epoch;
                break;
            }
            rounds += 1;
            if rounds < SPIN {
                std::hint::spin_loop();
            } else {
                std::thread::park();
            }
        }
        let task = *shared.task.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(task) = task.filter(|task| part < task.parts) {
            let run = std::panic::AssertUnwindSafe(|| {
                // SAFETY: the task is alive until this worker counts itself off below.
                unsafe { (task.call)(task.data, part) }
            });
            if std::panic::catch_unwind(run).is_err() {
                shared.failed.store(true, Ordering::Relaxed);
            }
        }
        shared.busy.fetch_sub(1, Ordering::Release);
    }
}

impl Drop for Threads {
    fn drop(&mut self) {
        self.shared.stop.store(true, Ordering::Release);
        for worker in self.workers.drain(..) {
            worker.thread().unpark();
            // A worker's panic was reported by `run`.
            drop(worker.join());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_job_is_done_once() {
        let threads = Threads::new(3);
        for round in 0..200u64 {
            let mut jobs = [round, round + 1, round + 2];
            threads.run(&mut jobs, |job| *job *= 2);
            assert_eq!(jobs, [2 * round, 2 * round + 2, 2 * round + 4]);
        }
    }

    #[test]
    fn shares_cover_everything() {
        for total in [0, 1, 7, 1000] {
            let cut: Vec<usize> = (0..3).flat_map(|part| share(total, 3, part)).collect();
            assert_eq!(cut, (0..total).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_panic_in_a_worker_reaches_the_caller() {
        let threads = Threads::new(2);
        let caught = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            threads.run(&mut [0, 1], |job| {
                assert!(*job == 0, "job 1 fails on purpose");
            });
        }));
        assert!(caught.is_err());
        threads.run(&mut [0, 0], |job| *job += 1);
    }
}

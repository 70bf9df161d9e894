//! Threads that share one step: fixed stretches of work, no shared sums, so the bits do not depend
//! on how many there are.
//!
//! Each worker has a desk where the caller lays a task, and spins before it: handing over and
//! waiting are a few loads and stores, no call to the system. One that finds nothing for some
//! hundred microseconds parks. The thread that calls takes the first stretch itself, and then those
//! that no worker has begun: on a busy machine it does not wait for threads that others keep from
//! running. Per-call threads (scoped spawn, about 20 µs) cost more than a step of 600 particles, and
//! a general pool cannot promise fixed stretches; hence this small one.
#![allow(
    unsafe_code,
    reason = "lends a borrowed task to workers for the length of one call"
)]

use std::cell::UnsafeCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::JoinHandle;

/// More threads than this are not used.
pub const MAX_THREADS: usize = 64;

/// Fewer items than this per thread are not worth a wait: some tenths of a microsecond, twice that
/// of the wait itself.
const LEAST_SHARE: usize = 128;

/// Rounds that are spun before a thread lets others run: some hundred microseconds.
const SPIN: u32 = 10_000;

/// The same where there are more threads than processors.
const SPIN_CROWDED: u32 = 50;

/// Times a worker lets others run before it parks.
const YIELDS: u32 = 20;

/// The items of one part when `total` items are cut into `parts`.
pub fn share(total: usize, parts: usize, part: usize) -> std::ops::Range<usize> {
    total * part / parts..total * (part + 1) / parts
}

/// Processors that this process may use.
pub fn processors() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

/// Threads that pay for so many particles on so many processors, where the user did not say: with
/// fewer particles each, two threads save little and lose much on a busy machine.
pub fn suited(particles: usize, processors: usize) -> usize {
    (particles / WORTH_A_THREAD).clamp(1, processors.clamp(1, MAX_THREADS))
}

/// Particles that are worth a thread unasked.
const WORTH_A_THREAD: usize = 1000;

/// A borrowed task: a call and its data, both valid until all workers are done.
#[derive(Clone, Copy)]
struct Task {
    // SAFETY: whoever calls it passes the `data` beside it and the part it was laid out for, once.
    call: unsafe fn(*const (), usize),
    data: *const (),
}

/// Where a worker finds its tasks: a cache line of its own.
#[repr(align(128))]
struct Desk {
    /// Number of the task that lies here.
    laid: AtomicU64,
    /// Number of the last task that somebody began.
    begun: AtomicU64,
    /// Number of the last task that the worker did, or the caller in its place.
    done: AtomicU64,
    parked: AtomicBool,
    failed: AtomicBool,
    stop: AtomicBool,
    /// Written by the caller, read by the worker if that was the one to begin it; the caller then
    /// waits for `done`.
    task: UnsafeCell<Option<Task>>,
}

// SAFETY: `task` is written and read in turns that `laid`, `begun` and `done` hand over, and what its
// `data` points to, a `Borrowed` whose closure is `Sync` and whose jobs are `Send`, lives until `done`.
unsafe impl Sync for Desk {}
// SAFETY: as above.
unsafe impl Send for Desk {}

struct Worker {
    desk: Arc<Desk>,
    handle: JoinHandle<()>,
}

/// A team of threads.
pub struct Threads {
    workers: Vec<Worker>,
    spin: u32,
}

impl Default for Threads {
    fn default() -> Self {
        Self::new(1)
    }
}

impl Threads {
    /// A team of `count` threads, the caller included.
    pub fn new(count: usize) -> Self {
        let count = count.clamp(1, MAX_THREADS);
        let crowded = count > 1 && count > processors();
        let spin = if crowded { SPIN_CROWDED } else { SPIN };
        let workers = (1..count)
            .map_while(|part| {
                let desk = Arc::new(Desk {
                    laid: AtomicU64::new(0),
                    begun: AtomicU64::new(0),
                    done: AtomicU64::new(0),
                    parked: AtomicBool::new(false),
                    failed: AtomicBool::new(false),
                    stop: AtomicBool::new(false),
                    task: UnsafeCell::new(None),
                });
                let own = Arc::clone(&desk);
                let handle = std::thread::Builder::new()
                    .name(format!("ballast-{part}"))
                    .spawn(move || own.attend(part, spin))
                    .ok()?;
                Some(Worker { desk, handle })
            })
            .collect();
        Self { workers, spin }
    }

    /// A team of so many threads, or, for 0, of as many as suit so many particles.
    pub fn team(threads: usize, particles: usize) -> Self {
        Self::new(match threads {
            0 => suited(particles, processors()),
            count => count,
        })
    }

    /// Number of threads.
    pub fn count(&self) -> usize {
        self.workers.len() + 1
    }

    /// Into how many parts so many items are worth cutting.
    pub fn parts(&self, items: usize) -> usize {
        self.count().min(items / LEAST_SHARE).max(1)
    }

    /// Runs `work` on stretches of items, told where each begins.
    pub fn each<T: Send>(&self, items: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
        let (total, parts) = (items.len(), self.parts(items.len()));
        if parts == 1 {
            return work(0, items);
        }
        let mut jobs: [(usize, &mut [T]); MAX_THREADS] = std::array::from_fn(|_| (0, &mut [][..]));
        let mut rest = items;
        for (part, job) in jobs.iter_mut().enumerate().take(parts) {
            let stretch = share(total, parts, part);
            let (own, others) = rest.split_at_mut(stretch.len());
            *job = (stretch.start, own);
            rest = others;
        }
        self.run(&mut jobs[..parts], |(first, items)| work(*first, items));
    }

    /// Runs `work` on each of `parts` parts, one per thread, and waits for all.
    ///
    /// # Panics
    /// As [`Self::run`].
    pub fn split(&self, parts: usize, work: impl Fn(usize) + Sync) {
        let mut jobs: [usize; MAX_THREADS] = std::array::from_fn(|part| part);
        self.run(&mut jobs[..parts], |part| work(*part));
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
        if jobs.is_empty() {
            return;
        }
        let borrowed = Borrowed {
            jobs: jobs.as_mut_ptr(),
            work,
        };
        let data = std::ptr::from_ref(&borrowed).cast();
        let helpers = &self.workers[..jobs.len() - 1];
        for worker in helpers {
            let call = call::<J, F>;
            worker.lay(Task { call, data });
        }
        // The borrow must outlive the workers even when the caller's own part panics.
        let wait = Wait {
            helpers,
            spin: self.spin,
        };
        // SAFETY: part 0 exists and no worker runs it.
        unsafe { call::<J, F>(data, 0) };
        for (part, worker) in helpers.iter().enumerate() {
            let number = worker.desk.laid.load(Ordering::Relaxed);
            if worker.desk.begin(number) {
                worker.desk.done.store(number, Ordering::Relaxed);
                // SAFETY: whoever begins a part is the only one to run it.
                unsafe { call::<J, F>(data, part + 1) };
            }
        }
        drop(wait);
        let failed = |worker: &Worker| worker.desk.failed.swap(false, Ordering::Relaxed);
        // All of them, so that none is left set.
        let failures = helpers.iter().filter(|worker| failed(worker)).count();
        assert!(failures == 0, "a worker thread panicked");
    }
}

impl Worker {
    /// Hands a task over.
    fn lay(&self, task: Task) {
        let desk = &self.desk;
        // SAFETY: what lay here before was begun by the caller, or the worker is done with it: `run`
        // waits for that.
        unsafe { *desk.task.get() = Some(task) };
        // In one order with `parked` for both: either the worker sees the task or this one sees it
        // parked.
        desk.laid.fetch_add(1, Ordering::SeqCst);
        if desk.parked.load(Ordering::SeqCst) {
            self.handle.thread().unpark();
        }
    }
}

/// Waits for the workers at its end.
struct Wait<'a> {
    helpers: &'a [Worker],
    spin: u32,
}

impl Drop for Wait<'_> {
    fn drop(&mut self) {
        for Worker { desk, .. } in self.helpers {
            let laid = desk.laid.load(Ordering::Relaxed);
            // Nobody begins what is still lying here after this.
            if desk.begin(laid) {
                continue;
            }
            let mut rounds = 0;
            while desk.done.load(Ordering::Acquire) != laid {
                rounds += 1;
                if rounds < self.spin {
                    std::hint::spin_loop();
                } else {
                    std::thread::yield_now();
                }
            }
        }
    }
}

impl Desk {
    /// Whether the one who asks is the first to begin the task of this number.
    fn begin(&self, number: u64) -> bool {
        let (before, order) = (number - 1, Ordering::AcqRel);
        self.begun
            .compare_exchange(before, number, order, Ordering::Acquire)
            .is_ok()
    }

    /// Does what is laid here, until told to stop.
    fn attend(&self, part: usize, spin: u32) {
        let mut seen = 0;
        while let Some(number) = self.wait(seen, spin) {
            seen = number;
            if !self.begin(number) {
                continue;
            }
            // SAFETY: the caller laid the task and does not touch it before `done`.
            let task = unsafe { *self.task.get() };
            let run = std::panic::AssertUnwindSafe(|| {
                if let Some(task) = task {
                    // SAFETY: the task is alive until `done` says that this part is.
                    unsafe { (task.call)(task.data, part) }
                }
            });
            if std::panic::catch_unwind(run).is_err() {
                self.failed.store(true, Ordering::Relaxed);
            }
            self.done.store(number, Ordering::Release);
        }
    }

    /// Until a task after number `seen` is laid: its number; nothing if there will be none.
    fn wait(&self, seen: u64, spin: u32) -> Option<u64> {
        let mut rounds = 0;
        loop {
            let laid = self.laid.load(Ordering::Acquire);
            if laid != seen {
                return Some(laid);
            }
            if self.stop.load(Ordering::Relaxed) {
                return None;
            }
            rounds += 1;
            if rounds < spin {
                std::hint::spin_loop();
            } else if rounds < spin + YIELDS {
                std::thread::yield_now();
            } else {
                self.parked.store(true, Ordering::SeqCst);
                if self.laid.load(Ordering::SeqCst) == seen && !self.stop.load(Ordering::SeqCst) {
                    std::thread::park();
                }
                self.parked.store(false, Ordering::SeqCst);
                rounds = 0;
            }
        }
    }
}

impl Drop for Threads {
    fn drop(&mut self) {
        for worker in self.workers.drain(..) {
            worker.desk.stop.store(true, Ordering::SeqCst);
            worker.handle.thread().unpark();
            // A worker's panic was reported by `run`.
            drop(worker.handle.join());
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
    fn fewer_jobs_than_threads_and_idle_times_lose_nothing() {
        let threads = Threads::new(4);
        let mut sum = 0;
        for round in 0..400usize {
            let mut jobs = vec![0; 1 + round % 4];
            threads.run(&mut jobs, |job| *job += 1);
            sum += jobs.iter().sum::<usize>();
            if round % 100 == 99 {
                // Until all are parked, however busy the machine is.
                let parked = |worker: &Worker| worker.desk.parked.load(Ordering::SeqCst);
                let mut tries = 0;
                while !threads.workers.iter().all(parked) {
                    std::thread::yield_now();
                    tries += 1u64;
                    assert!(tries < 1_000_000_000, "a worker goes on spinning");
                }
            }
        }
        assert_eq!(sum, 1000);
    }

    #[test]
    fn shares_cover_everything() {
        for total in [0, 1, 7, 1000] {
            let cut: Vec<usize> = (0..3).flat_map(|part| share(total, 3, part)).collect();
            assert_eq!(cut, (0..total).collect::<Vec<_>>());
        }
    }

    #[test]
    fn stretches_know_where_they_begin() {
        for threads in [1, 2, 3] {
            let mut items = vec![0; 1000];
            Threads::new(threads).each(&mut items, |first, items| {
                for (k, item) in items.iter_mut().enumerate() {
                    *item = first + k;
                }
            });
            assert_eq!(items, (0..1000).collect::<Vec<_>>());
        }
    }

    #[test]
    fn few_particles_get_one_thread_and_none_more_than_there_are_processors() {
        assert_eq!(suited(0, 8), 1);
        assert_eq!(suited(1999, 8), 1);
        assert_eq!(suited(2000, 8), 2);
        assert_eq!(suited(1_000_000, 8), 8);
        assert_eq!(suited(1_000_000, 0), 1);
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

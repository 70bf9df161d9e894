//! Threads that share one step: fixed stretches of work, no shared sums, so the bits do not depend
//! on how many there are.
//!
//! Each worker has a desk where the caller lays a task, and spins before it: handing over and
//! waiting are a few loads and stores, no call to the system. One that finds nothing for some
//! hundred microseconds parks. The thread that calls takes the first stretch itself, and soon after
//! those that no worker has begun: on a busy machine it does not wait for threads that others keep
//! from running. Per-call threads (scoped spawn, about 20 µs) cost more than a step of 600 particles,
//! and a general pool cannot promise fixed stretches; hence this small one.
#![allow(
    unsafe_code,
    reason = "lends a borrowed task to workers for the length of one call"
)]

mod together;

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

/// Rounds that a caller waits for a worker before it looks whether that one has begun: some
/// microseconds.
const PATIENCE: u32 = 100;

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

/// Padded to cache lines of its own, so that a write beside it does not take it away from the thread that
/// uses it.
#[repr(align(128))]
pub(super) struct Apart<T>(pub(super) T);

/// Where a worker finds its tasks. They are numbered from 1.
struct Desk {
    /// Written by the caller only.
    order: Apart<Order>,
    /// Number of the last task that somebody began: the worker, as a rule, and then the caller does not
    /// look here.
    begun: Apart<AtomicU64>,
    /// Number of the last task that is done.
    done: Apart<AtomicU64>,
    parked: Apart<AtomicBool>,
    failed: Apart<AtomicBool>,
}

struct Order {
    /// Number of the task that lies here.
    laid: AtomicU64,
    stop: AtomicBool,
    /// Read by the worker if that was the one to begin it; the caller then waits for the end.
    task: UnsafeCell<Option<Task>>,
}

// SAFETY: `task` is written and read in turns that `laid`, `begun` and `done` hand over, and what its `data`
// points to, a closure that is `Sync`, lives until the task is done.
unsafe impl Sync for Desk {}
// SAFETY: as above.
unsafe impl Send for Desk {}

struct Worker {
    desk: Arc<Desk>,
    handle: JoinHandle<()>,
}

/// A team of threads, which works for one caller at a time.
pub struct Threads {
    workers: Vec<Worker>,
    spin: u32,
    busy: AtomicBool,
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
                    order: Apart(Order {
                        laid: AtomicU64::new(0),
                        stop: AtomicBool::new(false),
                        task: UnsafeCell::new(None),
                    }),
                    begun: Apart(AtomicU64::new(0)),
                    done: Apart(AtomicU64::new(0)),
                    parked: Apart(AtomicBool::new(false)),
                    failed: Apart(AtomicBool::new(false)),
                });
                let own = Arc::clone(&desk);
                let handle = std::thread::Builder::new()
                    .name(format!("ballast-{part}"))
                    .spawn(move || own.attend(part, spin))
                    .ok()?;
                Some(Worker { desk, handle })
            })
            .collect();
        Self {
            workers,
            spin,
            busy: AtomicBool::new(false),
        }
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

    /// Runs `work` on every job, one job per thread, and waits for all.
    ///
    /// # Panics
    /// If a job panicked, or there are more jobs than threads.
    pub fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
        struct Jobs<J>(*mut J);
        // SAFETY: each job is worked on by one thread.
        unsafe impl<J: Send> Sync for Jobs<J> {}
        impl<J> Jobs<J> {
            // SAFETY: whoever calls it is the only one to work on this part, which there must be.
            #[allow(clippy::mut_from_ref, reason = "each part has its own")]
            unsafe fn of(&self, part: usize) -> &mut J {
                // SAFETY: the caller's.
                unsafe { &mut *self.0.add(part) }
            }
        }
        let all = Jobs(jobs.as_mut_ptr());
        // SAFETY: parts are the jobs, and each is run by one thread.
        self.split(jobs.len(), |part| work(unsafe { all.of(part) }));
    }

    /// Runs `work` on each of `parts` parts, one per thread, and waits for all.
    ///
    /// # Panics
    /// If a part panicked, or there are more parts than threads.
    pub fn split<F: Fn(usize) + Sync>(&self, parts: usize, work: F) {
        // SAFETY: `data` comes from `split` below, which outlives the call.
        unsafe fn call<F: Fn(usize)>(data: *const (), part: usize) {
            // SAFETY: `split` made `data` from an `F` that outlives the call.
            unsafe { (*data.cast::<F>())(part) }
        }
        assert!(parts <= self.count(), "one part per thread");
        if parts == 0 {
            return;
        }
        if self.busy.swap(true, Ordering::Acquire) {
            // Asked from within, or by another thread: nobody is free.
            return (0..parts).for_each(work);
        }
        // To the very end, so that nobody clears what is asked below.
        let _busy = Busy(&self.busy);
        let data = std::ptr::from_ref(&work).cast();
        let helpers = &self.workers[..parts - 1];
        for worker in helpers {
            let call = call::<F>;
            worker.lay(Task { call, data });
        }
        // The borrow must outlive the workers even when the caller's own part panics.
        let wait = Wait {
            helpers,
            spin: self.spin,
        };
        work(0);
        for (part, worker) in helpers.iter().enumerate() {
            if !worker.is_soon_done() && worker.take_back() {
                work(part + 1);
            }
        }
        drop(wait);
        let failed = |worker: &Worker| worker.desk.failed.0.load(Ordering::Relaxed);
        assert!(!helpers.iter().any(failed), "a worker thread panicked");
    }
}

impl Worker {
    /// Hands a task over.
    fn lay(&self, task: Task) {
        let order = &self.desk.order.0;
        // SAFETY: what lay here before was begun by the caller, or the worker is done with it: `split`
        // waits for that.
        unsafe { *order.task.get() = Some(task) };
        // Looked at first: it hardly ever is.
        if self.desk.failed.0.load(Ordering::Relaxed) {
            self.desk.failed.0.store(false, Ordering::Relaxed);
        }
        let number = order.laid.load(Ordering::Relaxed) + 1;
        order.laid.store(number, Ordering::Release);
        // One that parks just now may be missed here: whoever takes its task back sees it.
        self.wake(Ordering::Relaxed);
    }

    /// Wakes it if it is parked.
    fn wake(&self, order: Ordering) {
        if self.desk.parked.0.load(order) {
            self.handle.thread().unpark();
        }
    }

    /// Whether its task is done within a short wait, which looks at nothing that the worker writes before
    /// the end.
    fn is_soon_done(&self) -> bool {
        let laid = self.desk.order.0.laid.load(Ordering::Relaxed);
        for _ in 0..PATIENCE {
            if self.desk.done.0.load(Ordering::Acquire) == laid {
                return true;
            }
            std::hint::spin_loop();
        }
        false
    }

    /// Takes its task back unless it was begun.
    fn take_back(&self) -> bool {
        let desk = &self.desk;
        let number = desk.order.0.laid.load(Ordering::Relaxed);
        let mine = desk.begin(number);
        if mine {
            // Whoever waits waits for nobody.
            desk.done.0.store(number, Ordering::Relaxed);
            // In one order with what the worker does before it parks: either it sees the task, which is
            // begun, or it is seen here.
            std::sync::atomic::fence(Ordering::SeqCst);
            self.wake(Ordering::SeqCst);
        }
        mine
    }
}

/// Waits for the workers at its end.
struct Wait<'a> {
    helpers: &'a [Worker],
    spin: u32,
}

/// Marks the team as free again at its end.
struct Busy<'a>(&'a AtomicBool);

impl Drop for Busy<'_> {
    fn drop(&mut self) {
        self.0.store(false, Ordering::Release);
    }
}

impl Drop for Wait<'_> {
    fn drop(&mut self) {
        for worker in self.helpers {
            // Nobody begins what is still lying here after this.
            if worker.is_soon_done() || worker.take_back() {
                continue;
            }
            let desk = &worker.desk;
            let laid = desk.order.0.laid.load(Ordering::Relaxed);
            let mut rounds = 0;
            while desk.done.0.load(Ordering::Acquire) != laid {
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
            .0
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
            let task = unsafe { *self.order.0.task.get() };
            let run = std::panic::AssertUnwindSafe(|| {
                if let Some(task) = task {
                    // SAFETY: the task is alive until `done` says that this part is.
                    unsafe { (task.call)(task.data, part) }
                }
            });
            if std::panic::catch_unwind(run).is_err() {
                self.failed.0.store(true, Ordering::Relaxed);
            }
            self.done.0.store(number, Ordering::Release);
        }
    }

    /// Until a task after number `seen` is laid: its number; nothing if there will be none.
    fn wait(&self, seen: u64, spin: u32) -> Option<u64> {
        let mut rounds = 0;
        loop {
            let laid = self.order.0.laid.load(Ordering::Acquire);
            if laid != seen {
                return Some(laid);
            }
            if self.order.0.stop.load(Ordering::Relaxed) {
                return None;
            }
            rounds += 1;
            if rounds < spin {
                std::hint::spin_loop();
            } else if rounds < spin + YIELDS {
                std::thread::yield_now();
            } else {
                self.parked.0.store(true, Ordering::SeqCst);
                let order = &self.order.0;
                if order.laid.load(Ordering::SeqCst) == seen && !order.stop.load(Ordering::SeqCst) {
                    std::thread::park();
                }
                self.parked.0.store(false, Ordering::SeqCst);
                rounds = 0;
            }
        }
    }
}

impl Drop for Threads {
    fn drop(&mut self) {
        for worker in self.workers.drain(..) {
            worker.desk.order.0.stop.store(true, Ordering::SeqCst);
            worker.handle.thread().unpark();
            // A worker's panic was reported by `split`.
            drop(worker.handle.join());
        }
    }
}

#[cfg(test)]
mod tests;

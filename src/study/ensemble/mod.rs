//! Ensembles: one scene run with many seeds, several at a time.
//!
//! Each run is that of its seed alone, on one thread of its own, so the bits depend neither on how
//! many run at a time nor on which of them ends first.

pub mod spread;
pub mod table;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Does a task for every seed, at most `threads` at a time, and answers in the order of the seeds.
///
/// # Panics
/// If a task did.
pub fn each<T: Send>(seeds: &[u64], threads: usize, task: impl Fn(u64) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let done: Vec<Mutex<Option<T>>> = seeds.iter().map(|_| Mutex::new(None)).collect();
    let work = || {
        loop {
            let k = next.fetch_add(1, Ordering::Relaxed);
            let Some(&seed) = seeds.get(k) else {
                return;
            };
            let answer = task(seed);
            *done[k].lock().unwrap_or_else(PoisonError::into_inner) = Some(answer);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, seeds.len().max(1)) {
            scope.spawn(work);
        }
    });
    let answers = done.into_iter().map(|slot| {
        let answer = slot.into_inner().unwrap_or_else(PoisonError::into_inner);
        answer.expect("every seed was taken by a thread that has ended well")
    });
    answers.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_seed_is_done_once_and_answers_come_in_order() {
        let seeds: Vec<u64> = (5..60).collect();
        let expected: Vec<u64> = seeds.iter().map(|seed| seed * seed).collect();
        for threads in [0, 1, 3, 100] {
            let taken = AtomicUsize::new(0);
            let answers = each(&seeds, threads, |seed| {
                taken.fetch_add(1, Ordering::Relaxed);
                seed * seed
            });
            assert_eq!(answers, expected, "{threads} threads");
            assert_eq!(taken.into_inner(), seeds.len());
        }
        assert!(each(&[], 2, |seed| seed).is_empty());
    }

    #[test]
    fn as_many_run_at_a_time_as_there_are_threads() {
        // Each waits for the other: one at a time would wait for ever.
        let both = std::sync::Barrier::new(2);
        let leaders = each(&[1, 2], 2, |_| both.wait().is_leader());
        assert_eq!(leaders.iter().filter(|leader| **leader).count(), 1);
    }
}

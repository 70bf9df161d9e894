//! Handing over, waiting, and what panics leave behind.

use super::*;

#[test]
fn stretches_answer_in_their_order() {
    for count in [1, 2, 3] {
        let threads = Threads::new(count);
        for total in [0, 1, 127, 128 * count, 1000] {
            let mut items = vec![1u64; total];
            let span = |first: usize, items: &mut [u64]| {
                for item in items.iter_mut() {
                    *item += 1;
                }
                Some([first, first + items.len()])
            };
            // Each begins where the one before ends.
            let join = |a: Option<[usize; 2]>, b: Option<[usize; 2]>| match (a, b) {
                (Some(a), Some(b)) => (a[1] == b[0]).then_some([a[0], b[1]]),
                (a, b) => a.or(b),
            };
            let all = threads.join(&mut items, None, span, join);
            assert_eq!(all, Some([0, total]), "{count} threads");
            assert!(items.iter().all(|item| *item == 2));
        }
    }
}

#[test]
fn both_things_are_done_once() {
    for count in [1, 2, 5] {
        let (mut one, mut other) = (0, 0);
        Threads::new(count).both(|| one += 1, || other += 2);
        assert_eq!([one, other], [1, 2]);
    }
}

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
            let parked = |worker: &Worker| worker.desk.parked.0.load(Ordering::SeqCst);
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

/// Until somebody sets it, or a while has passed.
fn wait_for(flag: &AtomicBool) -> bool {
    (0..WHILE).any(|_| {
        std::thread::yield_now();
        flag.load(Ordering::Acquire)
    })
}

/// Turns that others are given: some milliseconds.
const WHILE: usize = 20_000;

/// Until a worker has begun part 1 once: in which try. On a busy machine the caller may take it back
/// several times.
fn until_a_worker_helps(threads: &Threads, mut once: impl FnMut(&AtomicBool) -> bool) -> usize {
    for tries in 0..10_000 {
        if once(&AtomicBool::new(false)) {
            return tries;
        }
        // One that was missed when it parked is awake by then.
        threads.split(2, |_| {});
    }
    panic!("no worker ever helps");
}

#[test]
fn a_parked_worker_is_woken() {
    let threads = Threads::new(2);
    let mut at_once = 0;
    for _ in 0..20 {
        let parked = &threads.workers[0].desk.parked.0;
        while !parked.load(Ordering::SeqCst) {
            std::thread::yield_now();
        }
        let caller = std::thread::current().id();
        let tries = until_a_worker_helps(&threads, |begun| {
            let helped = AtomicBool::new(false);
            threads.split(2, |part| {
                if part == 0 {
                    wait_for(begun);
                } else {
                    begun.store(true, Ordering::Release);
                    let other = std::thread::current().id() != caller;
                    helped.store(other, Ordering::Relaxed);
                }
            });
            helped.into_inner()
        });
        at_once += usize::from(tries == 0);
    }
    // By the task itself, and not only after it was taken back.
    assert!(at_once > 0);
}

/// What part 0 and part 1 do once a worker has begun the latter, and whether the caller was told.
fn panics(own: bool, others: bool) {
    let threads = Threads::new(2);
    until_a_worker_helps(&threads, |begun| {
        let written = AtomicBool::new(false);
        let caller = std::thread::current().id();
        let caught = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            threads.split(2, |part| {
                if part == 0 {
                    let helped = wait_for(begun);
                    assert!(!(own && helped), "part 0 fails on purpose");
                } else if std::thread::current().id() != caller {
                    begun.store(true, Ordering::Release);
                    // The caller has its panic meanwhile.
                    (0..WHILE).for_each(|_| std::thread::yield_now());
                    // What the caller lent is still there, panic or not.
                    written.store(true, Ordering::Release);
                    assert!(!others, "part 1 fails on purpose");
                }
            });
        }));
        let helped = begun.load(Ordering::Acquire);
        if helped {
            assert!(caught.is_err() && written.load(Ordering::Acquire));
        }
        helped
    });
    // Nothing is left of it.
    threads.split(2, |_| {});
}

#[test]
fn a_panic_in_a_worker_reaches_the_caller() {
    panics(false, true);
}

#[test]
fn a_panic_of_the_caller_waits_for_the_workers() {
    panics(true, false);
    panics(true, true);
}

#[test]
fn whoever_asks_from_within_works_alone() {
    let threads = Threads::new(3);
    let done = AtomicU64::new(0);
    threads.split(3, |_| {
        threads.split(3, |part| {
            done.fetch_add(1 << (8 * part), Ordering::Relaxed);
        });
    });
    assert_eq!(done.into_inner(), 0x03_03_03);
    threads.split(3, |_| {});
}

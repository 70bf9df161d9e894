//! What a team does together: the same on stretches of items, or two things at once.

use super::{MAX_THREADS, Threads, share};

/// One of two things that are done once.
enum Job<A, B> {
    One(A),
    Other(B),
    Done,
}

impl Threads {
    /// Runs `work` on stretches of items, told where each begins.
    pub fn each<T: Send>(&self, items: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
        self.join(items, (), work, |(), ()| ());
    }

    /// The same, and joins what the stretches answer, in their order. How many there are must not matter:
    /// to join with `none` changes nothing.
    pub fn join<T: Send, R: Copy + Send>(
        &self,
        items: &mut [T],
        none: R,
        work: impl Fn(usize, &mut [T]) -> R + Sync,
        join: impl Fn(R, R) -> R,
    ) -> R {
        let (total, parts) = (items.len(), self.parts(items.len()));
        if parts == 1 {
            return work(0, items);
        }
        let mut jobs: [(usize, &mut [T], R); MAX_THREADS] =
            std::array::from_fn(|_| (0, &mut [][..], none));
        let mut rest = items;
        for (part, job) in jobs.iter_mut().enumerate().take(parts) {
            let stretch = share(total, parts, part);
            let (own, others) = rest.split_at_mut(stretch.len());
            (job.0, job.1) = (stretch.start, own);
            rest = others;
        }
        self.run(&mut jobs[..parts], |(first, items, answer)| {
            *answer = work(*first, items);
        });
        jobs[..parts].iter().map(|job| job.2).fold(none, join)
    }

    /// Does two things, at the same time if there is anybody to help.
    pub fn both(&self, one: impl FnOnce() + Send, other: impl FnOnce() + Send) {
        if self.count() == 1 {
            one();
            return other();
        }
        let mut jobs = [Job::One(one), Job::Other(other)];
        self.run(&mut jobs, |job| match std::mem::replace(job, Job::Done) {
            Job::One(one) => one(),
            Job::Other(other) => other(),
            Job::Done => {}
        });
    }
}

//! How fast memory is: a copy of more than the caches hold.

use std::fs;
use std::sync::Barrier;
use std::time::Instant;

/// Times it is copied; the best counts.
const TIMES: u32 = 9;

/// How many times the largest cache is copied, and what is copied where no cache is known [bytes].
const CACHES: usize = 4;
const UNKNOWN: usize = 64 << 20;

/// At most so much is copied, by all threads together [bytes].
const MOST: usize = 256 << 20;

/// What memory is measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Memory {
    /// Bytes that so many threads read and write in a second while they copy, best of several.
    pub copy: f64,
    /// Largest cache [bytes], as far as the system tells: what stays in it is not moved.
    pub cache: Option<usize>,
}

impl Memory {
    /// Measures it with so many threads at a time.
    pub fn measured(threads: usize) -> Self {
        let cache = cache();
        let threads = threads.max(1);
        let rate = best_rate(threads, each(cache, threads));
        Self { copy: rate, cache }
    }

    /// Share of the copy's rate that a step of so many bytes reaches at so many steps per second;
    /// none for one that the caches hold.
    pub fn share(&self, bytes: usize, rate: f64) -> Option<f64> {
        let held = bytes <= self.cache.unwrap_or(UNKNOWN);
        (!held).then(|| bytes as f64 * rate / self.copy)
    }
}

/// What each thread copies [bytes]: together more than the cache, and no more memory for more threads.
fn each(cache: Option<usize>, threads: usize) -> usize {
    let all = CACHES * cache.unwrap_or(UNKNOWN);
    all.min(MOST).div_ceil(threads)
}

/// Bytes read and written per second, the best of several copies by all threads at once.
fn best_rate(threads: usize, bytes: usize) -> f64 {
    let barrier = Barrier::new(threads);
    let copy = || {
        let from = vec![1_u8; bytes];
        let mut to = vec![0_u8; bytes];
        let times = (0..TIMES).map(|_| {
            barrier.wait();
            let start = Instant::now();
            to.copy_from_slice(std::hint::black_box(&from));
            std::hint::black_box(&mut to);
            start.elapsed().as_secs_f64()
        });
        times.collect::<Vec<f64>>()
    };
    let times: Vec<Vec<f64>> = std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(copy)).collect();
        let own = copy();
        let others = others.into_iter().filter_map(|other| other.join().ok());
        others.chain([own]).collect()
    });
    // The slowest thread decides how long a copy took.
    let slowest = |k: usize| times.iter().map(|own| own[k]).fold(0.0, f64::max);
    let best = (0..TIMES as usize)
        .map(slowest)
        .fold(f64::INFINITY, f64::min);
    2.0 * (threads * bytes) as f64 / best.max(f64::MIN_POSITIVE)
}

/// Largest cache of the first processor [bytes].
fn cache() -> Option<usize> {
    let folders = fs::read_dir("/sys/devices/system/cpu/cpu0/cache").ok()?;
    let sizes = folders.flatten().filter_map(|folder| {
        let text = fs::read_to_string(folder.path().join("size")).ok()?;
        size(text.trim())
    });
    sizes.max()
}

/// A size as the system writes it: 32K, 1M.
fn size(text: &str) -> Option<usize> {
    let end = text.find(|c: char| !c.is_ascii_digit());
    let (digits, unit) = text.split_at(end.unwrap_or(text.len()));
    let factor = match unit {
        "" => 1,
        "K" => 1 << 10,
        "M" => 1 << 20,
        "G" => 1 << 30,
        _ => return None,
    };
    digits.parse::<usize>().ok()?.checked_mul(factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read() {
        assert_eq!(size("32K"), Some(32 << 10));
        assert_eq!(size("1M"), Some(1 << 20));
        assert_eq!(size("512"), Some(512));
        assert_eq!(size("big"), None);
        assert_eq!(size("3X"), None);
    }

    #[test]
    fn what_the_caches_hold_is_not_compared_with_memory() {
        let memory = Memory {
            copy: 1e10,
            cache: Some(1000),
        };
        assert_eq!(memory.share(1000, 1e6), None);
        assert_eq!(memory.share(2000, 2.5e6), Some(0.5));
    }

    #[test]
    fn threads_share_what_is_copied() {
        for cache in [None, Some(1 << 20), Some(33 << 20), Some(1 << 30)] {
            let alone = each(cache, 1);
            assert!(alone <= MOST, "{cache:?}");
            for threads in 2..=64 {
                let all = threads * each(cache, threads);
                assert!(all >= alone && all < alone + threads, "{cache:?} {threads}");
            }
        }
    }

    /// A copy that were not made, or whose bytes were counted wrongly by a thousand, would not lie
    /// between a hundredth and a hundred times of what one byte after the other takes.
    #[test]
    fn a_copy_takes_time() {
        let bytes = 1 << 20;
        let start = Instant::now();
        let mut sum = 0_u64;
        for k in 0..bytes as u64 {
            sum = std::hint::black_box(sum ^ k);
        }
        let one_by_one = bytes as f64 / start.elapsed().as_secs_f64();
        let rate = best_rate(2, bytes);
        assert!(
            rate > 0.01 * one_by_one && rate < 1000.0 * one_by_one,
            "{rate} {one_by_one} {sum}"
        );
    }
}

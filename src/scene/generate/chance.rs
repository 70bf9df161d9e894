//! Random numbers: the same for the same seed and stream on every machine, whatever else is drawn.

use chacha20::ChaCha8Rng;
use chacha20::rand_core::{Rng, SeedableRng};

/// A sequence of random numbers.
pub(super) struct Chance(ChaCha8Rng);

impl Chance {
    /// The sequence of a seed and a stream: any two are independent (ChaCha with eight rounds,
    /// Bernstein 2008).
    pub(super) fn new(seed: u64, stream: u64) -> Self {
        Self::of_key(seed, 0, stream)
    }

    /// The sequence of a seed and a moment of a run: cycles done and next number.
    pub(super) fn of_moment(seed: u64, (cycle, number): (u64, u32)) -> Self {
        Self::of_key(seed, cycle.saturating_add(1), u64::from(number))
    }

    fn of_key(seed: u64, moment: u64, stream: u64) -> Self {
        let mut key = [0; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8..16].copy_from_slice(&moment.to_le_bytes());
        let mut numbers = ChaCha8Rng::from_seed(key);
        numbers.set_stream(stream);
        Self(numbers)
    }

    /// Uniform in [0, 1): a multiple of 2^-53.
    pub(super) fn fraction(&mut self) -> f64 {
        // Both steps are exact.
        (self.0.next_u64() >> 11) as f64 * (0.5 / (1u64 << 52) as f64)
    }

    /// Uniform in (0, 1], for logarithms.
    pub(super) fn above_zero(&mut self) -> f64 {
        1.0 - self.fraction()
    }

    /// A whole number below `n`; uneven by less than n / 2^64.
    pub(super) fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.0.next_u64()) * n as u128) >> 64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bits_are_those_of_chacha() {
        // First words of the block of key 0, nonce 0, counter 0 with eight rounds: the ECRYPT test
        // vectors (set 6 of Salsa's successor, as in draft-strombergson-chacha-test-vectors-01, TC1).
        let mut chance = Chance::new(0, 0);
        assert_eq!(
            chance.0.next_u64().to_le_bytes(),
            [0x3e, 0x00, 0xef, 0x2f, 0x89, 0x5f, 0x40, 0xd6]
        );
    }

    #[test]
    fn streams_and_seeds_differ() {
        let first = |seed, stream| Chance::new(seed, stream).fraction();
        assert!(first(1, 0) != first(2, 0) && first(1, 0) != first(1, 1));
        assert_eq!(first(1, 7), first(1, 7));
    }
}

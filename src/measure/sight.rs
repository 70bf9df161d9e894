//! What a screen can show of an assembly that has more particles than the screen has dots.

/// The part of the plane that is seen, and how finely.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// Lower and upper corner [m].
    pub window: [[f64; 2]; 2],
    /// Dots across and down it.
    pub dots: [u32; 2],
}

/// Dots across and down where nobody has said how finely it is seen.
const UNKNOWN: [u32; 2] = [240; 2];

/// Most dots across and down that are told apart: those of a screen of 500 by 250 characters.
const MOST: u32 = 1000;

/// Radius in dots from which a disc is more than a dot.
const ROUND: f64 = 0.75;

impl Sight {
    /// All of this box [m].
    pub fn whole(window: [[f64; 2]; 2]) -> Self {
        Self {
            window,
            dots: UNKNOWN,
        }
    }

    /// Whether another one has as many dots, each less than a dot away from where it is in this one.
    pub fn is_within_a_dot(&self, other: &Self) -> bool {
        let [low, high] = self.window;
        let near = |k: usize| {
            let dot = (high[k] - low[k]) / f64::from(self.dots[k]);
            (0..2).all(|end| (self.window[end][k] - other.window[end][k]).abs() < dot)
        };
        self.dots == other.dots && near(0) && near(1)
    }

    /// The same with a quarter of it more on each side, so that what is moved into it is there already.
    #[must_use]
    pub fn wider(self) -> Self {
        let [low, high] = self.window;
        let more = [0, 1].map(|k| 0.25 * (high[k] - low[k]));
        Self {
            window: [
                [0, 1].map(|k| low[k] - more[k]),
                [0, 1].map(|k| high[k] + more[k]),
            ],
            dots: self.dots.map(|n| n + n.div_ceil(2)),
        }
    }
}

/// Where something is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Place {
    /// Nowhere.
    Outside,
    /// At several dots: it is larger than one.
    Large,
    /// At this one.
    Dot(usize),
}

/// The dots of a sight.
#[derive(Debug)]
pub(super) struct Grid {
    low: [f64; 2],
    per_metre: [f64; 2],
    dots: [usize; 2],
    /// The same, and the finer of the two scales.
    size: [f64; 2],
    finest: f64,
}

impl Grid {
    pub(super) fn new(sight: &Sight) -> Self {
        let dots = sight.dots.map(|n| n.clamp(1, MOST) as usize);
        let [low, high] = sight.window;
        let per_metre = [0, 1].map(|k| dots[k] as f64 / (high[k] - low[k]).max(f64::MIN_POSITIVE));
        Self {
            low,
            per_metre,
            dots,
            size: dots.map(|n| n as f64),
            finest: per_metre[0].max(per_metre[1]),
        }
    }

    /// How many dots there are.
    pub(super) fn count(&self) -> usize {
        self.dots[0] * self.dots[1]
    }

    /// Place of something that reaches so far around this point [m].
    pub(super) fn place(&self, at: [f64; 2], reach: f64) -> Place {
        let place = [0, 1].map(|k| (at[k] - self.low[k]) * self.per_metre[k]);
        // Nearly all of a crowd.
        let is_small = reach * self.finest < ROUND;
        if is_small && (0..2).all(|k| place[k] >= 0.0 && place[k] < self.size[k]) {
            return Place::Dot(place[1] as usize * self.dots[0] + place[0] as usize);
        }
        let around = self.per_metre.map(|scale| reach * scale);
        let seen =
            (0..2).all(|k| place[k] + around[k] >= 0.0 && place[k] - around[k] <= self.size[k]);
        if !seen {
            return Place::Outside;
        }
        if !is_small {
            return Place::Large;
        }
        let [x, y] = [0, 1].map(|k| (place[k].max(0.0) as usize).min(self.dots[k] - 1));
        Place::Dot(y * self.dots[0] + x)
    }
}

/// Lets pass what is seen: everything larger than a dot, and of what is smaller a few for each dot.
#[derive(Debug)]
pub(super) struct Sieve {
    grid: Grid,
    /// How many have passed at each dot.
    passed: Vec<u8>,
}

impl Sieve {
    pub(super) fn new(sight: &Sight) -> Self {
        let grid = Grid::new(sight);
        Self {
            passed: vec![0; grid.count()],
            grid,
        }
    }

    /// Whether something passes that reaches so far around this point [m]; at most so many do that are
    /// no larger than a dot.
    pub(super) fn passes(&mut self, at: [f64; 2], reach: f64, most: u8) -> bool {
        match self.grid.place(at, reach) {
            Place::Outside => false,
            Place::Large => true,
            Place::Dot(dot) => {
                let passes = self.passed[dot] < most;
                self.passed[dot] += u8::from(passes);
                passes
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sight() -> Sight {
        Sight {
            window: [[0.0, 0.0], [10.0, 10.0]],
            dots: [10, 10],
        }
    }

    #[test]
    fn small_ones_pass_once_for_each_dot_large_ones_always_and_none_from_elsewhere() {
        let mut sieve = Sieve::new(&sight());
        let passed = (0..10_000).filter(|&k| {
            let at = [f64::from(k % 100), f64::from(k / 100)].map(|x| 0.1 * x);
            sieve.passes(at, 0.01, 1)
        });
        assert_eq!(passed.count(), 100);
        assert!(sieve.passes([3.2, 3.3], 0.01, 2), "one more");
        assert!(!sieve.passes([3.2, 3.3], 0.01, 2));
        for _ in 0..3 {
            assert!(sieve.passes([3.2, 3.3], 0.75, 1));
            assert!(sieve.passes([-0.7, 3.3], 0.75, 1), "its rim is seen");
        }
        for at in [[-0.8, 3.0], [3.0, 10.8], [f64::NAN, 3.0]] {
            assert!(!sieve.passes(at, 0.75, 1), "{at:?}");
        }
    }

    #[test]
    fn a_sight_that_moves_by_less_than_a_dot_is_the_same_to_whoever_looks() {
        let moved = |x: f64, y: f64, dots| Sight {
            window: [[x, 0.0], [10.0, 10.0 + y]],
            dots,
        };
        assert!(sight().is_within_a_dot(&moved(0.9, -0.9, [10, 10])));
        for other in [
            moved(1.1, 0.0, [10, 10]),
            moved(0.0, 1.1, [10, 10]),
            moved(0.0, 0.0, [10, 11]),
            moved(f64::NAN, 0.0, [10, 10]),
        ] {
            assert!(!sight().is_within_a_dot(&other), "{other:?}");
        }
    }

    #[test]
    fn a_wider_sight_has_dots_of_the_same_size() {
        let wide = sight().wider();
        assert_eq!(wide.window, [[-2.5, -2.5], [12.5, 12.5]]);
        assert_eq!(wide.dots, [15, 15]);
    }
}

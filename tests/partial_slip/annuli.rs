//! The same theory in another form, for comparison: D(η) itself as a list of annuli, of any number.
//!
//! η and N in any units with N = η^1.5, k = 1. A step fills or cuts the outermost annulus and then
//! overwrites D by ±μ from the outside inwards until ∫ D dη is the displacement.

/// How a list of annuli is kept short.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Keep {
    /// Not at all.
    All,
    /// At most so many: whichever corner of ∫ D dη spans the smallest triangle goes, and nothing is
    /// remembered of what went before.
    SmallestTriangle(usize),
}

/// Annuli from the inside outwards: outer overlap, and D in (η, δ) and in (N, T).
#[derive(Clone)]
pub(crate) struct Annuli {
    list: Vec<[f64; 3]>,
    friction: f64,
    keep: Keep,
}

fn load(eta: f64) -> f64 {
    eta * eta.sqrt()
}

impl Annuli {
    pub(crate) fn new(friction: f64, keep: Keep) -> Self {
        Self {
            list: Vec::new(),
            friction,
            keep,
        }
    }

    fn inner(&self, k: usize) -> f64 {
        if k == 0 { 0.0 } else { self.list[k - 1][0] }
    }

    pub(crate) fn len(&self) -> usize {
        self.list.len()
    }

    /// Tangential force.
    pub(crate) fn force(&self) -> f64 {
        let annuli = self.list.iter().enumerate();
        annuli
            .map(|(k, [eta, _, d])| d * (load(*eta) - load(self.inner(k))))
            .sum()
    }

    /// Steps to an overlap with a displacement.
    pub(crate) fn step(&mut self, overlap: f64, d: f64) {
        let mut missing = d;
        let old = self.inner(self.list.len());
        if overlap > old {
            let most = self.friction * (overlap - old);
            let fill = d.clamp(-most, most);
            let slope = fill / (overlap - old);
            self.list.push([overlap, slope, slope]);
            missing -= fill;
        }
        while self.inner(self.list.len()) > overlap {
            let [eta, slope, _] = self.list.pop().expect("not empty");
            let inner = self.inner(self.list.len()).max(overlap);
            missing += slope * (eta - inner);
            if inner == overlap && self.inner(self.list.len()) < overlap {
                let [.., force] = [0.0, 0.0, slope];
                self.list.push([overlap, slope, force]);
            }
        }
        let s = self.friction.copysign(missing);
        let mut outer = overlap;
        while missing != 0.0 && !self.list.is_empty() {
            let [eta, slope, force] = self.list.pop().expect("not empty");
            let inner = self.inner(self.list.len());
            let most = (s - slope) * (eta - inner);
            if most.abs() < missing.abs() {
                missing -= most;
                outer = inner;
                continue;
            }
            let front = eta - missing / (s - slope);
            missing = 0.0;
            outer = front;
            if front > inner {
                self.list.push([front, slope, force]);
            }
        }
        if outer < overlap {
            self.list.push([overlap, s, s]);
        }
        if let Keep::SmallestTriangle(most) = self.keep {
            while self.list.len() > most {
                self.drop_smallest();
            }
        }
    }

    fn drop_smallest(&mut self) {
        let area = |k: usize| {
            let (a, b, c) = (self.inner(k), self.list[k][0], self.list[k + 1][0]);
            ((self.list[k][1] - self.list[k + 1][1]) * (b - a) * (c - b)).abs()
        };
        let corners = 0..self.list.len() - 1;
        let k = corners
            .min_by(|&i, &j| area(i).total_cmp(&area(j)))
            .expect("at least two");
        let (a, b) = (self.inner(k), self.list[k][0]);
        let [_, slope, force] = self.list.remove(k);
        let outer = &mut self.list[k];
        let c = outer[0];
        outer[1] = (slope * (b - a) + outer[1] * (c - b)) / (c - a);
        let loads = [load(a), load(b), load(c)];
        outer[2] = (force * (loads[1] - loads[0]) + outer[2] * (loads[2] - loads[1]))
            / (loads[2] - loads[0]);
    }
}

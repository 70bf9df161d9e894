//! The same theory in another form, for comparison: D(η) itself as a list of annuli, of any number.
//!
//! N = η^1.5 and k = μ = 1. A step fills or cuts the outermost annulus and then overwrites D by ±1
//! from the outside inwards until ∫ D dη is the displacement.

/// How a list of annuli is kept short.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Keep {
    /// Not at all.
    All,
    /// At most so many: the corner of ∫ D dη that spans the smallest triangle goes, and nothing is
    /// remembered of what went before.
    SmallestTriangle(usize),
}

/// From `inner` to `outer`.
#[derive(Clone, Copy)]
struct Annulus {
    inner: f64,
    outer: f64,
    /// D in (η, δ) and in (N, T): the same until annuli are joined.
    slopes: [f64; 2],
    /// T up to `inner`.
    below: f64,
}

impl Annulus {
    fn force(&self) -> f64 {
        self.below + self.slopes[1] * (load(self.outer) - load(self.inner))
    }
}

/// Annuli from the inside outwards.
#[derive(Clone)]
pub(crate) struct Annuli {
    list: Vec<Annulus>,
    keep: Keep,
}

fn load(eta: f64) -> f64 {
    eta * eta.sqrt()
}

impl Annuli {
    pub(crate) fn new(keep: Keep) -> Self {
        Self {
            list: Vec::new(),
            keep,
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.list.len()
    }

    /// Tangential force.
    pub(crate) fn force(&self) -> f64 {
        self.list.last().map_or(0.0, Annulus::force)
    }

    fn overlap(&self) -> f64 {
        self.list.last().map_or(0.0, |annulus| annulus.outer)
    }

    fn push(&mut self, outer: f64, slope: f64) {
        self.list.push(Annulus {
            inner: self.overlap(),
            outer,
            slopes: [slope; 2],
            below: self.force(),
        });
    }

    /// Steps to an overlap with a displacement; answers the tangential force.
    pub(crate) fn step(&mut self, overlap: f64, d: f64) -> f64 {
        let mut missing = d;
        let growth = overlap - self.overlap();
        if growth > 0.0 {
            let fill = d.clamp(-growth, growth);
            self.push(overlap, fill / growth);
            missing -= fill;
        }
        while self.overlap() > overlap {
            let last = self.list.last_mut().expect("not empty");
            missing += last.slopes[0] * (last.outer - overlap.max(last.inner));
            if last.inner < overlap {
                last.outer = overlap;
            } else {
                self.list.pop();
            }
        }
        let slope = 1.0_f64.copysign(missing);
        while missing != 0.0 {
            let Some(last) = self.list.last_mut() else {
                break;
            };
            let rise = slope - last.slopes[0];
            if (rise * (last.outer - last.inner)).abs() > missing.abs() {
                last.outer -= missing / rise;
                break;
            }
            missing -= rise * (last.outer - last.inner);
            self.list.pop();
        }
        if self.overlap() < overlap {
            self.push(overlap, slope);
        }
        if let Keep::SmallestTriangle(most) = self.keep {
            while self.list.len() > most {
                self.drop_smallest();
            }
        }
        self.force()
    }

    fn drop_smallest(&mut self) {
        let area = |k: &usize| {
            let (near, far) = (self.list[*k], self.list[k + 1]);
            let bend = near.slopes[0] - far.slopes[0];
            (bend * (near.outer - near.inner) * (far.outer - far.inner)).abs()
        };
        let corners = 0..self.list.len() - 1;
        let k = corners
            .min_by(|i, j| area(i).total_cmp(&area(j)))
            .expect("at least two");
        let (near, far) = (self.list.remove(k), self.list[k]);
        let shift =
            near.slopes[0] * (near.outer - near.inner) + far.slopes[0] * (far.outer - far.inner);
        let force = far.force() - near.below;
        self.list[k] = Annulus {
            inner: near.inner,
            outer: far.outer,
            slopes: [
                shift / (far.outer - near.inner),
                force / (load(far.outer) - load(near.inner)),
            ],
            below: near.below,
        };
    }
}

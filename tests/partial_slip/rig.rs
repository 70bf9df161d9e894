//! One contact that is led along a path, with its ledger.

use ballast::engine::contact::diagram::{Diagram, Partial};

/// Parameters of a contact, and what it is loaded with for most tests.
#[derive(Clone, Copy)]
pub(crate) struct Pair {
    /// (4/3) E* √R* [N/m^1.5].
    pub(crate) hertz: f64,
    /// E*/(4 G*).
    pub(crate) k: f64,
    pub(crate) friction: f64,
    /// Normal force [N].
    pub(crate) load: f64,
}

impl Pair {
    /// Two equal spheres of a radius [m], Young's modulus [Pa] and Poisson's ratio.
    pub(crate) fn spheres(radius: f64, young: f64, poisson: f64, friction: f64, load: f64) -> Self {
        let e_star = young / (2.0 * (1.0 - poisson * poisson));
        let g_star = young / (4.0 * (1.0 + poisson) * (2.0 - poisson));
        Self {
            hertz: 4.0 / 3.0 * e_star * (radius / 2.0).sqrt(),
            k: e_star / (4.0 * g_star),
            friction,
            load,
        }
    }

    /// Those of the reference files.
    pub(crate) fn reference() -> Self {
        Self::spheres(0.01, 210e9, 0.3, 0.3, 88.0)
    }

    /// Overlap under the load [m].
    pub(crate) fn overlap(&self) -> f64 {
        let root = (self.load / self.hertz).cbrt();
        root * root
    }

    /// Displacement at which the loaded contact slides [m].
    pub(crate) fn star(&self) -> f64 {
        self.friction * self.k * self.overlap()
    }

    /// Force at which it slides [N].
    pub(crate) fn limit(&self) -> f64 {
        self.friction * self.load
    }

    pub(crate) fn law(&self) -> Partial {
        Partial::new(self.hertz, self.k, self.friction, 16)
    }
}

/// A contact under way.
#[derive(Clone, Copy)]
pub(crate) struct Rig {
    law: Partial,
    pub(crate) memory: Diagram<16>,
    /// Overlap and displacement [m].
    pub(crate) at: [f64; 2],
    pub(crate) force: f64,
    /// Work of the mean force of each step [J].
    pub(crate) work: f64,
    /// Losses by sliding and by slip in annuli [J].
    pub(crate) lost: [f64; 2],
}

impl Rig {
    pub(crate) fn new(law: Partial) -> Self {
        Self {
            law,
            memory: Diagram::default(),
            at: [0.0; 2],
            force: 0.0,
            work: 0.0,
            lost: [0.0; 2],
        }
    }

    /// Under its normal load.
    pub(crate) fn loaded(pair: &Pair) -> Self {
        let mut rig = Self::new(pair.law());
        rig.to(pair.overlap(), 0.0);
        rig
    }

    /// One step to an overlap and a displacement; whether it slid.
    pub(crate) fn to(&mut self, overlap: f64, delta: f64) -> bool {
        let d = delta - self.at[1];
        let slip = self.law.advance(overlap, d, &mut self.memory);
        self.work += 0.5 * (self.force + slip.force) * d;
        self.lost[0] += slip.gross;
        self.lost[1] += slip.micro;
        self.force = slip.force;
        self.at = [overlap, delta];
        slip.sliding
    }

    /// A straight line in so many steps.
    pub(crate) fn line(&mut self, overlap: f64, delta: f64, steps: usize) {
        let [a, d] = self.at;
        for k in 1..=steps {
            let s = k as f64 / steps as f64;
            self.to(a + s * (overlap - a), d + s * (delta - d));
        }
    }

    /// Elastic energy [J].
    pub(crate) fn energy(&self) -> f64 {
        self.law.energy(&self.memory)
    }

    /// What the ledger does not account for [J].
    pub(crate) fn residual(&self) -> f64 {
        self.work - self.energy() - self.lost[0] - self.lost[1]
    }

    /// Radius inside the outermost slip annulus over that of the contact.
    pub(crate) fn stick_ratio(&self) -> f64 {
        let shares = self.law.shares(&self.memory);
        let whole = self.memory.overlap();
        let (mut outer, mut sign) = (whole, 0.0);
        for k in (0..shares.len()).rev() {
            let (_, share) = shares[k];
            // Rounding of a thin annulus. What slipped the other way before sticks now.
            if share.abs() < 1.0 - 1e-9 || share * sign < 0.0 {
                break;
            }
            (outer, sign) = (if k == 0 { 0.0 } else { shares[k - 1].0 }, share);
        }
        (outer / whole).sqrt()
    }
}

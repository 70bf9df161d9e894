//! The exact law of contacts with partial slip against closed forms, an independent solution, energy
//! and its own convergence.

#[path = "partial_slip/annuli.rs"]
mod annuli;
#[path = "partial_slip/energy.rs"]
mod energy;
#[path = "partial_slip/histories.rs"]
mod histories;
#[path = "partial_slip/impacts.rs"]
mod impacts;
#[path = "partial_slip/nested.rs"]
mod nested;

use ballast::engine::contact::diagram::{Diagram, Partial};

/// Spheres of 10 mm radius, E = 210 GPa, ν = 0.3, as in the reference files: (4/3) E* √R* and k.
pub(crate) fn spheres() -> (f64, f64) {
    let (young, poisson) = (210e9, 0.3);
    let e_star = young / (2.0 * (1.0 - poisson * poisson));
    let g_star = young / (2.0 * (1.0 + poisson)) / (2.0 * (2.0 - poisson));
    (
        4.0 / 3.0 * e_star * 0.005_f64.sqrt(),
        e_star / (4.0 * g_star),
    )
}

/// Friction of the reference files.
pub(crate) const FRICTION: f64 = 0.3;

/// The contact of the reference files.
pub(crate) fn reference() -> Partial {
    let (hertz, k) = spheres();
    Partial::new(hertz, k, FRICTION, 16)
}

/// Overlap at a normal force [m].
pub(crate) fn overlap_at(load: f64) -> f64 {
    let root = (load / spheres().0).cbrt();
    root * root
}

/// A contact under way.
#[derive(Clone, Copy)]
pub(crate) struct Rig {
    pub(crate) law: Partial,
    pub(crate) memory: Diagram<16>,
    pub(crate) at: [f64; 2],
    pub(crate) force: f64,
    pub(crate) work: f64,
    pub(crate) lost: f64,
}

impl Rig {
    pub(crate) fn new(law: Partial) -> Self {
        Self {
            law,
            memory: Diagram::default(),
            at: [0.0; 2],
            force: 0.0,
            work: 0.0,
            lost: 0.0,
        }
    }

    /// One step to an overlap and a displacement; whether it slid.
    pub(crate) fn to(&mut self, overlap: f64, delta: f64) -> bool {
        let d = delta - self.at[1];
        let slip = self.law.advance(overlap, d, &mut self.memory);
        self.work += 0.5 * (self.force + slip.force) * d;
        self.lost += slip.gross + slip.micro;
        self.force = slip.force;
        self.at = [overlap, delta];
        slip.sliding
    }

    /// A straight line in many steps.
    pub(crate) fn line(&mut self, overlap: f64, delta: f64, steps: usize) {
        let [a, d] = self.at;
        for k in 1..=steps {
            let s = k as f64 / steps as f64;
            self.to(a + s * (overlap - a), d + s * (delta - d));
        }
    }

    pub(crate) fn energy(&self) -> f64 {
        self.law.energy(&self.memory)
    }
}

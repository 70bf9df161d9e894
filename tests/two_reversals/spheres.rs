//! The two spheres of the reference data, and paths of them.

use ballast::engine::contact::two_reversals::TwoReversals;

/// E\* and G\* [Pa] of equal materials.
pub(crate) fn moduli(young: f64, poisson: f64) -> [f64; 2] {
    [
        young / (2.0 * (1.0 - poisson * poisson)),
        young / (4.0 * (1.0 + poisson) * (2.0 - poisson)),
    ]
}

/// What both the laws and the tests need to know of a pair.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spheres {
    pub(crate) young_eff: f64,
    pub(crate) shear_eff: f64,
    pub(crate) r_eff: f64,
    pub(crate) friction: f64,
}

/// Radius 10 mm, E = 210 GPa, ν = 0.3, μ = 0.3.
pub(crate) fn pair() -> Spheres {
    let [young_eff, shear_eff] = moduli(210e9, 0.3);
    Spheres {
        young_eff,
        shear_eff,
        r_eff: 5e-3,
        friction: 0.3,
    }
}

impl Spheres {
    pub(crate) fn law(&self) -> TwoReversals {
        TwoReversals::new(self.young_eff, self.shear_eff, self.r_eff, self.friction)
    }

    /// N [N].
    pub(crate) fn load(&self, overlap: f64) -> f64 {
        4.0 / 3.0 * self.young_eff * self.r_eff.sqrt() * overlap * overlap.sqrt()
    }

    /// α at this N [m].
    pub(crate) fn overlap(&self, load: f64) -> f64 {
        (load / self.load(1.0)).powf(2.0 / 3.0)
    }

    /// κ = E\*/(4 G\*).
    pub(crate) fn kappa(&self) -> f64 {
        self.young_eff / (4.0 * self.shear_eff)
    }

    /// Displacement at which virgin loading slides [m].
    pub(crate) fn slide(&self, overlap: f64) -> f64 {
        self.friction * self.kappa() * overlap
    }
}

/// A path through corners (α, δ), each leg in equal steps of (α, δ).
#[derive(Debug, Clone)]
pub(crate) struct Path {
    pub(crate) name: &'static str,
    /// In units of α and of the sliding displacement at 88 N.
    corners: Vec<[f64; 2]>,
}

impl Path {
    pub(crate) fn new(name: &'static str, corners: &[[f64; 2]]) -> Self {
        Self {
            name,
            corners: corners.to_vec(),
        }
    }

    /// The overlap [m] and the displacement of the step [m], step by step, beginning at rest.
    pub(crate) fn steps(&self, per_leg: usize) -> Vec<[f64; 2]> {
        let pair = pair();
        let overlap = pair.overlap(88.0);
        let unit = [overlap, pair.slide(overlap)];
        let mut from = [0.0; 2];
        let mut steps = Vec::new();
        for &to in &self.corners {
            for i in 1..=per_leg {
                let part = i as f64 / per_leg as f64;
                let alpha = from[0] + (to[0] - from[0]) * part;
                let d = (to[1] - from[1]) / per_leg as f64;
                steps.push([alpha * unit[0], d * unit[1]]);
            }
            from = to;
        }
        steps
    }

    pub(crate) fn mirrored(&self) -> Self {
        Self {
            name: self.name,
            corners: self.corners.iter().map(|[a, d]| [*a, -d]).collect(),
        }
    }
}

/// The fourteen histories: those of the reference data, then seven more.
pub(crate) fn histories() -> Vec<Path> {
    vec![
        Path::new("L_up_slow", &[[0.6, 0.0], [0.6, 0.25], [1.0, 0.45]]),
        Path::new("L_up_fast", &[[0.6, 0.0], [0.6, 0.25], [1.0, 0.85]]),
        Path::new("L_down_hold", &[[1.0, 0.0], [1.0, 0.35], [0.45, 0.35]]),
        Path::new(
            "U_up_slow",
            &[[0.6, 0.0], [0.6, 0.45], [0.6, 0.3], [1.0, 0.1]],
        ),
        Path::new(
            "R_up",
            &[[0.6, 0.0], [0.6, 0.5], [0.6, -0.1], [0.6, 0.05], [1.0, 0.6]],
        ),
        Path::new(
            "R_down",
            &[[1.0, 0.0], [1.0, 0.8], [1.0, -0.2], [1.0, 0.1], [0.6, 0.2]],
        ),
        Path::new(
            "RU_down",
            &[
                [1.0, 0.0],
                [1.0, 0.8],
                [1.0, -0.2],
                [1.0, 0.4],
                [1.0, 0.25],
                [0.6, 0.2],
            ],
        ),
        Path::new("L_after_normal", &[[1.0, 0.0], [1.0, 0.9]]),
        Path::new("U_up_fast", &[[0.6, 0.0], [0.6, 0.4], [1.0, -0.6]]),
        Path::new(
            "U_down",
            &[[1.0, 0.0], [1.0, 0.7], [0.8, -0.1], [0.5, -0.3]],
        ),
        Path::new("L_together", &[[1.0, 0.5], [1.0, 0.9]]),
        Path::new(
            "slide_up_down",
            &[[0.5, 0.0], [0.5, 0.7], [1.0, 1.6], [0.5, 1.2]],
        ),
        Path::new("stuck_relieved", &[[0.3, 0.1], [1.0, 0.6], [0.35, 0.6]]),
        Path::new(
            "nested",
            &[
                [1.0, 0.0],
                [1.0, 0.8],
                [1.0, -0.3],
                [1.0, 0.5],
                [1.0, 0.0],
                [1.0, 0.3],
            ],
        ),
    ]
}

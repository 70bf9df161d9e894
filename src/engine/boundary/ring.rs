//! A ring of boundary particles: everything at or outside a closed curve that deforms with the
//! imposed strain.
//!
//! The curve is a circle at first. A particle that is more than half outside joins the ring (Randall
//! 1989, 6.4.1), so the ring has no gaps to leave by. The ring moves as the strain rate says, or each
//! of its particles carries its share of an imposed stress.

use serde::{Deserialize, Serialize};

use super::straining::{NONE, Ramp, Tensor, velocity};

/// Free particles are looked at every so many cycles.
pub(super) const JOIN_EVERY: u64 = 50;

/// The ring and what acts on it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Ring {
    /// Radius of the curve before it was strained [m].
    pub radius: f64,
    /// Whether its particles may turn.
    pub turning: bool,
    /// Numbers of its particles, ascending.
    pub members: Vec<u32>,
    /// Where the strain has taken the unit vectors.
    gradient: Tensor,
    /// The imposed stress, if the ring carries one.
    load: Option<Load>,
}

/// A stress that the ring carries [Pa], compression positive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Load {
    stress: Tensor,
    ramp: Option<Ramp>,
    /// Numbers of its particles, as they follow each other around the centre.
    chain: Vec<u32>,
}

impl Ring {
    /// Without members yet.
    pub fn new(radius: f64, turning: bool) -> Self {
        Self {
            radius,
            turning,
            members: Vec::new(),
            gradient: [[1.0, 0.0], [0.0, 1.0]],
            load: None,
        }
    }

    /// Whether a point at `d` from the centre is outside the curve.
    pub(super) fn is_outside(&self, d: [f64; 2]) -> bool {
        let [[a, b], [c, e]] = self.gradient;
        let det = a * e - b * c;
        let x = (e * d[0] - b * d[1]) / det;
        let y = (a * d[1] - c * d[0]) / det;
        x * x + y * y > self.radius * self.radius
    }

    /// Radius of the circle with the area of the curve [m].
    pub(super) fn mean_radius(&self) -> f64 {
        let [[a, b], [c, e]] = self.gradient;
        self.radius * (a * e - b * c).sqrt()
    }

    /// Points of the curve, relative to the centre [m].
    pub fn curve(&self, points: usize) -> impl Iterator<Item = [f64; 2]> + '_ {
        (0..points).map(move |k| {
            let angle = std::f64::consts::TAU * k as f64 / points as f64;
            let (s, c) = libm::sincos(angle);
            let [x, y] = [self.radius * c, self.radius * s];
            let [[a, b], [d, e]] = self.gradient;
            [a * x + b * y, d * x + e * y]
        })
    }

    /// Follows a step of `dt` [s].
    pub(super) fn deform(&mut self, rate: &Tensor, dt: f64) {
        let column = |k: usize| {
            let f = [self.gradient[0][k], self.gradient[1][k]];
            let v = velocity(rate, f);
            [f[0] + v[0] * dt, f[1] + v[1] * dt]
        };
        let (one, two) = (column(0), column(1));
        self.gradient = [[one[0], two[0]], [one[1], two[1]]];
    }

    /// Whether its particles carry a stress instead of moving as the strain rate says.
    pub fn is_loaded(&self) -> bool {
        self.load.is_some()
    }

    /// The stress it carries [Pa].
    pub fn stress(&self) -> Option<Tensor> {
        self.load.as_ref().map(|load| load.stress)
    }

    /// Lets it carry a stress [Pa], reached over so many cycles from the one before, or from zero.
    /// `chain` names its particles as they follow each other around the centre.
    pub(super) fn carry(&mut self, stress: Tensor, cycle: u64, over: u64, chain: Vec<u32>) {
        let from = self.stress().unwrap_or(NONE);
        let ramp = (over > 0).then(|| Ramp::new(from, stress, cycle, over));
        self.load = Some(Load {
            stress: if over > 0 { from } else { stress },
            ramp,
            chain,
        });
    }

    /// Its particles as they follow each other while they carry a stress.
    pub(super) fn chain(&self) -> &[u32] {
        self.load.as_ref().map_or(&[], |load| &load.chain)
    }

    /// No stress any more: it moves as the strain rate says.
    pub(super) fn hold(&mut self) {
        self.load = None;
    }

    /// The stress for the boundary at this cycle [Pa].
    pub(super) fn stress_at(&mut self, cycle: u64) -> Option<Tensor> {
        let load = self.load.as_mut()?;
        if let Some(ramp) = &load.ramp {
            let (stress, arrived) = ramp.at(cycle);
            load.stress = stress;
            if arrived {
                load.ramp = None;
            }
        }
        Some(load.stress)
    }
}

/// The order in which points follow each other around the middle, which they are seen from.
pub(super) fn around(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    let angle = |k: usize| libm::atan2(points[k][1], points[k][0]);
    order.sort_by(|&a, &b| angle(a).total_cmp(&angle(b)).then(a.cmp(&b)));
    order
}

/// Force on a corner of a closed chain under a stress [N], from where its neighbours are [m]: half that
/// on each of the two sides that meet there, `thickness` [m] deep. Around a chain they balance.
pub(super) fn corner_force(
    before: [f64; 2],
    after: [f64; 2],
    stress: &Tensor,
    thickness: f64,
) -> [f64; 2] {
    // Outwards, as long as half of both sides.
    let side = [
        0.5 * thickness * (after[1] - before[1]),
        -0.5 * thickness * (after[0] - before[0]),
    ];
    // Tractions: the first index of the stress belongs to the side it acts on.
    [0, 1].map(|j| -(side[0] * stress[0][j] + side[1] * stress[1][j]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corner_forces_balance_and_do_the_work_of_the_stress() {
        let points = [
            [1.0, 0.1],
            [-0.2, 1.3],
            [-1.0, -0.4],
            [0.5, -0.9],
            [0.9, 0.9],
        ];
        let stress = [[3.0, 0.5], [0.5, 1.0]];
        let order = around(&points);
        assert_eq!(order, [2, 3, 0, 4, 1]);
        let mut forces = [[0.0; 2]; 5];
        for (place, &k) in order.iter().enumerate() {
            let (before, after) = (order[(place + 4) % 5], order[(place + 1) % 5]);
            forces[k] = corner_force(points[before], points[after], &stress, 2.0);
        }
        for k in 0..2 {
            assert!(forces.iter().map(|f| f[k]).sum::<f64>().abs() < 1e-14);
        }
        // Σ x_i F_j = -A t σ_ij: twice the mean stress theorem, here for the polygon in order of angle.
        let area = 0.5
            * (0..5)
                .map(|k| {
                    let (a, b) = (points[order[k]], points[order[(k + 1) % 5]]);
                    a[0] * b[1] - a[1] * b[0]
                })
                .sum::<f64>();
        let trace = points
            .iter()
            .zip(&forces)
            .map(|(x, f)| x[0] * f[0] + x[1] * f[1])
            .sum::<f64>();
        assert!((trace + area * 2.0 * 4.0).abs() < 1e-13, "{trace} {area}");
    }

    #[test]
    fn the_curve_follows_the_strain() {
        let mut ring = Ring::new(1.0, false);
        for _ in 0..1000 {
            ring.deform(&[[0.1, 0.0], [0.0, -0.1]], 1e-3);
        }
        assert!(ring.is_outside([0.906, 0.0]) && !ring.is_outside([0.903, 0.0]));
        assert!(ring.is_outside([0.0, 1.106]) && !ring.is_outside([0.0, 1.104]));
    }
}

//! What two materials make of their contact, worked out once per pair of materials.

use serde::{Deserialize, Serialize};

use super::contact::dashpot::{fraction_for_restitution, hertz_fraction_for_restitution};
use super::setup::{Body, Dashpot, Material, PairOverride, Setup};

/// Parameters of a contact between two materials. What the law of the scene does not use is zero.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// Normal stiffness [N/m].
    pub normal_stiffness: f64,
    /// Shear stiffness [N/m].
    pub shear_stiffness: f64,
    /// E*, with 1/E* = (1 - ν1²)/E1 + (1 - ν2²)/E2 [Pa] (Randall 1989, (4.9)).
    pub young: f64,
    /// G*, with 1/G* = (2 - ν1)/G1 + (2 - ν2)/G2 [Pa] (Randall 1989, (4.10)).
    pub shear: f64,
    /// Friction coefficient [-].
    pub friction: f64,
    /// Cohesion [N].
    pub cohesion: f64,
    /// Pull that a bond bears [N].
    pub bond_tension: f64,
    /// Shear that a bond bears without normal force [N].
    pub bond_shear: f64,
    /// Coefficient of rolling friction [-].
    pub rolling_friction: f64,
    /// Rolling stiffness over k_n (μ_r R_r)² [-].
    pub rolling_shape: f64,
    /// Normal dashpot as it was asked for.
    pub dashpot: Dashpot,
    /// Normal and tangential dashpot as fractions of critical.
    pub fraction: [f64; 2],
    /// Normal and tangential dashpot as ratios c/k [s].
    pub beta: [f64; 2],
    /// Whether the dashpot may pull.
    pub pull: bool,
    /// Whether dashpots act on the velocity at the boundary.
    pub centred: bool,
}

impl Pair {
    /// Whether the contact can carry a tangential force.
    pub fn is_frictional(&self) -> bool {
        (self.friction > 0.0 || self.cohesion > 0.0 || self.bond_shear > 0.0)
            && (self.shear_stiffness > 0.0 || self.shear > 0.0)
    }

    /// Gap up to which a bond holds [m].
    pub fn bond_reach(&self) -> f64 {
        if self.normal_stiffness > 0.0 {
            self.bond_tension / self.normal_stiffness
        } else {
            0.0
        }
    }

    /// Whether rolling is resisted.
    pub fn resists_rolling(&self) -> bool {
        self.rolling_friction > 0.0 && (self.normal_stiffness > 0.0 || self.young > 0.0)
    }

    /// Whether a dashpot acts.
    pub fn is_damped(&self) -> bool {
        self.fraction.iter().chain(&self.beta).any(|&c| c > 0.0)
    }
}

/// All pairs of materials, particle-particle and particle-wall.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PairTable {
    materials: usize,
    pairs: Vec<Pair>,
}

impl PairTable {
    /// Works the table out.
    pub fn new(setup: &Setup) -> Self {
        let m = &setup.materials;
        let mut pairs = Vec::with_capacity(2 * m.len() * m.len());
        for a in 0..m.len() {
            for b in 0..m.len() {
                let special = setup.pair([a, b]);
                for wall in [false, true] {
                    pairs.push(combine(setup, &m[a], &m[b], special, wall));
                }
            }
        }
        Self {
            materials: m.len(),
            pairs,
        }
    }

    /// Largest gap up to which any bond of particles holds [m].
    pub fn bond_reach(&self) -> f64 {
        let of_particles = self.pairs.iter().step_by(2);
        of_particles.map(Pair::bond_reach).fold(0.0, f64::max)
    }

    /// The parameters of two materials; `wall`: the second belongs to a wall.
    pub fn get(&self, a: usize, b: usize, wall: bool) -> &Pair {
        &self.pairs[2 * (a * self.materials + b) + usize::from(wall)]
    }
}

fn combine(
    setup: &Setup,
    a: &Material,
    b: &Material,
    special: Option<&PairOverride>,
    wall: bool,
) -> Pair {
    let damping = &setup.damping;
    let dashpot = match special.and_then(|s| s.restitution) {
        Some(e) => Dashpot::Restitution(e),
        None if wall => damping.wall.unwrap_or(damping.contact),
        None => damping.contact,
    };
    let linear = setup.law.has_constant_springs();
    let shears = setup.law.card().shears();
    let given = |pick: fn(&PairOverride) -> Option<f64>| special.and_then(pick);
    let spring = |pick: fn(&PairOverride) -> Option<f64>, own: fn(&Material) -> Option<f64>| {
        let both = || in_series(side(a, own(a)), side(b, own(b)));
        if linear {
            given(pick).unwrap_or_else(both)
        } else {
            0.0
        }
    };
    let elastic = |compliance: fn(&Material) -> f64| {
        let sum = compliance(a) + compliance(b);
        if !linear && sum > 0.0 { 1.0 / sum } else { 0.0 }
    };
    let (fraction, beta) = dashpots(setup, dashpot);
    Pair {
        normal_stiffness: spring(|s| s.normal_stiffness, |m| m.normal_stiffness),
        shear_stiffness: spring(|s| s.shear_stiffness, |m| m.shear_stiffness),
        young: elastic(normal_compliance),
        shear: if shears {
            elastic(shear_compliance)
        } else {
            0.0
        },
        friction: given(|s| s.friction).unwrap_or_else(|| a.friction.min(b.friction)),
        cohesion: given(|s| s.cohesion).unwrap_or_else(|| a.cohesion.min(b.cohesion)),
        bond_tension: given(|s| s.bond_tension)
            .unwrap_or_else(|| a.bond_tension.min(b.bond_tension)),
        bond_shear: given(|s| s.bond_shear).unwrap_or_else(|| a.bond_shear.min(b.bond_shear)),
        rolling_friction: given(|s| s.rolling_friction)
            .unwrap_or_else(|| a.rolling_friction.min(b.rolling_friction)),
        rolling_shape: match setup.body {
            Body::Sphere => 2.25,
            Body::Disc => 3.0,
        },
        dashpot,
        fraction,
        beta,
        pull: damping.pull,
        centred: damping.centred,
    }
}

/// Fractions of critical and ratios c/k of the normal and the tangential dashpot.
fn dashpots(setup: &Setup, normal: Dashpot) -> ([f64; 2], [f64; 2]) {
    let damping = &setup.damping;
    let linear = setup.law.has_constant_springs();
    let (fraction, beta) = match normal {
        Dashpot::None => (0.0, 0.0),
        Dashpot::Fraction(b) => (b, 0.0),
        Dashpot::Beta(beta) => (0.0, beta),
        Dashpot::Restitution(e) if linear => (fraction_for_restitution(e, damping.pull), 0.0),
        Dashpot::Restitution(e) => (hertz_fraction_for_restitution(e, damping.pull), 0.0),
    };
    match damping.tangential {
        Some(b) => ([fraction, b], [beta, 0.0]),
        None if linear => ([fraction; 2], [beta; 2]),
        None => ([fraction, 0.0], [beta, 0.0]),
    }
}

/// (1 - ν²)/E [1/Pa]; zero for a rigid partner, and for what no law has asked for.
fn normal_compliance(m: &Material) -> f64 {
    match (m.rigid, m.young, m.poisson) {
        (false, Some(young), Some(poisson)) => (1.0 - poisson * poisson) / young,
        _ => 0.0,
    }
}

/// (2 - ν)/G [1/Pa] with G = E/(2 (1 + ν)).
fn shear_compliance(m: &Material) -> f64 {
    match (m.rigid, m.young, m.poisson) {
        (false, Some(young), Some(poisson)) => (2.0 - poisson) * 2.0 * (1.0 + poisson) / young,
        _ => 0.0,
    }
}

fn side(material: &Material, stiffness: Option<f64>) -> f64 {
    if material.rigid {
        f64::INFINITY
    } else {
        stiffness.unwrap_or(0.0)
    }
}

/// 2 k1 k2/(k1 + k2): equal materials give k itself, a rigid partner twice the other's.
fn in_series(k1: f64, k2: f64) -> f64 {
    match (k1.is_infinite(), k2.is_infinite()) {
        (true, false) => 2.0 * k2,
        (false, true) => 2.0 * k1,
        (false, false) if k1 + k2 > 0.0 => 2.0 * (k1 * k2) / (k1 + k2),
        // Two rigid bodies, or two without a spring: no contact to model.
        (true, true) | (false, false) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stiffnesses_combine_in_series() {
        assert_eq!(in_series(1.35e9, 1.35e9), 1.35e9);
        assert_eq!(in_series(1.0, 3.0), 1.5);
        assert_eq!(in_series(f64::INFINITY, 3.0), 6.0);
    }
}

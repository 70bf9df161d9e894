//! What two materials make of their contact, worked out once per pair of materials.

use serde::{Deserialize, Serialize};

use super::setup::{Damping, Dashpot, Material, PairOverride, Setup};

/// Parameters of a contact between two materials.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pair {
    /// Normal stiffness [N/m].
    pub normal_stiffness: f64,
    /// Shear stiffness [N/m].
    pub shear_stiffness: f64,
    /// Friction coefficient [-].
    pub friction: f64,
    /// Cohesion [N].
    pub cohesion: f64,
    /// Normal dashpot.
    pub dashpot: Dashpot,
    /// Tangential dashpot as a fraction of critical; `None`: as the normal one.
    pub tangential: Option<f64>,
    /// Whether the dashpot may pull.
    pub pull: bool,
}

impl Pair {
    /// Whether the contact can carry a tangential force.
    pub fn is_frictional(&self) -> bool {
        (self.friction > 0.0 || self.cohesion > 0.0) && self.shear_stiffness > 0.0
    }

    /// Whether a dashpot acts.
    pub fn is_damped(&self) -> bool {
        self.dashpot != Dashpot::None || self.tangential.is_some_and(|b| b > 0.0)
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
                let special = setup
                    .pairs
                    .iter()
                    .rfind(|p| p.materials == [a, b] || p.materials == [b, a]);
                for wall in [false, true] {
                    pairs.push(combine(&m[a], &m[b], special, &setup.damping, wall));
                }
            }
        }
        Self {
            materials: m.len(),
            pairs,
        }
    }

    /// The parameters of two materials; `wall`: the second belongs to a wall.
    pub fn get(&self, a: usize, b: usize, wall: bool) -> &Pair {
        &self.pairs[2 * (a * self.materials + b) + usize::from(wall)]
    }
}

fn combine(
    a: &Material,
    b: &Material,
    special: Option<&PairOverride>,
    damping: &Damping,
    wall: bool,
) -> Pair {
    let dashpot = match special.and_then(|s| s.restitution) {
        Some(e) => Dashpot::Restitution(e),
        None if wall => damping.wall.unwrap_or(damping.contact),
        None => damping.contact,
    };
    let given = |pick: fn(&PairOverride) -> Option<f64>| special.and_then(pick);
    Pair {
        normal_stiffness: given(|s| s.normal_stiffness)
            .unwrap_or_else(|| in_series(side(a, a.normal_stiffness), side(b, b.normal_stiffness))),
        shear_stiffness: given(|s| s.shear_stiffness)
            .unwrap_or_else(|| in_series(side(a, a.shear_stiffness), side(b, b.shear_stiffness))),
        friction: given(|s| s.friction).unwrap_or_else(|| a.friction.min(b.friction)),
        cohesion: given(|s| s.cohesion).unwrap_or_else(|| a.cohesion.min(b.cohesion)),
        dashpot,
        tangential: damping.tangential,
        pull: damping.pull,
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

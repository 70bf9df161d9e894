//! How contacts and forces are distributed over directions, as waves about their mean (Rothenburg &
//! Bathurst 1989; Bathurst & Rothenburg 1988):
//!
//! E(θ) = (1 + a cos 2(θ - θ_a) + b cos 4(θ - θ_b))/2π for contacts,
//! N(θ) = N0 (1 + a_n cos 2(θ - θ_n)) for the mean normal force in a direction,
//! T(θ) = N0 a_t sin 2(θ - θ_t) for the mean tangential force; their tangent points the other way,
//! and so does their sign.
//!
//! a and b are moments of the normals. The waves of the forces are fitted to the contacts by least
//! squares, so that N0 is the mean over directions and not over contacts, and directions with many
//! contacts do not pull at it. Where all branches are alike, sin φ is the deviator of the three waves
//! of second order, ½ (a + a_n + a_t) on common axes, over 1 + ½ a a_n.

use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};

use super::fourth::Fourth;
use super::link::Link;
use super::tensor::{crest, ratio};
use crate::engine::World;

/// Least determinant of directions that a wave can be fitted to; that of equally spread ones is 1/4.
const SPREAD: f64 = 1e-9;

/// A wave over directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Coefficients of cosine and sine.
    pub parts: [f64; 2],
    /// Periods in a full turn.
    pub periods: u32,
}

impl Wave {
    /// Height over the mean.
    pub fn amplitude(&self) -> f64 {
        let [c, s] = self.parts;
        (c * c + s * s).sqrt()
    }

    /// Direction of the crest, less than a period from direction 1 [degrees]; NaN without a wave.
    pub fn angle(&self) -> f64 {
        let [c, s] = self.parts;
        if self.amplitude() > 0.0 {
            crest(s, c, self.periods)
        } else {
            f64::NAN
        }
    }
}

/// Fourier coefficients of a region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fourier {
    /// Contacts, second order: a.
    pub contacts: Wave,
    /// Contacts, fourth order: b.
    pub fourfold: Wave,
    /// Normal forces: a_n. NaN where contacts have fewer than three directions.
    pub normal: Wave,
    /// Tangential forces: a_t. Its angle is the direction in which they add most to the stress. NaN
    /// where contacts have fewer than two directions that are not at right angles.
    pub tangential: Wave,
    /// Mean over directions of the normal force, N0 [N].
    pub mean_normal: f64,
}

impl Fourier {
    /// Fits the touching contacts of the particles marked as inside; `fourth` is their fabric.
    pub fn of(world: &World, inside: &[bool], fourth: &Fourth) -> Self {
        let (mut gram, mut normals) = (Matrix3::zeros(), Vector3::zeros());
        let (mut shears, mut count) = (Vector2::zeros(), 0.0);
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(inside);
            let [n1, n2] = [link.e[0], link.e[1]];
            let [c, s] = [(n1 - n2) * (n1 + n2), 2.0 * n1 * n2];
            let basis = Vector3::new(1.0, c, s);
            gram += weight * (basis * basis.transpose());
            normals += weight * link.normal * basis;
            shears += weight * link.tangential * Vector2::new(c, s);
            count += weight;
        }
        let nothing = || Vector3::from_element(f64::NAN);
        let fitted = inverse(gram, count).map_or_else(nothing, |inverse| inverse * normals);
        let mean_normal = fitted[0];
        let waves = gram.fixed_view::<2, 2>(1, 1).into_owned();
        let sheared = inverse_of_waves(waves, count).map(|inverse| inverse * shears);
        let [cosine, sine] = sheared.map_or([f64::NAN; 2], Into::into);
        let [a, d, e] = fourth.contracted();
        let twofold = |parts| Wave { parts, periods: 2 };
        Self {
            contacts: twofold([2.0 * (a - e), 4.0 * d]),
            fourfold: Wave {
                parts: fourth.fourfold().map(|mean| 2.0 * mean),
                periods: 4,
            },
            normal: twofold([fitted[1], fitted[2]].map(|part| ratio(part, mean_normal))),
            // a_t sin 2(θ - θ_t) has its sine along cos 2θ_t and minus its cosine along sin 2θ_t.
            tangential: twofold([sine, -cosine].map(|part| ratio(part, mean_normal))),
            mean_normal,
        }
    }

    /// sin φ of an assembly in which every branch is alike and forces go by their waves.
    pub fn sin_phi(&self) -> f64 {
        let waves = [self.contacts, self.normal, self.tangential];
        let [c, s] = [0, 1].map(|k| waves.iter().map(|wave| wave.parts[k]).sum::<f64>());
        let (a, n) = (self.contacts.parts, self.normal.parts);
        let common = a[0] * n[0] + a[1] * n[1];
        0.5 * (c * c + s * s).sqrt() / (1.0 + 0.5 * common)
    }
}

/// The inverse of the sums over so many contacts, unless they point in fewer than three directions.
fn inverse(gram: Matrix3<f64>, count: f64) -> Option<Matrix3<f64>> {
    let mean = gram / count;
    (mean.determinant() > SPREAD).then(|| gram.try_inverse())?
}

/// The same of the two waves alone, which two directions determine.
fn inverse_of_waves(gram: Matrix2<f64>, count: f64) -> Option<Matrix2<f64>> {
    let mean = gram / count;
    (mean.determinant() > SPREAD).then(|| gram.try_inverse())?
}

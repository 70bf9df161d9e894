//! The area that two bodies share, and the mean stress on it.
//!
//! Its size is that of the geometry: a = √(R* α), with R* = R1 R2/(R1 + R2), and R at a wall. For
//! spheres of Hertz it is the radius of the contact circle, and the stresses are N/(π a²) and
//! T/(π a²) (Randall 1989, (4.14) and 4.6). Between discs of unit length the same a is half the
//! width of Hertz' strip, and the stresses are N/(2 a) and T/(2 a) per length. Springs have no area
//! of their own: there it says how far bodies of such curvature would have to flatten.

use std::f64::consts::PI;

use super::link::Link;
use crate::engine::World;
use crate::engine::contact_report::Other;
use crate::engine::setup::Body;

/// Area of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactArea {
    /// Radius of the circle, or half the width of the strip: a [m].
    pub radius: f64,
    /// Area [m²].
    pub area: f64,
    /// The smaller of the radii of the two bodies [m].
    pub smaller: f64,
}

impl ContactArea {
    /// Of listed contact k; without overlap it is a point.
    pub fn of(world: &World, k: usize) -> Self {
        let radius = |p: usize| world.particles().row[p].radius;
        let (first, other) = world.bodies(k);
        let (curvature, smaller) = match other {
            Other::Particle(second) => {
                let (a, b) = (radius(first), radius(second));
                (a * b / (a + b), a.min(b))
            }
            Other::Wall(_) => (radius(first), radius(first)),
        };
        let square = (curvature * world.geometry(k).overlap).max(0.0);
        let radius = square.sqrt();
        Self {
            radius,
            area: match world.model().body {
                Body::Sphere => PI * square,
                Body::Disc => 2.0 * radius,
            },
            smaller,
        }
    }

    /// Mean normal and tangential stress of a force [Pa]; 0 over a point that carries nothing.
    pub fn stress(&self, normal: f64, tangential: f64) -> [f64; 2] {
        [normal, tangential].map(|force| if force == 0.0 { 0.0 } else { force / self.area })
    }

    /// a/R of the smaller body: above 0.07 contact laws no longer hold strictly (Randall 1989, 4.6).
    pub fn relative(&self) -> f64 {
        self.radius / self.smaller
    }
}

/// Mean normal stress on each touching contact of the particles marked as inside, and what the contact
/// counts for. Bonds across a gap have no area.
pub fn normal_stresses(world: &World, inside: &[bool]) -> Vec<(f64, f64)> {
    let touching = Link::all(world).filter(Link::is_touching);
    let weighed = touching.map(|link| (link.weight(inside), link));
    weighed
        .filter(|(weight, _)| *weight > 0.0)
        .map(|(weight, link)| (weight, ContactArea::of(world, link.place), link))
        .filter(|(_, area, link)| area.area > 0.0 || !link.bonded)
        .map(|(weight, area, link)| {
            let [normal, _] = area.stress(link.normal, link.tangential);
            (normal, weight)
        })
        .collect()
}

/// Largest pressure of Hertz of listed contact k [Pa]: p0 = 3 N/(2 π a²) = 2 E* a/(π R*) in the middle of
/// a circle, p0 = 2 N/(π a) in that of a strip; NaN if its law knows no moduli.
pub fn peak_pressure(world: &World, k: usize) -> f64 {
    let effective = world.effective(k);
    if effective.young <= 0.0 {
        return f64::NAN;
    }
    let area = ContactArea::of(world, k);
    match world.model().body {
        Body::Sphere => 2.0 * effective.young * area.radius / (PI * effective.radius),
        Body::Disc => {
            let overlap = world.geometry(k).overlap;
            let [normal, _] = world.pass().springs(k, overlap.max(0.0));
            let [mean, _] = area.stress(normal, 0.0);
            4.0 / PI * mean
        }
    }
}

/// |T|/(μ N) of listed contact k; NaN without friction or load.
pub fn obliquity(world: &World, k: usize) -> f64 {
    let reaction = world.reaction(k);
    let limit = world.pair_of(k).friction * reaction.normal;
    if limit > 0.0 {
        reaction.tangential.abs() / limit
    } else {
        f64::NAN
    }
}

/// c/a of listed contact k, the radius of what sticks over that of the contact; NaN if its law knows
/// nothing of it.
pub fn stick_ratio(world: &World, k: usize) -> f64 {
    let traction = world.pass().traction(k);
    let slips = traction.filter(|traction| traction.friction > 0.0);
    slips.map_or(f64::NAN, |traction| traction.stick_ratio())
}

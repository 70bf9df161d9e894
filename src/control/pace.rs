//! How fast a servo may act: stiff assemblies need little strain for much stress, and nothing moves
//! faster through them than a wave.

use crate::engine::World;
use crate::measure::region::Content;

/// Largest inertial number that a servo may cause (GDR MiDi 2004): far below where flow begins to
/// depend on rate.
const INERTIAL: f64 = 1e-3;

/// Time constant of a servo with gain 1, in times that a wave needs across the assembly, if nothing
/// damps the waves.
const CROSSINGS: f64 = 2.0;

/// Angular frequency of the slowest wave that runs in and out of a disc whose edge is held, in the
/// inverse of those times: twice the first zero of J1.
const SLOWEST: f64 = 2.0 * 3.8317;

/// What an assembly answers, and how soon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pace {
    /// Stress per isotropic strain if all particles followed the strain: above the true modulus [Pa].
    pub(super) modulus: f64,
    /// Time constant of a servo with gain 1 [s].
    pub(super) time: f64,
    /// Largest strain rate [1/s].
    pub(super) fastest: f64,
}

impl Pace {
    /// Of a region whose contacts answer with this modulus [Pa] and that shall come under a stress [Pa].
    pub(super) fn of(world: &World, content: &Content, modulus: f64, stress: f64) -> Self {
        let particles = world.particles();
        let (mut mass, mut volume, mut radius) = (0.0, 0.0, 0.0);
        for (row, m) in particles.row.iter().zip(&particles.mass) {
            mass += m;
            volume += std::f64::consts::PI * row.radius * row.radius;
            radius += row.radius;
        }
        let density = mass / (volume * content.thickness);
        let crossing = size(world) * (density / modulus).sqrt();
        let diameter = 2.0 * radius / particles.len() as f64;
        Self {
            modulus,
            time: crossing * crossings(drag(world) * crossing),
            // Without particles there is nothing to move.
            fastest: finite(INERTIAL / diameter * (stress.abs() / density).sqrt()),
        }
    }
}

/// Time constant of a servo with gain 1 in times that a wave needs across, at a damping of the
/// velocities in the inverse of those times.
///
/// A servo that integrates drives waves with 1/(T ω) of what it sees at their frequency ω, and they
/// answer with ω/α: it is stable if T > 1/α. Strong damping makes the assembly follow late instead, by
/// α/ω². Twice the former and half the latter leave a margin.
fn crossings(drag: f64) -> f64 {
    let ringing = if drag > 0.0 { 2.0 / drag } else { CROSSINGS };
    ringing.min(CROSSINGS) + 0.5 * drag / (SLOWEST * SLOWEST)
}

/// Damping of all velocities by `con1` and globally [1/s].
fn drag(world: &World) -> f64 {
    let damping = world.model().damping;
    (1.0 - damping.con1) / world.dt() + damping.global
}

/// What a wave has to cross [m].
fn size(world: &World) -> f64 {
    if let Some(cell) = world.cell() {
        return cell.area().sqrt();
    }
    let [low, high] = world.particles().extent();
    (high[0] - low[0]).max(high[1] - low[1])
}

fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { 0.0 }
}

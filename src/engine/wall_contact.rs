//! Where a particle meets a wall: its face, or one of its ends as a point.
//!
//! Walls have two sides; a particle stays on the one its centre was on when it came near. Where
//! walls share an end, a face beats the end, and the end counts once. An end that stands on the face
//! of another wall is no corner: that wall is met instead.

use serde::{Deserialize, Serialize};

use super::particles::Row;
use super::wall::Wall;

/// A listed pair of particle and wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WallPair {
    /// Index of the particle.
    pub particle: u32,
    /// Index of the wall.
    pub wall: u32,
    /// Side the centre is on: +1 left of the wall's direction, -1 right.
    pub side: f64,
}

/// Where such a pair stands in this cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WallTouch {
    /// Unit vector from the centre to the wall.
    pub e: [f64; 2],
    /// Distance from the centre to the wall; infinite where another wall takes the contact [m].
    pub distance: f64,
    /// Velocity of the wall at the contact [m/s].
    pub v: [f64; 2],
    /// Spin of the wall [rad/s].
    pub spin: f64,
    /// The contact point on the wall [m].
    pub at: [f64; 2],
}

impl Default for WallTouch {
    /// Nowhere near: a pair that was just listed is not touched before it is located.
    fn default() -> Self {
        Self {
            e: [0.0; 2],
            distance: f64::INFINITY,
            v: [0.0; 2],
            spin: 0.0,
            at: [0.0; 2],
        }
    }
}

/// Which wall of a joint takes the contact instead.
pub(super) type TakenBy = Option<u32>;

/// The centre went through the face.
pub(super) struct Through;

/// Works out where a pair stands; `share` is how near two ends must be to count as one [m].
pub(super) fn locate(
    walls: &[Wall],
    pair: &mut WallPair,
    row: &Row,
    share: f64,
) -> Result<(WallTouch, TakenBy), Through> {
    let wall = &walls[pair.wall as usize];
    let foot = Foot::of(wall, row.x);
    if let Some(end) = foot.beyond {
        // Beyond an end the particle may go round to the other side.
        if foot.height != 0.0 {
            pair.side = 1f64.copysign(foot.height);
        }
        let corner = wall.end(end);
        if let Some(taker) = taken(walls, pair.wall as usize, end, row.x, share) {
            return Ok((WallTouch::default(), Some(taker)));
        }
        let d = [corner[0] - row.x[0], corner[1] - row.x[1]];
        let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
        if distance == 0.0 {
            return Err(Through);
        }
        let e = [d[0] / distance, d[1] / distance];
        return Ok((
            WallTouch {
                e,
                distance,
                v: wall.velocity_at(corner),
                spin: wall.spin,
                at: corner,
            },
            None,
        ));
    }
    let distance = pair.side * foot.height;
    if distance <= 0.0 {
        return Err(Through);
    }
    let e = [
        pair.side * wall.direction[1],
        -pair.side * wall.direction[0],
    ];
    let at = [row.x[0] + distance * e[0], row.x[1] + distance * e[1]];
    Ok((
        WallTouch {
            e,
            distance,
            v: wall.velocity_at(at),
            spin: wall.spin,
            at,
        },
        None,
    ))
}

/// The side a centre is on.
pub(super) fn side(wall: &Wall, x: [f64; 2]) -> f64 {
    if Foot::of(wall, x).height >= 0.0 {
        1.0
    } else {
        -1.0
    }
}

/// Distance from a point to the nearest point of the wall [m].
pub fn distance(wall: &Wall, x: [f64; 2]) -> f64 {
    let foot = Foot::of(wall, x);
    match foot.beyond {
        None => foot.height.abs(),
        Some(end) => {
            let corner = wall.end(end);
            let d = [corner[0] - x[0], corner[1] - x[1]];
            (d[0] * d[0] + d[1] * d[1]).sqrt()
        }
    }
}

/// Foot of the perpendicular from a point onto the line of a wall.
struct Foot {
    /// Height over the line, positive on the left [m].
    height: f64,
    /// The end beyond which the foot lies.
    beyond: Option<usize>,
}

impl Foot {
    fn of(wall: &Wall, x: [f64; 2]) -> Self {
        let r = [x[0] - wall.point[0], x[1] - wall.point[1]];
        let along = r[0] * wall.direction[0] + r[1] * wall.direction[1];
        let height = r[1] * wall.direction[0] - r[0] * wall.direction[1];
        // Exactly over an end counts as beyond: over a joint of two walls in line the one point
        // would be two faces otherwise.
        let beyond = if along <= wall.h1 {
            Some(0)
        } else if along >= wall.h2 {
            Some(1)
        } else {
            None
        };
        Self { height, beyond }
    }
}

/// The wall that takes the contact at a shared end, if any.
fn taken(walls: &[Wall], w: usize, end: usize, x: [f64; 2], share: f64) -> TakenBy {
    let corner = walls[w].end(end);
    let mut taker = None;
    for joint in walls[w].joints.iter().filter(|joint| joint.own == end) {
        if !joint.holds(walls, corner, share) {
            continue;
        }
        let other = joint.other;
        match (joint.end, Foot::of(&walls[other], x).beyond) {
            // Some point of the other wall is nearer than the end, or the end itself.
            (None, _) | (Some(_), None) => return Some(other as u32),
            (Some(shared), Some(at)) if at == shared && other < w => taker = Some(other as u32),
            (Some(_), Some(_)) => {}
        }
    }
    taker
}

//! Overlaps of particles with walls at the start.

use super::{ACCEPTED, SLACK, per_cent};
use crate::engine::setup::WallSetup;
use crate::scene::draft::Draft;
use crate::scene::problem::Problem;

/// Reports particles that overlap a wall too much, and centres on a wall.
pub(super) fn check(draft: &Draft<'_>, mut sound: Vec<usize>) {
    let particles = &draft.setup.particles;
    let x = |i: usize| particles[i].at[0];
    sound.sort_by(|&i, &j| x(i).total_cmp(&x(j)));
    let widest = sound
        .iter()
        .map(|&i| particles[i].radius)
        .fold(0.0, f64::max);
    for (w, wall) in draft.setup.walls.iter().enumerate() {
        if !draft.walls[w].sound {
            continue;
        }
        let (left, right) = reach(wall);
        let begin = sound.partition_point(|&i| x(i) < left - widest);
        for &i in sound[begin..]
            .iter()
            .take_while(|&&i| x(i) <= right + widest)
        {
            if !check_wall(draft, i, w) {
                return;
            }
        }
    }
}

/// Leftmost and rightmost point of a wall.
fn reach(wall: &WallSetup) -> (f64, f64) {
    if wall.direction[0] == 0.0 {
        return (wall.point[0], wall.point[0]);
    }
    let ends = [wall.h1, wall.h2].map(|h| wall.point[0] + h * wall.direction[0]);
    (ends[0].min(ends[1]), ends[0].max(ends[1]))
}

/// Whether to go on.
fn check_wall(draft: &Draft<'_>, i: usize, w: usize) -> bool {
    if i < draft.sampled[0] && w < draft.sampled[1] {
        return true;
    }
    let (particle, wall) = (&draft.setup.particles[i], &draft.setup.walls[w]);
    let apart = distance(particle.at, wall);
    let overlap = particle.radius - apart;
    let problem = if apart == 0.0 {
        Problem::new(
            format!(
                "the centre of particle {} lies on wall `{}`",
                i + 1,
                wall.name
            ),
            draft.particles[i].place,
        )
        .remedy("move it to the side it belongs to: a wall pushes towards the side of the centre")
    } else if overlap > particle.radius * (ACCEPTED + SLACK) && !draft.setup.overlap_allowed {
        Problem::new(
            format!(
                "particle {} overlaps wall `{}` by {} of its radius",
                i + 1,
                wall.name,
                per_cent(overlap / particle.radius)
            ),
            draft.particles[i].place,
        )
        .remedy(
            "move it away or make it smaller: up to 5 % is accepted; or write overlap = \
                 \"allow\" in [model]",
        )
    } else {
        return true;
    };
    draft.report.add(
        problem
            .expected(format!("centre of particle {}", i + 1))
            .also(draft.walls[w].place, "the wall"),
    );
    !draft.report.is_full()
}

/// Distance of a centre from the nearest point of a wall.
pub(in crate::scene) fn distance(at: [f64; 2], wall: &WallSetup) -> f64 {
    let [ex, ey] = wall.direction;
    let x = at[0] - wall.point[0];
    let y = at[1] - wall.point[1];
    let along = x * ex + y * ey;
    let across = y * ex - x * ey;
    let beyond = (wall.h1 - along).max(along - wall.h2).max(0.0);
    libm::hypot(across, beyond)
}

//! Overlaps at the start. Particles of like size share a grid whose boxes are as wide as they are,
//! so that a hundred thousand of any mixture of sizes take a fraction of a second.

use super::draft::Draft;
use super::problem::Problem;
use crate::engine::setup::WallSetup;

/// Largest overlap that is accepted, as a fraction of the smaller radius.
const ACCEPTED: f64 = 0.05;
/// Rounding of positions and radii in the preset: an overlap meant to be 5 % is accepted.
const SLACK: f64 = 1e-9;

/// Reports particles that overlap each other or a wall too much, and centres on a wall.
pub(crate) fn check(draft: &Draft<'_>) {
    let sound: Vec<usize> = (0..draft.particles.len())
        .filter(|&i| draft.particles[i].sound)
        .collect();
    if !draft.setup.overlap_allowed {
        check_pairs(draft, &sound);
    }
    check_walls(draft, sound);
}

/// Size class, and row and column of the box within the grid of that class.
type Cell = (i32, i64, i64);

/// Sizes within a factor of two share a class; its boxes are as wide as its widest particle.
fn class(radius: f64) -> i32 {
    libm::ilogb(radius)
}

fn cell(class: i32, at: [f64; 2]) -> Cell {
    // 2 R < 2 * 2^(class + 1). Saturates far outside of any position that is accepted.
    let width = libm::ldexp(1.0, class + 2);
    let index = |x: f64| (x / width).floor() as i64;
    (class, index(at[1]), index(at[0]))
}

fn check_pairs(draft: &Draft<'_>, sound: &[usize]) {
    let particles = &draft.setup.particles;
    let own = |&i: &usize| (cell(class(particles[i].radius), particles[i].at), i);
    // In the order of the boxes: those of a row follow each other, whatever order they came in.
    let mut boxes: Vec<(Cell, usize)> = sound.iter().map(own).collect();
    boxes.sort_unstable();
    let mut classes: Vec<i32> = boxes.iter().map(|((class, ..), _)| *class).collect();
    classes.dedup();
    for &((own, ..), i) in &boxes {
        // A pair is found from its smaller particle, whose neighbours of a class are few.
        for &other in classes.iter().filter(|&&other| other >= own) {
            let (_, y, x) = cell(other, particles[i].at);
            for row in [-1, 0, 1].map(|dy| y.saturating_add(dy)) {
                let first = (other, row, x.saturating_sub(1));
                let last = (other, row, x.saturating_add(1));
                let start = boxes.partition_point(|(cell, _)| *cell < first);
                let near = boxes[start..].iter().take_while(|(cell, _)| *cell <= last);
                for &(_, j) in near {
                    if (other > own || j > i) && !check_pair(draft, i.min(j), i.max(j)) {
                        return;
                    }
                }
            }
        }
    }
}

/// Whether to go on.
fn check_pair(draft: &Draft<'_>, i: usize, j: usize) -> bool {
    if j < draft.sampled[0] {
        // Both come from a run, which has pressed them together.
        return true;
    }
    let (first, second) = (&draft.setup.particles[i], &draft.setup.particles[j]);
    let smaller = first.radius.min(second.radius);
    let apart = libm::hypot(second.at[0] - first.at[0], second.at[1] - first.at[1]);
    let overlap = first.radius + second.radius - apart;
    if overlap <= smaller * (ACCEPTED + SLACK) {
        return true;
    }
    let message = format!(
        "particles {} and {} overlap by {} of the smaller radius",
        i + 1,
        j + 1,
        per_cent(overlap / smaller)
    );
    draft.report.add(
        Problem::new(message, draft.particles[j].place)
            .expected(format!("centre of particle {}", j + 1))
            .also(
                draft.particles[i].place,
                format!("centre of particle {}", i + 1),
            )
            .remedy(
                "move them apart or make them smaller: up to 5 % is accepted; or write \
                     overlap = \"allow\" in [model]",
            ),
    );
    !draft.report.is_full()
}

fn check_walls(draft: &Draft<'_>, mut sound: Vec<usize>) {
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
pub(super) fn distance(at: [f64; 2], wall: &WallSetup) -> f64 {
    let [ex, ey] = wall.direction;
    let x = at[0] - wall.point[0];
    let y = at[1] - wall.point[1];
    let along = x * ex + y * ey;
    let across = y * ex - x * ey;
    let beyond = (wall.h1 - along).max(along - wall.h2).max(0.0);
    libm::hypot(across, beyond)
}

fn per_cent(fraction: f64) -> String {
    let digits = format!("{:.6}", 100.0 * fraction);
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    format!("{digits} %")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::setup::ParticleSetup;
    use crate::scene::draft::Mark;
    use crate::scene::place::Place;
    use crate::scene::problem::Report;

    fn particle(at: [f64; 2], radius: f64) -> ParticleSetup {
        ParticleSetup {
            at,
            radius,
            material: 0,
            velocity: [0.0; 2],
            spin: 0.0,
            angle: 0.0,
            force: [0.0; 2],
            fixed: [false; 3],
        }
    }

    fn found(particles: Vec<ParticleSetup>) -> usize {
        let report = Report::new(Vec::new());
        let mut draft = Draft::new(&report);
        let mark = Mark {
            place: Place::new(0, 0..0),
            sound: true,
        };
        draft.particles = vec![mark; particles.len()];
        draft.setup.particles = particles;
        check(&draft);
        report.count()
    }

    fn brute_force(particles: &[ParticleSetup]) -> usize {
        let mut found = 0;
        for (i, p) in particles.iter().enumerate() {
            for q in &particles[i + 1..] {
                let apart = libm::hypot(p.at[0] - q.at[0], p.at[1] - q.at[1]);
                let overlap = p.radius + q.radius - apart;
                found += usize::from(overlap > (ACCEPTED + SLACK) * p.radius.min(q.radius));
            }
        }
        found
    }

    #[test]
    fn the_grid_finds_what_brute_force_finds() {
        // Halton points, sizes over three decades.
        let halton = |mut i: usize, base: usize| {
            let (mut f, mut r) = (1.0, 0.0);
            while i > 0 {
                f /= base as f64;
                r += f * (i % base) as f64;
                i /= base;
            }
            r
        };
        let particles: Vec<ParticleSetup> = (1..400)
            .map(|i| {
                let at = [halton(i, 2) - 0.5, halton(i, 3) - 0.5];
                particle(at, libm::pow(10.0, -1.5 - 2.0 * halton(i, 5)))
            })
            .collect();
        let expected = brute_force(&particles);
        assert!((20..1000).contains(&expected), "{expected}");
        assert_eq!(found(particles), expected);
    }

    #[test]
    fn five_per_cent_is_accepted_and_more_is_not() {
        let two = |apart| vec![particle([0.0; 2], 1.0), particle([apart, 0.0], 2.0)];
        assert_eq!(found(two(2.95)), 0);
        assert_eq!(found(two(2.949)), 1);
    }

    #[test]
    fn a_hundred_thousand_of_mixed_sizes_are_checked_at_once() {
        let mut particles: Vec<ParticleSetup> = (0..100_000)
            .map(|i| particle([f64::from(i % 300), f64::from(i / 300)], 0.49))
            .collect();
        particles.push(particle([-1e6, 0.0], 9.99e5));
        // Processor time: on a busy machine the clock says nothing.
        let used = || rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime).tv_sec;
        let start = used();
        assert_eq!(found(particles.clone()), 0);
        // All pairs would be 5e9 distances: half a minute on the machine this was written on.
        assert!(used() - start < 5);
        particles.push(particle([7.0, 7.0], 0.1));
        assert_eq!(found(particles), 1);
    }

    #[test]
    fn a_heap_of_equal_centres_ends() {
        let heap = vec![particle([0.0; 2], 1.0); 100_000];
        assert!(found(heap) >= 1000);
    }
}

//! Overlaps at the start. Particles of like size share a grid whose boxes are as wide as they are,
//! so that a hundred thousand of any mixture of sizes take a fraction of a second.

mod images;
mod walls;

pub(super) use walls::distance;

use super::draft::Draft;
use super::problem::Problem;
use images::{Body, Pair, bodies, pair};

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
    walls::check(draft, sound);
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
    let bodies = bodies(draft, sound);
    let size = |body: usize| class(particles[bodies[body].of].radius);
    let own = |body: usize| (cell(size(body), bodies[body].at), body);
    // In the order of the boxes: those of a row follow each other, whatever order they came in.
    let mut boxes: Vec<(Cell, usize)> = (0..bodies.len()).map(own).collect();
    boxes.sort_unstable();
    let mut classes: Vec<i32> = boxes.iter().map(|((class, ..), _)| *class).collect();
    classes.dedup();
    for &((own, ..), i) in &boxes {
        // A pair is found from its smaller particle, whose neighbours of a class are few.
        for &other in classes.iter().filter(|&&other| other >= own) {
            let (_, y, x) = cell(other, bodies[i].at);
            for row in [-1, 0, 1].map(|dy| y.saturating_add(dy)) {
                let first = (other, row, x.saturating_sub(1));
                let last = (other, row, x.saturating_add(1));
                let start = boxes.partition_point(|(cell, _)| *cell < first);
                let near = boxes[start..].iter().take_while(|(cell, _)| *cell <= last);
                for &(_, j) in near {
                    let once = other > own || j > i;
                    if once && !check_pair(draft, &bodies[i], &bodies[j]) {
                        return;
                    }
                }
            }
        }
    }
}

/// Whether to go on.
fn check_pair(draft: &Draft<'_>, a: &Body, b: &Body) -> bool {
    let Some(Pair { of: [i, j], across }) = pair(a, b) else {
        return true;
    };
    if j < draft.sampled[0] {
        // Both come from a run, which has pressed them together.
        return true;
    }
    let [first, second] = [i, j].map(|k| draft.setup.particles[k].radius);
    let smaller = first.min(second);
    let apart = libm::hypot(b.at[0] - a.at[0], b.at[1] - a.at[1]);
    let overlap = first + second - apart;
    if overlap <= smaller * (ACCEPTED + SLACK) {
        return true;
    }
    let share = per_cent(overlap / smaller);
    let edge = if across {
        " across an edge of [cell]"
    } else {
        ""
    };
    let place = draft.particles[j].place;
    let problem = if i == j {
        let message = format!(
            "particle {} overlaps its own image{edge} by {share} of its radius",
            i + 1
        );
        Problem::new(message, place)
            .expected(format!("centre of particle {}", j + 1))
            .remedy(
                "make it smaller or the cell larger: up to 5 % is accepted; or write overlap = \
                     \"allow\" in [model]",
            )
    } else {
        let message = format!(
            "particles {} and {} overlap{edge} by {share} of the smaller radius",
            i + 1,
            j + 1
        );
        Problem::new(message, place)
            .expected(format!("centre of particle {}", j + 1))
            .also(
                draft.particles[i].place,
                format!("centre of particle {}", i + 1),
            )
            .remedy(
                "move them apart or make them smaller: up to 5 % is accepted; or write \
                     overlap = \"allow\" in [model]",
            )
    };
    draft.report.add(problem);
    !draft.report.is_full()
}

fn per_cent(fraction: f64) -> String {
    let digits = format!("{:.6}", 100.0 * fraction);
    let digits = digits.trim_end_matches('0').trim_end_matches('.');
    format!("{digits} %")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::setup::{BoundarySetup, ParticleSetup};
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
        found_in(None, particles)
    }

    fn found_in(boundary: Option<BoundarySetup>, particles: Vec<ParticleSetup>) -> usize {
        let report = Report::new(Vec::new());
        let mut draft = Draft::new(&report);
        let mark = Mark {
            place: Place::new(0, 0..0),
            sound: true,
        };
        draft.particles = vec![mark; particles.len()];
        draft.setup.particles = particles;
        draft.setup.boundary = boundary;
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

    /// Points that fill a square evenly.
    fn halton(mut i: usize, base: usize) -> f64 {
        let (mut f, mut r) = (1.0, 0.0);
        while i > 0 {
            f /= base as f64;
            r += f * (i % base) as f64;
            i /= base;
        }
        r
    }

    #[test]
    fn the_grid_finds_what_brute_force_finds() {
        // Sizes over three decades.
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
    fn images_across_the_edges_of_a_cell_are_seen() {
        // Particles that have strayed from a leaning cell by up to two of its edges.
        let (corner, edges) = ([-0.1, 0.2], [[1.0, 0.1], [0.4, 0.8]]);
        let particles: Vec<ParticleSetup> = (1..150)
            .map(|i| {
                let at = [4.0 * halton(i, 2) - 2.0, 4.0 * halton(i, 3) - 2.0];
                particle(at, libm::pow(10.0, -0.9 - 1.5 * halton(i, 5)))
            })
            .collect();
        // All images of all pairs, each pair from its first particle.
        let mut expected = [0; 2];
        for (i, p) in particles.iter().enumerate() {
            for (j, q) in particles.iter().enumerate().skip(i) {
                for n in -9..=9i32 {
                    for m in -9..=9i32 {
                        if i == j && (n, m) <= (0, 0) {
                            continue;
                        }
                        let shift =
                            [0, 1].map(|k| f64::from(n) * edges[0][k] + f64::from(m) * edges[1][k]);
                        let d = [0, 1].map(|k| q.at[k] + shift[k] - p.at[k]);
                        let overlap = p.radius + q.radius - libm::hypot(d[0], d[1]);
                        let counts = overlap > (ACCEPTED + SLACK) * p.radius.min(q.radius);
                        expected[usize::from((n, m) != (0, 0))] += usize::from(counts);
                    }
                }
            }
        }
        assert!(expected[0] > 3 && expected[1] > 50, "{expected:?}");
        let boundary = BoundarySetup::Cell { corner, edges };
        assert_eq!(
            found_in(Some(boundary), particles.clone()),
            expected[0] + expected[1]
        );
        assert_eq!(found(particles), expected[0]);
    }

    #[test]
    fn a_particle_wider_than_its_cell_meets_itself() {
        let cell = |width: f64| BoundarySetup::Cell {
            corner: [0.0; 2],
            edges: [[width, 0.0], [0.0, 5.0]],
        };
        let one = || vec![particle([0.3, 0.3], 1.0)];
        assert_eq!(found_in(Some(cell(1.96)), one()), 0);
        assert_eq!(found_in(Some(cell(1.94)), one()), 1);
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

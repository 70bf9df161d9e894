//! Where particles are for whoever looks for overlaps: in a periodic cell also across its edges.

use crate::engine::boundary::cell::Cell;
use crate::engine::setup::{BoundarySetup, ParticleSetup};
use crate::scene::draft::Draft;

/// Images are looked for as many cells away at most. Particles that reach farther overlap their own
/// images, which are nearer.
const FAR: i32 = 2;

/// A particle, or its image across an edge of the cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Body {
    /// Place of the particle in the list.
    pub(super) of: usize,
    /// Its centre [m], for a particle of a periodic cell in the cell itself.
    pub(super) at: [f64; 2],
    /// How many edges it is shifted by from there.
    image: [i32; 2],
    /// How many edges the particle has strayed from the cell.
    strayed: [i32; 2],
}

/// Each of these particles, and in a periodic cell the images that others can touch.
pub(super) fn bodies(draft: &Draft<'_>, sound: &[usize]) -> Vec<Body> {
    let particles = &draft.setup.particles;
    let here = |&of: &usize| Body {
        of,
        at: particles[of].at,
        image: [0; 2],
        strayed: [0; 2],
    };
    let mut bodies: Vec<Body> = sound.iter().map(here).collect();
    if let Some(BoundarySetup::Cell { corner, edges }) = draft.setup.boundary {
        lay(&Cell { corner, edges }, particles, &mut bodies);
    }
    bodies
}

/// Takes particles home and lays the images around the cell behind them.
fn lay(cell: &Cell, particles: &[ParticleSetup], bodies: &mut Vec<Body>) {
    let radius = |body: &Body| particles[body.of].radius;
    let largest = bodies.iter().map(radius).fold(0.0, f64::max);
    let widths = cell.widths();
    for k in 0..bodies.len() {
        let body = &mut bodies[k];
        body.strayed = cell.image(body.at).map(i32::from);
        body.at = cell.home(body.at);
        let own = *body;
        let fractions = cell.fractions(own.at);
        let reach = [0, 1].map(|k| (radius(&own) + largest) / widths[k]);
        let near = |k: usize, n: i32| {
            let there = fractions[k] + f64::from(n);
            -reach[k] <= there && there <= 1.0 + reach[k]
        };
        let shifts = |k: usize| (-FAR..=FAR).filter(move |&n| near(k, n));
        for n in shifts(0) {
            for m in shifts(1).filter(|m| [n, *m] != [0; 2]) {
                let shift = cell.shift([n as i16, m as i16]);
                bodies.push(Body {
                    at: [own.at[0] + shift[0], own.at[1] + shift[1]],
                    image: [n, m],
                    ..own
                });
            }
        }
    }
}

/// A pair of a particle and another, or an image of another or of its own.
pub(super) struct Pair {
    /// Their places in the list, ascending.
    pub(super) of: [usize; 2],
    /// Whether they meet across an edge of the cell.
    pub(super) across: bool,
}

/// The pair that two bodies are, if it is not the image of another pair.
pub(super) fn pair(a: &Body, b: &Body) -> Option<Pair> {
    let (first, second) = if (a.of, a.image != [0; 2]) <= (b.of, b.image != [0; 2]) {
        (a, b)
    } else {
        (b, a)
    };
    let own = first.of == second.of;
    if first.image != [0; 2] || (own && second.image < [0; 2]) {
        return None;
    }
    let apart = |k: usize| second.image[k] - second.strayed[k] + first.strayed[k];
    Some(Pair {
        of: [first.of, second.of],
        across: [apart(0), apart(1)] != [0; 2],
    })
}

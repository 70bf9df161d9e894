//! Where particles are for whoever looks for overlaps: in a periodic cell also across its edges.

use crate::engine::boundary::cell::{Cell, HERE, Image};
use crate::engine::setup::{BoundarySetup, ParticleSetup};
use crate::scene::draft::Draft;

/// Images are looked for as many cells away at most. Particles that reach farther overlap their own
/// images, which are nearer.
const FAR: i16 = 2;

/// A particle, or its image across an edge of the cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Body {
    /// Place of the particle in the list.
    pub(super) of: usize,
    /// Its centre [m], for a particle of a periodic cell in the cell itself.
    pub(super) at: [f64; 2],
    /// How many edges it is shifted by from there.
    image: Image,
    /// How many edges the particle has strayed from the cell.
    strayed: Image,
}

/// Each of these particles, and in a periodic cell the images that others can touch.
pub(super) fn bodies(draft: &Draft<'_>, sound: &[usize]) -> Vec<Body> {
    let particles = &draft.setup.particles;
    let here = |&of: &usize| Body {
        of,
        at: particles[of].at,
        image: HERE,
        strayed: HERE,
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
        body.strayed = cell.image(body.at);
        body.at = cell.home(body.at);
        let own = *body;
        let fractions = cell.fractions(own.at);
        let reach = [0, 1].map(|k| (radius(&own) + largest) / widths[k]);
        let near = |k: usize, n: i16| {
            let there = fractions[k] + f64::from(n);
            -reach[k] <= there && there <= 1.0 + reach[k]
        };
        for (image, at) in cell.images(own.at, FAR) {
            if image != HERE && near(0, image[0]) && near(1, image[1]) {
                bodies.push(Body { at, image, ..own });
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
    let (first, second) = if (a.of, a.image != HERE) <= (b.of, b.image != HERE) {
        (a, b)
    } else {
        (b, a)
    };
    let own = first.of == second.of;
    if first.image != HERE || (own && second.image < HERE) {
        return None;
    }
    let apart = |k: usize| {
        let [there, back, on] = [second.image[k], second.strayed[k], first.strayed[k]];
        i32::from(there) - i32::from(back) + i32::from(on)
    };
    Some(Pair {
        of: [first.of, second.of],
        across: [apart(0), apart(1)] != [0; 2],
    })
}

//! A picture of a world at a cycle boundary: what screens and files draw. Immutable, and complete
//! in itself: whoever draws it needs no world.

use super::means::{Means, Sums};
use super::sight::{Sieve, Sight};
use super::strongest::Strongest;
use crate::engine::World;
use crate::engine::boundary::cell::Cell;
use crate::engine::contact_report::Other;
use crate::engine::neighbours::Status;

/// A disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Number.
    pub id: u32,
    /// Centre [m].
    pub at: [f64; 2],
    /// Radius [m].
    pub radius: f64,
    /// Velocity [m/s]; NaN in a picture of a world whose forces are not summed.
    pub velocity: [f64; 2],
    /// Spin [rad/s]; NaN there too.
    pub spin: f64,
    /// Angle [rad].
    pub angle: f64,
    /// Index of the material.
    pub material: u16,
    /// Whether its motion is prescribed.
    pub driven: bool,
}

impl Disc {
    /// Magnitude of its velocity [m/s].
    pub fn speed(&self) -> f64 {
        squared(self.velocity).sqrt()
    }

    /// That of particle p. How fast it is nobody knows before forces are summed.
    fn of(world: &World, p: usize) -> Self {
        let particles = world.particles();
        let (velocity, spin) = if world.is_settled() {
            world.velocity(p)
        } else {
            ([f64::NAN; 2], f64::NAN)
        };
        let row = &particles.row[p];
        Self {
            id: particles.id[p],
            at: home(world, world.position(p)),
            radius: row.radius,
            velocity,
            spin,
            angle: row.angle,
            material: particles.material[p],
            driven: particles.is_driven(p),
        }
    }
}

/// A touching contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Ends of the branch: the two centres, or centre and foot on the wall [m].
    pub ends: [[f64; 2]; 2],
    /// Radii summed, or the radius at a wall: length of the force bar [m].
    pub length: f64,
    /// Unit vector from the first body to the second.
    pub normal: [f64; 2],
    /// Normal force [N].
    pub n: f64,
    /// Tangential force [N].
    pub t: f64,
    /// Whether it slides.
    pub sliding: bool,
    /// Number of the first particle.
    pub first: u32,
    /// Number of the second, or `None` at a wall.
    pub second: Option<u32>,
    /// Place of the wall in [`Picture::walls`].
    pub wall: Option<usize>,
}

impl Touch {
    /// That of contact k.
    fn of(world: &World, k: usize) -> Self {
        let particles = world.particles();
        let g = world.geometry(k);
        let reaction = world.reaction_along(k, g.e);
        let (first, second, wall) = match world.bodies(k) {
            (i, Other::Particle(j)) => (i, Some(j), None),
            (i, Other::Wall(w)) => (i, None, Some(w)),
        };
        let from = home(world, world.position(first));
        let to = [0, 1].map(|axis| from[axis] + g.distance * g.e[axis]);
        let reach = second.map_or(0.0, |j| particles.row[j].radius);
        Self {
            ends: [from, to],
            length: particles.row[first].radius + reach,
            normal: g.e,
            n: reaction.normal,
            t: reaction.tangential,
            sliding: reaction.sliding,
            first: particles.id[first],
            second: second.map(|j| particles.id[j]),
            wall,
        }
    }

    /// Middle of the force bar, and half of its length [m].
    pub fn bar(&self) -> ([f64; 2], f64) {
        let [from, to] = self.ends;
        let middle = [0, 1].map(|k| 0.5 * (from[k] + to[k]));
        (middle, 0.5 * self.length)
    }

    /// Magnitude of the contact force [N].
    pub fn force(&self) -> f64 {
        (self.n * self.n + self.t * self.t).sqrt()
    }

    /// Unit vector along the contact force, as Strack & Cundall drew it; the normal where there is none.
    pub fn along(&self) -> [f64; 2] {
        let (e, size) = (self.normal, self.force());
        if size > 0.0 {
            let [n, t] = [self.n / size, self.t / size];
            [n * e[0] + t * e[1], n * e[1] - t * e[0]]
        } else {
            e
        }
    }
}

/// A wall as far as it can be drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Name.
    pub name: String,
    /// Ends [m]; infinite ones are cut where the scene ends.
    pub ends: [[f64; 2]; 2],
}

/// The assembly.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Picture {
    /// Discs in ascending number.
    pub discs: Vec<Disc>,
    /// Touching contacts in list order.
    pub touches: Vec<Touch>,
    /// Walls.
    pub walls: Vec<Stroke>,
    /// Lower and upper corner of everything drawn [m].
    pub bounds: [[f64; 2]; 2],
    /// Box around all discs [m] where some of them are left out: more than can be seen.
    pub whole: Option<[[f64; 2]; 2]>,
    /// Means over all discs and contacts, also those that are left out.
    pub means: Means,
    /// Largest speed of a disc, also of those that are left out: then that of the last half step [m/s].
    pub fastest: f64,
}

/// So many particles are drawn whatever is seen of them.
const FEW: usize = 20_000;

impl Picture {
    /// Draws a world whose forces are summed.
    pub fn of(world: &World) -> Self {
        let mut picture = Self {
            bounds: bounds(world, around_discs(world)),
            ..Self::default()
        };
        let count = world.particles().len();
        picture.discs = (0..count).map(|p| Disc::of(world, p)).collect();
        let list = world.contacts();
        let touching = (0..list.len()).filter(|&k| list.status[k] != Status::Apart);
        picture.touches = touching.map(|k| Touch::of(world, k)).collect();
        picture.means = Means::of(&picture.discs, &picture.touches);
        let speeds = picture.discs.iter().map(Disc::speed);
        picture.fastest = speeds.filter(|v| v.is_finite()).fold(0.0, f64::max);
        picture.draw_walls(world);
        picture
    }

    /// Whether what is seen of a world is only part of it.
    pub fn is_of_part(world: &World) -> bool {
        world.particles().len() > FEW
    }

    /// The same, but of a large world only what can be seen of it, and the particle of the number
    /// `selected` with its contacts wherever it is.
    pub fn seen(world: &World, sight: Option<&Sight>, selected: Option<u32>) -> Self {
        let particles = world.particles();
        if !Self::is_of_part(world) {
            return Self::of(world);
        }
        let mut picture = Self::default();
        let sight = match sight {
            Some(sight) => sight.wider(),
            None => Sight::whole(bounds(world, around_discs(world))),
        };
        let mut sieve = Sieve::new(&sight);
        let mut sums = Sums::default();
        let mut whole = NOTHING;
        let chosen = selected.and_then(|id| particles.index(id));
        let at_home = Home::of(world);
        let flows = world.imposed_rate().is_some();
        let mut fastest = 0.0;
        for (p, row) in particles.row.iter().enumerate() {
            let (at, radius) = (at_home.of_inner(row.x), row.radius);
            take(&mut whole, at, radius);
            sums.add_disc(radius);
            let flow = if flows {
                world.flow_at(row.x)
            } else {
                [0.0; 2]
            };
            let speed = squared([row.v[0] + flow[0], row.v[1] + flow[1]]);
            fastest = if speed > fastest { speed } else { fastest };
            // One whose motion is prescribed looks otherwise.
            let most = 1 + u8::from(particles.is_driven(p));
            if sieve.passes(at, radius, most) || chosen == Some(p) {
                picture.discs.push(Disc::of(world, p));
            }
        }
        picture.whole = Some(whole);
        picture.fastest = fastest.sqrt();
        picture.bounds = bounds(world, whole);
        let mut strongest = Strongest::new(&sight);
        let list = world.contacts();
        for k in (0..list.len()).filter(|&k| list.status[k] != Status::Apart) {
            let touch = Touch::of(world, k);
            sums.add_contact(touch.force(), touch.t);
            let is_chosen = |id| Some(id) == selected;
            if is_chosen(touch.first) || touch.second.is_some_and(is_chosen) {
                strongest.choose(k);
            } else {
                strongest.look(k, touch.bar(), touch.force());
            }
        }
        let chosen = strongest.chosen();
        picture.touches = chosen.iter().map(|&k| Touch::of(world, k)).collect();
        picture.means = sums.means();
        picture.draw_walls(world);
        picture
    }

    fn draw_walls(&mut self, world: &World) {
        let [low, high] = self.bounds;
        let far = (high[0] - low[0]).max(high[1] - low[1]);
        for wall in world.walls() {
            let cut = |h: f64| h.clamp(-2.0 * far, 2.0 * far);
            let end = |h: f64| {
                [0, 1].map(|k| wall.point[k] + cut(h) * wall.direction[k] + world.origin()[k])
            };
            let ends = [end(wall.h1), end(wall.h2)];
            self.walls.push(Stroke {
                name: wall.name.clone(),
                ends,
            });
        }
        if let Some(cell) = world.cell() {
            let origin = world.origin();
            let corner = |n: i16, m: i16| {
                let shift = cell.shift([n, m]);
                [0, 1].map(|k| cell.corner[k] + shift[k] + origin[k])
            };
            let corners = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
            for k in 0..4 {
                self.walls.push(Stroke {
                    name: "cell".into(),
                    ends: [corners[k], corners[(k + 1) % 4]],
                });
            }
        }
    }
}

/// Where a particle at x is drawn [m]: one that has left a periodic cell, where it came in again.
pub(super) fn home(world: &World, x: [f64; 2]) -> [f64; 2] {
    let origin = world.origin();
    match world.cell() {
        None => x,
        Some(_) => Home::of(world).of_inner([x[0] - origin[0], x[1] - origin[1]]),
    }
}

/// The same for many particles.
struct Home<'a> {
    origin: [f64; 2],
    cell: Option<&'a Cell>,
}

impl<'a> Home<'a> {
    fn of(world: &'a World) -> Self {
        Self {
            origin: world.origin(),
            cell: world.cell(),
        }
    }

    /// Of a place relative to the origin of the world [m].
    fn of_inner(&self, x: [f64; 2]) -> [f64; 2] {
        let x = self.cell.map_or(x, |cell| cell.home(x));
        [x[0] + self.origin[0], x[1] + self.origin[1]]
    }
}

fn squared(v: [f64; 2]) -> f64 {
    v[0] * v[0] + v[1] * v[1]
}

/// The box that a box is before it takes anything [m].
const NOTHING: [[f64; 2]; 2] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];

/// Makes a box so large that it holds what reaches so far around a point [m].
fn take([low, high]: &mut [[f64; 2]; 2], x: [f64; 2], reach: f64) {
    for k in 0..2 {
        // Asked in this order because hardly anything is at the rim of a crowd.
        let (below, above) = (x[k] - reach, x[k] + reach);
        if below < low[k] && x[k].is_finite() {
            low[k] = below;
        }
        if above > high[k] && x[k].is_finite() {
            high[k] = above;
        }
    }
}

/// Box around all discs [m].
fn around_discs(world: &World) -> [[f64; 2]; 2] {
    let mut found = NOTHING;
    for p in 0..world.particles().len() {
        take(
            &mut found,
            world.position(p),
            world.particles().row[p].radius,
        );
    }
    found
}

/// Box around all discs, which is known, or the cell, and the finite ends of walls [m].
fn bounds(world: &World, discs: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let mut found = discs;
    if let Some(cell) = world.cell() {
        found = NOTHING;
        for image in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            let shift = cell.shift(image);
            let corner = [0, 1].map(|k| cell.corner[k] + shift[k] + world.origin()[k]);
            take(&mut found, corner, 0.0);
        }
    }
    for wall in world
        .walls()
        .iter()
        .filter(|wall| (wall.h2 - wall.h1).is_finite())
    {
        for end in 0..2 {
            let x = wall.end(end);
            let x = [x[0] + world.origin()[0], x[1] + world.origin()[1]];
            take(&mut found, x, 0.0);
        }
    }
    let [low, high] = found;
    if low[0] > high[0] || low[1] > high[1] {
        [[0.0; 2], [1.0; 2]]
    } else {
        [low, high]
    }
}

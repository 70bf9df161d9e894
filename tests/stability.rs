//! The largest stable step: of whole scenes, against closed forms, and of the bound the engine
//! reports.
//!
//! Every scene is preloaded (overlap 1e-3 of the radius, so that nothing separates) and has a
//! friction coefficient of 1e3 (so that nothing slips): the contacts are linear springs throughout.

mod common;

use ballast::engine::World;
use ballast::engine::setup::{Body, Dashpot, ParticleSetup, Setup};
use common::*;
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;

/// Overlap of every contact, in radii.
const PRELOAD: f64 = 1e-3;

/// Size of the perturbation, in overlaps.
const PERTURBATION: f64 = 1e-9;

/// Stiffness ratio and limit in sqrt(m/k_n).
type Entry = (f64, f64);

/// Bloch analysis of the endless lattices, in sqrt(m/k_n): k_s/k_n = 0, 2/3, 1. Where the rotation
/// mode decides (k_s > 0) it is 2 sqrt(I/(2 z k_s R²)).
const SQUARE_DISC: [Entry; 3] = [(0.0, 1.0), (2.0 / 3.0, 0.612_372), (1.0, 0.5)];
const SQUARE_SPHERE: [Entry; 3] = [(0.0, 1.0), (2.0 / 3.0, 0.547_723), (1.0, 0.447_214)];
const HEXAGONAL_DISC: [Entry; 3] = [(0.0, 0.816_497), (2.0 / 3.0, 0.5), (1.0, 0.408_248)];
const HEXAGONAL_SPHERE: [Entry; 3] = [(0.0, 0.816_497), (2.0 / 3.0, 0.447_214), (1.0, 0.365_148)];

/// A preloaded scene in equilibrium, and how far a perturbed copy gets from it.
struct Perturbed {
    world: World,
    rest: Vec<[f64; 2]>,
    size: f64,
}

impl Perturbed {
    /// Every free particle is moved by the perturbation, in some direction.
    fn new(mut setup: Setup) -> Self {
        let rest = setup.particles.iter().map(|p| p.at).collect();
        let radius = setup.particles[0].radius;
        let size = PERTURBATION * PRELOAD * radius;
        let mut random = Random(1);
        let free = |p: &&mut ParticleSetup| p.fixed != [true; 3];
        for particle in setup.particles.iter_mut().filter(free) {
            let angle = random.between(0.0, std::f64::consts::TAU);
            particle.at[0] += size * angle.cos();
            particle.at[1] += size * angle.sin();
        }
        setup.ledger = false;
        Self {
            world: world(setup),
            rest,
            size,
        }
    }

    /// Largest displacement over the perturbation.
    fn growth(&self) -> f64 {
        let gaps: Vec<f64> = (0..self.rest.len())
            .map(|p| {
                let x = self.world.position(p);
                (x[0] - self.rest[p][0]).hypot(x[1] - self.rest[p][1])
            })
            .collect();
        range(&gaps)[1] / self.size
    }

    /// Most of it within so many cycles; stops at `enough`.
    fn most(&mut self, cycles: u64, enough: f64) -> f64 {
        let mut most = 0f64;
        for _ in 0..cycles {
            run(&mut self.world, 1);
            most = most.max(self.growth());
            if most >= enough {
                break;
            }
        }
        most
    }
}

/// One percent beyond the limit the perturbation explodes, one percent below it stays.
fn brackets(name: &str, setup: &Setup, frac: f64) {
    let with = |factor: f64| Setup {
        frac: factor * frac,
        ..setup.clone()
    };
    let grown = Perturbed::new(with(1.01)).most(200, 1e6);
    assert!(grown >= 1e6, "{name}: grew {grown:e} at 1.01 of {frac}");
    let kept = Perturbed::new(with(0.99)).most(2000, 10.0);
    assert!(kept < 10.0, "{name}: grew {kept:e} at 0.99 of {frac}");
    assert!(kept > 0.5, "{name}: nothing moved");
}

fn check_lattices(name: &str, body: Body, table: [Entry; 3], build: impl Fn(f64) -> Setup) {
    for (ratio, limit) in table {
        let name = format!("{name}, k_s/k_n = {ratio}");
        let mut setup = build(ratio);
        setup.body = body;
        // The base step is 2 sqrt(m/k_n).
        let frac = 0.5 * limit;
        brackets(&name, &setup, frac);
        let world = world(setup);
        let real = undamped_limit(&world);
        assert!((real / frac - 1.0).abs() < 5e-3, "{name}: {real} {frac}");
        let bound = world.frac_limit();
        // The power iteration comes from the side of larger limits.
        assert!(bound < real * (1.0 + 1e-9), "{name}: {bound} {real}");
        assert!(bound > 0.5 * real, "{name}: {bound} {real}");
    }
}

#[test]
fn nine_discs() {
    for (ratio, frac) in [(1.0, 0.267_09), (2.0 / 3.0, 0.327_01)] {
        let setup = square_lattice(material(1e6, ratio * 1e6, 1e3), 3, PRELOAD);
        brackets("nine discs", &setup, frac);
        let world = world(setup);
        let real = undamped_limit(&world);
        // Five digits are given; the preload shortens the lever arms by 5e-4 of themselves.
        assert!((real / frac - 1.0).abs() < 1.5e-3, "{ratio}: {real}");
        let bound = world.frac_limit();
        assert!(bound < real && bound > 0.5 * real, "{bound} {real}");
    }
}

#[test]
fn square_lattices_in_a_box() {
    let build = |ratio: f64| square_lattice(material(1e6, ratio * 1e6, 1e3), 20, PRELOAD);
    check_lattices("square discs", Body::Disc, SQUARE_DISC, build);
    check_lattices("square spheres", Body::Sphere, SQUARE_SPHERE, build);
}

#[test]
fn hexagonal_patches_in_a_driven_ring() {
    let build = |ratio: f64| hexagonal_patch(material(1e6, ratio * 1e6, 1e3), 12, PRELOAD);
    check_lattices("hexagonal discs", Body::Disc, HEXAGONAL_DISC, build);
    check_lattices("hexagonal spheres", Body::Sphere, HEXAGONAL_SPHERE, build);
}

/// One spring of the stiffness matrix: stiffness and viscosity times the square of b·u, u in
/// coordinates times the root of mass.
struct Spring {
    b: Vec<(usize, f64)>,
    stiffness: f64,
    viscosity: f64,
}

/// All springs of a scene, from positions and materials alone.
fn springs(world: &World) -> Vec<Spring> {
    let particles = world.particles();
    let material = &world.model().materials[0];
    let k_n = material.normal_stiffness.expect("linear law");
    let shears = material.friction > 0.0;
    let k_s = material.shear_stiffness.filter(|_| shears).unwrap_or(0.0);
    let fraction = match world.model().damping.contact {
        Dashpot::Fraction(fraction) => fraction,
        _ => 0.0,
    };
    let mut all = Vec::new();
    let mut touch = |i: usize, j: Option<usize>, e: [f64; 2], arms: [f64; 2]| {
        let inverse = |p: usize| {
            if particles.fixed[p] == [true; 3] {
                0.0
            } else {
                1.0 / particles.mass[p]
            }
        };
        let sum = inverse(i) + j.map_or(0.0, inverse);
        if sum == 0.0 {
            return;
        }
        let mut add = |k: f64, parts: [[f64; 3]; 2]| {
            let mut b = Vec::new();
            for (p, part) in [(Some(i), parts[0]), (j, parts[1])] {
                let Some(p) = p else { continue };
                let inertia = [particles.mass[p], particles.mass[p], particles.inertia[p]];
                for axis in (0..3).filter(|&axis| !particles.fixed[p][axis]) {
                    b.push((3 * p + axis, part[axis] / inertia[axis].sqrt()));
                }
            }
            all.push(Spring {
                b,
                stiffness: k,
                viscosity: 2.0 * fraction * (k / sum).sqrt(),
            });
        };
        add(k_n, [[e[0], e[1], 0.0], [-e[0], -e[1], 0.0]]);
        add(k_s, [[e[1], -e[0], -arms[0]], [-e[1], e[0], -arms[1]]]);
    };
    for i in 0..particles.len() {
        let a = particles.row[i];
        for j in i + 1..particles.len() {
            let b = particles.row[j];
            let d = [b.x[0] - a.x[0], b.x[1] - a.x[1]];
            let (distance, reach) = (d[0].hypot(d[1]), a.radius + b.radius);
            if distance < reach {
                let share = distance / reach;
                let e = [d[0] / distance, d[1] / distance];
                touch(i, Some(j), e, [a.radius * share, b.radius * share]);
            }
        }
        for wall in world.walls() {
            let r = [a.x[0] - wall.point[0], a.x[1] - wall.point[1]];
            let height = r[1] * wall.direction[0] - r[0] * wall.direction[1];
            if height.abs() < a.radius {
                let away = [-wall.direction[1], wall.direction[0]];
                touch(i, None, away.map(|x| -x * height.signum()), [a.radius, 0.0]);
            }
        }
    }
    all
}

/// Largest stable FRAC without dashpots, 2/ω of the fastest mode by power iteration.
fn undamped_limit(world: &World) -> f64 {
    let springs = springs(world);
    let mut random = Random(2);
    let mut u: Vec<f64> = (0..3 * world.particles().len())
        .map(|_| random.between(-1.0, 1.0))
        .collect();
    let mut square = 0.0;
    for _ in 0..3000 {
        let mut next = vec![0.0; u.len()];
        for spring in &springs {
            let stretch: f64 = spring.b.iter().map(|&(k, b)| b * u[k]).sum();
            for &(k, b) in &spring.b {
                next[k] += spring.stiffness * stretch * b;
            }
        }
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        square = dot(&u, &next) / dot(&u, &u);
        let norm = dot(&next, &next).sqrt();
        u = next.into_iter().map(|x| x / norm).collect();
    }
    2.0 / square.sqrt() / world.base_step()
}

/// Largest FRAC for which 4 M - 2 dt C - dt² K has no negative eigenvalue: where the leapfrog with
/// lagged dashpots turns unstable.
fn assembled_limit(world: &World) -> f64 {
    let n = 3 * world.particles().len();
    let (mut k, mut c) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    let mut damped = false;
    for spring in springs(world) {
        let mut b = DVector::zeros(n);
        for (row, part) in spring.b {
            b[row] = part;
        }
        k.ger(spring.stiffness, &b, &b, 1.0);
        c.ger(spring.viscosity, &b, &b, 1.0);
        damped |= spring.viscosity > 0.0;
    }
    if !damped {
        return 2.0 / k.symmetric_eigenvalues().max().sqrt() / world.base_step();
    }
    let (mut low, mut high) = (0.0, 2.0 * world.base_step());
    for _ in 0..24 {
        let middle = 0.5 * (low + high);
        let sum = &k * (middle * middle) + &c * (2.0 * middle);
        if sum.symmetric_eigenvalues().max() <= 4.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low / world.base_step()
}

/// A jittered lattice of 36 particles of radii up to 1 : 4, in a box, some driven, many overlapping.
fn network(seed: u64, friction: f64, ratio: f64, dashpot: f64, body: Body) -> Setup {
    let mut random = Random(seed);
    let mut setup = scene(material(1e6, ratio * 1e6, friction));
    setup.body = body;
    setup.damping = contact_damping(dashpot);
    for row in 0..6 {
        for column in 0..6 {
            let x = f64::from(column) + random.between(-0.2, 0.2);
            let y = f64::from(row) + random.between(-0.2, 0.2);
            let radius = random.between(0.2, 0.8);
            setup.particles.push(if random.next() < 0.1 {
                driven(x, y, radius, [0.0; 2], 0.0)
            } else {
                particle(x, y, radius)
            });
        }
    }
    setup.walls = closing_walls([-0.5; 2], [5.5; 2], 0.0);
    setup
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_bound_holds_for_random_networks(
        seed in any::<u64>(),
        ratio in 0.0..1.0f64,
        dashpot in prop::sample::select(vec![0.0, 0.0, 0.1, 0.5, 1.0]),
        friction in prop::sample::select(vec![0.0, 0.3, 1e3]),
        sphere in any::<bool>(),
    ) {
        let body = if sphere { Body::Sphere } else { Body::Disc };
        let world = world(network(seed, friction, ratio, dashpot, body));
        let limit = assembled_limit(&world);
        let bound = world.frac_limit();
        prop_assert!(limit.is_finite());
        // Rounding of eigenvalues, and the bisection to 2^-24 with dashpots.
        prop_assert!(bound <= limit * (1.0 + 1e-6), "bound {bound}, limit {limit}");
        // As derived where the bound is worked out.
        let worst = if dashpot == 0.0 { 0.5f64.sqrt() } else { 1.0 / (1.0 + 3f64.sqrt()) };
        prop_assert!(bound >= worst * limit * (1.0 - 1e-6), "bound {bound}, limit {limit}");
        // Particles that cannot decide are left out on the way: to the bit it is the least of all.
        let each = (0..world.particles().len()).map(|p| world.stable_step_of(p));
        prop_assert_eq!(world.stable_step(), each.fold(f64::INFINITY, f64::min));
    }
}

#[test]
fn dashpots_tighten_the_limit() {
    // Nine discs again: what the assembled matrices say is what the engine does, dashpots included.
    let build = |dashpot: f64| {
        let mut setup = square_lattice(material(1e6, 1e6, 1e3), 3, PRELOAD);
        setup.damping = contact_damping(dashpot);
        setup
    };
    let free = assembled_limit(&world(build(0.0)));
    assert!((undamped_limit(&world(build(0.0))) / free - 1.0).abs() < 1e-9);
    assert!((free / 0.267_09 - 1.0).abs() < 1.5e-3, "{free}");
    let damped = build(0.5);
    let limit = assembled_limit(&world(damped.clone()));
    assert!(limit < 0.6 * free, "{limit}");
    let with = |factor: f64| Setup {
        frac: factor * limit,
        ..damped.clone()
    };
    assert!(Perturbed::new(with(1.02)).most(2000, 1e6) >= 1e6);
    assert!(Perturbed::new(with(0.98)).most(2000, 10.0) < 10.0);
}

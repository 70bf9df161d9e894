//! Assemblies the measures are checked on: linear springs, so that an overlap is a force.

use ballast::engine::World;
use ballast::engine::setup::*;
use ballast::measure::fabric::Fabric;
use ballast::measure::region::{Content, Shape};
use ballast::measure::stress::Stress;

/// Normal and shear stiffness [N/m].
pub(crate) const K: f64 = 1e6;

/// A centre [m] and a radius [m].
pub(crate) type Disc = ([f64; 2], f64);

/// Everything that is measured over a region.
pub(crate) struct Measured {
    pub(crate) content: Content,
    pub(crate) stress: Stress,
    pub(crate) fabric: Fabric,
}

/// Measures a region.
pub(crate) fn measured(world: &World, shape: Shape) -> Measured {
    let content = Content::of(world, shape);
    Measured {
        stress: Stress::of(world, &content),
        fabric: Fabric::of(world, &content),
        content,
    }
}

/// Discs that touch without friction, damping or gravity.
pub(crate) fn setup(discs: &[Disc]) -> Setup {
    let particle = |&(at, radius): &Disc| ParticleSetup {
        at,
        radius,
        material: 0,
        velocity: [0.0; 2],
        spin: 0.0,
        angle: 0.0,
        force: [0.0; 2],
        fixed: [false; 3],
    };
    Setup {
        body: Body::Disc,
        law: LawChoice::linear(),
        normal: NormalForm::Total,
        unloading: Unloading::Rescale,
        nodes: 16,
        time_step: TimeStepChoice::Critical,
        frac: 0.1,
        frac_auto: None,
        rotation: true,
        gravity: None,
        damping: Damping::default(),
        materials: vec![Material {
            name: "m".into(),
            density: 1000.0,
            young: None,
            poisson: None,
            friction: 0.0,
            cohesion: 0.0,
            bond_tension: 0.0,
            bond_shear: 0.0,
            normal_stiffness: Some(K),
            shear_stiffness: Some(K),
            rolling_friction: 0.0,
            rigid: false,
        }],
        pairs: vec![],
        particles: discs.iter().map(particle).collect(),
        walls: vec![],
        tol: None,
        boundary: None,
        strain_rate: [[0.0; 2]; 2],
        fracc_every: 1,
        overlap_allowed: true,
        ledger: false,
    }
}

/// The world of a setup with its first forces summed.
pub(crate) fn built(setup: Setup) -> World {
    let mut world = World::build(setup, 1).expect("the assembly is sound");
    world.settle();
    world
}

/// A wall from one point to another.
pub(crate) fn wall(name: &str, from: [f64; 2], to: [f64; 2]) -> WallSetup {
    let d = [to[0] - from[0], to[1] - from[1]];
    let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
    WallSetup {
        name: name.into(),
        material: 0,
        point: from,
        direction: d.map(|component| component / length),
        h1: 0.0,
        h2: length,
        velocity: [0.0; 2],
        angular_velocity: 0.0,
        about: from,
    }
}

/// Left, right, bottom and top wall of a box.
pub(crate) fn box_of(min: [f64; 2], max: [f64; 2]) -> Vec<WallSetup> {
    vec![
        wall("left", min, [min[0], max[1]]),
        wall("right", [max[0], min[1]], max),
        wall("bottom", min, [max[0], min[1]]),
        wall("top", [min[0], max[1]], max),
    ]
}

/// Unit discs at whole multiples of two vectors, within a distance of the zero point.
pub(crate) fn lattice(a: [f64; 2], b: [f64; 2], within: f64) -> Vec<Disc> {
    let mut discs = Vec::new();
    for i in -40..=40_i32 {
        for j in -40..=40_i32 {
            let (i, j) = (f64::from(i), f64::from(j));
            let x = [i * a[0] + j * b[0], i * a[1] + j * b[1]];
            if x[0] * x[0] + x[1] * x[1] < within * within {
                discs.push((x, 1.0));
            }
        }
    }
    discs
}

/// A frictional assembly of discs of many sizes in a box, loosely placed and not yet touching: the
/// walls close in, top and bottom faster than the sides.
pub(crate) fn compressed(columns: u32, rows: u32) -> Setup {
    // A fixed sequence is as good as any random one.
    let mut state = 12345_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut discs = Vec::new();
    for i in 0..columns {
        for j in 0..rows {
            let radius = 0.6 + 0.4 * random();
            let loose = 1.0 - radius;
            let shift = [random(), random()].map(|share| loose * (2.0 * share - 1.0));
            let at = [f64::from(2 * i + 1), f64::from(2 * j + 1)];
            discs.push(([at[0] + shift[0], at[1] + shift[1]], radius));
        }
    }
    let mut setup = setup(&discs);
    setup.materials[0].friction = 0.5;
    setup.damping.contact = Dashpot::Fraction(0.3);
    setup.walls = box_of([0.0; 2], [f64::from(2 * columns), f64::from(2 * rows)]);
    for (wall, v) in setup
        .walls
        .iter_mut()
        .zip([[0.4, 0.0], [-0.4, 0.0], [0.0, 0.6], [0.0, -0.6]])
    {
        wall.velocity = v;
    }
    setup
}

/// Stops all walls, and particles too: about half of critical for the slowest swing of some ten discs,
/// sqrt(k/m) pi/10. Rattlers would otherwise fly from wall to wall for ever.
pub(crate) fn stop(world: &mut World) {
    let damping = Damping {
        global: 5.0,
        ..world.model().damping
    };
    world.set_damping(damping);
    for w in 0..world.walls().len() {
        world.set_wall_velocity(w, [0.0; 2]);
    }
}

/// Runs cycles and sums the forces.
pub(crate) fn run(world: &mut World, cycles: u32) {
    for _ in 0..cycles {
        world.cycle().expect("nothing runs away");
    }
    world.settle();
}

/// Whether two numbers differ by less than a share of a scale.
pub(crate) fn close(a: f64, b: f64, share: f64, scale: f64) -> bool {
    (a - b).abs() <= share * scale.abs()
}

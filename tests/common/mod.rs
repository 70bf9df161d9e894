//! Scenes for the tests of the engine, built without a preset.
#![allow(
    dead_code,
    reason = "every test binary uses its own part of these builders"
)]

use ballast::engine::World;
use ballast::engine::setup::{
    Body, Damping, Dashpot, LawChoice, Material, NormalForm, ParticleSetup, Setup, TimeStepChoice,
    Unloading, WallSetup,
};

/// Normal stiffness, density and radius of the discs of Cundall & Strack 1979.
pub(crate) const STIFFNESS: f64 = 1.35e9;
pub(crate) const DENSITY: f64 = 1000.0;
pub(crate) const RADIUS: f64 = 50.0;

/// A material of the linear law.
pub(crate) fn material(normal: f64, shear: f64, friction: f64) -> Material {
    Material {
        name: "disc".into(),
        density: DENSITY,
        // About as stiff as the springs at an overlap of 0.005 radii.
        young: Some(27.0 * normal),
        poisson: Some(0.3),
        friction,
        cohesion: 0.0,
        bond_tension: 0.0,
        bond_shear: 0.0,
        normal_stiffness: Some(normal),
        shear_stiffness: Some(shear),
        rolling_friction: 0.0,
        rigid: false,
    }
}

/// A scene of one material without particles and walls: undamped discs at a tenth of the critical
/// step, energies booked, any overlap accepted.
pub(crate) fn scene(material: Material) -> Setup {
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
        materials: vec![material],
        pairs: vec![],
        particles: vec![],
        walls: vec![],
        tol: None,
        boundary: None,
        strain_rate: [[0.0; 2]; 2],
        fracc_every: 1,
        overlap_allowed: true,
        ledger: true,
    }
}

/// A law of the list.
/// The same of spheres under a law with elastic constants, at a tenth of the Rayleigh step.
pub(crate) fn spheres(name: &str, material: Material) -> Setup {
    Setup {
        body: Body::Sphere,
        law: law(name),
        time_step: TimeStepChoice::Rayleigh,
        ..scene(material)
    }
}

pub(crate) fn law(name: &str) -> LawChoice {
    LawChoice::named(name).expect("it is in the list")
}

/// A free particle at rest.
pub(crate) fn particle(x: f64, y: f64, radius: f64) -> ParticleSetup {
    ParticleSetup {
        at: [x, y],
        radius,
        material: 0,
        velocity: [0.0; 2],
        spin: 0.0,
        angle: 0.0,
        force: [0.0; 2],
        fixed: [false; 3],
    }
}

/// The same, moving.
pub(crate) fn moving(x: f64, y: f64, radius: f64, velocity: [f64; 2], spin: f64) -> ParticleSetup {
    ParticleSetup {
        velocity,
        spin,
        ..particle(x, y, radius)
    }
}

/// The same, moving as told.
pub(crate) fn driven(x: f64, y: f64, radius: f64, velocity: [f64; 2], spin: f64) -> ParticleSetup {
    ParticleSetup {
        fixed: [true; 3],
        ..moving(x, y, radius, velocity, spin)
    }
}

/// A wall from one point to another, at rest.
pub(crate) fn wall(name: &str, from: [f64; 2], to: [f64; 2]) -> WallSetup {
    let d = [to[0] - from[0], to[1] - from[1]];
    let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
    WallSetup {
        name: name.into(),
        material: 0,
        point: from,
        direction: [d[0] / length, d[1] / length],
        h1: 0.0,
        h2: length,
        velocity: [0.0; 2],
        angular_velocity: 0.0,
        about: from,
    }
}

/// Four walls that close on the box from `low` to `high`, longer than its sides, at speed `v`.
pub(crate) fn closing_walls(low: [f64; 2], high: [f64; 2], v: f64) -> Vec<WallSetup> {
    let over = 0.25 * (high[0] - low[0]).min(high[1] - low[1]);
    let [x0, y0] = [low[0] - over, low[1] - over];
    let [x1, y1] = [high[0] + over, high[1] + over];
    let towards = |mut wall: WallSetup, velocity: [f64; 2]| {
        wall.velocity = velocity;
        wall
    };
    vec![
        towards(wall("bottom", [x0, low[1]], [x1, low[1]]), [0.0, v]),
        towards(wall("right", [high[0], y0], [high[0], y1]), [-v, 0.0]),
        towards(wall("top", [x1, high[1]], [x0, high[1]]), [0.0, -v]),
        towards(wall("left", [low[0], y1], [low[0], y0]), [v, 0.0]),
    ]
}

/// Nine discs just touching each other and four walls that close at speed `v`. Number 1 is at the
/// lower left, 2 right of it, 5 in the middle.
pub(crate) fn nine_discs(material: Material, frac: f64, v: f64) -> Setup {
    let mut setup = Setup {
        frac,
        ..scene(material)
    };
    for y in [-1.0, 0.0, 1.0] {
        for x in [-1.0, 0.0, 1.0] {
            let at = |c: f64| 2.0 * RADIUS * c;
            setup.particles.push(particle(at(x), at(y), RADIUS));
        }
    }
    setup.walls = closing_walls([-3.0 * RADIUS; 2], [3.0 * RADIUS; 2], v);
    setup
}

/// n times n particles of radius 1 in a box of walls at rest, every contact with this overlap.
pub(crate) fn square_lattice(material: Material, n: usize, overlap: f64) -> Setup {
    let mut setup = scene(material);
    let spacing = 2.0 - overlap;
    let half = 0.5 * spacing * (n as f64 - 1.0);
    for row in 0..n {
        for column in 0..n {
            let (x, y) = (column as f64 * spacing, row as f64 * spacing);
            setup.particles.push(particle(x - half, y - half, 1.0));
        }
    }
    let edge = half + 1.0 - overlap;
    setup.walls = closing_walls([-edge; 2], [edge; 2], 0.0);
    setup
}

/// A hexagon of `side` free particles of radius 1 per side in a ring of driven ones at rest, every
/// contact with this overlap.
pub(crate) fn hexagonal_patch(material: Material, side: i32, overlap: f64) -> Setup {
    let mut setup = scene(material);
    let spacing = 2.0 - overlap;
    let rise = 0.75f64.sqrt() * spacing;
    for row in -side..=side {
        for column in -side..=side {
            let ring = row.abs().max(column.abs()).max((row + column).abs());
            if ring > side {
                continue;
            }
            let x = (f64::from(column) + 0.5 * f64::from(row)) * spacing;
            let y = f64::from(row) * rise;
            setup.particles.push(if ring == side {
                driven(x, y, 1.0, [0.0; 2], 0.0)
            } else {
                particle(x, y, 1.0)
            });
        }
    }
    setup
}

/// Two unit discs side by side with this gap between them.
pub(crate) fn two_particles(material: Material, gap: f64) -> Setup {
    let mut setup = scene(material);
    let x = 1.0 + 0.5 * gap;
    setup.particles = vec![particle(-x, 0.0, 1.0), particle(x, 0.0, 1.0)];
    setup
}

/// One unit particle over an endless floor, its centre at height 1 + gap.
pub(crate) fn on_floor(material: Material, gap: f64) -> Setup {
    let mut setup = scene(material);
    setup.particles = vec![particle(0.0, 1.0 + gap, 1.0)];
    setup.walls = vec![floor()];
    setup
}

/// An endless floor through the origin, solid side up.
pub(crate) fn floor() -> WallSetup {
    WallSetup {
        h1: f64::NEG_INFINITY,
        h2: f64::INFINITY,
        ..wall("floor", [0.0, 0.0], [1.0, 0.0])
    }
}

/// A heap of touching discs of three sizes between two side walls on a floor: rows of a
/// triangular pile under gravity, friction low enough that it collapses.
pub(crate) fn collapsing_pile(rows: usize, friction: f64) -> Setup {
    let mut setup = scene(Material {
        density: 1.0 / std::f64::consts::PI,
        ..material(1e5, 1e5, friction)
    });
    setup.gravity = Some(ballast::engine::setup::Gravity::Uniform([0.0, -10.0]));
    setup.damping.contact = Dashpot::Fraction(0.2);
    for row in 0..rows {
        for column in 0..rows - row {
            let radius = [1.0, 0.9, 0.95][(row + 2 * column) % 3];
            let x = 2.0 * column as f64 + row as f64;
            setup
                .particles
                .push(particle(x, 1.0 + 1.74 * row as f64, radius));
        }
    }
    let width = 2.0 * rows as f64;
    setup.walls = vec![
        wall("floor", [-width, 0.0], [2.0 * width, 0.0]),
        wall("left", [-width, 4.0 * width], [-width, 0.0]),
        wall("right", [2.0 * width, 0.0], [2.0 * width, 4.0 * width]),
    ];
    setup
}

/// A damping of contacts only.
pub(crate) fn contact_damping(fraction: f64) -> Damping {
    Damping {
        contact: Dashpot::Fraction(fraction),
        ..Damping::default()
    }
}

/// The world of a setup, on one thread.
pub(crate) fn world(setup: Setup) -> World {
    World::build(setup, 1).expect("the scene builds")
}

/// Runs cycles that must not fail.
pub(crate) fn run(world: &mut World, cycles: u64) {
    for _ in 0..cycles {
        world.cycle().expect("no fault in this scene");
    }
}

/// Numbers that look random and are the same everywhere: SplitMix64.
#[derive(Debug, Clone)]
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Between 0 and 1.
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Between two bounds.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Largest and smallest of a series.
pub(crate) fn range(series: &[f64]) -> [f64; 2] {
    series
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &x| {
            [low.min(x), high.max(x)]
        })
}

/// Slope of ln y over ln x by least squares: the order of y(x).
pub(crate) fn order(points: &[[f64; 2]]) -> f64 {
    let logs: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::ln)).collect();
    let n = logs.len() as f64;
    let mean = [0, 1].map(|k| logs.iter().map(|p| p[k]).sum::<f64>() / n);
    let (mut over, mut under) = (0.0, 0.0);
    for p in &logs {
        over += (p[0] - mean[0]) * (p[1] - mean[1]);
        under += (p[0] - mean[0]) * (p[0] - mean[0]);
    }
    over / under
}

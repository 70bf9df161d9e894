//! The energy ledger: it closes, and every single booking in it is needed for that.

mod common;

use ballast::engine::World;
use ballast::engine::edit::Motion;
use ballast::engine::setup::{Damping, Dashpot, Gravity, Material, Setup, TimeStepChoice};
use common::*;

/// Entries of the balance: stored ones first, then losses, then work.
const ENTRIES: [&str; 10] = [
    "kinetic",
    "rotational",
    "elastic_normal",
    "elastic_tangential",
    "potential",
    "transit",
    "friction_loss",
    "damping_loss",
    "global_loss",
    "boundary_work",
];

/// All entries with the sign they have in the balance.
fn entries(world: &mut World) -> [f64; 10] {
    world.settle();
    let e = world.energies();
    let b = world.bookings().expect("energies are booked");
    [
        e.kinetic,
        e.rotational,
        e.elastic_normal,
        e.elastic_tangential,
        e.potential,
        e.transit,
        b.friction_loss,
        b.damping_loss,
        b.global_loss,
        -b.boundary_work,
    ]
}

/// Runs a scene and holds the balance against the sum of what went to and fro.
struct Balance {
    change: [f64; 10],
    turnover: f64,
    error: f64,
}

impl Balance {
    fn of(setup: Setup, time: f64, mut act: impl FnMut(&mut World)) -> Self {
        let mut world = world(setup);
        let before = entries(&mut world);
        let cycles = (time / world.dt()).round() as u64;
        run(&mut world, cycles / 2);
        act(&mut world);
        run(&mut world, cycles - cycles / 2);
        let after = entries(&mut world);
        let mut change = [0.0; 10];
        for k in 0..10 {
            change[k] = after[k] - before[k];
        }
        Self {
            change,
            turnover: change.iter().map(|x| x.abs()).sum(),
            error: world.bookings().expect("energies are booked").energy_error,
        }
    }

    /// What is missing when some entry is left out, over the turnover.
    fn without(&self, left_out: Option<usize>) -> f64 {
        let sum: f64 = (0..10)
            .filter(|&k| Some(k) != left_out)
            .map(|k| self.change[k])
            .sum();
        (sum / self.turnover).abs()
    }

    /// The balance closes to `within`, and fails by a factor 50 without any of the named entries.
    fn check(&self, scene: &str, within: f64, needed: &[&str]) {
        let full = self.without(None);
        assert!(full < within, "{scene}: off by {full:e}, {:?}", self.change);
        assert!(
            self.error.abs() < 10.0 * within,
            "{scene}: reported {:e}",
            self.error
        );
        for name in needed {
            let k = ENTRIES
                .iter()
                .position(|entry| entry == name)
                .expect("an entry");
            let off = self.without(Some(k));
            assert!(
                off > 50.0 * within,
                "{scene} closes without {name}: {off:e}, {:?}",
                self.change
            );
        }
    }
}

/// Unit discs of mass 1.
fn discs(friction: f64) -> Setup {
    scene(Material {
        density: 1.0 / std::f64::consts::PI,
        ..material(1e4, 0.8e4, friction)
    })
}

/// The same at a fine step.
fn fine(friction: f64) -> Setup {
    Setup {
        frac: 2e-3,
        ..discs(friction)
    }
}

#[test]
fn a_linear_ledger_closes_to_rounding() {
    // Head-on contacts of fixed direction: the trapezoid of a linear spring is exact, so what is
    // left is the random walk of rounding.
    let mut setup = square_lattice(
        Material {
            density: 1.0 / std::f64::consts::PI,
            ..material(1e4, 1e4, 0.0)
        },
        3,
        0.01,
    );
    for wall in &mut setup.walls {
        let inward = [-wall.direction[1], wall.direction[0]];
        wall.velocity = inward.map(|x| 0.05 * x);
    }
    let mut world = world(setup);
    run(&mut world, 40);
    for w in 0..4 {
        world.set_wall_velocity(w, [0.0; 2]);
    }
    let mut worst = 0f64;
    for _ in 0..200 {
        run(&mut world, 100);
        world.settle();
        let error = world.bookings().expect("booked").energy_error.abs();
        let bound = 1e-12 * (world.cycle_number() as f64).sqrt();
        assert!(error < bound, "cycle {}: {error:e}", world.cycle_number());
        worst = worst.max(error);
    }
    // Energy did flow to and fro.
    let e = world.energies();
    assert!(worst > 0.0 && e.kinetic > 1e-6 * e.elastic_normal);
    assert!(world.bookings().expect("booked").boundary_work > 0.01 * e.elastic_normal);
}

/// A box of discs that has everything: friction, dashpots, global damping, a wall that moves and
/// one that turns, a driven and a pushed particle, weight.
fn everything(steps: f64) -> Setup {
    let mut setup = discs(0.3);
    setup.gravity = Some(Gravity::Uniform([0.3, -2.0]));
    setup.damping = Damping {
        global: 0.2,
        ..contact_damping(0.1)
    };
    let mut random = Random(3);
    for row in 0..4 {
        for column in 0..4 {
            let x = 1.96 * f64::from(column) + random.between(-0.01, 0.01);
            let y = 1.96 * f64::from(row) + random.between(-0.01, 0.01);
            setup.particles.push(particle(x, y, 1.0));
        }
    }
    setup.particles[5] = driven(1.96, 1.96, 1.0, [0.05, 0.0], 0.2);
    setup.particles[10].force = [5.0, -3.0];
    setup.walls = closing_walls([-0.98; 2], [6.86; 2], 0.0);
    setup.walls[0].velocity = [0.0, 0.1];
    setup.walls[1].angular_velocity = 0.05;
    setup.time_step = TimeStepChoice::Seconds(1.0 / steps);
    setup.frac = 1.0;
    setup
}

#[test]
fn a_full_ledger_converges() {
    let errors = [4e3, 8e3, 16e3, 32e3, 64e3].map(|steps| {
        let mut world = world(everything(steps));
        // Over a while, so that a lucky zero does not count.
        let errors: Vec<f64> = (0..10)
            .map(|_| {
                run(&mut world, (0.1 * steps) as u64);
                world.settle();
                world.bookings().expect("booked").energy_error.abs()
            })
            .collect();
        [1.0 / steps, range(&errors)[1]]
    });
    let order = order(&errors);
    assert!(order > 0.9, "{order}: {errors:?}");
    assert!(errors[4][1] < 1e-5, "{errors:?}");
    let all = Balance::of(everything(16e3), 1.0, |_| ());
    for (k, name) in ENTRIES.iter().enumerate() {
        // The transit vanishes with the step; all others are there.
        assert!(*name == "transit" || all.change[k] != 0.0, "{name}");
    }
}

#[test]
fn springs_kinetic_energy_and_spin() {
    // Two discs that meet off centre and stick: undamped, nothing slips.
    let mut setup = fine(1e3);
    setup.particles = vec![
        moving(-1.1, 0.3, 1.0, [1.0, 0.0], 0.0),
        moving(1.1, -0.3, 1.0, [-1.0, 0.0], 0.0),
    ];
    setup.frac = 5e-4;
    // Stopped in the middle of the contact.
    let inside = Balance::of(setup.clone(), 0.16, |_| ());
    inside.check(
        "contact",
        3e-6,
        &[
            "kinetic",
            "rotational",
            "elastic_normal",
            "elastic_tangential",
        ],
    );
    // In the middle of a contact at a coarse step, the transit belongs to the balance.
    let mut coarse = nine_discs(material(STIFFNESS, STIFFNESS, 0.0), 0.1, 0.12);
    coarse
        .walls
        .iter_mut()
        .for_each(|wall| wall.velocity = wall.velocity.map(|v| 3.0 * v));
    let time = 57.0 * world(coarse.clone()).dt();
    Balance::of(coarse, time, |_| ()).check("coarse", 1e-10, &["transit", "boundary_work"]);
}

#[test]
fn losses_at_contacts() {
    // A disc that slides on a floor under its weight until it rolls.
    let mut sliding = fine(0.3);
    sliding.particles = vec![moving(0.0, 1.0 - 10.0 / 1e4, 1.0, [1.0, 0.0], 0.0)];
    sliding.gravity = Some(Gravity::Uniform([0.0, -10.0]));
    sliding.walls = vec![floor()];
    Balance::of(sliding, 0.05, |_| ()).check(
        "sliding",
        1e-5,
        &["friction_loss", "kinetic", "rotational"],
    );
    // An impact, with spin, with dashpots and friction: contact over at the end, the spring's last
    // energy too.
    let mut impact = fine(0.2);
    impact.damping = contact_damping(0.3);
    impact.particles = vec![moving(0.0, 1.01, 1.0, [0.5, -1.0], 1.0)];
    impact.walls = vec![floor()];
    let impact = Balance::of(impact, 0.1, |_| ());
    impact.check(
        "impact",
        1e-4,
        &["friction_loss", "damping_loss", "kinetic"],
    );
    assert_eq!(impact.change[2..4], [0.0; 2]);
    // Sticking while it lasts, then parting: only the tangential dashpot and what the tangential
    // spring holds at the end are lost.
    let mut sticking = fine(1e3);
    sticking.damping = Damping {
        tangential: Some(0.3),
        ..Damping::default()
    };
    sticking.particles = vec![moving(0.0, 1.01, 1.0, [0.3, -1.0], 0.0)];
    sticking.walls = vec![floor()];
    let sticking = Balance::of(sticking, 0.1, |_| ());
    sticking.check("sticking", 1e-3, &["damping_loss"]);
}

#[test]
fn losses_of_motion() {
    for (name, damping) in [
        (
            "global",
            Damping {
                global: 2.0,
                ..Damping::default()
            },
        ),
        (
            "con1",
            Damping {
                con1: 0.9999,
                ..Damping::default()
            },
        ),
        (
            "local",
            Damping {
                local: 0.5,
                ..Damping::default()
            },
        ),
    ] {
        let mut setup = fine(0.5);
        setup.damping = damping;
        setup.gravity = Some(Gravity::Uniform([0.0, -10.0]));
        setup.particles = vec![
            moving(0.0, 0.0, 1.0, [1.0, 2.0], 3.0),
            moving(2.1, 0.0, 1.0, [-1.0, 2.0], 3.0),
        ];
        let needed = ["global_loss", "potential", "kinetic"];
        Balance::of(setup, 0.5, |_| ()).check(name, 2e-4, &needed);
    }
}

#[test]
fn weight_towards_a_point() {
    let mut setup = fine(0.5);
    setup.gravity = Some(Gravity::Centripetal {
        towards: [0.0, 5.0],
        g: 10.0,
    });
    setup.particles = vec![moving(4.0, 0.0, 1.0, [1.0, 2.0], 0.0)];
    Balance::of(setup, 0.5, |_| ()).check("centripetal", 1e-6, &["potential", "kinetic"]);
}

#[test]
fn work_of_every_agent() {
    let needed = ["boundary_work"];
    // A wall that pushes.
    let mut pushing = fine(0.5);
    pushing.particles = vec![particle(0.0, 1.0, 1.0)];
    pushing.walls = vec![floor()];
    pushing.walls[0].velocity = [0.0, 1.0];
    Balance::of(pushing, 0.02, |_| ()).check("pushing wall", 1e-6, &needed);
    // A wall that drags along itself.
    let mut dragging = fine(0.5);
    dragging.gravity = Some(Gravity::Uniform([0.0, -10.0]));
    dragging.particles = vec![particle(0.0, 1.0 - 1e-3, 1.0)];
    dragging.walls = vec![floor()];
    dragging.walls[0].velocity = [1.0, 0.0];
    Balance::of(dragging, 0.05, |_| ()).check("dragging wall", 1e-5, &needed);
    // A wall that turns about a point beside the particle.
    let mut turning = fine(0.5);
    turning.particles = vec![particle(2.0, 1.0, 1.0)];
    turning.walls = vec![wall("lever", [-1.0, 0.0], [5.0, 0.0])];
    turning.walls[0].angular_velocity = 1.0;
    Balance::of(turning, 0.05, |_| ()).check("turning wall", 1e-4, &needed);
    // A driven particle, straight and by its spin.
    for (velocity, spin) in [([1.0, 0.0], 0.0), ([0.0, 0.0], 5.0), ([0.5, 0.5], 2.0)] {
        let mut setup = fine(0.5);
        setup.particles = vec![
            driven(0.0, 0.0, 1.0, velocity, spin),
            particle(1.99, 0.1, 1.0),
        ];
        Balance::of(setup, 0.01, |_| ()).check("driven", 1e-4, &needed);
    }
    // One velocity prescribed, the other free; weight acts on the prescribed one.
    let mut guided = fine(0.5);
    guided.gravity = Some(Gravity::Uniform([-3.0, -10.0]));
    guided.particles = vec![moving(0.0, 0.0, 1.0, [1.0, 0.0], 0.0)];
    guided.particles[0].fixed = [true, false, false];
    Balance::of(guided, 0.5, |_| ()).check("guided", 1e-6, &needed);
    // An applied force, on a free and on a held particle: the latter works against its holder.
    for fixed in [[false; 3], [false, true, false]] {
        let mut setup = fine(0.5);
        setup.particles = vec![particle(0.0, 0.0, 1.0)];
        setup.particles[0].force = [3.0, 4.0];
        setup.particles[0].fixed = fixed;
        Balance::of(setup, 0.5, |_| ()).check("applied", 1e-9, &needed);
    }
}

/// A command and what it does.
type Act = (&'static str, fn(&mut World));

#[test]
fn work_of_every_command() {
    let acts: [Act; 12] = [
        ("velocity", |world| {
            world.set_motion(0, Motion::Velocity([1.0, 2.0]));
        }),
        ("spin", |world| world.set_motion(0, Motion::Spin(5.0))),
        ("zero", World::zero_velocities),
        ("gravity", |world| {
            world.set_gravity(Some(Gravity::Uniform([0.0, -20.0])));
        }),
        ("frac", |world| world.set_frac(0.5 * world.model().frac)),
        ("create", |world| {
            world.create(&moving(0.0, 3.4, 1.0, [0.0, -1.0], 1.0));
        }),
        ("delete", |world| world.delete(1)),
        ("delete wall", |world| world.delete_wall(0)),
        ("create wall", |world| {
            world.create_wall(&wall("slope", [-3.0, 0.2], [3.0, 0.2]));
        }),
        ("friction", |world| {
            world.change_materials(|model| model.materials[0].friction = 0.0);
        }),
        ("stiffness", |world| {
            world.change_materials(|model| model.materials[0].normal_stiffness = Some(1.5e4));
        }),
        ("damping", |world| world.set_damping(contact_damping(0.3))),
    ];
    for (name, act) in acts {
        let mut setup = fine(0.5);
        setup.gravity = Some(Gravity::Uniform([0.0, -10.0]));
        setup.particles = vec![
            moving(0.0, 1.0 - 2e-3, 1.0, [0.5, 0.0], 0.0),
            moving(1.98, 1.0 - 2e-3, 1.0, [-0.5, 0.0], 0.0),
        ];
        setup.walls = vec![floor()];
        let before = setup.clone();
        let balance = Balance::of(setup, 0.02, act);
        // Booked as work, so that the balance goes on; commands that change nothing stored book
        // next to nothing, and then it is not missed.
        let needed: &[&str] = match name {
            "frac" | "damping" => &[],
            _ => &["boundary_work"],
        };
        balance.check(name, 2e-5, needed);
        // Negative control: the same scene without the command ends elsewhere.
        let without = Balance::of(before, 0.02, |_| ());
        assert_ne!(without.change, balance.change, "{name} did nothing");
    }
}

#[test]
fn accounts_of_the_deleted_stay() {
    let mut setup = everything(16e3);
    setup.walls[2].velocity = [0.0, -0.1];
    // Low number, loaded and pushed: its account holds something of everything.
    setup.particles[0].force = [1.0, 1.0];
    let mut world = world(setup);
    run(&mut world, 4000);
    let before = entries(&mut world);
    world.delete(0);
    world.delete_wall(2);
    let after = entries(&mut world);
    // The drag of the half step before the boundary goes with the particle: one part in 8000 of
    // its account. Contact losses are booked whole.
    for (k, within) in [(6, 1e-12), (7, 1e-12), (8, 1e-3)] {
        let gap = (after[k] - before[k]).abs();
        assert!(
            before[k] > 0.0 && gap < within * before[k],
            "{}",
            ENTRIES[k]
        );
    }
    // The command's work is the jump of what is stored (booked as work, hence the sign), and the
    // accounts go on; they were worth far more than the tolerance.
    let jump = |k: std::ops::Range<usize>| k.map(|k| after[k] - before[k]).sum::<f64>();
    let missing = jump(0..10);
    let scale: f64 = before.iter().map(|x| x.abs()).sum();
    assert!(missing.abs() < 1e-12 * scale, "{missing:e}");
    assert!(jump(0..6).abs() > 1e-6 * scale);
}

#[test]
fn dashpots_by_stiffness_and_restitution_are_booked() {
    for dashpot in [
        Dashpot::Beta(2e-3),
        Dashpot::Restitution(0.5),
        Dashpot::Fraction(0.2),
    ] {
        for pull in [false, true] {
            let mut setup = fine(0.0);
            setup.damping = Damping {
                contact: dashpot,
                pull,
                ..Damping::default()
            };
            setup.particles = vec![moving(0.0, 1.01, 1.0, [0.0, -1.0], 0.0)];
            setup.walls = vec![floor()];
            let balance = Balance::of(setup, 0.1, |_| ());
            balance.check("dashpot", 5e-4, &["damping_loss"]);
        }
    }
}

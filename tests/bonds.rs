//! Bonds: they pull as springs do, break where they should, and the books close over it.

mod common;
#[path = "bonds/presets.rs"]
mod presets;

use ballast::engine::neighbours::Status;
use ballast::engine::setup::{Dashpot, Material, ParticleSetup, Setup, TimeStepChoice};
use ballast::engine::{Isa, World};
use ballast::record::checkpoint::{decode, encode};
use common::*;
use nalgebra::{DMatrix, DVector};

const K_N: f64 = 1e6;
const K_S: f64 = 0.7e6;

fn bonded(tension: f64, shear: f64, friction: f64) -> Setup {
    let mut setup = scene(Material {
        density: 1.0 / std::f64::consts::PI,
        bond_tension: tension,
        bond_shear: shear,
        ..material(K_N, K_S, friction)
    });
    setup.law = law("bonded");
    setup
}

/// Two unit discs that are moved as told, bonded with this gap between them.
fn couple(mut setup: Setup, gap: f64, velocity: [f64; 2], spin: f64) -> World {
    setup.time_step = TimeStepChoice::Seconds(1e-4);
    setup.frac = 1.0;
    setup.particles = vec![
        driven(-1.0, 0.0, 1.0, [0.0; 2], 0.0),
        driven(1.0 + gap, 0.0, 1.0, velocity, spin),
    ];
    let mut world = world(setup);
    assert_eq!(world.bond(Some(gap.max(0.0)), |_| true), 1);
    world
}

#[test]
fn a_bond_pulls_as_its_spring_does_up_to_its_strength_and_never_again() {
    // Far beyond the halo that is asked for: a bond that holds is listed all the same.
    let strength = 0.3 * K_N;
    let mut setup = bonded(strength, 1e9, 0.5);
    setup.tol = Some(1e-3);
    let mut world = couple(setup, 0.0, [0.5, 0.0], 0.0);
    let mut held = 0;
    while world.bonds() == 1 {
        // The normal has a length of 1 but for two roundings.
        let (normal, spring) = (world.reaction(0).normal, K_N * world.geometry(0).overlap);
        assert!((normal - spring).abs() <= 4.0 * f64::EPSILON * spring.abs());
        assert!(spring >= -strength);
        held += 1;
        run(&mut world, 1);
    }
    // It broke in the first step beyond, and is apart.
    let overlap = world.geometry(0).overlap;
    assert!(K_N * overlap < -strength && K_N * (overlap + 0.5e-4) >= -strength);
    assert!(held > 5990, "{held}");
    assert_eq!(world.contacts().status[0], Status::Apart);
    assert_eq!(world.reaction(0).normal, 0.0);
    assert_eq!((world.bonds(), world.bonds_broken()), (0, 1));
    // Back again it is a contact as any other.
    world.set_motion(1, ballast::engine::edit::Motion::Velocity([-0.5, 0.0]));
    let mut pressed = 0;
    for _ in 0..7000 {
        run(&mut world, 1);
        // Pairs far apart are listed no more.
        let Some(&[0, 1]) = world.contacts().pairs.first() else {
            continue;
        };
        let overlap = world.geometry(0).overlap;
        let (normal, spring) = (world.reaction(0).normal, (K_N * overlap).max(0.0));
        assert!((normal - spring).abs() <= 4.0 * f64::EPSILON * spring);
        pressed += usize::from(overlap > 0.0);
    }
    assert!(pressed > 900 && world.bonds() == 0, "{pressed}");
}

/// A disc that turns against one at rest shears their contact at a constant normal force.
#[test]
fn a_bond_shears_up_to_its_strength_and_what_a_press_adds_then_rubs() {
    let (shear, friction) = (2e3, 0.5);
    for (gap, carried) in [(-2e-3, 1e3), (0.0, 0.0), (1e-3, 0.0)] {
        let mut world = couple(bonded(5e3, shear, friction), gap, [0.0; 2], -1.0);
        let normal = world.reaction(0).normal;
        assert!((normal + K_N * gap).abs() < 1e-6);
        let limit = shear + carried;
        let rise = K_S * world.dt() * (1.0 + 0.5 * gap);
        for cycle in 1.. {
            run(&mut world, 1);
            let now = world.reaction(0);
            if world.bonds() == 0 {
                break;
            }
            assert_eq!(now.normal, normal);
            let expected = f64::from(cycle) * rise;
            assert!((now.tangential.abs() - expected).abs() < 1e-9 * limit);
            assert!(now.tangential.abs() <= limit && !now.sliding);
        }
        // The limit lies between the force that was held last and the one that was not.
        let steps = world.cycle_number() as f64;
        assert!(
            (steps - 1.0) * rise <= limit && steps * rise > limit,
            "{gap}"
        );
        for _ in 0..10 {
            let now = world.reaction(0);
            assert!(
                (now.tangential.abs() - carried).abs() < 1e-9 * limit,
                "{gap}"
            );
            let touches = world.contacts().status[0] != Status::Apart;
            assert_eq!((touches, now.sliding), (gap < 0.0, gap < 0.0));
            assert_eq!(now.normal, if gap < 0.0 { normal } else { 0.0 });
            run(&mut world, 1);
        }
        assert_eq!(world.bonds_broken(), 1);
    }
}

#[test]
fn only_what_is_near_inside_and_strong_is_bonded() {
    let mut setup = bonded(1e3, 1e3, 0.5);
    setup.materials.push(Material {
        name: "weak".into(),
        bond_tension: 0.0,
        bond_shear: 0.0,
        ..setup.materials[0].clone()
    });
    // Touching, apart by half the reach, apart by more than it, and of another material.
    let mut x = 0.0;
    for (gap, material) in [(0.0, 0), (0.0, 0), (5e-4, 0), (2e-3, 0), (-1e-3, 1)] {
        x += 2.0 + gap;
        setup.particles.push(ParticleSetup {
            material,
            ..particle(x, 0.0, 1.0)
        });
    }
    let mut world = world(setup);
    assert_eq!(world.bond(None, |p| p > 0), 0);
    assert_eq!(world.bond(None, |_| true), 1);
    assert_eq!(world.bond(None, |_| true), 0);
    assert_eq!(world.bond(Some(1.0), |_| true), 1);
    assert_eq!(world.bonds(), 2);
    // One that goes with a particle did not break.
    world.delete(0);
    assert_eq!((world.bonds(), world.bonds_broken()), (1, 0));
}

/// Bonded unit discs of a triangular lattice, columns by rows, the middle at the origin, that touch.
fn lattice(mut setup: Setup, columns: usize, rows: usize) -> Setup {
    let rise = 3f64.sqrt();
    for row in 0..rows {
        for column in 0..columns {
            let x = 2.0 * column as f64 + (row % 2) as f64 - columns as f64;
            let y = rise * (row as f64 - 0.5 * (rows as f64 - 1.0));
            setup.particles.push(particle(x, y, 1.0));
        }
    }
    setup
}

/// A block that turns, is drawn apart and sheared so fast that most of its bonds break, some discs
/// collide again.
fn torn(columns: usize, rows: usize, frac: f64) -> Setup {
    let mut setup = lattice(bonded(4e2, 6e2, 0.3), columns, rows);
    setup.frac = frac;
    let mut random = Random(5);
    for particle in &mut setup.particles {
        let [x, y] = particle.at;
        particle.velocity = [0.5 * x - y, x - 0.3 * y].map(|v| v + random.between(-0.5, 0.5));
        particle.spin = random.between(-0.5, 0.5);
    }
    setup
}

fn built(setup: &Setup, threads: usize, isa: Isa) -> World {
    let mut world = World::build(setup.clone(), threads).expect("the scene builds");
    world.use_instructions(isa);
    assert!(world.bond(None, |_| true) > 0);
    world
}

#[test]
fn energy_is_found_again_with_what_broke() {
    // One bond, slowly: what its spring held at its strength.
    let strength = 1e3;
    let mut world = couple(bonded(strength, 1e9, 0.5), 0.0, [0.01, 0.0], 0.0);
    run(&mut world, 2000);
    let booked = world.bookings().expect("energies are booked");
    let stored = strength * strength / (2.0 * K_N);
    let step = 0.01 * world.dt() * strength;
    assert!((booked.bond_loss - stored).abs() < step, "{booked:?}");
    assert!(booked.energy_error.abs() < 1e-9, "{booked:?}");
    assert_eq!((booked.slip_loss, booked.friction_loss), (0.0, 0.0));
    // A block that is torn: the error is that of the step, and falls with it.
    let errors = [0.1, 0.025].map(|frac| {
        let setup = torn(12, 10, frac);
        let mut world = built(&setup, 1, Isa::widest());
        let [before, kinetic] = [world.bonds() as f64, world.energies().kinetic];
        let cycles = (0.05 / world.dt()) as u64;
        run(&mut world, cycles);
        world.settle();
        let booked = world.bookings().expect("energies are booked");
        assert!((world.bonds() as f64) < 0.5 * before);
        assert!(booked.bond_loss > 1e-3 * kinetic && booked.friction_loss > 0.0);
        booked.energy_error.abs()
    });
    // Contacts begin and bonds break within a step: at least of its first order.
    assert!(
        errors[0] < 1e-4 && errors[1] < 0.25 * errors[0],
        "{errors:?}"
    );
}

#[test]
fn momentum_is_kept_while_bonds_break() {
    let setup = torn(12, 10, 0.1);
    let mut world = built(&setup, 1, Isa::widest());
    let (before, scale) = momentum(&mut world);
    run(&mut world, 2000);
    let (after, _) = momentum(&mut world);
    assert!(world.bonds_broken() > 100);
    // Each cycle rounds each of the sums once.
    let rounding = 2000.0 * 120.0 * f64::EPSILON * scale;
    for (before, after) in before.iter().zip(after) {
        assert!((after - before).abs() < rounding, "{before} {after}");
    }
}

/// Momentum in x and y and angular momentum about the origin, and the size of what is summed.
fn momentum(world: &mut World) -> ([f64; 3], f64) {
    world.settle();
    let (mut sum, mut scale) = ([0.0; 3], 0.0);
    for p in 0..world.particles().len() {
        let (x, (v, spin)) = (world.position(p), world.velocity(p));
        let (m, i) = (world.particles().mass[p], world.particles().inertia[p]);
        let turn = m * (x[0] * v[1] - x[1] * v[0]);
        for (sum, part) in sum.iter_mut().zip([m * v[0], m * v[1], turn + i * spin]) {
            *sum += part;
        }
        scale += m * (v[0].abs() + v[1].abs()) + turn.abs() + i * spin.abs();
    }
    (sum, scale)
}

/// Stiffness matrix of a lattice as it stands, three ways of each disc: the springs of bonds that touch.
fn stiffness(setup: &Setup) -> DMatrix<f64> {
    let discs = &setup.particles;
    let mut k = DMatrix::zeros(3 * discs.len(), 3 * discs.len());
    for i in 0..discs.len() {
        for j in 0..i {
            let d = [0, 1].map(|axis| discs[j].at[axis] - discs[i].at[axis]);
            let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
            if distance > 2.1 {
                continue;
            }
            let [x, y] = d.map(|d| d / distance);
            // How much each way adds to overlap and slide.
            for (spring, ways) in [
                (K_N, [x, y, 0.0, -x, -y, 0.0]),
                (K_S, [y, -x, -1.0, -y, x, -1.0]),
            ] {
                let place = |n: usize| 3 * if n < 3 { i } else { j } + n % 3;
                for a in 0..6 {
                    for b in 0..6 {
                        k[(place(a), place(b))] += spring * ways[a] * ways[b];
                    }
                }
            }
        }
    }
    k
}

/// A beam that is held at its left end and pulled down at its right one, against the linear equations
/// of the same springs. They are those of no load: the answer differs by a share that grows with the
/// load, by the angle that the beam turns and the strain in it.
#[test]
fn a_beam_bends_as_its_springs_say() {
    let (columns, rows) = (10, 3);
    let shares = [1e-6, 1e-5].map(|bend| {
        let mut setup = lattice(bonded(1e5, 1e5, 0.5), columns, rows);
        setup.frac = 0.2;
        setup.ledger = false;
        let k = stiffness(&setup);
        let held = |p: usize| p.is_multiple_of(columns);
        let free: Vec<usize> = (0..3 * columns * rows).filter(|n| !held(n / 3)).collect();
        let k = k.select_rows(&free).select_columns(&free);
        let end = (columns - 1) + columns * (rows / 2);
        let pulled = free.iter().position(|&n| n == 3 * end + 1);
        let pulled = pulled.expect("the end is free");
        let mut load = DVector::zeros(free.len());
        load[pulled] = -1.0;
        let solved = k.clone().lu().solve(&load).expect("it is stiff");
        // So large a load that the end sinks by this many radii.
        let force = bend / solved[pulled].abs();
        let solved = solved * force;
        for p in 0..columns * rows {
            setup.particles[p].fixed = [held(p); 3];
        }
        setup.particles[end].force = [0.0, -force];
        // Mass 1 and inertia 1/2 of each disc.
        let root = |n: usize| if free[n] % 3 == 2 { 2f64.sqrt() } else { 1.0 };
        let scaled = DMatrix::from_fn(free.len(), free.len(), |a, b| root(a) * k[(a, b)] * root(b));
        let slowest = scaled.symmetric_eigenvalues().min().sqrt();
        // All ways of swinging die out with the rate of the slowest.
        setup.damping.global = 2.0 * slowest;
        let start: Vec<[f64; 2]> = setup.particles.iter().map(|p| p.at).collect();
        let mut world = world(setup);
        // Held discs are not asked: a bond between them carries nothing either way.
        assert_eq!(world.bond(None, |_| true), 27 + 38);
        let cycles = 40.0 / (slowest * world.dt());
        run(&mut world, cycles as u64);
        let now = |n: usize| match n % 3 {
            2 => world.particles().row[n / 3].angle,
            axis => world.position(n / 3)[axis] - start[n / 3][axis],
        };
        let off = free.iter().zip(solved.iter());
        let off = off.map(|(&n, &u)| (now(n) - u).abs()).fold(0.0, f64::max);
        off / bend
    });
    // What is not linear is a share of a few times the bend; rounding of places, R ε/bend.
    assert!(shares[1] < 10.0 * 1e-5, "{shares:?}");
    assert!(shares[0] < 10.0 * 1e-6, "{shares:?}");
}

#[test]
fn threads_instructions_and_a_stop_on_the_way_change_no_bit() {
    let setup = torn(40, 36, 0.1);
    let outcome = |world: &mut World| {
        world.settle();
        (world.state_hash(), format!("{:?}", world.bookings()))
    };
    for ledger in [true, false] {
        let setup = Setup {
            ledger,
            ..setup.clone()
        };
        let mut one = built(&setup, 1, Isa::Baseline);
        run(&mut one, 300);
        let broken = one.bonds_broken();
        let one = outcome(&mut one);
        assert!(broken > 500, "{broken}");
        for isa in Isa::ALL.into_iter().filter(|isa| isa.is_here()) {
            for threads in [1, 2, 3] {
                let mut world = built(&setup, threads, isa);
                run(&mut world, 150);
                if threads == 2 {
                    let stored = encode(&world).expect("it is stored");
                    world = decode(&stored).expect("it is what was stored");
                    assert!(world.unpack(threads));
                    world.use_instructions(isa);
                }
                run(&mut world, 150);
                assert_eq!(world.bonds_broken(), broken);
                assert_eq!(outcome(&mut world), one, "{isa} {threads}");
            }
        }
    }
}

#[test]
fn without_bonds_it_is_the_linear_law() {
    for fraction in [0.0, 0.2] {
        let outcomes = ["linear", "bonded"].map(|name| {
            let mut setup = collapsing_pile(10, 0.4);
            setup.law = law(name);
            setup.damping.contact = Dashpot::Fraction(fraction);
            setup.materials[0].cohesion = 3.0;
            if name == "bonded" {
                // Strong ones, but nobody makes them.
                setup.materials[0].bond_tension = 1e3;
                setup.materials[0].bond_shear = 1e3;
            }
            let mut world = world(setup);
            run(&mut world, 3000);
            world.settle();
            (world.state_hash(), world.bookings())
        });
        assert_eq!(outcomes[0], outcomes[1]);
    }
}

/// Parts of a world are modelled or not; bonds outlive that.
#[test]
fn bonds_outlive_changes_of_the_model() {
    let setup = bonded(1e5, 1e5, 0.5);
    let mut world = world(Setup {
        particles: vec![particle(-1.0, 0.0, 1.0), particle(1.001, 0.0, 1.0)],
        ..setup
    });
    assert!(world.frac_limit().is_infinite());
    assert_eq!(world.bond(Some(2e-3), |_| true), 1);
    world.set_damping(contact_damping(0.1));
    world.change_materials(|model| model.materials[0].rolling_friction = 0.1);
    assert_eq!(world.bonds(), 1);
    assert_eq!(world.reaction(0).normal, K_N * world.geometry(0).overlap);
    // The stability bound counts what pulls.
    assert!(world.frac_limit().is_finite());
    // A weaker bond breaks.
    world.change_materials(|model| model.materials[0].bond_tension = 1.0);
    assert_eq!((world.bonds(), world.reaction(0).normal), (0, 0.0));
}

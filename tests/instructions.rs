//! Vector instructions change no bit: every law, with and without ledger, whatever the number of
//! threads.

mod common;

use ballast::engine::Isa;
use ballast::engine::World;
use ballast::engine::contact::laws::LAWS;
use ballast::engine::neighbours::Status;
use ballast::engine::setup::{
    Body, BoundarySetup, Damping, Dashpot, Material, NormalForm, Setup, TimeStepChoice, Unloading,
};
use common::*;

/// A collapsing pile of spheres of three sizes under a law: contacts form, slide, roll and part.
fn pile(law_name: &str, rows: usize) -> Setup {
    let mut setup = collapsing_pile(rows, 0.4);
    setup.law = law(law_name);
    if !setup.law.has_constant_springs() {
        setup.body = Body::Sphere;
        setup.time_step = TimeStepChoice::Rayleigh;
        setup.frac = 0.2;
        for material in &mut setup.materials {
            *material = Material {
                young: Some(1e6),
                poisson: Some(0.25),
                ..material.clone()
            };
        }
    }
    for (k, particle) in setup.particles.iter_mut().enumerate() {
        particle.radius *= 1.0 - 0.05 * (k % 3) as f64;
    }
    setup.damping = Damping {
        contact: Dashpot::Fraction(0.1),
        ..setup.damping
    };
    setup
}

/// What a run comes to, with all that the monitors and books hold.
fn outcome(setup: &Setup, isa: Isa, threads: usize, cycles: u64) -> (Vec<u64>, String) {
    let mut world = World::build(setup.clone(), threads).expect("the scene builds");
    world.use_instructions(isa);
    let hashes = (0..6)
        .map(|_| {
            run(&mut world, cycles / 6);
            world.state_hash()
        })
        .collect();
    let seen = format!(
        "{:?} {:?} {:?}",
        world.bookings(),
        world.fracc_monitor(),
        world.particles().force
    );
    (hashes, seen)
}

/// The scenes: each law as it is, and what else a loop can be put together from.
fn scenes() -> Vec<(String, Setup)> {
    let mut scenes: Vec<(String, Setup)> = Vec::new();
    for card in LAWS {
        let setup = pile(card.name, 12);
        for ledger in [false, true] {
            let name = format!("{}, ledger {ledger}", card.name);
            scenes.push((
                name,
                Setup {
                    ledger,
                    ..setup.clone()
                },
            ));
        }
        if !["bonded", "mindlin-deresiewicz-exact"].contains(&card.name) {
            let normal = NormalForm::Incremental;
            scenes.push((
                format!("{}, summed", card.name),
                Setup {
                    normal,
                    ..setup.clone()
                },
            ));
        }
    }
    let mut rolling = pile("hertz-mindlin", 12);
    for material in &mut rolling.materials {
        material.rolling_friction = 0.2;
    }
    scenes.push(("rolling".into(), rolling));
    let mut keep = pile("hertz-mindlin", 12);
    keep.unloading = Unloading::Keep;
    keep.damping = Damping {
        tangential: Some(0.3),
        centred: true,
        pull: true,
        overlap_critical: Some(0.01),
        global: 0.2,
        local: 0.3,
        con1: 0.999,
        ..keep.damping
    };
    scenes.push(("all damping, force kept".into(), keep));
    let mut undamped = pile("linear", 12);
    undamped.damping.contact = Dashpot::None;
    scenes.push(("linear, undamped".into(), undamped));
    scenes
}

#[test]
fn instructions_change_no_bit() {
    let wider: Vec<Isa> = Isa::ALL.into_iter().filter(|isa| isa.is_here()).collect();
    for (name, setup) in scenes() {
        let one = outcome(&setup, Isa::Baseline, 1, 3000);
        assert!(
            one.0.windows(2).all(|pair| pair[0] != pair[1]),
            "{name} stands still"
        );
        for &isa in &wider {
            let same = outcome(&setup, isa, 1, 3000);
            assert_eq!(one, same, "{name}, {isa}");
        }
    }
    // Negative control: another last bit somewhere is seen.
    let setup = pile("hertz-mindlin", 12);
    let mut other = setup.clone();
    other.particles[7].radius = other.particles[7].radius.next_up();
    assert_ne!(
        outcome(&setup, Isa::widest(), 1, 3000),
        outcome(&other, Isa::widest(), 1, 3000)
    );
}

#[test]
fn neither_do_threads_beside_them() {
    // 2485 particles: eight shares of more than 256 each, none of them a multiple of eight.
    for law in ["linear", "hertz-mindlin", "mindlin-deresiewicz-exact"] {
        let setup = pile(law, 70);
        let one = outcome(&setup, Isa::Baseline, 1, 300);
        for threads in [2, 3, 8] {
            let isa = Isa::widest();
            assert_eq!(
                one,
                outcome(&setup, isa, threads, 300),
                "{law}, {isa}, {threads}"
            );
        }
    }
}

/// Spheres that fly into each other: no weight and no walls, sums of forces kept now and then only.
fn clump(rows: usize) -> Setup {
    let mut setup = pile("hertz-mindlin", rows);
    (setup.gravity, setup.walls, setup.ledger) = (None, Vec::new(), false);
    setup.fracc_every = 100;
    for particle in &mut setup.particles {
        let [x, y] = particle.at;
        particle.velocity = [0.3 * (rows as f64 - x), 0.3 * (0.6 * rows as f64 - y)];
    }
    setup
}

/// Where a run ends.
fn end(setup: &Setup, isa: Isa, threads: usize) -> Vec<[u64; 2]> {
    let mut world = World::build(setup.clone(), threads).expect("the scene builds");
    world.use_instructions(isa);
    run(&mut world, 1500);
    let rows = world.particles().row.iter();
    rows.map(|row| row.x.map(f64::to_bits)).collect()
}

/// Motion leaves out what a scene has not, and keeps sums only for whoever looks: either way the same
/// bits as with the ledger, which sums by itself and asks for everything.
#[test]
fn neither_does_what_motion_leaves_out() {
    // 465 particles: three shares.
    let clump = clump(30);
    let mut rolling = clump.clone();
    rolling.materials[0].rolling_friction = 0.2;
    let mut pushed = clump.clone();
    pushed.particles[40].force = [3.0, -2.0];
    let mut walled = clump.clone();
    walled.walls = vec![wall("floor", [-60.0, 0.0], [90.0, 0.0])];
    let mut ends = Vec::new();
    for (name, setup) in [
        ("clump", clump),
        ("rolling", rolling),
        ("pushed", pushed),
        ("walled", walled),
    ] {
        let ledger = Setup {
            ledger: true,
            fracc_every: 1,
            ..setup.clone()
        };
        let booked = end(&ledger, Isa::Baseline, 1);
        for fracc_every in [1, 100] {
            let setup = Setup {
                fracc_every,
                ..setup.clone()
            };
            for (isa, threads) in [(Isa::Baseline, 1), (Isa::widest(), 1), (Isa::widest(), 3)] {
                let same = end(&setup, isa, threads) == booked;
                assert!(same, "{name}, FRACC every {fracc_every}, {isa}, {threads}");
            }
        }
        ends.push(booked);
    }
    // Each of them matters.
    assert!(ends[1..].iter().all(|other| *other != ends[0]));
}

/// Many threads in a cell: those who move particles write the rows of the images that others read.
#[test]
fn neither_do_many_threads_in_a_cell() {
    // 1200 particles that press each other in it: eight shares of 150.
    let edges = [[80.0, 0.0], [0.0, 1.74 * 30.0]];
    let corner = [-0.5, -0.5];
    let mut setup = clump(2);
    let places = (0..30).flat_map(|row| (0..40).map(move |column| (row, column)));
    let at = |(row, column): (usize, usize)| {
        let x = (2 * column + row % 2) as f64;
        let mut one = particle(
            x,
            1.74 * row as f64,
            1.02 - 0.01 * ((row + column) % 2) as f64,
        );
        one.velocity = [(column % 5) as f64 - 2.0, (row % 7) as f64 - 3.0].map(|v| 0.5 * v);
        one
    };
    setup.particles = places.map(at).collect();
    setup.boundary = Some(BoundarySetup::Cell { corner, edges });
    setup.ledger = true;
    let end = |setup: &Setup, isa, threads| {
        let mut world = World::build(setup.clone(), threads).expect("the scene builds");
        world.use_instructions(isa);
        assert!(world.set_strain_rate([[-0.02, 0.01], [0.0, 0.02]], 0));
        run(&mut world, 600);
        let seen = (world.state_hash(), format!("{:?}", world.bookings()));
        (seen, world)
    };
    let (one, world) = end(&setup, Isa::Baseline, 1);
    for threads in [2, 5, 8] {
        assert_eq!(end(&setup, Isa::widest(), threads).0, one, "{threads}");
    }
    // Touching pairs over an edge, far apart inside, of bodies that different threads of eight move.
    let (contacts, rows) = (world.contacts(), &world.particles().row);
    let share = rows.len() / 8;
    let crossing = contacts
        .pairs
        .iter()
        .zip(&contacts.status)
        .filter(|(pair, status)| {
            let [i, j] = pair.map(|p| p as usize);
            let d = [0, 1].map(|k| rows[j].x[k] - rows[i].x[k]);
            **status != Status::Apart && d[0].hypot(d[1]) > 10.0 && i.abs_diff(j) > share
        });
    assert!(crossing.count() > 10);
}

/// Contacts that have much in common are read in another way than others; what changes that in the
/// middle of a run changes it for all instructions alike.
#[test]
fn neither_do_changes_of_what_contacts_have_in_common() {
    let two = |mut setup: Setup, change: fn(&mut Material)| {
        let mut other = setup.materials[0].clone();
        other.name = "other".into();
        change(&mut other);
        setup.materials.push(other);
        for particle in setup.particles.iter_mut().step_by(3) {
            particle.material = 1;
        }
        setup
    };
    let mut scenes = Vec::new();
    for law in ["linear", "hertz-mindlin", "mindlin-deresiewicz-exact"] {
        let setup = Setup {
            ledger: false,
            ..pile(law, 12)
        };
        scenes.push((law, setup.clone()));
        scenes.push((
            "friction of two kinds",
            two(setup.clone(), |m| m.friction = 0.1),
        ));
        scenes.push(("two densities", two(setup, |m| m.density *= 3.0)));
    }
    for (name, setup) in scenes {
        let hashes = |isa: Isa| {
            let mut world = World::build(setup.clone(), 1).expect("the scene builds");
            world.use_instructions(isa);
            let damping = setup.damping;
            let mut hashes = Vec::new();
            for stage in 0..6 {
                match stage {
                    1 => world.change_materials(|model| model.materials[0].friction = 0.0),
                    2 => world.set_damping(Damping {
                        tangential: Some(0.2),
                        ..damping
                    }),
                    3 => world.change_materials(|model| model.materials[0].friction = 0.4),
                    4 => world.set_damping(Damping {
                        overlap_critical: Some(0.01),
                        ..damping
                    }),
                    5 => world.set_damping(damping),
                    _ => {}
                }
                run(&mut world, 300);
                hashes.push(world.state_hash());
            }
            hashes
        };
        let one = hashes(Isa::Baseline);
        assert!(one.windows(2).all(|pair| pair[0] != pair[1]), "{name}");
        for isa in Isa::ALL.into_iter().filter(|isa| isa.is_here()) {
            assert_eq!(one, hashes(isa), "{name}, {isa}");
        }
    }
}

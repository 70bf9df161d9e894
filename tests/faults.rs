//! Faults: what scenes end with names cycle and culprit, and what can be done about it then.

mod common;

use ballast::engine::World;
use ballast::engine::fault::Fault;
use ballast::engine::setup::{Material, Setup};
use common::*;

fn discs(friction: f64) -> Setup {
    scene(Material {
        density: 1.0 / std::f64::consts::PI,
        ..material(1e4, 0.8e4, friction)
    })
}

/// Runs until the fault.
fn fault(setup: Setup) -> (Fault, u64) {
    let mut world = world(setup);
    for _ in 0..3_000_000 {
        if let Err(fault) = world.cycle() {
            return (fault, world.cycle_number());
        }
    }
    panic!("no fault");
}

#[test]
fn faults_name_cycle_and_culprit() {
    // Not a number: an applied force that is none.
    let mut setup = discs(0.5);
    setup.particles = vec![particle(0.0, 0.0, 1.0), particle(5.0, 0.0, 1.0)];
    setup.particles[1].force = [f64::NAN, 0.0];
    let (found, _) = fault(setup);
    assert_eq!(
        found,
        Fault::NotANumber {
            cycle: 1,
            particle: 2
        }
    );
    assert!(found.to_string().contains("particle 2"), "{found}");

    // Runaway: faster than a radius per cycle.
    let mut setup = discs(0.5);
    setup.particles = vec![
        particle(0.0, 0.0, 1.0),
        moving(5.0, 0.0, 1.0, [1e6, 0.0], 0.0),
    ];
    let (found, _) = fault(setup);
    let Fault::Runaway {
        cycle: 1,
        particle: 2,
        distance,
    } = found
    else {
        panic!("{found:?}");
    };
    assert!(distance > 1.0);

    // Unstable: the step far beyond the limit ends in a runaway or not a number, not in silence.
    let mut setup = square_lattice(material(1e6, 1e6, 1e3), 4, 1e-3);
    setup.frac = 1.5;
    setup.particles[0].at[0] += 1e-6;
    let (found, cycle) = fault(setup);
    let (Fault::Runaway { cycle: named, .. } | Fault::ThroughWall { cycle: named, .. }) = found
    else {
        panic!("{found:?}");
    };
    assert_eq!(named, cycle);

    // Lost: flies on and on.
    let mut setup = discs(0.5);
    setup.particles = vec![
        particle(0.0, 0.0, 1.0),
        moving(5.0, 0.0, 1.0, [450.0, 0.0], 0.0),
    ];
    let (found, _) = fault(setup);
    let Fault::Lost {
        particle: 2,
        distance,
        ..
    } = found
    else {
        panic!("{found:?}");
    };
    assert!(distance > 1e4);

    // A wall that would step over the particle, to and fro.
    for factor in [1.1, 4.0, 100.0] {
        let mut setup = discs(0.5);
        setup.particles = vec![particle(0.0, 50.0, 1.0)];
        setup.walls = vec![floor()];
        let dt = ballast::engine::World::build(setup.clone(), 1)
            .unwrap()
            .dt();
        setup.walls[0].velocity = [0.0, factor / dt];
        let (found, cycle) = fault(setup);
        let Fault::WallRunaway {
            cycle: named,
            wall,
            distance,
        } = found
        else {
            panic!("{factor}: {found:?}");
        };
        assert_eq!((named, wall.as_str()), (cycle, "floor"));
        assert!((distance / factor - 1.0).abs() < 1e-12);
    }

    // Through a wall: too fast for the spring.
    let mut setup = discs(0.5);
    setup.particles = vec![moving(0.0, 1.1, 1.0, [0.0, -200.0], 0.0)];
    setup.walls = vec![floor()];
    setup.frac = 0.01;
    let (found, cycle) = fault(setup);
    let Fault::ThroughWall {
        cycle: named,
        particle: 1,
        wall,
    } = found
    else {
        panic!("{found:?}");
    };
    assert_eq!((named, wall.as_str()), (cycle, "floor"));

    // Coincident centres.
    let mut setup = discs(0.5);
    setup.particles = vec![
        particle(9.0, 0.0, 1.0),
        particle(0.0, 0.0, 1.0),
        particle(0.0, 0.0, 1.0),
    ];
    let (found, _) = fault(setup);
    assert_eq!(
        found,
        Fault::Coincident {
            cycle: 1,
            first: 2,
            second: 3
        }
    );
}

#[test]
fn a_centre_on_a_wall_is_a_fault_at_once() {
    for (x, name) in [(0.0, "face"), (3.0, "end")] {
        let mut setup = discs(0.5);
        setup.particles = vec![particle(x, 0.0, 1.0)];
        setup.walls = vec![wall(name, [-3.0, 0.0], [3.0, 0.0])];
        let Err(Fault::ThroughWall {
            cycle: 0,
            particle: 1,
            wall,
        }) = World::build(setup, 1)
        else {
            panic!("{name}");
        };
        assert_eq!(wall, name);
    }
}

#[test]
fn a_world_that_broke_off_stays_as_it_is() {
    let mut setup = discs(0.5);
    setup.particles = vec![moving(0.0, 1.1, 1.0, [0.0, -200.0], 0.0)];
    setup.walls = vec![floor()];
    setup.frac = 0.01;
    let mut world = world(setup);
    let found = (0..1000).find_map(|_| world.cycle().err());
    assert!(world.is_broken());
    assert_eq!(world.fault(), found.as_ref());
    let (hash, cycle) = (world.state_hash(), world.cycle_number());
    assert_eq!(world.cycle().err(), found);
    assert_eq!((world.state_hash(), world.cycle_number()), (hash, cycle));
}

/// A change that leaves a centre on a wall is met before the next cycle, and can be taken back.
#[test]
fn what_a_change_misplaced_another_mends() {
    let mut setup = discs(0.5);
    setup.particles = vec![particle(0.0, 5.0, 1.0)];
    setup.walls = vec![floor()];
    let mut world = world(setup);
    run(&mut world, 10);
    world.create(&particle(9.0, 0.0, 1.0));
    let hash = world.state_hash();
    for _ in 0..2 {
        let found = world.cycle().expect_err("the centre is on the floor");
        assert!(
            matches!(
                found,
                Fault::ThroughWall {
                    cycle: 10,
                    particle: 2,
                    ..
                }
            ),
            "{found}"
        );
    }
    assert!(!world.is_broken());
    assert_eq!(hash, world.state_hash());
    world.delete(1);
    assert_eq!(world.fault(), None);
    run(&mut world, 10);
    assert_eq!(world.cycle_number(), 20);
}

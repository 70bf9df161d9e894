//! A world that has been in a checkpoint is the one that went in, whatever its contacts remember.

mod common;

use ballast::engine::World;
use ballast::engine::setup::{Body, Setup, TimeStepChoice};
use ballast::record::checkpoint::{decode, encode};
use common::*;

const SIDE: i32 = 45;

/// Spheres pressed together, each on its own way: more contacts than are written at a time.
fn crowd(law_name: &str, ledger: bool) -> Setup {
    let mut setup = scene(material(STIFFNESS, STIFFNESS, 0.3));
    setup.law = law(law_name);
    setup.body = Body::Sphere;
    setup.time_step = TimeStepChoice::Rayleigh;
    setup.ledger = ledger;
    for j in 0..SIDE {
        for i in 0..SIDE {
            let mut one = particle(
                1.99 * RADIUS * (f64::from(i) + 0.5 * f64::from(j % 2)),
                1.99 * RADIUS * 0.75f64.sqrt() * f64::from(j),
                RADIUS,
            );
            one.velocity = [f64::from(i * j % 7 - 3), f64::from(j * j % 5 - 2)];
            one.spin = f64::from(i % 3 - 1) * 1e-2;
            setup.particles.push(one);
        }
    }
    setup
}

#[test]
fn contacts_remember_to_the_bit() {
    for law_name in [
        "linear",
        "hertz-mindlin",
        "mindlin-deresiewicz",
        "mindlin-deresiewicz-exact",
    ] {
        for ledger in [false, true] {
            let mut world = World::build(crowd(law_name, ledger), 1).expect("the scene builds");
            run(&mut world, 20);
            assert!(world.contacts().len() > 4096, "{}", world.contacts().len());
            let bytes = encode(&world).expect("it can be written");
            let mut again: World = decode(&bytes).expect("it can be read");
            assert!(again.unpack(1), "{law_name}");
            assert_eq!(again.state_hash(), world.state_hash(), "{law_name}");
            run(&mut world, 20);
            run(&mut again, 20);
            assert_eq!(again.state_hash(), world.state_hash(), "{law_name}");
            assert_eq!(again.bookings(), world.bookings(), "{law_name}");
        }
    }
}

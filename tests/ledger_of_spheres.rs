//! The energy ledger of six hundred colliding spheres: it closes with the square of the step, and
//! every single booking in it is needed for that.

mod common;

use ballast::engine::World;
use ballast::engine::setup::{Body, Damping, Dashpot, LawChoice, Material, Setup, TimeStepChoice};
use common::*;

const RADIUS: f64 = 1e-3;

/// Speed of the spheres [m/s].
const SPEED: f64 = 0.5;

/// 25 x 24 spheres on a jittered lattice, flying about in a box of walls.
fn gas(law: LawChoice, frac: f64, damping: Damping) -> Setup {
    let mut setup = scene(Material {
        name: "glass".into(),
        density: 2650.0,
        young: Some(70e9),
        poisson: Some(0.25),
        ..material(1.0, 1.0, 0.3)
    });
    setup.law = law;
    setup.body = Body::Sphere;
    setup.time_step = TimeStepChoice::Rayleigh;
    setup.frac = frac;
    setup.damping = damping;
    setup.fracc_every = 1000;
    let mut state = 1u64;
    let mut random = move || {
        // Knuth's 64-bit linear congruence, upper bits.
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let pitch = 2.3 * RADIUS;
    for i in 0..25 {
        for j in 0..24 {
            let at = [
                pitch * (f64::from(i) + 0.5 + 0.1 * random()),
                pitch * (f64::from(j) + 0.5 + 0.1 * random()),
            ];
            let v = [2.0 * SPEED * random(), 2.0 * SPEED * random()];
            let radius = RADIUS * (1.0 - 0.3 * (random() + 0.5));
            setup
                .particles
                .push(moving(at[0], at[1], radius, v, 400.0 * random()));
        }
    }
    let [w, h] = [25.0 * pitch, 24.0 * pitch];
    let corners = [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]];
    for k in 0..4 {
        setup
            .walls
            .push(wall(&format!("w{k}"), corners[k], corners[(k + 1) % 4]));
    }
    setup
}

/// Entries of the balance at the end, and by how much they fail to add up, over the energy at first.
struct Balance {
    entries: [f64; 7],
    error: f64,
}

fn balance(law: LawChoice, frac: f64, damping: Damping) -> Balance {
    let mut world: World = world(gas(law, frac, damping));
    let opening = world.energies();
    let opening = opening.kinetic + opening.rotational + opening.transit;
    let cycles = (0.8e-3 / world.dt()).round() as u64;
    run(&mut world, cycles);
    // On to a moment at which springs are bent.
    while world.energies().elastic_normal < 1e-4 * opening
        || world.energies().elastic_tangential < 1e-5 * opening
    {
        run(&mut world, 1);
    }
    world.settle();
    let (e, b) = (world.energies(), world.bookings().expect("booked"));
    let entries = [
        e.kinetic + e.transit - opening,
        e.rotational,
        e.elastic_normal,
        e.elastic_tangential,
        b.friction_loss - b.slip_loss,
        b.slip_loss,
        b.damping_loss,
    ]
    .map(|entry| entry / opening);
    let sum: f64 = entries.iter().sum();
    assert!((sum.abs() - b.energy_error.abs()).abs() < 1e-9);
    Balance {
        entries,
        error: sum,
    }
}

fn check(law: &str, damping: Damping) {
    let coarse = balance(common::law(law), 0.1, damping);
    let fine = balance(common::law(law), 0.01, damping);
    assert!(coarse.error.abs() < 1e-4, "{law}: {:e}", coarse.error);
    assert!(fine.error.abs() < 1e-6, "{law}: {:e}", fine.error);
    let names = [
        "kinetic",
        "rotational",
        "elastic_normal",
        "elastic_tangential",
        "sliding",
        "slip",
        "dashpots",
    ];
    for (name, entry) in names.iter().zip(fine.entries) {
        let absent = *name == "dashpots" && damping.contact == Dashpot::None;
        assert!(
            absent || entry.abs() > 10.0 * fine.error.abs(),
            "{law}: without {name} the balance would be the same: {entry:e}"
        );
    }
}

#[test]
fn undamped_spheres() {
    for law in ["hertz-mindlin", "mindlin-deresiewicz-exact"] {
        check(law, Damping::default());
    }
}

#[test]
fn damped_spheres() {
    for law in ["hertz-mindlin", "mindlin-deresiewicz-exact"] {
        check(law, contact_damping(0.1));
        check(
            law,
            Damping {
                centred: true,
                tangential: Some(0.1),
                ..contact_damping(0.1)
            },
        );
    }
}

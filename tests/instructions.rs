//! Vector instructions change no bit: every law, with and without ledger, whatever the number of
//! threads.

mod common;

use ballast::engine::World;
use ballast::engine::contact::laws::LAWS;
use ballast::engine::lanes::Isa;
use ballast::engine::setup::{
    Body, Damping, Dashpot, Material, NormalForm, Setup, TimeStepChoice, Unloading,
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
        if card.name != "mindlin-deresiewicz-exact" {
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

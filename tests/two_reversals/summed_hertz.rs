//! What the summed normal force of 1989 costs.

use ballast::engine::contact::Normal;
use ballast::engine::contact::incremental_hertz::{IncrementalHertz, SummedHertz};
use ballast::engine::neighbours::Status;
use ballast::engine::setup::{Material, NormalForm, Unloading};

use crate::common::{material, moving, particle, run, spheres, world};
use crate::impact::{Form, Impact};
use crate::spheres::pair;

#[test]
fn rebound_loses_speed_with_the_step() {
    // Steps per contact and e_n of a normal impact, mean over the phase of first touch.
    for (steps, e) in [(10, 0.9275), (35, 0.9746), (100, 0.9908), (350, 0.9974)] {
        let impact = Impact::thesis(0.0);
        let phases = (0..8).map(|phase| {
            let [v_n, _] = impact.outgoing(steps, (f64::from(phase) + 0.5) / 8.0, Form::Summed);
            -v_n / impact.incoming[0]
        });
        let mean = phases.sum::<f64>() / 8.0;
        assert!((mean - e).abs() < 2e-4, "{steps}: {mean}");
        let [v_n, _] = impact.outgoing(steps, 0.5, Form::Total);
        assert!((-v_n / impact.incoming[0] - 1.0).abs() < 2e-3);
    }
}

#[test]
fn force_drifts_over_cycles_of_overlap() {
    // ±10 % of the overlap, each leg in as many steps as a contact of 35 steps takes for it.
    let pair = pair();
    let law = IncrementalHertz::new(pair.young_eff, pair.r_eff);
    let overlap = pair.overlap(88.0);
    for (steps, drift) in [(35, -2.1e-3), (350, -2.1e-4)] {
        let mut memory = SummedHertz::new(88.0);
        for i in 0..steps {
            let at = |i: usize| (std::f64::consts::TAU * i as f64 / steps as f64).sin();
            law.sum(0.1 * overlap * (at(i + 1) - at(i)), &mut memory);
        }
        let got = law.held(0.0, &memory) / 88.0 - 1.0;
        assert!((got / drift - 1.0).abs() < 0.05, "{got:e}");
    }
}

/// The sum is used up while the spheres still overlap: the shear and rolling springs beside it then let go of
/// what they hold, and all of it is booked.
#[test]
fn springs_beside_a_used_up_sum_are_booked() {
    for unloading in [Unloading::Rescale, Unloading::Keep] {
        let soft = Material {
            young: Some(7e7),
            rolling_friction: 0.1,
            ..material(1.0, 1.0, 0.5)
        };
        let mut setup = spheres("hertz-mindlin", soft);
        setup.normal = NormalForm::Incremental;
        setup.unloading = unloading;
        setup.particles = vec![
            moving(0.0, 0.0, 0.01, [3.0, 2.0], 0.0),
            particle(0.0205, 0.0, 0.01),
        ];
        let mut world = world(setup);
        let mut used_up = 0;
        for _ in 0..300 {
            run(&mut world, 1);
            let touches = world
                .contacts()
                .status
                .first()
                .is_some_and(|s| *s != Status::Apart);
            used_up += u32::from(
                touches && world.geometry(0).overlap > 0.0 && world.reaction(0).normal == 0.0,
            );
            let (books, losses) = (world.energies(), world.bookings().expect("kept"));
            let sums = [
                books.elastic_tangential,
                losses.friction_loss,
                losses.slip_loss,
            ];
            assert!(sums.iter().all(|sum| sum.is_finite()), "{sums:?}");
        }
        assert!(used_up > 0);
    }
}

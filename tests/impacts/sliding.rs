//! Impacts that slide throughout, from impulses alone; the numbers of the thesis' hand checks.

use ballast::engine::setup::{Body, Damping, Dashpot, LawChoice};

use crate::shots::Shot;

/// T = μ N throughout: v_t' = v_t - μ (1 + e) v_n and ω' = μ (1 + e) v_n R M/I, whatever the law.
#[test]
fn gross_sliding_follows_from_impulses() {
    for law in [
        LawChoice::HertzMindlin,
        LawChoice::MindlinDeresiewicz,
        LawChoice::MindlinDeresiewiczExact,
    ] {
        for body in [Body::Sphere, Body::Disc] {
            for (e, friction) in [(1.0, 0.12), (0.98, 0.092), (0.5, 0.4), (0.2, 0.3)] {
                let [vn, vt] = [0.1, 0.1 * friction * 14.0];
                let shot = Shot {
                    body,
                    friction,
                    velocity: [vn, vt],
                    damping: Damping {
                        contact: Dashpot::Restitution(e),
                        centred: true,
                        ..Damping::default()
                    },
                    phase: 0.5,
                    ..Shot::thesis(law, 0.0)
                };
                let flight = shot.fire();
                // With the restitution measured it is a matter of impulses: T = μ N in every step.
                let lost = friction * (vn + flight.v[0]);
                let (_, inertia) = shot.mass();
                assert!(
                    (flight.v[1] - (vt - lost)).abs() < 1e-9 * vt,
                    "{law:?} {body:?} {e}: {flight:?}"
                );
                let spin = -lost / (inertia * shot.radius);
                assert!((flight.spin / spin - 1.0).abs() < 1e-9, "{law:?} {body:?}");
                assert!((flight.v[0] / vn - e).abs() < 1e-3, "{law:?} {body:?} {e}");
            }
        }
    }
}

/// e = 1: sliding throughout begins at v_t/v_n = μ (7 - 1/κ), and nowhere below.
#[test]
fn sliding_throughout_begins_where_it_should() {
    let off = |share: f64| {
        let base = Shot::thesis(LawChoice::MindlinDeresiewiczExact, 0.0);
        let edge = base.friction * (7.0 - 1.0 / base.kappa());
        let shot = Shot {
            velocity: [0.4, share * edge * 0.4],
            ..base
        };
        let flight = shot.fire();
        let lost = (shot.velocity[1] - flight.v[1]) / (2.0 * shot.friction * shot.velocity[0]);
        (lost - 1.0).abs()
    };
    assert!(off(1.0) < 1e-4, "{}", off(1.0));
    assert!(off(1.2) < 1e-6, "{}", off(1.2));
    // The negative control: a little below it does stick for a while.
    assert!(off(0.95) > 1e-3, "{}", off(0.95));
}

//! Impacts that slide throughout, from impulses alone; the numbers of the thesis' hand checks.

use ballast::engine::setup::{Body, Damping, Dashpot};

use crate::common::law;
use crate::shots::Shot;

/// T = μ N throughout: v_t' = v_t - μ (1 + e) v_n and ω' = μ (1 + e) v_n R M/I.
///
/// The shear spring of the other laws starts from nothing where a strong dashpot makes N start with
/// a jump: they stick for the first steps and lose less, 7e-4 of v_t at e = 0.5.
#[test]
fn gross_sliding_follows_from_impulses() {
    for (name, strong) in [
        ("mindlin-deresiewicz-exact", 1e-9),
        ("mindlin-deresiewicz", 2e-3),
        ("hertz-mindlin", 2e-3),
    ] {
        for body in [Body::Sphere, Body::Disc] {
            for (e, friction, band) in [(1.0, 0.12, 1e-9), (0.98, 0.092, 1e-9), (0.5, 0.4, strong)]
            {
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
                    ..Shot::thesis(law(name), 0.0)
                };
                let flight = shot.fire();
                // With the restitution measured it is a matter of impulses.
                let lost = friction * (vn + flight.v[0]);
                let off = (flight.v[1] - (vt - lost)) / vt;
                assert!(off.abs() < band, "{name} {body:?} {e}: {off}");
                let (_, inertia) = shot.mass();
                let off = (flight.spin * inertia * shot.radius + lost) / vt;
                assert!(off.abs() < band, "{name} {body:?} {e}: {off}");
                let off = flight.v[0] / vn - e;
                assert!(off.abs() < 1e-3, "{name} {body:?} {e}: {off}");
            }
        }
    }
}

/// e = 1: sliding throughout begins at v_t/v_n = μ (7 - 1/κ), and nowhere below.
#[test]
fn sliding_throughout_begins_where_it_should() {
    let off = |share: f64| {
        let base = Shot::thesis(law("mindlin-deresiewicz-exact"), 0.0);
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

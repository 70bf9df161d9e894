//! The polygon of the forces on a particle.

use ballast::engine::setup::Gravity;
use ballast::measure::polygon::ForcePolygon;

use crate::packing::{K, box_of, built, close, compressed, run, setup};

#[test]
fn sides_go_round_the_particle() {
    // A disc in a corner with another on its shoulder; weight and an applied force pull at it.
    let s = 0.5f64.sqrt();
    let mut corner = setup(&[
        ([0.99, 0.98], 1.0),
        ([0.99 + 1.95 * s, 0.98 + 1.95 * s], 1.0),
    ]);
    corner.walls = box_of([0.0; 2], [9.0; 2]);
    corner.gravity = Some(Gravity::Uniform([0.0, -10.0]));
    corner.particles[0].force = [7.0, 0.0];
    let world = built(corner);
    let polygon = ForcePolygon::of(&world, 0);
    let by: Vec<&str> = polygon.sides.iter().map(|side| side.by.as_str()).collect();
    assert_eq!(by, ["2", "left", "bottom"]);
    let directions = polygon.sides.iter().map(|side| side.direction);
    for (found, exact) in directions.zip([45.0, 180.0, 270.0]) {
        assert!(close(found, exact, 1e-12, 1.0), "{found}");
    }
    let force = |k: usize| polygon.sides[k].force;
    assert!(close(force(0)[0], -0.05 * K * s, 1e-12, K) && close(force(1)[0], 0.01 * K, 1e-12, K));
    assert!(close(force(2)[1], 0.02 * K, 1e-12, K));
    let weight = 1000.0 * std::f64::consts::PI * 10.0;
    assert!(close(polygon.body[1], -weight, 1e-14, weight) && polygon.body[0] == 7.0);
    let corners = polygon.corners();
    assert_eq!(corners.len(), 5);
    assert_eq!(corners[0], [0.0; 2]);
    let gap = polygon.gap();
    assert!(
        close(gap[0], (0.01 - 0.05 * s) * K + 7.0, 1e-12, K),
        "{gap:?}"
    );
    // The other one feels the opposite.
    let other = ForcePolygon::of(&world, 1);
    assert_eq!((other.particle, other.sides.len()), (2, 1));
    assert_eq!(other.sides[0].force, force(0).map(|f| -f));
    assert_eq!(other.sides[0].direction, 225.0);
}

#[test]
fn what_does_not_close_is_out_of_balance() {
    let mut world = built(compressed(8, 8));
    run(&mut world, 500);
    let mut open = 0.0_f64;
    for p in 0..64 {
        let polygon = ForcePolygon::of(&world, p);
        let (gap, sum) = (polygon.gap(), world.particles().force[p].f);
        let scale = world.particles().force[p].scale;
        // The same few forces, in another order.
        assert!(
            (0..2).all(|k| close(gap[k], sum[k], 1e-14, scale)),
            "{gap:?} {sum:?}"
        );
        let turns = polygon.sides.windows(2);
        assert!(
            turns
                .into_iter()
                .all(|pair| pair[0].direction <= pair[1].direction)
        );
        open = open.max((gap[0].abs() + gap[1].abs()) / scale.max(1.0));
    }
    assert!(open > 1e-3, "something must be out of balance: {open}");
}

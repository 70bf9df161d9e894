//! What memory diagrams keep to on any path.

use proptest::prelude::*;

use super::polyline::{Node, ORIGIN};
use super::{Diagram, Partial};

/// Steps of overlap and displacement over the largest of the first and k times it.
fn walk() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let step = (0.05..1.0_f64, -0.3..0.3_f64).prop_map(|(overlap, d)| [overlap, d]);
    proptest::collection::vec(step, 1..60)
}

/// Overlap, friction and the rest of no special size.
fn law(friction: f64) -> Partial {
    Partial::new(3e9, 1.3, friction, 6)
}

const OVERLAP: f64 = 2e-5;

fn forward<const M: usize>(law: &Partial, walk: &[[f64; 2]], memory: &mut Diagram<M>) {
    for [overlap, d] in walk {
        law.advance(overlap * OVERLAP, d * OVERLAP, memory);
    }
}

/// Slopes of the segments in (η, δ/k) and in (N, T).
fn slopes<const M: usize>(law: &Partial, memory: &Diagram<M>) -> Vec<[f64; 2]> {
    let mut inner = ORIGIN;
    let slope = |outer: &Node| {
        let slopes = [
            (outer.shift - inner.shift) / (outer.overlap() - inner.overlap()),
            (outer.force - inner.force) / (law.load(outer.root) - law.load(inner.root)),
        ];
        inner = *outer;
        slopes
    };
    memory.nodes().iter().map(slope).collect()
}

/// A segment's slope is known to the rounding of its ends over its width.
fn at_most<const M: usize>(friction: f64, law: &Partial, memory: &Diagram<M>) {
    let mut inner = ORIGIN;
    for (outer, slopes) in memory.nodes().iter().zip(slopes(law, memory)) {
        let width = outer.overlap() - inner.overlap();
        let rounding = 1e-14 * memory.overlap() / width;
        for slope in slopes {
            assert!(slope.abs() <= friction * (1.0 + rounding), "{slope}");
        }
        inner = *outer;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(500) })]

    #[test]
    fn friction_bounds_slopes_and_force(walk in walk()) {
        let law = law(0.4);
        let mut memory = Diagram::<8>::default();
        for [overlap, d] in walk {
            let slip = law.advance(overlap * OVERLAP, d * OVERLAP, &mut memory);
            let limit = 0.4 * law.load(memory.top().root);
            prop_assert!(slip.force.abs() <= limit * (1.0 + 1e-15));
            // The books of dropped nodes, part of `micro`, have either sign.
            prop_assert!(slip.gross >= 0.0 && law.energy(&memory) >= 0.0);
            prop_assert!(memory.len() <= 6);
            let nodes = memory.nodes();
            prop_assert!(nodes.windows(2).all(|pair| pair[0].root < pair[1].root));
            at_most(0.4, &law, &memory);
        }
    }

    /// Steps that vanish beside what they are added to, as those of an assembly at rest: they may run
    /// along a segment of the same slope, where a share of it would be nought over nought.
    #[test]
    fn vanishing_steps_change_nothing(walk in walk(), sizes in proptest::collection::vec(-1.0..1.0_f64, 1..40)) {
        let law = law(0.4);
        let mut memory = Diagram::<8>::default();
        forward(&law, &walk, &mut memory);
        let before = law.force(&memory);
        let limit = 0.4 * law.load(memory.top().root);
        for size in sizes {
            let slip = law.advance(memory.overlap(), size * 1e-17 * OVERLAP, &mut memory);
            prop_assert!((slip.force - before).abs() <= 1e-12 * limit, "{} {before}", slip.force);
        }
    }

    /// With room for every corner a step loses energy or none. What is merged as negligible may
    /// give some of its 1e-9.
    #[test]
    fn slip_loses_energy(walk in walk()) {
        let law = Partial::new(3e9, 1.3, 0.4, 64);
        let mut memory = Diagram::<64>::default();
        for [overlap, d] in walk {
            let slip = law.advance(overlap * OVERLAP, d * OVERLAP, &mut memory);
            let scale = 0.4 * law.load(OVERLAP.sqrt()) * 0.4 * 1.3 * OVERLAP;
            prop_assert!(slip.gross >= 0.0 && slip.micro >= -1e-9 * scale, "{:?} {}", slip, scale);
        }
    }

    #[test]
    fn mirrored_paths_have_mirrored_bits(walk in walk()) {
        let law = law(0.4);
        let (mut memory, mut mirrored) = (Diagram::<8>::default(), Diagram::<8>::default());
        for [overlap, d] in walk {
            let slip = law.advance(overlap * OVERLAP, d * OVERLAP, &mut memory);
            let other = law.advance(overlap * OVERLAP, -d * OVERLAP, &mut mirrored);
            prop_assert_eq!(slip.force, -other.force);
            prop_assert_eq!([slip.gross, slip.micro], [other.gross, other.micro]);
            prop_assert_eq!(law.energy(&memory), law.energy(&mirrored));
        }
    }

    #[test]
    fn nothing_happens_to_a_contact_at_rest(walk in walk()) {
        let law = law(0.4);
        let mut memory = Diagram::<8>::default();
        forward(&law, &walk, &mut memory);
        let before = memory;
        // Its overlap is the square of the root that is kept: a rounding off at most.
        let slip = law.advance(walk[walk.len() - 1][0] * OVERLAP, 0.0, &mut memory);
        prop_assert_eq!(slip.force, before.top().force);
        prop_assert_eq!([slip.gross, slip.micro], [0.0; 2]);
        prop_assert_eq!(memory, before);
    }

    /// Lower friction slips in place: the limit holds, energy is lost and none made.
    #[test]
    fn lowered_friction_slips(walk in walk(), share in 0.05..0.95_f64) {
        let high = law(0.4);
        let mut memory = Diagram::<8>::default();
        forward(&high, &walk, &mut memory);
        let before = memory;
        let friction = 0.4 * share;
        let low = law(friction);
        let slip = low.advance(memory.overlap(), 0.0, &mut memory);
        at_most(friction, &low, &memory);
        let scale = high.energy(&before);
        let lost = slip.gross + slip.micro;
        prop_assert!((lost - (scale - low.energy(&memory))).abs() <= 1e-12 * scale);
        prop_assert!(lost >= -1e-12 * scale, "{} {}", lost, scale);
        let force = before.top().force.abs();
        prop_assert!(slip.force.abs() <= force * (1.0 + 1e-14));
        // Slopes that were low enough are left alone.
        if slopes(&high, &before).iter().flatten().all(|slope| slope.abs() < friction) {
            prop_assert_eq!(memory.nodes(), before.nodes());
        }
    }

    #[test]
    fn checkpoints_keep_every_bit(walk in walk()) {
        let law = law(0.4);
        let mut memory = Diagram::<8>::default();
        forward(&law, &walk, &mut memory);
        let bytes = postcard::to_stdvec(&memory).expect("written");
        let again: Diagram<8> = postcard::from_bytes(&bytes).expect("read");
        prop_assert_eq!(again, memory);
        // Unused nodes are not written: friction, the number of nodes, and 32 bytes each.
        prop_assert_eq!(bytes.len(), 8 + 1 + 32 * memory.len());
        prop_assert_eq!(postcard::from_bytes::<Diagram<1>>(&bytes).is_err(), memory.len() > 1);
    }
}

/// Sheared and made smoother, a contact is what it would be had it been smoother all along.
#[test]
fn smoother_after_shear_is_shear_when_smoother() {
    let (high, low) = (law(0.4), law(0.25));
    for d in [0.05, 0.2, 0.3, 0.6] {
        let (mut memory, mut other) = (Diagram::<8>::default(), Diagram::<8>::default());
        for memory in [&mut memory, &mut other] {
            high.advance(OVERLAP, 0.0, memory);
        }
        high.advance(OVERLAP, d * OVERLAP, &mut memory);
        let sheared = high.energy(&memory);
        let after = low.advance(OVERLAP, 0.0, &mut memory);
        let slip = low.advance(OVERLAP, d * OVERLAP, &mut other);
        let limit = 0.25 * low.load(OVERLAP.sqrt());
        assert!((after.force - slip.force).abs() < 1e-14 * limit, "{d}");
        assert_eq!(after.sliding, slip.sliding);
        assert!(after.gross + after.micro > 0.0 && low.energy(&memory) < sheared);
    }
}

/// What is locked in the middle does not make an edge slip that was free of load.
#[test]
fn a_core_under_load_does_not_raise_the_force() {
    let (high, low) = (law(0.4), law(0.02));
    let mut memory = Diagram::<8>::default();
    high.advance(0.05 * OVERLAP, 0.5 * OVERLAP, &mut memory);
    let locked = high.advance(OVERLAP, 0.0, &mut memory).force;
    let after = low.advance(OVERLAP, 0.0, &mut memory);
    assert!((after.force / locked - 0.05).abs() < 1e-14, "{after:?}");
    assert!(after.micro > 0.0 && after.gross == 0.0);
}

#[test]
fn no_friction_no_force() {
    let (rough, smooth) = (law(0.4), law(0.0));
    let mut memory = Diagram::<8>::default();
    let slip = smooth.advance(OVERLAP, OVERLAP, &mut memory);
    assert_eq!(slip, crate::engine::contact::slipped::Slipped::default());
    // Roughened, it begins without force; made smooth again, it loses what it stored.
    rough.advance(OVERLAP, 0.1 * OVERLAP, &mut memory);
    let stored = rough.energy(&memory);
    assert!(rough.force(&memory) > 0.0 && stored > 0.0);
    let slip = smooth.advance(0.7 * OVERLAP, 0.1 * OVERLAP, &mut memory);
    assert_eq!([slip.force, slip.gross, slip.micro], [0.0, stored, 0.0]);
    assert_eq!(smooth.energy(&memory), 0.0);
    assert_eq!(memory.len(), 1);
}

/// A seed is what loading at constant overlap makes, sliding or not.
#[test]
fn seeds_are_virgin_contacts() {
    let law = law(0.4);
    let mut memory = Diagram::<8>::default();
    let limit = 0.4 * law.load(OVERLAP.sqrt());
    law.advance(OVERLAP, 0.0, &mut memory);
    for d in [0.1, 0.1, 0.1, 0.5] {
        law.advance(OVERLAP, -d * OVERLAP, &mut memory);
        let seed: Diagram<8> = law.seed(OVERLAP, law.force(&memory));
        assert!((law.force(&seed) - law.force(&memory)).abs() < 1e-15 * limit);
        // And the same on the way back.
        let (mut a, mut b) = (memory, seed);
        let back = 0.3 * OVERLAP;
        let forces = [
            law.advance(OVERLAP, back, &mut a),
            law.advance(OVERLAP, back, &mut b),
        ];
        // Close to sliding the front is the cube root of a difference: 1e-16 become 1e-11 of η.
        assert!(
            (forces[0].force - forces[1].force).abs() < 1e-10 * limit,
            "{d} {forces:?} {limit}"
        );
        assert!((law.energy(&a) - law.energy(&b)).abs() < 1e-10 * limit * OVERLAP);
    }
    let seed: Diagram<8> = law.seed(OVERLAP, 3.0 * limit);
    assert!((law.force(&seed) - limit).abs() < 1e-15 * limit);
}

/// The stiffness is that of the first instant of a displacement, and no other exceeds it.
#[test]
fn stiffness_is_the_largest() {
    let law = law(0.4);
    let mut memory = Diagram::<8>::default();
    law.advance(OVERLAP, 0.0, &mut memory);
    let d = 1e-4 * OVERLAP;
    let mut secant = f64::INFINITY;
    for _ in 0..5 {
        let before = law.force(&memory);
        let next = (law.advance(OVERLAP, d, &mut memory).force - before) / d;
        assert!(next < secant && next < law.stiffness(OVERLAP));
        assert!(next > 0.99 * law.stiffness(OVERLAP));
        secant = next;
    }
}

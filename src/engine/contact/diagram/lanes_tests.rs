//! Lanes against contacts alone, to the bit.
#![allow(
    unsafe_code,
    reason = "memories of a block by pointer, as the loop does"
)]

use proptest::prelude::*;

use super::{Diagram, Partial, PartialLanes};
use crate::engine::lanes::{Lanes, Scalars};

const OVERLAP: f64 = 2e-5;

/// Small and large steps, forwards, backwards and none, as shares of the overlap.
fn walk() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let step = (
        prop_oneof![0.05..1.0_f64, 0.70..0.71_f64, Just(0.7)],
        prop_oneof![-0.3..0.3_f64, -1e-3..1e-3_f64, 1e-7..1e-5_f64, Just(0.0)],
    );
    proptest::collection::vec(step.prop_map(|(overlap, d)| [overlap, d]), 1..80)
}

/// Four contacts of different size that walk together, one of them under another friction than the
/// step before every now and then, one that does not always touch.
fn together<V: Lanes>(walks: &[Vec<[f64; 2]>; 4]) {
    let law = |lane: usize, step: usize| {
        let friction = if lane == 1 && step % 9 == 8 { 0.2 } else { 0.4 };
        Partial::new(3e9 * (1.0 + lane as f64), 1.3, friction, 6).booked(false)
    };
    let mut alone = [Diagram::<8>::default(); 4];
    let mut lanes = alone;
    let steps = walks.iter().map(Vec::len).min().unwrap_or(0);
    let all = |step: usize| walks.each_ref().map(|walk| walk[step]);
    for (step, now) in (0..steps).map(|step| (step, all(step))) {
        let mut overlap = [0.7 * OVERLAP; 8];
        let mut d = [0.0; 8];
        let (mut hertz, mut per, mut friction) = ([0.0; 8], [0.0; 8], [0.0; 8]);
        for lane in 0..4 {
            let [o, t] = now[lane];
            (overlap[lane], d[lane]) = (o * OVERLAP, t * OVERLAP);
            [hertz[lane], per[lane], friction[lane]] = law(lane, step).of_lanes();
        }
        let touching = if step % 5 == 3 { 0b1011 } else { 0b1111 };
        for from in (0..4).step_by(V::COUNT) {
            let at = |numbers: &[f64; 8]| {
                let mut moved = [0.0; 8];
                moved[..V::COUNT].copy_from_slice(&numbers[from..from + V::COUNT]);
                V::of(&moved)
            };
            let block = PartialLanes {
                hertz: at(&hertz),
                per_compliance: at(&per),
                friction: at(&friction),
            };
            let bits = touching >> from & ((1 << V::COUNT) - 1);
            // SAFETY: `from` + COUNT is at most 4.
            let (force, sliding) = unsafe {
                let memory = lanes.as_mut_ptr().add(from);
                block.advance(bits, at(&overlap), at(&d), memory, |lane| {
                    law(from + lane, step)
                })
            };
            for lane in (0..V::COUNT).filter(|lane| bits >> lane & 1 == 1) {
                let k = from + lane;
                let slip = law(k, step).advance(overlap[k], d[k], &mut alone[k]);
                assert_eq!(slip.force.to_bits(), force.numbers()[lane].to_bits());
                assert_eq!(slip.sliding, sliding >> lane & 1 == 1);
            }
        }
        assert_eq!(alone, lanes, "step {step}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn lanes_do_what_contacts_do_alone(walks in prop::array::uniform4(walk())) {
        together::<f64>(&walks);
        together::<Scalars>(&walks);
    }
}

//! Lanes against contacts alone, to the bit.

use proptest::prelude::*;

use super::{Branch, ReversalLanes, Reversals, TwoReversals, held};
use crate::engine::lanes::{Lanes, Scalars};

const OVERLAP: f64 = 2e-5;

/// Small and large steps, forwards, backwards and none, as shares of the overlap.
fn walk() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let step = (
        prop_oneof![0.05..1.0_f64, 0.70..0.71_f64, Just(0.7)],
        prop_oneof![
            -0.3..0.3_f64,
            -0.05..0.05_f64,
            -1e-3..1e-3_f64,
            1e-7..1e-5_f64,
            Just(0.0)
        ],
    );
    proptest::collection::vec(step.prop_map(|(overlap, d)| [overlap, d]), 1..80)
}

/// Laws of different size and friction; the last has none every now and then.
fn law(lane: usize, step: usize) -> TwoReversals {
    let friction = if lane == 3 && step % 9 == 8 {
        0.0
    } else {
        0.2 + 0.1 * lane as f64
    };
    TwoReversals::new(3e9 * (1.0 + lane as f64), 1.3e9, 0.01, friction)
}

fn numbers(memory: &Reversals) -> Vec<u64> {
    let mut numbers = Vec::new();
    memory.numbers(&mut |number| numbers.push(number.to_bits()));
    numbers
}

/// What has been seen: branches, and sliding.
type Seen = [u64; 4];

/// Four contacts that walk together, one of which does not always touch.
fn together<V: Lanes>(walks: &[Vec<[f64; 2]>; 4]) -> Seen {
    let mut seen = Seen::default();
    let mut alone = [Reversals::default(); 4];
    let mut lanes = alone;
    let steps = walks.iter().map(Vec::len).min().unwrap_or(0);
    for (step, now) in (0..steps).map(|step| (step, walks.each_ref().map(|walk| walk[step]))) {
        let touching = if step % 5 == 3 { 0b1011 } else { 0b1111 };
        for from in (0..4).step_by(V::COUNT) {
            let at = |number: &dyn Fn(usize) -> f64| {
                let mut numbers = [1.0; 8];
                for (lane, place) in numbers.iter_mut().enumerate().take(V::COUNT) {
                    *place = number(from + lane);
                }
                V::of(&numbers)
            };
            let block = TwoReversals {
                limit: at(&|k| law(k, step).limit),
                shear: at(&|k| law(k, step).shear),
                kappa: at(&|k| law(k, step).kappa),
                friction: at(&|k| law(k, step).friction),
            };
            let held = lanes;
            let mut memory = ReversalLanes {
                overlap: at(&|k| held[k].overlap),
                force: at(&|k| held[k].force),
                unloaded_from: at(&|k| held[k].unloaded_from),
                reloaded_from: at(&|k| held[k].reloaded_from),
                shortfall: at(&|k| held[k].shortfall),
                branch: at(&|k| f64::from(held[k].branch as u8)),
            };
            let bits = touching >> from & ((1 << V::COUNT) - 1);
            let slip = block.advance_together(
                V::mask(bits),
                at(&|k| now[k][0] * OVERLAP),
                at(&|k| now[k][1] * OVERLAP),
                &mut memory,
            );
            let [force, gross, micro] = [slip.force, slip.gross, slip.micro].map(V::numbers);
            for lane in (0..V::COUNT).filter(|lane| bits >> lane & 1 == 1) {
                let k = from + lane;
                let [overlap, d] = now[k].map(|share| share * OVERLAP);
                let one = law(k, step).advance(overlap, d, &mut alone[k]);
                let want = [one.force, one.gross, one.micro].map(f64::to_bits);
                let got = [force[lane], gross[lane], micro[lane]].map(f64::to_bits);
                assert_eq!(want, got, "step {step}, contact {k}: {one:?}");
                assert_eq!(one.sliding, V::bits(slip.sliding) >> lane & 1 == 1);
                lanes[k] = held::lane(&memory.numbers(), lane);
                assert_eq!(numbers(&alone[k]), numbers(&lanes[k]), "step {step}");
                seen[alone[k].branch as usize] += 1;
                seen[3] += u64::from(one.sliding);
            }
        }
    }
    seen
}

#[test]
fn lanes_do_what_contacts_do_alone() {
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig {
        failure_persistence: None,
        ..ProptestConfig::with_cases(400)
    });
    let total = std::cell::Cell::new(Seen::default());
    runner
        .run(&prop::array::uniform4(walk()), |walks| {
            let seen = together::<f64>(&walks);
            prop_assert_eq!(seen, together::<Scalars>(&walks));
            let before = total.get();
            total.set(std::array::from_fn(|k| before[k] + seen[k]));
            Ok(())
        })
        .expect("the same bits");
    let total = total.get();
    assert!(total.iter().all(|count| *count > 500), "{total:?}");
    assert_eq!(Branch::Reloading as usize, 2);
}

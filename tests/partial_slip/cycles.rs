//! Closed cycles in overlap and displacement never give energy.

use ballast::engine::contact::diagram::Partial;
use proptest::prelude::*;

use crate::rig::Rig;

/// Steps of a leg.
const STEPS: usize = 100;

/// μ = k = 1, N = α^1.5.
fn unit() -> Rig {
    Rig::new(Partial::new(1.0, 1.0, 1.0, 16))
}

/// Work per leg that the mean force of finite steps may show for nothing. A leg of length l under
/// stiffness k has an error of l² k/12 n² and less, with l <= 2 and k <= 1.5 √1.5; once in a while a
/// corner adds some. Of 2000 paths the worst used a fifth.
const LEEWAY: f64 = 1.0 / (STEPS * STEPS) as f64;

fn corners() -> impl Strategy<Value = Vec<[f64; 2]>> {
    proptest::collection::vec(
        (0.02..1.5_f64, -1.0..1.0_f64).prop_map(|(a, d)| [a, d]),
        2..8,
    )
}

/// Work that a spring without slip does on a path, if its force stays when the overlap changes.
fn work_if_force_is_kept(path: &[[f64; 2]]) -> f64 {
    let (mut at, mut force, mut work) = ([0.0; 2], 0.0_f64, 0.0);
    for &[overlap, delta] in path {
        for k in 1..=STEPS {
            let s = k as f64 / STEPS as f64;
            let (now, d) = (
                at[0] + s * (overlap - at[0]),
                (delta - at[1]) / STEPS as f64,
            );
            let limit = now * now.sqrt();
            let next = (force + 1.5 * now.sqrt() * d).clamp(-limit, limit);
            work += 0.5 * (force + next) * d;
            force = next;
        }
        at = [overlap, delta];
    }
    work
}

/// The control: sheared where it is stiff and back where it is soft, such a law gives energy, far
/// more than the leeway. The exact one takes some.
#[test]
fn a_law_that_keeps_the_force_gives_energy() {
    let cycle = [
        [1.0, 0.0],
        [1.0, 0.23],
        [0.5, 0.23],
        [0.5, -0.09],
        [1e-9, -0.09],
        [1e-9, 0.0],
    ];
    let gain = -work_if_force_is_kept(&cycle);
    assert!(gain > 20.0 * LEEWAY * cycle.len() as f64, "{gain}");
    let mut rig = unit();
    for [a, d] in cycle {
        rig.line(a, d, STEPS);
    }
    assert!(rig.work > 0.0, "{}", rig.work);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    /// From a first touch to the last, displacement back where it was.
    #[test]
    fn from_touch_to_parting(corners in corners()) {
        let mut rig = unit();
        for [a, d] in &corners {
            rig.line(*a, *d, STEPS);
        }
        rig.line(1e-9, 0.0, STEPS);
        let leeway = LEEWAY * (corners.len() + 1) as f64;
        prop_assert!(rig.work > -leeway, "{} {leeway}", rig.work);
        prop_assert!(rig.lost[0] >= 0.0 && rig.lost[1] >= 0.0);
        prop_assert!(rig.residual().abs() < leeway, "{} {leeway}", rig.residual());
    }

    /// Under load, again and again: after a first round the state comes back.
    #[test]
    fn under_load(corners in corners()) {
        let mut rig = unit();
        let mut rounds = Vec::new();
        for _ in 0..3 {
            for [a, d] in &corners {
                rig.line(*a, *d, STEPS);
            }
            rounds.push(rig);
        }
        let leeway = LEEWAY * corners.len() as f64;
        let load = rig.at[0] * rig.at[0].sqrt();
        let [a, b] = [rounds[1].force, rounds[2].force];
        prop_assert!((a - b).abs() < 1e-12 * load, "{a} {b}");
        let work = rounds[2].work - rounds[1].work;
        prop_assert!(work > -leeway, "{work} {leeway}");
    }
}

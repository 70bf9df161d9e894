//! Whether particles that are neighbours in place are neighbours in memory.

use super::Report;
use crate::engine::World;
use crate::engine::contact_report::Other;
use crate::scene::{MANY_FOR_ORDER, order_along_curve};

/// Numbers of neighbours may lie so many times as far apart as along the curve before it is said. Rows of a
/// lattice are as good as the curve; numbers at random have a third of all particles in between, 40 times as
/// many as the curve among 5000 and more among more of them.
const POOR: f64 = 5.0;

/// Fewer pairs than so many tell little: on the curve a few of them lie very far apart.
const PAIRS: usize = 1_000;

/// Warns of numbers that have little to do with places.
pub(super) fn describe(report: &mut Report, world: &World) {
    let rows = &world.particles().row;
    let count = world.particles().len();
    if count < MANY_FOR_ORDER {
        return;
    }
    let pair = |k| match world.bodies(k) {
        (i, Other::Particle(j)) => Some([i, j]),
        (_, Other::Wall(_)) => None,
    };
    let pairs: Vec<[usize; 2]> = (0..world.contacts().len()).filter_map(pair).collect();
    if pairs.len() < PAIRS {
        return;
    }
    let mut sorted: Vec<usize> = (0..count).collect();
    order_along_curve(&mut sorted, |&p| rows[p].x);
    let mut place = vec![0; count];
    for (along, &p) in sorted.iter().enumerate() {
        place[p] = along;
    }
    let mean = |number: &dyn Fn(usize) -> usize| -> f64 {
        let apart = pairs.iter().map(|&[i, j]| number(i).abs_diff(number(j)));
        apart.sum::<usize>() as f64 / pairs.len() as f64
    };
    let (own, curve) = (mean(&|p| p), mean(&|p| place[p]));
    if own > POOR * curve {
        report.warnings.push(format!(
            "the numbers of neighbours differ by {own:.0} on average, along a curve it would be {curve:.0}: \
             neighbours are far apart in memory, and a cycle takes up to twice as long; import with order = \
             \"curve\" in [[generate]] numbers particles anew"
        ));
    }
}

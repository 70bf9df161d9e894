//! A sample in a periodic cell, repeated along the edges of the cell: as many particles as wanted, at rest
//! at once.

use super::trouble;
use crate::engine::boundary::{Boundary, Kind};
use crate::engine::setup::ParticleSetup;
use crate::language::command::MOST_GENERATED;
use crate::scene::{Sample, Trouble, order_along_curve};

/// The sample so often along its two edges; particles are numbered along a curve through all copies.
pub(super) fn repeated(sample: Sample, [across, up]: [u32; 2]) -> Result<Sample, Trouble> {
    if [across, up] == [1, 1] {
        return Ok(sample);
    }
    let Some(Boundary {
        kind: Kind::Cell(cell),
        ..
    }) = &sample.boundary
    else {
        return Err(trouble(
            "repeat",
            "`repeat` repeats a sample along the edges of its cell, and it has none".into(),
            "expected a sample in a periodic cell",
            "leave it out, or start from a preset with [cell]",
        ));
    };
    let count = u64::from(across) * u64::from(up) * sample.particles.len() as u64;
    if count > MOST_GENERATED {
        return Err(trouble(
            "repeat",
            format!("the sample so often has {count} particles"),
            &format!("expected {MOST_GENERATED} at most"),
            "repeat it less often",
        ));
    }
    let [a, b] = cell.edges;
    let copies = (0..up).flat_map(|j| (0..across).map(move |i| [f64::from(i), f64::from(j)]));
    let shifts = copies.map(|[i, j]| [0, 1].map(|k| i * a[k] + j * b[k]));
    // Home first: a particle that has left the cell would lie outside the larger one, too.
    let home: Vec<ParticleSetup> = (sample.particles.iter())
        .map(|(_, particle)| ParticleSetup {
            at: cell.home(particle.at),
            ..particle.clone()
        })
        .collect();
    let all = shifts.flat_map(|shift| {
        home.iter().map(move |particle| ParticleSetup {
            at: [particle.at[0] + shift[0], particle.at[1] + shift[1]],
            ..particle.clone()
        })
    });
    let mut all: Vec<ParticleSetup> = all.collect();
    order_along_curve(&mut all, |particle| particle.at);
    let particles = (1..).zip(all).collect();
    let mut cell = cell.clone();
    cell.edges = [
        a.map(|x| f64::from(across) * x),
        b.map(|x| f64::from(up) * x),
    ];
    let middle = |k: usize| cell.corner[k] + 0.5 * (cell.edges[0][k] + cell.edges[1][k]);
    let boundary = sample.boundary.clone().map(|boundary| Boundary {
        centre: [middle(0), middle(1)],
        kind: Kind::Cell(cell.clone()),
        ..boundary
    });
    Ok(Sample {
        particles,
        boundary,
        ..sample
    })
}

//! One direct stress that is held while the other direction is strained, in a cell and in a ring; and the
//! same along the other axis.

use std::fmt::Write;

use crate::common::Random;
use crate::grains::{grains, ran, to_rest};

/// Stress that is held [Pa].
const LATERAL: f64 = 1e5;

/// 200 spheres compressed to 100 kPa, at rest with friction, then compressed along direction 1 while the
/// stress along 2 is held: its mean over the second half is that, and the other one rises.
fn held(boundary: &str, place: &str) {
    let (grains, rest) = (grains(place), to_rest("servo s11 1e5 s22 1e5 shear 0"));
    let session = ran(&format!(
        r#"
        {grains}
        {boundary}
        [history]
        every = 100
        columns = ["stress_11", "stress_22", "strain_11", "strain_22"]
        {rest}
        [[stage]]
        name = "axial"
        do = ["servo s22 1e5 gain 8", "strain rate 0.84 0 0 0 over 1000"]
        max_cycles = 25_000
        "#
    ));
    let recording = session.recording();
    let of_stage = |stage: u32| {
        let rows = recording.rows().iter().enumerate();
        let rows = rows.filter(move |(_, row)| row.stage == stage);
        rows.map(|(k, _)| [0, 1, 2, 3].map(|column| recording.value(k, column)))
            .collect::<Vec<_>>()
    };
    let rest = *of_stage(2).last().expect("a stage of the preset");
    for stress in &rest[..2] {
        assert!((stress / LATERAL - 1.0).abs() < 0.01, "at rest: {rest:?}");
    }
    let rows = of_stage(3);
    let second = &rows[rows.len() / 2..];
    let mean =
        |column: usize| second.iter().map(|row| row[column]).sum::<f64>() / second.len() as f64;
    assert!((mean(1) / LATERAL - 1.0).abs() < 0.01, "{}", mean(1));
    // Negative control: without the servo it would have gone the way of the other stress.
    assert!(
        mean(0) > 1.4 * LATERAL,
        "it was hardly compressed: {}",
        mean(0)
    );
    // The servo moves direction 2 alone; direction 1 goes as it was told.
    let last = rows[rows.len() - 1];
    let told = 0.84 * session.world().dt() * (25_000.0 - 500.5) + rest[2];
    assert!((last[2] / told - 1.0).abs() < 1e-6, "{last:?} {told}");
    assert!(last[3] < rest[3], "it did not widen: {last:?}");
}

#[test]
fn a_cell_holds_one_stress() {
    held(
        "[cell]\nsize = [0.021, 0.021]\ncorner = [-0.0105, -0.0105]",
        "{ rectangle = { min = [-0.0105, -0.0105], max = [0.0105, 0.0105] } }",
    );
}

#[test]
fn a_ring_holds_one_stress() {
    held(
        "[boundary]\nkind = \"circle\"\nradius = 0.0116\n\
         [[measure]]\nname = \"core\"\ncircle = { centre = [0, 0], radius = 0.0085 }",
        "{ circle = { centre = [0, 0], radius = 0.0121 } }",
    );
}

/// Discs near a hexagonal lattice in a cell, or all of that turned by a right angle.
fn turned(turn: bool) -> Vec<[f64; 2]> {
    let place = |[x, y]: [f64; 2]| if turn { [-y, x] } else { [x, y] };
    let (side, rise) = (0.01, 0.01 * 0.75f64.sqrt());
    let mut random = Random(7);
    let mut particles = String::new();
    for row in 0..8 {
        for column in 0..8 {
            let shift = 0.25 + 0.5 * f64::from(row % 2);
            let at = [
                side * (f64::from(column) + shift + random.between(-0.001, 0.001)),
                rise * (f64::from(row) + 0.5 + random.between(-0.001, 0.001)),
            ];
            let at = place(at);
            let _ = writeln!(
                particles,
                "[[particle]]\nat = {at:?}\nradius = {}\nmaterial = \"disc\"",
                0.005 * (1.0 + random.between(0.001, 0.003))
            );
        }
    }
    let size = [8.0 * side, 8.0 * rise];
    let (size, corner, servo, rate) = if turn {
        ([size[1], size[0]], [-size[1], 0.0], "s11", "0 0 0 0.05")
    } else {
        (size, [0.0; 2], "s22", "0.05 0 0 0")
    };
    let session = ran(&format!(
        r#"
        [model]
        law = "linear"
        body = "disc"
        frac = 0.1
        [damping]
        contact = 0.2
        [material.disc]
        density = 1000
        normal_stiffness = 1e8
        shear_stiffness = 5e7
        friction = 0.3
        {particles}
        [cell]
        size = {size:?}
        corner = {corner:?}
        [history]
        every = 10
        columns = ["stress_11", "stress_22"]
        [[stage]]
        name = "axial"
        do = ["servo {servo} 2e5 gain 4", "strain rate {rate} over 100"]
        max_cycles = 4000
        "#
    ));
    let recording = session.recording();
    let rows = 0..recording.rows().len();
    rows.map(|k| {
        let stress = [recording.value(k, 0), recording.value(k, 1)];
        if turn { [stress[1], stress[0]] } else { stress }
    })
    .collect()
}

#[test]
fn the_axes_are_alike() {
    let (along, across) = (turned(false), turned(true));
    assert_eq!(along.len(), across.len());
    let last = along[along.len() - 1];
    assert!((last[1] / 2e5 - 1.0).abs() < 0.05, "{last:?}");
    assert!((last[0] / last[1] - 1.0).abs() > 0.1, "{last:?}");
    // Coordinates change places and signs: no sum is taken in another order.
    assert_eq!(along, across);
}

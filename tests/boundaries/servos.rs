//! Servos that hold and follow a stress while a sample is sheared, by a ring, by walls and in a cell.

use crate::grains::{grains, ran, to_rest};

/// Mean stress that is held [Pa].
const PRESSURE: f64 = 1e5;

const SQUARE: &str = "{ rectangle = { min = [-0.0105, -0.0105], max = [0.0105, 0.0105] } }";

const STAGES: [&str; 8] = [
    "gather",
    "compress",
    "rest",
    "shear",
    "back",
    "unload",
    "path",
    "path-back",
];

/// A row of the history.
struct Row {
    stage: &'static str,
    /// Cycles in the stage.
    cycle: f64,
    mean: f64,
    deviator: f64,
    shear: f64,
}

/// 200 spheres of the thesis' graded assembly, compressed, at rest with friction, sheared at constant
/// mean stress and back again, then along a stress path that turns twice. All its stresses.
fn tested(boundary: &str, place: &str) -> Vec<Row> {
    let (grains, rest) = (grains(place), to_rest("servo mean 1e5 deviator 0 shear 0"));
    let preset = format!(
        r#"
        {grains}
        {boundary}
        [history]
        every = 100
        columns = ["stress_11", "stress_22", "stress_12", "stress_21"]
        {rest}
        [[stage]]
        name = "shear"
        do = ["servo mean 1e5 gain 8", "strain rate -0.42 0 0 0.42 over 1000"]
        max_cycles = 25_000
        [[stage]]
        name = "back"
        do = ["strain rate 0.42 0 0 -0.42 over 1000"]
        max_cycles = 15_000
        [[stage]]
        name = "unload"
        do = ["strain rate 0 0 0 0", "servo mean 1e5 deviator 0 shear 0 over 10000 gain 8"]
        max_cycles = 20_000
        [[stage]]
        name = "path"
        do = ["servo mean 1e5 deviator 3e4 shear 0 over 20000 gain 32"]
        max_cycles = 20_000
        [[stage]]
        name = "path-back"
        do = ["servo mean 1e5 deviator -3e4 shear 0 over 40000 gain 32"]
        max_cycles = 40_000
        "#
    );
    let session = ran(&preset);
    let recording = session.recording();
    let rows = recording.rows().iter().enumerate();
    rows.map(|(k, row)| Row {
        stage: STAGES[row.stage as usize],
        cycle: row.stage_cycle as f64,
        mean: 0.5 * (recording.value(k, 0) + recording.value(k, 1)),
        deviator: recording.value(k, 0) - recording.value(k, 1),
        shear: 0.5 * (recording.value(k, 2) + recording.value(k, 3)),
    })
    .collect()
}

/// Largest of something in a stage, over the mean stress that is held.
fn most(rows: &[Row], stage: &str, what: impl Fn(&Row) -> f64) -> f64 {
    let rows = rows.iter().filter(|row| row.stage == stage);
    rows.map(what).fold(0.0, |most, x| x.abs().max(most)) / PRESSURE
}

/// Mean stress within 0.5 % while sheared, within 2 % from the moment the shearing turns round, and
/// every stress within 2 % along a path that turns.
fn held(boundary: &str, place: &str) {
    let rows = tested(boundary, place);
    let missed = |row: &Row| row.mean - PRESSURE;
    let along = |from: f64, to: f64, over: f64| {
        move |row: &Row| row.deviator - (from + (to - from) * (row.cycle / over).min(1.0))
    };
    let last = rows
        .iter()
        .rfind(|row| row.stage == "rest")
        .expect("a stage of the preset");
    let found = [
        ("at rest, deviator", last.deviator / PRESSURE, 0.01),
        ("at rest, shear", last.shear / PRESSURE, 0.01),
        ("sheared", most(&rows, "shear", missed), 0.005),
        ("sheared back", most(&rows, "back", missed), 0.02),
        ("path", most(&rows, "path", along(0.0, 3e4, 2e4)), 0.02),
        (
            "path back",
            most(&rows, "path-back", along(3e4, -3e4, 4e4)),
            0.02,
        ),
        ("path, mean", most(&rows, "path", missed), 0.02),
        ("path back, mean", most(&rows, "path-back", missed), 0.02),
    ];
    let moved = most(&rows, "shear", |row| row.deviator);
    assert!(moved > 0.4, "it was hardly sheared: {moved}");
    for (what, error, band) in found {
        assert!(error.abs() < band, "{what}: {error} of the mean stress");
    }
}

#[test]
fn a_ring_holds_and_follows_stresses() {
    // At its particles, which do not turn, the stress is not symmetric.
    held(
        "[boundary]\nkind = \"circle\"\nradius = 0.0116\n\
         [[measure]]\nname = \"core\"\ncircle = { centre = [0, 0], radius = 0.0085 }",
        "{ circle = { centre = [0, 0], radius = 0.0121 } }",
    );
}

#[test]
fn walls_hold_and_follow_stresses() {
    let half = 0.0105;
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    let mut text = "[boundary]\nkind = \"walls\"\n[material.plate]\nrigid = true\n".to_owned();
    for k in 0..4 {
        let [from, to] = [corners[k], corners[(k + 1) % 4]];
        text += &format!(
            "[[wall]]\nname = \"side{k}\"\nfrom = {from:?}\nto = {to:?}\nmaterial = \"plate\"\n"
        );
    }
    held(&text, SQUARE);
}

#[test]
fn a_cell_holds_and_follows_stresses() {
    held(
        "[cell]\nsize = [0.021, 0.021]\ncorner = [-0.0105, -0.0105]",
        SQUARE,
    );
}

//! Presets made by the tests.

use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Discs along one side of the block: enough for three threads to share every pass.
const SIDE: usize = 46;

/// Writes `block.toml`: some two thousand discs with friction and damping that fall into a box.
pub(crate) fn write_block(folder: &Path) {
    let mut text = String::from(
        r#"[model]
body = "disc"
gravity = [0.0, -9.81]

[damping]
contact = 0.1

[material.disc]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 7e5
friction = 0.4

[history]
every = 50
columns = ["state_hash", "kinetic", "energy_error", "contacts", "fracc", "wall:floor:f2", "wall:left:f1"]

[[stage]]
name = "fall"
until = "contacts > 4000"
max_cycles = 400

[[stage]]
name = "slip"
do = ["friction 0.1", "wall left velocity -0.5 0"]
max_cycles = 337
"#,
    );
    let width = SIDE as f64 * 0.021;
    for (name, from, to) in [
        ("floor", [0.0, 0.0], [width, 0.0]),
        ("left", [0.0, 0.0], [0.0, 2.0]),
        ("right", [width, 0.0], [width, 2.0]),
    ] {
        let wall = format!(
            "[[wall]]\nname = \"{name}\"\nmaterial = \"disc\"\nfrom = {from:?}\nto = {to:?}\n"
        );
        text.push_str(&wall);
    }
    for k in 0..SIDE * SIDE {
        let (column, row) = ((k % SIDE) as f64, (k / SIDE) as f64);
        // Every other row is shifted, sizes and velocities vary without any generator.
        let shift = if (k / SIDE).is_multiple_of(2) {
            1e-4
        } else {
            9e-4
        };
        let radius = 0.01 * (1.0 - 0.02 * ((k * 7919) % 13) as f64 / 13.0);
        let (x, y) = (
            0.0105 + 0.021 * column - 4e-4 + shift,
            0.0102 + 0.0203 * row,
        );
        let speed = 0.1 * ((k * 104_729) % 17) as f64 / 17.0 - 0.05;
        let _ = write!(
            text,
            "[[particle]]\nat = [{x:?}, {y:?}]\nradius = {radius:?}\nmaterial = \"disc\"\n\
             velocity = [{speed:?}, -0.3]\n"
        );
    }
    fs::write(folder.join("block.toml"), text).expect("it can be written");
}

/// Writes `open.toml`: a disc between two walls, without stages.
pub(crate) fn write_open(folder: &Path) {
    let text = r#"[model]
body = "disc"
[material.m]
density = 1000.0
normal_stiffness = 1e6
[[particle]]
at = [0.0, 0.0]
radius = 1.0
material = "m"
velocity = [0.3, 0.0]
[[wall]]
name = "left"
material = "m"
from = [-1.5, -2.0]
to = [-1.5, 2.0]
[[wall]]
name = "right"
material = "m"
from = [1.5, -2.0]
to = [1.5, 2.0]
[history]
every = 10
columns = ["particle:1:x", "state_hash"]
"#;
    fs::write(folder.join("open.toml"), text).expect("it can be written");
}

/// A run of some seconds: long enough to be interrupted anywhere.
pub(crate) const LONG: &str = "nine-disc-compression --set stage.ring.max_cycles=750000 \
                        --set stage.rest.max_cycles=750000 --set history.every=1500";

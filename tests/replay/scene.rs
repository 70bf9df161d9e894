//! A scene with stages of every kind.

use ballast::scene::Scene;
use ballast::session::{Options, Session};
use proptest::prelude::*;

/// Discs that fall on a floor: stages with commands that run, a stage without cycles, one that ends
/// by a column, and rows that do not fit the lengths of the stages.
pub(crate) const SCENE: &str = r#"
[model]
body = "disc"
gravity = [0.0, -9.81]
[damping]
contact = 0.1
[material.m]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 8e5
friction = 0.4
[material.n]
density = 2000.0
normal_stiffness = 2e6
shear_stiffness = 1e6
friction = 0.2
[[particle]]
at = [0.0, 0.999]
radius = 1.0
material = "m"
velocity = [0.3, -1.0]
[[particle]]
at = [1.99, 1.0]
radius = 1.0
material = "n"
[[particle]]
at = [1.0, 2.73]
radius = 1.0
material = "m"
spin = 3.0
[[wall]]
name = "floor"
material = "m"
from = [-50.0, 0.0]
to = [50.0, 0.0]
[history]
every = 7
columns = ["fracc", "energy_error", "kinetic", "contact:1-2:delta", "wall:floor:f2", "state_hash"]
"#;

/// Stages of which a scene has some, in any order: with commands that run, to a number or a condition,
/// at their end or before; without cycles; that end by a column, at once or later; whose command may be
/// refused.
pub(crate) const STAGES: [&str; 10] = [
    r#"name = "fall"
do = ["cycle 11", "friction 0.3"]
max_cycles = 30"#,
    r#"name = "instant"
do = ["wall floor velocity 0.1 0", "damp global 0.5"]
until = "cycle >= 0""#,
    r#"name = "rest"
do = ["particle 1 fix spin"]
until = "kinetic < 1e-3"
max_cycles = 40"#,
    r#"name = "last"
do = ["solve ratio 10 max 5", "zero"]
until = "stage_cycle >= 9""#,
    r#"name = "run"
do = ["cycle 11"]"#,
    r#"name = "settle"
do = ["friction 0.5", "solve until kinetic < 2000 max 20"]
until = "kinetic < 1000"
max_cycles = 15
check_every = 3"#,
    r#"name = "turn"
do = ["print step", "friction 0.1"]"#,
    r#"name = "drive"
do = ["wall floor velocity 0 0.5", "step 4", "cycle 3"]
max_cycles = 2"#,
    r#"name = "crowd"
do = ["friction 0.6", "create at 1 1.5 radius 0.5", "cycle 2", "particle 2 fix x"]
max_cycles = 3"#,
    r#"name = "calm"
until = "kinetic < 3000"
max_cycles = 50"#,
];

/// The preset, with some of the stages; `loose`: overlaps are allowed.
pub(crate) fn preset() -> impl Strategy<Value = String> {
    let stages = proptest::sample::subsequence(STAGES.to_vec(), 0..=4).prop_shuffle();
    (stages, any::<bool>()).prop_map(|(stages, loose)| with_stages(&stages, loose))
}

pub(crate) fn with_stages(stages: &[&str], loose: bool) -> String {
    let mut text = SCENE.to_owned();
    if loose {
        text = text.replace("[damping]", "overlap = \"allow\"\n[damping]");
    }
    for stage in stages {
        text.push_str(&format!("[[stage]]\n{stage}\n"));
    }
    text
}

pub(crate) fn open(preset: &str) -> Session {
    let scene = Scene::parse("random", preset, &[]).unwrap();
    Session::open(scene, Options::default()).unwrap()
}

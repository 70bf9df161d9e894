//! Things that once went wrong, each in its smallest scene.

#[path = "regressions/changes.rs"]
mod changes;
mod common;
mod program;
#[path = "regressions/programs.rs"]
mod programs;
#[path = "regressions/worlds.rs"]
mod worlds;

/// Undamped discs of 1000 kg/m³ on springs of 1e6 N/m.
const HEAD: &str = r#"
[model]
body = "disc"
frac = 0.1
[material.m]
density = 1e3
normal_stiffness = 1e6
"#;

const DISC: &str = "[[particle]]\nat = [0, 0]\nradius = 0.1\nmaterial = \"m\"\n";

/// A disc between two that stay where they are.
const PRESSED: &str = r#"
[[particle]]
at = [0, 0]
radius = 0.1
material = "m"
fixed = ["x", "y"]
[[particle]]
at = [0.196, 0]
radius = 0.1
material = "m"
[[particle]]
at = [0.392, 0]
radius = 0.1
material = "m"
fixed = ["x", "y"]
"#;

//! `[[generate]]`: where particles are put, how many, and what is refused.

mod counts;
mod errors;
mod fair;
mod lasting;
mod placing;
#[path = "../program/mod.rs"]
mod program;
mod sources;
mod typed;

use ballast::engine::setup::ParticleSetup;
use ballast::scene::Scene;

/// What every preset here begins with.
const HEAD: &str =
    "[model]\nbody = \"disc\"\n[material.m]\ndensity = 1e3\nnormal_stiffness = 1e6\n";

/// A preset with these tables.
fn preset(tables: &str) -> String {
    format!("{HEAD}{tables}")
}

/// The scene of a preset with these tables.
#[track_caller]
fn scene(tables: &str) -> Scene {
    scene_with(tables, &[])
}

/// The same with overrides.
#[track_caller]
fn scene_with(tables: &str, set: &[&str]) -> Scene {
    let set: Vec<String> = set.iter().map(|&option| option.to_owned()).collect();
    Scene::parse("g.toml", &preset(tables), &set).unwrap_or_else(|why| panic!("{why}"))
}

/// The report on a preset with these tables.
#[track_caller]
fn refusal(tables: &str) -> String {
    let refused = Scene::parse("g.toml", &preset(tables), &[]);
    refused.expect_err("it is wrong").to_string()
}

/// Distance between the surfaces of two particles.
fn apart(a: &ParticleSetup, b: &ParticleSetup) -> f64 {
    let d = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
    (d[0] * d[0] + d[1] * d[1]).sqrt() - a.radius - b.radius
}

/// Smallest distance between any two surfaces, by comparing all pairs.
fn least_apart(particles: &[ParticleSetup]) -> f64 {
    let mut least = f64::INFINITY;
    for (i, a) in particles.iter().enumerate() {
        for b in &particles[i + 1..] {
            least = least.min(apart(a, b));
        }
    }
    least
}

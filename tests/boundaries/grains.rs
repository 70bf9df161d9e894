//! The grading of the thesis, a third of it, and how it comes to rest.

use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

/// A preset run to its end.
pub(crate) fn ran(preset: &str) -> Session {
    let scene = Scene::parse("ran", preset, &[]).expect("the scene is sound");
    let mut session = Session::open(scene, Options::default()).expect("the scene is sound");
    session
        .advance(Budget::default(), false)
        .expect("nothing breaks");
    session
}

/// The stages in which the grains are gathered, compressed to 100 kPa and come to rest with friction, their
/// stress held by this command.
pub(crate) fn to_rest(servo: &str) -> String {
    format!(
        r#"
        [[stage]]
        name = "gather"
        do = ["continuum boundary", "strain rate 20 0 0 20", "con1 0.99"]
        until = "porosity < 0.25"
        max_cycles = 200_000
        [[stage]]
        name = "compress"
        do = ["con1 0.9999", "strain rate 0 0 0 0", "servo mean 1e5"]
        until = "abs(isotropic_stress - 1e5) < 1e3 and unbalanced < 5e-3"
        max_cycles = 300_000
        [[stage]]
        name = "rest"
        do = ["con1 0.999", "continuum none", "friction 0.3", "{servo}"]
        until = "stage_cycle > 5000 and unbalanced < 1e-3 and sin_phi < 4e-3"
        max_cycles = 100_000
        "#
    )
}

/// 200 spheres of five sizes without friction, in a region.
pub(crate) fn grains(region: &str) -> String {
    format!(
        r#"
        [model]
        law = "hertz-mindlin"
        frac = 0.2
        [damping]
        contact = 0.1
        [material.glass]
        density = 2650
        young = 70e9
        poisson = 0.25
        [[generate]]
        in = {region}
        material = "glass"
        grading = [
          {{ radius = 0.92e-3, count = 10 }},
          {{ radius = 0.76e-3, count = 46 }},
          {{ radius = 0.61e-3, count = 57 }},
          {{ radius = 0.46e-3, count = 77 }},
          {{ radius = 0.31e-3, count = 10 }},
        ]
        "#
    )
}

//! How many particles come of what was asked.

use crate::{HEAD, refusal, scene, scene_with};
use ballast::scene::Scene;

fn square(grading: &str, more: &str) -> String {
    format!(
        "[[generate]]\nmaterial = \"m\"\nin = {{ rectangle = {{ min = [0, 0], max = [1, 1] }} }}\n\
         grading = {grading}\n{more}\n"
    )
}

fn placed(scene: &Scene) -> Vec<usize> {
    scene.generated[0]
        .sizes
        .iter()
        .map(|size| size.placed)
        .collect()
}

#[test]
fn what_fits_is_placed_in_full() {
    let scene = scene(&square(
        "[{ radius = 0.02, count = 200 }, { radius = 0.04, count = 30 }, { radius = 0.01, count = 0 }]",
        "velocity = [1, -2]",
    ));
    assert_eq!(placed(&scene), [30, 200, 0]);
    let area = std::f64::consts::PI * (30.0 * 0.0016 + 200.0 * 0.0004);
    assert!((scene.generated[0].porosity.unwrap() - (1.0 - area)).abs() < 1e-12);
    assert!(
        scene
            .setup
            .particles
            .iter()
            .all(|p| p.velocity == [1.0, -2.0] && p.material == 0)
    );
    assert_eq!(scene.generated[0].shortfall(), None);
}

#[test]
fn when_a_size_no_longer_fits_the_next_smaller_one_comes() {
    let grading = "[{ radius = 0.3, count = 9 }, { radius = 0.05, count = 1000 }, { radius = 0.01, count = 50 }]";
    let scene = scene(&square(grading, ""));
    let placed = placed(&scene);
    // A disc of 0.3 leaves room for another only if both lie in opposite corners.
    assert!(
        (1..=2).contains(&placed[0]) && placed[1] > 20 && placed[2] == 50,
        "{placed:?}"
    );
    let short = scene.generated[0].shortfall().expect("not all fit");
    let missing = 1059 - scene.setup.particles.len();
    assert_eq!(
        short,
        format!(
            "generate 1 had no room for {missing} of the 1059 particles asked for, of radii 0.05 to 0.3 m"
        )
    );
    let refused = refusal(&square(grading, "exact = true"));
    assert!(refused.contains("generate 1 had no room for"), "{refused}");
    assert!(refused.contains("g.toml:10:9"), "{refused}");
}

#[test]
fn full_means_that_no_other_fits_anywhere() {
    let scene = scene(&square("[{ radius = 0.04 }]", ""));
    let room = |at: [f64; 2]| {
        let near = scene.setup.particles.iter();
        near.map(|p| (p.at[0] - at[0]).hypot(p.at[1] - at[1]) - p.radius)
            .fold(f64::INFINITY, f64::min)
    };
    // A place would show at one point of a lattice unless it is narrower than its mesh.
    let mesh = 0.92 / 1000.0;
    for i in 0..=1000 {
        for j in 0..=1000 {
            let at = [0.04 + mesh * f64::from(i), 0.04 + mesh * f64::from(j)];
            assert!(room(at) < 0.04 + mesh, "{at:?}");
        }
    }
}

#[test]
fn the_old_generator_stops_looser() {
    // With tries a size is given up earlier: the fewer, the looser.
    let porosity = |more: &str| {
        scene(&square("[{ radius = 0.01 }]", more)).generated[0]
            .porosity
            .unwrap()
    };
    let (ten, thousand, full) = (
        porosity("tries = 10"),
        porosity("tries = 1000"),
        porosity(""),
    );
    assert!(
        ten > thousand + 0.05 && thousand > full + 0.01,
        "{ten} {thousand} {full}"
    );
}

/// Before the thesis nothing smaller was tried once a size no longer fitted.
#[test]
fn full_may_be_the_end() {
    let sizes = "[{ radius = 0.06, count = 1000 }, { radius = 0.01, count = 300 }]";
    let placed = |more: &str| {
        let radii = scene(&square(sizes, more)).setup.particles;
        let large = radii.iter().filter(|p| p.radius == 0.06).count();
        (large, radii.len() - large)
    };
    let next = placed("");
    assert_eq!(next, placed("when_full = \"next\""));
    assert!(next.0 > 20 && next.0 < 1000 && next.1 > 100, "{next:?}");
    assert_eq!(placed("when_full = \"stop\""), (next.0, 0));
    // Where all fit there is nothing to stop for.
    let few = "[{ radius = 0.06, count = 3 }, { radius = 0.01, count = 5 }]";
    let all = scene(&square(few, "when_full = \"stop\"")).setup.particles;
    assert_eq!(all.len(), 8);
}

#[test]
fn columns_and_commands_may_name_generated_particles() {
    let tables = square("[{ radius = 0.02, count = 20 }]", "")
        + "[history]\ncolumns = [\"particle:20:x\"]\n\
           [[stage]]\nname = \"s\"\ndo = [\"particle 20 fix x\"]\nmax_cycles = 1\n";
    assert_eq!(scene(&tables).history.columns.len(), 1);
    let refused = refusal(&tables.replace("particle 20", "particle 21"));
    assert!(refused.contains("there is no particle 21"), "{refused}");
}

#[test]
fn generated_particles_need_what_the_law_needs() {
    let text = HEAD.replace("normal_stiffness = 1e6\n", "")
        + &square("[{ radius = 0.02, count = 2 }]", "");
    let refused = Scene::parse("g.toml", &text, &[]).expect_err("a stiffness is missing");
    assert!(
        refused.to_string().contains("normal_stiffness"),
        "{refused}"
    );
}

#[test]
fn options_reach_inside() {
    let tables = square("[{ radius = 0.02, count = 20 }]", "name = \"sand\"");
    let set = [
        "generate.sand.grading.0.count=7",
        "generate.0.in.rectangle.max=[2, 1]",
    ];
    let scene = scene_with(&tables, &set);
    assert_eq!(scene.setup.particles.len(), 7);
    assert_eq!(scene.generated[0].area, Some(2.0));
}

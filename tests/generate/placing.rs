//! Particles keep clear of each other, of what is there already, of walls and of the border.

use crate::{least_apart, scene};
use ballast::engine::setup::ParticleSetup;

/// What rounding of coordinates near 1 can bring surfaces together by.
const ROUNDING: f64 = 1e-14;

fn inside_circle(particle: &ParticleSetup, centre: [f64; 2], radius: f64) -> bool {
    let d = [particle.at[0] - centre[0], particle.at[1] - centre[1]];
    (d[0] * d[0] + d[1] * d[1]).sqrt() + particle.radius <= radius + ROUNDING
}

#[test]
fn a_full_circle_of_many_sizes_has_no_contact() {
    let scene = scene(
        "[[generate]]\nmaterial = \"m\"\nin = { circle = { centre = [0.5, -0.25], radius = 1.0 } }\n\
         grading = [{ radius = 0.2, count = 4 }, { radius = 0.003, count = 500 }, \
         { radius = 0.05, count = 60 }, { radius = 0.02 }]\n",
    );
    let particles = &scene.setup.particles;
    assert!(particles.len() > 700, "{}", particles.len());
    assert!(
        particles
            .iter()
            .all(|p| inside_circle(p, [0.5, -0.25], 1.0))
    );
    assert!(least_apart(particles) > -ROUNDING);
    // The largest come first: after as many as fit of a size there is no room for a larger one.
    assert_eq!(scene.generated[0].shortfall(), None);
    // Numbers lead from neighbour to neighbour. In the order of placing a step is 0.9 of the radius long, the
    // mean distance in a unit circle, which is a dozen distances of neighbours.
    let step = |pair: &[ParticleSetup]| {
        (pair[0].at[0] - pair[1].at[0]).hypot(pair[0].at[1] - pair[1].at[1])
    };
    let way: f64 = particles.windows(2).map(step).sum();
    let count = particles.len() as f64;
    let neighbour = (std::f64::consts::PI / count).sqrt();
    assert!(way < 2.0 * count * neighbour, "{way} {neighbour}");
}

#[test]
fn the_gap_holds_between_particles_and_to_walls_and_listed_ones() {
    let scene = scene(
        "[[particle]]\nat = [0.5, 0.5]\nradius = 0.1\nmaterial = \"m\"\n\
         [[particle]]\nat = [-0.05, 0.2]\nradius = 0.2\nmaterial = \"m\"\n\
         [[particle]]\nat = [0.9, 0.9]\nradius = 0.001\nmaterial = \"m\"\n\
         [[wall]]\nname = \"slope\"\nfrom = [0.6, 0.0]\nto = [1.0, 0.4]\nmaterial = \"m\"\n\
         [[generate]]\nmaterial = \"m\"\nin = { rectangle = { min = [0, 0], max = [1, 1] } }\n\
         grading = [{ radius = 0.02 }]\ngap = 0.01\n\
         [[generate]]\nmaterial = \"m\"\nin = { rectangle = { min = [0, 0], max = [1, 1] } }\n\
         grading = [{ radius = 0.004 }]\ngap = 0.001\n",
    );
    let particles = &scene.setup.particles;
    let second = scene.generated[1].first as usize - 1;
    assert!(second > 100 && particles.len() > second + 100);
    assert!(least_apart(&particles[..second]) > 0.01 - ROUNDING);
    assert!(least_apart(particles) > 0.001 - ROUNDING);
    for (k, particle) in particles.iter().enumerate().skip(3) {
        let [x, y] = particle.at;
        let gap = if k < second { 0.01 } else { 0.001 };
        assert!(
            [x, y]
                .iter()
                .all(|x| *x >= particle.radius && *x <= 1.0 - particle.radius)
        );
        // Distance from the line y = x - 0.6; beyond its ends the region ends too.
        let off = (x - y - 0.6).abs() / 2f64.sqrt();
        assert!(off >= particle.radius + gap - ROUNDING, "{k}");
    }
}

#[test]
fn particles_lie_wholly_inside_a_polygon() {
    // An L: not convex.
    let corners = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 0.4],
        [0.4, 0.4],
        [0.4, 1.0],
        [0.0, 1.0],
    ];
    let scene = scene(&format!(
        "[[generate]]\nmaterial = \"m\"\nin = {{ polygon = {corners:?} }}\ngrading = [{{ radius = 0.03 }}]\n"
    ));
    let particles = &scene.setup.particles;
    assert!((scene.generated[0].area.unwrap() - 0.64).abs() < 1e-15);
    assert!(particles.len() > 80, "{}", particles.len());
    assert!(least_apart(particles) > -ROUNDING);
    for particle in particles {
        let ([x, y], r) = (particle.at, particle.radius - ROUNDING);
        let flat = x >= r && x <= 1.0 - r && y >= r && y <= 0.4 - r;
        let upright = x >= r && x <= 0.4 - r && y >= r && y <= 1.0 - r;
        // Around the inner corner neither arm alone holds a disc that lies in the L.
        let corner = x >= r && y >= r && (x - 0.4).hypot(y - 0.4) >= r && x <= 0.4 && y <= 0.4;
        assert!(flat || upright || corner, "{particle:?}");
    }
    assert!(particles.iter().any(|p| p.at[1] > 0.5) && particles.iter().any(|p| p.at[0] > 0.5));
}

#[test]
fn a_periodic_cell_has_no_border() {
    let scene = scene(
        "[[generate]]\nmaterial = \"m\"\nin = { rectangle = { min = [0, 0], max = [1, 0.7] } }\n\
         grading = [{ radius = 0.03 }, { radius = 0.1, count = 5 }]\nperiodic = true\n",
    );
    let particles = &scene.setup.particles;
    assert!(
        particles.iter().any(|p| p.at[0] < p.radius),
        "some stick out"
    );
    let inside =
        |p: &ParticleSetup| p.at[0] >= 0.0 && p.at[0] < 1.0 && p.at[1] >= 0.0 && p.at[1] < 0.7;
    assert!(particles.iter().all(inside));
    let mut tiled = Vec::new();
    for shift in [[0.0, 0.0], [1.0, 0.0], [0.0, 0.7], [1.0, 0.7], [1.0, -0.7]] {
        tiled.extend(particles.iter().map(|p| ParticleSetup {
            at: [p.at[0] + shift[0], p.at[1] + shift[1]],
            ..p.clone()
        }));
    }
    assert!(least_apart(&tiled) > -ROUNDING);
}

#[test]
fn a_large_sample_has_no_contact() {
    let scene = scene(
        "[[generate]]\nmaterial = \"m\"\nin = { circle = { centre = [0, 0], radius = 1.0 } }\n\
         grading = [{ radius = 0.006, count = 3000 }, { radius = 0.002 }]\n",
    );
    let mut particles = scene.setup.particles;
    assert!(particles.len() > 40_000, "{}", particles.len());
    // In order of x, only those less than two radii ahead can touch.
    particles.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]));
    for (i, a) in particles.iter().enumerate() {
        let ahead = particles[i + 1..].iter();
        for b in ahead.take_while(|b| b.at[0] - a.at[0] < 0.012) {
            assert!(crate::apart(a, b) > -ROUNDING);
        }
    }
}

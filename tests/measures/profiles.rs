//! Porosity by distance.

use std::f64::consts::PI;

use ballast::measure::profile::{Profile, Ring};
use ballast::measure::region::Shape;

use crate::packing::{built, close, compressed, lattice, measured, setup};

#[test]
fn rings_cut_discs_exactly() {
    // One disc in the middle, one that the second ring cuts: its part is a lens less a lens.
    let far = 1024.0;
    let discs = [([far, 0.0], 1.0), ([far + 2.0, 0.0], 0.5)];
    let world = built(setup(&discs));
    let circle = Shape::Circle {
        centre: [far, 0.0],
        radius: 4.0,
    };
    let profile = Profile::of(&world, circle, 4);
    let found: Vec<f64> = profile.rings.iter().map(|ring| ring.disc_area).collect();
    // The circle of radius 2 passes through the middle of the small disc; the lens of both: the
    // angles at the two centres come from the triangle 2, 2, 1/2.
    let (a, b) = (libm::acos(1.0 - 0.125 / 4.0), libm::acos(0.125));
    let chord = 0.5 * libm::sin(b);
    let lens = 4.0 * a - 2.0 * libm::cos(a) * chord + 0.25 * b - 0.125 * 0.5 * chord;
    for (found, exact) in found.iter().zip([PI, lens, 0.25 * PI - lens, 0.0]) {
        assert!((found - exact).abs() < 1e-12, "{found} {exact}");
    }
    assert_eq!(profile.rings[0].porosity(), 0.0);
    assert_eq!(profile.rings[3].porosity(), 1.0);
    assert!(close(profile.rings[2].area(), 5.0 * PI, 1e-14, 1.0));
    let particles: Vec<usize> = profile.rings.iter().map(|ring| ring.particles).collect();
    assert_eq!(particles, [1, 0, 1, 0]);
    assert_eq!(profile.centre, [far, 0.0]);
}

#[test]
fn rings_add_up_to_their_region() {
    let world = built(compressed(8, 8));
    let circle = Shape::Circle {
        centre: [7.0, 9.0],
        radius: 6.0,
    };
    let content = measured(&world, circle).content;
    for count in [1, 3, 17] {
        let profile = Profile::of(&world, circle, count);
        let rings = &profile.rings;
        assert_eq!(rings.len(), count);
        let discs: f64 = rings.iter().map(|ring| ring.disc_area).sum();
        assert!(close(discs, content.disc_area, 1e-13, discs));
        let area: f64 = rings.iter().map(Ring::area).sum();
        assert!(close(area, content.area, 1e-13, area));
        let particles: usize = rings.iter().map(|ring| ring.particles).sum();
        assert_eq!(particles, content.particles());
        // Averaged by area, porosity is that of the region.
        let hollow: f64 = rings.iter().map(|ring| ring.porosity() * ring.area()).sum();
        assert!(close(hollow / area, content.porosity(), 1e-13, 1.0));
    }
    // The whole: about the centre of area, as far as discs reach.
    let all = Profile::of(&world, Shape::All, 5);
    let particles: usize = all.rings.iter().map(|ring| ring.particles).sum();
    assert_eq!(particles, 64);
    let discs: f64 = all.rings.iter().map(|ring| ring.disc_area).sum();
    let exact = measured(&world, Shape::All).content.disc_area;
    assert!(close(discs, exact, 1e-13, exact));
    let rectangle = Shape::Rectangle {
        min: [2.0, 3.0],
        max: [8.0, 13.0],
    };
    let inscribed = Profile::of(&world, rectangle, 2);
    assert_eq!(
        (inscribed.centre, inscribed.rings[1].outer),
        ([5.0, 8.0], 3.0)
    );
}

#[test]
fn a_lattice_is_as_dense_everywhere() {
    let world = built(setup(&lattice([2.0, 0.0], [1.0, 3f64.sqrt()], 40.0)));
    let circle = Shape::Circle {
        centre: [0.3, 0.4],
        radius: 30.0,
    };
    let profile = Profile::of(&world, circle, 3);
    let touching = 1.0 - PI / 12f64.sqrt();
    for ring in &profile.rings {
        // The edge of a ring cuts discs at random: some thirty of them by a few per cent.
        let off = (ring.porosity() - touching).abs();
        assert!(off < 0.01, "{ring:?}: {off}");
    }
    // A hole in the middle shows in the first ring alone.
    let mut discs = lattice([2.0, 0.0], [1.0, 3f64.sqrt()], 40.0);
    discs.retain(|([x, y], _)| x * x + y * y > 25.0);
    let hollow = Profile::of(&built(setup(&discs)), circle, 3);
    assert!(hollow.rings[0].porosity() > touching + 0.1);
    let [second, same] = [&hollow, &profile].map(|profile| profile.rings[1].porosity());
    assert!(close(second, same, 1e-12, 1.0));
}

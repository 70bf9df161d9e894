//! Regular packings. Discs of radius R overlap by α, so their distance is D = 2R - α and every
//! contact carries F = kα. A region of whole periods holds whole numbers of discs and contacts,
//! wherever it begins, so its closed forms are exact but for rounding: an overlap of 0.02 R is the
//! difference of lengths up to 40 R, known to some 1e-13 of itself.

use ballast::engine::World;
use ballast::engine::setup::{Body, LawChoice, TimeStepChoice};
use ballast::measure::contact_area::{ContactArea, normal_stresses, peak_pressure};
use ballast::measure::fourier::Fourier;
use ballast::measure::fourth::FourthFabric;
use ballast::measure::redundancy::Redundancy;
use ballast::measure::region::Shape;
use ballast::measure::rose::{PETALS, Rose};
use nalgebra::Matrix2;
use std::f64::consts::PI;

use crate::packing::{K, Measured, built, close, lattice, measured, run, setup, wall};

const OVERLAP: f64 = 0.02;
const D: f64 = 2.0 - OVERLAP;
const F: f64 = K * OVERLAP;

/// Rounding of overlaps, with some room.
const ROUNDING: f64 = 1e-12;

fn rectangle(corner: [f64; 2], size: [f64; 2]) -> Shape {
    Shape::Rectangle {
        min: corner,
        max: [corner[0] + size[0], corner[1] + size[1]],
    }
}

fn is_isotropic(m: &Measured, stress: f64) {
    let s = m.stress.total;
    assert!(close(s[(0, 0)], stress, ROUNDING, stress), "{s} {stress}");
    assert!(close(s[(1, 1)], stress, ROUNDING, stress), "{s} {stress}");
    assert!(close(s[(0, 1)], 0.0, ROUNDING, stress), "{s}");
    assert!(close(s[(1, 0)], 0.0, ROUNDING, stress), "{s}");
    let half = Matrix2::identity() * 0.5;
    for fabric in [m.fabric.plain, m.fabric.weighted] {
        assert!((fabric - half).norm() < ROUNDING, "{fabric}");
    }
    // Nothing shears, so there is nothing to weigh with.
    assert!(m.fabric.by_tangential.iter().all(|x| x.is_nan()));
    // All normal forces are alike and nothing shears: fabric is the whole of it.
    assert!((m.stress.fabric - s).norm() < ROUNDING * stress);
    assert!(m.stress.normal_variation.norm() < ROUNDING * stress);
    assert!(m.stress.shear.norm() < ROUNDING * stress);
    assert!(m.stress.sin_phi() < ROUNDING);
}

fn fabric_to_fourth_order(world: &World, m: &Measured, exact: [f64; 5]) {
    let fourth = FourthFabric::of(world, &m.content.inside);
    for of in [fourth.plain, fourth.weighted] {
        for (k, exact) in exact.into_iter().enumerate() {
            assert!(close(of.component(k), exact, ROUNDING, 1.0), "{of:?}");
        }
        let [a, b, c] = of.contracted();
        let second = Matrix2::new(a, b, b, c);
        assert!((second - m.fabric.plain).norm() < ROUNDING);
    }
}

fn fourier(world: &World, m: &Measured) -> Fourier {
    let fourth = FourthFabric::of(world, &m.content.inside);
    Fourier::of(world, &m.content.inside, &fourth.plain)
}

/// Unknown forces and moments over equations, in a region of whole periods.
#[test]
fn redundancy_of_lattices() {
    let row = D * 3f64.sqrt() / 2.0;
    let hexagonal = (
        lattice([D, 0.0], [0.5 * D, row], 20.0),
        [5.0 * D, 6.0 * row],
    );
    let square = (lattice([D, 0.0], [0.0, D], 20.0), [5.0 * D, 6.0 * D]);
    // Contacts per disc times what each carries over equations: one force and two equations where
    // nothing can turn a disc.
    for ((discs, size), friction, rolling, exact) in [
        (&hexagonal, 0.0, 0.0, 3.0 / 2.0),
        (&hexagonal, 0.5, 0.0, 3.0 * 2.0 / 3.0),
        (&hexagonal, 0.5, 0.1, 3.0 * 3.0 / 3.0),
        (&square, 0.0, 0.0, 2.0 / 2.0),
        (&square, 0.5, 0.0, 2.0 * 2.0 / 3.0),
        (&square, 0.0, 0.1, 2.0 * 2.0 / 3.0),
    ] {
        let mut setup = setup(discs);
        setup.materials[0].friction = friction;
        setup.materials[0].rolling_friction = rolling;
        let world = built(setup);
        let m = measured(&world, rectangle([-4.3, -5.7], *size));
        let redundancy = Redundancy::of(&world, &m.content.inside);
        assert_eq!(redundancy.ratio(), exact);
        assert!(redundancy.equations >= 60.0);
    }
}

#[test]
fn contact_areas_are_those_of_the_geometry() {
    let row = D * 3f64.sqrt() / 2.0;
    let discs = lattice([D, 0.0], [0.5 * D, row], 20.0);
    // R* = 1/2, so a = 0.1: a circle of spheres, a strip of discs.
    let radius = (0.5 * OVERLAP).sqrt();
    for (body, area) in [
        (Body::Sphere, PI * 0.5 * OVERLAP),
        (Body::Disc, 2.0 * radius),
    ] {
        let mut setup = setup(&discs);
        setup.body = body;
        let world = built(setup);
        let m = measured(&world, rectangle([-4.3, -5.7], [5.0 * D, 6.0 * row]));
        let stresses = normal_stresses(&world, &m.content.inside);
        assert_eq!(stresses.iter().map(|(_, weight)| weight).sum::<f64>(), 90.0);
        // Half the digits of the overlap go into a.
        let exact = F / area;
        assert!(
            stresses
                .iter()
                .all(|(s, _)| close(*s, exact, ROUNDING, exact))
        );
        let of = ContactArea::of(&world, 0);
        assert!(close(of.radius, 0.1, ROUNDING, 0.1));
        assert!(close(of.relative(), 0.1, ROUNDING, 0.1));
    }
    // The largest pressure is 3/2 of the mean in a circle, 4/π in a strip.
    for (body, over_mean) in [(Body::Sphere, 1.5), (Body::Disc, 4.0 / PI)] {
        let mut setup = setup(&discs);
        let hertz = LawChoice::named("hertz").expect("it is in the list");
        (setup.body, setup.law) = (body, hertz);
        setup.time_step = TimeStepChoice::Seconds(1e-6);
        setup.materials[0].young = Some(1e7);
        setup.materials[0].poisson = Some(0.3);
        let world = built(setup);
        let (at, reaction) = (ContactArea::of(&world, 0), world.reaction(0));
        let mean = reaction.normal / at.area;
        let peak = peak_pressure(&world, 0);
        assert!(
            close(peak, over_mean * mean, ROUNDING, peak),
            "{peak} {mean}"
        );
    }
    // Unequal discs, and a wall: the curvatures add, the wall has none.
    let mut unequal = setup(&[([0.0, 0.0], 1.0), ([3.9, 0.0], 3.0)]);
    unequal.walls = vec![wall("floor", [-9.0, -0.9], [9.0, -0.9])];
    let world = built(unequal);
    let areas = [0, 1].map(|k| ContactArea::of(&world, k));
    assert!(close(
        areas[0].radius,
        (0.75 * 0.1_f64).sqrt(),
        ROUNDING,
        1.0
    ));
    assert_eq!((areas[0].smaller, areas[1].smaller), (1.0, 1.0));
    assert!(close(areas[1].radius, 0.1_f64.sqrt(), ROUNDING, 1.0));
}

fn spikes(rose: &Rose) -> Vec<usize> {
    (0..PETALS).filter(|&k| rose.contacts[k] > 0.0).collect()
}

#[test]
fn square_packing() {
    let world = built(setup(&lattice([D, 0.0], [0.0, D], 20.0)));
    let m = measured(&world, rectangle([-4.3, -5.7], [5.0 * D, 6.0 * D]));
    assert_eq!(m.content.particles(), 30);
    is_isotropic(&m, F / D);
    let porosity = 1.0 - PI / (D * D);
    assert!(close(m.content.porosity(), porosity, 1e-13, 1.0));
    // The textbook's 0.2146 is that of discs that just touch: denser by 2 α/D of the solid.
    let touching = 1.0 - PI / 4.0;
    assert!((touching - 0.2146).abs() < 5e-5);
    let overlap = (1.0 - touching) * OVERLAP;
    assert!(close(touching - porosity, overlap, 0.03, overlap));
    let rose = Rose::of(&world, &m.content, PETALS);
    assert_eq!(spikes(&rose), [0, 9]);
    assert_eq!([rose.contacts[0], rose.contacts[9]], [30.0, 30.0]);
    fabric_to_fourth_order(&world, &m, [0.5, 0.0, 0.0, 0.0, 0.5]);
    let fourier = fourier(&world, &m);
    // Two directions at right angles: no second order, all there can be of the fourth, along them.
    assert!(fourier.contacts.amplitude() < ROUNDING);
    assert!(close(fourier.fourfold.amplitude(), 2.0, ROUNDING, 1.0));
    assert!(
        fourier
            .fourfold
            .angle()
            .min(90.0 - fourier.fourfold.angle())
            < 1e-9
    );
    // They leave the wave along the diagonals open.
    assert!(fourier.normal.amplitude().is_nan() && fourier.mean_normal.is_nan());
    let trace = 2.0 * 2.0 / (D * D);
    assert!(close(
        m.fabric.trace(&world, &m.content),
        trace,
        1e-12,
        trace
    ));
    // A region that is no period shows that the closed forms are not met by any region.
    let other = measured(&world, rectangle([-4.3, -5.7], [5.1 * D, 6.0 * D]));
    assert!((other.content.porosity() - porosity).abs() > 1e-3);
    assert!((other.stress.total[(0, 0)] - F / D).abs() > 1e-3 * F);
}

#[test]
fn hexagonal_packing() {
    let row = D * 3f64.sqrt() / 2.0;
    let discs = lattice([D, 0.0], [0.5 * D, row], 20.0);
    let period = rectangle([-4.3, -5.7], [5.0 * D, 6.0 * row]);
    for (body, thickness) in [(Body::Disc, 1.0), (Body::Sphere, 2.0)] {
        let mut setup = setup(&discs);
        setup.body = body;
        let world = built(setup);
        let m = measured(&world, period);
        assert_eq!(m.content.particles(), 30);
        is_isotropic(&m, 3f64.sqrt() * F / (D * thickness));
        let porosity = 1.0 - PI / (D * row);
        assert!(close(m.content.porosity(), porosity, 1e-13, 1.0));
        let touching = 1.0 - PI / 12f64.sqrt();
        assert!((touching - 0.0931).abs() < 5e-5);
        let overlap = (1.0 - touching) * OVERLAP;
        assert!(close(touching - porosity, overlap, 0.03, overlap));
        let rose = Rose::of(&world, &m.content, PETALS);
        assert_eq!(spikes(&rose), [0, 6, 12]);
        assert!([0, 6, 12].iter().all(|&k| rose.contacts[k] == 30.0));
        let force = 30.0 * F;
        assert!(close(rose.force[6], force, ROUNDING, force));
        assert_eq!(rose.sliding, [0.0; PETALS]);
        assert_eq!(rose.direction(6), 60.0);
        fabric_to_fourth_order(&world, &m, [0.375, 0.0, 0.125, 0.0, 0.375]);
        let fourier = fourier(&world, &m);
        for wave in [
            fourier.contacts,
            fourier.fourfold,
            fourier.normal,
            fourier.tangential,
        ] {
            assert!(wave.amplitude() < ROUNDING, "{wave:?}");
        }
        assert!(close(fourier.mean_normal, F, ROUNDING, F));
        let trace = 2.0 * 3.0 / (D * row * thickness);
        assert!(close(
            m.fabric.trace(&world, &m.content),
            trace,
            1e-12,
            trace
        ));
        let full = Rose::mirrored(&rose.contacts);
        assert_eq!(full.len(), 36);
        assert_eq!(full[6], full[24]);
    }
}

/// Moduli per unit thickness of springs k_n and k_s on a hexagonal lattice, from the sum over its
/// three directions: in a lattice the strain is the same everywhere.
#[test]
fn a_hexagonal_packing_is_as_stiff_as_its_springs() {
    let overlap = 1e-4;
    let d = 2.0 - overlap;
    let row = d * 3f64.sqrt() / 2.0;
    let discs = lattice([d, 0.0], [0.5 * d, row], 20.0);
    let period = rectangle([-4.3, -5.7], [5.0 * d, 6.0 * row]);
    let strain = 1e-6;
    for ratio in [2.0 / 3.0, 1.0] {
        let (kn, ks) = (K, ratio * K);
        let c11 = 3f64.sqrt() / 4.0 * (3.0 * kn + ks);
        let c12 = 3f64.sqrt() / 4.0 * (kn - ks);
        // Poisson's ratio of the plane.
        assert!(close(c12 / c11, (1.0 - ratio) / (3.0 + ratio), 1e-14, 1.0));
        for (e, stress) in [
            ([1.0, 0.0, 0.0], [c11, c12, 0.0]),
            ([0.0, 1.0, 0.0], [c12, c11, 0.0]),
            ([0.0, 0.0, 1.0], [0.0, 0.0, c11 - c12]),
        ] {
            let mut setup = setup(&discs);
            setup.materials[0].friction = 10.0;
            setup.materials[0].shear_stiffness = Some(ks);
            (setup.time_step, setup.frac) = (TimeStepChoice::Seconds(1.0), 1.0);
            for particle in &mut setup.particles {
                // Compression positive; shear without rotation.
                let [x, y] = particle.at;
                particle.fixed = [true; 3];
                particle.velocity = [e[0] * x + e[2] * y, e[2] * x + e[1] * y].map(|u| -strain * u);
            }
            let mut world = built(setup);
            let before = measured(&world, period).stress.total;
            run(&mut world, 1);
            let more = (measured(&world, period).stress.total - before) / strain;
            // The forces there are turn with the contacts and act on shorter sides: 1e-4 of the
            // stiffness; friction of 10 is far from used.
            let found = [
                more[(0, 0)],
                more[(1, 1)],
                0.5 * (more[(0, 1)] + more[(1, 0)]),
            ];
            for (found, exact) in found.into_iter().zip(stress) {
                assert!(close(found, exact, 2e-4, kn), "{ratio} {e:?}: {more}");
            }
        }
    }
}

/// What laws of Hertz make of a contact: its stiffness is 2 E* a, whatever a is called.
#[test]
fn spheres_of_hertz_touch_in_the_circle_of_their_geometry() {
    // Thesis, 5.2: spheres of 10 mm, E = 210 GPa, ν = 0.3 under 88 N.
    let young_eff = 210e9 / (2.0 * (1.0 - 0.09));
    let overlap = 4.029_7e-6;
    let mut pair = setup(&[([0.0, 0.0], 0.01), ([0.02 - overlap, 0.0], 0.01)]);
    pair.body = Body::Sphere;
    pair.law = LawChoice::named("hertz").expect("there is one");
    pair.materials[0].young = Some(210e9);
    pair.materials[0].poisson = Some(0.3);
    (pair.time_step, pair.frac) = (TimeStepChoice::Seconds(1e-7), 1.0);
    let world = built(pair);
    let area = ContactArea::of(&world, 0);
    assert!(close(area.radius, 141.95e-6, 1e-4, 141.95e-6), "{area:?}");
    // The centres are known to 1e-18 of 0.02, the overlap of 4e-6 to 1e-12, its root to half of that.
    let stiffness = world.pass().stiffness(0, world.geometry(0).overlap).k[0];
    let exact = 2.0 * young_eff * area.radius;
    assert!(close(stiffness, exact, 1e-11, exact), "{stiffness} {exact}");
    let force = world.reaction(0).normal;
    assert!(close(force, 88.0, 1e-4, 88.0), "{force}");
    // Hertz: the mean stress is two thirds of the largest, 2 E* a/(π R*).
    let [mean, _] = area.stress(force, 0.0);
    let largest = 2.0 * young_eff * area.radius / (PI * 0.005);
    assert!(
        close(mean, largest * 2.0 / 3.0, 1e-11, mean),
        "{mean} {largest}"
    );
}

#[test]
fn a_turned_packing_turns_its_tensors_and_keeps_its_invariants() {
    // Squeezed along direction 2, so that slanting contacts carry more than level ones. Turned about
    // the middle of a circle that passes no centre within 1e-3.
    let circle = Shape::Circle {
        centre: [0.0; 2],
        radius: 9.5,
    };
    let discs = lattice([D, 0.0], [0.5 * D, 0.85 * D], 16.0);
    let radii = discs
        .iter()
        .map(|(x, _)| (x[0] * x[0] + x[1] * x[1]).sqrt());
    assert!(radii.clone().all(|r| (r - 9.5).abs() > 1e-3));
    let flat = measured(&built(setup(&discs)), circle);
    assert!(flat.stress.sin_phi() > 0.1, "{}", flat.stress.sin_phi());
    assert!(flat.fabric.anisotropy() > 1e-3);
    for degrees in [7.0, 33.0, 90.0, 151.0, 200.0] {
        let (s, c) = libm::sincos(f64::to_radians(degrees));
        let turn = Matrix2::new(c, -s, s, c);
        let turned: Vec<_> = discs
            .iter()
            .map(|&([x, y], r)| ([c * x - s * y, s * x + c * y], r))
            .collect();
        let m = measured(&built(setup(&turned)), circle);
        assert_eq!(m.content.particles(), flat.content.particles());
        let scale = flat.stress.isotropic();
        let expected = turn * flat.stress.total * turn.transpose();
        assert!((m.stress.total - expected).norm() < 1e-11 * scale);
        let expected = turn * flat.fabric.weighted * turn.transpose();
        assert!((m.fabric.weighted - expected).norm() < 1e-11);
        let invariants = |m: &Measured| {
            [
                m.content.porosity(),
                m.stress.sin_phi(),
                m.stress.isotropic() / scale,
                m.stress.deviator() / scale,
                m.fabric.anisotropy(),
                m.fabric.anisotropy_weighted(),
            ]
        };
        for (now, before) in invariants(&m).into_iter().zip(invariants(&flat)) {
            assert!((now - before).abs() < 1e-11, "{degrees}: {now} {before}");
        }
        // Angles are known to the rounding over the anisotropy; they live in half a turn.
        for (now, before) in [
            (m.stress.principal().angle, flat.stress.principal().angle),
            (m.fabric.principal().angle, flat.fabric.principal().angle),
        ] {
            let off = (now - before - degrees).rem_euclid(180.0);
            assert!(off.min(180.0 - off) < 1e-6, "{degrees}: {now} {before}");
            assert!((0.0..180.0).contains(&now));
        }
        // What would pass without turning anything.
        assert!((m.stress.total - flat.stress.total).norm() > 1e-3 * scale);
    }
}

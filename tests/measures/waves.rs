//! Stress, forces and fabric over directions. Pairs of discs, each alone, point and press and shear as
//! told: contacts over directions by quantiles of their distribution, so that sums over them are
//! integrals to rounding, and forces by the wave of their direction.

use std::f64::consts::PI;

use ballast::engine::World;
use ballast::engine::setup::TimeStepChoice;
use ballast::measure::fourier::{Fourier, Wave};
use ballast::measure::obliquity::Obliquity;
use ballast::measure::region::Shape;
use ballast::measure::sample::Sample;

use crate::packing::{K, built, close, measured, run, setup};

/// A wave of second order: amplitude, direction [degrees].
type Given = (f64, f64);

/// Mean normal force over directions: an overlap of 1e-4 radii.
const N0: f64 = 1e-4 * K;

/// Shear stiffness: shear moves a disc by 1e-11 radii, and nothing else notices.
const STIFF: f64 = 1e11;

fn wave((amplitude, degrees): Given, theta: f64) -> [f64; 2] {
    let (s, c) = libm::sincos(2.0 * (theta - degrees.to_radians()));
    [amplitude * c, amplitude * s]
}

/// Directions distributed as 1 + a cos 2(θ - θ_a).
fn directions(contacts: Given, count: u32) -> Vec<f64> {
    let [_, zero] = wave(contacts, 0.0);
    let share = |theta: f64| (theta + 0.5 * (wave(contacts, theta)[1] - zero)) / PI;
    let quantile = |k: u32| {
        let wanted = (f64::from(k) + 0.5) / f64::from(count);
        let (mut low, mut high) = (0.0, PI);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if share(middle) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    };
    (0..count).map(quantile).collect()
}

/// Pairs of discs that point in these directions and carry N(θ) and T(θ).
fn pairs(contacts: Given, normal: Given, tangential: Given) -> World {
    let (mut discs, mut slides) = (Vec::new(), Vec::new());
    for (theta, k) in directions(contacts, 400).into_iter().zip(0_u32..) {
        let (s, c) = libm::sincos(theta);
        let n = N0 * (1.0 + wave(normal, theta)[0]);
        let distance = 2.0 - n / K;
        let at = [f64::from(5 * (k % 20)), f64::from(5 * (k / 20))];
        discs.push((at, 1.0));
        discs.push(([at[0] + distance * c, at[1] + distance * s], 1.0));
        // The first disc moves along t = (e2, -e1) by T over the stiffness.
        let t = N0 * wave(tangential, theta)[1] / STIFF;
        slides.push([t * s, -t * c]);
    }
    let mut setup = setup(&discs);
    setup.materials[0].friction = 10.0;
    setup.materials[0].shear_stiffness = Some(STIFF);
    (setup.time_step, setup.frac) = (TimeStepChoice::Seconds(1.0), 1.0);
    for (k, particle) in setup.particles.iter_mut().enumerate() {
        particle.fixed = [true; 3];
        if k % 2 == 0 {
            particle.velocity = slides[k / 2];
        }
    }
    let mut world = built(setup);
    run(&mut world, 1);
    world
}

fn fourier(world: &mut World) -> Fourier {
    *Sample::of(world).whole().fourier()
}

fn is_wave(found: Wave, (amplitude, degrees): Given) {
    // Overlaps of 1e-4 between coordinates up to 100 are known to 1e-10 of themselves.
    assert!(close(found.amplitude(), amplitude, 1e-9, 1.0), "{found:?}");
    // A crest along direction 1 may come out on either side of it.
    let off = (found.angle() - degrees).rem_euclid(180.0);
    assert!(off.min(180.0 - off) < 1e-7, "{found:?}");
}

#[test]
fn waves_that_were_put_in_come_out() {
    for (contacts, normal, tangential) in [
        ((0.3, 0.0), (0.4, 0.0), (0.2, 0.0)),
        ((0.3, 20.0), (0.4, 35.0), (0.2, 170.0)),
        ((0.05, 100.0), (0.7, 95.0), (0.1, 90.0)),
    ] {
        let mut world = pairs(contacts, normal, tangential);
        let all = measured(&world, Shape::All);
        let f = fourier(&mut world);
        is_wave(f.contacts, contacts);
        is_wave(f.normal, normal);
        is_wave(f.tangential, tangential);
        assert!(close(f.mean_normal, N0, 1e-9, N0));
        // The distribution has no wave of fourth order.
        assert!(f.fourfold.amplitude() < 1e-9, "{:?}", f.fourfold);
        // Half the wave is the difference of the principal fabrics.
        assert!(close(all.fabric.anisotropy(), 0.5 * contacts.0, 1e-9, 1.0));
        // The mean over contacts is another one: the fit is over directions.
        let [c, _] = wave((1.0, contacts.1), normal.1.to_radians());
        let over_contacts = 1.0 + 0.5 * contacts.0 * normal.0 * c;
        assert!(close(all.stress.mean_normal, over_contacts * N0, 1e-9, N0));
    }
}

#[test]
fn waves_explain_the_stress() {
    let (contacts, normal) = ((0.3, 10.0), (0.4, 10.0));
    for tangential in [(0.2, 10.0), (0.0, 10.0), (0.2, 100.0)] {
        let mut world = pairs(contacts, normal, tangential);
        let s = measured(&world, Shape::All).stress;
        let f = fourier(&mut world);
        // On common axes tangential forces add, or take away where they turn the other way.
        let sign = if tangential.1 > 90.0 { -1.0 } else { 1.0 };
        let sum = 0.5 * (contacts.0 + normal.0 + sign * tangential.0);
        let exact = sum / (1.0 + 0.5 * contacts.0 * normal.0);
        assert!(close(f.sin_phi(), exact, 1e-9, 1.0), "{}", f.sin_phi());
        // Branches differ by the overlap, up to 1.4e-4 of 2: by half of that at most.
        assert!(close(s.sin_phi(), exact, 7e-5, 1.0), "{}", s.sin_phi());
        assert!(!close(s.sin_phi(), exact, 1e-12, 1.0));
        // The short form leaves the product of the two waves out: here 6 % of it.
        assert!(close(s.sin_phi(), sum, 0.061, sum) && !close(s.sin_phi(), sum, 0.05, sum));
        let shear = 0.5 * sign * tangential.0 / (1.0 + 0.5 * contacts.0 * normal.0);
        assert!(close(s.sin_phi_of(&s.shear), shear, 7e-5, 1.0));
        let fabric = 0.5 * contacts.0;
        assert!(close(s.sin_phi_of(&s.fabric), fabric, 7e-5, 1.0));
    }
    // On different axes the three add as vectors of twice the angle.
    let mut world = pairs((0.3, 20.0), (0.4, 50.0), (0.2, 80.0));
    let s = measured(&world, Shape::All).stress;
    let f = fourier(&mut world);
    assert!(close(s.sin_phi(), f.sin_phi(), 7e-5, 1.0));
    let all_along = 0.5 * (0.3 + 0.4 + 0.2) / (1.0 + 0.5 * 0.3 * 0.4 * 0.5);
    assert!(s.sin_phi() < 0.9 * all_along);
}

#[test]
fn turning_and_mirroring_take_the_waves_along() {
    let mut plain = pairs((0.2, 15.0), (0.3, 25.0), (0.1, 40.0));
    let mut mirrored = pairs((0.2, 165.0), (0.3, 155.0), (0.1, 140.0));
    let (f, g) = (fourier(&mut plain), fourier(&mut mirrored));
    for (a, b) in [
        (f.contacts, g.contacts),
        (f.normal, g.normal),
        (f.tangential, g.tangential),
    ] {
        is_wave(a, (b.amplitude(), 180.0 - b.angle()));
    }
    assert!(close(f.sin_phi(), g.sin_phi(), 1e-9, 1.0));
}

#[test]
fn obliquity_is_the_share_of_friction_in_use() {
    // T = N0 a_t sin 2θ and N = N0 over μ = 10: a sine, whose mean size is 2/π of its height.
    let world = pairs((0.0, 0.0), (0.0, 0.0), (5.0, 0.0));
    let obliquity = Obliquity::of(&world, &vec![true; 800]);
    assert_eq!(obliquity.contacts.len(), 400);
    // A sum over 400 directions instead of an integral: π²/6 over the square of the 100 in a
    // quarter wave.
    assert!(close(obliquity.mean(), 0.5 * 2.0 / PI, 2e-4, 1.0));
    let histogram = obliquity.histogram();
    assert_eq!(histogram.count(), 400.0);
    assert!(histogram.mean.abs() < 1e-9);
    assert!(close(histogram.deviation, 0.5 / 2f64.sqrt(), 1e-9, 1.0));
    // Half of the range is used, and its ends most: the share of a bar is that of an arcsine.
    assert!(
        histogram.bars[..5]
            .iter()
            .chain(&histogram.bars[15..])
            .all(|&bar| bar == 0.0)
    );
    let arc = |x: f64| libm::asin(x / 0.5) / PI;
    for (k, &bar) in histogram.bars.iter().enumerate().take(15).skip(5) {
        let [low, high] = histogram.edges(k);
        let exact = 400.0 * (arc(high.min(0.5)) - arc(low.max(-0.5)));
        // Four arcs lead through each bar, each begins and ends between two directions.
        assert!((bar - exact).abs() <= 4.0, "{k}: {bar} {exact}");
    }
    assert!(histogram.bars[5] > 2.0 * histogram.bars[9]);
    // Normal forces are shown over their mean.
    assert!(
        obliquity
            .contacts
            .iter()
            .all(|c| close(c[0], 1.0, 1e-9, 1.0))
    );
}

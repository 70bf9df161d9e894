//! The oldest experiments of the method: the two discs and the nine discs of Cundall & Strack 1979.

mod common;

use ballast::engine::World;
use ballast::measure::columns::Column;
use ballast::measure::sample::Sample;
use common::*;

/// Normal force of contact I-J.
fn normal(world: &mut World, contact: &str) -> f64 {
    value(world, &format!("contact:{contact}:n"))
}

fn value(world: &mut World, column: &str) -> f64 {
    Sample::of(world).value(&Column::parse(column).expect("a column"))
}

/// Closes the walls for so many cycles, then holds them.
fn close(world: &mut World, loading: u64) {
    run(world, loading);
    for w in 0..world.walls().len() {
        world.set_wall_velocity(w, [0.0; 2]);
    }
}

/// q of the outer discs: two springs k on mass m, leapfrog at frac of 2 sqrt(m/k), so that
/// sin(q/2) = ω dt/2 = sqrt(2) frac.
fn phase(frac: f64) -> f64 {
    2.0 * (2f64.sqrt() * frac).asin()
}

#[test]
fn two_discs_between_walls() {
    // Cundall & Strack 1979, fig. 1 and (1) to (7): all by hand for two cycles. Powers of two make
    // every product exact.
    let (k, v, m) = (1024.0, 0.125, 4.0);
    let mut setup = two_particles(
        ballast::engine::setup::Material {
            density: m / std::f64::consts::PI,
            ..material(k, k, 0.0)
        },
        0.0,
    );
    setup.time_step = ballast::engine::setup::TimeStepChoice::Seconds(1.0 / 64.0);
    setup.frac = 1.0;
    setup.walls = closing_walls([-2.0, -2.0], [2.0, 2.0], v);
    setup.walls.retain(|wall| wall.velocity[0] != 0.0);
    let dt = 1.0 / 64.0;
    let mut world = world(setup);
    let mass = world.particles().mass[0];
    // ρπR² with ρ = m/π is m up to the last bits.
    assert!((mass / m - 1.0).abs() < 4.0 * f64::EPSILON);

    run(&mut world, 1);
    let first = v * dt;
    assert_eq!(value(&mut world, "contact:1-left:alpha"), first);
    assert_eq!(normal(&mut world, "1-left"), k * first);
    assert_eq!(normal(&mut world, "2-right"), k * first);
    assert_eq!(value(&mut world, "contact:1-2:alpha"), 0.0);
    assert_eq!(normal(&mut world, "1-2"), 0.0);

    run(&mut world, 1);
    let speed = k * first / mass * dt;
    let left = first + (v - speed) * dt;
    let middle = 2.0 * speed * dt;
    // Overlaps are differences of coordinates of size 1 to 2: four roundings of 2^-53.
    let ulp = 4.0 * f64::EPSILON;
    assert!((value(&mut world, "contact:1-left:alpha") - left).abs() < ulp);
    assert!((value(&mut world, "contact:2-right:alpha") - left).abs() < ulp);
    assert!((value(&mut world, "contact:1-2:alpha") - middle).abs() < ulp);
    assert!((normal(&mut world, "1-left") - k * left).abs() < k * ulp);
    assert!((normal(&mut world, "1-2") - k * middle).abs() < k * ulp);
    let row = |world: &World, p: usize| world.particles().row[p].v[0];
    assert_eq!(row(&world, 0), speed);
    assert_eq!(row(&world, 1), -speed);
    assert!(middle > 0.0 && left > first);
}

#[test]
fn damped_discs_settle_at_the_closed_form() {
    // E2: damping, of whatever kind, does not move F_eq = k v N dt/2.
    let (v, loading) = (0.12, 40);
    let base = || nine_discs(material(STIFFNESS, STIFFNESS, 0.0), 0.1, v);
    let mut contact = base();
    contact.damping.contact = ballast::engine::setup::Dashpot::Fraction(0.3);
    let mut beta = base();
    // β for about the same dashpot: c = β k.
    beta.damping.contact = ballast::engine::setup::Dashpot::Beta(0.04);
    let mut global = base();
    // A third of critical for ω = sqrt(2k/m).
    global.damping.global = 0.66 * (2.0 * STIFFNESS / 7.854e6f64).sqrt();
    for (name, setup) in [("contact", contact), ("beta", beta), ("global", global)] {
        let mut world = world(setup);
        let equal = STIFFNESS * v * loading as f64 * world.dt() / 2.0;
        close(&mut world, loading);
        let early = normal(&mut world, "1-left");
        run(&mut world, 1500 - loading);
        for contact in ["1-left", "1-2", "4-5", "5-6", "8-9", "8-top", "3-bottom"] {
            let error = normal(&mut world, contact) / equal - 1.0;
            assert!(error.abs() < 1e-9, "{name} {contact}: {error}");
        }
        // It had something to settle from.
        assert!((early / equal - 1.0).abs() > 1e-3, "{name}");
    }
}

#[test]
fn undamped_discs_oscillate_about_it() {
    for (frac, loading) in [
        (0.0946, 40),
        (0.1, 40),
        (0.05, 40),
        (0.07, 40),
        (0.15, 40),
        (0.1, 120),
        (0.0946, 120),
        (0.08, 25),
        (0.2, 7),
        (0.03, 300),
    ] {
        let v = 0.12;
        let mut world = world(nine_discs(material(STIFFNESS, STIFFNESS, 0.0), frac, v));
        let equal = STIFFNESS * v * loading as f64 * world.dt() / 2.0;
        close(&mut world, loading);
        let q = phase(frac);
        // A + B cos(qn) + C sin(qn) by least squares over many periods.
        let cycles = 4000;
        let (mut matrix, mut right) = (nalgebra::Matrix3::zeros(), nalgebra::Vector3::zeros());
        let mut series = Vec::new();
        for n in 0..cycles {
            let base =
                nalgebra::Vector3::new(1.0, (q * f64::from(n)).cos(), (q * f64::from(n)).sin());
            let force = normal(&mut world, "4-5");
            series.push(force);
            matrix += base * base.transpose();
            right += base * force;
            run(&mut world, 1);
        }
        let fit = matrix
            .lu()
            .solve(&right)
            .expect("three independent functions");
        let amplitude = fit[1].hypot(fit[2]) / equal;
        // Discrete response of y'' = -4 sin²(q/2) y to a ramp of N steps: an impulse of half a wall
        // step at 0 and its opposite at N, each answered by sin(q n)/sin q.
        let n = loading as f64;
        let closed = 2.0 * (0.5 * n * q).sin().abs() / (n * q.sin());
        // The contract is 0.5 %; nothing but rounding and the fit of a finite series is left.
        assert!(
            (amplitude - closed).abs() < 1e-8,
            "{frac} {loading}: {amplitude} {closed}"
        );
        // A frequency that is off by 1e-4 turns 4000 cycles of phase by half a radian: the fit
        // above would have shown it.
        let [low, high] = range(&series);
        let middle = 0.5 * (low + high) / equal;
        assert!((middle - 1.0).abs() < 1e-2, "{frac} {loading}: {middle}");
        assert!((fit[0] / equal - 1.0).abs() < 1e-8);
        if loading == 40 && frac == 0.0946 {
            assert!((amplitude - 0.1495).abs() < 5e-5, "{amplitude}");
        }
        if loading == 40 && frac == 0.1 {
            assert!((amplitude - 0.1019).abs() < 5e-5, "{amplitude}");
        }
    }
}

/// F/(k v N dt/2) of contact 4-5 over some cycles.
fn normalised(k: f64, v: f64, loading: u64) -> Vec<f64> {
    let mut world = world(nine_discs(material(k, k, 0.0), 0.1, v));
    let equal = k * v * loading as f64 * world.dt() / 2.0;
    let mut series = Vec::new();
    for n in 0..600 {
        if n == loading {
            for w in 0..world.walls().len() {
                world.set_wall_velocity(w, [0.0; 2]);
            }
        }
        run(&mut world, 1);
        series.push(normal(&mut world, "4-5") / equal);
    }
    series
}

#[test]
fn speed_and_stiffness_scale_out() {
    // E3, E4: the step goes with sqrt(m/k), so only the number of loading cycles shows.
    let distance = |a: &[f64], b: &[f64]| {
        let gaps: Vec<f64> = a.iter().zip(b).map(|(x, y)| (x - y).abs()).collect();
        range(&gaps)[1]
    };
    let fast = normalised(1.35e9, 0.12, 40);
    let slow = normalised(1.35e9, 0.04, 120);
    assert!(distance(&fast, &normalised(1.5e8, 0.36, 40)) < 1e-8);
    assert!(distance(&slow, &normalised(1.5e8, 0.12, 120)) < 1e-8);
    // Negative control: another number of loading cycles is another curve, with less to-and-fro.
    assert!(distance(&fast, &slow) > 0.1);
    let swing = |series: &[f64]| {
        let [low, high] = range(&series[200..]);
        high - low
    };
    assert!(swing(&slow) < 0.7 * swing(&fast));
}

#[test]
fn friction_shares_the_load_as_statics_says() {
    let table = include_str!("../data/reference/nine_disc_static.csv");
    let mut rows = 0;
    let mut slips = 0;
    for line in table.lines().skip(1) {
        let cell: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cell[k].parse::<f64>().expect("a number");
        let ratio = number(0);
        let friction = match cell[1] {
            // Larger than any T/N here.
            "90" => 1e6,
            degrees => degrees.parse::<f64>().expect("degrees").to_radians().tan(),
        };
        // Overlaps of 6e-5 of the radius in the end: small enough for small-strain statics, and
        // loading over some thousand periods for quasi-static.
        let v = 1e-5;
        let mut setup = nine_discs(material(STIFFNESS, ratio * STIFFNESS, friction), 0.1, v);
        // More would be unstable at this step: lagged dashpots tighten the limit.
        setup.damping = contact_damping(0.2);
        let mut world = world(setup);
        assert!(world.frac_limit() > 0.1);
        let loading = 20_000;
        close(&mut world, loading);
        let closing = v * loading as f64 * world.dt();
        run(&mut world, 3000);
        let scale = STIFFNESS * closing;
        let found = [
            normal(&mut world, "1-left"),
            normal(&mut world, "4-left"),
            normal(&mut world, "1-2"),
            normal(&mut world, "2-5"),
            value(&mut world, "contact:1-left:t").abs(),
            -value(&mut world, "contact:1-2:t").abs(),
        ];
        for (k, force) in found.into_iter().enumerate() {
            let (is, should) = (force / scale, number(k + 2));
            assert!((is - should).abs() < 2e-4, "{line}: column {}: {is}", k + 2);
        }
        // Mirror images carry the same.
        for contact in ["3-right", "9-top", "7-left", "1-bottom"] {
            let gap = normal(&mut world, contact) - found[0];
            assert!(gap.abs() < 1e-6 * scale, "{line}: {contact}");
        }
        // The walls slip where the table says so: the shear force stands at its limit.
        let at_limit = (found[4] / (friction * found[0]) - 1.0).abs() < 1e-3 && found[4] > 0.0;
        assert_eq!(at_limit, cell[8] == "True", "{line}");
        slips += usize::from(at_limit);
        rows += 1;
    }
    assert_eq!(rows, 16);
    assert!(slips > 0);
}

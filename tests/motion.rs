// Long because: one scene stands above the tests that share it, for rolling, impacts and momenta.
//! Motion: rolling, impacts, momentum, the order of the leapfrog, damping of motion, and digits.

mod common;

#[path = "motion/bounces.rs"]
mod bounces;

use ballast::engine::World;
use ballast::engine::neighbours::Status;
use ballast::engine::setup::{Body, Damping, Dashpot, Gravity, Material, Setup, TimeStepChoice};
use common::*;

/// Discs and spheres of radius 1 with this mass.
fn of_mass(body: Body, mass: f64, material: Material) -> Material {
    let volume = match body {
        Body::Disc => std::f64::consts::PI,
        Body::Sphere => 4.0 / 3.0 * std::f64::consts::PI,
    };
    Material {
        density: mass / volume,
        ..material
    }
}

/// A particle of mass 1 and radius 1 in static equilibrium on the floor under gravity `g` across
/// it. Stiff, so that the tangential spring swings back within 1e-4 of the time that slip lasts.
fn resting(body: Body, friction: f64, g: [f64; 2]) -> Setup {
    let k = 1e9;
    let mut setup = on_floor(of_mass(body, 1.0, material(k, k, friction)), g[1] / k);
    setup.body = body;
    setup.gravity = Some(Gravity::Uniform(g));
    setup.ledger = false;
    setup
}

#[test]
fn slip_turns_into_rolling() {
    let (v0, friction, g) = (1.0, 0.3, 10.0);
    for (body, share, time) in [
        (Body::Sphere, 5.0 / 7.0, 2.0 / 7.0),
        (Body::Disc, 2.0 / 3.0, 1.0 / 3.0),
    ] {
        let mut setup = resting(body, friction, [0.0, -g]);
        setup.particles[0].velocity = [v0, 0.0];
        setup.damping.tangential = Some(0.2);
        let mut world = world(setup);
        let slides = |world: &World| world.contacts().status[0] == Status::Sliding;
        run(&mut world, 3);
        assert!(slides(&world));
        while slides(&world) {
            run(&mut world, 1);
        }
        let rolled = time * v0 / (friction * g);
        assert!(
            (world.time() / rolled - 1.0).abs() < 1e-4,
            "{body:?}: {}",
            world.time()
        );
        // The spring that is still tense swings out in some hundred cycles.
        run(&mut world, 2000);
        world.settle();
        let (v, spin) = world.velocity(0);
        assert!((v[0] / (share * v0) - 1.0).abs() < 1e-4, "{body:?}: {v:?}");
        // Rolling to the right turns clockwise.
        assert!(
            (spin / (-share * v0) - 1.0).abs() < 1e-4,
            "{body:?}: {spin}"
        );
    }
}

#[test]
fn rolling_down_an_incline() {
    let (g, slope) = (10.0, 0.3f64);
    for (body, share, least) in [
        (Body::Sphere, 5.0 / 7.0, 2.0 / 7.0),
        (Body::Disc, 2.0 / 3.0, 1.0 / 3.0),
    ] {
        // Rolls with 5 % more friction than it takes, slides with 5 % less.
        for (factor, rolls) in [(1.05, true), (0.95, false)] {
            let friction = factor * least * slope.tan();
            for tilted_wall in [false, true] {
                let mut setup = resting(body, friction, [g * slope.sin(), -g * slope.cos()]);
                if tilted_wall {
                    // The same in other axes: gravity down, floor tilted.
                    let e = [slope.cos(), -slope.sin()];
                    setup.gravity = Some(Gravity::Uniform([0.0, -g]));
                    setup.walls[0].direction = e;
                    let height = setup.particles[0].at[1];
                    setup.particles[0].at = [height * slope.sin(), height * slope.cos()];
                }
                setup.damping.tangential = Some(0.3);
                setup.damping.contact = Dashpot::Fraction(0.3);
                let mut world = world(setup);
                let speed = |world: &mut World| {
                    world.settle();
                    let v = world.velocity(0).0;
                    (v[0].hypot(v[1]), world.time())
                };
                // The tangential spring takes its load within some hundred cycles.
                run(&mut world, 4000);
                let early = speed(&mut world);
                run(&mut world, 20_000);
                let late = speed(&mut world);
                let rate = (late.0 - early.0) / (late.1 - early.1);
                let expected = if rolls {
                    share * g * slope.sin()
                } else {
                    g * (slope.sin() - friction * slope.cos())
                };
                assert!(
                    (rate / expected - 1.0).abs() < 1e-4,
                    "{body:?} {rolls}: {rate} {expected}"
                );
                let slides = world.contacts().status[0] == Status::Sliding;
                assert_eq!(slides, !rolls);
            }
        }
    }
}

/// Linear and angular momentum of the half step before the boundary, and their scales: what the
/// leapfrog conserves.
fn momenta(world: &World) -> ([f64; 3], [f64; 2]) {
    let p = world.particles();
    let (mut sum, mut scale) = ([0.0; 3], [0.0; 2]);
    for (k, row) in p.row.iter().enumerate() {
        let m = p.mass[k];
        let turn = m * (row.x[0] * row.v[1] - row.x[1] * row.v[0]);
        sum[0] += m * row.v[0];
        sum[1] += m * row.v[1];
        sum[2] += turn + p.inertia[k] * row.spin;
        scale[0] += m * row.v[0].hypot(row.v[1]);
        scale[1] += turn.abs() + (p.inertia[k] * row.spin).abs();
    }
    (sum, scale)
}

#[test]
fn a_closed_system_keeps_its_momenta() {
    let mut setup = scene(of_mass(Body::Disc, 1.0, material(1e3, 0.7e3, 0.5)));
    setup.damping.contact = Dashpot::Fraction(0.1);
    let mut random = Random(7);
    // A swirling ring of 48 discs, radii up to 1 : 5, that falls in on itself.
    for ring in 0..4 {
        for k in 0..12 {
            let angle = std::f64::consts::TAU * (f64::from(k) + 0.5 * f64::from(ring)) / 12.0;
            let far = 5.0 + 3.0 * f64::from(ring);
            let radius = random.between(0.24, 1.2);
            let (s, c) = angle.sin_cos();
            let v = [-c - 0.4 * s, -s + 0.4 * c].map(|x| x * random.between(0.5, 1.0));
            let spin = random.between(-2.0, 2.0);
            setup
                .particles
                .push(moving(far * c, far * s, radius, v, spin));
        }
    }
    setup.time_step = TimeStepChoice::Seconds(2e-4);
    setup.frac = 1.0;
    let mut world = world(setup);
    let (before, scale) = momenta(&world);
    let own = spins(&world);
    let (mut touching, mut sliding) = (0, 0);
    for _ in 0..1000 {
        run(&mut world, 100);
        let status = &world.contacts().status;
        touching += status.iter().filter(|s| **s != Status::Apart).count();
        sliding += status.iter().filter(|s| **s == Status::Sliding).count();
        let (now, _) = momenta(&world);
        for k in 0..3 {
            let drift = (now[k] - before[k]).abs() / scale[k / 2];
            assert!(drift < 1e-12, "component {k} drifted by {drift:e}");
        }
    }
    // It did collide, slide and dissipate.
    world.settle();
    let lost = world.bookings().expect("booked");
    assert!(touching > 200 && sliding > 50, "{touching} {sliding}");
    assert!(lost.friction_loss > 0.0 && lost.damping_loss > 0.0);
    // What is constant is a sum whose parts are not: spin took over from orbit.
    let turned = spins(&world) - own;
    assert!(turned.abs() > 1e-3 * scale[1], "{turned}");
}

/// Angular momentum of the spins.
fn spins(world: &World) -> f64 {
    let p = world.particles();
    p.row
        .iter()
        .zip(&p.inertia)
        .map(|(row, i)| i * row.spin)
        .sum()
}

#[test]
fn the_leapfrog_is_of_second_order() {
    // One disc between two preloaded walls: x = A cos(ωt), ω² = 2k/m, from given velocities too.
    let k = 1e4;
    let errors = [25.0, 50.0, 100.0, 200.0].map(|steps| {
        let mut setup = scene(of_mass(Body::Disc, 1.0, material(k, k, 0.0)));
        setup.walls = closing_walls([-0.9, -5.0], [0.9, 5.0], 0.0);
        let omega = (2.0 * k).sqrt();
        let period = std::f64::consts::TAU / omega;
        setup.time_step = TimeStepChoice::Seconds(period / steps);
        setup.frac = 1.0;
        let (amplitude, v) = (1e-3, 0.05);
        setup.particles = vec![moving(amplitude, 0.0, 1.0, [v, 0.0], 0.0)];
        let mut world = world(setup);
        let mut errors = Vec::new();
        for _ in 0..(3.0 * steps) as u64 {
            run(&mut world, 1);
            world.settle();
            let (s, c) = (omega * world.time()).sin_cos();
            let x = amplitude * c + v / omega * s;
            errors.push((world.position(0)[0] - x).abs());
            // The velocity at the boundary is the mean of the half steps.
            let u = v * c - amplitude * omega * s;
            errors.push((world.velocity(0).0[0] - u).abs() / omega);
        }
        [1.0 / steps, range(&errors)[1]]
    });
    let order = order(&errors);
    assert!((order - 2.0).abs() < 0.05, "{order}: {errors:?}");
}

/// A particle with nothing around it but gravity.
fn falling(damping: Damping, velocity: [f64; 2], spin: f64, gravity: f64) -> World {
    // Friction, so that spins are modelled.
    let mut setup = scene(of_mass(Body::Disc, 1.0, material(1e4, 1e4, 0.5)));
    setup.gravity = Some(Gravity::Uniform([0.0, gravity]));
    setup.damping = damping;
    setup.particles = vec![moving(0.0, 0.0, 1.0, velocity, spin)];
    setup.time_step = TimeStepChoice::Seconds(0.01);
    setup.frac = 1.0;
    world(setup)
}

#[test]
fn global_damping_is_the_central_form() {
    let (alpha, g, dt) = (3.0, -10.0, 0.01);
    let damping = Damping {
        global: alpha,
        ..Damping::default()
    };
    let mut world = falling(damping, [1.0, 2.0], 4.0, g);
    // First half a step, then v' = r v + s: a geometric series towards g/α.
    let half =
        |h: f64, v: f64, a: f64| (v * (1.0 - 0.5 * alpha * h) + a * h) / (1.0 + 0.5 * alpha * h);
    let ratio = (1.0 - 0.5 * alpha * dt) / (1.0 + 0.5 * alpha * dt);
    let first = [
        half(0.5 * dt, 1.0, 0.0),
        half(0.5 * dt, 2.0, g),
        half(0.5 * dt, 4.0, 0.0),
    ];
    let limit = [0.0, g / alpha, 0.0];
    for n in 0..1000 {
        run(&mut world, 1);
        let row = world.particles().row[0];
        for (k, v) in [row.v[0], row.v[1], row.spin].into_iter().enumerate() {
            let closed = limit[k] + (first[k] - limit[k]) * ratio.powi(n);
            // Each step rounds a few times at the size of the velocity.
            assert!(
                (v - closed).abs() < 1e-13 * (1.0 + limit[k].abs()),
                "{n} {k}: {v} {closed}"
            );
        }
    }
    // And near to what the differential equation says: 2 exp(-αt) - ... after a time.
    assert!((world.particles().row[0].v[1] - g / alpha).abs() < 1e-9);
}

#[test]
fn con1_takes_its_share_of_every_step() {
    let damping = Damping {
        con1: 0.9,
        ..Damping::default()
    };
    let mut world = falling(damping, [1.0, 0.0], 2.0, 0.0);
    for n in 1..200 {
        run(&mut world, 1);
        let row = world.particles().row[0];
        let share = 0.9f64.powi(n);
        assert!((row.v[0] / share - 1.0).abs() < 1e-13);
        assert!((row.spin / (2.0 * share) - 1.0).abs() < 1e-13);
    }
}

#[test]
fn local_damping_scales_the_force() {
    // λ|F| against the velocity: rising it brakes with g(1 + λ), falling it gains g(1 - λ).
    let (lambda, g) = (0.7, 10.0);
    let damping = Damping {
        local: lambda,
        ..Damping::default()
    };
    let mut world = falling(damping, [0.0, 5.0], 0.0, -g);
    let mut last = f64::NAN;
    let (mut up, mut down) = (0, 0);
    for _ in 0..100 {
        run(&mut world, 1);
        let v = world.particles().row[0].v[1];
        let rate = (v - last) / world.dt();
        if v > 0.0 && last > 0.0 {
            assert!((rate + g * (1.0 + lambda)).abs() < 1e-10);
            up += 1;
        }
        if v < 0.0 && last < 0.0 {
            assert!((rate + g * (1.0 - lambda)).abs() < 1e-10);
            down += 1;
        }
        last = v;
    }
    assert!(up > 10 && down > 10, "{up} {down}");
}

#[test]
fn the_shown_velocity_is_the_mean_of_the_half_steps() {
    // With every damping of motion at once, given mid-run too.
    use ballast::engine::edit::Motion;
    for (global, con1, local) in [
        (0.0, 1.0, 0.0),
        (3.0, 1.0, 0.0),
        (3.0, 0.9, 0.0),
        (0.0, 1.0, 0.5),
    ] {
        let damping = Damping {
            global,
            con1,
            local,
            ..Damping::default()
        };
        let mut world = falling(damping, [1.0, -2.0], 4.0, -10.0);
        run(&mut world, 10);
        world.set_motion(0, Motion::Velocity([0.5, -1.5]));
        world.set_motion(0, Motion::Spin(2.0));
        world.settle();
        let (shown, spin) = world.velocity(0);
        let before = world.particles().row[0];
        run(&mut world, 1);
        let after = world.particles().row[0];
        let mean = [0, 1].map(|k| 0.5 * (before.v[k] + after.v[k]));
        for (is, should) in [
            (shown[0], 0.5),
            (shown[1], -1.5),
            (spin, 2.0),
            (mean[0], 0.5),
            (mean[1], -1.5),
            (0.5 * (before.spin + after.spin), 2.0),
        ] {
            assert!(
                (is - should).abs() < 1e-14,
                "{global} {con1} {local}: {is} {should}"
            );
        }
    }
}

#[test]
fn frictionless_particles_keep_turning() {
    let mut setup = scene(material(1e4, 1e4, 0.0));
    setup.particles = vec![moving(0.0, 0.0, 1.0, [0.0; 2], 3.0)];
    let mut turning = world(setup.clone());
    run(&mut turning, 100);
    let angle = turning.particles().row[0].angle;
    assert!((angle / (3.0 * turning.time()) - 1.0).abs() < 1e-12);
    assert!(turning.energies().rotational > 0.0);
    // Unless rotation is switched off.
    setup.rotation = false;
    let mut still = world(setup);
    run(&mut still, 100);
    let row = still.particles().row[0];
    assert_eq!([row.angle, row.spin], [0.0; 2]);
}

/// A compressed row of three unequal discs between walls, moved by `shift` along both axes.
fn compressed(shift: f64) -> Setup {
    let mut setup = scene(of_mass(Body::Disc, 1.0, material(1e4, 0.5e4, 0.3)));
    // Multiples of 2^-20: exact near the origin and 2^20 radii away from it.
    let grain = (0.5f64).powi(20);
    let exact = |x: f64| (x / grain).round() * grain;
    for (x, y) in [(-1.999, 0.001), (0.0, 0.0), (1.9985, -0.002)] {
        setup
            .particles
            .push(particle(exact(x) + shift, exact(y) + shift, 1.0));
    }
    let edge = exact(2.9975);
    setup.walls = closing_walls([-edge, -8.0], [edge, 8.0], exact(0.01));
    for wall in &mut setup.walls {
        for axis in 0..2 {
            wall.point[axis] += shift;
            wall.about[axis] += shift;
        }
    }
    setup
}

/// Two discs pressed together in absolute coordinates: the overlap after some cycles as plain
/// arithmetic finds it, without an origin of its own.
fn plain_overlap(shift: f64, cycles: u32) -> f64 {
    let (k, dt) = (1e4, 1e-3);
    let mut x = [shift - 0.999, shift + 0.999];
    let mut v = [0.0; 2];
    for _ in 0..cycles {
        let force = k * (2.0 - (x[1] - x[0])).max(0.0);
        v[0] -= force * dt;
        v[1] += force * dt;
        for p in 0..2 {
            x[p] += v[p] * dt;
        }
    }
    2.0 - (x[1] - x[0])
}

#[test]
fn overlaps_keep_their_digits_far_from_zero() {
    let far = 1_048_576.0;
    let (mut here, mut there) = (world(compressed(0.0)), world(compressed(far)));
    assert_eq!(here.origin(), [0.0; 2]);
    assert!(there.origin()[0] > 1e6);
    let mut forces = 0.0;
    for _ in 0..2000 {
        run(&mut here, 1);
        run(&mut there, 1);
        for k in 0..here.contacts().len() {
            let gap = here.reaction(k).normal - there.reaction(k).normal;
            // The origins differ by less than the size of the scene, so only last bits do.
            assert!(gap.abs() < 1e-9 * 1e4 * 0.01, "{gap}");
            forces += here.reaction(k).normal;
        }
    }
    assert!(forces > 0.0);
    let x = there.position(0)[0] - far - here.position(0)[0];
    // Shown coordinates round to the digits that are left out there.
    assert!(x.abs() < 1e-9, "{x}");
    // Negative control: the same in coordinates counted from zero loses 1e-8 of the overlap.
    let lost = plain_overlap(far, 100) / plain_overlap(0.0, 100) - 1.0;
    assert!(lost.abs() > 1e-8, "{lost:e}");
}

//! Stress against forces: parts against the whole, the inside against the walls, moments against the
//! part that is not symmetric. Each holds as an identity with the out-of-balance forces of a moving
//! assembly, and without them at rest.

use ballast::engine::World;
use ballast::engine::neighbours::Slot;
use ballast::engine::setup::Dashpot;
use ballast::measure::assembly::Assembly;
use ballast::measure::region::Shape;
use ballast::measure::stress::Stress;
use ballast::measure::wall_force::WallForce;
use nalgebra::{Matrix2, Vector2};

use crate::packing::{box_of, built, close, compressed, measured, run, setup, stop};

/// Compressed until it carries a mean stress [Pa].
fn loaded(columns: u32, rows: u32, stress: f64) -> World {
    let mut world = built(compressed(columns, rows));
    for _ in 0..500 {
        if measured(&world, Shape::All).stress.isotropic() > stress {
            return world;
        }
        run(&mut world, 20);
    }
    panic!("the walls never met resistance");
}

/// Mean stress from where walls push, over the area they enclose.
fn from_walls(world: &World) -> Matrix2<f64> {
    let list = world.contacts();
    let mut sum = Matrix2::zeros();
    for (k, touch) in list.touches.iter().enumerate() {
        let Slot([fx, fy, ..]) = list.slots[list.pairs.len() + k];
        if fx != 0.0 || fy != 0.0 {
            sum -= Vector2::from(touch.at) * Vector2::new(fx, fy).transpose();
        }
    }
    sum / volume(world)
}

fn volume(world: &World) -> f64 {
    let content = measured(world, Shape::All).content;
    content.area * content.thickness
}

/// What out-of-balance forces do to the mean stress.
fn from_motion(world: &World) -> Matrix2<f64> {
    let p = world.particles();
    let mut sum = Matrix2::zeros();
    for k in 0..p.len() {
        sum += Vector2::from(p.row[k].x) * Vector2::from(p.force[k].f).transpose();
    }
    sum / volume(world)
}

fn skew(stress: &Stress) -> f64 {
    stress.total[(0, 1)] - stress.total[(1, 0)]
}

#[test]
fn parts_sum_to_the_independent_whole() {
    let mut world = loaded(8, 8, 1e3);
    let shapes = [
        Shape::All,
        Shape::Circle {
            centre: [8.0, 8.0],
            radius: 4.0,
        },
        Shape::Rectangle {
            min: [3.0, 4.0],
            max: [12.0, 9.0],
        },
    ];
    for _ in 0..20 {
        run(&mut world, 10);
        for shape in shapes {
            let m = measured(&world, shape);
            let (s, total) = (m.stress, m.stress.total.norm());
            // Some hundred terms, each rounded a few times.
            assert!((s.parts() - s.total).norm() < 1e-12 * total);
            assert!((s.fabric + s.normal_variation - s.normal).norm() < 1e-12 * total);
            // None of the parts could be missing.
            for part in [s.fabric, s.normal_variation, s.shear] {
                assert!(part.norm() > 1e-3 * total, "{part} {total}");
            }
            // Shear does no more than the whole; it does something.
            let share = s.sin_phi_of(&s.shear);
            assert!(share.abs() > 1e-6 && share.abs() < 1.0, "{share}");
            let parts = [s.fabric, s.normal_variation, s.shear];
            let shares = parts.iter().map(|part| s.sin_phi_of(part));
            assert!(close(shares.sum(), s.sin_phi(), 1e-12, 1.0));
        }
    }
}

#[test]
fn the_inside_balances_the_walls() {
    let mut world = loaded(8, 8, 5e3);
    let mut moving = 0.0_f64;
    for _ in 0..20 {
        run(&mut world, 5);
        let s = measured(&world, Shape::All).stress.total;
        let balance = from_walls(&world) + from_motion(&world);
        assert!((s - balance).norm() < 1e-12 * s.norm(), "{s} {balance}");
        moving = moving.max(from_motion(&world).norm() / s.norm());
    }
    // The assembly moved enough for that to be worth something.
    assert!(moving > 1e-4, "{moving}");
    stop(&mut world);
    run(&mut world, 20_000);
    let s = measured(&world, Shape::All).stress;
    let unbalanced = Assembly::of(&world).unbalanced;
    let off = (s.total - from_walls(&world)).norm() / s.total.norm();
    // Each particle's unbalanced force acts at up to the size of the box, its contacts at a radius.
    assert!(off < 16.0 * unbalanced, "{off} {unbalanced}");
    assert!(off < 1e-6, "{off}");
    // Platens as an experimenter reads them: force over the length of the other side.
    let force = |w: usize| WallForce::of(&world, w).force;
    let side = |a: usize, b: usize, k: usize| world.walls()[b].point[k] - world.walls()[a].point[k];
    let (width, height) = (side(0, 1, 0), side(2, 3, 1));
    let read = [force(1)[0] / height, force(3)[1] / width];
    for (k, read) in read.into_iter().enumerate() {
        // Friction on the other pair of walls acts over the size of a disc at most: they face each
        // other at nearly equal places.
        let by_friction =
            (force(2 - 2 * k)[k].abs() + force(3 - 2 * k)[k].abs()) / width.min(height);
        let own = s.total[(k, k)];
        assert!(
            (own - read).abs() <= by_friction + 1e-6 * own,
            "{own} {read}"
        );
    }
}

#[test]
fn moments_make_the_part_that_is_not_symmetric() {
    let mut world = loaded(8, 8, 5e3);
    let middle = Shape::Circle {
        centre: [8.0, 8.0],
        radius: 4.0,
    };
    let mut moving = 0.0_f64;
    for _ in 0..20 {
        run(&mut world, 5);
        let m = measured(&world, middle);
        let p = world.particles();
        let inside = (0..p.len()).filter(|&k| m.content.inside[k]);
        let moment: f64 = inside.map(|k| p.force[k].tau * p.row[k].radius).sum();
        let expected = -moment * m.content.per_volume();
        let scale = m.stress.isotropic();
        // The sign too: what is not symmetric is far above the rounding.
        assert!(
            close(skew(&m.stress), expected, 1e-12, scale),
            "{} {expected}",
            skew(&m.stress)
        );
        moving = moving.max(skew(&m.stress).abs() / scale);
    }
    assert!(moving > 1e-5, "{moving}");
    stop(&mut world);
    run(&mut world, 20_000);
    let m = measured(&world, middle);
    let rest = skew(&m.stress).abs() / m.stress.isotropic();
    assert!(rest < 1e-8 && rest < 1e-3 * moving, "{rest} {moving}");
    // At walls the branch ends at the surface, the lever arm in the circumference: what is left of
    // the whole assembly is the overlap times the friction there.
    let list = world.contacts();
    let mut left = 0.0;
    for k in list.pairs.len()..list.len() {
        left += world.geometry(k).overlap * world.reaction(k).tangential.abs();
    }
    let all = measured(&world, Shape::All);
    let (found, scale) = (skew(&all.stress).abs(), all.stress.isotropic());
    assert!(found <= left / volume(&world) + 1e-8 * scale);
    assert!(left > 0.0);
}

#[test]
fn nine_discs_show_the_friction_their_walls_feel() {
    let at = |k: u32| [f64::from(2 * (k % 3) + 1), f64::from(2 * (k / 3) + 1)];
    let discs: Vec<_> = (0..9).map(|k| (at(k), 1.0)).collect();
    let mut setup = setup(&discs);
    setup.damping.contact = Dashpot::Fraction(0.4);
    setup.walls = box_of([0.0; 2], [6.0; 2]);
    let mut world = built(setup);
    // Strain of 0.6 % in direction 1, 1.2 % in direction 2: each contact of a row shares its own.
    let time = 40.0 * world.dt();
    for (w, v) in [[0.018, 0.0], [-0.018, 0.0], [0.0, 0.036], [0.0, -0.036]]
        .into_iter()
        .enumerate()
    {
        world.set_wall_velocity(w, v.map(|v| v / time));
    }
    let walls = |world: &World| {
        let force = |w: usize| WallForce::of(world, w).force;
        let side = |a: usize, k: usize| world.walls()[a + 1].point[k] - world.walls()[a].point[k];
        let s1 = 0.5 * (force(1)[0] - force(0)[0]) / side(2, 1);
        let s2 = 0.5 * (force(3)[1] - force(2)[1]) / side(0, 0);
        (s2 - s1) / (s2 + s1)
    };
    // While it is loaded the walls feel something else than the inside.
    let mut ringing = 0.0_f64;
    for _ in 0..8 {
        run(&mut world, 5);
        let inside = measured(&world, Shape::All).stress.sin_phi();
        ringing = ringing.max((inside - walls(&world)).abs());
    }
    assert!(ringing > 1e-5, "{ringing}");
    stop(&mut world);
    run(&mut world, 4000);
    let m = measured(&world, Shape::All);
    let unbalanced = Assembly::of(&world).unbalanced;
    assert!(unbalanced < 1e-9, "{unbalanced}");
    let sin_phi = m.stress.sin_phi();
    assert!(close(sin_phi, walls(&world), 1e-9, 1.0));
    // Closed form: force per row goes as the strain, stress as force over the other side.
    let (s1, s2) = (0.006 / (6.0 - 0.072), 0.012 / (6.0 - 0.036));
    let exact = (s2 - s1) / (s2 + s1);
    assert!(close(sin_phi, exact, 1e-9, 1.0), "{sin_phi} {exact}");
    assert!((m.stress.principal().angle - 90.0).abs() < 1e-6);
    // A square packing whatever its forces: normals tell nothing, weighted ones everything.
    assert!(m.fabric.anisotropy() < 1e-14);
    let weighted = (0.012 - 0.006) / (0.012 + 0.006);
    assert!(close(m.fabric.anisotropy_weighted(), weighted, 1e-9, 1.0));
}

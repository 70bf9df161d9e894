//! What a world, or a session with one, once got wrong.

use std::fs;

use ballast::engine::World;
use ballast::engine::setup::Material;
use ballast::measure::columns::Column;
use ballast::record::checkpoint;
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

use crate::common::{floor, material, particle, scene, world};
use crate::{DISC, HEAD, PRESSED};

fn session(tables: &str) -> Session {
    session_with(tables, &[])
}

fn session_with(tables: &str, set: &[&str]) -> Session {
    let set: Vec<String> = set.iter().map(|&option| option.to_owned()).collect();
    let scene = Scene::parse("p.toml", &format!("{HEAD}{tables}"), &set);
    let scene = scene.unwrap_or_else(|why| panic!("{why}"));
    Session::open(scene, Options::default()).expect("it begins")
}

fn run(session: &mut Session, line: &str) {
    session
        .type_line(line)
        .unwrap_or_else(|why| panic!("{why}"));
    session.advance(Budget::default(), false).expect("it runs");
}

fn value(session: &mut Session, column: &str) -> f64 {
    let column = Column::parse(column).expect("it is in the list");
    session.sample().value(&column)
}

/// With the velocity of the boundary both are those of a parabola; with that of the half step before
/// kinetic energy lacks a tenth after ten steps.
#[test]
fn kinetic_energy_is_that_of_the_boundary() {
    let mut fall = session(DISC);
    run(&mut fall, "gravity 0 -10");
    let mass = 1e3 * std::f64::consts::PI * 0.1 * 0.1;
    for _ in 0..10 {
        run(&mut fall, "cycle 1");
        let (kinetic, potential) = (value(&mut fall, "kinetic"), value(&mut fall, "potential"));
        assert!(kinetic > 0.0);
        assert!(
            (kinetic + potential).abs() < 1e-12 * kinetic,
            "{kinetic} {potential}"
        );
        let v = value(&mut fall, "particle:1:vy");
        assert!((kinetic - 0.5 * mass * v * v).abs() < 1e-12 * kinetic);
    }
}

/// Wherever the disc is, and whether energies are booked or not.
#[test]
fn the_potential_is_zero_at_the_start() {
    let high = DISC.replace("at = [0, 0]", "at = [0, 5]");
    for columns in ["potential", "energy_error"] {
        let tables = format!("{high}[history]\ncolumns = [\"{columns}\"]\n");
        let mut fall = session_with(&tables, &["model.gravity=[0.0, -10.0]"]);
        assert_eq!(value(&mut fall, "potential"), 0.0, "{columns}");
        run(&mut fall, "cycle 10");
        assert!(value(&mut fall, "potential") < 0.0, "{columns}");
    }
}

/// Two discs that are listed twice, and touch across the edge of the cell only.
#[test]
fn a_contact_is_the_image_that_touches() {
    let cell = "[cell]\nsize = [0.42, 1]\n";
    let at = |x: f64| format!("[[particle]]\nat = [{x}, 0.5]\nradius = 0.1\nmaterial = \"m\"\n");
    let tables = format!("{cell}{}{}", at(0.05), at(0.281));
    let mut pair = session_with(&tables, &["model.tol=0.3", "model.overlap=\"allow\""]);
    let pairs = pair.world().contacts().pairs.iter();
    assert_eq!(pairs.filter(|pair| **pair == [0, 1]).count(), 2);
    let [n, most] = ["contact:1-2:n", "max_force"].map(|column| value(&mut pair, column));
    assert!(most > 1e3 && n == most, "{n} {most}");
}

/// Columns of discs pressed along one direction only: the servo has to see that, whichever it is.
#[test]
fn a_servo_does_not_mind_which_way_is_up() {
    let rates = [[0.25, 0.199], [0.199, 0.25]].map(|[a, b]| {
        let mut pressed = session(&format!(
            "[cell]\nsize = [{a}, {b}]\n[[particle]]\nat = [0, 0]\nradius = 0.1\nmaterial = \"m\"\n"
        ));
        run(&mut pressed, "servo deviator 0");
        run(&mut pressed, "cycle 100");
        ["strain_rate_11", "strain_rate_22"].map(|column| value(&mut pressed, column))
    });
    let [[a, b], [c, d]] = rates;
    assert!(a.abs() > 0.0 && b.abs() > 0.0, "{rates:?}");
    assert!(
        (a - d).abs() < 1e-9 * a.abs() && (b - c).abs() < 1e-9 * b.abs(),
        "{rates:?}"
    );
}

/// A wall whose friction is set again meets materials that came after its own.
#[test]
fn the_friction_of_a_wall_meets_all_materials() {
    let mut setup = scene(material(1e6, 1e6, 0.5));
    setup.particles = vec![particle(0.0, 0.999, 1.0), particle(3.0, 0.999, 1.0)];
    setup.walls = vec![floor()];
    let mut kept: World = world(setup.clone());
    kept.set_wall_friction("floor", 0.5);
    let stored = checkpoint::encode(&kept).expect("it is stored");
    let kept: World = checkpoint::decode(&stored).expect("it is what was stored");
    let smooth = Material {
        name: "smooth".into(),
        ..material(1e6, 1e6, 0.1)
    };
    setup.materials.push(smooth);
    setup.particles.clear();
    setup.walls.clear();
    let mut world = kept.reopen(&setup, 1).expect("its contacts fit");
    let place = |name: &str| world.model().materials.iter().position(|m| m.name == name);
    let [own, new] = ["disc@floor", "smooth"].map(|name| place(name).expect("it is there"));
    assert!(own < new);
    world.create(&ballast::engine::setup::ParticleSetup {
        material: new,
        ..particle(6.0, 0.999, 1.0)
    });
    world.set_wall_friction("floor", 0.7);
    let at_wall = (0..world.contacts().len()).map(|k| world.pair_of(k).friction);
    assert_eq!(at_wall.collect::<Vec<_>>(), [0.7; 3]);
}

/// Discs that come into an empty world are listed with their neighbours, not with all.
#[test]
fn an_empty_world_is_measured_when_its_first_particles_come() {
    let mut world = world(scene(material(1e6, 1e6, 0.5)));
    let grid = |k: u32| particle(f64::from(k % 20) * 2.5e-3, f64::from(k / 20) * 2.5e-3, 1e-3);
    let discs: Vec<_> = (0..400).map(grid).collect();
    world.create_all(&discs);
    assert!(world.contacts().pairs.is_empty());
    assert!(world.tol() < 1e-3, "{}", world.tol());
}

/// A cell that is sheared on and on takes other edges of the same lattice, and the contacts are those of all
/// particles with all images, worked out one by one.
#[test]
fn a_cell_can_be_sheared_without_end() {
    let mut tables = String::from("[cell]\nsize = [0.84, 0.84]\n");
    for k in 0..16 {
        let [x, y] = [k % 4, k / 4].map(|n| 0.21 * f64::from(n) + 0.02 * f64::from(k % 3));
        tables += &format!("[[particle]]\nat = [{x}, {y}]\nradius = 0.11\nmaterial = \"m\"\n");
    }
    let dashpots = "damping.contact=0.5";
    for rate in ["0 -1 0 0", "0 0 -1 0", "0 1 0 0"] {
        let mut sheared = session_with(&tables, &[dashpots, "model.overlap=\"allow\""]);
        sheared
            .type_line(&format!("strain rate {rate}"))
            .expect("it is accepted");
        let (mut turns, mut before) = (0, sheared.world().cell().expect("a cell").edges);
        for _ in 0..200 {
            run(&mut sheared, "cycle 100");
            let world = sheared.world();
            let cell = world.cell().expect("a cell");
            let leans = |a: f64, b: f64| (a - b).abs() > 0.4;
            turns += usize::from(
                leans(cell.edges[1][0], before[1][0]) || leans(cell.edges[0][1], before[0][1]),
            );
            before = cell.edges;
            assert!(cell.widths().iter().all(|width| *width > 0.7), "{cell:?}");
            let list = world.contacts();
            let found: f64 = (0..list.pairs.len())
                .map(|k| world.geometry(k).overlap.max(0.0))
                .sum();
            let rows = &world.particles().row;
            let mut all = 0.0;
            for (i, a) in rows.iter().enumerate() {
                for b in &rows[..i] {
                    let d = [0, 1].map(|k| a.x[k] - b.x[k]);
                    let d = cell.nearest(d);
                    for (n, m) in (-2..=2).flat_map(|n| (-2..=2).map(move |m| (n, m))) {
                        let shift = cell.shift([n, m]);
                        let far = f64::hypot(d[0] + shift[0], d[1] + shift[1]);
                        all += (a.radius + b.radius - far).max(0.0);
                    }
                }
            }
            assert!(
                all > 0.0 && (found - all).abs() < 1e-9 * all,
                "{found} {all}"
            );
        }
        assert!(turns > 10, "{rate}: {turns}");
    }
}

/// Cycles that run on after the last stage write no dumps but those that are due.
#[test]
fn a_run_that_goes_on_after_its_stages_dumps_no_more_than_before() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut session = session(&format!(
        "{PRESSED}[dump]\nevery = 10\nwhat = [\"contacts\"]\n[[stage]]\nname = \"a\"\nmax_cycles = 3\n"
    ));
    session.write_dumps(&folder.path().join("x.csv"));
    let budget = Budget {
        until_cycle: Some(12),
        time: None,
    };
    session.advance(budget, true).expect("it runs");
    assert_eq!(session.world().cycle_number(), 12);
    let files = fs::read_dir(folder.path()).expect("it is there");
    let name = |file: std::io::Result<fs::DirEntry>| file.expect("it is there").file_name();
    let mut names: Vec<String> = files
        .map(|file| name(file).to_string_lossy().into_owned())
        .collect();
    names.sort();
    let cycles = [0, 3, 10].map(|cycle| format!("x.contacts.{cycle:010}.csv"));
    assert_eq!(names, cycles);
}

//! The command `generate`.

use crate::scene;
use ballast::scene::Scene;
use ballast::session::{Budget, By, Options, Replay, Session};

const TABLES: &str = "[material.n]\ndensity = 2e3\nnormal_stiffness = 1e6\n\
                      [[particle]]\nat = [0, 0]\nradius = 0.3\nmaterial = \"m\"\nvelocity = [0.25, 0]\n\
                      [[wall]]\nname = \"floor\"\nfrom = [-1, -0.5]\nto = [1, -0.5]\nmaterial = \"m\"\nvelocity = [0, 0.5]\n";

fn open(scene: Scene) -> Session {
    Session::open(scene, Options::default()).expect("it is sound")
}

fn places(session: &Session) -> Vec<[f64; 2]> {
    let world = session.world();
    (0..world.particles().len())
        .map(|p| world.position(p))
        .collect()
}

/// Smallest distance between surfaces, the wall's too.
fn least(session: &Session) -> f64 {
    let world = session.world();
    let (places, rows) = (places(session), &world.particles().row);
    let floor = world.walls()[0].point[1] + world.origin()[1];
    let mut least = f64::INFINITY;
    for i in 0..places.len() {
        least = least.min(places[i][1] - floor - rows[i].radius);
        for j in 0..i {
            let apart = (places[i][0] - places[j][0]).hypot(places[i][1] - places[j][1]);
            least = least.min(apart - rows[i].radius - rows[j].radius);
        }
    }
    least
}

fn budget(cycle: u64) -> Budget {
    Budget {
        until_cycle: Some(cycle),
        time: None,
    }
}

fn run(session: &mut Session, cycles: u64) {
    let to = session.world().cycle_number() + cycles;
    while session.world().cycle_number() < to {
        session.advance(budget(to), false).expect("it runs");
    }
}

#[test]
fn it_adds_where_there_is_room_now() {
    let mut session = open(scene(TABLES));
    // The wall and the particle move from where the preset has them.
    session.type_line("cycle 40").expect("a command");
    run(&mut session, 40);
    let reply = session
        .type_line("generate in rectangle -1 -1 1 1 radius 0.05 count 20 material n")
        .expect("there is room");
    assert_eq!(reply.lines, ["particles 2 to 21"]);
    let added = &session.world().particles().material[1..];
    assert!(added.len() == 20 && added.iter().all(|&m| m == 1));
    // Below the wall there is room too: `least` counts those as deep inside.
    let floor = session.world().walls()[0].point[1] + session.world().origin()[1];
    assert!(floor > -0.5, "it moved");
    let above = places(&session).iter().filter(|at| at[1] > floor).count();
    let below = places(&session).iter().filter(|at| at[1] < floor).count();
    assert!(above > 1 && below > 0);
    assert!(
        places(&session)
            .iter()
            .skip(1)
            .all(|at| (at[1] - floor).abs() >= 0.05 - 1e-14)
    );
    let reply = session
        .type_line("generate in circle 0.5 0.3 0.2 radius 0.02")
        .expect("room");
    assert!(reply.lines[0].starts_with("particles 22 to "), "{reply:?}");
    let refused = session.type_line("generate in circle 0 0 0.29 radius 0.02");
    let refused = refused.expect_err("inside of particle 1").to_string();
    assert!(
        refused.contains("no room for a particle of radius 0.02 m"),
        "{refused}"
    );
    let refused = session.type_line("generate in rectangle 0 0 9 9 radius 1e-5");
    assert!(
        refused
            .expect_err("too many")
            .to_string()
            .contains("give a count")
    );
}

#[test]
fn a_full_region_says_how_many_found_no_room() {
    let mut session = open(scene(TABLES));
    let reply = session
        .type_line("generate in rectangle -1 -0.5 1 1 radius 0.1 count 500")
        .expect("there is room for some");
    let count = session.world().particles().len() - 1;
    assert!((20..100).contains(&count), "{count}");
    let said = format!(
        "particles 2 to {}; no room for {} more",
        count + 1,
        500 - count
    );
    assert_eq!(reply.lines, [said]);
    assert!(least(&session) > -1e-14);
}

#[test]
fn a_replay_gives_the_same_places() {
    let mut session = open(scene(TABLES));
    session.type_line("cycle 10").expect("a command");
    run(&mut session, 10);
    session
        .execute(
            &"generate in circle 0.5 0.5 0.3 radius 0.02 count 30"
                .parse()
                .expect("a line"),
            By::User,
        )
        .expect("room");
    session
        .type_line("generate in circle -0.5 0.5 0.3 radius 0.02 count 30")
        .expect("room");
    session.type_line("cycle 10").expect("a command");
    run(&mut session, 10);
    let journal = session.journal().clone();
    let mut again = open(scene(TABLES));
    let mut replay = Replay::new(&journal, again.scene());
    for _ in 0..100 {
        again
            .advance_replay(&mut replay, budget(20))
            .expect("it replays");
    }
    assert_eq!(places(&again), places(&session));
    // Two generated at one cycle, and two seeds, differ.
    let p = places(&session);
    assert!((p[1][0] - p[31][0] - 1.0).abs() > 1e-6);
    let mut other = open(crate::scene_with(TABLES, &["model.seed=2"]));
    other
        .type_line("generate in circle 0.5 0.5 0.3 radius 0.02 count 30")
        .expect("room");
    assert!(places(&other)[1] != p[1]);
}

#[test]
fn a_stage_may_generate() {
    let tables = TABLES.to_owned()
        + "[history]\ncolumns = [\"particle:3:x\"]\n\
           [[stage]]\nname = \"s\"\ndo = [\"generate in circle 0.5 0.5 0.3 radius 0.02 count 2\"]\nmax_cycles = 2\n";
    let mut session = open(scene(&tables));
    while !session.is_finished() {
        session.advance(budget(10), false).expect("it runs");
    }
    assert_eq!(session.world().particles().len(), 3);
}

#[test]
fn images_of_a_periodic_cell_are_in_the_way() {
    let tables = "[cell]\nsize = [1, 1]\n\
                  [[particle]]\nat = [0.1, 0.5]\nradius = 0.3\nmaterial = \"m\"\n";
    let mut session = open(scene(tables));
    session
        .type_line("generate in rectangle 0 0 1 1 radius 0.05")
        .expect("room");
    let added = places(&session);
    assert!(added.len() > 20, "{}", added.len());
    for at in &added[1..] {
        let image = (at[0] - 1.1).hypot(at[1] - 0.5);
        assert!(image >= 0.35 - 1e-14, "{at:?}");
    }
    let refused = session.type_line("generate in rectangle 0.5 0 1.5 1 radius 0.01");
    assert!(
        refused
            .expect_err("out")
            .to_string()
            .contains("out of the periodic cell")
    );
}

//! PRINT: BALL's tables, one file each. They read a world and change nothing but the sums of its
//! forces, which a cycle would make anyway.

mod averages;
mod balls;
mod boundary;
mod contacts;
mod energy;
mod layout;
mod materials;
mod measures;
mod step;
mod walls;

pub use boundary::boundary_itself;

pub(super) use balls::prescribed;
pub(super) use contacts::{Carried, DEEP, WIDE, has_areas};
pub(super) use layout::listed;
pub(super) use materials::dashpots;

use std::borrow::Cow;

use super::places::regions_of;
use crate::engine::World;
use crate::language::command::Printout;
use crate::measure::reference::Reference;
use crate::measure::region::Region;
use crate::measure::sample::Sample;
use measures::Place;

/// The lines of a table. `averages`: balls and contacts show largest, smallest and mean only.
pub(super) fn table(
    world: &mut World,
    regions: &[Region],
    reference: &Reference,
    what: &Printout,
    averages: bool,
) -> Vec<String> {
    let regions = match what {
        Printout::Measure(_, place) | Printout::Profile(place, _) => regions_of(place, regions),
        _ => Cow::Borrowed(regions),
    };
    let sample = Sample::over(world, &regions, Some(reference));
    let world = sample.world();
    match what {
        Printout::Balls(range) if averages => averages::balls(world, *range),
        Printout::Balls(range) => balls::lines(world, reference, *range),
        Printout::Contacts(range) if averages => averages::contacts(world, *range),
        Printout::Contacts(range) => contacts::lines(world, *range),
        Printout::Walls => walls::lines(world),
        Printout::Types => materials::lines(world),
        Printout::Boundary => boundary::lines(world),
        Printout::Energy => energy::lines(world),
        Printout::Step => step::lines(world),
        Printout::Measure(measure, place) => measures::lines(&sample, *measure, place),
        Printout::Profile(place, rings) => measures::profile(&Place::of(&sample, place), *rings),
        Printout::Polygon(id) => measures::polygon(world, *id),
        Printout::Averages => [
            averages::balls(world, None),
            vec![String::new()],
            averages::contacts(world, None),
        ]
        .concat(),
        Printout::All => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::command::{Measure, Where};
    use crate::scene::Scene;
    use crate::session::{Budget, Options, Session};

    /// Discs and a wall under everything that makes a number long or a row odd.
    const SCENE: &str = r#"
        [model]
        body = "disc"
        gravity = [0.0, -9.81]
        [damping]
        contact = 0.1
        [material."a-material-with-a-name-that-is-too-long"]
        density = 2650.0
        normal_stiffness = 1.234567e9
        shear_stiffness = 1.234567e9
        friction = 0.123456789
        cohesion = 1.234567e-7
        [[particle]]
        at = [-1.23456789e-3, 0.99e-3]
        radius = 1e-3
        material = "a-material-with-a-name-that-is-too-long"
        velocity = [-1.2345678e-5, -0.123456789]
        spin = -1234567.89
        [[particle]]
        at = [0.77e-3, 1.01e-3]
        radius = 1e-3
        material = "a-material-with-a-name-that-is-too-long"
        fixed = ["x"]
        [[particle]]
        at = [50e-3, 50e-3]
        radius = 1e-3
        material = "a-material-with-a-name-that-is-too-long"
        driven = true
        [[wall]]
        name = "floor"
        from = [-1.0, 0.0]
        to = [1.0, -1.23456789e-7]
        material = "a-material-with-a-name-that-is-too-long"
        [history]
        columns = ["energy_error"]
        [[stage]]
        name = "fall"
        max_cycles = 7
    "#;

    fn tables() -> Vec<Printout> {
        let mut tables = vec![
            Printout::Balls(None),
            Printout::Contacts(None),
            Printout::Walls,
            Printout::Types,
            Printout::Boundary,
            Printout::Energy,
            Printout::Step,
            Printout::Averages,
            Printout::Profile(Where::Default, Some(3)),
            Printout::Polygon(2),
        ];
        tables.extend(Measure::all().map(|measure| Printout::Measure(measure, Where::Default)));
        tables
    }

    fn printed(session: &mut Session, what: &Printout, averages: bool) -> Vec<String> {
        let Session {
            world,
            scene,
            reference,
            ..
        } = session;
        table(world, &scene.regions, reference, what, averages)
    }

    fn session() -> Session {
        opened(SCENE)
    }

    fn opened(scene: &str) -> Session {
        let scene = Scene::parse("tables", scene, &[]).unwrap();
        let mut session = Session::open(scene, Options::default()).unwrap();
        session.advance(Budget::default(), false).unwrap();
        session
    }

    #[test]
    fn no_table_is_wider_than_a_line() {
        let spheres = SCENE.replace("body = \"disc\"", "law = \"linear\"\ntime_step = 1e-6");
        for scene in [SCENE, &spheres] {
            let mut session = opened(scene);
            for (what, averages) in tables().iter().flat_map(|t| [(t, false), (t, true)]) {
                let lines = printed(&mut session, what, averages);
                assert!(!lines.is_empty(), "{what}");
                for line in lines {
                    assert!(line.chars().count() <= layout::WIDTH, "{line}");
                    assert_eq!(line, line.trim_end(), "{what}");
                }
            }
        }
    }

    #[test]
    fn printing_changes_nothing() {
        let (mut watched, mut other) = (session(), session());
        for _ in 0..20 {
            for what in tables() {
                printed(&mut watched, &what, false);
            }
            watched.world.cycle().unwrap();
            other.world.cycle().unwrap();
        }
        assert_eq!(watched.world.state_hash(), other.world.state_hash());
        assert_eq!(watched.world.fracc_monitor(), other.world.fracc_monitor());
        assert_eq!(watched.world.bookings(), other.world.bookings());
    }

    #[test]
    fn empty_tables_say_so_in_words() {
        let scene = Scene::parse("one", &SCENE.replace("[history]", "[history] # "), &[]);
        let mut session = Session::open(scene.unwrap(), Options::default()).unwrap();
        session.type_line("delete 1-3").unwrap();
        session.type_line("wall floor delete").unwrap();
        for what in [
            Printout::Balls(None),
            Printout::Contacts(None),
            Printout::Walls,
            Printout::Boundary,
        ] {
            for averages in [false, true] {
                let lines = printed(&mut session, &what, averages);
                assert_eq!(lines.len(), 1, "{lines:?}");
                assert!(lines[0].contains("no"), "{lines:?}");
            }
        }
    }
}

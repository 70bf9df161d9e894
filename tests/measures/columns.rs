//! Columns: every one in the list has a value, under every name it goes by.

use ballast::engine::World;
use ballast::engine::setup::{Body, BoundarySetup, LawChoice, TimeStepChoice};
use ballast::measure::columns::{CONTACT, Card, Column, Kind, assembly, listing};
use ballast::measure::reference::Reference;
use ballast::measure::region::{Region, Shape};
use ballast::measure::sample::Sample;

use crate::packing::{built, compressed, run, setup, wall};

#[test]
fn every_listed_column_has_a_value() {
    let mut setup = compressed(6, 6);
    setup.ledger = true;
    setup.boundary = Some(BoundarySetup::Walls { centre: [6.0; 2] });
    let mut world = built(setup);
    run(&mut world, 400);
    let reference = Reference::of(&world);
    run(&mut world, 20);
    let core = Region {
        name: "core".into(),
        shape: Shape::Circle {
            centre: [6.0, 6.0],
            radius: 4.0,
        },
    };
    let regions = [core];
    let [i, j] = world.contacts().pairs[0].map(|p| world.particles().id[p as usize]);
    let wall = &world.contacts().walls[0];
    let (k, wall) = (
        world.particles().id[wall.particle as usize],
        world.walls()[wall.wall as usize].name.clone(),
    );
    let sample = Sample::over(&mut world, &regions, Some(&reference));
    assert!(sample.assembly().contacts > 40.0);
    let has_value = |name: &str| {
        let column = Column::parse(name).expect("it is in the list");
        assert_eq!(column.name(), name);
        let value = sample.value(&column);
        assert!(
            value.is_finite() || column.kind() == Kind::Hash,
            "{name}: {value}"
        );
    };
    for (family, Card { name, .. }) in listing() {
        match family {
            "" => has_value(name),
            "region:NAME:" => has_value(&format!("region:core:{name}")),
            "wall:NAME:" => has_value(&format!("wall:{wall}:{name}")),
            // Stresses and slip belong to spheres, below.
            "contact:I-J:" if ["n", "t", "alpha", "delta", "a"].contains(name) => {
                has_value(&format!("contact:{i}-{j}:{name}"));
                has_value(&format!("contact:{k}-{wall}:{name}"));
            }
            "contact:I-J:" => {}
            "particle:I:" => has_value(&format!("particle:2:{name}")),
            "material:NAME:" => has_value(&format!("material:m:{name}")),
            other => panic!("no example of {other}"),
        }
    }
    for row in assembly().filter(|row| row.is_regional()) {
        has_value(&format!("region:core:{}", row.card.name));
    }
}

/// Spheres with friction have all columns of contacts; what a law or a scene does not know is NaN.
#[test]
fn every_column_of_a_contact_has_a_value_where_it_has_a_meaning() {
    let spheres = |law: &str, ledger: bool| {
        let mut setup = setup(&[([0.0, 0.0], 1.0), ([1.9999, 0.0], 1.0)]);
        let law = LawChoice::named(law).expect("it is in the list");
        (setup.body, setup.law, setup.ledger) = (Body::Sphere, law, ledger);
        let material = &mut setup.materials[0];
        (material.young, material.poisson) = (Some(1e9), Some(0.3));
        material.friction = 0.4;
        // These springs are not constant: there is no critical step.
        setup.time_step = TimeStepChoice::Seconds(1e-7);
        setup.frac = 1.0;
        setup.particles[0].velocity = [0.01, 0.02];
        setup.walls = vec![wall("floor", [-2.0, -0.9999], [2.0, -0.9999])];
        let mut world = built(setup);
        run(&mut world, 3);
        world
    };
    let value = |world: &mut World, contact: &str, name: &str| {
        let column = Column::parse(&format!("contact:{contact}:{name}")).expect("it is listed");
        Sample::of(world).value(&column)
    };
    for contact in ["1-2", "1-floor"] {
        let mut world = spheres("mindlin-deresiewicz-exact", true);
        for row in CONTACT {
            let name = row.card.name;
            assert!(
                value(&mut world, contact, name).is_finite(),
                "{contact}:{name}"
            );
        }
        let mut unbooked = spheres("mindlin-deresiewicz-exact", false);
        assert!(value(&mut unbooked, contact, "friction_loss").is_nan());
        let mut held = spheres("hertz-mindlin", true);
        assert!(value(&mut held, contact, "c_over_a").is_nan());
        assert!(value(&mut held, contact, "p0") > 0.0);
        let mut linear = spheres("linear", true);
        assert!(value(&mut linear, contact, "p0").is_nan());
    }
}

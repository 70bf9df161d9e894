//! Columns: every one in the list has a value, under every name it goes by.

use ballast::measure::columns::{Card, Column, Kind, assembly, listing};
use ballast::measure::reference::Reference;
use ballast::measure::region::{Region, Shape};
use ballast::measure::sample::Sample;

use crate::packing::{built, compressed, run};

#[test]
fn every_listed_column_has_a_value() {
    let mut setup = compressed(6, 6);
    setup.ledger = true;
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
            "contact:I-J:" => {
                has_value(&format!("contact:{i}-{j}:{name}"));
                has_value(&format!("contact:{k}-{wall}:{name}"));
            }
            "particle:I:" => has_value(&format!("particle:2:{name}")),
            "material:NAME:" => has_value(&format!("material:m:{name}")),
            other => panic!("no example of {other}"),
        }
    }
    for row in assembly().filter(|row| row.is_regional()) {
        has_value(&format!("region:core:{}", row.card.name));
    }
}

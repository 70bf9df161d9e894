//! Largest, smallest and mean of what balls and contacts show (Randall 1989, 4.6). Of his eight
//! parameters of either seven are listed; the speed, the share of friction in use and the overlap are
//! added, and those of the contact area are shown where there is a circle.

use super::super::figure::figure;
use super::contacts::Carried;
use super::layout::{Table, number, words};
use super::{balls, contacts};
use crate::engine::World;
use crate::language::command::ParticleRange;
use crate::measure::load::load;

/// One parameter of one item: what it is called, its value.
type Value = (String, f64);

/// Name and unit of a parameter, and where its value comes from.
type Parameter<F> = (&'static str, &'static str, F);

/// A parameter of a contact; `None` where it is not defined.
type OfContact = fn(&Carried) -> Option<f64>;

/// Over particles.
pub(super) fn balls(world: &World, range: Option<ParticleRange>) -> Vec<String> {
    let chosen = balls::chosen(world, range);
    if chosen.is_empty() {
        return balls::none(range);
    }
    let speed = |p: usize| {
        let [x, y] = world.velocity(p).0;
        (x * x + y * y).sqrt()
    };
    let rows: [Parameter<&dyn Fn(usize) -> f64>; 8] = [
        ("angle", "rad", &|p| world.particles().row[p].angle),
        ("vx", "m/s", &|p| world.velocity(p).0[0]),
        ("vy", "m/s", &|p| world.velocity(p).0[1]),
        ("speed", "m/s", &speed),
        ("spin", "rad/s", &|p| world.velocity(p).1),
        ("Fx", "N", &|p| load(world, p).0[0]),
        ("Fy", "N", &|p| load(world, p).0[1]),
        ("moment", "N m", &|p| load(world, p).1),
    ];
    let mut table = empty();
    for (name, unit, value) in rows {
        let values = chosen.iter();
        let values = values.map(|&p| (world.particles().id[p].to_string(), value(p)));
        table.row(row(name, unit, &values.collect::<Vec<_>>()));
    }
    with_count("balls", chosen.len(), &table)
}

/// Over touching contacts.
pub(super) fn contacts(world: &World, range: Option<ParticleRange>) -> Vec<String> {
    let chosen = contacts::chosen(world, range);
    if chosen.is_empty() {
        return contacts::none(world, range);
    }
    let rows: [Parameter<OfContact>; 9] = [
        ("n", "N", |c| Some(c.normal)),
        ("t", "N", |c| Some(c.tangential)),
        ("angle", "deg", |c| Some(c.angle)),
        ("|t|/mu n", "-", |c| c.obliquity),
        ("overlap/d", "-", |c| Some(c.depth)),
        ("a", "m", |c| Some(c.area.radius)),
        ("sigma_n", "Pa", |c| Some(c.stress()[0])),
        ("sigma_t", "Pa", |c| Some(c.stress()[1])),
        ("a/R", "-", |c| Some(c.area.relative())),
    ];
    let shown = if contacts::has_areas(world) { 9 } else { 5 };
    let mut table = empty();
    for (name, unit, value) in rows.into_iter().take(shown) {
        let values = chosen.iter().filter_map(|c| Some((c.bodies(), value(c)?)));
        table.row(row(name, unit, &values.collect::<Vec<_>>()));
    }
    with_count("contacts", chosen.len(), &table)
}

fn empty() -> Table {
    Table::new(
        1,
        &[
            words("parameter"),
            words("unit"),
            number("largest", ""),
            words("of"),
            number("smallest", ""),
            words("of"),
            number("mean", ""),
        ],
    )
}

fn with_count(what: &str, count: usize, table: &Table) -> Vec<String> {
    let mut lines = vec![format!("{what}: {count}")];
    lines.extend(table.lines());
    lines
}

/// A dash everywhere where the parameter is defined nowhere.
fn row(name: &str, unit: &str, values: &[Value]) -> Vec<String> {
    let mut cells = vec![name.to_owned(), unit.to_owned()];
    let (Some(first), count) = (values.first(), values.len()) else {
        cells.extend(std::iter::repeat_n("-".to_owned(), 5));
        return cells;
    };
    // The first of equals, so that the answer does not depend on more than the numbers.
    let (mut most, mut least, mut sum) = (first, first, 0.0);
    for value in values {
        if value.1 > most.1 {
            most = value;
        }
        if value.1 < least.1 {
            least = value;
        }
        sum += value.1;
    }
    for (of, value) in [most, least] {
        cells.extend([figure(*value), super::layout::name(of)]);
    }
    cells.push(figure(sum / count as f64));
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn largest_smallest_and_mean() {
        let values = [("1", 2.0), ("2", -4.0), ("3", 2.0), ("4", 1.0)];
        let values = values.map(|(of, value)| (of.to_owned(), value));
        assert_eq!(
            row("vx", "m/s", &values),
            ["vx", "m/s", "2", "1", "-4", "2", "0.25"]
        );
        assert_eq!(row("vx", "m/s", &[])[2..], ["-"; 5]);
    }
}

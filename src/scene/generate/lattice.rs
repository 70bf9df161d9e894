//! Regular arrangements: every site whose own circle, of the spacing as diameter, lies in the region.

use super::crowd::Disc;
use super::region::Region;
use crate::scene::reader::Reader;

/// Kinds of lattice.
pub(super) const KINDS: &[&str] = &["square", "hexagonal"];

/// A lattice.
pub(super) struct Lattice {
    hexagonal: bool,
    /// Distance of neighbours [m].
    spacing: f64,
    /// Radius of the particles [m].
    radius: f64,
}

/// Sides of a rectangle that are a multiple of the spacing but for rounding, relative to the spacing.
const SLACK: f64 = 1e-9;

impl Lattice {
    /// Distance of rows [m].
    fn row(&self) -> f64 {
        if self.hexagonal {
            self.spacing * (0.5 * 3f64.sqrt())
        } else {
            self.spacing
        }
    }

    /// Its particles, row by row from below.
    pub(super) fn fill(&self, region: &Region, periodic: bool) -> Vec<Disc> {
        let (s, row) = (self.spacing, self.row());
        let [min, max] = region.bounds();
        // A site: in a circle the centre, else the first of all.
        let site = match (region, periodic, self.hexagonal) {
            (_, true, true) => [min[0] + 0.25 * s, min[1] + 0.5 * row],
            (Region::Circle { centre, .. }, ..) => *centre,
            _ => min.map(|x| x + 0.5 * s),
        };
        let steps = |from: f64, to: f64, step: f64| ((to - from) / step) as i64 + 1;
        let (left, right) = (steps(min[0], site[0], s), steps(site[0], max[0], s));
        let (down, up) = (steps(min[1], site[1], row), steps(site[1], max[1], row));
        let mut discs = Vec::new();
        for j in -down..=up {
            // Every other row stands between the sites of those beside it.
            let shift = if self.hexagonal && j % 2 != 0 {
                0.5 * s
            } else {
                0.0
            };
            for i in -left..=right {
                let at = [site[0] + shift + i as f64 * s, site[1] + j as f64 * row];
                let needed = if periodic { 0.0 } else { 0.5 * s };
                if region.depth(at) >= needed - SLACK * s {
                    let radius = self.radius;
                    discs.push(Disc { at, radius });
                }
            }
        }
        discs
    }

    /// Radius of the particles [m].
    pub(super) fn radius(&self) -> f64 {
        self.radius
    }
}

/// Reads it; reports one that does not fit a periodic cell.
pub(super) fn read(
    reader: &Reader<'_>,
    region: &Region,
    gap: f64,
    periodic: bool,
) -> Option<Lattice> {
    let hexagonal = reader.word("lattice")? == "hexagonal";
    if !reader.has("radius") {
        reader.refuse(
            "lattice",
            &format!("{} has no `radius`", reader.title),
            "a lattice needs the radius of its particles",
            "add radius = number > 0 [m]",
        );
        return None;
    }
    let radius = reader.number("radius")?;
    let spacing = if reader.has("spacing") {
        reader.number("spacing")?
    } else {
        2.0 * radius + gap
    };
    let lattice = Lattice {
        hexagonal,
        spacing,
        radius,
    };
    let most = region.area() / (spacing * lattice.row());
    if most > super::MOST as f64 {
        reader.refuse(
            if reader.has("spacing") {
                "spacing"
            } else {
                "radius"
            },
            &format!("the lattice has {most:.0} particles"),
            &format!("expected {} at most", super::MOST),
            "lengths are in metres: give a larger spacing or a smaller region",
        );
        return None;
    }
    if periodic {
        check_cell(reader, &lattice, region)?;
    }
    Some(lattice)
}

fn check_cell(reader: &Reader<'_>, lattice: &Lattice, region: &Region) -> Option<()> {
    let [min, max] = region.bounds();
    let steps = [
        lattice.spacing,
        if lattice.hexagonal {
            2.0 * lattice.row()
        } else {
            lattice.row()
        },
    ];
    for (k, name) in ["wide", "high"].into_iter().enumerate() {
        let (side, step) = (max[k] - min[k], steps[k]);
        let number = (side / step).round().max(1.0);
        if (side - number * step).abs() > SLACK * lattice.spacing * number.max(1.0) {
            reader.refuse(
                "in",
                &format!(
                    "the lattice of {} does not close: the cell is {side} m {name}",
                    reader.title
                ),
                &format!("expected a multiple of {step} m"),
                &format!(
                    "make it {} m {name}: {number} times {step} m",
                    number * step
                ),
            );
            return None;
        }
    }
    Some(())
}

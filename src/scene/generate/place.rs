//! `in`: the region of a `[[generate]]`.

use super::region::{Region, length, sides};
use crate::scene::reader::Reader;

/// Reads it; reports one that has no inside.
pub(super) fn read(reader: &Reader<'_>) -> Option<Region> {
    let table = reader.table("in")?;
    let Some(written) = table.one_of(&["circle", "rectangle", "polygon"]) else {
        table.refuse(
            "",
            &format!("`in` of {} is nowhere", reader.title),
            "neither `circle`, `rectangle` nor `polygon` is given",
            "write circle = { centre = [x, y], radius = r }, rectangle = { min = [x, y], max = \
             [x, y] } or polygon = [[x, y], ...]",
        );
        return None;
    };
    let region = match written {
        "circle" => {
            let circle = table.table("circle")?;
            let (centre, radius) = (circle.vector("centre"), circle.number("radius"));
            Region::Circle {
                centre: centre?,
                radius: radius?,
            }
        }
        "rectangle" => rectangle(&table)?,
        _ => polygon(&table)?,
    };
    let [min, max] = region.bounds();
    let area = region.area();
    if !(area.is_finite() && area > 0.0 && min.iter().chain(&max).all(|x| x.is_finite())) {
        reader.refuse(
            "in",
            &format!(
                "the region of {} has no area that a number can hold",
                reader.title
            ),
            "expected an area above 0 m^2 and below 1e308 m^2",
            "lengths are in metres: give the region the size of the sample",
        );
        return None;
    }
    Some(region)
}

fn rectangle(table: &Reader<'_>) -> Option<Region> {
    let rectangle = table.table("rectangle")?;
    let (min, max) = (rectangle.vector("min"), rectangle.vector("max"));
    let (min, max) = (min?, max?);
    if (0..2).any(|k| min[k] >= max[k]) {
        rectangle.refuse(
            "max",
            "the `rectangle` has no area",
            "expected numbers above those of `min`",
            "`min` is the lower left corner, `max` the upper right one",
        );
        return None;
    }
    Some(Region::Rectangle { min, max })
}

fn polygon(table: &Reader<'_>) -> Option<Region> {
    let mut corners = table.vectors("polygon")?;
    // Closing it by hand is no mistake.
    if corners.len() > 3 && corners.first() == corners.last() {
        corners.pop();
    }
    let refuse = |message: &str, expected: &str| {
        table.refuse(
            "polygon",
            message,
            expected,
            "list the corners once around, [[x, y], [x, y], ...], in either sense",
        );
        None
    };
    if corners.len() < 3 {
        return refuse(
            "the `polygon` has no area",
            "expected three corners or more",
        );
    }
    if corners.len() > MOST_CORNERS {
        return refuse(
            &format!("the `polygon` has {} corners", corners.len()),
            &format!("expected {MOST_CORNERS} at most"),
        );
    }
    for (k, [a, b]) in sides(&corners).enumerate() {
        if a == b {
            let (x, y) = (a[0], a[1]);
            return refuse(
                &format!(
                    "corners {} and {} of the `polygon` are the same",
                    k + 1,
                    k + 2
                ),
                &format!("[{x}, {y}] twice in a row"),
            );
        }
    }
    if let Some([i, j]) = crossing(&corners) {
        let count = corners.len();
        let name = |k: usize| format!("{}-{}", k + 1, (k + 1) % count + 1);
        return refuse(
            &format!(
                "the `polygon` crosses or touches itself: sides {} and {}",
                name(i),
                name(j)
            ),
            "expected sides that meet at corners only",
        );
    }
    Some(Region::Polygon(corners))
}

/// Corners beyond which all pairs of sides would take long to compare.
const MOST_CORNERS: usize = 2000;

/// Two sides that share more than the corner between neighbours.
fn crossing(corners: &[[f64; 2]]) -> Option<[usize; 2]> {
    let all: Vec<_> = sides(corners).collect();
    for (i, [a, b]) in all.iter().enumerate() {
        for (j, [c, d]) in all.iter().enumerate().skip(i + 1) {
            let meet = match (j == i + 1, i == 0 && j + 1 == all.len()) {
                (true, true) => false,
                (true, false) => folds_back(a, b, d),
                (false, true) => folds_back(b, a, c),
                _ => touch([a, b], [c, d]),
            };
            if meet {
                return Some([i, j]);
            }
        }
    }
    None
}

/// Positive if c lies to the left of the way from a to b.
fn turn(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// Whether the way from a to b goes straight back towards a.
fn folds_back(a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]) -> bool {
    let along = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
    turn(a, b, c) == 0.0 && along < 0.0
}

/// Whether two sides have a point in common.
fn touch([a, b]: [&[f64; 2]; 2], [c, d]: [&[f64; 2]; 2]) -> bool {
    let apart = |p: f64, q: f64| (p > 0.0 && q > 0.0) || (p < 0.0 && q < 0.0);
    let (ac, ad) = (turn(a, b, c), turn(a, b, d));
    let (ca, cb) = (turn(c, d, a), turn(c, d, b));
    if apart(ac, ad) || apart(ca, cb) {
        return false;
    }
    // In line: they touch where neither lies beyond the other.
    let between = |p: &[f64; 2], q: &[f64; 2], x: &[f64; 2]| {
        length([x[0] - p[0], x[1] - p[1]]) + length([x[0] - q[0], x[1] - q[1]])
            <= length([q[0] - p[0], q[1] - p[1]])
    };
    if [ac, ad, ca, cb] == [0.0; 4] {
        return between(a, b, c) || between(a, b, d) || between(c, d, a);
    }
    true
}

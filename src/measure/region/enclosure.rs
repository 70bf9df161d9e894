//! The area in which a whole assembly lies, for regions without a boundary of their own.
//!
//! Walls that have every centre on one side and are at least half as long as the edges they make
//! close a convex polygon: that of the intersections of their lines, whether or not their ends
//! still meet after they moved or turned. Otherwise it is the convex hull of the discs.

use super::hull::{self, Disc};
use crate::engine::World;
use crate::engine::wall::Wall;

/// What encloses an assembly.
#[derive(Debug, Clone, PartialEq)]
pub enum Enclosure {
    /// Corners of the polygon the walls close, counter-clockwise [m], in inner coordinates.
    Walls(Vec<[f64; 2]>),
    /// The convex hull of the discs.
    Hull,
    /// A periodic cell: nothing is outside.
    Cell,
}

/// A line with everything on its left.
#[derive(Clone, Copy)]
struct Line {
    point: [f64; 2],
    direction: [f64; 2],
}

/// Corners, each with the wall that makes the edge to the next; `None`: still open there.
type Outline = Vec<([f64; 2], Option<Line>)>;

/// How far the outline reaches before walls cut it, in sizes of the assembly.
const OPEN: f64 = 1e3;

/// Lines nearer than this are one, in sizes of the assembly.
const SAME: f64 = 1e-9;

impl Enclosure {
    /// What encloses the assembly now.
    pub fn of(world: &World) -> Self {
        if world.cell().is_some() {
            return Self::Cell;
        }
        let rows = &world.particles().row;
        if rows.is_empty() || world.walls().len() < 3 {
            return Self::Hull;
        }
        let [low, high] = world.particles().extent();
        let largest = rows.iter().fold(0.0, |most: f64, row| most.max(row.radius));
        let size = (high[0] - low[0]).max(high[1] - low[1]) + 2.0 * largest;
        let middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        let far = OPEN * size;
        let corner = |x: f64, y: f64| ([middle[0] + x * far, middle[1] + y * far], None);
        let mut outline: Outline = vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        for wall in world.walls() {
            let heights = rows.iter().map(|row| height(wall, row.x));
            let (least, most) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |range, h| {
                (range.0.min(h), range.1.max(h))
            });
            let sign = match (least > 0.0, most < 0.0) {
                (true, _) => 1.0,
                (_, true) => -1.0,
                _ => continue,
            };
            let line = Line {
                point: wall.point,
                direction: wall.direction.map(|component| sign * component),
            };
            outline = cut(&outline, line, SAME * size);
        }
        closed(&outline, world.walls(), SAME * size).map_or(Self::Hull, Self::Walls)
    }

    /// Its area [m²].
    pub fn area(&self, world: &World) -> f64 {
        match self {
            Self::Walls(corners) => polygon(corners),
            Self::Cell => world
                .cell()
                .map_or(f64::NAN, crate::engine::boundary::Cell::area),
            Self::Hull => {
                let rows = world.particles().row.iter();
                let discs: Vec<Disc> = rows.map(|row| (row.x, row.radius)).collect();
                hull::area(&discs)
            }
        }
    }
}

fn height(wall: &Wall, x: [f64; 2]) -> f64 {
    above(
        Line {
            point: wall.point,
            direction: wall.direction,
        },
        x,
    )
}

/// Height over a line, positive on its left [m].
fn above(line: Line, x: [f64; 2]) -> f64 {
    (x[1] - line.point[1]) * line.direction[0] - (x[0] - line.point[0]) * line.direction[1]
}

/// What is left of an outline on the left of a line; a line that takes less than `same` takes
/// nothing, since several walls can stand on one line.
fn cut(outline: &Outline, line: Line, same: f64) -> Outline {
    let heights: Vec<f64> = outline.iter().map(|(x, _)| above(line, *x)).collect();
    if heights.iter().all(|&h| h >= -same) {
        return outline.clone();
    }
    let mut left = Outline::new();
    for k in 0..outline.len() {
        let next = (k + 1) % outline.len();
        let (here, there) = (heights[k], heights[next]);
        let (a, edge) = outline[k];
        let b = outline[next].0;
        if here >= 0.0 {
            left.push((a, edge));
        }
        if (here >= 0.0) != (there >= 0.0) {
            let share = here / (here - there);
            let at = [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
            // Leaving, the new edge follows the line; coming back, the old one goes on.
            left.push((at, if here >= 0.0 { Some(line) } else { edge }));
        }
    }
    left
}

/// The corners, if walls make all edges: recomputed from the lines, since cutting a large square
/// loses digits.
fn closed(outline: &Outline, walls: &[Wall], same: f64) -> Option<Vec<[f64; 2]>> {
    let count = outline.len();
    let lines: Vec<Line> = outline
        .iter()
        .map(|(_, edge)| *edge)
        .collect::<Option<_>>()?;
    let corner = |k: usize| crossing(lines[(k + count - 1) % count], lines[k]);
    let corners: Vec<[f64; 2]> = (0..count).map(corner).collect();
    let covered = (0..count).all(|k| {
        let (line, a, b) = (lines[k], corners[k], corners[(k + 1) % count]);
        let along =
            |x: [f64; 2]| (x[0] - a[0]) * line.direction[0] + (x[1] - a[1]) * line.direction[1];
        let length = along(b);
        let covers = |wall: &Wall| {
            let turn =
                wall.direction[0] * line.direction[1] - wall.direction[1] * line.direction[0];
            if turn.abs() * length > same || above(line, wall.point).abs() > same {
                return 0.0;
            }
            let same_way =
                wall.direction[0] * line.direction[0] + wall.direction[1] * line.direction[1] > 0.0;
            let start = along(wall.point);
            let (from, to) = if same_way {
                (start + wall.h1, start + wall.h2)
            } else {
                (start - wall.h2, start - wall.h1)
            };
            (to.min(length) - from.max(0.0)).max(0.0)
        };
        walls.iter().map(covers).sum::<f64>() >= 0.5 * length
    });
    (count > 2 && covered).then_some(corners)
}

/// Where two lines cross.
fn crossing(a: Line, b: Line) -> [f64; 2] {
    let turn = a.direction[0] * b.direction[1] - a.direction[1] * b.direction[0];
    let along = above(b, a.point) / turn;
    [
        a.point[0] + along * a.direction[0],
        a.point[1] + along * a.direction[1],
    ]
}

fn polygon(corners: &[[f64; 2]]) -> f64 {
    let Some(&zero) = corners.first() else {
        return 0.0;
    };
    let from_zero = |x: &[f64; 2]| [x[0] - zero[0], x[1] - zero[1]];
    let pairs = corners.windows(2).map(|pair| {
        let (a, b) = (from_zero(&pair[0]), from_zero(&pair[1]));
        a[0] * b[1] - a[1] * b[0]
    });
    0.5 * pairs.sum::<f64>()
}

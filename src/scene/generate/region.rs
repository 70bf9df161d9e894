//! Where particles are generated: how far a point is inside, and how large the place is.

/// A part of the plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Region {
    /// A circle.
    Circle {
        /// Its centre [m].
        centre: [f64; 2],
        /// Its radius [m].
        radius: f64,
    },
    /// A rectangle along the axes.
    Rectangle {
        /// Lower left corner [m].
        min: [f64; 2],
        /// Upper right corner [m].
        max: [f64; 2],
    },
    /// A simple polygon, in either sense, without the first corner again at the end.
    Polygon(Vec<[f64; 2]>),
}

impl Region {
    /// Distance from a point inside to the border; negative outside [m].
    pub(super) fn depth(&self, [x, y]: [f64; 2]) -> f64 {
        match self {
            Self::Circle { centre, radius } => radius - length([x - centre[0], y - centre[1]]),
            // Outside it is less than the distance only beyond a corner, which is just as negative.
            Self::Rectangle { min, max } => {
                let across = (x - min[0]).min(max[0] - x);
                across.min((y - min[1]).min(max[1] - y))
            }
            Self::Polygon(corners) => polygon_depth(corners, [x, y]),
        }
    }

    /// Lower left and upper right corner of the rectangle around it [m].
    pub(super) fn bounds(&self) -> [[f64; 2]; 2] {
        match self {
            Self::Circle { centre, radius } => {
                [centre.map(|x| x - radius), centre.map(|x| x + radius)]
            }
            Self::Rectangle { min, max } => [*min, *max],
            Self::Polygon(corners) => {
                let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
                for corner in corners {
                    for k in 0..2 {
                        bounds[0][k] = bounds[0][k].min(corner[k]);
                        bounds[1][k] = bounds[1][k].max(corner[k]);
                    }
                }
                bounds
            }
        }
    }

    /// Its area [m²].
    pub(super) fn area(&self) -> f64 {
        match self {
            Self::Circle { radius, .. } => std::f64::consts::PI * radius * radius,
            Self::Rectangle { min, max } => (max[0] - min[0]) * (max[1] - min[1]),
            Self::Polygon(corners) => signed_area(corners).abs(),
        }
    }
}

/// Length of a vector; overflows only where the scene would.
pub(super) fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// The pairs of corners that the sides of a polygon join.
pub(super) fn sides(corners: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| [*a, *b])
}

/// Positive counter-clockwise; relative to the first corner, so that a distant polygon loses nothing.
fn signed_area(corners: &[[f64; 2]]) -> f64 {
    let Some(&[x, y]) = corners.first() else {
        return 0.0;
    };
    let cross = |[a, b]: [[f64; 2]; 2]| (a[0] - x) * (b[1] - y) - (b[0] - x) * (a[1] - y);
    0.5 * sides(corners).map(cross).sum::<f64>()
}

fn polygon_depth(corners: &[[f64; 2]], p: [f64; 2]) -> f64 {
    let (mut inside, mut nearest) = (false, f64::INFINITY);
    for [a, b] in sides(corners) {
        let side = [b[0] - a[0], b[1] - a[1]];
        let from = [p[0] - a[0], p[1] - a[1]];
        let square = side[0] * side[0] + side[1] * side[1];
        let t = ((from[0] * side[0] + from[1] * side[1]) / square).clamp(0.0, 1.0);
        nearest = nearest.min(length([from[0] - t * side[0], from[1] - t * side[1]]));
        // A ray to the right crosses the side: half open, so that a corner counts once.
        if (a[1] > p[1]) != (b[1] > p[1]) {
            let cross = side[0] * from[1] - side[1] * from[0];
            inside ^= (cross > 0.0) == (b[1] > a[1]);
        }
    }
    if inside { nearest } else { -nearest }
}

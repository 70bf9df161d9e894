//! Which part of the assembly is seen.

use super::scale::round_up;
use crate::measure::frame::{Disc, Picture};

/// Bounds that the whole assembly is fitted to [m]: the discs with some room, and walls as far as
/// they are near. Long walls do not make discs small; the bounds move in steps, so that the
/// picture keeps its scale while discs move.
pub fn fitted(picture: &Picture) -> [[f64; 2]; 2] {
    let [low, high] = picture.whole.unwrap_or_else(|| within(&picture.discs));
    let size = [0, 1].map(|k| high[k] - low[k]);
    if !size.iter().all(|size| size.is_finite() && *size > 0.0) {
        return picture.bounds;
    }
    let room = 0.1 * round_up(size[0].max(size[1]));
    let outer = picture.bounds;
    let fit = |inside: f64, edge: f64, outwards: f64| {
        if (edge - inside).abs() <= 2.0 * room {
            return edge;
        }
        let steps = (outwards * inside / room).ceil() + 1.0;
        let stepped = outwards * steps * room;
        if (edge - stepped) * outwards > 0.0 {
            stepped
        } else {
            edge
        }
    };
    [
        [0, 1].map(|k| fit(low[k], outer[0][k], -1.0)),
        [0, 1].map(|k| fit(high[k], outer[1][k], 1.0)),
    ]
}

/// Box around discs [m].
fn within(discs: &[Disc]) -> [[f64; 2]; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for disc in discs {
        for k in 0..2 {
            low[k] = low[k].min(disc.at[k] - disc.radius);
            high[k] = high[k].max(disc.at[k] + disc.radius);
        }
    }
    [low, high]
}

/// A window on the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Middle [m]; `None` follows the assembly.
    pub centre: Option<[f64; 2]>,
    /// Magnification over the fitted size.
    pub zoom: f64,
}

impl Default for View {
    fn default() -> Self {
        Self {
            centre: None,
            zoom: 1.0,
        }
    }
}

impl View {
    /// Lower and upper corner of what a window of `width` by `height` dots (square ones) shows of
    /// these bounds [m].
    pub fn window(&self, bounds: [[f64; 2]; 2], width: f64, height: f64) -> [[f64; 2]; 2] {
        let [low, high] = bounds;
        let size = [0, 1].map(|k| (high[k] - low[k]).max(1e-300));
        let fit = (size[0] / width.max(1.0)).max(size[1] / height.max(1.0)) * 1.04;
        let half = [width, height].map(|dots| 0.5 * dots.max(1.0) * fit / self.zoom);
        let middle = self
            .centre
            .unwrap_or([0, 1].map(|k| 0.5 * (low[k] + high[k])));
        [
            [middle[0] - half[0], middle[1] - half[1]],
            [middle[0] + half[0], middle[1] + half[1]],
        ]
    }

    /// Moves by parts of the window.
    pub fn pan(&mut self, bounds: [[f64; 2]; 2], dx: f64, dy: f64) {
        let [low, high] = bounds;
        let middle = self
            .centre
            .unwrap_or([0, 1].map(|k| 0.5 * (low[k] + high[k])));
        let size = (high[0] - low[0]).max(high[1] - low[1]) / self.zoom;
        self.centre = Some([middle[0] + dx * size, middle[1] + dy * size]);
    }

    /// Magnifies.
    pub fn magnify(&mut self, factor: f64) {
        self.zoom = (self.zoom * factor).clamp(0.1, 1e4);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(x: f64) -> Picture {
        let disc = |x: f64| Disc {
            id: 1,
            at: [x, 0.1],
            radius: 0.1,
            velocity: [0.0; 2],
            spin: 0.0,
            angle: 0.0,
            material: 0,
            driven: false,
        };
        Picture {
            discs: vec![disc(-x), disc(x)],
            bounds: [[-20.0, 0.0], [20.0, 6.0]],
            ..Picture::default()
        }
    }

    #[test]
    fn long_walls_do_not_make_discs_small() {
        let [low, high] = fitted(&picture(0.5));
        assert!(low[0] > -1.0 && low[0] < -0.6, "{low:?}");
        assert!(high[1] < 0.7, "{high:?}");
        // The floor is near: its height is the lower bound.
        assert_eq!(low[1], 0.0);
    }

    #[test]
    fn the_bounds_stand_while_discs_move_a_little() {
        assert_eq!(fitted(&picture(0.501)), fitted(&picture(0.56)));
        assert_ne!(fitted(&picture(0.501)), fitted(&picture(0.9)));
    }

    #[test]
    fn without_discs_all_is_seen() {
        let mut empty = picture(0.5);
        empty.discs.clear();
        assert_eq!(fitted(&empty), empty.bounds);
    }
}

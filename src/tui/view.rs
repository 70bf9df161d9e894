//! Which part of the assembly is seen.

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

//! Histograms: how values are distributed over ranges of equal width.

/// Counts of values from `low` to `high`. What lies beyond counts at the ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Histogram {
    /// Lower edge of the first bar.
    pub low: f64,
    /// Upper edge of the last bar.
    pub high: f64,
    /// Weight of the values in each bar.
    pub bars: Vec<f64>,
    /// Weighted mean; NaN without values.
    pub mean: f64,
    /// Weighted standard deviation; NaN without values.
    pub deviation: f64,
}

impl Histogram {
    /// Sorts values with their weights into so many bars. An edge belongs to the bar above it, the
    /// last one to the last bar.
    ///
    /// # Panics
    /// Without bars.
    pub fn of(values: &[(f64, f64)], low: f64, high: f64, bars: usize) -> Self {
        assert!(bars > 0, "a histogram needs bars");
        let mut counts = vec![0.0; bars];
        let (mut count, mut sum) = (0.0, 0.0);
        for &(value, weight) in values {
            let share = (value - low) / (high - low);
            // Rounding may reach the last edge; nothing and NaN end at the first bar.
            let bar = (share * bars as f64) as usize;
            counts[bar.min(bars - 1)] += weight;
            count += weight;
            sum += weight * value;
        }
        let mean = sum / count;
        let squares = values.iter().map(|(value, weight)| {
            let off = value - mean;
            weight * (off * off)
        });
        Self {
            low,
            high,
            bars: counts,
            mean,
            deviation: (squares.sum::<f64>() / count).sqrt(),
        }
    }

    /// The same from zero to the largest value.
    pub fn from_zero(values: &[(f64, f64)], bars: usize) -> Self {
        let most = values
            .iter()
            .fold(0.0, |most: f64, (value, _)| most.max(*value));
        Self::of(values, 0.0, most, bars)
    }

    /// Lower and upper edge of a bar.
    pub fn edges(&self, bar: usize) -> [f64; 2] {
        let edge = |k: usize| {
            let share = k as f64 / self.bars.len() as f64;
            self.low + share * (self.high - self.low)
        };
        [edge(bar), edge(bar + 1)]
    }

    /// Weight of all values.
    pub fn count(&self) -> f64 {
        self.bars.iter().sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_fall_between_their_edges() {
        let values = [
            (-1.0, 1.0),
            (-0.5, 2.0),
            (0.0, 1.0),
            (0.49, 0.5),
            (1.0, 1.5),
        ];
        let histogram = Histogram::of(&values, -1.0, 1.0, 4);
        assert_eq!(histogram.bars, [1.0, 2.0, 1.5, 1.5]);
        assert_eq!(histogram.edges(1), [-0.5, 0.0]);
        assert_eq!(histogram.count(), 6.0);
        let mean: f64 = (-1.0 - 1.0 + 0.245 + 1.5) / 6.0;
        assert!((histogram.mean - mean).abs() < 1e-15);
        let square = (1.0 + 0.5 + 0.5 * 0.49 * 0.49 + 1.5) / 6.0;
        assert!((histogram.deviation - (square - mean * mean).sqrt()).abs() < 1e-15);
        // What a rounding or a cohesion carries beyond stays in.
        let beyond = Histogram::of(&[(1.0 + 1e-9, 1.0), (-2.0, 1.0)], -1.0, 1.0, 4);
        assert_eq!(beyond.bars, [1.0, 0.0, 0.0, 1.0]);
        let empty = Histogram::of(&[], 0.0, 1.0, 2);
        assert!(empty.mean.is_nan() && empty.deviation.is_nan() && empty.count() == 0.0);
        // All values alike: no width to sort by.
        assert_eq!(Histogram::of(&[(3.0, 2.0)], 3.0, 3.0, 2).bars, [2.0, 0.0]);
    }
}

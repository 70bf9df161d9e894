//! Round numbers for axes, and numbers in few characters.

/// An axis with round ends and ticks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Distance of ticks.
    pub step: f64,
    /// Whether the axis counts powers of ten: ends and step are exponents then.
    pub decades: bool,
}

impl Scale {
    /// An axis over these values with at most so many steps. It depends on nothing else, so it
    /// stays as long as the values stay between the same round numbers.
    pub fn over(low: f64, high: f64, most: usize) -> Self {
        let (low, high) = if low.is_finite() && high.is_finite() {
            // Sums and differences of what is left stay finite.
            let ends = [low.min(high), high.max(low)];
            ends.map(|end| end.clamp(-1e300, 1e300)).into()
        } else {
            (0.0, 1.0)
        };
        // A constant gets room around it; noise in the last digits is no variation.
        let size = low.abs().max(high.abs());
        let (low, high) = if high - low > 1e-9 * size {
            (low, high)
        } else if size < 1e-290 {
            (0.0, 1.0)
        } else {
            (low - 0.1 * size, high + 0.1 * size)
        };
        let most = most.max(1) as f64;
        let mut step = round_up((high - low) / most);
        // Ends that are moved outwards may ask for one step more.
        for _ in 0..4 {
            let scale = Self {
                low: (low / step).floor() * step,
                high: (high / step).ceil() * step,
                step,
                decades: false,
            };
            if (scale.high - scale.low) / step <= most + 0.5 || most < 2.0 {
                return scale;
            }
            step = round_up(1.5 * step);
        }
        Self {
            low,
            high,
            step,
            decades: false,
        }
    }

    /// An axis of powers of ten over these positive values, with about so many steps. Its ends are
    /// whole powers.
    pub fn decades(low: f64, high: f64, most: usize) -> Self {
        let exponent = |x: f64| x.clamp(1e-300, 1e300).log10();
        let low = exponent(low.min(high)).floor();
        let high = exponent(high.max(low)).ceil().max(low + 1.0);
        let steps = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0];
        let enough = |step: &f64| (high - low) / step <= most as f64 + 1.0;
        Self {
            low,
            high,
            step: steps.into_iter().find(enough).unwrap_or(200.0),
            decades: true,
        }
    }

    /// Where a value lies between the ends, 0 to 1 inside.
    pub fn place(&self, value: f64) -> f64 {
        let value = if self.decades { value.log10() } else { value };
        (value - self.low) / (self.high - self.low)
    }

    /// The ticks with their labels, as values of the column.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let size = self.low.abs().max(self.high.abs());
        // Ticks stand at multiples of the step; a little less than a step is lost to rounding.
        let first = (self.low / self.step - 1e-6).ceil() * self.step;
        let count = ((self.high - first) / self.step + 1e-6)
            .floor()
            .clamp(0.0, 50.0) as usize;
        (0..=count)
            .map(|k| {
                let value = first + k as f64 * self.step;
                if self.decades {
                    return (10f64.powf(value), format!("1e{value:.0}"));
                }
                (value, label(value, self.step, size))
            })
            .collect()
    }
}

/// The next number above of the kind 1, 2, 5, 10, 20 ...
pub fn round_up(x: f64) -> f64 {
    if !(x.is_finite() && x > 0.0) {
        return 1.0;
    }
    let decade = 10f64.powf(x.log10().floor());
    let rest = x / decade;
    let factor = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|factor| rest <= factor * (1.0 + 1e-9))
        .unwrap_or(10.0);
    let up = factor * decade;
    if up.is_finite() && up > 0.0 { up } else { x }
}

/// The next number below of the same kind.
pub fn round_down(x: f64) -> f64 {
    let up = round_up(x);
    [1.0, 0.5, 0.4, 0.2]
        .into_iter()
        .map(|share| share * up)
        // Two fifths of 5 is 2, but of 1 or 2 it is no round number.
        .find(|down| *down <= x * (1.0 + 1e-9) && round_up(*down) <= *down * (1.0 + 1e-6))
        .unwrap_or(x)
}

/// A tick's number with the decimals that its step needs.
fn label(value: f64, step: f64, size: f64) -> String {
    if value.abs() < 1e-6 * step {
        return "0".into();
    }
    let finest = step.log10().floor();
    if (1e-3..1e5).contains(&size) && finest > -6.0 {
        let decimals = (-finest).max(0.0) as usize;
        return format!("{value:.decimals$}");
    }
    let own = value.abs().log10().floor();
    let decimals = (own - finest).clamp(0.0, 6.0) as usize;
    format!("{value:.decimals$e}")
}

/// Four significant digits, always as many, so that what stands behind does not move.
pub fn short(x: f64) -> String {
    if x.is_nan() {
        return "nan".into();
    }
    if x.is_infinite() {
        return if x > 0.0 { "inf" } else { "-inf" }.into();
    }
    if x == 0.0 {
        return "0".into();
    }
    let scientific = format!("{x:.3e}");
    let exponent = scientific
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse::<i32>().ok())
        .unwrap_or(0);
    if (-3..=4).contains(&exponent) {
        let decimals = (3 - exponent).max(0) as usize;
        format!("{x:.decimals$}")
    } else {
        scientific
    }
}

/// A count, in exact digits while they are few.
pub fn count(n: f64) -> String {
    if n.fract() == 0.0 && n.abs() < 1e9 {
        format!("{n:.0}")
    } else {
        short(n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn axes_are_round() {
        for (low, high, ends) in [
            (0.0, 0.43, (0.0, 0.5)),
            (0.11, 0.43, (0.1, 0.5)),
            (-3.0, 7.0, (-4.0, 8.0)),
            (1.02e5, 1.09e5, (1.02e5, 1.1e5)),
            (0.0, 0.0, (0.0, 1.0)),
            (5.0, 5.0, (4.4, 5.6)),
        ] {
            let scale = Scale::over(low, high, 6);
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * scale.step;
            assert!(near(scale.low, ends.0), "{low} {high}: {scale:?}");
            assert!(near(scale.high, ends.1), "{low} {high}: {scale:?}");
        }
    }

    #[test]
    fn decades_are_whole() {
        let labels = |low, high, most| -> Vec<String> {
            let ticks = Scale::decades(low, high, most).ticks();
            ticks.into_iter().map(|(_, label)| label).collect()
        };
        assert_eq!(labels(2e-3, 0.5, 4), ["1e-3", "1e-2", "1e-1", "1e0"]);
        assert_eq!(labels(1e-8, 2e5, 4), ["1e-6", "1e-3", "1e0", "1e3", "1e6"]);
        assert_eq!(labels(1.0, 1.0, 4), ["1e0", "1e1"]);
        assert_eq!(Scale::decades(1e-3, 10.0, 4).place(0.1), 0.5);
        // Zero has no place there.
        assert!(!Scale::decades(1e-3, 10.0, 4).place(0.0).is_finite());
    }

    #[test]
    fn labels_have_the_decimals_of_their_step() {
        let labels = |low, high| -> Vec<String> {
            let ticks = Scale::over(low, high, 4).ticks();
            ticks.into_iter().map(|(_, label)| label).collect()
        };
        assert_eq!(labels(0.0, 0.4), ["0", "0.1", "0.2", "0.3", "0.4"]);
        assert_eq!(labels(0.0, 4e6), ["0", "1e6", "2e6", "3e6", "4e6"]);
        assert_eq!(labels(0.0, 2.9e-5), ["0", "1e-5", "2e-5", "3e-5"]);
        assert_eq!(labels(1.0e6, 1.1e6), ["1.00e6", "1.05e6", "1.10e6"]);
    }

    #[test]
    fn short_numbers_keep_their_length() {
        for (x, text) in [
            (0.41268, "0.4127"),
            (3.974, "3.974"),
            (102_000.0, "1.020e5"),
            (12_345.6, "12346"),
            (-1.5e-5, "-1.500e-5"),
            (f64::NAN, "nan"),
            (0.0, "0"),
        ] {
            assert_eq!(short(x), text);
        }
        assert_eq!(count(128.0), "128");
    }

    #[test]
    fn the_largest_numbers_get_an_axis() {
        for (low, high) in [(1.4e308, 3.2e305), (f64::MIN, -1e301), (f64::MAX, f64::MAX)] {
            let scale = Scale::over(low, high, 4);
            assert!(scale.high > scale.low && scale.step > 0.0, "{scale:?}");
            assert!(scale.low.is_finite() && scale.high.is_finite());
        }
    }

    proptest! {
        #[test]
        fn any_values_get_an_axis(low in any::<f64>(), high in any::<f64>(), most in 0usize..20) {
            let scale = Scale::over(low, high, most);
            prop_assert!(scale.high > scale.low && scale.step > 0.0, "{:?}", scale);
            prop_assert!(scale.low.is_finite() && scale.high.is_finite());
            prop_assert!(scale.ticks().len() < 60);
            let plain = low.abs() < 1e300 && high.abs() < 1e300;
            if plain && low < high && high - low < 1e290 {
                prop_assert!(scale.place(low) > -1e-6 && scale.place(high) < 1.0 + 1e-6);
            }
        }

        #[test]
        fn round_numbers_are_little_more(x in 1e-290f64..1e290) {
            let up = round_up(x);
            prop_assert!(up >= x * (1.0 - 1e-6) && up <= 2.6 * x, "{}", up);
            let down = round_down(x);
            prop_assert!(down <= x * (1.0 + 1e-6) && 2.6 * down >= x, "{}", down);
            prop_assert!((round_up(down) / down - 1.0).abs() < 1e-6, "{}", down);
        }
    }
}

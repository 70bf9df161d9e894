//! How a number varies from seed to seed.

/// Mean and spread of one number over an ensemble.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// How many values there are; undefined ones do not count.
    pub n: usize,
    /// Their mean; nan if there is none.
    pub mean: f64,
    /// Standard deviation of one value, from n - 1 degrees of freedom; nan below two values.
    pub sd: f64,
    /// The smallest.
    pub min: f64,
    /// The largest.
    pub max: f64,
}

impl Spread {
    /// Of these values, summed in this order. Those that are nan are left out.
    pub fn of(values: impl Iterator<Item = f64> + Clone) -> Self {
        let values = values.filter(|value| !value.is_nan());
        let n = values.clone().count();
        let mean = values.clone().sum::<f64>() / n as f64;
        let squares: f64 = values.clone().map(|x| (x - mean) * (x - mean)).sum();
        Self {
            n,
            mean,
            sd: if n > 1 {
                (squares / (n - 1) as f64).sqrt()
            } else {
                f64::NAN
            },
            min: values.clone().fold(f64::NAN, f64::min),
            max: values.fold(f64::NAN, f64::max),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_and_spread_are_those_of_the_textbook() {
        // 2, 4, 4, 4, 5, 5, 7, 9: mean 5, sum of squared deviations 32.
        let values = [2.0, 4.0, f64::NAN, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0];
        let spread = Spread::of(values.into_iter());
        assert_eq!((spread.n, spread.mean), (8, 5.0));
        assert_eq!((spread.min, spread.max), (2.0, 9.0));
        assert!((spread.sd - (32.0f64 / 7.0).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn what_is_not_known_is_nan() {
        let one = Spread::of([3.5].into_iter());
        assert_eq!((one.n, one.mean, one.min, one.max), (1, 3.5, 3.5, 3.5));
        assert!(one.sd.is_nan());
        let none = Spread::of([f64::NAN].into_iter());
        assert_eq!(none.n, 0);
        assert!(
            [none.mean, none.sd, none.min, none.max]
                .iter()
                .all(|x| x.is_nan())
        );
        // Equal values: rounding of their mean must not look like a spread of its own.
        let equal = Spread::of([0.1; 10].into_iter());
        assert!(equal.sd < 1e-16, "{}", equal.sd);
    }
}

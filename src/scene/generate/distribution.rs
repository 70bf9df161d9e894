//! `distribution`: radii drawn from one, by number.

use super::chance::Chance;
use crate::scene::key::{Absent, Bounds, Form, Key};
use crate::scene::reader::Reader;

/// The keys of its table.
pub(super) const KEYS: &[Key] = &[
    Key {
        absent: Absent::Wrong,
        ..number(
            "kind",
            Form::Word(KINDS),
            "-",
            "which: of numbers of particles, not of their mass",
        )
    },
    Key {
        absent: Absent::Wrong,
        ..number(
            "count",
            Form::Count(1, super::MOST),
            "-",
            "how many radii are drawn",
        )
    },
    number(
        "min",
        RADIUS,
        "m",
        "smallest radius; (log)normal: by default three deviations below",
    ),
    number(
        "max",
        RADIUS,
        "m",
        "largest radius; (log)normal: by default three deviations above",
    ),
    number(
        "mean",
        RADIUS,
        "m",
        "mean radius of normal and lognormal, before it is cut at both ends",
    ),
    number(
        "deviation",
        RADIUS,
        "m",
        "standard deviation of normal and lognormal, of the radius itself",
    ),
    Key {
        form: Form::Number(Bounds::FINITE),
        ..number(
            "exponent",
            RADIUS,
            "-",
            "p of power: numbers per radius go with radius^-p",
        )
    },
];

const KINDS: &[&str] = &["uniform", "normal", "lognormal", "power"];
const RADIUS: Form = Form::Number(Bounds::POSITIVE);

const fn number(name: &'static str, form: Form, unit: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form,
        unit,
        absent: Absent::Said("required if `kind` needs it"),
        summary,
    }
}

/// A distribution of radii between two.
pub(super) struct Distribution {
    shape: Shape,
    min: f64,
    max: f64,
    /// How many are drawn.
    pub(super) count: usize,
}

enum Shape {
    Uniform,
    /// Mean and standard deviation [m].
    Normal(f64, f64),
    /// Mean and standard deviation of the logarithm of the radius in metres.
    Lognormal(f64, f64),
    /// Exponent.
    Power(f64),
}

/// Least share of a distribution that must lie between its ends: others are drawn again.
const LEAST: f64 = 0.01;

impl Distribution {
    /// Draws all radii [m].
    pub(super) fn draw(&self, chance: &mut Chance) -> Vec<f64> {
        (0..self.count).map(|_| self.one(chance)).collect()
    }

    fn one(&self, chance: &mut Chance) -> f64 {
        let (min, max) = (self.min, self.max);
        match self.shape {
            Shape::Uniform => min + chance.fraction() * (max - min),
            Shape::Normal(mean, deviation) => self.within(chance, |z| mean + deviation * z),
            Shape::Lognormal(mean, deviation) => {
                self.within(chance, |z| libm::exp(mean + deviation * z))
            }
            Shape::Power(p) => {
                let (u, ratio, q) = (chance.fraction(), max / min, 1.0 - p);
                let times = if q == 0.0 {
                    libm::pow(ratio, u)
                } else {
                    libm::pow(1.0 + u * (libm::pow(ratio, q) - 1.0), 1.0 / q)
                };
                (min * times).clamp(min, max)
            }
        }
    }

    /// A radius from a standard normal number, drawn again until it lies between the ends.
    fn within(&self, chance: &mut Chance, radius: impl Fn(f64) -> f64) -> f64 {
        loop {
            let far = (-2.0 * libm::log(chance.above_zero())).sqrt();
            let z = far * libm::cos(2.0 * std::f64::consts::PI * chance.fraction());
            let radius = radius(z);
            if radius >= self.min && radius <= self.max {
                return radius;
            }
        }
    }
}

/// Reads it.
pub(super) fn read(reader: &Reader<'_>) -> Option<Distribution> {
    let table = reader.table("distribution")?;
    let (kind, count) = (table.word("kind"), table.count("count"));
    let kind = kind?;
    let (needed, foreign): (&[&'static str], &[&'static str]) = match kind {
        "uniform" => (&["min", "max"], &["mean", "deviation", "exponent"]),
        "power" => (&["min", "max", "exponent"], &["mean", "deviation"]),
        _ => (&["mean", "deviation"], &["exponent"]),
    };
    let mut sound = true;
    for name in needed.iter().filter(|name| !table.has(name)) {
        table.refuse(
            name,
            &format!("the distribution `{kind}` has no `{name}`"),
            &format!("`{name}` is missing here"),
            &format!("a {kind} distribution needs {}", needed.join(" and ")),
        );
        sound = false;
    }
    for name in foreign.iter().filter(|name| table.has(name)) {
        table.refuse(
            name,
            &format!("a {kind} distribution has no `{name}`"),
            "without meaning here",
            &format!(
                "leave it out; a {kind} distribution needs {}",
                needed.join(" and ")
            ),
        );
        sound = false;
    }
    let value = |name: &str| table.has(name).then(|| table.number(name)).flatten();
    let [min, max, mean, deviation, exponent] =
        ["min", "max", "mean", "deviation", "exponent"].map(value);
    if !sound {
        return None;
    }
    let (shape, usual) = match kind {
        "uniform" => (Shape::Uniform, [min?, max?]),
        "power" => (Shape::Power(exponent?), [min?, max?]),
        "normal" => {
            let (mean, deviation) = (mean?, deviation?);
            let ends = [mean - 3.0 * deviation, mean + 3.0 * deviation];
            (Shape::Normal(mean, deviation), ends)
        }
        _ => {
            let (mean, deviation) = (mean?, deviation?);
            let variance = libm::log1p((deviation / mean) * (deviation / mean));
            let (middle, spread) = (libm::log(mean) - 0.5 * variance, variance.sqrt());
            let ends = [-3.0, 3.0].map(|z| libm::exp(middle + z * spread));
            (Shape::Lognormal(middle, spread), ends)
        }
    };
    let (min, max) = (min.unwrap_or(usual[0]), max.unwrap_or(usual[1]));
    check(&table, &shape, min, max)?;
    let count = count? as usize;
    Some(Distribution {
        shape,
        min,
        max,
        count,
    })
}

fn check(table: &Reader<'_>, shape: &Shape, min: f64, max: f64) -> Option<()> {
    if !(min > 0.0 && min <= max && max.is_finite()) {
        table.refuse(
            if table.has("max") { "max" } else { "min" },
            &format!("the radii go from {min} m to {max} m"),
            "expected 0 < min <= max",
            "give both `min` and `max`; without them a normal distribution goes three deviations \
             down and up",
        );
        return None;
    }
    let below = |z: f64| 0.5 * libm::erfc(-z * std::f64::consts::FRAC_1_SQRT_2);
    let share = match *shape {
        Shape::Uniform | Shape::Power(_) => 1.0,
        Shape::Normal(mean, deviation) => {
            below((max - mean) / deviation) - below((min - mean) / deviation)
        }
        Shape::Lognormal(middle, spread) => {
            below((libm::log(max) - middle) / spread) - below((libm::log(min) - middle) / spread)
        }
    };
    if share < LEAST {
        table.refuse(
            "kind",
            "hardly any radius of the distribution lies between `min` and `max`",
            "less than 1 % of it does",
            "move `min` and `max` towards the mean",
        );
        return None;
    }
    Some(())
}

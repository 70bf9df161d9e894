//! What a `[[generate]]` placed.

use super::fill::Size;

/// What one table placed.
#[derive(Debug, Clone, PartialEq)]
pub struct Generated {
    /// What the table is called in messages.
    pub title: String,
    /// Number of the first particle.
    pub first: u32,
    /// Area of the region [m²].
    pub area: f64,
    /// Share of the region that the placed particles leave free [-].
    pub porosity: f64,
    /// Sizes, largest first.
    pub sizes: Vec<SizeGenerated>,
}

/// What was placed of one size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SizeGenerated {
    /// Radius [m].
    pub radius: f64,
    /// How many were asked for; `None`: as many as fit.
    pub asked: Option<usize>,
    /// How many were placed.
    pub placed: usize,
}

impl Generated {
    pub(super) fn new(
        title: &str,
        first: u32,
        area: f64,
        sizes: &[Size],
        asked: &[Option<usize>],
        placed: &[usize],
    ) -> Self {
        let sizes: Vec<SizeGenerated> = sizes
            .iter()
            .zip(asked.iter().zip(placed))
            .map(|(size, (&asked, &placed))| SizeGenerated {
                radius: size.radius,
                asked,
                placed,
            })
            .collect();
        let discs = |size: &SizeGenerated| {
            size.placed as f64 * std::f64::consts::PI * size.radius * size.radius
        };
        let covered: f64 = sizes.iter().map(discs).sum();
        Self {
            title: title.to_owned(),
            first,
            area,
            porosity: 1.0 - covered / area,
            sizes,
        }
    }

    /// How many were placed.
    pub fn count(&self) -> usize {
        self.sizes.iter().map(|size| size.placed).sum()
    }

    /// What did not fit, in words; nothing if all did.
    pub fn shortfall(&self) -> Option<String> {
        let short: Vec<&SizeGenerated> = self.sizes.iter().filter(|size| size.is_short()).collect();
        let (largest, smallest) = (short.first()?, short.last()?);
        let missing: usize = short
            .iter()
            .map(|size| size.asked.unwrap_or_default() - size.placed)
            .sum();
        let radii = if largest.radius == smallest.radius {
            format!("of radius {} m", largest.radius)
        } else {
            format!("of radii {} to {} m", smallest.radius, largest.radius)
        };
        let asked: usize = self.sizes.iter().filter_map(|size| size.asked).sum();
        Some(format!(
            "{} had no room for {missing} of the {asked} particles asked for, {radii}",
            self.title
        ))
    }
}

impl SizeGenerated {
    fn is_short(&self) -> bool {
        self.asked.is_some_and(|asked| self.placed < asked)
    }
}

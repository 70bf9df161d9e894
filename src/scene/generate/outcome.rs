//! What a `[[generate]]` placed.

use super::crowd::Disc;
use super::grading::Wanted;
use crate::engine::setup::ParticleSetup;
use crate::scene::draft::Draft;

/// What one table placed.
#[derive(Debug, Clone, PartialEq)]
pub struct Generated {
    /// What the table is called in messages.
    pub title: String,
    /// Number of the first particle.
    pub first: u32,
    /// Area of the region, if there is one [m²].
    pub area: Option<f64>,
    /// Share of it that the discs of the placed particles leave free [-].
    pub porosity: Option<f64>,
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
        draft: &Draft<'_>,
        area: f64,
        wanted: &Wanted,
        placed: &[usize],
    ) -> Self {
        let rows = wanted.radii.iter().zip(&wanted.asked).zip(placed);
        let sizes = rows.map(|((&radius, &asked), &placed)| SizeGenerated {
            radius,
            asked,
            placed,
        });
        Self::sized(title, draft, Some(area), sizes.collect())
    }

    /// Of particles that were not asked for by size.
    pub(super) fn of(
        title: &str,
        draft: &Draft<'_>,
        area: Option<f64>,
        particles: &[impl Round],
    ) -> Self {
        let mut radii: Vec<f64> = particles.iter().map(Round::radius).collect();
        radii.sort_by(|a, b| b.total_cmp(a));
        let equal = radii.chunk_by(|a, b| a == b);
        let sizes = equal.map(|equal| SizeGenerated {
            radius: equal[0],
            asked: None,
            placed: equal.len(),
        });
        Self::sized(title, draft, area, sizes.collect())
    }

    fn sized(title: &str, draft: &Draft<'_>, area: Option<f64>, sizes: Vec<SizeGenerated>) -> Self {
        let discs = |size: &SizeGenerated| {
            size.placed as f64 * std::f64::consts::PI * size.radius * size.radius
        };
        let covered: f64 = sizes.iter().map(discs).sum();
        Self {
            title: title.to_owned(),
            first: draft.next_number(),
            area,
            porosity: area.map(|area| 1.0 - covered / area),
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

/// What has a radius.
pub(super) trait Round {
    /// The radius [m].
    fn radius(&self) -> f64;
}

impl Round for Disc {
    fn radius(&self) -> f64 {
        self.radius
    }
}

impl Round for ParticleSetup {
    fn radius(&self) -> f64 {
        self.radius
    }
}

//! The sizes that are asked for.

use super::MOST;
use super::csv_rows::{self, Columns};
use super::fill::Size;
use super::region::Region;
use crate::scene::draft::Draft;
use crate::scene::reader::Reader;

/// Radii, and how many of each.
pub(super) struct Wanted {
    /// Radii, largest first [m].
    pub(super) radii: Vec<f64>,
    /// How many of each; `None`: as many as fit.
    pub(super) asked: Vec<Option<usize>>,
}

impl Wanted {
    fn new(mut rows: Vec<(f64, Option<usize>)>) -> Self {
        // Stable: of equal radii the first written comes first.
        rows.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (radii, asked) = rows.into_iter().unzip();
        Self { radii, asked }
    }

    /// Smallest radius [m].
    pub(super) fn smallest(&self) -> f64 {
        self.radii.last().copied().unwrap_or(f64::INFINITY)
    }

    /// How many of each size are tried.
    pub(super) fn sizes(&self, region: &Region) -> Vec<Size> {
        let rows = self.radii.iter().zip(&self.asked);
        rows.map(|(&radius, asked)| Size {
            radius,
            count: asked.unwrap_or_else(|| most(region, radius)),
        })
        .collect()
    }
}

/// How many discs of one size there can be: each takes 2√3 R² at least, but for those at the border
/// [-].
fn most(region: &Region, radius: f64) -> usize {
    (region.area() / (3.0 * radius * radius)) as usize + 8
}

/// Reads `grading`.
pub(super) fn read(reader: &Reader<'_>, region: Option<&Region>) -> Option<Wanted> {
    let tables = reader.tables("grading")?;
    let mut rows = Vec::with_capacity(tables.len());
    let mut sound = true;
    for table in &tables {
        let (radius, count) = (table.number("radius"), table.count("count"));
        let Some(radius) = radius.filter(|_| count.is_some() || !table.has("count")) else {
            sound = false;
            continue;
        };
        if let Some(problem) = region.and_then(|region| unfit(region, radius, count)) {
            let [message, expected, remedy] = &problem;
            table.refuse("radius", message, expected, remedy);
            sound = false;
        }
        rows.push((radius, count.map(|count| count as usize)));
    }
    sound
        .then_some(rows)
        .and_then(|rows| whole(reader, "grading", rows))
}

const COLUMNS: Columns = Columns {
    required: &["radius", "count"],
    optional: &[],
    ignored: &[],
};

/// Reads the file of `grading_file`.
pub(super) fn read_file<'a>(
    reader: &Reader<'a>,
    region: Option<&Region>,
    draft: &mut Draft<'a>,
) -> Option<Wanted> {
    let mut rows = Vec::new();
    csv_rows::read(reader, "grading_file", &COLUMNS, draft, |table, row| {
        let (radius, count) = (table.radius(row, 0), table.number(row, 1, "count"));
        let (radius, count) = (radius?, count?);
        if !(count >= 0.0 && count.fract() == 0.0 && count <= MOST as f64) {
            return table.refuse(
                row.line(),
                &format!("`count` cannot be {count}"),
                &format!("expected whole numbers from 0 to {MOST}"),
                "a histogram of numbers of particles is meant, not of shares",
            );
        }
        if let Some(problem) = region.and_then(|region| unfit(region, radius, Some(count as u64))) {
            let [message, expected, remedy] = &problem;
            return table.refuse(row.line(), message, expected, remedy);
        }
        rows.push((radius, Some(count as usize)));
        Some(())
    })?;
    whole(reader, "grading_file", rows)
}

/// Radii that were drawn from a distribution.
pub(super) fn drawn(
    reader: &Reader<'_>,
    region: Option<&Region>,
    radii: Vec<f64>,
) -> Option<Wanted> {
    let largest = radii.iter().copied().fold(0.0, f64::max);
    if let Some(problem) = region.and_then(|region| unfit(region, largest, Some(1))) {
        let [message, expected, remedy] = &problem;
        reader.refuse("distribution", message, expected, remedy);
        return None;
    }
    whole(
        reader,
        "distribution",
        radii.into_iter().map(|radius| (radius, Some(1))).collect(),
    )
}

/// The sizes, if they are neither none nor too many.
fn whole(reader: &Reader<'_>, key: &str, rows: Vec<(f64, Option<usize>)>) -> Option<Wanted> {
    if rows.is_empty() {
        reader.refuse(
            key,
            &format!("the `{key}` of {} is empty", reader.title),
            "expected a size or more",
            "write for instance grading = [{ radius = 1e-3, count = 100 }]",
        );
        return None;
    }
    let total: usize = rows.iter().filter_map(|(_, count)| *count).sum();
    if total as u64 > MOST {
        reader.refuse(
            key,
            &format!("{} asks for {total} particles", reader.title),
            &format!("expected {MOST} at most"),
            "ask for fewer",
        );
        return None;
    }
    Some(Wanted::new(rows))
}

/// Why the region cannot hold a size, if so: what, what was expected, what to do.
fn unfit(region: &Region, radius: f64, count: Option<u64>) -> Option<[String; 3]> {
    let [min, max] = region.bounds();
    let half = 0.5 * (max[0] - min[0]).min(max[1] - min[1]);
    if radius > half {
        return Some([
            format!("a particle of radius {radius} m is larger than the region"),
            format!("expected {half} m at most, half its width"),
            "lengths are in metres: give a smaller radius or a larger region".to_owned(),
        ]);
    }
    let most = most(region, radius);
    (count.is_none() && most as u64 > MOST).then(|| {
        [
            format!("{most} particles of radius {radius} m may fit"),
            format!("expected {MOST} at most"),
            "give a `count`, a larger radius or a smaller region".to_owned(),
        ]
    })
}

//! The sizes that are asked for.

use super::MOST;
use super::fill::Size;
use super::region::Region;
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

/// Reads it.
pub(super) fn read(reader: &Reader<'_>, region: Option<&Region>) -> Option<Wanted> {
    if !reader.has("grading") {
        reader.refuse(
            "",
            &format!("{} has no `grading`", reader.title),
            "what is placed is missing here",
            "add grading = [{ radius = 1e-3, count = 100 }]",
        );
        return None;
    }
    let tables = reader.tables("grading")?;
    let mut rows = Vec::with_capacity(tables.len());
    let mut sound = true;
    for table in &tables {
        let (radius, count) = (table.number("radius"), table.count("count"));
        let Some(radius) = radius.filter(|_| count.is_some() || !table.has("count")) else {
            sound = false;
            continue;
        };
        if let Some(region) = region {
            sound &= check_size(table, region, radius, count);
        }
        rows.push((radius, count.map(|count| count as usize)));
    }
    if rows.is_empty() && sound {
        reader.refuse(
            "grading",
            &format!("the `grading` of {} is empty", reader.title),
            "expected a size or more",
            "write grading = [{ radius = 1e-3, count = 100 }]",
        );
        return None;
    }
    let total: usize = rows.iter().filter_map(|(_, count)| *count).sum();
    if total as u64 > MOST {
        reader.refuse(
            "grading",
            &format!("{} asks for {total} particles", reader.title),
            &format!("expected {MOST} at most"),
            "ask for fewer",
        );
        return None;
    }
    sound.then(|| Wanted::new(rows))
}

/// Whether a size is one that the region can hold.
fn check_size(table: &Reader<'_>, region: &Region, radius: f64, count: Option<u64>) -> bool {
    let [min, max] = region.bounds();
    let half = 0.5 * (max[0] - min[0]).min(max[1] - min[1]);
    if radius > half {
        table.refuse(
            "radius",
            &format!("a particle of radius {radius} m is larger than the region"),
            &format!("expected {half} m at most, half its width"),
            "lengths are in metres: give a smaller radius or a larger region",
        );
        return false;
    }
    let most = most(region, radius);
    if count.is_none() && most as u64 > MOST {
        table.refuse(
            "radius",
            &format!("{most} particles of radius {radius} m may fit"),
            &format!("expected {MOST} at most"),
            "give a `count`, a larger radius or a smaller region",
        );
        return false;
    }
    true
}

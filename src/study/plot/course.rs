//! How one quantity of a history goes with another.

use super::table::{Place, Table};
use crate::measure::columns::nearest;
use crate::record::history::FIRST_COLUMNS;
use crate::session::Refusal;

/// A line of a chart.
pub(super) struct Course {
    /// Its name in the legend.
    pub(super) name: String,
    /// What the rows give, in order. Where one is not defined the line has a gap.
    pub(super) points: Vec<Point>,
    /// Whether it is the mean over an ensemble.
    pub(super) is_mean: bool,
}

/// What a row gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    /// Across.
    pub(super) x: f64,
    /// Up; the mean over an ensemble.
    pub(super) y: f64,
    /// One standard deviation below and above; nan if there is none.
    pub(super) within: [f64; 2],
    /// The least and the greatest of an ensemble; nan if there are none.
    pub(super) extremes: [f64; 2],
}

impl Point {
    fn is_defined(&self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

/// The rows of a table that are drawn.
pub(super) struct Rows {
    places: Vec<usize>,
    /// Rows of an ensemble that are left out because some seeds have none there: their mean would
    /// jump where a seed drops out.
    pub(super) left_out: usize,
}

impl Rows {
    /// Those of a stage, or of all.
    pub(super) fn of(table: &Table, stage: Option<&str>) -> Result<Self, Refusal> {
        let all = 0..table.rows();
        let mut places: Vec<usize> = match stage {
            None => all.collect(),
            Some(stage) => of_stage(table, stage)?,
        };
        let before = places.len();
        if let (Some(n), Some(_)) = (table.column("n"), table.column("row")) {
            let counts = places.iter().map(|row| table.number(*row, n));
            let counts: Vec<f64> = counts.collect::<Result<_, _>>()?;
            let all = counts.iter().copied().fold(0.0, f64::max);
            let mut counts = counts.into_iter();
            places.retain(|_| counts.next() == Some(all));
        }
        Ok(Self {
            left_out: before - places.len(),
            places,
        })
    }
}

fn of_stage(table: &Table, stage: &str) -> Result<Vec<usize>, Refusal> {
    let Some(column) = table.column(FIRST_COLUMNS[2]) else {
        return Err(table.refuse("it has no column `stage`", "leave --stage out"));
    };
    let all = 0..table.rows();
    let places: Vec<usize> = all
        .clone()
        .filter(|row| table.text(*row, column) == stage)
        .collect();
    if places.is_empty() {
        let mut known: Vec<&str> = all.map(|row| table.text(row, column)).collect();
        known.dedup();
        known.retain(|name| !name.is_empty());
        return Err(table.refuse(
            &format!("it has no row of a stage `{stage}`"),
            &nearest(stage, known.into_iter()),
        ));
    }
    Ok(places)
}

impl Course {
    /// Reads one quantity over another.
    pub(super) fn read(table: &Table, rows: &Rows, x: &str, y: &str) -> Result<Self, Refusal> {
        let (across, up) = (table.find(x)?, table.find(y)?);
        let (Place::Single(x_column) | Place::Spread(x_column, _)) = across;
        let (y_column, spread) = match up {
            Place::Single(column) => (column, [None; 3]),
            Place::Spread(column, spread) => (column, spread),
        };
        let mut points = Vec::with_capacity(rows.places.len());
        for &row in &rows.places {
            let x = table.number(row, x_column)?;
            let y = table.number(row, y_column)?;
            let mut told = [f64::NAN; 3];
            for (told, column) in told.iter_mut().zip(spread) {
                if let Some(column) = column {
                    *told = table.number(row, column)?;
                }
            }
            let [sd, min, max] = told;
            points.push(Point {
                x,
                y,
                within: [y - sd, y + sd],
                extremes: [min, max],
            });
        }
        if !points.iter().any(Point::is_defined) {
            return Err(table.refuse(
                &format!("no row has both a `{x}` and a `{y}`"),
                "they are nan there: choose other columns, or another stage",
            ));
        }
        Ok(Self {
            name: String::new(),
            points,
            is_mean: spread.iter().any(Option::is_some),
        })
    }

    /// Its parts without gaps.
    pub(super) fn parts(&self) -> impl Iterator<Item = &[Point]> {
        let parts = self.points.split(|point| !point.is_defined());
        parts.filter(|part| !part.is_empty())
    }

    /// Everything it reaches upwards and downwards.
    pub(super) fn heights(&self) -> impl Iterator<Item = f64> + Clone {
        self.points.iter().flat_map(|point| {
            let [[a, b], [c, d]] = [point.within, point.extremes];
            [point.y, a, b, c, d]
        })
    }
}

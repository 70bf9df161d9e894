//! Marks: what a chart is compared with.

use std::path::Path;

use super::table::Table;
use crate::session::Refusal;

/// Columns of a file of marks.
const COLUMNS: [&str; 3] = ["x", "y", "label"];

/// A number that the curves are compared with.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Where it is.
    pub at: At,
    /// What it is.
    pub label: String,
}

/// Where a mark is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum At {
    /// At a point.
    Point(f64, f64),
    /// All along this height.
    Level(f64),
    /// All the way up here.
    Upright(f64),
}

impl Mark {
    /// `X,Y,LABEL`, or the marks in a file; X or Y may be left empty for a line.
    pub fn parse(text: &str) -> Result<Vec<Self>, Refusal> {
        let parts: Vec<&str> = text.splitn(3, ',').collect();
        if let [x, y, label] = parts.as_slice() {
            return Ok(vec![Self::of(x, y, label).map_err(|why| {
                Refusal::new(
                    format!("--marks {text}: {why}"),
                    "write X,Y,LABEL; leave X or Y empty for a line: ,0.36,peak of the source",
                )
            })?]);
        }
        let path = Path::new(text);
        if parts.len() == 2 && !path.exists() {
            return Err(Refusal::new(
                format!("--marks {text}: it has no label"),
                "write X,Y,LABEL, or the name of a CSV file with the columns x, y, label",
            ));
        }
        let table = Table::read(path)?;
        let mut places = [0; 3];
        for (place, name) in places.iter_mut().zip(COLUMNS) {
            *place = table.column(name).ok_or_else(|| {
                table.refuse(
                    &format!("its header has no `{name}`"),
                    "a file of marks has the columns x, y, label",
                )
            })?;
        }
        let marks = (0..table.rows()).map(|row| {
            let [x, y, label] = places.map(|place| table.text(row, place));
            Self::of(x, y, label).map_err(|why| {
                table.refuse(
                    &format!("mark {}: {why}", row + 1),
                    "leave x or y empty for a line, and the other not",
                )
            })
        });
        marks.collect()
    }

    fn of(x: &str, y: &str, label: &str) -> Result<Self, String> {
        let number = |text: &str| match text.trim() {
            "" => Ok(None),
            text => match text.parse::<f64>() {
                Ok(number) if number.is_finite() => Ok(Some(number)),
                _ => Err(format!("`{text}` is no number")),
            },
        };
        let at = match (number(x)?, number(y)?) {
            (Some(x), Some(y)) => At::Point(x, y),
            (None, Some(y)) => At::Level(y),
            (Some(x), None) => At::Upright(x),
            (None, None) => return Err("it is nowhere".into()),
        };
        let label = label.trim().to_owned();
        Ok(Self { at, label })
    }

    /// How far across it is, if it is anywhere in particular.
    pub fn x(&self) -> Option<f64> {
        match self.at {
            At::Point(x, _) | At::Upright(x) => Some(x),
            At::Level(_) => None,
        }
    }

    /// How far up it is, if it is anywhere in particular.
    pub fn y(&self) -> Option<f64> {
        match self.at {
            At::Point(_, y) | At::Level(y) => Some(y),
            At::Upright(_) => None,
        }
    }
}

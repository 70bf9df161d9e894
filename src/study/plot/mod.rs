//! Charts of histories: any column over any other, of one run, of several, or of an ensemble with its
//! spread, with marks for what they are compared with.

mod axis;
mod course;
mod draw;
mod mark;
mod table;

pub use mark::{At, Mark};
pub use table::Table;

use std::path::Path;

use crate::session::Refusal;
use course::{Course, Rows};
use draw::Content;

/// What is to be drawn of the histories.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Wanted {
    /// Column across.
    pub x: String,
    /// Columns up.
    pub y: Vec<String>,
    /// Only the rows of this stage.
    pub stage: Option<String>,
    /// Numbers to compare with.
    pub marks: Vec<Mark>,
    /// Title, instead of the names of the columns.
    pub title: Option<String>,
}

/// A chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// As SVG.
    pub svg: String,
    /// Things the user should know.
    pub notices: Vec<String>,
}

/// Draws histories over each other.
pub fn chart(tables: &[Table], wanted: &Wanted) -> Result<Drawing, Refusal> {
    let stage = wanted.stage.as_deref();
    let mut courses = Vec::new();
    let mut notices = Vec::new();
    for table in tables {
        let rows = Rows::of(table, stage)?;
        if rows.left_out > 0 {
            notices.push(format!(
                "{}: {} rows are left out that not all seeds have",
                table.name, rows.left_out
            ));
        }
        for y in &wanted.y {
            let mut course = Course::read(table, &rows, &wanted.x, y)?;
            course.name = legend(table, y, tables.len(), wanted.y.len());
            courses.push(course);
        }
    }
    let across = axis::name(std::slice::from_ref(&wanted.x))?;
    let up = axis::name(&wanted.y)?;
    let usual = format!("{} over {}", wanted.y.join(", "), wanted.x);
    let svg = draw::svg(&Content {
        title: wanted.title.as_deref().unwrap_or(&usual),
        caption: &caption(&courses, stage),
        axes: [&across, &up],
        courses: &courses,
        marks: &wanted.marks,
    });
    let svg = svg.map_err(|error| {
        Refusal::new(
            format!("the chart cannot be drawn: {error}"),
            "the CSV files hold its numbers",
        )
    })?;
    Ok(Drawing { svg, notices })
}

/// What tells a line from the others.
fn legend(table: &Table, y: &str, tables: usize, columns: usize) -> String {
    let stem = Path::new(&table.name).file_stem();
    let stem = stem.unwrap_or_default().to_string_lossy().into_owned();
    match (tables, columns) {
        (1, _) => y.to_owned(),
        (_, 1) => stem,
        _ => format!("{stem}: {y}"),
    }
}

fn caption(courses: &[Course], stage: Option<&str>) -> String {
    let stage = stage.map(|stage| format!("stage {stage}"));
    let mean = courses.iter().any(|course| course.is_mean);
    let mean = mean.then(|| {
        "mean over the seeds; band: ± standard deviation; thin: least and greatest".to_owned()
    });
    let parts: Vec<String> = stage.into_iter().chain(mean).collect();
    parts.join("; ")
}

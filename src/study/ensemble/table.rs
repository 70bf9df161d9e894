//! The history of an ensemble: mean, standard deviation, minimum and maximum of every column, row by
//! row.
//!
//! Rows are counted from 0 in each stage, and the first row of a stage in one seed belongs to the
//! first in the others: stages that end by a condition end at other cycles in other seeds. Where a
//! stage is longer in some seeds, its later rows are those of these seeds alone; `n` says how many.

use super::spread::Spread;
use crate::measure::columns::Kind;
use crate::record::number::Cell;
use crate::record::table::CsvTable;
use crate::session::Recording;

/// What is told of each column.
const TOLD: [&str; 4] = ["mean", "sd", "min", "max"];

/// Lays it out: `cycle` and `time` are means over the `n` seeds. `stages` are the names of the
/// stages; columns that are no numbers are left out.
pub fn table(stages: &[String], runs: &[&Recording]) -> CsvTable {
    let columns: Vec<_> = runs
        .first()
        .into_iter()
        .flat_map(|run| run.shown())
        .filter(|column| column.kind() != Kind::Hash)
        .collect();
    let mut header: Vec<String> = ["cycle", "time", "stage", "row", "n"]
        .map(str::to_owned)
        .to_vec();
    for column in &columns {
        header.extend(TOLD.map(|told| format!("{}:{told}", column.name())));
    }
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    let mut table = CsvTable::new(&header);
    for stage in 0..stages.len().max(1) {
        // Places of the rows of this stage, seed by seed.
        let rows: Vec<Vec<usize>> = runs.iter().map(|run| rows_of(run, stage)).collect();
        let longest = rows.iter().map(Vec::len).max().unwrap_or_default();
        for k in 0..longest {
            let here: Vec<(&Recording, usize)> = runs
                .iter()
                .zip(&rows)
                .filter_map(|(run, rows)| Some((*run, *rows.get(k)?)))
                .collect();
            let n = here.len() as f64;
            let cycle: f64 = here
                .iter()
                .map(|(run, row)| run.rows()[*row].cycle as f64)
                .sum();
            let time: f64 = here.iter().map(|(run, row)| run.rows()[*row].time).sum();
            let mut cells = vec![
                Cell::Real(cycle / n),
                Cell::Real(time / n),
                Cell::name(stages.get(stage).map_or("", String::as_str)),
                Cell::Count(k as u64),
                Cell::Count(here.len() as u64),
            ];
            for column in &columns {
                let values = here.iter().map(|(run, row)| {
                    let place = run.position(column);
                    place.map_or(f64::NAN, |place| run.value(*row, place))
                });
                let spread = Spread::of(values);
                cells.extend([spread.mean, spread.sd, spread.min, spread.max].map(Cell::Real));
            }
            table.row(&cells);
        }
    }
    table
}

fn rows_of(run: &Recording, stage: usize) -> Vec<usize> {
    let rows = run.rows().iter().enumerate();
    rows.filter(|(_, row)| row.stage as usize == stage)
        .map(|(place, _)| place)
        .collect()
}

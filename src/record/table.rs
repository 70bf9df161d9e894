//! Tables of one moment as CSV (RFC 4180, line ends LF): a header and rows, put together in memory
//! and written as a whole file.

use super::history::encode;
use super::number::Cell;

/// A table being filled.
#[derive(Debug, Clone, PartialEq)]
pub struct CsvTable {
    width: usize,
    bytes: Vec<u8>,
}

impl CsvTable {
    /// Without rows yet.
    pub fn new(columns: &[&str]) -> Self {
        let mut table = Self {
            width: columns.len(),
            bytes: Vec::new(),
        };
        encode(&mut table.bytes, columns.iter());
        table
    }

    /// Adds a row.
    ///
    /// # Panics
    /// If there are more or fewer cells than columns.
    pub fn row(&mut self, cells: &[Cell<'_>]) {
        assert_eq!(cells.len(), self.width, "one cell for each column");
        encode(&mut self.bytes, cells.iter().map(Cell::text));
    }

    /// The text of the file.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_follow_their_header() {
        let mut table = CsvTable::new(&["ball", "with", "n"]);
        table.row(&[
            Cell::Count(1),
            Cell::name("a \"wall\", odd"),
            Cell::Real(0.1),
        ]);
        table.row(&[Cell::Count(2), Cell::name("3"), Cell::Real(f64::NAN)]);
        let text = "ball,with,n\n1,\"a \"\"wall\"\", odd\",0.1\n2,3,nan\n";
        assert_eq!(table.bytes(), text.as_bytes());
    }
}

//! Tables as lines of text: a row of names, a row of units, columns that line up, never wider than
//! [`WIDTH`].

use crate::session::figure::figure;

/// Widest line [characters].
pub(super) const WIDTH: usize = 100;

/// Longest name that is shown whole [characters].
const NAME: usize = 16;

/// Head of a column.
#[derive(Debug, Clone, Copy)]
pub(super) struct Head {
    name: &'static str,
    unit: &'static str,
    words: bool,
}

/// A column of numbers.
pub(super) const fn number(name: &'static str, unit: &'static str) -> Head {
    Head {
        name,
        unit,
        words: false,
    }
}

/// A column of words.
pub(super) const fn words(name: &'static str) -> Head {
    Head {
        name,
        unit: "",
        words: true,
    }
}

/// A table being filled.
#[derive(Debug)]
pub(super) struct Table {
    heads: Vec<Head>,
    /// Columns at the front that tell the rows apart: they come again where a table is broken.
    keys: usize,
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(super) fn new(keys: usize, heads: &[Head]) -> Self {
        Self {
            heads: heads.to_vec(),
            keys,
            rows: Vec::new(),
        }
    }

    /// Adds a row: the keys and other words as they come, numbers as figures.
    pub(super) fn row(&mut self, cells: Vec<String>) {
        debug_assert_eq!(cells.len(), self.heads.len(), "one cell for each column");
        self.rows.push(cells);
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The lines. A table too wide for one goes on below itself, with its keys again.
    pub(super) fn lines(&self) -> Vec<String> {
        let widths: Vec<usize> = (0..self.heads.len()).map(|c| self.width(c)).collect();
        let front: usize = widths[..self.keys].iter().map(|w| w + 2).sum();
        let mut lines = Vec::new();
        let mut next = self.keys;
        while next < self.heads.len() {
            let first = next;
            let mut used = front;
            while next < widths.len() && (next == first || used + widths[next] <= WIDTH) {
                used += widths[next] + 2;
                next += 1;
            }
            let columns: Vec<usize> = (0..self.keys).chain(first..next).collect();
            if first > self.keys {
                lines.push(String::new());
            }
            lines.extend(self.block(&columns, &widths));
        }
        lines
    }

    fn width(&self, c: usize) -> usize {
        let head = &self.heads[c];
        let cells = self.rows.iter().map(|row| row[c].chars().count());
        let heads = [head.name.chars().count(), unit(head).chars().count()];
        cells.chain(heads).max().unwrap_or(0)
    }

    fn block(&self, columns: &[usize], widths: &[usize]) -> Vec<String> {
        let line = |cell: &dyn Fn(usize) -> String| {
            let cells = columns.iter().map(|&c| {
                let width = widths[c];
                if self.heads[c].words {
                    format!("{:<width$}", cell(c))
                } else {
                    format!("{:>width$}", cell(c))
                }
            });
            let line: Vec<String> = cells.collect();
            line.join("  ").trim_end().to_owned()
        };
        let mut lines = vec![line(&|c| self.heads[c].name.to_owned())];
        if columns.iter().any(|&c| !self.heads[c].unit.is_empty()) {
            lines.push(line(&|c| unit(&self.heads[c])));
        }
        lines.extend(self.rows.iter().map(|row| line(&|c| row[c].clone())));
        lines
    }
}

fn unit(head: &Head) -> String {
    if head.unit.is_empty() {
        String::new()
    } else {
        format!("[{}]", head.unit)
    }
}

/// A name, shortened where it would push the numbers off the line.
pub(super) fn name(text: &str) -> String {
    if text.chars().count() <= NAME {
        return text.to_owned();
    }
    let start: String = text.chars().take(NAME - 3).collect();
    start + "..."
}

/// A figure, or a dash where there is none.
pub(super) fn optional(x: Option<f64>) -> String {
    x.map_or_else(|| "-".to_owned(), figure)
}

/// Lines of `what  value`, the values below each other.
pub(in crate::session) fn listed(rows: &[(&str, String)]) -> Vec<String> {
    let width = rows.iter().map(|(what, _)| what.chars().count()).max();
    let width = width.unwrap_or(0);
    rows.iter()
        .map(|(what, value)| format!("{what:<width$}  {value}").trim_end().to_owned())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_line_up_under_names_and_units() {
        let mut table = Table::new(1, &[number("no", ""), number("x", "m"), words("marks")]);
        table.row(vec!["1".into(), figure(0.5), "x y".into()]);
        table.row(vec!["12".into(), figure(-1.25e-9), String::new()]);
        assert_eq!(
            table.lines(),
            [
                "no         x  marks",
                "         [m]",
                " 1       0.5  x y",
                "12  -1.25e-9",
            ]
        );
    }

    #[test]
    fn wide_tables_go_on_below_with_their_keys() {
        let heads: Vec<Head> = std::iter::once(words("name"))
            .chain((0..12).map(|_| number("a quantity", "N")))
            .collect();
        let mut table = Table::new(1, &heads);
        let cells = std::iter::once(name("a name without any end to it"));
        table.row(
            cells
                .chain((0..12).map(|k| figure(-1.234_567e-100 * f64::from(k + 1))))
                .collect(),
        );
        let lines = table.lines();
        assert!(
            lines.iter().all(|line| line.chars().count() <= WIDTH),
            "{lines:#?}"
        );
        let keys = lines
            .iter()
            .filter(|line| line.starts_with("a name withou..."));
        assert_eq!(keys.count(), 2, "{lines:#?}");
        let all = lines.join(" ");
        assert_eq!(
            all.matches("e-100").count() + all.matches("e-99").count(),
            12
        );
    }

    #[test]
    fn lists_line_up() {
        let lines = listed(&[("dt", "1 s".into()), ("frac limit", "2".into())]);
        assert_eq!(lines, ["dt          1 s", "frac limit  2"]);
    }
}

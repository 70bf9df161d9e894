//! Tables of text: figures stand below each other.

/// Rows of cells as lines. The first `left` columns are set to the left, the others to the right; a
/// last cell beyond `columns` follows as it is.
pub(super) fn aligned(rows: &[Vec<String>], left: usize, columns: usize) -> Vec<String> {
    let width = |k: usize| {
        let cells = rows.iter().filter_map(|row| row.get(k));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    rows.iter()
        .map(|row| {
            let cells = row.iter().enumerate().map(|(k, cell)| match widths.get(k) {
                Some(&w) if k < left => format!("{cell:w$}"),
                Some(&w) => format!("{cell:>w$}"),
                None => cell.clone(),
            });
            let cells: Vec<String> = cells.collect();
            cells.join("  ").trim_end().to_owned()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_stand_below_each_other() {
        let rows = [["a", "1", "one"], ["bc", "100", ""]];
        let rows = rows.map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(aligned(&rows, 1, 2), ["a     1  one", "bc  100"]);
    }
}

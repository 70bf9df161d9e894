//! The reference of all keys, made from their declarations.

use super::SECTIONS;
use super::key::Key;

/// All sections and keys as Markdown: what the README shows.
pub fn reference_table() -> String {
    let mut lines = Vec::new();
    for section in SECTIONS {
        let required = if section.required { " Required." } else { "" };
        lines.push(format!("### `{}`\n", section.header("NAME")));
        lines.push(format!("{}.{required}\n", capital(section.summary)));
        lines.push("| key | value | default | meaning |".to_owned());
        lines.push("|---|---|---|---|".to_owned());
        for key in section.keys {
            push_rows(&mut lines, "", key);
        }
        lines.push(String::new());
    }
    lines.join("\n")
}

/// The same as plain text with aligned columns: what `ballast keys` shows.
pub fn reference_text() -> String {
    let mut lines = Vec::new();
    for section in SECTIONS {
        let required = if section.required { " (required)" } else { "" };
        let header = section.header("NAME");
        lines.push(format!("{header}  {}{required}", section.summary));
        let mut rows = Vec::new();
        for key in section.keys {
            push_cells(&mut rows, "", key);
        }
        let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max();
        let widths = [0, 1, 2].map(|k| width(k).unwrap_or(0));
        for [name, wanted, absent, summary] in &rows {
            let [a, b, c] = widths;
            lines.push(format!("  {name:a$}  {wanted:b$}  {absent:c$}  {summary}"));
        }
        lines.push(String::new());
    }
    lines.insert(
        0,
        "of each key: what stands there, what holds if it is left out, what it means\n".to_owned(),
    );
    lines.join("\n")
}

fn push_cells(rows: &mut Vec<[String; 4]>, within: &str, key: &Key) {
    let name = format!("{within}{}", key.name);
    let summary = key.summary.to_owned();
    rows.push([name.clone(), key.wanted(), key.absent.to_string(), summary]);
    if let Some(keys) = key.form.inner() {
        for key in keys {
            push_cells(rows, &format!("{name}."), key);
        }
    }
}

fn push_rows(lines: &mut Vec<String>, within: &str, key: &Key) {
    let name = format!("{within}{}", key.name);
    let (wanted, absent) = (cell(&key.wanted()), cell(&key.absent.to_string()));
    let summary = cell(key.summary);
    lines.push(format!("| `{name}` | {wanted} | {absent} | {summary} |"));
    if let Some(keys) = key.form.inner() {
        for key in keys {
            push_rows(lines, &format!("{name}."), key);
        }
    }
}

fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().collect::<String>() + letters.as_str()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_is_declared_once_and_documented() {
        let table = reference_table();
        for section in SECTIONS {
            assert!(table.contains(&section.header("NAME")));
            for (k, key) in section.keys.iter().enumerate() {
                assert!(!key.summary.is_empty(), "{}.{}", section.name, key.name);
                let twice = section.keys[k + 1..]
                    .iter()
                    .any(|other| other.name == key.name);
                assert!(!twice, "{}.{}", section.name, key.name);
                assert!(table.contains(&format!("| `{}` | ", key.name)));
            }
        }
    }
}

//! The reference of all keys, made from their declarations.

use super::SECTIONS;
use super::key::{Form, Key};

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

fn push_rows(lines: &mut Vec<String>, within: &str, key: &Key) {
    let name = format!("{within}{}", key.name);
    let (wanted, absent) = (cell(&key.wanted()), cell(&key.absent.to_string()));
    let summary = cell(key.summary);
    lines.push(format!("| `{name}` | {wanted} | {absent} | {summary} |"));
    if let Form::Table(keys) | Form::VectorOrTable(keys) = key.form {
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

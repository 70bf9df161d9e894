//! Words of commands that are shown to be copied into a shell.

/// A word that a shell takes as it is, quoted if need be.
pub fn shell_word(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./+,:@%".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_come_through_a_shell_as_they_are() {
        for (text, expected) in [
            ("out/run-1.csv", "out/run-1.csv"),
            ("my run.csv", "'my run.csv'"),
            ("a'b", "'a'\\''b'"),
            ("", "''"),
            ("$HOME", "'$HOME'"),
        ] {
            assert_eq!(shell_word(text), expected);
        }
    }
}

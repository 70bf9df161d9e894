//! Text within one line: in quotes, with `\` before what would end or break them.

/// In quotes.
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = String::with_capacity(text.len() + 2);
    quoted.push('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            c if c.is_control() => quoted.extend(c.escape_unicode()),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

/// As it is when that reads back the same, else in quotes.
pub(super) fn quoted_if_needed(text: &str) -> String {
    let plain = !text.is_empty()
        && !text.starts_with('"')
        && text.trim() == text
        && !text.contains(char::is_control);
    if plain { text.into() } else { quoted(text) }
}

/// What [`quoted_if_needed`] or [`quoted`] was given, or what is wrong.
pub(super) fn unquoted_if_quoted(text: &str) -> Result<String, String> {
    if text.starts_with('"') {
        unquoted(text)
    } else {
        Ok(text.to_owned())
    }
}

/// What [`quoted`] was given, or what is wrong.
pub(super) fn unquoted(quoted: &str) -> Result<String, String> {
    let inner = quoted
        .strip_prefix('"')
        .ok_or_else(|| format!("`{quoted}` does not start with a quotation mark"))?;
    let mut text = String::with_capacity(inner.len());
    let mut rest = inner.chars();
    while let Some(c) = rest.next() {
        match c {
            '"' if rest.as_str().is_empty() => return Ok(text),
            '"' => {
                return Err(format!(
                    "`{}` follows the closing quotation mark",
                    rest.as_str()
                ));
            }
            '\\' => text.push(escaped(&mut rest)?),
            c => text.push(c),
        }
    }
    Err("the closing quotation mark is missing".into())
}

fn escaped(rest: &mut std::str::Chars<'_>) -> Result<char, String> {
    match rest.next() {
        Some(c @ ('"' | '\\')) => Ok(c),
        Some('n') => Ok('\n'),
        Some('r') => Ok('\r'),
        Some('t') => Ok('\t'),
        Some('u') => {
            let code = rest
                .as_str()
                .strip_prefix('{')
                .and_then(|code| code.split_once('}'));
            let (digits, after) = code.ok_or("`\\u` needs a number in braces")?;
            *rest = after.chars();
            u32::from_str_radix(digits, 16)
                .ok()
                .and_then(char::from_u32)
                .ok_or_else(|| format!("`\\u{{{digits}}}` is no character"))
        }
        Some(c) => Err(format!("`\\{c}` means nothing")),
        None => Err("the line ends after `\\`".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_text_stays_plain() {
        for (text, written) in [
            ("friction 0.3", "friction 0.3"),
            ("say \"x\"", "say \"x\""),
            ("", "\"\""),
            (" x", "\" x\""),
            ("\"x", "\"\\\"x\""),
            ("a\nb\u{1}", "\"a\\nb\\u{1}\""),
        ] {
            assert_eq!(quoted_if_needed(text), written);
            assert_eq!(unquoted_if_quoted(written).unwrap(), text);
        }
    }

    #[test]
    fn wrong_quotes_are_explained() {
        for (text, hint) in [
            ("x", "start"),
            ("\"x", "closing"),
            ("\"x\"y", "`y` follows"),
            ("\"\\q\"", "`\\q` means nothing"),
            ("\"\\u{110000}\"", "no character"),
            ("\"\\u61\"", "braces"),
            ("\"\\", "ends after"),
        ] {
            let error = unquoted(text).unwrap_err();
            assert!(error.contains(hint), "{text}: {error}");
        }
    }
}

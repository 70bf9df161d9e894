//! Cuts an expression into tokens.

use crate::language::mistake::{Mistake, shown};
use crate::language::number;
use std::ops::Range;

/// The smallest piece of an expression.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind<'a> {
    Number(f64),
    /// A column, a variable or a function.
    Name(&'a str),
    Or,
    And,
    AtLeast,
    More,
    AtMost,
    Less,
    Equal,
    Plus,
    Minus,
    Times,
    Over,
    Open,
    Close,
    Comma,
    End,
}

/// A token and the bytes it was read from.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Token<'a> {
    pub(super) kind: Kind<'a>,
    pub(super) span: Range<usize>,
}

/// Reads the token that begins at or after byte `from`.
pub(super) fn token(text: &str, from: usize) -> Result<Token<'_>, Mistake> {
    let rest = &text[from..];
    let start = from + rest.len() - rest.trim_start().len();
    let rest = &text[start..];
    let taken = |kind, length| {
        Ok(Token {
            kind,
            span: start..start + length,
        })
    };
    let Some(first) = rest.chars().next() else {
        return taken(Kind::End, 0);
    };
    if first.is_ascii_digit() || first == '.' {
        let length = numeral(rest);
        let span = start..start + length;
        let kind = numeral_value(&rest[..length], span.clone())?;
        return Ok(Token { kind, span });
    }
    if first.is_alphabetic() || first == '_' {
        let word = &rest[..name(rest)];
        let kind = match word.to_ascii_lowercase().as_str() {
            "and" => Kind::And,
            "or" => Kind::Or,
            _ => Kind::Name(word),
        };
        return taken(kind, word.len());
    }
    for (sign, kind) in [
        (">=", Kind::AtLeast),
        ("<=", Kind::AtMost),
        ("==", Kind::Equal),
        (">", Kind::More),
        ("<", Kind::Less),
        ("+", Kind::Plus),
        ("-", Kind::Minus),
        ("*", Kind::Times),
        ("/", Kind::Over),
        ("(", Kind::Open),
        (")", Kind::Close),
        (",", Kind::Comma),
    ] {
        if rest.starts_with(sign) {
            return taken(kind, sign.len());
        }
    }
    let (sign, remedy) = match first {
        '=' => ("=", "equality is written `==`"),
        '&' => ("&", "write `and`"),
        '|' => ("|", "write `or`"),
        '!' => ("!", "turn the comparison round instead"),
        '^' => ("^", "write powers as products"),
        '[' | '{' => (&rest[..1], "write parentheses as `(` and `)`"),
        _ => (
            &rest[..first.len_utf8()],
            "expressions hold columns, numbers, + - * /, comparisons, `and`, `or` and parentheses",
        ),
    };
    let message = format!("{} has no meaning in an expression", shown(sign));
    Err(Mistake::new(message, remedy, start..start + sign.len()))
}

fn numeral_value(text: &str, span: Range<usize>) -> Result<Kind<'_>, Mistake> {
    match number::parse(text) {
        Some(value) if value.is_finite() => Ok(Kind::Number(value)),
        Some(_) => Err(Mistake::new(
            format!("{} is too large", shown(text)),
            "the largest number is about 1.8e308",
            span,
        )),
        None => Err(Mistake::new(
            format!("{} is no number", shown(text)),
            "numbers look like 1_000, 0.5 or 1e-3",
            span,
        )),
    }
}

/// Length of what looks like a number, whether it is one or not.
fn numeral(text: &str) -> usize {
    let bytes = text.as_bytes();
    let signed_exponent = |at: usize| {
        at > 0
            && matches!(bytes[at - 1], b'e' | b'E')
            && matches!(bytes[at], b'+' | b'-')
            && bytes.get(at + 1).is_some_and(u8::is_ascii_digit)
    };
    text.char_indices()
        .find(|&(at, c)| !(c.is_alphanumeric() || c == '_' || c == '.' || signed_exponent(at)))
        .map_or(text.len(), |(at, _)| at)
}

/// Length of a name. A `-` belongs to it only between the bodies of a contact or the numbers of
/// particles, so that everywhere else it subtracts.
fn name(text: &str) -> usize {
    let mut colons = 0;
    let mut joined = false;
    let mut family = "";
    for (at, c) in text.char_indices() {
        match c {
            ':' => {
                if colons == 0 {
                    family = &text[..at];
                }
                colons += 1;
            }
            '-' if colons == 1
                && !joined
                && ["contact", "particle"]
                    .iter()
                    .any(|joins| family.eq_ignore_ascii_case(joins)) =>
            {
                joined = true;
            }
            c if c.is_alphanumeric() || c == '_' => {}
            _ => return at,
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        let mut found = Vec::new();
        let mut at = 0;
        loop {
            let token = token(text, at).unwrap();
            if token.kind == Kind::End {
                return found;
            }
            at = token.span.end;
            found.push(&text[token.span]);
        }
    }

    #[test]
    fn a_dash_joins_bodies_and_numbers_and_subtracts_elsewhere() {
        for (text, expected) in [
            ("wall:left:f1-1", vec!["wall:left:f1", "-", "1"]),
            ("contact:1-floor:n-2", vec!["contact:1-floor:n", "-", "2"]),
            ("Contact:1-2:n", vec!["Contact:1-2:n"]),
            ("particle:1-9:vx-1", vec!["particle:1-9:vx", "-", "1"]),
            ("a-b", vec!["a", "-", "b"]),
            ("1e-3-x", vec!["1e-3", "-", "x"]),
        ] {
            assert_eq!(words(text), expected);
        }
    }

    #[test]
    fn signs_of_other_languages_are_explained() {
        for (text, hint) in [
            ("a = 1", "`==`"),
            ("a && b", "`and`"),
            ("a | b", "`or`"),
            ("3max", "is no number"),
            ("1e999", "too large"),
            ("é§", "parentheses"),
        ] {
            let mut at = 0;
            let mistake = loop {
                match token(text, at) {
                    Ok(token) => at = token.span.end,
                    Err(mistake) => break mistake,
                }
            };
            assert!(mistake.to_string().contains(hint), "{text}: {mistake}");
            assert!(text.get(mistake.span).is_some());
        }
    }
}

//! Just enough reading of Rust for the rules: code without its comments and strings, and paths.

use std::path::Path;

/// Whether a file is one of Rust's, by its name.
pub(crate) fn is_rust(path: &str) -> bool {
    Path::new(path).extension().is_some_and(|end| end == "rs")
}

/// The code of a file: comments, strings and characters become spaces, lines stay where they are.
pub(crate) fn code_only(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut code = String::with_capacity(text.len());
    let mut k = 0;
    while k < chars.len() {
        let end = skipped_to(&chars, k);
        if end == k {
            code.push(chars[k]);
            k += 1;
        }
        while k < end {
            code.push(if chars[k] == '\n' { '\n' } else { ' ' });
            k += 1;
        }
    }
    code
}

/// Where the comment, string or character that starts at `k` ends; `k` when none does.
fn skipped_to(chars: &[char], k: usize) -> usize {
    let at = |k: usize| chars.get(k).copied().unwrap_or('\0');
    match (at(k), at(k + 1)) {
        ('/', '/') => find_from(chars, k, "\n").unwrap_or(chars.len()),
        ('/', '*') => {
            let (mut depth, mut end) = (1, k + 2);
            while depth > 0 && end < chars.len() {
                match (at(end), at(end + 1)) {
                    ('*', '/') => depth -= 1,
                    ('/', '*') => depth += 1,
                    _ => {
                        end += 1;
                        continue;
                    }
                }
                end += 2;
            }
            end
        }
        ('"', _) => quoted_to(chars, k + 1, '"'),
        ('r', '"' | '#') if k == 0 || !is_word(at(k - 1)) || is_byte_prefix(chars, k - 1) => {
            let hashes = chars[k + 1..].iter().take_while(|c| **c == '#').count();
            if at(k + 1 + hashes) != '"' {
                return k;
            }
            let close = format!("\"{}", "#".repeat(hashes));
            let end = find_from(chars, k + 2 + hashes, &close);
            end.map_or(chars.len(), |end| end + close.len())
        }
        ('\'', '\\') => quoted_to(chars, k + 1, '\''),
        ('\'', _) if at(k + 2) == '\'' => k + 3,
        _ => k,
    }
}

fn is_byte_prefix(chars: &[char], k: usize) -> bool {
    matches!(chars[k], 'b' | 'c') && (k == 0 || !is_word(chars[k - 1]))
}

fn quoted_to(chars: &[char], mut k: usize, close: char) -> usize {
    while k < chars.len() && chars[k] != close {
        k += if chars[k] == '\\' { 2 } else { 1 };
    }
    chars.len().min(k + 1)
}

fn find_from(chars: &[char], from: usize, what: &str) -> Option<usize> {
    let what: Vec<char> = what.chars().collect();
    let rest = chars.get(from..)?;
    let at = rest.windows(what.len()).position(|piece| piece == what);
    at.map(|at| from + at)
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Line number and word for every line that holds one of the words, whole.
pub(crate) fn find<'a>(text: &str, words: &'a [impl AsRef<str>]) -> Vec<(usize, &'a str)> {
    let mut found = Vec::new();
    for (k, line) in text.lines().enumerate() {
        for word in words.iter().map(AsRef::as_ref) {
            let whole = |at: usize| {
                let before = line[..at].chars().next_back();
                let after = line[at + word.len()..].chars().next();
                !(word.starts_with(is_word) && before.is_some_and(is_word)
                    || word.ends_with(is_word) && after.is_some_and(is_word))
            };
            if line.match_indices(word).any(|(at, _)| whole(at)) {
                found.push((k + 1, word));
            }
        }
    }
    found
}

/// Line number and name for every name that follows `root` (`crate::`), groups in braces included.
pub(crate) fn names_after(code: &str, root: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices(root) {
        let before = code[..at].chars().next_back();
        if before.is_some_and(|c| is_word(c) || c == ':') {
            continue;
        }
        let line = code[..at].matches('\n').count() + 1;
        let rest = code[at + root.len()..].trim_start();
        let names = match rest.strip_prefix('{') {
            Some(group) => first_names(group),
            None => vec![first_name(rest)],
        };
        found.extend(names.into_iter().map(|name| (line, name)));
    }
    found
}

fn first_name(path: &str) -> String {
    path.chars().take_while(|c| is_word(*c)).collect()
}

/// The first name of each path of a group, whose opening brace has been read.
fn first_names(group: &str) -> Vec<String> {
    let (mut names, mut depth, mut start) = (Vec::new(), 1, 0);
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 || depth == 1 && c == ',' {
            names.push(first_name(group[start..at].trim_start()));
            start = at + 1;
        }
        if depth == 0 {
            break;
        }
    }
    names
}

#[test]
fn comments_and_strings_are_no_code() {
    let text = r##"a // b
"c \" d" e /* f /* g */ h
*/ i 'j' '\'' &'k l r#"m " n"# r"o" br"p" for_r"##;
    let code = code_only(text);
    let words: Vec<&str> = code.split_whitespace().collect();
    assert_eq!(words, ["a", "e", "i", "&'k", "l", "b", "for_r"]);
    assert_eq!(code.lines().count(), text.lines().count());
}

#[test]
fn words_are_found_whole() {
    assert_eq!(find("x\nprintln!()", &["println!"]), [(2, "println!")]);
    assert!(find("eprintln!(); f64::expect", &["println!", "f64::exp"]).is_empty());
}

#[test]
fn names_are_found_in_groups() {
    let code = "use crate::a::b;\nuse crate::{\n    c::{d, e},\n    f,\n};\nmycrate::g; crate::h()";
    let names = names_after(code, "crate::");
    let expected = [(1, "a"), (2, "c"), (2, "f"), (2, ""), (6, "h")];
    assert_eq!(names, expected.map(|(line, name)| (line, name.to_owned())));
}

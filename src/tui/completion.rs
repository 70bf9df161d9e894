//! What a half-typed line at the prompt could go on with: words of the screen besides those of the
//! language.

use super::app::words::{self, WORDS};
use crate::language::complete::{self, Completion};
use crate::language::{COMMANDS, Known};

/// Completes the end of a line, given up to the cursor.
pub fn complete(line: &str, known: &Known) -> Completion {
    let verb = line.split_whitespace().next().unwrap_or_default();
    let is_over = line.trim_start().len() > verb.len();
    if is_over && let Some((word, _)) = words::find(line.trim_start()) {
        let start = line.len() - line.trim_start()[verb.len()..].trim_start().len();
        let candidates = beginning(&line[start..], (word.values)().into_iter());
        return Completion { start, candidates };
    }
    let mut completion = complete::complete(line, known);
    if !is_over || words::asks_for_help(verb) {
        let typed = &line[completion.start..];
        let names = WORDS.iter().map(|word| word.name);
        let is_second = line[..completion.start].split_whitespace().count() == 1;
        if !is_over || is_second {
            completion.candidates.extend(beginning(typed, names));
        }
    }
    completion
}

/// Those that begin like this.
fn beginning<'a>(typed: &str, names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let typed = typed.to_lowercase();
    let fits = names.filter(|name| name.to_lowercase().starts_with(&typed));
    fits.map(str::to_owned).collect()
}

/// Usage of the command or word being typed.
pub fn usage(text: &str) -> &'static str {
    let Some(verb) = text.split_whitespace().next() else {
        return "";
    };
    let verb = verb.to_lowercase();
    let commands = COMMANDS.iter().map(|card| (card.name, card.usage));
    let words = WORDS.iter().map(|word| (word.name, word.usage));
    let all = commands.chain(words);
    let mut fitting = all.filter(|(name, _)| name.starts_with(&verb));
    let usage = match (fitting.next(), fitting.next()) {
        (Some((_, usage)), None) => usage,
        (Some((name, usage)), Some(_)) if name == verb => usage,
        _ => "",
    };
    usage.lines().next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_the_screen_are_completed_like_commands() {
        for (line, start, expected) in [
            ("lo", 0, vec!["load"]),
            ("pa", 0, vec!["particle", "pause", "pace", "pane"]),
            ("load disc-p", 5, vec!["disc-pile"]),
            ("load  graded-c", 6, vec!["graded-compression"]),
            ("pane mo", 5, vec!["mohr circle"]),
            ("pane Stress p", 5, vec!["stress path"]),
            ("pace ", 5, vec!["max"]),
            ("set kb", 4, vec!["kbps"]),
            ("help pan", 5, vec!["pane"]),
            ("he loa", 3, vec!["load"]),
            ("help solve pa", 11, vec![]),
            ("fric", 0, vec!["friction"]),
        ] {
            let completion = complete(line, &Known::default());
            assert_eq!(completion.candidates, expected, "{line}");
            assert_eq!(completion.start, start, "{line}");
        }
    }

    #[test]
    fn usages_of_both_are_shown() {
        assert_eq!(usage("pane m"), "pane NAME");
        assert_eq!(usage("savE"), "save FILE");
        assert_eq!(usage("pa"), "");
    }
}

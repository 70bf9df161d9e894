//! A command with a wrong letter is taken for a preset, which comes first on the line too.

use std::ffi::OsString;
use std::path::Path;

use clap::CommandFactory;
use clap::error::ErrorKind;

use super::Cli;
use crate::measure::columns::near;
use crate::scene::catalogue::{self, PRESETS};

/// What was meant, if the first word is near the name of a command and is nothing else.
pub(super) fn advice(
    parsed: &Result<Cli, clap::Error>,
    mut words: impl Iterator<Item = OsString>,
) -> Option<String> {
    let stumbled = match parsed {
        Ok(cli) => cli.command.is_none(),
        // A second word, or an option that only commands have.
        Err(error) => matches!(
            error.kind(),
            ErrorKind::ArgumentConflict | ErrorKind::UnknownArgument
        ),
    };
    let first = words.next()?.into_string().ok().filter(|_| stumbled)?;
    let is_preset = catalogue::find(&first).is_some() || Path::new(&first).exists();
    // No command looks like a path.
    if is_preset || first.starts_with('-') || first.contains(['.', '/']) {
        return None;
    }
    let cli = Cli::command();
    let commands: Vec<&str> = cli.get_subcommands().map(clap::Command::get_name).collect();
    if commands.contains(&first.as_str()) {
        return None;
    }
    let presets = PRESETS.iter().map(|preset| preset.name);
    let meant = near(&first, presets.chain(commands.iter().copied()))
        .filter(|name| commands.contains(name))?;
    Some(format!(
        "`{first}` is neither a command nor a preset; did you mean `ballast {meant}`?"
    ))
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::*;

    fn told(line: &str) -> Option<String> {
        let words = line.split_whitespace();
        let cli = Cli::try_parse_from(["ballast"].into_iter().chain(words.clone()));
        advice(&cli, words.map(OsString::from))
    }

    #[test]
    fn a_wrong_letter_in_a_command_is_found() {
        for (line, command) in [
            ("runn disc-pile", "run"),
            ("runn", "run"),
            ("chekc disc-pile", "check"),
            ("studdy x.toml --frac 0.1", "study"),
            ("prests", "presets"),
        ] {
            let told = told(line).unwrap_or_default();
            assert!(told.contains(&format!("`ballast {command}`")), "{told}");
        }
        for line in [
            "",
            "run disc-pile",
            "run dsc-pile",
            "disc-pile --plain",
            "disk-pile",
            "disc-pile --plian",
            "--plian",
            "completely-else.toml",
        ] {
            assert_eq!(told(line), None, "{line}");
        }
    }
}

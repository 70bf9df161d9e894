//! `--isa`, and the variable that says the same for whoever cannot add an option.

use super::{Cli, Command};
use crate::engine::Isa;

const VARIABLE: &str = "BALLAST_ISA";

/// Chooses the instructions that cycles are computed with; or says what is wrong with the variable.
/// What computes nothing need not care.
pub(super) fn choose(cli: &Cli) -> Result<(), String> {
    let set = std::env::var(VARIABLE).unwrap_or_default();
    let isa = match (cli.isa, set.as_str()) {
        (Some(isa), _) => Some(isa),
        (None, "") => None,
        (None, _) if !computes(cli.command.as_ref()) => None,
        (None, name) => {
            let known = name.parse::<Isa>();
            Some(known.map_err(|why| {
                format!("{VARIABLE}: {why}; unset it, or say --isa, which comes first")
            })?)
        }
    };
    if let Some(isa) = isa {
        isa.choose();
    }
    Ok(())
}

fn computes(command: Option<&Command>) -> bool {
    !matches!(
        command,
        Some(
            Command::Presets
                | Command::Show { .. }
                | Command::Laws
                | Command::Columns
                | Command::Commands { .. }
                | Command::Keys
                | Command::Completions { .. }
                | Command::Man
        )
    )
}

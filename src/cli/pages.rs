//! Completions and the manual page, from the definition of the command line.

use clap::Command;

use super::output;

/// Completions for a shell.
pub(super) fn completions(shell: clap_complete::Shell, command: &mut Command) -> u8 {
    let mut text = Vec::new();
    clap_complete::generate(shell, command, "ballast", &mut text);
    output::print(&String::from_utf8_lossy(&text))
}

/// The manual page in roff.
pub(super) fn man(command: Command) -> u8 {
    let mut text = Vec::new();
    if let Err(error) = clap_mangen::Man::new(command).render(&mut text) {
        output::complain(&format!("the manual page cannot be made: {error}"));
        return super::FAILED;
    }
    output::print(&String::from_utf8_lossy(&text))
}

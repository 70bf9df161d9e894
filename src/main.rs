//! The `ballast` program: everything it does is in the library.

use std::process::ExitCode;

/// Nothing but speed depends on it, so libraries need not have it.
#[global_allocator]
static ALLOCATOR: ballast::cli::LargePages = ballast::cli::LargePages;

fn main() -> ExitCode {
    ballast::cli::main()
}

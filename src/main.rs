//! The `ballast` program: everything it does is in the library.

use std::process::ExitCode;

#[global_allocator]
static ALLOCATOR: ballast::cli::LargePages = ballast::cli::LargePages;

fn main() -> ExitCode {
    ballast::cli::main()
}

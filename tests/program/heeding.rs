//! The real program, for tests that send it signals.

use std::process::{Command, Stdio};

/// The program, which heeds signals even where these tests were started to ignore them: shells do that
/// to what they run in the background, and `nohup` does, and the program leaves ignored what was.
pub(crate) fn heeding_signals() -> Command {
    let program = env!("CARGO_BIN_EXE_ballast");
    let heeding = || {
        let mut command = Command::new("env");
        command.arg("--default-signal=HUP,INT,QUIT,TERM");
        command
    };
    // Not every system's `env` can do that.
    let mut trial = heeding();
    let trial = trial.arg("true").stderr(Stdio::null()).status();
    if trial.is_ok_and(|status| status.success()) {
        // By a shell, as `env` takes a path with an equals sign in it for a variable.
        let mut command = heeding();
        command.args(["sh", "-c", "exec \"$0\" \"$@\"", program]);
        command
    } else {
        Command::new(program)
    }
}

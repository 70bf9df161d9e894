//! For tests that need a process of their own: signals and limits hold for a whole process.

use std::env;
use std::process::{Command, Output};

const VARIABLE: &str = "BALLAST_TEST_OWN_PROCESS";

/// Runs the test `name` (`module::tests::name` below `record`) alone in a new process, after the
/// shell has done `preparation`.
pub(super) fn run(name: &str, preparation: &str, value: &str) -> Output {
    Command::new("sh")
        .args(["-c", &format!("{preparation} exec \"$0\" \"$@\"")])
        .arg(env::current_exe().unwrap())
        .args(["--exact", &format!("record::{name}")])
        .env(VARIABLE, value)
        .output()
        .unwrap()
}

/// The value handed to the new process; nothing in the one that starts it.
pub(super) fn value() -> Option<String> {
    env::var(VARIABLE).ok()
}

/// Asserts that the test ran there and passed: a name that fits no test would succeed too.
#[track_caller]
pub(super) fn assert_passed(output: &Output) {
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success() && said.contains("1 passed"),
        "{said}"
    );
}

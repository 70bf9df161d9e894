//! What people do to a session.

use std::fs;
use std::path::Path;

use ballast::session::{Budget, Progress, Request, RunError, Session};
use proptest::prelude::*;

use super::scene::{open, with_stages};

/// One thing somebody does.
#[derive(Debug, Clone)]
pub(crate) enum Act {
    /// So many cycles pass in one batch; `free`: also when the stages are done.
    Pass { cycles: u64, free: bool },
    /// A line is typed; `{tmp}` is a folder. `stay`: cycles that it asks for do not run at once.
    Line { text: String, stay: bool },
    /// The state is kept, as a workbench does from time to time.
    Keep,
}

pub(crate) fn number(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (0..=1000u32).prop_map(move |k| low + (high - low) * f64::from(k) / 1000.0)
}

pub(crate) fn line() -> impl Strategy<Value = String> {
    let fixed = [
        "zero",
        "reference",
        "rotation off",
        "rotation on",
        "gravity none",
        "gravity 0 -9.81",
        "particle 1 fix x",
        "particle 2 free",
        "particle 3 fix x y spin",
        "particle 4 velocity 0 0.1",
        "delete 3",
        "delete 1-9",
        "particle 2 velocity 0 -300",
        "particle 3 velocity 3 -9",
        "frac 4",
        "create at 5 0 radius 0.5",
        "delete 4-9",
        "create at 9 1 radius 0.5",
        "create at 0.5 9 radius 0.7 material n",
        "wall lid from -3 5 to 3 5",
        "wall lid velocity 0 -0.1",
        "wall lid delete",
        "history every 5",
        "grow 1.02 over 40",
        "grow 0.99",
        "grow off",
        "history every 1",
        "history columns fracc,unbalanced,state_hash,particle:1:spin",
        "print averages",
        "print balls",
        "print energy",
        "inspect contact 1-2",
        "export csv {tmp}/out.csv",
        "journal {tmp}/out.journal",
        "nonsense",
        "friction",
    ];
    let often = [
        "save {tmp}/a",
        "save {tmp}/b",
        "restore {tmp}/a",
        "restore {tmp}/b",
        "restore {tmp}/kept",
        "source {tmp}/lines",
        "source {tmp}/loop",
        "pause",
        "go",
    ];
    prop_oneof![
        7 => proptest::sample::select(often.to_vec()).prop_map(str::to_owned),
        5 => proptest::sample::select(fixed.to_vec()).prop_map(str::to_owned),
        1 => number(0.0, 1.0).prop_map(|x| format!("friction {x:?}")),
        1 => number(0.0, 1.0).prop_map(|x| format!("friction {x:?} wall floor")),
        1 => number(0.0, 1.0).prop_map(|x| format!("friction {x:?} pair m n")),
        1 => number(500.0, 4000.0).prop_map(|x| format!("property m density {x:?}")),
        1 => number(1e5, 2e6).prop_map(|x| format!("property n normal_stiffness {x:?}")),
        1 => number(0.01, 0.2).prop_map(|x| format!("frac {x:?}")),
        1 => number(0.0, 0.5).prop_map(|x| format!("damp contact {x:?}")),
        1 => number(0.9, 1.0).prop_map(|x| format!("con1 {x:?}")),
        1 => number(-1.0, 1.0).prop_map(|x| format!("particle 2 velocity {x:?} 0")),
        1 => number(-3.0, 3.0).prop_map(|x| format!("particle 3 force {x:?} 1")),
        1 => number(-0.5, 0.5).prop_map(|x| format!("wall floor velocity {x:?} 0.01")),
        2 => (1..40u64).prop_map(|n| format!("cycle {n}")),
        1 => (1..9u64).prop_map(|n| format!("step {n}")),
        1 => (1..40u64).prop_map(|n| format!("solve ratio 0.5 max {n}")),
        1 => (1..40u64).prop_map(|n| format!("solve until kinetic < 1 max {n}")),
    ]
}

pub(crate) fn act() -> impl Strategy<Value = Act> {
    prop_oneof![
        6 => (0..35u64, any::<bool>()).prop_map(|(cycles, free)| Act::Pass { cycles, free }),
        10 => (line(), proptest::bool::weighted(0.2))
            .prop_map(|(text, stay)| Act::Line { text, stay }),
        1 => Just(Act::Keep),
    ]
}

pub(crate) fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let inner = path.join("inner");
    fs::write(&inner, "friction 0.7\ncycle 3\n").unwrap();
    let lines = format!(
        "# sourced\nfriction 0.6\ncycle 4\nsource {}\ndelete 2\nprint step\nzero\n",
        inner.display()
    );
    fs::write(path.join("lines"), lines).unwrap();
    // In one go, so that the clock keeps no state on the way.
    fs::write(path.join("wild"), "cycle 40\nfrac 4\ncycle 30\n").unwrap();
    // Restores what it saved on the way: must not begin again from there.
    let save = path.join("c").display().to_string();
    let back = format!("save {save}\ncycle 5\nrestore {save}\ncycle 2\npause\nfriction 0.1\n");
    fs::write(path.join("loop"), back).unwrap();
    folder
}

/// Does what is asked; lines that are refused must have changed nothing. An error ends a run, not the
/// session: people go on.
pub(crate) fn perform(session: &mut Session, act: &Act, folder: &Path) {
    let done = match act {
        Act::Pass { cycles, free } => {
            let until_cycle = Some(session.world().cycle_number() + cycles);
            let budget = Budget {
                until_cycle,
                ..Budget::default()
            };
            session.advance(budget, *free)
        }
        Act::Line { text, stay } => {
            let before = session.world().state_hash();
            let line = text.replace("{tmp}", &folder.display().to_string());
            match session.type_line(&line) {
                Ok(reply) if reply.request == Some(Request::Run) && !stay => {
                    session.advance(Budget::default(), false)
                }
                Ok(_) => Ok(Progress::Budget),
                Err(refusal) => {
                    let after = session.world().state_hash();
                    assert_eq!(before, after, "{line}: {refusal}");
                    Ok(Progress::Budget)
                }
            }
        }
        Act::Keep if session.world().is_broken() => Ok(Progress::Budget),
        Act::Keep => session
            .save(&folder.join("kept"))
            .map(|()| Progress::Budget),
    };
    match done {
        Ok(_) | Err(RunError::Fault(_) | RunError::Stage { .. }) => {}
        Err(other) => panic!("{act:?}: {other}"),
    }
}

/// What is typed in a run of these stages, `{tmp}` being a folder. Cycles run at once.
pub(crate) fn typed(stages: &[&str], lines: &[&str], folder: &Path) -> Session {
    let mut session = open(&with_stages(stages, false));
    for line in lines {
        let text = (*line).to_owned();
        perform(&mut session, &Act::Line { text, stay: false }, folder);
    }
    session
}

pub(crate) fn run(session: &mut Session, line: &str) {
    session.type_line(line).unwrap();
    session.advance(Budget::default(), false).unwrap();
}

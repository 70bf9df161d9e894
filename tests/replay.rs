//! A journal replays, and a checkpoint goes on, to the same bits: random sessions with commands at
//! any cycle, at the ends of stages too.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

use std::fs;
use std::path::Path;

use ballast::record::history::History;
use ballast::record::journal::Journal;
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Progress, Replay, Request, RunError, Session};
use proptest::prelude::*;

/// Discs that fall on a floor: stages with commands that run, a stage without cycles, one that ends
/// by a column, and rows that do not fit the lengths of the stages.
const SCENE: &str = r#"
[model]
body = "disc"
gravity = [0.0, -9.81]
[damping]
contact = 0.1
[material.m]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 8e5
friction = 0.4
[material.n]
density = 2000.0
normal_stiffness = 2e6
shear_stiffness = 1e6
friction = 0.2
[[particle]]
at = [0.0, 0.999]
radius = 1.0
material = "m"
velocity = [0.3, -1.0]
[[particle]]
at = [1.99, 1.0]
radius = 1.0
material = "n"
[[particle]]
at = [1.0, 2.73]
radius = 1.0
material = "m"
spin = 3.0
[[wall]]
name = "floor"
material = "m"
from = [-50.0, 0.0]
to = [50.0, 0.0]
[history]
every = 7
columns = ["fracc", "energy_error", "kinetic", "contact:1-2:delta", "wall:floor:f2", "state_hash"]
[[stage]]
name = "fall"
do = ["cycle 11", "friction 0.3"]
max_cycles = 30
[[stage]]
name = "instant"
do = ["wall floor velocity 0.1 0", "damp global 0.5"]
until = "cycle >= 0"
[[stage]]
name = "rest"
do = ["particle 1 fix spin"]
until = "kinetic < 1e-3"
max_cycles = 40
[[stage]]
name = "last"
do = ["solve ratio 10 max 5", "zero"]
until = "stage_cycle >= 9"
"#;

/// One thing somebody does.
#[derive(Debug, Clone)]
enum Act {
    /// So many cycles pass in one batch; `free`: also when the stages are done.
    Pass { cycles: u64, free: bool },
    /// A line is typed; `{tmp}` is a folder.
    Line(String),
}

fn number(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (0..=1000u32).prop_map(move |k| low + (high - low) * f64::from(k) / 1000.0)
}

fn line() -> impl Strategy<Value = String> {
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
        "create at 9 1 radius 0.5",
        "create at 0.5 9 radius 0.7 material n",
        "wall lid from -3 5 to 3 5",
        "wall lid velocity 0 -0.1",
        "wall lid delete",
        "history every 5",
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

fn act() -> impl Strategy<Value = Act> {
    prop_oneof![
        2 => (0..35u64, any::<bool>()).prop_map(|(cycles, free)| Act::Pass { cycles, free }),
        3 => line().prop_map(Act::Line),
    ]
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let inner = path.join("inner");
    fs::write(&inner, "friction 0.7\ncycle 3\n").unwrap();
    let lines = format!(
        "# sourced\nfriction 0.6\ncycle 4\nsource {}\ndelete 2\nprint step\nzero\n",
        inner.display()
    );
    fs::write(path.join("lines"), lines).unwrap();
    // Restores what it saved on the way: must not begin again from there.
    let save = path.join("c").display().to_string();
    let back = format!("save {save}\ncycle 5\nrestore {save}\ncycle 2\npause\nfriction 0.1\n");
    fs::write(path.join("loop"), back).unwrap();
    folder
}

/// With so many of its stages: a run may end with one that has no cycles, or have none at all.
fn open(stages: usize) -> Session {
    let parts: Vec<&str> = SCENE.split("[[stage]]").take(stages + 1).collect();
    let scene = Scene::parse("random", &parts.join("[[stage]]"), &[]).unwrap();
    Session::open(scene, Options::default()).unwrap()
}

/// What is asked, done; lines that are refused must have changed nothing.
fn perform(session: &mut Session, act: &Act, folder: &Path) -> Result<(), RunError> {
    match act {
        Act::Pass { cycles, free } => {
            let until_cycle = Some(session.world().cycle_number() + cycles);
            let budget = Budget {
                until_cycle,
                ..Budget::default()
            };
            session.advance(budget, *free).map(drop)
        }
        Act::Line(line) => {
            let before = session.world().state_hash();
            let line = line.replace("{tmp}", &folder.display().to_string());
            match session.type_line(&line) {
                Ok(reply) if reply.request == Some(Request::Run) => {
                    session.advance(Budget::default(), false).map(drop)
                }
                Ok(_) => Ok(()),
                Err(refusal) => {
                    let after = session.world().state_hash();
                    assert_eq!(before, after, "{line}: {refusal}");
                    Ok(())
                }
            }
        }
    }
}

/// Everything that is done, and how it ended.
fn play(session: &mut Session, acts: &[Act], folder: &Path) -> Option<String> {
    let done = acts
        .iter()
        .try_for_each(|act| perform(session, act, folder))
        .and_then(|()| session.finish());
    done.err().map(|error| error.to_string())
}

fn csv(session: &Session, folder: &Path) -> String {
    let path = folder.join("compare.csv");
    session.export_csv(&path).unwrap();
    fs::read_to_string(path).unwrap()
}

fn replayed(journal: &Journal, batch: u64) -> (Session, Option<String>) {
    let scene = Scene::parse(
        &journal.preset_name,
        &journal.preset_text,
        &journal.overrides,
    );
    let scene = scene.unwrap();
    let mut replay = Replay::new(journal, &scene);
    let mut session = Session::open(scene, Options::default()).unwrap();
    loop {
        let until_cycle = Some(session.world().cycle_number() + batch);
        let budget = Budget {
            until_cycle,
            ..Budget::default()
        };
        match session.advance_replay(&mut replay, budget) {
            Ok(Progress::Finished) => break,
            Ok(Progress::Budget | Progress::ErrandDone) => {}
            Err(error) => return (session, Some(error.to_string())),
        }
    }
    let end = session.finish().err().map(|error| error.to_string());
    (session, end)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, ..Default::default() })]

    #[test]
    fn a_journal_replays_to_the_same_bits(
        stages in 0..=4usize,
        acts in proptest::collection::vec(act(), 0..20),
        batch in 1..50u64,
        written in any::<bool>(),
    ) {
        let folder = folder();
        let mut session = open(stages);
        let file = folder.path().join("live.csv");
        if written {
            let names = session.recording().names();
            session.write_history(History::create(&file, &names).unwrap());
        }
        let end = play(&mut session, &acts, folder.path());
        let text = session.journal().to_string();
        // A replay needs nothing that the run has written.
        for name in ["a", "b", "c"] {
            drop(fs::remove_file(folder.path().join(name)));
        }
        let (again, end_again) = replayed(&Journal::parse(&text).unwrap(), batch);
        prop_assert_eq!(&end, &end_again, "{}", text);
        let (rows, rows_again) = (csv(&session, folder.path()), csv(&again, folder.path()));
        prop_assert_eq!(&rows, &rows_again, "{}", text);
        prop_assert_eq!(session.world().state_hash(), again.world().state_hash(), "{}", text);
        if end.is_none() {
            prop_assert_eq!(&session.journal().events, &again.journal().events);
        }
        if written {
            session.flush().unwrap();
            prop_assert_eq!(fs::read_to_string(&file).unwrap(), rows, "{}", text);
        }
    }

    #[test]
    fn a_resumed_session_goes_on_to_the_same_bits(
        stages in 0..=4usize,
        acts in proptest::collection::vec(act(), 0..20),
        at in 0.0..1.0f64,
    ) {
        let at = (acts.len() as f64 * at) as usize;
        // One that is never saved, one that is, and one that goes on from there.
        let (untouched, first, second) = (folder(), folder(), folder());
        let mut plain = open(stages);
        let plain_end = play(&mut plain, &acts, untouched.path());

        let mut session = open(stages);
        let early = acts[..at]
            .iter()
            .try_for_each(|act| perform(&mut session, act, first.path()));
        prop_assume!(early.is_ok());
        let checkpoint = first.path().join("checkpoint");
        let before = session.world().state_hash();
        session.save(&checkpoint).unwrap();
        prop_assert_eq!(before, session.world().state_hash());
        for name in ["a", "b", "c"] {
            let from = first.path().join(name);
            if from.exists() {
                fs::copy(&from, second.path().join(name)).unwrap();
            }
        }
        let end = play(&mut session, &acts[at..], first.path());
        let mut other = Session::resume(&checkpoint, 2).unwrap();
        prop_assert_eq!(before, other.world().state_hash());
        let other_end = play(&mut other, &acts[at..], second.path());

        prop_assert_eq!(&plain_end, &end);
        prop_assert_eq!(&plain_end, &other_end);
        let rows = csv(&plain, untouched.path());
        prop_assert_eq!(&rows, &csv(&session, first.path()));
        prop_assert_eq!(&rows, &csv(&other, second.path()));
        let hash = plain.world().state_hash();
        prop_assert_eq!(hash, session.world().state_hash());
        prop_assert_eq!(hash, other.world().state_hash());
        prop_assert_eq!(plain.world().bookings(), other.world().bookings());
        prop_assert_eq!(plain.world().fracc_monitor(), other.world().fracc_monitor());
    }
}

/// A command typed at the cycle where the last stages end counts after their own commands.
#[test]
fn commands_after_stages_without_cycles_keep_their_place() {
    let mut session = open(2);
    let reached = session.advance(Budget::default(), false).unwrap();
    assert_eq!(reached, Progress::Finished);
    session.type_line("wall floor velocity -0.2 0").unwrap();
    session.type_line("cycle 10").unwrap();
    session.advance(Budget::default(), false).unwrap();
    session.finish().unwrap();
    let (again, end) = replayed(session.journal(), 1000);
    assert_eq!(end, None);
    assert_eq!(again.world().walls()[0].velocity, [-0.2, 0.0]);
    assert_eq!(again.recording(), session.recording());
}

/// A run that was killed goes on with what it was last told.
#[test]
fn the_last_command_of_a_killed_run_still_holds() {
    let mut session = open(4);
    session.type_line("cycle 300").unwrap();
    session.advance(Budget::default(), false).unwrap();
    let (again, _) = replayed(session.journal(), 1000);
    assert_eq!(again.world().cycle_number(), 300);
    assert_eq!(again.world().state_hash(), session.world().state_hash());
}

fn run(session: &mut Session, line: &str) {
    session.type_line(line).unwrap();
    session.advance(Budget::default(), false).unwrap();
}

/// What follows a restored state is what followed it the first time, row by row.
#[test]
fn a_restored_state_repeats_itself() {
    let folder = folder();
    let save = format!("{}/a", folder.path().display());
    let mut session = open(4);
    let file = folder.path().join("live.csv");
    let names = session.recording().names();
    session.write_history(History::create(&file, &names).unwrap());
    run(&mut session, "cycle 13");
    session.type_line(&format!("save {save}")).unwrap();
    run(&mut session, "cycle 50");
    let (hash, rows) = (session.world().state_hash(), session.recording().clone());
    session.type_line("friction 0.9").unwrap();
    session.type_line(&format!("restore {save}")).unwrap();
    assert_eq!(session.world().cycle_number(), 13);
    run(&mut session, "cycle 50");
    assert_eq!(session.world().state_hash(), hash);
    assert_eq!(*session.recording(), rows);
    session.flush().unwrap();
    let written = fs::read_to_string(&file).unwrap();
    assert_eq!(written, csv(&session, folder.path()));
}

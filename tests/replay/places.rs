//! Places where the order of things is easily got wrong.

use std::fs;

use ballast::record::history::History;
use ballast::session::{Budget, Progress};

use super::acts::{folder, run};
use super::repetition::{assert_replays, csv, replayed};
use super::scene::{STAGES, open, with_stages};

/// A command typed at the cycle where the last stages end counts after their own commands.
#[test]
fn commands_after_stages_without_cycles_keep_their_place() {
    let mut session = open(&with_stages(&STAGES[..2], false));
    let reached = session.advance(Budget::default(), false).unwrap();
    assert_eq!(reached, Progress::Finished);
    session.type_line("wall floor velocity -0.2 0").unwrap();
    session.type_line("cycle 10").unwrap();
    session.advance(Budget::default(), false).unwrap();
    session.finish().unwrap();
    let (again, end) = replayed(session.journal(), 1000, None);
    assert_eq!(end, None);
    assert_eq!(again.world().walls()[0].velocity, [-0.2, 0.0]);
    assert_eq!(again.recording(), session.recording());
}

/// A run that was killed goes on with what it was last told.
#[test]
fn the_last_command_of_a_killed_run_still_holds() {
    let mut session = open(&with_stages(&STAGES[..4], false));
    session.type_line("cycle 300").unwrap();
    session.advance(Budget::default(), false).unwrap();
    let (again, _) = replayed(session.journal(), 1000, None);
    assert_eq!(again.world().cycle_number(), 300);
    assert_eq!(again.world().state_hash(), session.world().state_hash());
}

/// What follows a restored state is what followed it the first time, row by row.
#[test]
fn a_restored_state_repeats_itself() {
    let folder = folder();
    let save = format!("{}/a", folder.path().display());
    let mut session = open(&with_stages(&STAGES[..4], false));
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

/// A stage that ends with the cycles of its last command ends before what is typed then.
#[test]
fn a_command_typed_where_the_cycles_of_a_stage_end_comes_after_its_row() {
    let folder = folder();
    let mut session = open(&with_stages(&STAGES[4..5], false));
    let reached = session.advance(Budget::default(), false).unwrap();
    assert_eq!(reached, Progress::Finished);
    session.type_line("particle 2 velocity 5 0").unwrap();
    session.finish().unwrap();
    assert_eq!(session.recording().rows().last().unwrap().cycle, 11);
    assert_replays(&session, folder.path());
}

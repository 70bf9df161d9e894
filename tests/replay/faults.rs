//! What could not go on, and what was done about it, is repeated like anything else.

use std::fs;

use ballast::record::journal::Journal;
use ballast::session::{Budget, Replay, RunError, Session};

use super::acts::{Act, folder, perform, run, typed};
use super::repetition::{assert_replays, last_words, replayed, scene_of};
use super::scene::{STAGES, open, with_stages};

/// A disc that is driven into the floor after all stages: nothing but the fault tells how far the run
/// went.
#[test]
fn a_fault_beyond_the_stages_is_met_again() {
    let folder = folder();
    let folder = folder.path();
    let mut session = typed(
        &STAGES[..2],
        &[
            "source {tmp}/lines",
            "solve until kinetic < 0 max 28",
            "cycle 34",
        ],
        folder,
    );
    let pass = |session: &mut Session, cycles| {
        let free = true;
        perform(session, &Act::Pass { cycles, free }, folder);
    };
    pass(&mut session, 28);
    session.type_line("particle 3 fix x y spin").unwrap();
    pass(&mut session, 20);
    assert!(session.world().is_broken());
    assert_eq!(
        last_words(&session, 1),
        [
            "@117 fault cycle 117: the centre of particle 3 went through wall floor; reduce frac, \
             the speed, or stiffen the contact"
        ]
    );
    assert_replays(&session, folder);
    // Whoever tries again is told again, and nothing moves.
    let (hash, events) = (session.world().state_hash(), session.journal().events.len());
    pass(&mut session, 20);
    assert_eq!(hash, session.world().state_hash());
    assert_eq!(events, session.journal().events.len());
    session.finish().unwrap();
    assert_eq!(session.recording().rows().last().unwrap().cycle, 112);
    assert_replays(&session, folder);
}

/// After a fault people go back to the state that was kept for them, and on from there.
#[test]
fn what_is_done_after_a_fault_is_done_again() {
    let folder = folder();
    let folder = folder.path();
    let kept = folder.join("kept");
    let mut session = typed(&STAGES[..4], &["source {tmp}/wild"], folder);
    assert!(session.world().is_broken());
    for line in ["friction 0.2", "cycle 3", "go", "save x"] {
        let refusal = session.type_line(line).unwrap_err().to_string();
        assert!(refusal.contains("restore an earlier state"), "{refusal}");
    }
    let way = session.way_back(&kept).unwrap().unwrap();
    let command = way.split('`').nth(1).unwrap();
    assert!(way.starts_with("to go back to cycle 30"), "{way}");
    session.type_line(command).unwrap();
    assert!(!session.world().is_broken());
    assert_eq!(session.world().cycle_number(), 30);
    run(&mut session, "cycle 50");
    session.finish().unwrap();
    let text = session.journal().to_string();
    assert!(text.contains(" fault cycle 4"), "{text}");
    assert!(text.contains(" back 30 4 "), "{text}");
    assert_replays(&session, folder);
}

/// Stages that follow each other without a cycle are gone back to as one.
#[test]
fn a_state_between_stages_without_cycles_is_met_again() {
    let folder = folder();
    let folder = folder.path();
    let stages = [STAGES[0], STAGES[1], STAGES[6], STAGES[3]];
    let mut session = typed(&stages, &["source {tmp}/wild"], folder);
    let way = session.way_back(&folder.join("kept")).unwrap().unwrap();
    assert!(way.starts_with("to go back to cycle 30"), "{way}");
    session.type_line(way.split('`').nth(1).unwrap()).unwrap();
    session.finish().unwrap();
    assert_replays(&session, folder);
}

/// What a command of a stage is refused for, somebody may put right and go on.
#[test]
fn a_refused_stage_goes_on_when_told() {
    let folder = folder();
    let stage =
        "name = \"more\"\ndo = [\"friction 0.6\", \"create at 1 1.5 radius 0.5\", \"zero\"]";
    let mut session = open(&with_stages(&[stage, STAGES[4]], false));
    let error = session.advance(Budget::default(), false).unwrap_err();
    assert!(matches!(error, RunError::Stage { .. }), "{error}");
    assert_replays(&session, folder.path());
    session.type_line("friction 0.2").unwrap();
    session.advance(Budget::default(), false).unwrap();
    session.finish().unwrap();
    let words = last_words(&session, 5);
    assert_eq!(words[0], "@0 friction 0.2", "{words:?}");
    assert_eq!(words[1], "@0 : zero", "{words:?}");
    assert_replays(&session, folder.path());
}

/// The state of another run is no state of this one: its file is needed.
#[test]
fn a_state_of_another_run_stays_in_its_file() {
    let folder = folder();
    let folder = folder.path();
    let lines = ["cycle 13", "friction 0.9", "cycle 2", "save {tmp}/a"];
    typed(&STAGES[..4], &lines, folder);
    let mut session = typed(&STAGES[..4], &["cycle 5", "restore {tmp}/a"], folder);
    session.finish().unwrap();
    let [restore, end]: [String; 2] = last_words(&session, 2).try_into().unwrap();
    assert!(restore.starts_with("@5 restore "), "{restore}");
    assert_eq!(end, "@15 end");
    let journal = session.journal().clone();
    let (again, end) = replayed(&journal, 1000, None);
    assert_eq!(end, None);
    assert_eq!(again.world().state_hash(), session.world().state_hash());
    fs::remove_file(folder.join("a")).unwrap();
    let (_, end) = replayed(&journal, 1000, None);
    assert!(end.unwrap().contains("there is no such file"));
}

/// Journals that people have changed are refused where they make no sense.
#[test]
fn events_in_the_wrong_place_are_refused_beforehand() {
    let journal = typed(&STAGES[..1], &["cycle 20"], folder().path())
        .journal()
        .to_string();
    for (lines, hint) in [
        ("@20 friction 0.3\n@19 friction 0.4\n", "@19"),
        ("@20 back 30 1 a\n", "the run was never there"),
        ("@20 back 10 99 a\n", "the run was never there"),
        ("@20 back 10 0 a\n", "the run was never there"),
        ("@20 nonsense\n", "nonsense"),
    ] {
        let journal = Journal::parse(&format!("{journal}{lines}")).unwrap();
        let replay = Replay::new(&journal, &scene_of(&journal));
        let error = replay.check().unwrap_err().to_string();
        let hint = hint.strip_prefix('@').unwrap_or(hint);
        assert!(error.contains(hint), "{lines}: {error}");
    }
    let good = format!("{journal}@20 friction 0.3\n@20 back 10 3 a\n@12 zero\n");
    let good = Journal::parse(&good).unwrap();
    Replay::new(&good, &scene_of(&good)).check().unwrap();
}

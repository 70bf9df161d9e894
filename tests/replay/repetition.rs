//! Replays, and what is compared.

use std::fs;
use std::path::Path;

use ballast::record::journal::{EventKind, Journal};
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Progress, Replay, Session};

/// Why the run could not go on in the end, as its journal tells.
pub(crate) fn trouble(session: &Session) -> Option<String> {
    let mut events = session.journal().events.iter().rev();
    let mut last = events.next()?;
    if last.kind == EventKind::End {
        last = events.next().filter(|event| event.cycle == last.cycle)?;
    }
    match &last.kind {
        EventKind::Fault(why) => Some(why.clone()),
        _ => {
            let fault = session.world().fault();
            fault
                .filter(|_| session.world().is_broken())
                .map(ToString::to_string)
        }
    }
}

pub(crate) fn csv(session: &Session, folder: &Path) -> String {
    let path = folder.join("compare.csv");
    session.export_csv(&path).unwrap();
    fs::read_to_string(path).unwrap()
}

/// The scene that a journal was made in.
pub(crate) fn scene_of(journal: &Journal) -> Scene {
    let Journal {
        preset_name,
        preset_text,
        overrides,
        ..
    } = journal;
    Scene::parse(preset_name, preset_text, overrides).unwrap()
}

/// Replays in batches of so many cycles. `cut`: saved after so many batches, and resumed.
pub(crate) fn replayed(
    journal: &Journal,
    batch: u64,
    cut: Option<usize>,
) -> (Session, Option<String>) {
    let scene = scene_of(journal);
    let mut replay = Replay::new(journal, &scene);
    replay.check().unwrap();
    let mut session = Session::open(scene, Options::default()).unwrap();
    let mut end = None;
    for batches in 0.. {
        if cut == Some(batches) {
            let file = tempfile::NamedTempFile::new().unwrap();
            session.save(file.path()).unwrap();
            let resumed = Session::resume(file.path(), 1).unwrap();
            let rest = Replay::rest(journal, &resumed).expect("it is how the journal begins");
            let here = resumed.world().cycle_number();
            if rest.goes_back_before(here).is_none() {
                (session, replay) = (resumed, rest);
            }
        }
        let until_cycle = Some(session.world().cycle_number() + batch);
        let budget = Budget {
            until_cycle,
            ..Budget::default()
        };
        match session.advance_replay(&mut replay, budget) {
            Ok(Progress::Finished) => break,
            Ok(Progress::Budget | Progress::ErrandDone) => {}
            Err(error) => {
                end = Some(error.to_string());
                break;
            }
        }
    }
    if journal.is_complete() {
        session.finish().unwrap();
    }
    (session, end)
}

/// The words of the journal's last lines.
pub(crate) fn last_words(session: &Session, count: usize) -> Vec<String> {
    let events = &session.journal().events;
    let last = events[events.len() - count..].iter();
    last.map(ToString::to_string).collect()
}

/// Replays it without the files it wrote: everything is the same, faults too.
#[track_caller]
pub(crate) fn assert_replays(session: &Session, folder: &Path) {
    for name in ["a", "b", "c", "kept"] {
        drop(fs::remove_file(folder.join(name)));
    }
    let text = session.journal().to_string();
    for batch in [1, 1000] {
        let (again, end) = replayed(&Journal::parse(&text).unwrap(), batch, None);
        assert_eq!(trouble(session), end);
        assert_eq!(csv(session, folder), csv(&again, folder), "{text}");
        assert_eq!(session.world().state_hash(), again.world().state_hash());
        assert_eq!(session.journal().events, again.journal().events, "{text}");
    }
}

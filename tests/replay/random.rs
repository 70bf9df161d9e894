//! Random sessions, with commands at any cycle, at the ends of stages and after faults too.

use std::fs;

use ballast::engine::World;
use ballast::record::history::History;
use ballast::record::journal::Journal;
use ballast::session::Session;
use proptest::prelude::*;

use super::acts::{act, folder, perform};
use super::repetition::{csv, replayed, trouble};
use super::scene::{open, preset};

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, ..Default::default() })]

    #[test]
    fn a_journal_replays_to_the_same_bits(
        preset in preset(),
        acts in proptest::collection::vec(act(), 0..20),
        batch in 1..50u64,
        cut in proptest::option::of(0..20usize),
        written in any::<bool>(),
        killed in proptest::bool::weighted(0.2),
    ) {
        let folder = folder();
        let mut session = open(&preset);
        let file = folder.path().join("live.csv");
        if written {
            let names = session.recording().names();
            session.write_history(History::create(&file, &names).unwrap());
        }
        for act in &acts {
            perform(&mut session, act, folder.path());
            session.way_back(&folder.path().join("kept")).unwrap();
        }
        if !killed {
            session.finish().unwrap();
        }
        let text = session.journal().to_string();
        // A replay needs nothing that the run has written.
        for name in ["a", "b", "c", "kept"] {
            drop(fs::remove_file(folder.path().join(name)));
        }
        let (again, end) = replayed(&Journal::parse(&text).unwrap(), batch, cut);
        if killed {
            // How far it went is not known to the cycle.
            let (rows, rows_again) = (csv(&session, folder.path()), csv(&again, folder.path()));
            let same = rows.starts_with(&rows_again) || rows_again.starts_with(&rows);
            prop_assert!(same, "{}\n{}\n{}", text, rows, rows_again);
            return Ok(());
        }
        prop_assert_eq!(trouble(&session), end, "{}", text);
        let (rows, rows_again) = (csv(&session, folder.path()), csv(&again, folder.path()));
        prop_assert_eq!(&rows, &rows_again, "{}", text);
        prop_assert_eq!(session.world().state_hash(), again.world().state_hash(), "{}", text);
        prop_assert_eq!(&session.journal().events, &again.journal().events, "{}", text);
        if written {
            session.flush().unwrap();
            prop_assert_eq!(fs::read_to_string(&file).unwrap(), rows, "{}", text);
        }
    }

    #[test]
    fn a_resumed_session_goes_on_to_the_same_bits(
        preset in preset(),
        acts in proptest::collection::vec(act(), 0..20),
        at in 0.0..1.0f64,
    ) {
        let at = (acts.len() as f64 * at) as usize;
        // One that is never saved, one that is, and one that goes on from there.
        let (untouched, first, second) = (folder(), folder(), folder());
        let mut plain = open(&preset);
        for act in &acts {
            perform(&mut plain, act, untouched.path());
        }
        plain.finish().unwrap();

        let mut session = open(&preset);
        acts[..at].iter().for_each(|act| perform(&mut session, act, first.path()));
        let checkpoint = first.path().join("checkpoint");
        let before = session.world().state_hash();
        session.save(&checkpoint).unwrap();
        prop_assert_eq!(before, session.world().state_hash());
        for name in ["a", "b", "c", "kept"] {
            let from = first.path().join(name);
            if from.exists() {
                fs::copy(&from, second.path().join(name)).unwrap();
            }
        }
        let mut other = Session::resume(&checkpoint, 2).unwrap();
        prop_assert_eq!(before, other.world().state_hash());
        for (session, folder) in [(&mut session, &first), (&mut other, &second)] {
            acts[at..].iter().for_each(|act| perform(session, act, folder.path()));
            session.finish().unwrap();
        }

        prop_assert_eq!(trouble(&plain), trouble(&session));
        prop_assert_eq!(trouble(&plain), trouble(&other));
        let rows = csv(&plain, untouched.path());
        prop_assert_eq!(&rows, &csv(&session, first.path()));
        prop_assert_eq!(&rows, &csv(&other, second.path()));
        let hash = plain.world().state_hash();
        prop_assert_eq!(hash, session.world().state_hash());
        prop_assert_eq!(hash, other.world().state_hash());
        // As text: what is no number here is none there.
        let told = |world: &World| format!("{:?} {:?}", world.bookings(), world.fracc_monitor());
        prop_assert_eq!(told(plain.world()), told(other.world()));
    }
}

//! What a workbench says when it has given the terminal back: where the run is, how to go on with it, and
//! what could not be kept.

use crate::record::shell_word::shell_word;
use crate::session::Session;
use crate::session::saves::Saves;

/// The run failed, or its last state is lost.
const FAILED: u8 = 1;

/// How it ended.
#[derive(Debug)]
pub struct Ended {
    /// Exit status.
    pub status: u8,
    /// What to say after the terminal is given back.
    pub farewell: String,
}

impl Ended {
    /// Of a run that is saved as far as it could be. `why` it ended comes first; a last state that was
    /// lost is a failure, whatever `status` says.
    pub(super) fn of(why: &str, session: &Session, saves: &Saves, status: u8) -> Self {
        let lost = saves.fault().or(saves.unended()).is_some();
        Self {
            status: if lost { FAILED } else { status },
            farewell: [why, &text(session.world().cycle_number(), saves)].concat(),
        }
    }
}

fn text(cycle: u64, saves: &Saves) -> String {
    let mut lines = vec![format!("cycle {cycle}")];
    let Some(keep) = saves.keep() else {
        lines.extend(saves.warning());
        return lines.join("\n");
    };
    lines[0].push_str(&format!("; journal {}", keep.journal.display()));
    if let Some(fault) = saves.fault() {
        lines.push(format!("the last state could not be saved: {fault}"));
    }
    if let Some(fault) = saves.unended() {
        lines.push(format!("the journal lacks its end: {fault}"));
    }
    let command = format!("ballast {}", shell_word(&keep.checkpoint.to_string_lossy()));
    // What was saved may be gone with its folder.
    match saves.held().filter(|_| keep.checkpoint.exists()) {
        Some(held) if held == cycle => lines.push(format!("go on with: {command}")),
        Some(held) => lines.push(format!("go on from cycle {held} with: {command}")),
        None if saves.fault().is_some() => lines.push("there is no earlier one, either".into()),
        None => {}
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::scene::Scene;
    use crate::session::run_folder::Keep;
    use crate::session::{Budget, Options};

    fn session() -> Session {
        let scene = Scene::load("nine-disc-compression", &[]).unwrap();
        Session::open(scene, Options::default()).unwrap()
    }

    fn run_to(session: &mut Session, cycle: u64) {
        let budget = Budget {
            until_cycle: Some(cycle),
            time: None,
        };
        session.advance(budget, false).unwrap();
    }

    #[test]
    fn a_run_that_is_kept_says_how_to_go_on() {
        let folder = tempfile::tempdir().unwrap();
        let mut session = session();
        let keep = Keep::within(folder.path());
        let mut saves = Saves::begin_at(Ok(keep.clone()), &mut session);
        run_to(&mut session, 10);
        saves.close(&mut session);
        let ended = Ended::of("SIGTERM\n", &session, &saves, 143);
        assert_eq!(ended.status, 143);
        let expected = format!(
            "SIGTERM\ncycle 10; journal {}\ngo on with: ballast {}",
            keep.journal.display(),
            keep.checkpoint.display()
        );
        assert_eq!(ended.farewell, expected);
    }

    #[test]
    fn a_last_state_that_is_lost_is_said_with_the_one_before() {
        for earlier in [false, true] {
            let folder = tempfile::tempdir().unwrap();
            let mut session = session();
            let keep = Keep::within(folder.path());
            let mut saves = Saves::begin_at(Ok(keep.clone()), &mut session);
            if earlier {
                run_to(&mut session, 10);
                saves.close(&mut session);
            }
            run_to(&mut session, 20);
            // Neither root nor its owner can make a file where a folder is gone.
            let aside = folder.path().with_extension("aside");
            fs::rename(folder.path(), &aside).unwrap();
            saves.close(&mut session);
            fs::rename(&aside, folder.path()).unwrap();
            let ended = Ended::of("", &session, &saves, 0);
            assert_eq!(ended.status, 1);
            let said = ended.farewell;
            assert!(said.contains("the last state could not be saved"), "{said}");
            assert!(said.contains("there is no folder"), "{said}");
            let from = "go on from cycle 10 with: ballast ";
            assert_eq!(said.contains(from), earlier, "{said}");
            assert_eq!(said.contains("no earlier one"), !earlier, "{said}");
            drop(folder);
            let said = Ended::of("", &session, &saves, 0).farewell;
            assert!(said.contains("no earlier one"), "gone with all: {said}");
        }
    }

    #[test]
    fn where_nothing_is_kept_the_reason_is_said() {
        let mut session = session();
        let mut saves = Saves::begin_at(Err("there is no home".into()), &mut session);
        run_to(&mut session, 10);
        saves.close(&mut session);
        let ended = Ended::of("", &session, &saves, 0);
        assert_eq!(ended.status, 0, "it was known from the beginning");
        let expected = "cycle 10\nnothing of this run is kept: there is no home";
        assert_eq!(ended.farewell, expected);
    }

    #[test]
    fn a_folder_that_takes_no_journal_keeps_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut session = session();
        let keep = Keep::within(&folder.path().join("none"));
        let saves = Saves::begin_at(Ok(keep), &mut session);
        assert!(saves.keep().is_none());
        let warning = saves.warning().unwrap();
        assert!(warning.contains("there is no folder"), "{warning}");
    }
}

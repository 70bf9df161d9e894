//! `ballast export`: scenes for other programs.

use std::path::Path;

use super::bench::Timed;
use super::output::{complain, load, tell, unopened};
use super::placed::placed;
use super::{BAD_INPUT, FAILED, Lammps};
use crate::record::checkpoint;
use crate::session::Session;
use crate::study::bench::find;

/// Writes a deck for LAMMPS; answers the exit status.
pub(super) fn lammps(options: &Lammps) -> u8 {
    let mut session = match session(options) {
        Ok(session) => session,
        Err(status) => return status,
    };
    let deck = match session.lammps(options.nearest) {
        Ok(deck) => deck,
        Err(refusal) => {
            complain(&refusal.to_string());
            return BAD_INPUT;
        }
    };
    if let Err(error) = deck.write(&options.output) {
        complain(&error.to_string());
        return FAILED;
    }
    if !options.quiet {
        deck.notices.iter().for_each(|notice| tell(notice));
        let names: Vec<&str> = deck.files.iter().map(|(name, _)| name.as_str()).collect();
        let folder = options.output.display();
        tell(&format!("wrote {} in {folder}", names.join(", ")));
    }
    0
}

/// The run that is written, where it is written; or the exit status.
fn session(options: &Lammps) -> Result<Session, u8> {
    let threads = usize::from(options.threads);
    let path = Path::new(&options.preset);
    let failed = |error: crate::session::RunError| unopened(&error);
    if checkpoint::is_one(path) {
        let about_presets = [
            ("--at", options.at.is_some()),
            ("--set", !options.set.is_empty()),
        ];
        if let Some((option, _)) = about_presets.iter().find(|(_, given)| *given) {
            complain(&format!(
                "{option} is about presets, and {} is a checkpoint; leave it out: a checkpoint is written \
                 as it is",
                options.preset
            ));
            return Err(BAD_INPUT);
        }
        return Session::resume(path, threads).map_err(failed);
    }
    if let Some(standard) = find(&options.preset) {
        let scene = Timed::standard(standard, &options.set)?;
        return scene.session(options.at.as_ref(), threads, options.quiet);
    }
    let scene = load(&options.preset, &options.set).ok_or(BAD_INPUT)?;
    placed(scene, options.at.as_ref(), threads, options.quiet)
}

//! A run that has come to a place in its stages, for what begins there.

use super::BAD_INPUT;
use super::output::{complain, unopened};
use super::progress::Progress;
use super::sample::with_sample;
use crate::scene::Scene;
use crate::session::{Options, Place, Reached, Session};

/// The run of a scene at `place`, or where the first stage begins, its commands issued; or the exit
/// status.
pub(super) fn placed(
    scene: Scene,
    place: Option<&Place>,
    threads: usize,
    quiet: bool,
) -> Result<Session, u8> {
    let scene = with_sample(scene, threads, quiet)?;
    let how = Options {
        threads,
        expendable: true,
        ..Options::default()
    };
    let mut session = Session::open(scene, how).map_err(|error| unopened(&error))?;
    let mut progress = Progress::new(&session, None, quiet);
    let reached = session.reach(place, &mut |session| progress.show(session));
    progress.clear();
    match reached.map_err(|error| unopened(&error))? {
        Reached::There => Ok(session),
        Reached::Nowhere(refusal) => {
            complain(&refusal.to_string());
            Err(BAD_INPUT)
        }
    }
}

//! The sample of a scene, where it is wanted before anything else begins.

use super::output::{tell, unopened};
use super::progress::Progress;
use crate::scene::Scene;
use crate::session::{Options, start};

/// The scene with its sample, which is prepared now if need be; or the exit status.
pub(super) fn with_sample(scene: Scene, threads: usize, quiet: bool) -> Result<Scene, u8> {
    let options = Options {
        threads,
        ..Options::default()
    };
    let mut progress: Option<Progress> = None;
    let started = start::resolve(scene, &options, &mut |session| {
        let new = || Progress::of_sample(session, quiet);
        progress.get_or_insert_with(new).show(session);
        true
    });
    if let Some(progress) = &mut progress {
        progress.clear();
    }
    let started = started.map_err(|error| unopened(&error))?;
    started.notices.iter().for_each(|notice| tell(notice));
    Ok(started.scene)
}

//! Preparing a sample: another preset is run up to the end of a stage.

use std::time::Duration;

use super::super::{Budget, Options, Progress, RunError, Session};
use super::{Beat, cache, place, resolve, resolve_at, trouble};
use crate::measure::columns::nearest;
use crate::scene::catalogue::find;
use crate::scene::{Keep, Scene, Source};

/// Time between looks at the progress.
const BATCH: Duration = Duration::from_millis(50);

/// The run that prepares the sample of a scene: it ends where the sample is taken. `None` if the scene
/// starts from none, or from a file.
pub fn preparation(scene: &Scene) -> Result<Option<Scene>, RunError> {
    let Some(start) = &scene.start else {
        return Ok(None);
    };
    let Source::Preset { name, stage, set } = &start.from else {
        return Ok(None);
    };
    let path = match find(name) {
        Some(_) => name.clone(),
        None => place(scene, name).display().to_string(),
    };
    let mut set = set.clone();
    set.extend(scene.own_seed.map(|seed| format!("model.seed={seed}")));
    let mut run = Scene::load(&path, &set)?;
    if let Some(stage) = stage {
        let names = run.stages.iter().map(|stage| stage.name.as_str());
        let Some(at) = names.clone().position(|name| name == stage) else {
            let trouble = trouble(
                "stage",
                format!("{name} has no stage `{stage}`"),
                "expected the name of one of its stages",
                &nearest(stage, names),
            );
            return Err(scene.refused(&trouble).into());
        };
        run.stages.truncate(at + 1);
    }
    if run.stages.is_empty() {
        let trouble = trouble(
            "preset",
            format!("{name} has no [[stage]], so it never ends"),
            "expected a preset that comes to an end",
            "add a [[stage]] with max_cycles or until to it, or start from a checkpoint of it",
        );
        return Err(scene.refused(&trouble).into());
    }
    // Going on with bookings needs those so far; it changes no bit.
    run.setup.ledger |= start.keep == Keep::All && scene.setup.ledger;
    Ok(Some(run))
}

/// Whether a scene can be opened without running another preset first.
pub fn is_ready(scene: &Scene, options: &Options) -> bool {
    match preparation(scene) {
        Ok(Some(_)) if scene.sample.is_some() => true,
        Ok(Some(run)) => {
            // Its own sample is read from the cache then, not prepared.
            let own = is_ready(&run, options).then(|| resolve(run, options, &mut |_| false));
            !options.no_cache
                && matches!(own, Some(Ok(own)) if cache::Entry::of(&own.scene).read().is_some())
        }
        _ => true,
    }
}

/// Whether two runs that prepare a sample prepare the same one, so that the second finds it kept.
pub fn is_same(a: &Scene, b: &Scene, options: &Options) -> bool {
    let decides = |run: &Scene| (run.seed, run.stages.len(), run.setup.ledger);
    !options.no_cache
        && cache::is_on()
        && decides(a) == decides(b)
        && a.text == b.text
        && a.overrides == b.overrides
}

/// The checkpoint of the sample: from the cache, or prepared now and put there.
pub(super) fn state(
    scene: &Scene,
    options: &Options,
    beat: &mut Beat<'_>,
    depth: usize,
    notices: &mut Vec<String>,
) -> Result<Vec<u8>, RunError> {
    let run = preparation(scene)?;
    let run = run.expect("the scene starts from a preset");
    let options = Options {
        seed: None,
        expendable: true,
        ..*options
    };
    let started = resolve_at(run, &options, beat, depth + 1)?;
    notices.extend(started.notices);
    let entry = (!options.no_cache).then(|| cache::Entry::of(&started.scene));
    if let Some(state) = entry.as_ref().and_then(cache::Entry::read) {
        return Ok(state);
    }
    let state = run_to_the_end(started.scene.clone(), &options, beat)?;
    if let Some(Err(error)) = entry.map(|entry| entry.write(&state)) {
        notices.push(format!("the sample is not kept for the next time: {error}"));
    }
    Ok(state)
}

fn run_to_the_end(
    scene: Scene,
    options: &Options,
    beat: &mut Beat<'_>,
) -> Result<Vec<u8>, RunError> {
    let mut session = Session::open(scene, *options)?;
    let budget = Budget {
        time: Some(BATCH),
        ..Budget::default()
    };
    while session.advance(budget, false)? != Progress::Finished {
        if !beat(&session) {
            return Err(RunError::Stopped);
        }
    }
    session.encode()
}

//! The sample that a scene starts from: found in a file, in the cache, or prepared by running another
//! preset; then the preset is read again with it, and a world is made of both.
//!
//! A prepared sample goes through the bytes of a checkpoint even where it is used at once, so that one
//! from the cache gives the same bits.

mod cache;
mod fit;
mod prepare;
mod repeat;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::save::{Held, held};
use super::{Options, RunError, Session};
use crate::engine::World;
use crate::scene::{Keep, Origin, Sample, Scene, Source, Trouble};

pub use prepare::{is_ready, is_same, preparation};

/// Called between batches while a sample is being prepared; false ends it.
pub type Beat<'a> = dyn FnMut(&Session) -> bool + 'a;

/// A preset that starts from a preset that starts from a preset, and so on, is taken for a circle.
const DEEPEST: usize = 8;

/// A scene whose sample is known, and what the user should know about it.
pub struct Started {
    /// The scene, read with its sample.
    pub scene: Scene,
    /// What happened on the way.
    pub notices: Vec<String>,
}

/// Finds or prepares the sample of a scene; one that needs none, or has it, stays as it is.
pub fn resolve(scene: Scene, options: &Options, beat: &mut Beat<'_>) -> Result<Started, RunError> {
    resolve_at(scene, options, beat, 0)
}

fn resolve_at(
    scene: Scene,
    options: &Options,
    beat: &mut Beat<'_>,
    depth: usize,
) -> Result<Started, RunError> {
    let mut notices = Vec::new();
    let Some(start) = scene.start.as_ref().filter(|_| scene.sample.is_none()) else {
        return Ok(Started { scene, notices });
    };
    if depth > DEEPEST {
        let trouble = trouble(
            "preset",
            format!("{} starts from itself, by way of others", scene.name),
            "a preset that starts from something else is expected in the end",
            "name a preset that lists or generates its particles",
        );
        return Err(scene.refused(&trouble).into());
    }
    let state = match &start.from {
        Source::File(file) => read(&scene, file)?,
        Source::Preset { .. } => prepare::state(&scene, options, beat, depth, &mut notices)?,
    };
    let found = held(&state);
    let Held {
        world, cut_short, ..
    } = found.map_err(|fault| scene.refused(&unusable(start_key(&scene), &fault.to_string())))?;
    if world.is_broken() {
        let trouble = trouble(
            start_key(&scene),
            "the run that the sample is of broke off: its state cannot go on".into(),
            "a state between two cycles is expected",
            "mend that run first; a smaller frac is the usual remedy",
        );
        return Err(scene.refused(&trouble).into());
    }
    notices.extend(cut_short.iter().map(|stage| {
        format!("the sample's stage {stage} ended at max_cycles, before its condition held")
    }));
    let sample = Sample {
        particles: world.particles_at_rest(),
        walls: world.walls_at_rest(),
        boundary: world.boundary_at_rest(),
        materials: world
            .model()
            .materials
            .iter()
            .map(|m| m.name.clone())
            .collect(),
        state,
    };
    let sample =
        repeat::repeated(sample, start.repeat).map_err(|trouble| scene.refused(&trouble))?;
    let keep = start.keep;
    let scene = scene.started(Arc::new(sample))?;
    if let (Keep::Particles, Some(what)) = (keep, fit::change(&world, &scene)) {
        notices.push(format!(
            "the sample was made otherwise ({what}): forces follow anew from its overlaps, so let it \
             come to rest before anything is measured"
        ));
    }
    Ok(Started { scene, notices })
}

/// The world that a scene begins with. Its particles leave the scene: a large one has no room for them
/// twice.
pub(super) fn world(scene: &mut Scene, options: &Options) -> Result<World, RunError> {
    let threads = options.threads;
    let keep = scene.start.as_ref().map(|start| start.keep);
    let (Some(Keep::All), Some(sample)) = (keep, &scene.sample) else {
        let (setup, brought) = (scene.take_setup(), scene.brought());
        scene.sample = None;
        return Ok(World::build_from(setup, &brought, threads)?);
    };
    let Held { world, control, .. } = held(&sample.state)
        .map_err(|fault| scene.refused(&unusable(start_key(scene), &fault.to_string())))?;
    if let Some(misfit) = fit::misfit(&world, scene) {
        return Err(scene.refused(&misfit).into());
    }
    let reopened = world.reopen(&scene.setup, threads);
    let mut world = reopened.ok_or_else(|| {
        let misfit = unusable("keep", "what its contacts remember does not fit the law");
        RunError::from(scene.refused(&misfit))
    })?;
    // Nobody steers them any more.
    for servo in &control.walls {
        let steered = world.walls().iter().position(|w| w.name == servo.wall);
        if let Some(w) = steered {
            world.set_wall_velocity(w, [0.0; 2]);
        }
    }
    drop(scene.take_setup());
    scene.sample = None;
    Ok(world)
}

/// Overrides with which the preset starts from the same sample wherever it is read: for the journal.
/// Paths are whole, and the state is noted.
pub(super) fn noted(scene: &Scene, world: &World) -> Vec<String> {
    let Some(start) = &scene.start else {
        return scene.overrides.clone();
    };
    let (key, path) = match &start.from {
        Source::File(file) => ("from", Some(place(scene, file))),
        Source::Preset { name, .. } => {
            let embedded = crate::scene::catalogue::find(name).is_some();
            ("preset", (!embedded).then(|| place(scene, name)))
        }
    };
    let mut noted = Vec::new();
    let mut rest = scene.overrides.clone();
    if let Some(path) = path {
        let path = std::path::absolute(&path).unwrap_or(path);
        let text = toml::Value::String(path.display().to_string());
        let entry = format!("start.{key}={text}");
        let begin = format!("start.{key}");
        // One that was given is made whole where it stands: the last one counts.
        match rest
            .iter_mut()
            .rfind(|set| set.trim_start().starts_with(&begin))
        {
            Some(given) => *given = entry,
            None => noted.push(entry),
        }
    }
    rest.retain(|set| !set.trim_start().starts_with("start.state"));
    noted.push(format!("start.state=\"{:016x}\"", world.state_hash()));
    noted.extend(rest);
    noted
}

/// What to tell of a start that is not the one that was noted.
pub(super) fn another(scene: &Scene, world: &World) -> Option<String> {
    let expected = scene.start.as_ref()?.state?;
    let state = world.state_hash();
    (state != expected).then(|| {
        format!(
            "the run starts from state {state:016x}, and state {expected:016x} was noted: sample or \
             settings are others now"
        )
    })
}

fn read(scene: &Scene, file: &str) -> Result<Vec<u8>, RunError> {
    let path = place(scene, file);
    std::fs::read(&path).map_err(|error| {
        let attempt = crate::record::error::Attempt::Open;
        let error = crate::record::error::RecordError::new(&path, attempt, error);
        scene.refused(&unusable("from", &error.to_string())).into()
    })
}

/// Where a path of a preset leads: from its own folder.
fn place(scene: &Scene, path: &str) -> PathBuf {
    let folder = match &scene.origin {
        Origin::File(preset) => preset.parent().unwrap_or(Path::new("")),
        Origin::Embedded(_) | Origin::Text => Path::new(""),
    };
    folder.join(path)
}

/// The key that says what to start from.
fn start_key(scene: &Scene) -> &'static str {
    match scene.start.as_ref().map(|start| &start.from) {
        Some(Source::Preset { .. }) => "preset",
        _ => "from",
    }
}

fn unusable(key: &'static str, why: &str) -> Trouble {
    trouble(
        key,
        format!("there is no sample to start from: {why}"),
        "expected a checkpoint of this version",
        "write one with ballast run PRESET --checkpoint FILE.ballast, or name the preset that makes it",
    )
}

fn trouble(key: &'static str, message: String, expected: &str, remedy: &str) -> Trouble {
    Trouble {
        key,
        message,
        expected: expected.into(),
        remedy: remedy.into(),
    }
}

//! What is run: a preset, a journal or a checkpoint.

use std::path::Path;

use crate::cli::output::{complain, load, reject, tell, unopened};
use crate::cli::{BAD_INPUT, Run};
use crate::record::journal::{Journal, looks_like_journal};
use crate::scene::Scene;
use crate::session::start::Beat;
use crate::session::{Options, Replay, Session};

/// A session ready to run.
pub(super) struct Prepared {
    pub(super) session: Session,
    pub(super) replay: Option<Replay>,
    /// Whether it goes on from a checkpoint.
    pub(super) resumed: bool,
}

/// Reads and checks everything; no file is touched. Answers the exit status if something is wrong.
/// `beat` sees the run that prepares a sample, and ends it with false.
pub(super) fn prepare(options: &Run, beat: &mut Beat<'_>) -> Result<Prepared, u8> {
    let set = settings(options);
    let name = options.preset.as_deref().unwrap_or_default();
    let journal = journal(name)?;
    let prepared = match &options.resume {
        Some(path) => resume(path, options, journal.as_ref(), &set)?,
        None => begin(name, options, journal.as_ref(), &set, beat)?,
    };
    let Prepared {
        session, replay, ..
    } = &prepared;
    check_length(session.scene(), replay.as_ref(), name, options)?;
    Ok(prepared)
}

/// Whether it is known how far to run.
fn check_length(
    scene: &Scene,
    replay: Option<&Replay>,
    name: &str,
    options: &Run,
) -> Result<(), u8> {
    if !scene.stages.is_empty() || options.cycles.is_some() {
        return Ok(());
    }
    let wanted = match replay {
        None => format!("{} has no [[stage]]", scene.name),
        Some(replay) if replay.end().is_none() => {
            format!("{name} has no end and its preset no [[stage]]")
        }
        Some(_) => return Ok(()),
    };
    complain(&format!("{wanted}; say how far to run with --cycles N"));
    Err(BAD_INPUT)
}

/// Reads and checks what many runs have in common, before the first begins: their scene.
pub(super) fn foresee(options: &Run) -> Result<Scene, u8> {
    let name = options.preset.as_deref().unwrap_or_default();
    let (scene, replay) = read(name, journal(name)?.as_ref(), &settings(options))?;
    check_length(&scene, replay.as_ref(), name, options)?;
    Ok(scene)
}

/// `--set` and `--seed`, in this order.
fn settings(options: &Run) -> Vec<String> {
    let mut set = options.set.clone();
    set.extend(options.seed.map(|seed| format!("model.seed={seed}")));
    set
}

/// The scene of a preset or journal, and what to repeat.
fn read(
    name: &str,
    journal: Option<&Journal>,
    set: &[String],
) -> Result<(Scene, Option<Replay>), u8> {
    let scene = match journal {
        None => load(name, set).ok_or(BAD_INPUT)?,
        Some(journal) => {
            let overrides = [&journal.overrides, set].concat();
            let parsed = Scene::parse(&journal.preset_name, &journal.preset_text, &overrides);
            parsed.map_err(|rejection| {
                reject(&rejection);
                BAD_INPUT
            })?
        }
    };
    let replay = journal.map(|journal| Replay::new(journal, &scene));
    if let Some(Err(error)) = replay.as_ref().map(Replay::check) {
        complain(&format!("{name}: {error}"));
        return Err(BAD_INPUT);
    }
    Ok((scene, replay))
}

fn begin(
    name: &str,
    options: &Run,
    journal: Option<&Journal>,
    set: &[String],
    beat: &mut Beat<'_>,
) -> Result<Prepared, u8> {
    let (scene, replay) = read(name, journal, set)?;
    let how = Options {
        threads: options.threads.map_or(0, usize::from),
        no_cache: options.no_cache,
        ..Options::default()
    };
    let session = Session::open_watched(scene, how, beat).map_err(|error| unopened(&error))?;
    Ok(Prepared {
        session,
        replay,
        resumed: false,
    })
}

/// The journal of this path, if it is one.
fn journal(path: &str) -> Result<Option<Journal>, u8> {
    let Ok(text) = std::fs::read_to_string(path) else {
        return Ok(None);
    };
    if !looks_like_journal(&text) {
        return Ok(None);
    }
    let journal = Journal::parse(&text).map_err(|error| {
        complain(&format!("{path}: {error}"));
        BAD_INPUT
    })?;
    if journal.cut {
        tell(&format!("{path}: the last line is cut off and left out"));
    }
    Ok(Some(journal))
}

fn resume(
    path: &Path,
    options: &Run,
    journal: Option<&Journal>,
    set: &[String],
) -> Result<Prepared, u8> {
    let refuse = |message: &str| {
        complain(&format!("{}: {message}", path.display()));
        BAD_INPUT
    };
    let threads = options.threads.map_or(0, usize::from);
    let session = Session::resume(path, threads).map_err(|error| {
        complain(&error.to_string());
        BAD_INPUT
    })?;
    let scene = session.scene();
    if !set.is_empty() && !scene.overrides.ends_with(set) {
        return Err(refuse(
            "a resumed run keeps its preset; leave --set and --seed out, or start anew",
        ));
    }
    let another = |name: &str| {
        let own = &scene.name;
        refuse(&format!(
            "it is of preset {own}, and {name} is another; leave the preset out"
        ))
    };
    let replay = match (&options.preset, journal) {
        (None, _) => None,
        (Some(name), None) => {
            if load(name, &scene.overrides).ok_or(BAD_INPUT)?.text != scene.text {
                return Err(another(name));
            }
            None
        }
        (Some(name), Some(journal)) => {
            let same = journal.preset_text == scene.text
                && scene.overrides == [&journal.overrides, set].concat();
            Replay::new(journal, scene).check().map_err(|error| {
                complain(&format!("{name}: {error}"));
                BAD_INPUT
            })?;
            let rest = same.then(|| Replay::rest(journal, &session)).flatten();
            let rest = rest.ok_or_else(|| {
                refuse(&format!(
                    "it was not made by replaying {name}; leave it out"
                ))
            })?;
            let here = session.world().cycle_number();
            if let Some((cycle, back)) = rest.goes_back_before(here) {
                return Err(refuse(&format!(
                    "it is of cycle {here}, and at cycle {cycle} {name} goes back to cycle {back}, \
                     which it does not hold; replay from the beginning: ballast run {name}"
                )));
            }
            Some(rest)
        }
    };
    Ok(Prepared {
        session,
        replay,
        resumed: true,
    })
}

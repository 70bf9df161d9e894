//! One way to run an experiment: its scene with another law, other keys and another step.

use super::pace::{Pace, keep_pace, unit};
use super::plan::{NoPlan, Series};
use crate::engine::World;
use crate::language::Command;
use crate::scene::Scene;
use crate::session::figure::figure;

/// One way to run the experiment.
pub struct Variant {
    /// Index of its series.
    pub series: usize,
    /// FRAC that was asked for.
    pub asked: f64,
    /// FRAC it runs with, so that whole numbers of cycles make up the stages.
    pub frac: f64,
    /// Time step [s].
    pub dt: f64,
    /// Its cycles against those of the preset.
    pub pace: Pace,
    /// The scene it runs.
    pub scene: Scene,
}

/// A variant whose step would have to shrink by more, to make up the stages, is refused.
const SHRINKING: f64 = 0.1;

/// A stage that lets the step follow the stability bound would undo what the variants differ in.
pub(super) fn fixed_step(scene: &Scene) -> Result<(), NoPlan> {
    let auto = |command: &Command| matches!(command, Command::FracAuto(_));
    let stage = scene.stages.iter().find(|s| s.commands.iter().any(auto));
    stage.map_or(Ok(()), |stage| {
        Err(NoPlan::Refused(format!(
            "stage {name} says `frac auto`, after which all variants have the same step; leave it \
             out with --set stage.{name}.do=[...]",
            name = stage.name
        )))
    })
}

/// The preset with the law and the swept keys of a series, and FRAC.
fn with(scene: &Scene, series: &Series, frac: f64) -> Result<Scene, NoPlan> {
    let mut overrides = scene.overrides.clone();
    if !scene.study.law.is_empty() {
        overrides.push(format!("model.law=\"{}\"", series.law));
    }
    overrides.extend(series.settings.iter().cloned());
    overrides.push(format!("model.frac={frac:?}"));
    scene
        .overridden(&overrides)
        .map_err(|rejection| NoPlan::Rejected(Box::new(rejection)))
}

/// The step that FRAC multiplies in a series [s].
pub(super) fn base_step(scene: &Scene, series: &Series) -> Result<f64, NoPlan> {
    let scene = with(scene, series, scene.setup.frac)?;
    let world = World::build(scene.setup, 1).map_err(failed)?;
    Ok(world.base_step())
}

/// A variant of any FRAC. Where whole cycles do not make up the stages they are a little longer.
pub(super) fn unfitted(scene: &Scene, series: &Series, frac: f64) -> Result<Variant, NoPlan> {
    fixed_step(scene)?;
    let preset = World::build(scene.setup.clone(), 1).map_err(failed)?;
    let mut own = with(scene, series, frac)?;
    let dt = frac * base_step(scene, series)?;
    let pace = Pace::of(preset.dt() / dt);
    keep_pace(&mut own, pace, frac / scene.setup.frac);
    Ok(Variant {
        series: 0,
        asked: frac,
        frac,
        dt,
        pace,
        scene: own,
    })
}

pub(super) fn variant(
    scene: &Scene,
    all: &[Series],
    series: usize,
    asked: f64,
    [preset_frac, preset_dt, base_step]: [f64; 3],
) -> Result<Variant, NoPlan> {
    let mut own = with(scene, &all[series], asked)?;
    let unit = unit(&own);
    let ratio = preset_dt / (asked * base_step);
    let (pace, frac) = fitted(unit, ratio, asked).ok_or_else(|| {
        NoPlan::Refused(format!(
            "frac = {} does not fit into the stages: their lengths are multiples of {unit} cycles \
             at frac = {}, and the nearest step that makes them up is frac = {}; name that, or \
             smaller ones",
            figure(asked),
            figure(preset_frac),
            figure(asked * unit as f64 * ratio / (unit as f64 * ratio).ceil()),
        ))
    })?;
    own.setup.frac = frac;
    keep_pace(&mut own, pace, frac / preset_frac);
    Ok(Variant {
        series,
        asked,
        frac,
        dt: frac * base_step,
        pace,
        scene: own,
    })
}

/// The pace and FRAC nearest to what is asked, at `ratio` cycles per cycle of the preset, with which
/// `unit` cycles of the preset take a whole number of cycles; none if that is far from it.
fn fitted(unit: u64, ratio: f64, asked: f64) -> Option<(Pace, f64)> {
    if unit == 0 {
        return Some((Pace::of(ratio), asked));
    }
    let pace = Pace::of(ratio);
    if pace.whole(unit).is_some_and(|cycles| cycles > 0) {
        return Some((pace, asked));
    }
    let exact = unit as f64 * ratio;
    let cycles = exact.ceil();
    let shrunk = exact / cycles;
    (shrunk >= 1.0 - SHRINKING).then(|| (Pace::new(cycles as u64, unit), asked * shrunk))
}

pub(super) fn failed(fault: crate::engine::Fault) -> NoPlan {
    NoPlan::Failed(fault.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_fit_into_the_stages() {
        assert_eq!(fitted(40, 2.5, 0.04), Some((Pace::of(2.5), 0.04)));
        assert_eq!(fitted(0, 0.3, 0.5), Some((Pace::of(0.3), 0.5)));
        let (pace, frac) = fitted(500, 0.245 / 0.2, 0.2).unwrap();
        assert_eq!(pace, Pace::new(613, 500));
        assert!((frac - 0.2 * 612.5 / 613.0).abs() < 1e-15);
        // Half a cycle cannot be run, and two thirds are far from one.
        assert_eq!(fitted(1, 0.5, 0.2), None);
        assert_eq!(fitted(2, 1.0 / 3.0, 3.0), None);
    }
}

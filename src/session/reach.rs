//! Running up to a place in the stages: so many cycles into one of them, its commands issued.

use std::fmt;

use super::course::Phase;
use super::{Refusal, RunError, Session};
use crate::measure::columns::nearest;
use crate::scene::Scene;

/// A place in the stages of a scene.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Place {
    /// Name of the stage.
    pub stage: String,
    /// Cycles done in it.
    pub cycles: u64,
}

impl Place {
    /// From `STAGE` or `STAGE/CYCLES`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let (stage, cycles) = text.split_once('/').unwrap_or((text, "0"));
        match cycles.parse() {
            Ok(cycles) if !stage.is_empty() => Ok(Self {
                stage: stage.to_owned(),
                cycles,
            }),
            _ => Err("STAGE or STAGE/CYCLES is expected, for instance shear or shear/1000".into()),
        }
    }

    /// Which of the stages of a scene it names.
    pub fn stage_of(&self, scene: &Scene) -> Result<usize, Refusal> {
        let names = || scene.stages.iter().map(|stage| stage.name.as_str());
        names().position(|name| name == self.stage).ok_or_else(|| {
            Refusal::new(
                format!("{} has no stage `{}`", scene.name, self.stage),
                nearest(&self.stage, names()),
            )
        })
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.stage, self.cycles)
    }
}

/// How a run to a place ended.
#[derive(Debug)]
pub enum Reached {
    /// It is there.
    There,
    /// There is no such place.
    Nowhere(Refusal),
}

/// Cycles between two calls of the beat.
const BATCH: u64 = 64;

impl Session {
    /// Runs until `place`; `None`: until the commands of the first stage are issued. `beat` is called now
    /// and then.
    pub fn reach(
        &mut self,
        place: Option<&Place>,
        beat: &mut dyn FnMut(&Session),
    ) -> Result<Reached, RunError> {
        let (wanted, cycles) = match place {
            None if self.scene.stages.is_empty() => return Ok(Reached::There),
            None => (0, 0),
            Some(place) => match place.stage_of(&self.scene) {
                Ok(stage) => (stage, place.cycles),
                Err(refusal) => return Ok(Reached::Nowhere(refusal)),
            },
        };
        for turn in 0u64.. {
            if turn.is_multiple_of(BATCH) {
                beat(self);
            }
            if self.stands_at(wanted, cycles, Phase::Over) {
                return Ok(Reached::There);
            }
            if let Some(fault) = self.world.fault().cloned() {
                return Err(self.stopped(fault.into()));
            }
            let stage = self.course.stage;
            self.stage_turn()?;
            if self.stands_at(wanted, cycles, Phase::Running) {
                return Ok(Reached::There);
            }
            if self.is_finished() || self.course.stage > wanted {
                let before = &self.scene.stages[stage.min(wanted)].name;
                return Ok(Reached::Nowhere(Refusal::new(
                    format!(
                        "stage {before} was over before {cycles} cycles: at cycle {}",
                        self.world.cycle_number()
                    ),
                    "name an earlier place, STAGE/CYCLES",
                )));
            }
            self.cycle()?;
        }
        Ok(Reached::There)
    }

    fn stands_at(&self, stage: usize, cycles: u64, phase: Phase) -> bool {
        self.course.stage == stage && self.course.phase == phase && self.stage_cycle() >= cycles
    }
}

//! Where a run stands in its stages, and what was asked of it besides.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use super::By;
use crate::language::Expression;

/// Position in the stages. The end of a stage is noticed at the boundary where it comes; the next
/// stage begins only when the run goes on, so that a command typed at that boundary comes first,
/// live and in a replay.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Course {
    /// Index of the stage.
    pub(super) stage: usize,
    /// Cycle at which it began.
    pub(super) started_at: u64,
    /// Cycle at which the last stage that is over ended.
    pub(super) ended_at: u64,
    /// How far it is.
    pub(super) phase: Phase,
    /// Commands of the stage still to be issued.
    pub(super) lines: VecDeque<String>,
    /// Cycles that a command of the stage asked for.
    pub(super) errand: Option<Errand>,
    /// Lines of a sourced file still to be executed.
    pub(super) user_lines: VecDeque<String>,
    /// Cycles that the user asked for.
    pub(super) user_errand: Option<Errand>,
    /// Stages that ended at `max_cycles` although they have a condition.
    pub(super) cut_short: Vec<String>,
}

/// How far a stage is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub(super) enum Phase {
    /// Not begun.
    #[default]
    Ahead,
    /// Its commands are being issued.
    Issuing,
    /// Its cycles run.
    Running,
    /// Over.
    Over,
}

/// Cycles that a command asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Errand {
    /// Last cycle.
    pub until_cycle: Option<u64>,
    /// It ends earlier when this holds.
    #[serde(with = "as_text")]
    pub condition: Option<Expression>,
    /// Cycle at which it began.
    pub from: u64,
    /// Whether every boundary on the way is to be shown, not only where it ends.
    #[serde(skip)]
    pub shown: bool,
}

impl Course {
    /// Whether nothing of the stages is left.
    pub(super) fn is_finished(&self, stages: usize) -> bool {
        stages == 0 || self.done(stages) >= stages
    }

    /// Cycles that somebody asked for.
    pub(super) fn errand_of(&self, by: By) -> Option<&Errand> {
        match by {
            By::User => self.user_errand.as_ref(),
            By::Stage => self.errand.as_ref(),
        }
    }

    /// The same, and forgets them.
    pub(super) fn end_errand(&mut self, by: By) -> Option<Errand> {
        match by {
            By::User => self.user_errand.take(),
            By::Stage => self.errand.take(),
        }
    }

    /// How many stages have ended.
    pub(super) fn done(&self, stages: usize) -> usize {
        let own = usize::from(self.phase == Phase::Over);
        (self.stage + own).min(stages)
    }
}

/// A condition is kept as it would be typed.
mod as_text {
    use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

    use crate::language::Expression;

    #[allow(clippy::ref_option, reason = "the form that serde calls")]
    pub(super) fn serialize<S: Serializer>(
        condition: &Option<Expression>,
        to: S,
    ) -> Result<S::Ok, S::Error> {
        condition.as_ref().map(ToString::to_string).serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(
        from: D,
    ) -> Result<Option<Expression>, D::Error> {
        let text = Option::<String>::deserialize(from)?;
        let read = |text: String| Expression::parse_condition(&text);
        let mistaken = |mistake| D::Error::custom(format!("condition of a command: {mistake}"));
        text.map(read).transpose().map_err(mistaken)
    }
}

//! Where a run stands in its stages, and what was asked of it besides.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

/// Position in the stages. The end of a stage is noticed at the boundary where it comes; the next
/// stage begins only when the run goes on, so that a command typed at that boundary comes first,
/// live and in a replay.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Course {
    /// Index of the stage.
    pub(super) stage: usize,
    /// Cycle at which it began.
    pub(super) started_at: u64,
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
    /// Condition, as text.
    pub condition: Option<String>,
    /// Cycle at which it began.
    pub from: u64,
}

impl Course {
    /// Whether nothing of the stages is left.
    pub(super) fn is_finished(&self, stages: usize) -> bool {
        stages == 0 || self.done(stages) >= stages
    }

    /// How many stages have ended.
    pub(super) fn done(&self, stages: usize) -> usize {
        let own = usize::from(self.phase == Phase::Over);
        (self.stage + own).min(stages)
    }
}

//! Why a run or a command did not go on.

use crate::engine::Fault;
use crate::language::Mistake;
use crate::record::error::RecordError;
use crate::scene::Rejection;

/// A command that was not carried out; nothing has changed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}; {remedy}")]
pub struct Refusal {
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub remedy: String,
}

impl Refusal {
    /// From its two parts.
    pub fn new(message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            remedy: remedy.into(),
        }
    }
}

impl From<Mistake> for Refusal {
    fn from(mistake: Mistake) -> Self {
        Self::new(mistake.message, mistake.remedy)
    }
}

impl From<RecordError> for Refusal {
    fn from(error: RecordError) -> Self {
        Self::new(error.to_string(), "nothing else has changed")
    }
}

/// A run that cannot go on.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// Physics gone wrong.
    #[error(transparent)]
    Fault(#[from] Fault),
    /// A file could not be written or read.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// A command of a stage was refused.
    #[error("stage {stage}: `{line}`: {refusal}")]
    Stage {
        /// Name of the stage.
        stage: String,
        /// The command.
        line: String,
        /// Why.
        refusal: Refusal,
    },
    /// A command of a journal was refused.
    #[error("journal at cycle {cycle}: `{line}`: {refusal}")]
    Journal {
        /// Cycles done.
        cycle: u64,
        /// The command.
        line: String,
        /// Why.
        refusal: Refusal,
    },
    /// There is nothing to start from, or it does not go with the preset.
    #[error(transparent)]
    Rejected(Box<Rejection>),
    /// The sample to start from was not ready when somebody ended it.
    #[error("ended while the sample to start from was being prepared")]
    Stopped,
    /// A checkpoint does not fit.
    #[error("{0}")]
    Misfit(String),
}

impl From<Rejection> for RunError {
    fn from(rejection: Rejection) -> Self {
        Self::Rejected(Box::new(rejection))
    }
}

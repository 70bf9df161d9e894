//! What can be wrong with a checkpoint.

use super::{FORMAT, LARGEST};

/// What is wrong with a checkpoint.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CheckpointFault {
    /// It starts with something else.
    #[error("this is no checkpoint of ballast")]
    NotACheckpoint,
    /// Another version of this program wrote it.
    #[error("the checkpoint has format {found}, and this program reads format {FORMAT}")]
    OtherFormat {
        /// Its format.
        found: u32,
    },
    /// Its end is missing.
    #[error("the checkpoint is cut short: {held} of at least {expected} bytes")]
    Truncated {
        /// Bytes there are.
        held: u64,
        /// Bytes there should be.
        expected: u64,
    },
    /// Something follows it.
    #[error("{bytes} bytes follow the end of the checkpoint")]
    Trailing {
        /// How many.
        bytes: u64,
    },
    /// Its payload is not what was written.
    #[error("the checkpoint is damaged: its checksum does not fit its content")]
    Checksum,
    /// Larger than any state this program makes.
    #[error("the checkpoint holds {bytes} bytes or more, and at most {LARGEST} are used")]
    TooLarge {
        /// Bytes of its payload or content.
        bytes: u64,
    },
    /// Undamaged, but not the expected value.
    #[error("the checkpoint is undamaged but its content cannot be used ({0})")]
    Content(String),
    /// Something more urgent came up while it was written.
    #[error("writing the checkpoint was put off")]
    PutOff,
    /// The value has no binary form.
    #[error("the state cannot be put into a checkpoint ({0})")]
    Unwritable(String),
}

impl CheckpointFault {
    /// What a user can do about it.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::NotACheckpoint => "check the path; checkpoints usually end in .ballast",
            Self::OtherFormat { .. } | Self::Content(_) => {
                "read it with the version of ballast that wrote it, or replay the journal beside it"
            }
            Self::Truncated { .. } | Self::Trailing { .. } | Self::Checksum => {
                "use an earlier copy, or replay the journal beside it"
            }
            Self::TooLarge { .. } => "use a smaller scene, or replay the journal beside it",
            Self::PutOff => "save again",
            Self::Unwritable(_) => "this is a fault of the program: please report it",
        }
    }
}

//! What of a scene another program lacks, and what comes nearest to it there.

/// One thing that does not map.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Misfit {
    /// What it is, and why.
    pub(super) what: String,
    /// What is written instead; `None`: nothing comes near.
    pub(super) nearest: Option<String>,
}

/// All of them, and what is worth knowing besides.
#[derive(Debug, Clone, Default)]
pub(super) struct Fit {
    pub(super) misfits: Vec<Misfit>,
    /// What maps, in words: one line each.
    pub(super) maps: Vec<String>,
    /// What is the same in the limit only, or is done otherwise.
    pub(super) differs: Vec<String>,
}

impl Fit {
    pub(super) fn maps(&mut self, what: impl Into<String>) {
        self.maps.push(what.into());
    }

    pub(super) fn differs(&mut self, what: impl Into<String>) {
        self.differs.push(what.into());
    }

    /// Something that is lacking there, with what comes nearest.
    pub(super) fn lacks(&mut self, what: impl Into<String>, nearest: impl Into<String>) {
        self.misfits.push(Misfit {
            what: what.into(),
            nearest: Some(nearest.into()),
        });
    }

    /// Something that nothing comes near.
    pub(super) fn refuses(&mut self, what: impl Into<String>) {
        self.misfits.push(Misfit {
            what: what.into(),
            nearest: None,
        });
    }
}

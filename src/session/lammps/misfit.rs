//! What of a scene another program lacks, and what comes nearest to it there.

use crate::session::Refusal;

/// One thing that does not map.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Misfit {
    /// What it is, and why.
    pub(super) what: String,
    /// What is written instead; `None`: nothing comes near.
    pub(super) nearest: Option<String>,
}

/// All of them, and what is worth knowing besides: each once, as pairs and walls have much in common.
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
        once(&mut self.maps, what.into());
    }

    pub(super) fn differs(&mut self, what: impl Into<String>) {
        once(&mut self.differs, what.into());
    }

    /// Something that is lacking there, with what comes nearest.
    pub(super) fn lacks(&mut self, what: impl Into<String>, nearest: impl Into<String>) {
        let misfit = Misfit {
            what: what.into(),
            nearest: Some(nearest.into()),
        };
        once(&mut self.misfits, misfit);
    }

    /// Something that nothing comes near.
    pub(super) fn refuses(&mut self, what: impl Into<String>) {
        let misfit = Misfit {
            what: what.into(),
            nearest: None,
        };
        once(&mut self.misfits, misfit);
    }

    /// Refuses what does not map. `nearest`: what comes nearest will do, where something does.
    pub(super) fn accept(&self, name: &str, nearest: bool) -> Result<(), Refusal> {
        let reasons: Vec<&str> = (self.misfits.iter())
            .filter(|misfit| !nearest || misfit.nearest.is_none())
            .map(|misfit| misfit.what.as_str())
            .collect();
        if reasons.is_empty() {
            return Ok(());
        }
        let remedy = if self.misfits.iter().all(|misfit| misfit.nearest.is_some()) {
            let mut all = Vec::new();
            for one in self
                .misfits
                .iter()
                .filter_map(|misfit| misfit.nearest.as_deref())
            {
                once(&mut all, one);
            }
            format!("--nearest writes what comes nearest: {}", all.join("; "))
        } else {
            "nothing comes near that: change the scene with --set".to_owned()
        };
        Err(Refusal::new(
            format!(
                "{name} cannot be written for LAMMPS as it is: {}",
                reasons.join("; ")
            ),
            remedy,
        ))
    }
}

fn once<T: PartialEq>(list: &mut Vec<T>, one: T) {
    if !list.contains(&one) {
        list.push(one);
    }
}

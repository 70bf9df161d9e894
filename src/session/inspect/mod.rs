//! One contact in full: what `inspect` answers, what is recorded while it is followed, and the
//! files that come of it. Nothing here advances a memory or changes a world.

mod files;
mod follower;
mod inspection;
mod lines;
mod picture;
mod table;

pub use follower::{Follower, Moment};
pub use inspection::Inspection;

use super::{Refusal, Reply, Session};
use crate::measure::columns::Partner;

impl Session {
    /// Shows a contact and follows it from now on. Both bodies exist: the command was checked.
    pub(super) fn inspect(&mut self, i: u32, partner: &Partner) -> Reply {
        self.follow(i, partner);
        let mut lines = lines::contact(&mut self.world, i, partner);
        if let Some(follower) = &self.follower {
            lines.push(format!(
                "followed since cycle {}; `export svg contact FILE` draws it, `inspect off` ends it",
                follower.since()
            ));
        }
        Reply {
            lines,
            request: None,
        }
    }

    /// Follows a contact from now on; one that is followed already keeps its record.
    pub fn follow(&mut self, i: u32, partner: &Partner) {
        let follows = |follower: &Follower| follower.is_of(i, partner);
        if !self.follower.as_ref().is_some_and(follows) {
            self.follower = Some(Follower::new(i, partner.clone(), &self.world));
        }
    }

    /// Follows none any more.
    pub(super) fn follow_none(&mut self) -> Reply {
        match self.follower.take() {
            Some(follower) => Reply::line(format!("{} is not followed any more", follower.name())),
            None => Reply::line("no contact is followed"),
        }
    }

    /// After another world has taken the place of the one that was followed.
    pub(super) fn follow_anew(&mut self) {
        let old = self.follower.take();
        self.follower =
            old.map(|old| Follower::new(old.first(), old.partner().clone(), &self.world));
    }

    /// The contact that is followed, as it is now.
    pub fn inspection(&self) -> Option<Inspection> {
        let follower = self.follower.as_ref()?;
        Some(Inspection::of(&self.world, follower))
    }

    fn inspected(&self) -> Result<Inspection, Refusal> {
        self.inspection().ok_or_else(|| {
            Refusal::new(
                "no contact is followed",
                "`inspect contact I-J` begins to, and the cycles after it are kept",
            )
        })
    }
}

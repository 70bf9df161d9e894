//! Memories of two reversals in lanes, and what happens to them.

use super::super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::{Branch, Reversals};
use crate::engine::lanes::Lanes;

const UNLOADING: f64 = Branch::Unloading as u8 as f64;
const RELOADING: f64 = Branch::Reloading as u8 as f64;

/// Memories in lanes, as [`Reversals`] has them.
#[derive(Debug, Clone, Copy)]
pub struct ReversalLanes<V> {
    pub(super) overlap: V,
    pub(super) force: V,
    pub(super) unloaded_from: V,
    pub(super) reloaded_from: V,
    pub(super) shortfall: V,
    pub(super) branch: V,
}

numbers!(ReversalLanes {
    overlap: V,
    force: V,
    unloaded_from: V,
    reloaded_from: V,
    shortfall: V,
    branch: V,
});

/// Numbers of lanes, field by field.
pub(super) type Columns = [[f64; 8]; 6];

/// The memory of a lane.
#[inline(always)]
pub(super) fn lane(columns: &Columns, lane: usize) -> Reversals {
    let one = columns.map(|numbers| [numbers[lane], 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    ReversalLanes::<f64>::of(&one).into()
}

/// Changes the memory of a lane.
#[inline(always)]
pub(super) fn set_lane(columns: &mut Columns, lane: usize, memory: Reversals) {
    let new = ReversalLanes::from(memory).numbers();
    for (numbers, new) in columns.iter_mut().zip(new) {
        numbers[lane] = new[0];
    }
}

impl From<ReversalLanes<f64>> for Reversals {
    #[inline(always)]
    fn from(lane: ReversalLanes<f64>) -> Self {
        let branch = if lane.branch == RELOADING {
            Branch::Reloading
        } else if lane.branch == UNLOADING {
            Branch::Unloading
        } else {
            Branch::Virgin
        };
        Self {
            overlap: lane.overlap,
            force: lane.force,
            unloaded_from: lane.unloaded_from,
            reloaded_from: lane.reloaded_from,
            shortfall: lane.shortfall,
            branch,
        }
    }
}

impl From<Reversals> for ReversalLanes<f64> {
    #[inline(always)]
    fn from(memory: Reversals) -> Self {
        Self {
            overlap: memory.overlap,
            force: memory.force,
            unloaded_from: memory.unloaded_from,
            reloaded_from: memory.reloaded_from,
            shortfall: memory.shortfall,
            branch: f64::from(memory.branch as u8),
        }
    }
}

impl Numbers<f64> for Reversals {
    const COUNT: usize = <ReversalLanes<f64> as Numbers<f64>>::COUNT;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        <ReversalLanes<f64> as Numbers<f64>>::take(from).into()
    }
}

impl Written<f64> for Reversals {
    fn give(self, mask: bool, to: &mut Writing) {
        Written::<f64>::give(ReversalLanes::from(self), mask, to);
    }
}

impl<V: Lanes> ReversalLanes<V> {
    #[inline(always)]
    pub(super) fn pick(mask: V::Mask, yes: &Self, no: &Self) -> Self {
        Self {
            overlap: V::pick(mask, yes.overlap, no.overlap),
            force: V::pick(mask, yes.force, no.force),
            unloaded_from: V::pick(mask, yes.unloaded_from, no.unloaded_from),
            reloaded_from: V::pick(mask, yes.reloaded_from, no.reloaded_from),
            shortfall: V::pick(mask, yes.shortfall, no.shortfall),
            branch: V::pick(mask, yes.branch, no.branch),
        }
    }

    /// The numbers of all lanes, field by field.
    #[inline(always)]
    pub(super) fn numbers(&self) -> Columns {
        [
            self.overlap.numbers(),
            self.force.numbers(),
            self.unloaded_from.numbers(),
            self.reloaded_from.numbers(),
            self.shortfall.numbers(),
            self.branch.numbers(),
        ]
    }

    /// From the numbers of all lanes.
    #[inline(always)]
    pub(super) fn of(columns: &Columns) -> Self {
        Self {
            overlap: V::of(&columns[0]),
            force: V::of(&columns[1]),
            unloaded_from: V::of(&columns[2]),
            reloaded_from: V::of(&columns[3]),
            shortfall: V::of(&columns[4]),
            branch: V::of(&columns[5]),
        }
    }

    #[inline(always)]
    pub(super) fn is_virgin(&self) -> V::Mask {
        self.branch.equals(V::all(0.0))
    }

    #[inline(always)]
    pub(super) fn is_unloading(&self) -> V::Mask {
        self.branch.equals(V::all(UNLOADING))
    }

    #[inline(always)]
    pub(super) fn is_reloading(&self) -> V::Mask {
        self.branch.equals(V::all(RELOADING))
    }

    #[inline(always)]
    pub(super) fn direction(&self, d: V) -> V {
        let virgin = V::pick(self.force.equals(V::all(0.0)), d, self.force);
        let decides = V::pick(self.is_virgin(), virgin, self.unloaded_from);
        V::all(1.0).copysign(decides)
    }

    #[inline(always)]
    pub(super) fn sense(&self) -> V {
        V::pick(self.is_unloading(), V::all(-1.0), V::all(1.0))
    }

    #[inline(always)]
    pub(super) fn forget(&mut self, mask: V::Mask) {
        let zero = V::all(0.0);
        self.branch = V::pick(mask, zero, self.branch);
        self.unloaded_from = V::pick(mask, zero, self.unloaded_from);
        self.reloaded_from = V::pick(mask, zero, self.reloaded_from);
        self.shortfall = V::pick(mask, zero, self.shortfall);
    }

    #[inline(always)]
    pub(super) fn turn(&mut self, mask: V::Mask, direction: V) {
        let (first, second) = (mask & self.is_virgin(), mask & self.is_unloading());
        let overtaken = second & (direction * self.force).at_least(direction * self.unloaded_from);
        let second = second & !overtaken;
        self.unloaded_from = V::pick(first, self.force, self.unloaded_from);
        self.reloaded_from = V::pick(second, self.force, self.reloaded_from);
        let branch = V::pick(second, V::all(RELOADING), self.branch);
        self.branch = V::pick(first, V::all(UNLOADING), branch);
        self.shortfall = V::pick(first | second, V::all(0.0), self.shortfall);
        self.forget(overtaken);
    }

    #[inline(always)]
    pub(super) fn shift(&mut self, rise: V) {
        let (top, bottom) = (self.unloaded_from, self.reloaded_from);
        self.unloaded_from = V::pick(self.is_virgin(), top, top + rise);
        self.reloaded_from = V::pick(self.is_reloading(), bottom - rise, bottom);
    }

    #[inline(always)]
    pub(super) fn settle(&mut self, mask: V::Mask, direction: V, progress: V) {
        let zero = V::all(0.0);
        let mask = mask & !self.is_virgin();
        let force = direction * self.force;
        let top = direction * self.unloaded_from;
        let bottom = direction * self.reloaded_from;
        let reloading = self.is_reloading();
        let reached = zero.at_least(top) | (-top).at_least(force) | reloading & force.at_least(top);
        let back = reloading & zero.above(progress) & bottom.at_least(force);
        self.branch = V::pick(mask & !reached & back, V::all(UNLOADING), self.branch);
        self.forget(mask & reached);
    }
}

//! What a contact tells the energy ledger.

use serde::{Deserialize, Serialize};

use super::memory::{Memory, kept_as_columns};
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use crate::engine::lanes::Lanes;

/// What one contact contributes to the energy ledger, or several in lanes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Book<V = f64> {
    /// Dashpot forces at the last boundary [N].
    pub damping: [V; 2],
    /// Friction beyond the spring's own at the last boundary [N].
    pub excess: V,
    /// Energy lost in the last step by sliding of the whole contact, rolling included, and by slip
    /// within it [J].
    pub friction_loss: [V; 2],
    /// Energy lost in the dashpots in the last step [J].
    pub damping_loss: V,
    /// Tangential displacement since first touch [m].
    pub delta: V,
    /// Energy lost since first touch: sliding, slip within, dashpots [J].
    pub lost: [V; 3],
    /// Tangential way, without sign, over the cycles in which the whole contact slid, since first
    /// touch or since it was forgotten [m]. The step in which sliding begins or turns counts whole:
    /// its elastic part is in it.
    pub slid: V,
}

numbers! {
    Book {
        damping: [V; 2],
        excess: V,
        friction_loss: [V; 2],
        damping_loss: V,
        delta: V,
        lost: [V; 3],
        slid: V,
    }
}

/// Columns of the losses in the last step: sliding, slip within, dashpots.
pub(super) const LOSSES: [usize; 3] = [3, 4, 5];

impl Memory for Book {
    kept_as_columns!(Book);

    fn reduced(&self) -> [f64; 2] {
        [0.0; 2]
    }

    /// No force depends on any.
    fn visit(&self, _: &mut dyn FnMut(f64)) {}
}

/// A step of a contact.
pub(super) struct Step<V: Lanes> {
    /// Along the normal and across it [m].
    pub(super) way: [V; 2],
    /// Whether the whole contact slid.
    pub(super) sliding: V::Mask,
}

impl<V: Lanes> Book<V> {
    /// After a step of the contact.
    #[inline(always)]
    pub(super) fn after(self, loss: [V; 2], damping: [V; 2], excess: V, step: &Step<V>) -> Self {
        let way = step.way;
        let friction_loss = [loss[0] + mean(self.excess, excess) * way[1], loss[1]];
        let damping_loss =
            mean(self.damping[0], damping[0]) * way[0] + mean(self.damping[1], damping[1]) * way[1];
        Self {
            damping,
            excess,
            friction_loss,
            damping_loss,
            delta: self.delta + way[1],
            lost: [
                self.lost[0] + friction_loss[0],
                self.lost[1] + friction_loss[1],
                self.lost[2] + damping_loss,
            ],
            slid: V::pick(step.sliding, self.slid + way[1].abs(), self.slid),
        }
    }

    /// This where the mask says so, the other elsewhere.
    #[inline(always)]
    pub(super) fn or(self, mask: V::Mask, other: Self) -> Self {
        Self {
            damping: [
                V::pick(mask, self.damping[0], other.damping[0]),
                V::pick(mask, self.damping[1], other.damping[1]),
            ],
            excess: V::pick(mask, self.excess, other.excess),
            friction_loss: [
                V::pick(mask, self.friction_loss[0], other.friction_loss[0]),
                V::pick(mask, self.friction_loss[1], other.friction_loss[1]),
            ],
            damping_loss: V::pick(mask, self.damping_loss, other.damping_loss),
            delta: V::pick(mask, self.delta, other.delta),
            lost: [
                V::pick(mask, self.lost[0], other.lost[0]),
                V::pick(mask, self.lost[1], other.lost[1]),
                V::pick(mask, self.lost[2], other.lost[2]),
            ],
            slid: V::pick(mask, self.slid, other.slid),
        }
    }
}

/// Of the ends of a step.
#[inline(always)]
fn mean<V: Lanes>(old: V, new: V) -> V {
    V::all(0.5) * (old + new)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::contact::memories::Memories;

    #[test]
    fn losses_are_where_the_ledger_looks() {
        let book = Book {
            friction_loss: [1.0, 2.0],
            damping_loss: 3.0,
            ..Book::default()
        };
        let mut books = Memories::<Book>::default();
        books.follow(&[u32::MAX], 1);
        books.set(0, book);
        let losses = LOSSES.map(|column| books.column(column)[0]);
        assert_eq!((losses, books.get(0)), ([1.0, 2.0, 3.0], book));
    }
}

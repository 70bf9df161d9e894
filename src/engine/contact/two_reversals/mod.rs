//! The tangential law of Mindlin & Deresiewicz with two remembered reversals, as the program BALL
//! of Randall (1989) ran it, with the equations of chapter 3 put right.
//!
//! At constant normal force N the force T lies on one of three curves of slope 8 G\* a θ:
//!
//! | branch | θ³ | |
//! |---|---|---|
//! | virgin loading | 1 - T/(μN) | (3.53) |
//! | unloading from T\* | 1 - (T\* - T)/(2μN) | (3.54) |
//! | reloading from T\*\* | 1 - (T - T\*\*)/(2μN) | (3.55) |
//!
//! (for T\* > 0). A reversal while reloading is not remembered: the curve is run backwards, a
//! non-linear elastic path (figure 3.8). Reaching -T\*, T\* or T\*\* forgets the curve that led
//! there.
//!
//! A change ΔN moves every curve: T by ±μΔN along with a displacement Δs_c = μΔN/(8 G\* a), T\* by
//! +μΔN and T\*\* by -μΔN ((3.65), (4.16), (4.20), (4.21)). When N rises, a displacement too small
//! for that leaves the contact stuck at slope 8 G\* a, and what is missing, DD, waits for later
//! steps. When N falls the curve is followed at once, and a force before its start (θ > 1) moves at
//! full slope. Both steps together are (3.94) to (3.98).
//!
//! The limit of small steps is that of the corrected program; the steps are better:
//!
//! - The curve is followed exactly, across its corners, where BALL took the tangent at its start;
//!   Δs_c = μκΔα is exact too, with the mean of 8 G\* a over the step. No error of the step is left
//!   at constant N, and one of second order along a branch.
//! - A contact held in place follows a change of N like any other; BALL left T as it was when the
//!   displacement was exactly zero.
//! - The branch is a value of its own ([`Branch`]), for T\*\* = 0 is a legal turning point.
//!
//! The law is exact for virgin load, one unloading and one reloading at constant N. It is wrong for
//! a contact that was stuck while N rose (.1 μN on the histories of
//! `tests/two_reversals/histories.rs`), for nested loops (.03 to .07 μN), and most of all for a
//! reversal while N falls faster (.8 μN), where it can be driven round a cycle that gives energy
//! ([`WORST_GAIN`]). Two hard edges are BALL's too: pure normal loading leaves no DD only while T is
//! none (a billionth of μN), and a stuck contact moves at full slope while N rises but on its curve
//! while N falls, however little.

mod curves;
mod energy;
mod held;
mod lanes;
#[cfg(test)]
mod lanes_tests;
mod view;

use serde::{Deserialize, Serialize};

use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::slipped::Slipped;
use crate::engine::lanes::Lanes;
use curves::Run;
pub use held::ReversalLanes;
pub use lanes::SlippedLanes;

/// The most energy that a closed cycle of overlap and displacement was found to give per turn, as a
/// share of what a full slide there and back takes at its largest overlap (0.8 μN δ\*): a random
/// search over cycles of three or four corners whose overlap varies up to tenfold. No error of the
/// step, but a property of the law; with more corners a turn gives more.
pub const WORST_GAIN: f64 = 0.44;

/// Share of μN up to which T is none: what rounding leaves of a displacement that is along the normal.
///
/// A step along a slanted normal has a tangential part of up to 2⁻⁵² of it. If all of them have the same
/// sign, a million steps leave 2e-10 k_t/k_n/μ of μN; thousands, of either sign, were seen to leave 1e-12.
/// A shear that was meant and is as slow is summed up below this as above.
const NOTHING: f64 = 1e-9;

/// The curve that the force is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Branch {
    /// Loading without memory.
    #[default]
    Virgin,
    /// After the first reversal, from T\*.
    Unloading,
    /// After the second reversal, from T\*\*, in either direction.
    Reloading,
}

/// Memory of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Reversals {
    /// Overlap of the last step [m].
    overlap: f64,
    /// T [N].
    force: f64,
    /// T\* [N]; without meaning on the virgin branch.
    unloaded_from: f64,
    /// T\*\* [N]; has a meaning on the last two branches.
    reloaded_from: f64,
    /// DD [m]: what the displacement falls short of the curve while the contact is stuck.
    shortfall: f64,
    branch: Branch,
}

impl Reversals {
    /// T [N].
    pub fn force(&self) -> f64 {
        self.force
    }

    /// Shows every number that the future depends on.
    pub fn numbers(&self, see: &mut dyn FnMut(f64)) {
        for number in [
            self.overlap,
            self.force,
            self.unloaded_from,
            self.reloaded_from,
            self.shortfall,
            f64::from(self.branch as u8),
        ] {
            see(number);
        }
    }

    /// The curve that the force is on.
    pub fn branch(&self) -> Branch {
        self.branch
    }

    /// Sign of the loading direction (CDF): that of T\* once there is one, else of the force, and
    /// of the displacement where there is no force.
    fn direction(&self, d: f64) -> f64 {
        let decides = match self.branch {
            Branch::Virgin if self.force == 0.0 => d,
            Branch::Virgin => self.force,
            _ => self.unloaded_from,
        };
        1.0_f64.copysign(decides)
    }

    /// Sign of progress on the branch, seen in the loading direction (UFL).
    fn sense(&self) -> f64 {
        match self.branch {
            Branch::Virgin | Branch::Reloading => 1.0,
            Branch::Unloading => -1.0,
        }
    }

    /// The displacement has turned against the branch: remembers where. The reloading curve is run
    /// backwards without a memory of its own; a turning point that a fall of N has overtaken is
    /// none.
    fn turn(&mut self, direction: f64) {
        match self.branch {
            Branch::Virgin => {
                self.unloaded_from = self.force;
                self.branch = Branch::Unloading;
            }
            Branch::Unloading if direction * self.force >= direction * self.unloaded_from => {
                self.forget();
            }
            Branch::Unloading => {
                self.reloaded_from = self.force;
                self.branch = Branch::Reloading;
            }
            Branch::Reloading => return,
        }
        self.shortfall = 0.0;
    }

    /// Moves the turning points with the normal force, by ±μΔN [N] (4.20), (4.21).
    fn shift(&mut self, rise: f64) {
        if self.branch != Branch::Virgin {
            self.unloaded_from += rise;
        }
        if self.branch == Branch::Reloading {
            self.reloaded_from -= rise;
        }
    }

    /// Forgets all turning points.
    fn forget(&mut self) {
        self.branch = Branch::Virgin;
        self.unloaded_from = 0.0;
        self.reloaded_from = 0.0;
        self.shortfall = 0.0;
    }

    /// Forgets the turning points that this step has reached, or that a change of the normal force
    /// has overtaken.
    fn settle(&mut self, direction: f64, progress: f64) {
        if self.branch == Branch::Virgin {
            return;
        }
        let [force, top, bottom] =
            [self.force, self.unloaded_from, self.reloaded_from].map(|f| direction * f);
        let reloading = self.branch == Branch::Reloading;
        if top <= 0.0 || force <= -top || reloading && force >= top {
            self.forget();
        } else if reloading && progress < 0.0 && force <= bottom {
            self.branch = Branch::Unloading;
        }
    }
}

/// A contact as its present overlap shapes it.
#[derive(Debug, Clone, Copy)]
struct Size<V = f64> {
    /// sqrt(α).
    root: V,
    /// μN [N].
    limit: V,
    /// Displacement at which virgin loading slides, 3μN/(16 G\* a) [m] (3.28).
    slide: V,
}

/// The law, prepared for a pair.
#[derive(Debug, Clone, Copy)]
pub struct TwoReversals<V = f64> {
    /// μN/α^1.5.
    limit: V,
    /// 8 G\* sqrt(R\*).
    shear: V,
    /// E\*/(4 G\*): sliding displacement over μα.
    kappa: V,
    friction: V,
}

numbers!(TwoReversals {
    limit: V,
    shear: V,
    kappa: V,
    friction: V
});

impl<V: Lanes> TwoReversals<V> {
    #[inline(always)]
    fn size(&self, overlap: V) -> Size<V> {
        let root = overlap.sqrt();
        Size {
            root,
            limit: self.limit * overlap * root,
            slide: self.friction * self.kappa * overlap,
        }
    }
}

impl TwoReversals {
    /// From E\* and G\* [Pa], R\* [m] and μ.
    pub fn new(young_eff: f64, shear_eff: f64, r_eff: f64, friction: f64) -> Self {
        Self {
            limit: friction * 4.0 / 3.0 * young_eff * r_eff.sqrt(),
            shear: 8.0 * shear_eff * r_eff.sqrt(),
            kappa: young_eff / (4.0 * shear_eff),
            friction,
        }
    }

    /// One step to this overlap with the tangential displacement d [m].
    #[inline]
    pub fn advance(&self, overlap: f64, d: f64, memory: &mut Reversals) -> Slipped {
        if overlap <= 0.0 || self.friction <= 0.0 {
            *memory = Reversals::default();
            return Slipped::default();
        }
        let (before, size) = (self.size(memory.overlap), self.size(overlap));
        memory.overlap = overlap;
        if memory.branch == Branch::Virgin && memory.force.abs() <= NOTHING * before.limit {
            // Pure normal loading leaves nothing to catch up with and nothing to turn back from.
            memory.shortfall = 0.0;
            if memory.force * d < 0.0 {
                memory.force = 0.0;
            }
        }
        let direction = memory.direction(d);
        if direction * memory.sense() * d < 0.0 {
            memory.turn(direction);
        }
        let direction = memory.direction(d);
        let sense = direction * memory.sense();
        let progress = sense * d;

        // All curves move to the new normal force, at the mean of 8 G* a over the change.
        let rise = size.limit - before.limit;
        memory.shift(direction * rise);
        let (r, s) = (size.root, before.root);
        let stiffness = self.shear * (r * r + r * s + s * s) / (1.5 * (r + s));
        let pace = rise / stiffness;
        let missing = pace + memory.shortfall;
        let landed = memory.force + sense * rise;
        // Back along the reloading curve: an elastic path, with no annulus to stick first.
        let backwards = progress < 0.0 && memory.shortfall == 0.0;
        let mut run = Run::default();
        if rise < 0.0 {
            if memory.shortfall > 0.0 {
                memory.shortfall = (missing - progress).max(0.0);
            }
            if memory.is_before_start(landed, direction) {
                memory.force += stiffness * d;
            } else {
                memory.force = landed;
                run = memory.run(&size, sense * (progress - pace));
            }
        } else if progress <= missing && !backwards {
            memory.force += stiffness * d;
            memory.shortfall = missing - progress;
        } else {
            memory.force += sense * (stiffness * missing);
            memory.shortfall = 0.0;
            run = memory.run(&size, sense * (progress - missing));
        }
        let surplus = memory.force.abs() - size.limit;
        if surplus > 0.0 {
            memory.force = size.limit.copysign(memory.force);
            memory.forget();
            run.slid += surplus / stiffness;
        } else {
            memory.settle(direction, progress);
        }
        Slipped {
            force: memory.force,
            gross: 0.5 * (before.limit + size.limit) * run.slid,
            micro: size.limit * size.slide * run.losses,
            sliding: run.slid > 0.0,
        }
    }

    /// The pair comes apart with the displacement d [m]: forgets, and answers the energy lost [J].
    pub fn part(&self, d: f64, memory: &mut Reversals) -> f64 {
        let lost = self.energy(memory) + 0.5 * memory.force * d;
        *memory = Reversals::default();
        lost
    }

    /// T [N].
    pub fn force(&self, memory: &Reversals) -> f64 {
        memory.force
    }

    /// Tangent stiffness 8 G\* a θ [N/m].
    pub fn stiffness(&self, memory: &Reversals) -> f64 {
        let size = self.size(memory.overlap);
        let full = self.shear * size.root;
        if memory.shortfall > 0.0 || size.limit <= 0.0 {
            return full;
        }
        full * memory.theta(&size)
    }

    /// Memory that carries this force [N] at this overlap on the virgin curve; no more than μN.
    pub fn seed(&self, overlap: f64, force: f64) -> Reversals {
        // A listed pair may be apart.
        let overlap = overlap.max(0.0);
        let limit = self.size(overlap).limit;
        Reversals {
            overlap,
            force: force.clamp(-limit, limit),
            ..Reversals::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// μN = 1 and sliding displacement 1 at overlap 1.
    fn law() -> TwoReversals {
        TwoReversals::new(0.75, 0.75 / 4.0, 1.0, 1.0)
    }

    #[test]
    fn a_pair_apart_remembers_nothing() {
        assert_eq!(law().seed(-0.5, 0.0), Reversals::default());
    }

    #[test]
    fn unit_law_has_units() {
        let size = law().size(1.0);
        assert_eq!((size.limit, size.slide), (1.0, 1.0));
        // 3μN/(16 G* a) = 1.
        assert!((law().shear - 1.5).abs() < 1e-15);
    }

    #[test]
    fn turning_point_at_zero_force_is_one() {
        let mut memory = Reversals {
            overlap: 1.0,
            force: 0.0,
            unloaded_from: 0.75,
            branch: Branch::Unloading,
            ..Reversals::default()
        };
        for _ in 0..10 {
            law().advance(1.0, 0.05, &mut memory);
        }
        assert_eq!(
            (memory.branch, memory.reloaded_from),
            (Branch::Reloading, 0.0)
        );
        // δ - δ** = 2 δ* (1 - θ²).
        let theta = 0.75_f64.sqrt();
        let want = 2.0 * (1.0 - theta * theta * theta);
        assert!((memory.force - want).abs() < 1e-14, "{memory:?}");
    }

    #[test]
    fn memory_of_a_parted_pair_is_none() {
        let mut memory = law().seed(1.0, 0.4);
        law().advance(1.0, -0.1, &mut memory);
        let held = law().energy(&memory);
        let lost = law().part(-0.2, &mut memory);
        assert!(held > 0.0 && lost < held);
        assert_eq!(memory, Reversals::default());
        memory = law().seed(1.0, 0.4);
        assert_eq!(law().advance(0.0, 0.1, &mut memory), Slipped::default());
        assert_eq!(memory, Reversals::default());
    }

    #[test]
    fn seed_carries_no_more_than_friction_allows() {
        assert_eq!(law().force(&law().seed(1.0, -3.0)), -1.0);
        let memory = law().seed(1.0, 0.875);
        assert!((law().stiffness(&memory) - 0.75).abs() < 1e-15);
        assert_eq!(law().stiffness(&law().seed(1.0, 0.0)), 1.5);
    }

    #[test]
    fn nothing_without_friction() {
        let law = TwoReversals::new(0.75, 0.75 / 4.0, 1.0, 0.0);
        let mut memory = law.seed(1.0, 1.0);
        assert_eq!(law.advance(1.0, 0.5, &mut memory), Slipped::default());
        assert_eq!(
            (law.energy(&memory), law.part(0.1, &mut memory)),
            (0.0, 0.0)
        );
    }
}

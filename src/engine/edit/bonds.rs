//! Bonds between particles: making and counting them.

use crate::engine::World;
use crate::engine::neighbours::Status;

/// Gap up to which particles are bonded unless told otherwise, over the smaller radius: what touches but
/// for rounding.
const GAP: f64 = 1e-6;

impl World {
    /// Bonds all particles that touch, or are apart by no more than a gap [m], and are both inside, by their
    /// indices. Those that a bond could not hold there, or to whose materials it gives no strength, stay
    /// without. Answers how many bonds that made.
    pub fn bond(&mut self, gap: Option<f64>, inside: impl Fn(usize) -> bool) -> usize {
        let mut made = 0;
        self.booked(|world| {
            world.keeping_velocities(|world| {
                // All within the reach of a bond are listed then.
                world.relist();
                made = world.make_bonds(gap, inside);
                world.touch_again();
            });
        });
        made
    }

    fn make_bonds(&mut self, gap: Option<f64>, inside: impl Fn(usize) -> bool) -> usize {
        let mut pass = self.take_pass();
        let mut made = 0;
        for (k, &[i, j]) in self.contacts.pairs.iter().enumerate() {
            let [i, j] = [i as usize, j as usize];
            let pair = self.pair_of(k);
            let strong = pair.bond_tension > 0.0 || pair.bond_shear > 0.0;
            if !(inside(i) && inside(j) && strong) || pass.is_bonded(k) {
                continue;
            }
            let [a, b] = [i, j].map(|p| self.particles.row[p].radius);
            let most = gap.unwrap_or(GAP * a.min(b)).min(pair.bond_reach());
            if -self.geometry(k).overlap <= most {
                pass.bond(k);
                made += 1;
                // Only contacts that count as touching are asked for their forces.
                if self.contacts.status[k] == Status::Apart {
                    self.contacts.status[k] = Status::Touching;
                }
            }
        }
        self.put_pass(pass);
        self.bonds_made += made as u64;
        made
    }

    /// Whether listed contact k is bonded. Memories of laws without bonds are not looked at: there are
    /// large ones.
    pub fn is_bonded(&self, k: usize) -> bool {
        self.model.law.has_bonds() && self.pass().is_bonded(k)
    }

    /// Number of bonds that hold.
    pub fn bonds(&self) -> u64 {
        let bonded = (0..self.contacts.pairs.len()).filter(|&k| self.is_bonded(k));
        bonded.count() as u64
    }

    /// Number of bonds that broke.
    pub fn bonds_broken(&self) -> u64 {
        self.bonds_made - self.bonds()
    }

    /// Gap up to which a bond may hold [m]; 0 where the law knows none.
    pub(in crate::engine) fn bond_reach(&self) -> f64 {
        if self.model.law.has_bonds() {
            self.pairs.bond_reach()
        } else {
            0.0
        }
    }
}

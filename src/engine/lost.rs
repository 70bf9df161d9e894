//! Particles that a cycle cannot go on with: too fast, lost, or no longer numbers.

use super::World;
use super::fault::Fault;
use super::neighbours::Slot;

/// Further than so many sizes of the scene from its middle, a particle is lost.
const LOST: f64 = 1e4;

/// So many cells away it is, too: images are counted in sixteen bits, those of either of a pair.
const CELLS: f64 = 16_000.0;

impl World {
    /// The particle that moved too far, or not by a number, if one did.
    pub(super) fn wild_particle(&self) -> Option<Fault> {
        let (p, cycle) = (&self.particles, self.cycle);
        for (k, row) in p.row.iter().enumerate() {
            let step = (row.v[0] * row.v[0] + row.v[1] * row.v[1]).sqrt() * self.dt;
            let broken = step.is_nan() || row.spin.is_nan();
            if step < row.radius && !broken {
                continue;
            }
            for (contact, _) in self.contacts.of(k) {
                let Some(&[i, j]) = self.contacts.pairs.get(contact) else {
                    continue;
                };
                let Slot(force) = self.contacts.slots[contact];
                if force.iter().any(|f| f.is_nan()) && step.is_nan() {
                    let (first, second) = (p.id[i as usize], p.id[j as usize]);
                    return Some(Fault::Coincident {
                        cycle,
                        first,
                        second,
                    });
                }
            }
            let particle = p.id[k];
            return Some(if broken {
                Fault::NotANumber { cycle, particle }
            } else {
                Fault::Runaway {
                    cycle,
                    particle,
                    distance: step,
                }
            });
        }
        None
    }

    pub(super) fn lost_particle(&self) -> Result<(), Fault> {
        let mut limit = LOST * (self.size + self.origin_size());
        if let Some(cell) = self.cell() {
            let [a, b] = cell.widths();
            let width = a.min(b);
            let rows = self.particles.row.iter();
            let largest = rows.fold(0.0, |most: f64, row| most.max(row.radius));
            if width.is_nan() || width < largest {
                let cycle = self.cycle;
                return Err(Fault::Narrow { cycle, width });
            }
            limit = limit.min(CELLS * width);
        }
        for (row, &particle) in self.particles.row.iter().zip(&self.particles.id) {
            let distance = row.x[0].abs().max(row.x[1].abs());
            if distance > limit {
                return Err(Fault::Lost {
                    cycle: self.cycle,
                    particle,
                    distance,
                });
            }
        }
        Ok(())
    }

    /// Scenes that keep their own coordinates may lie up to sixteen sizes off the origin.
    fn origin_size(&self) -> f64 {
        if self.origin == [0.0; 2] {
            16.0 * self.size
        } else {
            0.0
        }
    }
}

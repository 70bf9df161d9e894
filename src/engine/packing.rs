//! A world on its way into a checkpoint and back: what is not stored is made again.

use super::World;
use super::threads::Threads;

impl World {
    /// Ready to be written to a checkpoint: takes the contact memory along, in place of what the next
    /// search for neighbours will need.
    pub fn pack(&mut self) {
        self.contacts.release();
        self.memory = self
            .pass
            .as_ref()
            .map(|pass| pass.save())
            .unwrap_or_default();
    }

    /// After the checkpoint is written.
    pub fn unload(&mut self) {
        self.memory = Vec::new();
    }

    /// After reading a checkpoint: what is not stored is made again. False if it does not fit.
    /// `threads` 0: as many as suit its size.
    pub fn unpack(&mut self, threads: usize) -> bool {
        let (particles, walls) = (self.particles.len(), self.walls.len());
        let known = self.particles.fit(self.model.materials.len());
        if !known || !self.contacts.unpack(particles, walls) {
            return false;
        }
        self.threads = Threads::team(threads, particles);
        let mut pass = self.plan().pass();
        let old = vec![u32::MAX; self.contacts.len()];
        pass.relist(&old, self.contacts.pairs.len(), self.room(), &|k| {
            self.basis(k)
        });
        let fits = pass.load(&std::mem::take(&mut self.memory));
        for row in &mut self.particles.row {
            row.set_spin(row.spin);
        }
        self.pass = Some(pass);
        self.see();
        fits
    }
}

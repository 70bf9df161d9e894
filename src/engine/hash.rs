//! The state in sixty-four bits: equal states, equal hash, on any machine and thread count.

use super::World;
use super::neighbours::Status;

/// FNV-1a over 64-bit words.
struct Fnv(u64);

impl Fnv {
    fn word(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Both zeros count as one.
    fn number(&mut self, x: f64) {
        self.word((x + 0.0).to_bits());
    }
}

impl World {
    /// Hash of cycle, positions, velocities, walls and the memory of touching contacts. What is
    /// only listed does not count, so TOL does not show in it.
    pub fn state_hash(&self) -> u64 {
        let mut hash = Fnv(0xcbf2_9ce4_8422_2325);
        hash.word(self.cycle);
        for (row, &id) in self.particles.row.iter().zip(&self.particles.id) {
            hash.word(u64::from(id));
            for x in [
                row.x[0], row.x[1], row.angle, row.v[0], row.v[1], row.spin, row.radius,
            ] {
                hash.number(x);
            }
        }
        for wall in &self.walls {
            for x in [wall.point[0], wall.point[1], wall.angle] {
                hash.number(x);
            }
        }
        if let Some(strain) = self.imposed_strain() {
            strain.iter().flatten().for_each(|x| hash.number(*x));
        }
        for (k, status) in self.contacts.status.iter().enumerate() {
            if *status == Status::Apart {
                continue;
            }
            if let Some(&[i, j]) = self.contacts.pairs.get(k) {
                hash.word(u64::from(self.particles.id[i as usize]));
                hash.word(u64::from(self.particles.id[j as usize]));
            } else {
                let wall = &self.contacts.walls[k - self.contacts.pairs.len()];
                hash.word(u64::from(self.particles.id[wall.particle as usize]));
                hash.word(u64::MAX - u64::from(wall.wall));
            }
            hash.word(u64::from(*status == Status::Sliding));
            self.pass().visit(k, &mut |number| hash.number(number));
        }
        hash.0
    }
}

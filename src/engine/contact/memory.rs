//! What a contact remembers from cycle to cycle.

use serde::{Serialize, de::DeserializeOwned};

/// Memory of a part of a law. The reduced form (forces in newtons) is what survives a change of law.
pub trait Memory: Copy + Default + Send + Sync + Serialize + DeserializeOwned + 'static {
    /// Normal and tangential spring force [N] as far as this part holds them.
    fn reduced(&self) -> [f64; 2];
    /// Shows every number that the future depends on, for the state hash.
    fn visit(&self, see: &mut dyn FnMut(f64));
}

impl Memory for () {
    fn reduced(&self) -> [f64; 2] {
        [0.0; 2]
    }

    fn visit(&self, _: &mut dyn FnMut(f64)) {}
}

impl<N: Memory, T: Memory, R: Memory> Memory for (N, T, R) {
    fn reduced(&self) -> [f64; 2] {
        [self.0.reduced()[0], self.1.reduced()[1]]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.0.visit(see);
        self.1.visit(see);
        self.2.visit(see);
    }
}

//! What a contact remembers from cycle to cycle.

use serde::{Serialize, de::DeserializeOwned};

/// Memory of a part of a law. The reduced form (forces in newtons) is what survives a change of law
/// and what the state hash sees.
pub trait Memory: Copy + Default + Send + Sync + Serialize + DeserializeOwned + 'static {
    /// Normal and tangential spring force [N] as far as this part holds them.
    fn reduced(&self) -> [f64; 2];
    /// From the reduced form.
    fn from_reduced(forces: [f64; 2]) -> Self;
}

impl Memory for () {
    fn reduced(&self) -> [f64; 2] {
        [0.0; 2]
    }

    fn from_reduced(_: [f64; 2]) -> Self {}
}

impl<N: Memory, T: Memory> Memory for (N, T) {
    fn reduced(&self) -> [f64; 2] {
        [self.0.reduced()[0], self.1.reduced()[1]]
    }

    fn from_reduced(forces: [f64; 2]) -> Self {
        (N::from_reduced(forces), T::from_reduced(forces))
    }
}

//! What is read off a world: measures read, they never change anything.

pub mod assembly;
pub mod columns;
pub mod fabric;
pub mod frame;
pub mod link;
pub mod region;
pub mod regional;
pub mod rose;
pub mod sample;
pub mod stress;
pub mod tensor;
pub mod wall_force;

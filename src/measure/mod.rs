//! What is read off a world: measures read, they never change anything.

pub mod assembly;
pub mod columns;
pub mod frame;
pub mod sample;
pub mod wall_force;

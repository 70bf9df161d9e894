//! What is read off a world: measures read, they never change anything.

mod affine;
pub mod assembly;
pub mod changes;
pub mod class;
pub mod columns;
pub mod contact_area;
pub mod fabric;
pub mod flow;
pub mod fourier;
pub mod fourth;
pub mod frame;
pub mod histogram;
pub mod link;
pub mod obliquity;
pub mod polygon;
pub mod profile;
pub mod redundancy;
pub mod reference;
pub mod region;
pub mod regional;
pub mod rose;
pub mod sample;
pub mod strain;
pub mod stress;
pub mod survey;
pub mod tensor;
pub mod wall_force;

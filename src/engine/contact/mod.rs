//! Contact laws: pure functions of named quantities, one file each, put together at compile time.
//!
//! A law sees a [`Touch`] and its own memory; it knows no world, no wall, no particle. A
//! [`law::Contact`] is a normal, a tangential, a rolling and a dashpot part; `pass` runs one kind
//! of contact over the list in one monomorphised loop. Each part declares its memory as an
//! associated type, so a scene without friction stores none.

pub mod bonded;
pub mod book;
pub mod card;
mod columns;
pub mod dashpot;
pub mod diagram;
pub mod exact;
mod geometry;
pub mod hertz;
pub mod hertz_mindlin;
mod history;
pub mod incremental_hertz;
pub mod inner;
mod kernel;
pub mod law;
pub mod laws;
pub mod linear;
mod memories;
mod memory;
pub mod mindlin_deresiewicz;
mod numbers;
pub mod parts;
pub(in crate::engine) mod pass;
mod plain;
pub mod quantities;
pub mod rolling;
pub mod slipped;
pub mod traction;
pub mod two_reversals;

pub use law::Law;
pub use parts::{Normal, Rolling, Tangential, Viscosity};
pub use quantities::{Basis, Load, Reaction, Roll, Shear, Stiffness, Touch};

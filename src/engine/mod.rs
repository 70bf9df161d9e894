//! The engine: particles, walls, contacts and the cycle.
//!
//! It knows no screen, file, clock or text format. [`setup`] says what a world is built from,
//! [`world`] is the state, [`step`] the cycle, readable from top to bottom.

pub mod auto_step;
pub mod bound;
pub mod boundary;
pub mod bytes;
pub mod contact;
pub mod contact_report;
pub mod edit;
mod extent;
pub mod fault;
mod growth;
pub mod hash;
mod keep;
mod lanes;
pub mod ledger;
mod lost;
pub mod motion;
pub mod neighbours;
pub mod observe;
mod origin;
mod packing;
pub mod pair;
pub mod particles;
pub mod phase;
pub mod plan;
pub mod restart;
mod rows;
pub mod setup;
mod shares;
pub mod step;
pub mod threads;
pub mod time_step;
pub mod traffic;
pub mod wall;
pub mod wall_contact;
pub mod world;

pub use fault::Fault;
pub use lanes::Isa;
pub use world::World;

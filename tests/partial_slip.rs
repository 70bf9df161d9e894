//! The exact law of contacts with partial slip against closed forms, an independent solution, energy
//! and its own convergence.

#[path = "partial_slip/annuli.rs"]
mod annuli;
#[path = "partial_slip/cycles.rs"]
mod cycles;
#[path = "partial_slip/energy.rs"]
mod energy;
#[path = "partial_slip/histories.rs"]
mod histories;
#[path = "partial_slip/impacts.rs"]
mod impacts;
#[path = "partial_slip/nested.rs"]
mod nested;
#[path = "partial_slip/rig.rs"]
mod rig;

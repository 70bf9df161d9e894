//! Randall's two-reversal law and his summed Hertz force: against closed forms, against an exact
//! solver, against the known results of the corrected law, and against each of its misprints.

mod common;

#[path = "two_reversals/ball_1989.rs"]
mod ball_1989;
#[path = "two_reversals/constant_load.rs"]
mod constant_load;
#[path = "two_reversals/energy.rs"]
mod energy;
#[path = "two_reversals/gain.rs"]
mod gain;
#[path = "two_reversals/histories.rs"]
mod histories;
#[path = "two_reversals/impact.rs"]
mod impact;
#[path = "two_reversals/memory_diagram.rs"]
mod memory_diagram;
#[path = "two_reversals/misprints.rs"]
mod misprints;
#[path = "two_reversals/spheres.rs"]
mod spheres;
#[path = "two_reversals/summed_hertz.rs"]
mod summed_hertz;
#[path = "two_reversals/turned.rs"]
mod turned;

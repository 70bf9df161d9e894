//! Measures against packings whose stress, fabric and porosity are known, and against each other.

#[path = "measures/columns.rs"]
mod columns;
#[path = "measures/equilibrium.rs"]
mod equilibrium;
#[path = "measures/lattices.rs"]
mod lattices;
#[path = "measures/packing.rs"]
mod packing;
#[path = "measures/regions.rs"]
mod regions;

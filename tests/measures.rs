//! Measures against packings whose stress, fabric and porosity are known, and against each other.

#[path = "measures/bearing.rs"]
mod bearing;
#[path = "measures/changes.rs"]
mod changes;
#[path = "measures/classes.rs"]
mod classes;
#[path = "measures/columns.rs"]
mod columns;
#[path = "measures/equilibrium.rs"]
mod equilibrium;
#[path = "measures/exports.rs"]
mod exports;
#[path = "measures/lattices.rs"]
mod lattices;
#[path = "measures/motion.rs"]
mod motion;
#[path = "measures/packing.rs"]
mod packing;
#[path = "measures/polygons.rs"]
mod polygons;
#[path = "measures/profiles.rs"]
mod profiles;
#[path = "measures/regions.rs"]
mod regions;
#[path = "measures/sights.rs"]
mod sights;
#[path = "measures/sliding.rs"]
mod sliding;
#[path = "measures/surveys.rs"]
mod surveys;
#[path = "measures/waves.rs"]
mod waves;

//! Runs about runs: presets against their expectations.

pub mod verify;

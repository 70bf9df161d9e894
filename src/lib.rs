//! Ballast: two-dimensional discrete element simulation of granular material.
//!
//! The crate is one library and one binary. Modules depend on each other in one direction only,
//! and `tests/tidy.rs` holds them to it:
//!
//! `main -> cli -> {tui, study} -> session -> {scene, record} -> language -> control -> measure -> engine`

pub mod control;
pub mod engine;
pub mod language;
pub mod measure;
pub mod record;
pub mod scene;
pub mod session;
pub mod study;
pub mod tui;

pub mod cli;

//! What is read off a world: it reads, never changes.

pub mod columns;

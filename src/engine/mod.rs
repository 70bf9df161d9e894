//! The engine: particles, walls, contacts and the cycle. Knows no screen, file, clock or text.

pub mod setup;

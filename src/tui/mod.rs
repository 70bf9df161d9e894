//! The workbench: a screen over a running session.
//!
//! The screen never holds a world. A worker thread owns the session; the screen draws immutable
//! frames (the newest wins) and sends orders. What a key does is a row of [`keys::KEYS`], what can
//! be looked at a row of [`panes::PANES`]; help derives from both.

pub mod app;
pub mod completion;
pub mod dots;
pub mod events;
pub mod farewell;
pub mod keys;
pub mod layout;
pub mod link;
pub mod look;
pub mod painter;
pub mod panes;
pub mod plain;
pub mod plot;
pub mod prompt;
pub mod scale;
pub mod series;
pub mod terminal;
pub mod trail;
pub mod view;
pub mod workbench;
pub mod write;

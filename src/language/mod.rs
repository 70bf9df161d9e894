//! The console language: what is typed at the prompt, listed in the stages of a preset and kept in
//! a journal is the same line of text, and becomes the same [`Command`].
//!
//! The language knows names and grammar. It never sees a world: whether wall `left` exists is
//! asked of a [`Known`], and what a command does is the session's business.

pub mod command;
pub mod complete;
pub mod definition;
pub mod expression;
pub mod known;
pub mod list;
pub mod mistake;
pub mod name;
pub mod number;
pub mod observable;
pub mod place;
pub mod verbs;
pub mod words;

pub use command::Command;
pub use definition::{Definition, Definitions};
pub use expression::{Expression, Quantity, Term};
pub use known::Known;
pub use list::{COMMANDS, Card, reference_table};
pub use mistake::Mistake;
pub use observable::Observable;

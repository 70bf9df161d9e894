//! a journal is the same line of text, and becomes the same [`Command`].
//!
//! The language knows names and grammar. It never sees a world: whether wall `left` exists is

pub mod expression;
pub mod mistake;
pub mod name;
pub mod number;

pub use expression::{Expression, Quantity, Term};
pub use mistake::Mistake;

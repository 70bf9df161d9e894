//! The verbs: one file for each or for a close family, with its card, what it is as data and how
//! it is read and written.

pub mod bond;
pub mod boundary;
pub mod con1;
pub mod create;
pub mod cycle;
pub mod damp;
pub mod delete;
pub mod export;
pub mod frac;
pub mod friction;
pub mod generate;
pub mod gravity;
pub mod grow;
pub mod help;
pub mod history;
pub mod inspect;
pub mod journal;
pub mod particle;
pub mod print;
pub mod property;
pub mod quit;
pub mod reference;
pub mod rotation;
pub mod save;
pub mod servo;
pub mod solve;
pub mod strain;
pub mod wall;
pub mod zero;

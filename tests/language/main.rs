//! The console language through its public face.

mod lines;
mod round_trip;

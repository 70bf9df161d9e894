//! A journal replays, and a checkpoint goes on, to the same bits.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

mod acts;
mod faults;
mod places;
mod random;
mod repetition;
mod scene;

//! Runs about runs: presets against their expectations, and speed against error.
//!
//! A study runs one experiment in several variants ([`plan`], [`variant`]), each over the same
//! simulated time ([`pace`]), once for what it gives ([`trace`]) and repeatedly for how long it
//! takes ([`timing`]). What comes out is judged by the questions that were asked ([`question`],
//! [`error`], [`replies`]) and laid out as numbers ([`outcome`], [`table`]) and as a picture
//! ([`picture`]). [`limits`] searches the largest stable step instead. [`ensemble`] runs a scene
//! with many seeds; [`plot`] draws what histories and ensembles hold. [`bench`] times standard scenes.

pub mod bench;
pub mod ensemble;
pub mod error;
pub mod front;
pub mod limits;
pub mod outcome;
pub mod pace;
pub mod picture;
pub mod plan;
pub mod plot;
pub mod question;
pub mod replies;
pub mod stability;
pub mod table;
pub mod timing;
pub mod trace;
pub mod trial;
pub mod variant;
pub mod verify;
mod watch;

use crate::session::Session;

/// What is being run, for whoever shows progress.
pub struct Beat<'a> {
    /// Name of the variant.
    pub name: &'a str,
    /// Runs that are done.
    pub done: usize,
    /// Runs that are known to be needed.
    pub of: usize,
    /// The run.
    pub session: &'a Session,
}

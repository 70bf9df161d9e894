//! The time before a run looks at signals: while its preset is read and its particles are placed.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::cli::output::complain;
use crate::record::interrupt::Interrupt;

/// How long somebody who ends a run has to wait while its preset is read and its particles are placed.
const PATIENCE: Duration = Duration::from_secs(1);

/// A preset is being read, and nobody looks whether a signal has come.
pub(super) struct Reading(Arc<AtomicBool>);

impl Reading {
    /// From now on a signal that finds no hearing ends the process: there is nothing to save.
    pub(super) fn begin(interrupt: &Interrupt) -> Self {
        let reading = Arc::new(AtomicBool::new(true));
        let (flag, interrupt) = (Arc::clone(&reading), interrupt.clone());
        std::thread::spawn(move || {
            while flag.load(Ordering::Relaxed) {
                let caught = interrupt.caught();
                std::thread::sleep(if caught.is_some() {
                    PATIENCE
                } else {
                    PATIENCE / 10
                });
                if let (Some(signal), true) = (caught, flag.load(Ordering::Relaxed)) {
                    complain(&format!(
                        "{}: ended while the preset was read; nothing was begun",
                        signal.name
                    ));
                    std::process::exit(i32::from(signal.exit_status()));
                }
            }
        });
        Self(reading)
    }

    /// Somebody looks again.
    pub(super) fn end(&self) {
        self.0.store(false, Ordering::Relaxed);
    }
}

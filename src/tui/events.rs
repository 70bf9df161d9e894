//! Waiting for keys, for the worker and for signals, without ever spinning.
//!
//! Reading keys from a terminal that has gone away would spin: so the terminal is polled first, and
//! a hang-up ends the wait.

use std::io::Read;
use std::os::unix::net::UnixStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use signal_hook::consts::{SIGCONT, SIGTSTP};

use rustix::event::{PollFd, PollFlags, Timespec, poll};

/// What ended a wait.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Woken {
    /// Keys are there.
    pub keys: bool,
    /// The terminal is gone.
    pub gone: bool,
}

/// Waits until keys come, the worker knocks, a signal arrives or the time is over.
pub fn wait(worker: &mut UnixStream, patience: Duration) -> Woken {
    let stdin = rustix::stdio::stdin();
    let mut fds = [
        PollFd::new(&stdin, PollFlags::IN),
        PollFd::new(worker, PollFlags::IN),
    ];
    let patience = Timespec {
        tv_sec: patience.as_secs() as i64,
        tv_nsec: i64::from(patience.subsec_nanos()),
    };
    // An interrupted wait is a signal, which the caller looks for anyway.
    let ready = poll(&mut fds, Some(&patience)).unwrap_or(0) > 0;
    let on = |fd: &PollFd<'_>, flags: PollFlags| ready && fd.revents().intersects(flags);
    let bad = PollFlags::HUP | PollFlags::ERR | PollFlags::NVAL;
    let woken = Woken {
        keys: on(&fds[0], PollFlags::IN),
        gone: on(&fds[0], bad),
    };
    if on(&fds[1], PollFlags::IN) {
        // Empties the pipe; it does not block.
        let mut knocks = [0; 256];
        while matches!(worker.read(&mut knocks), Ok(n) if n == knocks.len()) {}
    }
    woken
}

/// Signals of job control, as flags.
#[derive(Debug, Clone)]
pub struct JobControl {
    stop: Arc<AtomicBool>,
    resumed: Arc<AtomicBool>,
}

impl JobControl {
    /// Catches SIGTSTP and SIGCONT.
    pub fn install() -> std::io::Result<Self> {
        let control = Self {
            stop: Arc::default(),
            resumed: Arc::default(),
        };
        signal_hook::flag::register(SIGTSTP, Arc::clone(&control.stop))?;
        signal_hook::flag::register(SIGCONT, Arc::clone(&control.resumed))?;
        Ok(control)
    }

    /// Whether somebody else asked us to stop.
    pub fn asked_to_stop(&self) -> bool {
        self.stop.swap(false, Ordering::SeqCst)
    }

    /// Whether we were continued.
    pub fn was_resumed(&self) -> bool {
        self.resumed.swap(false, Ordering::SeqCst)
    }

    /// Stops the process, and whoever started it in the same job, until it is continued.
    pub fn stop_now() {
        // If this fails nothing has happened, and the screen comes back.
        let _ = rustix::process::kill_current_process_group(rustix::process::Signal::STOP);
    }
}

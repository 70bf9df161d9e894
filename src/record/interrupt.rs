//! Signals as a flag: a run looks at it between cycles and ends by itself, with everything saved.

use std::fs;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXFSZ};
use signal_hook::flag;

/// A signal that asks the program to end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Signal {
    /// Name, as `kill -l` has it.
    pub name: &'static str,
    /// Number [-].
    pub number: i32,
}

/// The signals that are caught.
pub const SIGNALS: [Signal; 4] = [
    Signal {
        name: "SIGINT",
        number: SIGINT,
    },
    Signal {
        name: "SIGTERM",
        number: SIGTERM,
    },
    Signal {
        name: "SIGHUP",
        number: SIGHUP,
    },
    // Left to itself it would end the process with the terminal still raw.
    Signal {
        name: "SIGQUIT",
        number: SIGQUIT,
    },
];

impl Signal {
    /// Status a program ends with that ended because of it.
    pub fn exit_status(self) -> u8 {
        128 + self.number as u8
    }
}

/// Whether a signal has come. Copies look at the same flag.
#[derive(Debug, Clone)]
pub struct Interrupt {
    /// Number of the last signal caught, 0 for none.
    number: Arc<AtomicUsize>,
}

impl Interrupt {
    /// Catches [`SIGNALS`] for the rest of the process. A second SIGINT ends it at once, for whoever
    /// presses Ctrl-C again because saving takes too long. A signal that the parent has told us to
    /// ignore stays ignored: that is how `nohup` keeps runs alive.
    pub fn install() -> io::Result<Self> {
        let number = Arc::new(AtomicUsize::new(0));
        let ignored = ignored_signals();
        for signal in SIGNALS {
            if ignored & (1 << (signal.number - 1)) != 0 {
                continue;
            }
            if signal.number == SIGINT {
                let again = Arc::new(AtomicBool::new(false));
                // Actions run in this order, so the first SIGINT only arms the second.
                flag::register_conditional_default(SIGINT, Arc::clone(&again))?;
                flag::register(SIGINT, again)?;
            }
            flag::register_usize(signal.number, Arc::clone(&number), signal.number as usize)?;
        }
        // Caught so that a file at the limit of `ulimit -f` fails to be written like one on a full
        // disk, instead of ending the process.
        flag::register(SIGXFSZ, Arc::default())?;
        Ok(Self { number })
    }

    /// The signal that has come, if any. Costs one load: may be asked in every cycle.
    pub fn caught(&self) -> Option<Signal> {
        let number = self.number.load(Ordering::Relaxed);
        SIGNALS
            .into_iter()
            .find(|signal| signal.number as usize == number)
    }
}

/// The set of signals this process was started to ignore, bit k-1 for number k; empty where the
/// system does not tell.
fn ignored_signals() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    ignored_in(&status)
}

fn ignored_in(status: &str) -> u64 {
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok())
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use std::os::unix::process::ExitStatusExt;

    use signal_hook::low_level::raise;

    use super::super::own_process;
    use super::*;

    #[test]
    fn each_signal_is_seen() {
        let name = "interrupt::tests::each_signal_is_seen";
        if own_process::value().is_none() {
            own_process::assert_passed(&own_process::run(name, "", "1"));
            return;
        }
        // What tests under nohup or in the background were started to ignore stays ignored.
        let ignored = ignored_signals();
        for signal in SIGNALS {
            let seen = ignored & (1 << (signal.number - 1)) == 0;
            let interrupt = Interrupt::install().unwrap();
            assert_eq!(interrupt.caught(), None);
            raise(signal.number).unwrap();
            assert_eq!(interrupt.clone().caught(), seen.then_some(signal));
        }
    }

    #[test]
    fn a_second_ctrl_c_ends_the_process() {
        let name = "interrupt::tests::a_second_ctrl_c_ends_the_process";
        if own_process::value().is_none() {
            let output = own_process::run(name, "", "1");
            // Tests in the background of a shell are started to ignore it.
            let ignored = ignored_signals() & (1 << (SIGINT - 1)) != 0;
            let ended = (!ignored).then_some(SIGINT);
            assert_eq!(output.status.signal(), ended);
            return;
        }
        let seen = ignored_signals() & (1 << (SIGINT - 1)) == 0;
        let interrupt = Interrupt::install().unwrap();
        raise(SIGINT).unwrap();
        assert_eq!(interrupt.caught(), seen.then_some(SIGNALS[0]));
        raise(SIGINT).unwrap();
    }

    #[test]
    fn nohup_is_respected() {
        let name = "interrupt::tests::nohup_is_respected";
        if own_process::value().is_none() {
            own_process::assert_passed(&own_process::run(name, "trap '' HUP;", "1"));
            return;
        }
        let interrupt = Interrupt::install().unwrap();
        raise(SIGHUP).unwrap();
        assert_eq!(interrupt.caught(), None);
        raise(SIGTERM).unwrap();
        assert_eq!(interrupt.caught(), Some(SIGNALS[1]));
    }

    #[test]
    fn statuses_follow_the_shell() {
        assert_eq!(SIGNALS.map(Signal::exit_status), [130, 143, 129, 131]);
    }

    #[test]
    fn the_mask_of_ignored_signals_is_read() {
        assert_eq!(ignored_in("Name:\tx\nSigIgn:\t0000000000001001\n"), 0x1001);
        assert_eq!(ignored_in("nothing"), 0);
    }
}

//! The real program in a pseudo-terminal, and the screen it draws there.

use std::io::{Read, Write};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};

/// Longest wait for anything. It only ends a test that hangs: the machine may be very busy.
const PATIENCE: Duration = Duration::from_secs(300);

/// The terminal is given back: what the program sends then.
pub(crate) const LEAVES: &str = "\u{1b}[?1049l";

/// What the prompt's line says while nobody types there.
const NO_PROMPT: &str = "press : to type a command";

/// A program in a terminal.
pub(crate) struct Pty {
    master: Option<Box<dyn MasterPty + Send>>,
    writer: Option<Box<dyn Write + Send>>,
    pub(crate) child: Box<dyn Child + Send + Sync>,
    state: Arc<Mutex<State>>,
    reader: JoinHandle<()>,
    /// Where its runs are kept.
    pub(crate) home: tempfile::TempDir,
}

struct State {
    /// The reader's end of the terminal is to be closed too.
    hung_up: bool,
    parser: vt100::Parser,
    bytes: Vec<u8>,
}

fn size(columns: u16, rows: u16) -> PtySize {
    PtySize {
        rows,
        cols: columns,
        pixel_width: 0,
        pixel_height: 0,
    }
}

impl Pty {
    /// Starts `ballast` with these arguments in a terminal of this size.
    pub(crate) fn start(columns: u16, rows: u16, arguments: &[&str]) -> Self {
        let pair = native_pty_system().openpty(size(columns, rows)).unwrap();
        let home = tempfile::tempdir().unwrap();
        let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_ballast"));
        command.args(arguments);
        command.env_clear();
        for (name, value) in [
            ("TERM", "xterm-256color"),
            ("LANG", "C.UTF-8"),
            ("PATH", "/usr/bin:/bin"),
        ] {
            command.env(name, value);
        }
        command.env("XDG_STATE_HOME", home.path());
        command.cwd(home.path());
        let child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let (width, height) = (columns.try_into().unwrap(), rows.try_into().unwrap());
        let parser = vt100::Parser::new(height, width, 0);
        let state = Arc::new(Mutex::new(State {
            hung_up: false,
            parser,
            bytes: Vec::new(),
        }));
        let mut reader = pair.master.try_clone_reader().unwrap();
        let shared = Arc::clone(&state);
        let reader = std::thread::spawn(move || {
            let mut piece = vec![0; 65536];
            while let Ok(n) = reader.read(&mut piece) {
                if n == 0 {
                    break;
                }
                let mut state = shared.lock().unwrap();
                if state.hung_up {
                    break;
                }
                state.parser.process(&piece[..n]);
                state.bytes.extend_from_slice(&piece[..n]);
            }
        });
        let writer = Some(pair.master.take_writer().unwrap());
        Self {
            master: Some(pair.master),
            writer,
            child,
            state,
            reader,
            home,
        }
    }

    /// What the screen shows.
    pub(crate) fn screen(&self) -> String {
        self.state.lock().unwrap().parser.screen().contents()
    }

    /// Bytes that came so far.
    pub(crate) fn bytes(&self) -> usize {
        self.state.lock().unwrap().bytes.len()
    }

    /// Whether these bytes came.
    pub(crate) fn sent(&self, text: &str) -> bool {
        let state = self.state.lock().unwrap();
        state
            .bytes
            .windows(text.len())
            .any(|window| window == text.as_bytes())
    }

    /// Types.
    pub(crate) fn keys(&mut self, text: &str) {
        let writer = self.writer.as_mut().unwrap();
        writer.write_all(text.as_bytes()).unwrap();
        writer.flush().unwrap();
    }

    /// Waits until something is so.
    pub(crate) fn until(&self, what: &str, mut is_so: impl FnMut(&Self) -> bool) {
        let start = Instant::now();
        while !is_so(self) {
            assert!(
                start.elapsed() < PATIENCE,
                "waiting for {what}, the screen shows\n{}",
                self.screen()
            );
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Waits until a text is on the screen.
    pub(crate) fn shows(&self, text: &str) {
        self.until(text, |pty| pty.screen().contains(text));
    }

    /// The cycle that the screen shows.
    pub(crate) fn cycle(&self) -> Option<u64> {
        let screen = self.screen();
        let (_, number) = screen.split_once("cycle ")?;
        // Thousands are set apart by one blank, the number by two.
        let number = number.split("  ").next()?;
        number.replace(' ', "").parse().ok()
    }

    /// Waits until at least so many cycles are done.
    pub(crate) fn reaches(&self, cycle: u64) {
        self.until(&format!("cycle {cycle}"), |pty| pty.cycle() >= Some(cycle));
    }

    /// Waits until nothing has been sent for a while.
    pub(crate) fn settles(&self) {
        let mut last = (self.bytes(), Instant::now());
        self.until("nothing", |pty| {
            if pty.bytes() != last.0 {
                last = (pty.bytes(), Instant::now());
            }
            last.1.elapsed() > Duration::from_millis(500)
        });
    }

    /// Leaves the prompt. What follows must not come before Esc was read: together they would be
    /// another key.
    pub(crate) fn leave_prompt(&mut self) {
        self.keys("\u{1b}");
        self.shows(NO_PROMPT);
    }

    /// Changes the size of the terminal.
    pub(crate) fn resize(&mut self, columns: u16, rows: u16) {
        let (width, height) = (columns.try_into().unwrap(), rows.try_into().unwrap());
        self.state
            .lock()
            .unwrap()
            .parser
            .screen_mut()
            .set_size(height, width);
        self.master
            .as_ref()
            .unwrap()
            .resize(size(columns, rows))
            .unwrap();
    }

    /// Closes the terminal under the program.
    pub(crate) fn hang_up(&mut self) {
        self.state.lock().unwrap().hung_up = true;
        self.writer = None;
        self.master = None;
    }

    /// Sends a signal.
    pub(crate) fn signal(&self, signal: rustix::process::Signal) {
        rustix::process::kill_process(self.pid(), signal).unwrap();
    }

    fn pid(&self) -> rustix::process::Pid {
        let pid = self.child.process_id().unwrap();
        rustix::process::Pid::from_raw(pid as i32).unwrap()
    }

    /// State letter of the process, as `ps` shows it.
    pub(crate) fn process_state(&self) -> char {
        let text = std::fs::read_to_string(format!("/proc/{}/stat", self.pid().as_raw_nonzero()));
        let text = text.unwrap_or_default();
        text.rsplit(") ")
            .next()
            .and_then(|rest| rest.chars().next())
            .unwrap_or('?')
    }

    /// Processor time used so far [s].
    pub(crate) fn processor_time(&self) -> f64 {
        let text = std::fs::read_to_string(format!("/proc/{}/stat", self.pid().as_raw_nonzero()));
        let text = text.unwrap_or_default();
        let fields: Vec<&str> = text.rsplit(") ").next().unwrap_or("").split(' ').collect();
        let ticks = |k: usize| {
            fields
                .get(k)
                .and_then(|f| f.parse::<f64>().ok())
                .unwrap_or(0.0)
        };
        (ticks(11) + ticks(12)) / 100.0
    }

    /// Waits for the end and the last bytes; the exit status.
    pub(crate) fn end(&mut self) -> u32 {
        let start = Instant::now();
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                self.until("the last bytes", |pty| pty.reader.is_finished());
                return status.exit_code();
            }
            if start.elapsed() > PATIENCE {
                let screen = self.screen();
                drop(self.child.kill());
                panic!("it does not end; the screen shows\n{screen}");
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Path of the file with this ending that the run keeps.
    pub(crate) fn kept(&self, ending: &str) -> std::path::PathBuf {
        let runs = self.home.path().join("ballast/runs");
        let run = std::fs::read_dir(runs)
            .unwrap()
            .next()
            .unwrap()
            .unwrap()
            .path();
        run.join(format!("run.{ending}"))
    }
}

//! The terminal: taken over, given back, whatever happens.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use crossterm::terminal::{disable_raw_mode, enable_raw_mode};
use ratatui::layout::Rect;

/// Alternate screen, bracketed paste, cursor hidden.
const ENTER: &str = "\x1b[?1049h\x1b[?2004h\x1b[?25l";

/// The reverse, in reverse order, and whatever a half-drawn frame left behind.
const LEAVE: &str = "\x1b[?2026l\x1b[0m\x1b[?2004l\x1b[?25h\x1b[?1049l";

/// Whether the terminal is ours, for the panic hook.
static TAKEN: AtomicBool = AtomicBool::new(false);

/// The terminal, taken over until dropped.
pub struct Terminal {
    /// Bytes written so far.
    pub written: u64,
}

impl Terminal {
    /// Takes the terminal over. A panic in any thread gives it back before it is reported.
    pub fn take() -> std::io::Result<Self> {
        let before = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            release();
            before(panic);
        }));
        let mut terminal = Self { written: 0 };
        terminal.enter()?;
        Ok(terminal)
    }

    /// Takes it over, again after it was released.
    pub fn enter(&mut self) -> std::io::Result<()> {
        enable_raw_mode()?;
        TAKEN.store(true, Ordering::SeqCst);
        self.send(ENTER)
    }

    /// Writes at once.
    pub fn send(&mut self, text: &str) -> std::io::Result<()> {
        if !TAKEN.load(Ordering::SeqCst) {
            // A panic has given it back: what it says must not be painted over.
            return Ok(());
        }
        let mut out = std::io::stdout().lock();
        out.write_all(text.as_bytes())?;
        out.flush()?;
        self.written += text.len() as u64;
        Ok(())
    }

    /// Its size; `None` when it has none, as a terminal that has gone away.
    pub fn size() -> Option<Rect> {
        let size = rustix::termios::tcgetwinsize(rustix::stdio::stdout()).ok()?;
        let area = Rect::new(0, 0, size.ws_col, size.ws_row);
        (!area.is_empty()).then_some(area)
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        release();
    }
}

/// Gives the terminal back; errors do not matter any more.
pub fn release() {
    if TAKEN.swap(false, Ordering::SeqCst) {
        let mut out = std::io::stdout().lock();
        drop(out.write_all(LEAVE.as_bytes()).and_then(|()| out.flush()));
        drop(disable_raw_mode());
    }
}

/// Whether there is a terminal to work with.
pub fn is_there() -> bool {
    std::io::stdin().is_terminal() && std::io::stdout().is_terminal()
}

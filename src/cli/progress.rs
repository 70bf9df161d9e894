//! Progress of long headless work: a bar on a terminal, plain lines otherwise, nothing in the first
//! second.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::output::tell;
use crate::session::Session;

/// Plain lines come this often.
pub(super) const LINES: Duration = Duration::from_secs(10);

/// Runs shorter than this show nothing.
pub(super) const PATIENCE: Duration = Duration::from_secs(1);

/// Shows how far a session is.
pub(super) struct Progress {
    start: Instant,
    first_cycle: u64,
    /// Cycle at which the run stops by order.
    stop: Option<u64>,
    quiet: bool,
    /// What comes before the place.
    title: String,
    bar: Option<ProgressBar>,
    next_line: Duration,
}

impl Progress {
    /// For a session that stops at `stop` at the latest.
    pub(super) fn new(session: &Session, stop: Option<u64>, quiet: bool) -> Self {
        Self {
            start: Instant::now(),
            first_cycle: session.world().cycle_number(),
            stop,
            quiet,
            title: String::new(),
            bar: None,
            next_line: LINES,
        }
    }

    /// For a session that prepares a sample.
    pub(super) fn of_sample(session: &Session, quiet: bool) -> Self {
        Self {
            title: format!("preparing {}  ", session.scene().name),
            ..Self::new(session, None, quiet)
        }
    }

    /// Called between batches.
    pub(super) fn show(&mut self, session: &Session) {
        let elapsed = self.start.elapsed();
        if self.quiet || elapsed < PATIENCE {
            return;
        }
        let cycle = session.world().cycle_number();
        let rate = (cycle - self.first_cycle) as f64 / elapsed.as_secs_f64();
        let end = end(session, self.stop);
        let place = format!("{}{}", self.title, place(session));
        if std::io::stderr().is_terminal() {
            let bar = self.bar.get_or_insert_with(|| {
                let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
                bar.set_style(style());
                bar
            });
            if let Some(end) = end {
                bar.set_length(end.saturating_sub(self.first_cycle));
            }
            bar.set_position(cycle - self.first_cycle);
            bar.set_message(format!("{place}cycle {cycle}  {rate:.0}/s"));
        } else if elapsed >= self.next_line {
            self.next_line = elapsed + LINES;
            let rest = end.map_or_else(String::new, |end| {
                let seconds = (end.saturating_sub(cycle)) as f64 / rate;
                let percent = 100.0 * cycle as f64 / end as f64;
                format!("  {percent:.0} %, {seconds:.0} s to go at most")
            });
            tell(&format!("{place}cycle {cycle}  {rate:.0} cycles/s{rest}"));
        }
    }

    /// Takes the bar away.
    pub(super) fn clear(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

/// How bars look.
pub(super) fn style() -> ProgressStyle {
    let style = ProgressStyle::with_template("{msg}  {wide_bar} {percent}%  eta {eta}");
    style.unwrap_or_else(|_| ProgressStyle::default_bar())
}

/// Where a session is: its stage and how many there are.
pub(super) fn place(session: &Session) -> String {
    let (stage, stages) = session.stage_number();
    match session.stage_name() {
        "" => String::new(),
        name => format!("{name} {}/{stages}  ", stage + 1),
    }
}

/// The cycle at which a session that stops at `stop` is over at the latest, if it is known.
pub(super) fn end(session: &Session, stop: Option<u64>) -> Option<u64> {
    let (stage, _) = session.stage_number();
    let done = session.world().cycle_number() - session.stage_cycle();
    let stages = session.scene().stages.get(stage..).unwrap_or_default();
    let rest: Option<u64> = stages.iter().map(|stage| stage.max_cycles).sum();
    let by_stages = rest
        .filter(|_| !stages.is_empty())
        .map(|cycles| done + cycles);
    match (stop, by_stages) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

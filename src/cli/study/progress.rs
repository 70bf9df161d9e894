//! Progress of many runs: a bar on a terminal, plain lines otherwise, nothing in the first second.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::cli::output::tell;
use crate::cli::progress::{LINES, PATIENCE};
use crate::study::Beat;

/// Shows how far a study is.
pub(super) struct Progress {
    start: Instant,
    quiet: bool,
    bar: Option<ProgressBar>,
    next_line: Duration,
}

impl Progress {
    pub(super) fn new(quiet: bool) -> Self {
        Self {
            start: Instant::now(),
            quiet,
            bar: None,
            next_line: LINES,
        }
    }

    /// Called between batches.
    pub(super) fn show(&mut self, beat: &Beat<'_>) {
        let elapsed = self.start.elapsed();
        if self.quiet || elapsed < PATIENCE {
            return;
        }
        let cycle = beat.session.world().cycle_number();
        let place = match beat.session.stage_name() {
            "" => format!("{}  cycle {cycle}", beat.name),
            stage => format!("{}  {stage}  cycle {cycle}", beat.name),
        };
        if std::io::stderr().is_terminal() {
            let bar = self.bar.get_or_insert_with(|| {
                let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
                let style = ProgressStyle::with_template("{msg}  {wide_bar} {pos} of {len} runs");
                bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
                bar
            });
            bar.set_length(beat.of.max(beat.done) as u64);
            bar.set_position(beat.done as u64);
            bar.set_message(place);
        } else if elapsed >= self.next_line {
            self.next_line = elapsed + LINES;
            let of = match beat.of {
                0 => String::new(),
                of => format!(" of {of}"),
            };
            tell(&format!("run {}{of}: {place}", beat.done + 1));
        }
    }

    /// Takes the bar away.
    pub(super) fn clear(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

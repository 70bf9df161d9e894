//! Progress of the runs of an ensemble: one bar or line for all of them, nothing in the first
//! second.

use std::collections::{BTreeMap, BTreeSet};
use std::io::IsTerminal;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget};

use super::output::tell;
use super::progress::{LINES, PATIENCE, end, place, style};
use crate::session::Session;

/// A bar is drawn anew so often at most.
const FRAME: Duration = Duration::from_millis(100);

/// Runs that are told apart; of more only the number is told.
const NAMED: usize = 4;

/// Length of the bar for each run.
const UNIT: u64 = 1000;

/// Shows how far all runs are. Threads share it.
pub(super) struct Crowd {
    start: Instant,
    title: String,
    seeds: Vec<u64>,
    /// Cycle at which runs stop by order.
    stop: Option<u64>,
    quiet: bool,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    running: BTreeMap<u64, Run>,
    done: BTreeSet<u64>,
    bar: Option<ProgressBar>,
    /// When something is shown next.
    next: Duration,
}

struct Run {
    text: String,
    /// Part of it that is done.
    share: f64,
}

impl Crowd {
    /// For the runs of these seeds, that stop at `stop` at the latest.
    pub(super) fn new(title: &str, seeds: Vec<u64>, stop: Option<u64>, quiet: bool) -> Self {
        Self {
            start: Instant::now(),
            title: title.to_owned(),
            seeds,
            stop,
            quiet,
            state: Mutex::new(State {
                next: if std::io::stderr().is_terminal() {
                    PATIENCE
                } else {
                    LINES
                },
                ..State::default()
            }),
        }
    }

    /// Called between batches of a run.
    pub(super) fn show(&self, session: &Session) {
        if session.is_finished() {
            return self.ended(session.scene().seed);
        }
        let cycle = session.world().cycle_number();
        let share = end(session, self.stop).map_or(0.0, |end| cycle as f64 / end as f64);
        let text = format!("{}cycle {cycle}", place(session));
        let mut state = self.state();
        let run = Run { text, share };
        state.running.insert(session.scene().seed, run);
        self.draw(&mut state);
    }

    /// Called between batches of the run that prepares the sample of a seed.
    pub(super) fn prepare(&self, seed: u64, session: &Session) {
        let text = format!("preparing {}  {}", session.scene().name, place(session));
        let mut state = self.state();
        state.running.insert(seed, Run { text, share: 0.0 });
        self.draw(&mut state);
    }

    /// A run has ended, in whatever way.
    pub(super) fn ended(&self, seed: u64) {
        let mut state = self.state();
        state.running.remove(&seed);
        state.done.insert(seed);
    }

    /// Takes the bar away.
    pub(super) fn clear(&self) {
        if let Some(bar) = self.state().bar.take() {
            bar.finish_and_clear();
        }
    }

    /// A run that panics with the lock leaves nothing half done.
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn draw(&self, state: &mut State) {
        let elapsed = self.start.elapsed();
        if self.quiet || elapsed < state.next {
            return;
        }
        let shares: f64 = state.running.values().map(|run| run.share).sum();
        let share = state.done.len() as f64 + shares;
        let of = self.seeds.len();
        if std::io::stderr().is_terminal() {
            state.next = elapsed + FRAME;
            let text = self.text(state);
            let bar = state.bar.get_or_insert_with(|| {
                let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
                bar.set_style(style());
                bar.set_length(UNIT * of as u64);
                bar
            });
            bar.set_position((UNIT as f64 * share) as u64);
            bar.set_message(text);
        } else {
            state.next = elapsed + LINES;
            let rest = if share > 0.0 {
                let rest = (of as f64 - share) / share * elapsed.as_secs_f64();
                let percent = 100.0 * share / of as f64;
                format!("  {percent:.0} %, {rest:.0} s to go at most")
            } else {
                String::new()
            };
            tell(&format!("{}{rest}", self.text(state)));
        }
    }

    /// Which runs are where.
    fn text(&self, state: &State) -> String {
        let mut text = self.title.clone();
        if self.seeds.len() > 1 {
            text += &format!("  {}/{} seeds done", state.done.len(), self.seeds.len());
        }
        for (seed, run) in state.running.iter().take(NAMED) {
            text += "  ";
            if self.seeds.len() > 1 {
                text += &format!("{seed}: ");
            }
            text += &run.text;
        }
        let more = state.running.len().saturating_sub(NAMED);
        if more > 0 {
            text += &format!("  and {more} more");
        }
        text
    }
}

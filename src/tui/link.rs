//! The line to the terminal: how many bytes it may get, and how often.
//!
//! A terminal behind a slow link takes a megabyte before a write blocks, and then a key is answered
//! a minute later. So frames are dropped, never queued: a token bucket counts bytes really
//! written, and the frame rate follows what the budget allows.

use std::time::{Duration, Instant};

/// Budget and rate.
#[derive(Debug)]
pub struct Link {
    /// Bytes per second allowed; `None`: any number.
    pub budget: Option<f64>,
    /// Frames per second aimed at.
    pub fps: f64,
    /// Bytes that may be written now; negative after a burst.
    tokens: f64,
    filled: Instant,
    drawn: Instant,
    /// Bytes and frames in the present window.
    window: (Instant, u64, u32),
    /// Bytes per second and frames per second, lately.
    pub measured: (f64, f64),
}

/// Rates that can be chosen.
const FPS: [f64; 6] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0];

/// What the environment says about the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Bytes per second.
    pub budget: Option<f64>,
    /// Frames per second.
    pub fps: f64,
}

impl Line {
    /// Local: any number of bytes, ten frames. Over SSH 16 kB/s and five frames: what a thin line
    /// carries, since neither the kernel nor a multiplexer tells how fast the line is. In a local
    /// multiplexer 64 kB/s.
    pub fn from_environment(get: impl Fn(&str) -> Option<String>) -> Self {
        let set = |name: &str| get(name).is_some_and(|value| !value.is_empty());
        let ssh = set("SSH_CONNECTION") || set("SSH_TTY");
        let multiplexer = set("TMUX") || set("STY");
        match (ssh, multiplexer) {
            (true, _) => Self {
                budget: Some(16e3),
                fps: 5.0,
            },
            (false, true) => Self {
                budget: Some(64e3),
                fps: 5.0,
            },
            (false, false) => Self {
                budget: None,
                fps: 10.0,
            },
        }
    }
}

/// Longest wait before the line is looked at again, however slow it is.
const LONGEST: Duration = Duration::from_secs(60);

fn pause(seconds: f64) -> Duration {
    let pause = Duration::try_from_secs_f64(seconds);
    pause.map_or(LONGEST, |pause| pause.min(LONGEST))
}

impl Link {
    /// A line with this budget [bytes/s] and rate [1/s].
    pub fn new(line: Line) -> Self {
        let now = Instant::now();
        Self {
            budget: line.budget,
            fps: line.fps,
            tokens: line.budget.unwrap_or(0.0),
            filled: now,
            drawn: now.checked_sub(Duration::from_secs(1)).unwrap_or(now),
            window: (now, 0, 0),
            measured: (0.0, 0.0),
        }
    }

    /// Time until a frame may be drawn: zero, now.
    pub fn wait(&mut self, now: Instant) -> Duration {
        self.fill(now);
        let beat = pause(1.0 / self.fps);
        let by_rate = beat.saturating_sub(now - self.drawn);
        match self.budget {
            Some(budget) if self.tokens <= 0.0 => by_rate.max(pause(-self.tokens / budget + 0.001)),
            _ => by_rate,
        }
    }

    fn fill(&mut self, now: Instant) {
        if let Some(budget) = self.budget {
            let added = budget * (now - self.filled).as_secs_f64();
            // Half a second's worth may be saved up.
            self.tokens = (self.tokens + added).min(0.5 * budget);
        }
        self.filled = now;
    }

    /// Counts what was written.
    pub fn sent(&mut self, now: Instant, bytes: usize, frame: bool) {
        self.tokens -= bytes as f64;
        self.window.1 += bytes as u64;
        if frame {
            self.drawn = now;
            self.window.2 += 1;
        }
        let elapsed = now - self.window.0;
        if elapsed >= Duration::from_secs(1) {
            let seconds = elapsed.as_secs_f64();
            self.measured = (
                self.window.1 as f64 / seconds,
                f64::from(self.window.2) / seconds,
            );
            self.window = (now, 0, 0);
        }
    }

    /// The next rate up or down.
    pub fn change_fps(&mut self, up: bool) {
        let next = if up {
            FPS.iter().copied().find(|fps| *fps > self.fps)
        } else {
            FPS.iter().rev().copied().find(|fps| *fps < self.fps)
        };
        self.fps = next.unwrap_or(self.fps);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_is_kept_on_average() {
        let mut link = Link::new(Line {
            budget: Some(10e3),
            fps: 20.0,
        });
        let start = Instant::now();
        let (mut now, mut sent) = (start, 0usize);
        while now - start < Duration::from_secs(20) {
            let wait = link.wait(now);
            if wait.is_zero() {
                link.sent(now, 3000, true);
                sent += 3000;
            }
            now += wait.max(Duration::from_millis(1));
        }
        let rate = sent as f64 / 20.0;
        // The first second's savings come on top.
        assert!((9.5e3..10.9e3).contains(&rate), "{rate}");
    }

    #[test]
    fn the_slowest_lines_wait_a_minute_at_a_time() {
        for line in [(None, 1e-20), (Some(1e-20), 10.0), (Some(1e-300), 1e-300)] {
            let (budget, fps) = line;
            let mut link = Link::new(Line { budget, fps });
            let now = Instant::now();
            link.sent(now, 3000, true);
            assert_eq!(link.wait(now), LONGEST);
        }
    }

    #[test]
    fn the_line_is_judged_by_the_environment() {
        let line = |names: &[&str]| {
            Line::from_environment(|name| names.contains(&name).then(|| "x".to_owned()))
        };
        assert_eq!(line(&[]).budget, None);
        assert_eq!(line(&["SSH_TTY"]).budget, Some(16e3));
        assert_eq!(line(&["TMUX"]).budget, Some(64e3));
        assert_eq!(line(&["TMUX", "SSH_CONNECTION"]).budget, Some(16e3));
    }
}

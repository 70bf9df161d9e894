//! `ballast [PRESET]`: the workbench.

use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;

use super::output::{complain, load, tell, unopened};
use super::sample::with_sample;
use super::{BAD_INPUT, Workbench};
use crate::engine::threads::{processors, suited};
use crate::scene::Scene;
use crate::scene::catalogue::PRESETS;
use crate::session::RunError;
use crate::tui::plain::{self, Heard};
use crate::tui::terminal;
use crate::tui::workbench::{Ended, Start, run};

/// Opens it; answers the exit status.
pub(super) fn open(options: &Workbench) -> u8 {
    let first = PRESETS.first().map_or("", |preset| preset.name);
    let name = options.preset.as_deref().unwrap_or(first);
    let dumb = std::env::var("TERM").is_ok_and(|term| term == "dumb");
    let plain = options.plain || (dumb && terminal::is_there());
    let Some(scene) = load(name, &options.set) else {
        return BAD_INPUT;
    };
    if !plain && !terminal::is_there() {
        complain(&format!(
            "the workbench needs a terminal; run without one with\n  ballast run {name}\nor talk \
             to it line by line with\n  ballast {name} --plain"
        ));
        return BAD_INPUT;
    }
    let threads = options.threads.map(usize::from);
    let scene = match with_sample(scene, threads.unwrap_or_default(), false) {
        Ok(scene) => scene,
        Err(status) => return status,
    };
    let others = processors().saturating_sub(1);
    let threads = threads.unwrap_or_else(|| suited(scene.setup.particles.len(), others));
    if plain {
        return tell_end(dialogue(scene, threads));
    }
    let start = Start {
        paused: options.paused,
        fps: options.fps,
        kbps: options.kbps,
        pace: options.pace,
        threads,
        panic_at: options.panic_at,
    };
    tell_end(run(scene, &start))
}

/// The teletype dialogue on standard input and output.
fn dialogue(scene: Scene, threads: usize) -> Result<Ended, RunError> {
    let (lines, heard) = std::sync::mpsc::channel();
    // A thread of its own reads, so that a signal is answered while nobody types.
    std::thread::spawn(move || {
        for line in std::io::stdin().lines().map_while(Result::ok) {
            if lines.send(line).is_err() {
                return;
            }
        }
    });
    let mut listen = || match heard.recv_timeout(Duration::from_millis(100)) {
        Ok(line) => Heard::Line(line),
        Err(RecvTimeoutError::Timeout) => Heard::Nothing,
        Err(RecvTimeoutError::Disconnected) => Heard::End,
    };
    plain::talk(scene, threads, &mut listen, &mut std::io::stdout())
}

fn tell_end(ended: Result<Ended, RunError>) -> u8 {
    match ended {
        Ok(ended) => {
            tell(&ended.farewell);
            ended.status
        }
        Err(error) => unopened(&error),
    }
}

//! `ballast [PRESET]`: the workbench, on a preset or on what a checkpoint holds.

use std::path::Path;
use std::sync::mpsc::RecvTimeoutError;
use std::time::Duration;

use super::output::{complain, load, tell, unopened};
use super::recorded::Recorded;
use super::sample::with_sample;
use super::{BAD_INPUT, Workbench};
use crate::engine::threads::{processors, suited};
use crate::record::shell_word::shell_word;
use crate::scene::catalogue::PRESETS;
use crate::session::{Options, Session};
use crate::tui::farewell::Ended;
use crate::tui::plain::{self, Heard};
use crate::tui::terminal;
use crate::tui::workbench::{Start, run};

/// Opens it; answers the exit status.
pub(super) fn open(options: &Workbench) -> u8 {
    let first = PRESETS.first().map_or("", |preset| preset.name);
    let name = options.preset.as_deref().unwrap_or(first);
    let dumb = std::env::var("TERM").is_ok_and(|term| term == "dumb");
    let plain = options.plain || (dumb && terminal::is_there());
    let opened = match Recorded::find(name) {
        Some(Recorded::Checkpoint) => resumed(options, name, plain),
        _ => begun(options, name, plain),
    };
    let mut session = match opened {
        Ok(session) => session,
        Err(status) => return status,
    };
    session.panic_at(options.panic_at);
    if plain {
        return tell_end(&dialogue(session));
    }
    let start = Start {
        paused: options.paused,
        fps: options.fps,
        kbps: options.kbps,
        pace: options.pace,
        threads: session.world().threads(),
    };
    match run(session, &start) {
        Ok(ended) => tell_end(&ended),
        Err(error) => unopened(&error),
    }
}

/// A preset from its beginning, or the exit status.
fn begun(options: &Workbench, name: &str, plain: bool) -> Result<Session, u8> {
    let scene = load(name, &options.set).ok_or(BAD_INPUT)?;
    look_for_terminal(plain, name, &["run ", ""])?;
    let threads = options.threads.map(usize::from);
    let scene = with_sample(scene, threads.unwrap_or_default(), false)?;
    let how = Options {
        threads: threads.unwrap_or_else(|| beside_a_screen(scene.setup.particles.len())),
        ..Options::default()
    };
    Session::open(scene, how).map_err(|error| unopened(&error))
}

/// The run that a checkpoint holds, or the exit status.
fn resumed(options: &Workbench, name: &str, plain: bool) -> Result<Session, u8> {
    if !options.set.is_empty() {
        complain(&format!(
            "{name}: a run that goes on keeps its preset; leave --set out, and type commands instead"
        ));
        return Err(BAD_INPUT);
    }
    look_for_terminal(plain, name, &["run --resume ", " --csv FILE.csv"])?;
    let threads = options.threads.map(usize::from);
    let suits = |particles| threads.unwrap_or_else(|| beside_a_screen(particles));
    Session::resume_with(Path::new(name), suits).map_err(|error| {
        complain(&error.to_string());
        BAD_INPUT
    })
}

/// Refuses to go on without one, and says what does.
fn look_for_terminal(plain: bool, name: &str, headless: &[&str; 2]) -> Result<(), u8> {
    if plain || terminal::is_there() {
        return Ok(());
    }
    let ([before, after], word) = (headless, shell_word(name));
    complain(&format!(
        "the workbench needs a terminal; run without one with\n  ballast {before}{word}{after}\nor \
         talk to it line by line with\n  ballast {word} --plain"
    ));
    Err(BAD_INPUT)
}

/// Threads for so many particles, one processor left to the screen.
fn beside_a_screen(particles: usize) -> usize {
    suited(particles, processors().saturating_sub(1))
}

/// The teletype dialogue on standard input and output.
fn dialogue(session: Session) -> Ended {
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
    plain::talk(session, &mut listen, &mut std::io::stdout())
}

fn tell_end(ended: &Ended) -> u8 {
    tell(&ended.farewell);
    ended.status
}

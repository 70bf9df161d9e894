//! The teletype dialogue: lines in, lines out, no cursor, no colours. For `TERM=dumb`, pipes,
//! screen readers and scripts.

use std::io::Write;
use std::time::{Duration, Instant};

use super::workbench::{Ended, folder};
use crate::record::interrupt::{Interrupt, Signal};
use crate::scene::Scene;
use crate::session::worker::Keep;
use crate::session::{Budget, Options, Progress, Request, RunError, Session};

/// A line of status comes this often while cycles run.
const STATUS: Duration = Duration::from_secs(2);

/// What was heard in a moment of listening.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Heard {
    /// A line.
    Line(String),
    /// Nothing yet.
    Nothing,
    /// The end of the input.
    End,
}

/// Talks until the input ends, a command or a signal ends it; everything is kept in a folder of
/// its own, as by the workbench.
pub fn talk(
    scene: Scene,
    threads: usize,
    listen: &mut dyn FnMut() -> Heard,
    output: &mut dyn Write,
) -> Result<Ended, RunError> {
    let interrupt = Interrupt::install().ok();
    let caught = || interrupt.as_ref().and_then(Interrupt::caught);
    let options = Options {
        threads,
        ..Options::default()
    };
    let mut session = Session::open(scene, options)?;
    let keep = folder(&session.scene().name);
    if let Some(keep) = &keep {
        session.write_journal(&keep.journal)?;
        session.write_dumps(&keep.journal);
    }
    let title = &session.scene().about.title;
    say(output, &format!("{}: {title}", session.scene().name));
    say(
        output,
        "type a command; help lists them, go runs, quit ends",
    );
    loop {
        if let Some(signal) = caught() {
            return close(&mut session, keep.as_ref(), Some(signal));
        }
        let line = match listen() {
            Heard::Line(line) => line,
            Heard::Nothing => continue,
            Heard::End => return close(&mut session, keep.as_ref(), None),
        };
        let text = line.trim();
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let reply = match session.type_line(text) {
            Ok(reply) => reply,
            Err(refusal) => {
                say(output, &format!("! {refusal}"));
                continue;
            }
        };
        reply.lines.iter().for_each(|line| say(output, line));
        match reply.request {
            Some(Request::Quit { .. }) => return close(&mut session, keep.as_ref(), None),
            Some(Request::Run) => {
                if let Err(error) = run(&mut session, output, &|| caught().is_some()) {
                    say(output, &format!("! {error}"));
                    let way = keep.as_ref().map(|keep| session.way_back(&keep.checkpoint));
                    if let Some(way) = way.transpose()?.flatten() {
                        say(output, &way);
                    }
                }
            }
            Some(Request::Pause) | None => {}
        }
    }
}

/// Saves what there is and says where; nothing is lost, so nothing has to be asked.
fn close(
    session: &mut Session,
    keep: Option<&Keep>,
    signal: Option<Signal>,
) -> Result<Ended, RunError> {
    session.flush()?;
    let cycle = session.world().cycle_number();
    let mut farewell = signal.map_or_else(String::new, |signal| format!("{}\n", signal.name));
    farewell.push_str(&format!("cycle {cycle}"));
    if let Some(keep) = keep {
        farewell.push_str(&format!("; journal {}", keep.journal.display()));
        // Half a cycle must not take the place of the good state that is there.
        if cycle > 0 && !session.world().is_broken() {
            session.save(&keep.checkpoint)?;
        }
        if keep.checkpoint.exists() {
            let path = keep.checkpoint.display();
            farewell.push_str(&format!("\ngo on with: ballast run --resume {path}"));
        }
    }
    let status = signal.map_or(0, Signal::exit_status);
    // After the checkpoint, which goes on as if nothing had ended; a replay stops here.
    session.finish()?;
    Ok(Ended { status, farewell })
}

fn run(
    session: &mut Session,
    output: &mut dyn Write,
    stop: &dyn Fn() -> bool,
) -> Result<(), RunError> {
    let mut last = Instant::now();
    let budget = Budget {
        until_cycle: None,
        time: Some(Duration::from_millis(50)),
    };
    while session.advance(budget, false)? == Progress::Budget {
        if stop() {
            break;
        }
        if last.elapsed() >= STATUS {
            last = Instant::now();
            say(output, &status(session));
        }
    }
    for notice in session.take_notices() {
        say(output, &notice);
    }
    say(output, &status(session));
    Ok(())
}

fn status(session: &Session) -> String {
    let world = session.world();
    let (stage, stages) = session.stage_number();
    let place = if stages > 0 {
        format!("{} {}/{stages}, ", session.stage_name(), stage + 1)
    } else {
        String::new()
    };
    let (cycle, time) = (world.cycle_number(), world.time());
    format!("{place}cycle {cycle}, time {time:.6e} s")
}

/// A reader that has gone needs no more lines.
fn say(output: &mut dyn Write, text: &str) {
    drop(writeln!(output, "{text}").and_then(|()| output.flush()));
}

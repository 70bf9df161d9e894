//! The teletype dialogue: lines in, lines out, no cursor, no colours. For `TERM=dumb`, pipes,
//! screen readers and scripts.

use std::io::{BufRead, Write};
use std::time::{Duration, Instant};

use crate::scene::Scene;
use crate::session::{Budget, Options, Progress, Request, RunError, Session};

/// A line of status comes this often while cycles run.
const STATUS: Duration = Duration::from_secs(2);

/// Talks until the input ends or a command ends it; answers the exit status.
pub fn talk(
    scene: Scene,
    threads: usize,
    input: &mut dyn BufRead,
    output: &mut dyn Write,
) -> Result<u8, RunError> {
    let interrupt = crate::record::interrupt::Interrupt::install().ok();
    let mut session = Session::open(
        scene,
        Options {
            threads,
            ..Options::default()
        },
    )?;
    say(
        output,
        &format!("{}: {}", session.scene().name, session.scene().about.title),
    );
    say(
        output,
        "type a command, help lists them, go runs, quit ends",
    );
    let mut line = String::new();
    loop {
        line.clear();
        if !matches!(input.read_line(&mut line), Ok(n) if n > 0) {
            return Ok(0);
        }
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
            Some(Request::Quit { .. }) => return Ok(0),
            Some(Request::Run) => {
                let caught = || {
                    interrupt
                        .as_ref()
                        .and_then(crate::record::interrupt::Interrupt::caught)
                };
                if let Err(error) = run(&mut session, output, &|| caught().is_some()) {
                    say(output, &format!("! {error}"));
                }
                if let Some(signal) = caught() {
                    say(output, signal.name);
                    return Ok(signal.exit_status());
                }
            }
            Some(Request::Pause) | None => {}
        }
    }
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
    format!(
        "{place}cycle {}, time {:.6e} s",
        world.cycle_number(),
        world.time()
    )
}

/// A reader that has gone needs no more lines.
fn say(output: &mut dyn Write, text: &str) {
    drop(writeln!(output, "{text}").and_then(|()| output.flush()));
}

//! The teletype dialogue: lines in, lines out, no cursor, no colours. For `TERM=dumb`, pipes,
//! screen readers and scripts.

use std::io::Write;
use std::time::{Duration, Instant};

use super::farewell::Ended;
use crate::record::checkpoint::AT_ONCE;
use crate::record::interrupt::{Interrupt, Signal};
use crate::session::saves::Saves;
use crate::session::{Budget, Progress, Request, RunError, Session};

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

/// Why the dialogue ended.
enum End {
    /// A command, or the end of the input.
    Quit,
    Signal(Signal),
}

/// Talks until the input ends, a command or a signal ends it; everything is kept in a folder of
/// its own, as by the workbench.
pub fn talk(
    mut session: Session,
    listen: &mut dyn FnMut() -> Heard,
    output: &mut dyn Write,
) -> Ended {
    let interrupt = Interrupt::install().ok();
    let saves = Saves::begin(&mut session);
    let mut dialogue = Dialogue {
        session,
        saves,
        output,
    };
    let caught = || interrupt.as_ref().and_then(Interrupt::caught);
    // Lines and cycles alike may come upon a fault of the program.
    let whole = std::panic::AssertUnwindSafe(|| dialogue.hold(listen, &caught));
    let (why, status) = match std::panic::catch_unwind(whole) {
        Ok(end) => {
            dialogue.saves.close(&mut dialogue.session);
            match end {
                // Nothing is lost, so nothing has to be asked.
                End::Quit => (String::new(), 0),
                End::Signal(signal) => (format!("{}\n", signal.name), signal.exit_status()),
            }
        }
        Err(_) => {
            let lost = dialogue.saves.rescue(&mut dialogue.session);
            let lost = lost.iter().map(|error| format!("; {error}"));
            (format!("internal error{}\n", lost.collect::<String>()), 1)
        }
    };
    Ended::of(&why, &dialogue.session, &dialogue.saves, status)
}

struct Dialogue<'a> {
    session: Session,
    saves: Saves,
    output: &'a mut dyn Write,
}

impl Dialogue<'_> {
    fn hold(
        &mut self,
        listen: &mut dyn FnMut() -> Heard,
        caught: &dyn Fn() -> Option<Signal>,
    ) -> End {
        let scene = self.session.scene();
        let title = format!("{}: {}", scene.name, scene.about.title);
        self.say(&title);
        if let Some(warning) = self.saves.warning() {
            self.say(&warning);
        }
        // A run that goes on.
        if self.session.world().cycle_number() > 0 {
            self.say(&status(&self.session));
        }
        self.say("type a command; help lists them, go runs, quit ends");
        loop {
            if let Some(signal) = caught() {
                return End::Signal(signal);
            }
            let line = match listen() {
                Heard::Line(line) => line,
                Heard::Nothing => continue,
                Heard::End => return End::Quit,
            };
            let text = line.trim();
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            let reply = match self.session.type_line(text) {
                Ok(reply) => reply,
                Err(refusal) => {
                    self.say(&format!("! {refusal}"));
                    continue;
                }
            };
            reply.lines.iter().for_each(|line| self.say(line));
            match reply.request {
                Some(Request::Quit { .. }) => return End::Quit,
                Some(Request::Run) => {
                    if let Err(error) = self.run(&|| caught().is_some()) {
                        self.say(&format!("! {error}"));
                        if let Some(way) = self.saves.way_back(&mut self.session) {
                            self.say(&way);
                        }
                    }
                }
                Some(Request::Pause) | None => {}
            }
        }
    }

    fn run(&mut self, stop: &dyn Fn() -> bool) -> Result<(), RunError> {
        let ran = self.cycles(stop);
        // Also after a fault: what is left out, for instance.
        for notice in self.session.take_notices() {
            self.say(&notice);
        }
        let told = ran?;
        if told != Some(self.session.world().cycle_number()) {
            self.say(&status(&self.session));
        }
        Ok(())
    }

    /// Answers the last cycle that was told of on the way.
    fn cycles(&mut self, stop: &dyn Fn() -> bool) -> Result<Option<u64>, RunError> {
        let (mut last, mut told) = (Instant::now(), None);
        loop {
            let each = self.session.shows_each();
            let budget = Budget {
                until_cycle: each.then(|| self.session.world().cycle_number() + 1),
                time: Some(Duration::from_millis(50)),
            };
            if self.session.advance(budget, false)? != Progress::Budget || stop() {
                return Ok(told);
            }
            // Nobody can type while cycles run: nothing is more urgent.
            if let Err(error) = self.saves.save_if_due(&mut self.session, AT_ONCE) {
                self.say(&format!("! {error}"));
            }
            if each || last.elapsed() >= STATUS {
                last = Instant::now();
                told = Some(self.session.world().cycle_number());
                self.say(&status(&self.session));
            }
        }
    }

    /// A reader that has gone needs no more lines.
    fn say(&mut self, text: &str) {
        drop(writeln!(self.output, "{text}").and_then(|()| self.output.flush()));
    }
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

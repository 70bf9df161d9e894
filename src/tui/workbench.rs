//! The loop of the workbench: keys in, orders out, frames drawn.

use std::os::unix::net::UnixStream;
use std::time::{Duration, Instant};

use crossterm::event::{self, Event, KeyEventKind};
use ratatui::buffer::Buffer;

use super::app::{App, Effect, Said};
use super::events::{JobControl, wait};
use super::farewell::Ended;
use super::link::{Line, Link};
use super::look;
use super::painter::Painter;
use super::terminal::Terminal;
use crate::record::interrupt::{Interrupt, Signal};
use crate::scene::Scene;
use crate::session::frames::Wants;
use crate::session::saves::Saves;
use crate::session::start::is_ready;
use crate::session::worker::{Order, Stopped, Worker};
use crate::session::{Options, RunError, Session};

/// How the workbench is started.
#[derive(Debug, Clone, Default)]
pub struct Start {
    /// Do not run at once.
    pub paused: bool,
    /// Frames per second; `None`: by the environment.
    pub fps: Option<f64>,
    /// Kilobytes per second; `None`: by the environment.
    pub kbps: Option<f64>,
    /// Cycles per second; `None`: as the preset says, 0: as many as possible.
    pub pace: Option<f64>,
    /// Threads.
    pub threads: usize,
}

/// Nothing to do: look around this often.
const IDLE: Duration = Duration::from_secs(1);

struct Workbench {
    app: App,
    worker: Worker,
    terminal: Terminal,
    painter: Painter,
    wake: UnixStream,
    threads: usize,
    /// A key was pressed: draw now, on credit.
    urgent: bool,
    /// Frames to be drawn as soon as they come: an order was given, and its answer is waited for.
    eager: u8,
    /// What frames were last asked to carry.
    wants: Option<Wants>,
}

/// Runs a workbench on a session, which may have begun long ago.
pub fn run(mut session: Session, start: &Start) -> Result<Ended, RunError> {
    let interrupt = Interrupt::install().map_err(cannot("catch signals"))?;
    let jobs = JobControl::install().map_err(cannot("catch signals"))?;
    let saves = Saves::begin(&mut session);
    let pace = match start.pace {
        Some(pace) => (pace > 0.0).then_some(pace),
        None => session.scene().about.pace,
    };
    let (wake, knock) = UnixStream::pair().map_err(cannot("make a pipe"))?;
    for end in [&wake, &knock] {
        end.set_nonblocking(true).map_err(cannot("make a pipe"))?;
    }
    let get = |name: &str| std::env::var(name).ok();
    let mut line = Line::from_environment(get);
    line.fps = start.fps.unwrap_or(line.fps);
    line.budget = start.kbps.map(|kbps| 1000.0 * kbps).or(line.budget);
    let mut app = App::new(look::from_environment(get), Link::new(line));
    app.pace = pace;
    app.folder = folder(&saves);
    let begun = session.world().cycle_number();
    let goes_on = (begun > 0).then(|| format!("goes on from cycle {begun}"));
    let welcome = [
        session.scene().about.shows.clone(),
        session.scene().about.look.clone(),
        goes_on.unwrap_or_default(),
        "space pauses, : types a command, ? helps, q quits".to_owned(),
    ];
    welcome
        .into_iter()
        .chain(saves.warning())
        .filter(|text| !text.is_empty())
        .for_each(|text| app.say(Said::Notice(text)));
    let terminal = Terminal::take().map_err(cannot("take the terminal over"))?;
    let worker = Worker::start(session, saves, !start.paused, pace, knock)
        .map_err(cannot("start a thread"))?;
    let mut bench = Workbench {
        app,
        worker,
        terminal,
        painter: Painter::default(),
        wake,
        threads: start.threads,
        urgent: true,
        eager: 0,
        wants: None,
    };
    let end = bench.work(&interrupt, &jobs);
    Ok(bench.close(&end))
}

fn cannot(what: &'static str) -> impl Fn(std::io::Error) -> RunError {
    move |error| RunError::Misfit(format!("cannot {what}: {error}"))
}

/// Why the loop ended.
enum End {
    Quit,
    Gone,
    Signal(Signal),
    WorkerDied,
    Terminal(std::io::Error),
}

impl Workbench {
    fn work(&mut self, interrupt: &Interrupt, jobs: &JobControl) -> End {
        loop {
            if let Some(signal) = interrupt.caught() {
                return End::Signal(signal);
            }
            if jobs.asked_to_stop() {
                self.suspend();
            }
            if jobs.was_resumed() {
                if let Err(error) = self.terminal.enter() {
                    return End::Terminal(error);
                }
                self.repaint();
            }
            while let Some(report) = self.worker.report() {
                let effect = self.app.take_report(report);
                if let Some(end) = self.effect(effect) {
                    return end;
                }
                self.urgent = true;
            }
            if self.worker.has_died() {
                return End::WorkerDied;
            }
            let pause = match self.draw_if_due() {
                Ok(pause) => pause,
                Err(error) => return End::Terminal(error),
            };
            let woken = wait(&mut self.wake, pause);
            if woken.gone {
                return End::Gone;
            }
            if woken.keys
                && let Some(end) = self.keys()
            {
                return end;
            }
        }
    }

    /// Draws if there is something to draw and the line allows it; answers how long to wait.
    fn draw_if_due(&mut self) -> std::io::Result<Duration> {
        let now = Instant::now();
        let due = self.app.link.wait(now);
        if !self.urgent && self.eager == 0 && !due.is_zero() {
            return Ok(due);
        }
        let frame = self.worker.frame();
        if frame.is_none() && !self.urgent && !due.is_zero() {
            return Ok(due);
        }
        if let Some(frame) = frame {
            self.eager = self.eager.saturating_sub(1);
            self.app.take_frame(frame);
        }
        let Some(area) = Terminal::size() else {
            return Ok(IDLE);
        };
        if self.painter.area() != area {
            self.app.dirty = true;
        }
        if self.app.dirty {
            self.app.dirty = false;
            let waited_for = std::mem::take(&mut self.urgent);
            let mut buffer = Buffer::empty(area);
            let cursor = self.app.draw(area, &mut buffer);
            self.ask_for_what_is_seen(waited_for);
            let text = self.painter.paint(&buffer, cursor);
            if !text.is_empty() {
                self.terminal.send(text)?;
                self.app.link.sent(now, text.len(), true);
            }
            return Ok(self
                .app
                .link
                .wait(Instant::now())
                .max(Duration::from_millis(1)));
        }
        self.urgent = false;
        let running = self.app.frame.as_ref().is_none_or(|frame| frame.running);
        Ok(if running {
            Duration::from_millis(50)
        } else {
            IDLE
        })
    }

    /// Frames carry what the panes on the screen draw, and no more. When a key has changed that, the
    /// frame with it is waited for; what moves out of sight by itself has time.
    fn ask_for_what_is_seen(&mut self, waited_for: bool) {
        let wants = self.app.wants();
        if self.wants.is_some_and(|asked| asked.serve(&wants)) {
            return;
        }
        self.wants = Some(wants);
        self.worker.order(Order::Wants(wants));
        if waited_for {
            self.eager = self.eager.max(2);
            self.worker.order(Order::Refresh);
        }
    }

    fn keys(&mut self) -> Option<End> {
        loop {
            match event::poll(Duration::ZERO) {
                Ok(true) => {}
                Ok(false) => return None,
                Err(error) => return Some(End::Terminal(error)),
            }
            let effects = match event::read() {
                Ok(Event::Key(key)) if key.kind != KeyEventKind::Release => {
                    vec![self.app.key(key)]
                }
                Ok(Event::Paste(text)) => self.app.paste(&text),
                Ok(Event::Resize(..)) => {
                    self.app.dirty = true;
                    Vec::new()
                }
                Ok(_) => Vec::new(),
                Err(error) => return Some(End::Terminal(error)),
            };
            self.urgent = true;
            for effect in effects {
                if let Some(end) = self.effect(effect) {
                    return Some(end);
                }
            }
        }
    }

    fn effect(&mut self, effect: Effect) -> Option<End> {
        match effect {
            Effect::None => {}
            Effect::Order(order) => {
                // The frame in the mailbox is older than the order, the next one may be.
                self.eager = 3;
                self.worker.order(order);
            }
            Effect::Load(name) => self.load(name),
            Effect::Repaint => self.repaint(),
            Effect::Suspend => self.suspend(),
            Effect::Quit => return Some(End::Quit),
        }
        None
    }

    fn load(&mut self, name: &str) {
        let opened = Scene::load(name, &[])
            .map_err(|rejection| rejection.to_string())
            .and_then(|scene| {
                let pace = scene.about.pace;
                let options = Options {
                    threads: self.threads,
                    ..Options::default()
                };
                if !is_ready(&scene, &options) {
                    return Err(format!(
                        "{name} starts from a sample that has to be prepared first, which takes a \
                         while: leave and open it with `ballast {name}`, which shows how far it is"
                    ));
                }
                Session::open(scene, options)
                    .map(|session| (session, pace))
                    .map_err(|e| e.to_string())
            });
        match opened {
            Ok((mut session, pace)) => {
                let look = session.scene().about.look.clone();
                self.app.pace = pace;
                let saves = Saves::begin(&mut session);
                let (folder, warning) = (folder(&saves), saves.warning());
                self.worker
                    .order(Order::Replace(Box::new(session), pace, saves));
                self.worker.order(Order::Go);
                let said = [format!("{name}: {look}")].into_iter().chain(warning);
                said.for_each(|text| self.app.say(Said::Notice(text)));
                self.app.keep_in(folder);
            }
            Err(error) => self.app.say(Said::Error(error)),
        }
    }

    fn repaint(&mut self) {
        self.painter.forget();
        self.app.dirty = true;
        self.urgent = true;
    }

    /// Gives the terminal back, stops, and takes it over again.
    fn suspend(&mut self) {
        super::terminal::release();
        JobControl::stop_now();
        if self.terminal.enter().is_ok() {
            self.repaint();
        }
    }

    fn close(self, end: &End) -> Ended {
        let Self {
            worker,
            terminal,
            app,
            ..
        } = self;
        let stopped = worker.stop();
        drop(terminal);
        let why = match end {
            End::Quit => String::new(),
            End::Gone => "the terminal is gone\n".to_owned(),
            End::Signal(signal) => format!("{}\n", signal.name),
            End::WorkerDied => format!(
                "internal error: {}\n",
                app.failure.clone().unwrap_or_default()
            ),
            End::Terminal(error) => format!("the terminal failed: {error}\n"),
        };
        let status = match end {
            End::Quit => 0,
            // Writing to a terminal that has gone fails before the poll tells.
            End::Gone | End::Terminal(_) => 129,
            End::Signal(signal) => signal.exit_status(),
            End::WorkerDied => 1,
        };
        match stopped {
            Some(Stopped { session, saves }) => Ended::of(&why, &session, &saves, status),
            None => Ended {
                status,
                farewell: why,
            },
        }
    }
}

/// The folder of a run, for who asks for help.
fn folder(saves: &Saves) -> String {
    let folder = saves.keep().and_then(|keep| keep.journal.parent());
    folder.map_or_else(String::new, |folder| folder.display().to_string())
}

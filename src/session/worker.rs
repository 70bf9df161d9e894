//! The thread that owns the session of a workbench.
//!
//! It runs batches of some milliseconds and between them takes orders and, if the screen has
//! emptied the mailbox, leaves the newest frame there. It never waits for the screen.

use std::io::Write;
use std::os::unix::net::UnixStream;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use super::frames::{Frame, Shown, Wants};
use super::pacing::Pacing;
use super::queue::{Giver, Taker, Urgent, Waiting, channel};
use super::rate::Rate;
use super::saves::Saves;
use super::turns::Turns;
use super::{Budget, Progress, Refusal, Reply, Request, RunError, Session};
use crate::measure::columns::Partner;

/// Length of a batch: short enough to answer keys at once.
const BATCH: Duration = Duration::from_millis(5);

/// What the screen asks of the worker.
pub enum Order {
    /// A typed line.
    Line(String),
    /// Run.
    Go,
    /// Stop at the next boundary.
    Pause,
    /// Run if paused, pause if running.
    Toggle,
    /// Cycles up to the next row of the history.
    Row,
    /// Follow a contact: the lower particle number and its partner.
    Follow(u32, Partner),
    /// Which parts of frames are wanted: those that come anyway.
    Wants(Wants),
    /// At most so many cycles per second; `None`: as fast as possible.
    Pace(Option<f64>),
    /// Another session instead of this one.
    Replace(Box<Session>, Option<f64>, Saves),
    /// A frame even if nothing has changed.
    Refresh,
    /// Save the state and end.
    Stop,
}

impl Urgent for Order {
    /// What is seen of a moving assembly changes by itself, too: nobody waits for that.
    fn is_urgent(&self) -> bool {
        !matches!(self, Self::Wants(_))
    }
}

/// What the worker tells the screen.
#[derive(Debug)]
pub enum Report {
    /// A line was executed.
    Said {
        /// The line.
        line: String,
        /// What came of it.
        reply: Result<Reply, Refusal>,
    },
    /// Something the user should know.
    Notice(String),
    /// The run cannot go on.
    Failed(String),
    /// The pace is this now.
    Pace(Option<f64>),
    /// A command asks to end; whether without asking.
    Quit(bool),
}

/// Newest frame, handed over.
pub type Mailbox = Arc<Mutex<Option<Box<Frame>>>>;

/// What is left when the thread has ended.
pub struct Stopped {
    /// The run.
    pub session: Box<Session>,
    /// How far it is kept.
    pub saves: Saves,
}

/// The screen's end.
pub struct Worker {
    orders: Giver<Order>,
    reports: Receiver<Report>,
    mailbox: Mailbox,
    thread: Option<JoinHandle<Stopped>>,
}

impl Worker {
    /// Starts the thread. `wake` gets a byte for every report and frame.
    pub fn start(
        session: Session,
        saves: Saves,
        running: bool,
        pace: Option<f64>,
        wake: UnixStream,
    ) -> std::io::Result<Self> {
        let (orders, inbox) = channel();
        let (outbox, reports) = mpsc::channel();
        let mailbox: Mailbox = Arc::default();
        let desk = Desk {
            session: attentive(Box::new(session), inbox.waiting()),
            saves,
            inbox,
            outbox,
            mailbox: Arc::clone(&mailbox),
            wake,
            running,
            free: false,
            changed: true,
            pacing: Pacing::new(pace, Instant::now()),
            wants: Wants::default(),
            shown: Shown::default(),
            rate: Rate::default(),
            turns: Turns::default(),
            batch: Duration::ZERO,
        };
        let thread = std::thread::Builder::new()
            .name("ballast-run".into())
            .spawn(|| desk.work())?;
        Ok(Self {
            orders,
            reports,
            mailbox,
            thread: Some(thread),
        })
    }

    /// Gives an order; false when the thread has ended.
    pub fn order(&self, order: Order) -> bool {
        self.orders.send(order).is_ok()
    }

    /// Next report, if there is one.
    pub fn report(&self) -> Option<Report> {
        self.reports.try_recv().ok()
    }

    /// Newest frame, if there is one.
    pub fn frame(&self) -> Option<Box<Frame>> {
        self.mailbox
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take()
    }

    /// Whether the thread has ended by itself, which only a panic does.
    pub fn has_died(&self) -> bool {
        self.thread.as_ref().is_none_or(JoinHandle::is_finished)
    }

    /// Ends the thread with everything saved that can be.
    pub fn stop(mut self) -> Option<Stopped> {
        self.order(Order::Stop);
        self.thread.take().and_then(|thread| thread.join().ok())
    }
}

/// The session, which keeps no good state while orders wait.
fn attentive(mut session: Box<Session>, waiting: Waiting) -> Box<Session> {
    session.keep_unless(move || waiting.any());
    session
}

/// The worker's own end.
struct Desk {
    session: Box<Session>,
    saves: Saves,
    inbox: Taker<Order>,
    outbox: Sender<Report>,
    mailbox: Mailbox,
    wake: UnixStream,
    running: bool,
    /// Whether to run on although all stages are done.
    free: bool,
    /// Whether there is something new to show.
    changed: bool,
    pacing: Pacing,
    wants: Wants,
    shown: Shown,
    rate: Rate,
    turns: Turns,
    /// How long the last batch took.
    batch: Duration,
}

impl Desk {
    fn work(mut self) -> Stopped {
        loop {
            // Orders, too, may come upon a fault of the program.
            let turn = std::panic::AssertUnwindSafe(|| self.turn());
            match std::panic::catch_unwind(turn) {
                Ok(true) => {}
                Ok(false) => break,
                Err(panic) => {
                    self.fall(panic.as_ref());
                    break;
                }
            }
        }
        Stopped {
            session: self.session,
            saves: self.saves,
        }
    }

    /// Orders, a batch and a frame. False: that was the last one.
    fn turn(&mut self) -> bool {
        if !self.take_orders() {
            self.saves.close(&mut self.session);
            return false;
        }
        if self.running && !self.is_held() && self.pacing.wait(Instant::now()).is_zero() {
            self.run_batch();
        }
        self.post();
        true
    }

    /// Whether the screen is to see this boundary before the next.
    fn is_held(&self) -> bool {
        self.changed && self.session.shows_each()
    }

    /// Carries out what has been ordered; waits when there is nothing else to do. False: stop.
    fn take_orders(&mut self) -> bool {
        loop {
            // A frame that found the mailbox full goes out as soon as it is empty.
            let mut patience = Duration::from_millis(if self.changed { 20 } else { 1000 });
            if self.running && !self.is_held() {
                patience = patience.min(self.pacing.wait(Instant::now()));
            }
            let order = match self.inbox.recv_timeout(patience) {
                Ok(order) => order,
                Err(RecvTimeoutError::Timeout) => return true,
                Err(RecvTimeoutError::Disconnected) => return false,
            };
            if order.is_urgent() {
                self.turns.await_answer();
            }
            if !self.carry_out(order) {
                return false;
            }
            self.changed = true;
        }
    }

    fn carry_out(&mut self, order: Order) -> bool {
        match order {
            Order::Line(line) => self.execute(line),
            Order::Pause => self.running = false,
            Order::Toggle if self.running => self.running = false,
            Order::Go | Order::Toggle => self.go(),
            Order::Row => {
                let every = self.session.recording().every;
                let rest = every - self.session.world().cycle_number() % every;
                self.execute(format!("cycle {rest}"));
            }
            Order::Follow(i, partner) => self.session.follow(i, &partner),
            Order::Wants(wants) => self.wants = wants,
            Order::Pace(pace) => {
                self.pacing = Pacing::new(pace, Instant::now());
                self.tell(Report::Pace(pace));
            }
            Order::Replace(session, pace, saves) => {
                self.saves.close(&mut self.session);
                let lost = [self.saves.fault(), self.saves.unended()];
                let lost: Vec<String> = lost.into_iter().flatten().map(str::to_owned).collect();
                for fault in lost {
                    self.tell(Report::Notice(format!("of the run before: {fault}")));
                }
                self.saves = saves;
                self.running = false;
                self.session = attentive(session, self.inbox.waiting());
                self.shown = Shown::default();
                self.rate = Rate::default();
                self.pacing = Pacing::new(pace, Instant::now());
                self.free = false;
            }
            Order::Refresh => {}
            Order::Stop => return false,
        }
        true
    }

    fn go(&mut self) {
        self.running = true;
        self.free = self.session.is_finished();
    }

    fn execute(&mut self, line: String) {
        let reply = self.session.type_line(&line);
        self.shown.forget();
        match reply.as_ref().ok().and_then(|reply| reply.request) {
            Some(Request::Run) => self.go(),
            Some(Request::Pause) => self.running = false,
            Some(Request::Quit { anyway }) => self.tell(Report::Quit(anyway)),
            None => {}
        }
        self.tell(Report::Said { line, reply });
        self.tell_notices();
    }

    fn run_batch(&mut self) {
        let before = self.session.world().cycle_number();
        // A slow pace runs a few cycles and waits; a fast one is cut into batches.
        let until_cycle = match self.pacing.cycles() {
            _ if self.session.shows_each() => Some(before + 1),
            Some(cycles) => Some(before.saturating_add(cycles)),
            None => self.free.then_some(u64::MAX),
        };
        let start = Instant::now();
        let budget = Budget {
            until_cycle,
            time: Some(BATCH),
        };
        match self.session.advance(budget, self.free) {
            Ok(Progress::Budget) => {}
            Ok(Progress::ErrandDone) => self.running = false,
            Ok(Progress::Finished) => {
                self.running = false;
                self.tell(Report::Notice(
                    "all stages are done; space or go runs on".into(),
                ));
            }
            Err(error) => self.fail(&error),
        }
        self.tell_notices();
        self.changed = true;
        let done = self.session.world().cycle_number() - before;
        self.pacing.made(done, start);
        self.batch = start.elapsed();
        let waiting = self.inbox.waiting();
        let ordered = || waiting.any();
        let saved = self.saves.save_if_due(&mut self.session, &ordered);
        if let Err(error) = saved {
            self.tell(Report::Notice(error.to_string()));
        }
    }

    fn fail(&mut self, error: &RunError) {
        self.running = false;
        let mut message = error.to_string();
        if let Some(way) = self.saves.way_back(&mut self.session) {
            message.push_str(&format!("; {way}"));
        }
        self.tell(Report::Failed(message));
    }

    /// A fault of the program itself: keeps what can be kept.
    fn fall(&mut self, panic: &(dyn std::any::Any + Send)) {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let mut text = text
            .or_else(|| panic.downcast_ref::<String>().cloned())
            .unwrap_or_default();
        for error in self.saves.rescue(&mut self.session) {
            text.push_str(&format!("; {error}"));
        }
        self.tell(Report::Failed(text));
    }

    fn tell(&mut self, report: Report) {
        // A screen that has gone needs no report.
        drop(self.outbox.send(report));
        self.knock();
    }

    fn tell_notices(&mut self) {
        for notice in self.session.take_notices() {
            self.tell(Report::Notice(notice));
        }
    }

    fn knock(&mut self) {
        // A full pipe wakes as well as one more byte would.
        drop(self.wake.write(&[1]));
    }

    /// Leaves the newest frame if the last one was taken.
    fn post(&mut self) {
        let turn = || self.turns.is_due(Instant::now(), self.batch);
        if !self.changed || self.running && !turn() {
            return;
        }
        let empty = self
            .mailbox
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .is_none();
        if !empty {
            return;
        }
        let start = Instant::now();
        let rate = self
            .rate
            .update(self.session.world().cycle_number(), self.running);
        let frame = self
            .session
            .frame(self.wants, rate, self.running, &mut self.shown);
        *self.mailbox.lock().unwrap_or_else(PoisonError::into_inner) = Some(Box::new(frame));
        self.changed = false;
        self.turns.taken(start, Instant::now());
        self.knock();
    }
}

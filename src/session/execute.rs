//! Carrying out a command: the only way anything changes a world.

use super::course::Errand;
use super::{Refusal, Session, generate, print};
use crate::language::command::{Export, Goal, HistoryChange, Printout};
use crate::language::{COMMANDS, Command, Expression, Known, number};
use crate::measure::reference::Reference;
use crate::record::journal::EventKind;

/// Who asks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// Somebody who types or presses, now or in a journal.
    User,
    /// A stage of the preset.
    Stage,
}

/// What a command answers.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Reply {
    /// Lines for the dialogue; tables come as they are printed.
    pub lines: Vec<String>,
    /// What whoever runs the session should do now.
    pub request: Option<Request>,
}

/// What a command asks of whoever runs the session.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Request {
    /// Run on.
    Run,
    /// Stop running.
    Pause,
    /// End; `anyway`: without asking.
    Quit {
        /// Whether unsaved cycles do not matter.
        anyway: bool,
    },
}

impl Reply {
    pub(super) fn line(text: impl Into<String>) -> Self {
        Self {
            lines: vec![text.into()],
            request: None,
        }
    }

    pub(super) fn asking(text: impl Into<String>, request: Request) -> Self {
        Self {
            lines: vec![text.into()],
            request: Some(request),
        }
    }
}

/// Out-of-balance ratio that `solve` aims at unless told otherwise.
const SOLVED: f64 = 1e-5;

impl Session {
    /// Executes a line as if typed.
    pub fn type_line(&mut self, line: &str) -> Result<Reply, Refusal> {
        // People who have just opened a prompt with a colon type another.
        let line = line.trim_start().trim_start_matches(':');
        let command = Command::parse_with(line, &self.scene.definitions)?;
        self.execute(&command, By::User)
    }

    /// What lines can refer to now.
    pub fn known(&self) -> Known {
        Known {
            names: self.names(),
            definitions: self.scene.definitions.clone(),
            boundary: self.world.model().boundary,
        }
    }

    /// Carries a command out. A refused one has changed nothing.
    pub fn execute(&mut self, command: &Command, by: By) -> Result<Reply, Refusal> {
        let line = command.to_string();
        self.known().check(command, &line)?;
        self.check_whole(command)?;
        self.panic_if_asked();
        let reply = self.carry_out(command, by)?;
        let told = match command {
            // Tells itself, at the cycle that it left.
            Command::Restore(_) => false,
            Command::Reference
            | Command::Save(_)
            | Command::Pause
            | Command::History(HistoryChange::Every(_) | HistoryChange::Columns(_)) => true,
            other => other.changes_world() || other.runs_cycles(),
        };
        if by == By::User && told {
            self.note(EventKind::Typed(line)).map_err(|error| {
                Refusal::new(
                    error.to_string(),
                    "the command took effect but is not in the journal",
                )
            })?;
        }
        Ok(reply)
    }

    /// A world that broke off in the middle of a cycle can be looked at, and left.
    fn check_whole(&self, command: &Command) -> Result<(), Refusal> {
        let builds_on_it = match command {
            Command::Restore(_) => false,
            Command::Save(_) => true,
            other => other.changes_world() || other.runs_cycles(),
        };
        match self.world.fault() {
            Some(fault) if builds_on_it && self.world.is_broken() => Err(Refusal::new(
                format!("the run cannot go on: {fault}"),
                match self.safe_cycle() {
                    Some(cycle) => {
                        format!("first restore an earlier state, such as that of cycle {cycle}")
                    }
                    None => {
                        "no earlier state was kept: change the preset and begin anew".to_owned()
                    }
                },
            )),
            _ => Ok(()),
        }
    }

    /// Whether energies are booked, which a column needs.
    fn check_booked(&self, column: &str) -> Result<(), Refusal> {
        if self.world.ledger().is_some() {
            return Ok(());
        }
        Err(Refusal::new(
            format!("{column} needs energies booked from the start"),
            "name it in [history] columns of the preset",
        ))
    }

    fn carry_out(&mut self, command: &Command, by: By) -> Result<Reply, Refusal> {
        match command {
            Command::Cycle(n) => Ok(self.run_to(Some(*n), None, by)),
            Command::Step(n) => {
                let reply = self.run_to(Some(*n), None, by);
                if let Some(errand) = &mut self.course.user_errand {
                    errand.shown = by == By::User;
                }
                Ok(reply)
            }
            Command::Solve(solve) => {
                let columns = command
                    .awaits()
                    .map(Expression::columns)
                    .unwrap_or_default();
                if let Some(column) = columns.iter().find(|column| column.card().ledger) {
                    self.check_booked(&column.name())?;
                }
                let balanced = |ratio: f64| {
                    Expression::parse_condition(&format!("unbalanced <= {}", number::format(ratio)))
                };
                let condition = match &solve.goal {
                    Some(Goal::Until(condition)) => condition.clone(),
                    Some(Goal::Ratio(ratio)) => balanced(*ratio)?,
                    None => balanced(SOLVED)?,
                };
                Ok(self.run_to(solve.max, Some(condition), by))
            }
            Command::Go => Ok(Reply::asking("running", Request::Run)),
            Command::Pause => Ok(Reply::asking(
                format!("paused at cycle {}", self.world.cycle_number()),
                Request::Pause,
            )),
            Command::Quit { anyway } => Ok(Reply::asking("bye", Request::Quit { anyway: *anyway })),
            Command::Help(None) => {
                let width = COMMANDS
                    .iter()
                    .map(|card| card.name.len())
                    .max()
                    .unwrap_or(0);
                let row = |card: &crate::language::Card| {
                    format!("{:width$}  {}", card.name, card.summary)
                };
                Ok(Reply {
                    lines: COMMANDS.iter().map(row).collect(),
                    request: None,
                })
            }
            Command::Help(Some(name)) => {
                let card = COMMANDS.iter().find(|card| card.name == *name);
                let page = card.map(crate::language::Card::page).unwrap_or_default();
                Ok(Reply {
                    lines: page.lines().map(str::to_owned).collect(),
                    request: None,
                })
            }
            Command::Print(what) => Ok(self.print(what)),
            Command::InspectContact(i, partner) => Ok(self.inspect(*i, partner)),
            Command::InspectOff => Ok(self.follow_none()),
            Command::History(change) => self.change_history(change),
            Command::Reference => {
                self.reference = Reference::of(&self.world);
                self.world.forget_slid();
                Ok(Reply::line(format!(
                    "differences from cycle {}",
                    self.reference.cycle
                )))
            }
            Command::Export(Export::Contact(what), file) => self.export_contact(*what, file),
            Command::Save(_)
            | Command::Restore(_)
            | Command::Export(..)
            | Command::Journal(_)
            | Command::Source(_) => self.keep(command),
            Command::Generate(new) => {
                generate::generate(&mut self.world, self.scene.seed, new).map(Reply::line)
            }
            other => self.change_world(other).map(Reply::line),
        }
    }

    fn run_to(&mut self, cycles: Option<u64>, condition: Option<Expression>, by: By) -> Reply {
        let from = self.world.cycle_number();
        let until_cycle = cycles.map(|n| from.saturating_add(n));
        let errand = Some(Errand {
            until_cycle,
            condition,
            from,
            shown: false,
        });
        match by {
            By::User => self.course.user_errand = errand,
            By::Stage => self.course.errand = errand,
        }
        Reply {
            lines: Vec::new(),
            request: Some(Request::Run),
        }
    }

    fn print(&mut self, what: &Printout) -> Reply {
        let mut lines = Vec::new();
        match what {
            Printout::Averages => {
                self.averages_only = true;
                lines.push("print balls and print contacts show averages from now on".into());
            }
            Printout::All => {
                self.averages_only = false;
                lines.push("print balls and print contacts show every row from now on".into());
            }
            _ => {}
        }
        let averages = self.averages_only;
        lines.extend(print::table(
            &mut self.world,
            &self.scene.regions,
            &self.reference,
            what,
            averages,
        ));
        Reply {
            lines,
            request: None,
        }
    }

    fn change_history(&mut self, change: &HistoryChange) -> Result<Reply, Refusal> {
        match change {
            HistoryChange::Show => {}
            HistoryChange::Every(every) => self.recording.every = *every,
            HistoryChange::Columns(columns) => {
                if self.csv.is_some() {
                    return Err(Refusal::new(
                        "the columns of a CSV file being written cannot change",
                        "name them in [history] columns, or export another file at the end",
                    ));
                }
                if let Some(column) = columns.iter().find(|column| column.needs_ledger()) {
                    self.check_booked(&column.name())?;
                }
                self.recording.show(columns);
            }
        }
        let names = self.recording.names().join(", ");
        let (every, rows) = (self.recording.every, self.recording.rows().len());
        Ok(Reply::line(format!(
            "every {every} cycles, {rows} rows: {names}"
        )))
    }
}

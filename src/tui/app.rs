//! State of the screen: what it shows, what has the focus, what was typed. Knows no terminal.

use crossterm::event::KeyEvent;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::symbols::border;

use super::keys::{self, Action};
use super::layout::{self, Arrangement, Class};
use super::link::Link;
use super::look::{Chains, Look, Points, Theme};
use super::panes::{self, PaneId};
use super::prompt::{Prompt, Typed};
use super::series::Series;
use super::view::View;
use crate::language::Known;
use crate::scene::catalogue::PRESETS;
use crate::session::frames::Frame;
use crate::session::worker::{Order, Report};

/// One line of the dialogue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Said {
    /// What was typed.
    Line(String),
    /// An answer.
    Answer(String),
    /// A refusal or a failure.
    Error(String),
    /// Something worth knowing.
    Notice(String),
}

/// A warning with the cycle and particle it is about.
#[derive(Debug, Clone, PartialEq)]
pub struct Warning {
    /// Cycle.
    pub cycle: u64,
    /// Particle to jump to.
    pub particle: Option<u32>,
    /// What it says.
    pub text: String,
}

/// What lies over the panes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overlay {
    /// Keys, commands, panes; scrolled by so many lines.
    Help(u16),
    /// Presets; the one under the cursor.
    Presets(usize),
    /// Whether to quit although cycles are unsaved.
    Quit,
}

/// What has to be done outside the screen's own state.
pub enum Effect {
    /// Nothing.
    None,
    /// An order to the worker.
    Order(Order),
    /// Load an embedded preset by name.
    Load(&'static str),
    /// Paint everything anew.
    Repaint,
    /// Stop the process until it is continued.
    Suspend,
    /// End.
    Quit,
}

/// Lines of dialogue kept.
const DIALOGUE: usize = 2000;

/// State of the screen.
pub struct App {
    /// Newest frame.
    pub frame: Option<Box<Frame>>,
    /// Histories.
    pub series: Series,
    /// Prompt.
    pub prompt: Prompt,
    /// What was said.
    pub dialogue: Vec<Said>,
    /// Lines scrolled back in the dialogue.
    pub scrolled: usize,
    /// Number of the pane in focus.
    pub focus: usize,
    /// The pane that fills the screen.
    pub zoomed: Option<PaneId>,
    /// Part of the assembly that is seen.
    pub view: View,
    /// Settings of the picture.
    pub look: Look,
    /// Line to the terminal.
    pub link: Link,
    /// What lies over the panes.
    pub overlay: Option<Overlay>,
    /// Selected disc.
    pub selected: Option<u32>,
    /// Column name of each chart.
    pub charts: Vec<String>,
    /// Warnings.
    pub warnings: Vec<Warning>,
    /// Those not acknowledged.
    pub unseen: usize,
    /// Why the run cannot go on.
    pub failure: Option<String>,
    /// Cycles per second aimed at; `None`: as many as possible.
    pub pace: Option<f64>,
    /// Whether a frame has to be drawn.
    pub dirty: bool,
    /// Cycle last known to be exported or saved by the user.
    pub kept_cycle: u64,
    /// Where the run's own files are.
    pub folder: String,
    arrangement: Arrangement,
}

impl App {
    /// An empty screen.
    pub fn new(look: Look, link: Link) -> Self {
        Self {
            frame: None,
            series: Series::default(),
            prompt: Prompt::default(),
            dialogue: Vec::new(),
            scrolled: 0,
            focus: 0,
            zoomed: None,
            view: View::default(),
            look,
            link,
            overlay: None,
            selected: None,
            charts: ["sin_phi", "isotropic_stress", "coordination", "unbalanced"]
                .map(str::to_owned)
                .to_vec(),
            warnings: Vec::new(),
            unseen: 0,
            failure: None,
            pace: None,
            dirty: true,
            kept_cycle: 0,
            folder: String::new(),
            arrangement: layout::arrange(Rect::default(), None),
        }
    }

    /// Lines of boxes: ASCII where nothing else can be shown.
    pub fn border(&self) -> border::Set<'static> {
        if self.look.points != Points::Ascii {
            return border::PLAIN;
        }
        border::Set {
            top_left: "+",
            top_right: "+",
            bottom_left: "+",
            bottom_right: "+",
            vertical_left: "|",
            vertical_right: "|",
            horizontal_top: "-",
            horizontal_bottom: "-",
        }
    }

    /// Takes a frame.
    pub fn take_frame(&mut self, mut frame: Box<Frame>) {
        let restarted = frame.restarted;
        self.series.take(&mut frame);
        if restarted
            && self
                .frame
                .as_ref()
                .is_none_or(|old| old.preset != frame.preset)
        {
            self.begin();
        }
        let before = self.frame.as_ref().map_or(0, |old| old.fracc.warnings);
        if frame.fracc.warnings > before
            && let Some((cycle, particle, fracc)) = frame.fracc.last
        {
            let more = frame.fracc.warnings - before;
            let text = format!("FRACC {fracc:.3} > 0.3 at disc {particle}, {more} cycles");
            self.warn(Warning {
                cycle,
                particle: Some(particle),
                text,
            });
        }
        self.frame = Some(frame);
        self.dirty = true;
    }

    /// A new run: what belonged to the old one goes.
    fn begin(&mut self) {
        self.view = View::default();
        self.selected = None;
        self.failure = None;
        self.warnings.clear();
        self.unseen = 0;
        self.kept_cycle = 0;
        // Charts show what is recorded.
        let names: Vec<String> = self
            .series
            .columns
            .iter()
            .map(crate::measure::columns::Column::name)
            .collect();
        let wanted = [
            "sin_phi",
            "isotropic_stress",
            "coordination",
            "unbalanced",
            "kinetic",
        ];
        let mut charts: Vec<String> = wanted
            .iter()
            .filter(|name| names.iter().any(|n| n == *name))
            .map(|n| (*n).to_owned())
            .collect();
        charts.extend(
            names
                .iter()
                .filter(|name| !wanted.contains(&name.as_str()))
                .cloned(),
        );
        charts.truncate(4);
        if !charts.is_empty() {
            self.charts = charts;
        }
    }

    fn warn(&mut self, warning: Warning) {
        self.warnings.push(warning);
        self.unseen += 1;
        if self.warnings.len() > 500 {
            self.warnings.remove(0);
        }
    }

    /// Adds to the dialogue.
    pub fn say(&mut self, said: Said) {
        self.dialogue.push(said);
        if self.dialogue.len() > DIALOGUE {
            self.dialogue.drain(..DIALOGUE / 4);
        }
        self.scrolled = 0;
        self.dirty = true;
    }

    /// Takes a report of the worker.
    pub fn take_report(&mut self, report: Report) -> Effect {
        match report {
            Report::Said { line, reply } => {
                self.say(Said::Line(line.clone()));
                match reply {
                    Ok(reply) => {
                        if (line.starts_with("export") || line.starts_with("save"))
                            && let Some(frame) = &self.frame
                        {
                            self.kept_cycle = frame.cycle;
                        }
                        reply
                            .lines
                            .into_iter()
                            .for_each(|text| self.say(Said::Answer(text)));
                    }
                    Err(refusal) => self.say(Said::Error(refusal.to_string())),
                }
                Effect::None
            }
            Report::Notice(text) => {
                self.say(Said::Notice(text));
                Effect::None
            }
            Report::Failed(text) => {
                self.failure = Some(text.clone());
                self.say(Said::Error(text));
                Effect::None
            }
            Report::Pace(pace) => {
                self.pace = pace;
                self.dirty = true;
                Effect::None
            }
            Report::Quit(anyway) => self.quit(anyway),
        }
    }

    /// Takes pasted text.
    pub fn paste(&mut self, text: &str) {
        if !self.prompt.open {
            self.prompt.open_with("");
        }
        self.prompt.paste(text);
        self.dirty = true;
    }

    /// Takes a key.
    pub fn key(&mut self, event: KeyEvent) -> Effect {
        self.dirty = true;
        if self.prompt.open {
            let nothing = Known::default();
            let known = self
                .frame
                .as_ref()
                .map(|frame| std::sync::Arc::clone(&frame.known));
            return match self.prompt.key(event, known.as_deref().unwrap_or(&nothing)) {
                Typed::Editing | Typed::Left => Effect::None,
                Typed::Line(line) => self.line(line),
            };
        }
        let Some(key) = keys::find(event) else {
            return Effect::None;
        };
        if let Some(overlay) = self.overlay {
            return self.overlaid(overlay, key.action);
        }
        self.act(key.action)
    }

    /// A typed line: the screen's own words, or a command for the worker.
    fn line(&mut self, line: String) -> Effect {
        let mut words = line.split_whitespace();
        match (words.next(), words.next(), words.next()) {
            (Some("q!" | "quit!"), None, None) => Effect::Quit,
            (Some("q" | "quit"), None, None) => self.quit(false),
            (Some("pace"), Some("max"), None) => Effect::Order(Order::Pace(None)),
            (Some("pace"), Some(number), None) => match number.parse::<f64>() {
                Ok(pace) if pace > 0.0 && pace.is_finite() => {
                    Effect::Order(Order::Pace(Some(pace)))
                }
                _ => {
                    self.say(Said::Error(format!(
                        "`{number}` is no pace; cycles per second, or max"
                    )));
                    Effect::None
                }
            },
            (Some("set"), Some("kbps"), Some(number)) => match number.parse::<f64>() {
                Ok(kbps) if kbps > 0.0 => {
                    self.link.budget = Some(1000.0 * kbps);
                    Effect::None
                }
                _ => {
                    self.say(Said::Error(format!(
                        "`{number}` is no rate; kilobytes per second"
                    )));
                    Effect::None
                }
            },
            (Some("load"), Some(name), None) => match PRESETS.iter().find(|p| p.name == name) {
                Some(preset) => Effect::Load(preset.name),
                None => {
                    let near =
                        crate::measure::columns::nearest(name, PRESETS.iter().map(|p| p.name));
                    self.say(Said::Error(format!("there is no preset `{name}`; {near}")));
                    Effect::None
                }
            },
            _ => Effect::Order(Order::Line(line)),
        }
    }

    fn quit(&mut self, anyway: bool) -> Effect {
        let unsaved = self
            .frame
            .as_ref()
            .is_some_and(|frame| frame.cycle > self.kept_cycle);
        if anyway || !unsaved {
            return Effect::Quit;
        }
        self.overlay = Some(Overlay::Quit);
        self.dirty = true;
        Effect::None
    }

    fn overlaid(&mut self, overlay: Overlay, action: Action) -> Effect {
        let last = PRESETS.len() - 1;
        self.overlay = match (overlay, action) {
            (Overlay::Quit, Action::Quit | Action::Interrupt) => return Effect::Quit,
            (_, Action::Repaint) => return Effect::Repaint,
            (Overlay::Presets(at), Action::Zoom) => {
                self.overlay = None;
                return Effect::Load(PRESETS[at.min(last)].name);
            }
            (Overlay::Help(at), Action::Pan(_, y)) if y != 0.0 => Some(Overlay::Help(if y > 0.0 {
                at.saturating_sub(1)
            } else {
                at + 1
            })),
            (Overlay::Help(at), Action::Scroll(by)) => {
                Some(Overlay::Help(at.saturating_add_signed(by as i16)))
            }
            (Overlay::Presets(at), Action::Pan(_, y)) if y != 0.0 => {
                Some(Overlay::Presets(if y > 0.0 {
                    at.saturating_sub(1)
                } else {
                    (at + 1).min(last)
                }))
            }
            _ => None,
        };
        Effect::None
    }

    fn act(&mut self, action: Action) -> Effect {
        let running = self.frame.as_ref().is_some_and(|frame| frame.running);
        let bounds = self
            .frame
            .as_ref()
            .map_or([[0.0; 2], [1.0; 2]], |frame| frame.picture.bounds);
        match action {
            Action::Toggle => return Effect::Order(Order::Toggle),
            Action::Cycle => return Effect::Order(Order::Line("cycle 1".into())),
            Action::Row => return Effect::Order(Order::Row),
            Action::Prompt => self.prompt.open_with(""),
            Action::PromptWith(text) => self.prompt.open_with(text),
            Action::Help => self.overlay = Some(Overlay::Help(0)),
            Action::Presets => self.overlay = Some(Overlay::Presets(0)),
            Action::Quit => return self.quit(false),
            Action::Interrupt if running => return Effect::Order(Order::Pause),
            Action::Interrupt => return self.quit(false),
            Action::Focus(by) => self.move_focus(by),
            Action::Pane(number) if number < self.arrangement.panes.len() => self.focus = number,
            Action::Zoom => {
                self.zoomed = match self.zoomed {
                    Some(_) => None,
                    None => self.focused(),
                };
            }
            Action::Back => self.zoomed = None,
            Action::Pan(_, y) if self.focused() == Some(PaneId::Dialogue) => {
                self.scroll(if y > 0.0 { -1 } else { 1 });
            }
            Action::Pan(x, y) => self.view.pan(bounds, x, y),
            Action::Scroll(by) => self.scroll(by),
            Action::Magnify(factor) => self.view.magnify(factor),
            Action::Fit => self.view = View::default(),
            Action::Chart(by) => self.change_chart(by),
            Action::Select(by) => self.select(by),
            Action::Chains => {
                self.look.chains = match self.look.chains {
                    Chains::Off => Chains::Force,
                    Chains::Force => Chains::Tangential,
                    Chains::Tangential => Chains::Off,
                };
            }
            Action::Discs => self.look.discs = !self.look.discs,
            Action::Velocities => self.look.velocities = !self.look.velocities,
            Action::Points => {
                self.look.points = match self.look.points {
                    Points::Braille => Points::HalfBlock,
                    Points::HalfBlock => Points::Ascii,
                    Points::Ascii => Points::Braille,
                };
            }
            Action::Theme => {
                self.look.theme = if self.look.theme == Theme::Mono {
                    Theme::Colour
                } else {
                    Theme::Mono
                };
            }
            Action::Fps(up) => self.link.change_fps(up),
            Action::Pace(up) => {
                let rate = self
                    .frame
                    .as_ref()
                    .map_or(1000.0, |frame| frame.rate.max(10.0));
                let now = self.pace.unwrap_or(rate);
                return Effect::Order(Order::Pace(Some(
                    (if up { 2.0 } else { 0.5 } * now).max(1.0),
                )));
            }
            Action::Flat => return Effect::Order(Order::Pace(None)),
            Action::Acknowledge => {
                self.unseen = 0;
                self.selected = self
                    .warnings
                    .last()
                    .and_then(|w| w.particle)
                    .or(self.selected);
            }
            Action::Repaint => return Effect::Repaint,
            Action::Suspend => return Effect::Suspend,
            Action::Pane(_) => {}
        }
        Effect::None
    }

    /// The pane in focus.
    pub fn focused(&self) -> Option<PaneId> {
        self.zoomed
            .or_else(|| self.arrangement.panes.get(self.focus).map(|(id, _)| *id))
    }

    fn move_focus(&mut self, by: isize) {
        let count = self.arrangement.panes.len().max(1) as isize;
        let zoomed = self.zoomed.is_some();
        self.focus = (self.focus as isize + by).rem_euclid(count) as usize;
        if zoomed {
            self.zoomed = None;
        }
    }

    fn scroll(&mut self, by: isize) {
        let most = self.dialogue.len();
        self.scrolled = self.scrolled.saturating_add_signed(-by).min(most);
    }

    /// The chart in focus, or the first one, shows another column.
    fn change_chart(&mut self, by: isize) {
        let slot = match self.focused() {
            Some(PaneId::Chart(slot)) => slot,
            _ => 0,
        };
        let count = self.series.columns.len() as isize;
        let Some(chart) = self.charts.get_mut(slot).filter(|_| count > 0) else {
            return;
        };
        let at = self.series.position(chart).map_or(0, |at| at as isize + by);
        *chart = self.series.columns[at.rem_euclid(count) as usize].name();
    }

    fn select(&mut self, by: isize) {
        let Some(frame) = &self.frame else { return };
        let discs = &frame.picture.discs;
        if discs.is_empty() {
            return;
        }
        let at = self
            .selected
            .and_then(|id| discs.iter().position(|disc| disc.id == id));
        let next = match at {
            None => 0,
            Some(at) => (at as isize + by).rem_euclid(discs.len() as isize) as usize,
        };
        self.selected = Some(discs[next].id);
    }

    /// Draws everything; answers where the cursor stands.
    pub fn draw(&mut self, area: Rect, buffer: &mut Buffer) -> Option<(u16, u16)> {
        self.arrangement = layout::arrange(area, self.zoomed);
        let a = self.arrangement.clone();
        if self.zoomed.is_none() {
            self.focus = self.focus.min(a.panes.len().saturating_sub(1));
        }
        panes::status::draw(self, a.status, buffer);
        for (number, (id, rect)) in a.panes.iter().enumerate() {
            let number = if self.zoomed.is_some() {
                self.focus
            } else {
                number
            };
            if a.class == Class::Numbers {
                (panes::row(*id).draw)(self, *id, *rect, buffer);
            } else {
                panes::draw(self, *id, number, *rect, buffer);
            }
        }
        panes::dialogue::last(self, a.last, buffer);
        panes::status::hints(self, a.hints, buffer);
        let cursor = panes::dialogue::prompt(self, a.prompt, buffer);
        match self.overlay {
            Some(Overlay::Help(at)) => {
                let at = panes::help::draw(self, at, area, buffer);
                self.overlay = Some(Overlay::Help(at));
            }
            Some(Overlay::Presets(at)) => panes::presets::draw(self, at, area, buffer),
            Some(Overlay::Quit) => panes::help::ask(self, area, buffer),
            None => {}
        }
        if self.overlay.is_some() { None } else { cursor }
    }
}

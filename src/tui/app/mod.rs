//! State of the screen: what it shows, what has the focus, what was typed. Knows no terminal.

mod acting;
mod dialogue;
mod places;
mod reports;
pub mod words;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::symbols::border;

use crate::session::frames::Frame;
use crate::session::worker::Order;
use crate::tui::layout::{self, Arrangement, Class};
use crate::tui::link::Link;
use crate::tui::look::{Look, Points};
use crate::tui::panes::{self, PaneId};
use crate::tui::prompt::Prompt;
use crate::tui::scale::round_up;
use crate::tui::series::Series;
use crate::tui::trail::Trail;
use crate::tui::view::View;

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

/// State of the screen.
pub struct App {
    /// Newest frame.
    pub frame: Option<Box<Frame>>,
    /// Histories.
    pub series: Series,
    /// Where the stress has been, as far as frames carried it.
    pub trail: Trail,
    /// Prompt.
    pub prompt: Prompt,
    /// What was said.
    pub dialogue: Vec<Said>,
    /// Lines scrolled back in the dialogue, as they stand in its pane.
    pub scrolled: usize,
    /// Number of the pane in focus.
    pub focus: usize,
    /// The pane that fills the screen.
    pub zoomed: Option<PaneId>,
    /// Part of the assembly that is seen.
    pub view: View,
    /// Speed that the longest stroke of a velocity stands for [m/s].
    pub stroke: f64,
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
    /// How far panes have been turned to other drawings.
    pub turned: Vec<(PaneId, usize)>,
    /// Panes that stand in other places than usual: kind of screen, number of the place, pane.
    pub placed: Vec<(Class, usize, PaneId)>,
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
    /// All of the screen.
    area: Rect,
    /// Where in the dialogue an answer begins that is to be read from its beginning.
    unread: Option<usize>,
    /// Pane that gets the focus as soon as it is on the screen.
    sought: Option<PaneId>,
}

impl App {
    /// An empty screen.
    pub fn new(look: Look, link: Link) -> Self {
        Self {
            frame: None,
            series: Series::default(),
            trail: Trail::default(),
            prompt: Prompt::default(),
            dialogue: Vec::new(),
            scrolled: 0,
            focus: 0,
            zoomed: None,
            view: View::default(),
            stroke: 0.0,
            look,
            link,
            overlay: None,
            selected: None,
            charts: ["sin_phi", "isotropic_stress", "coordination", "unbalanced"]
                .map(str::to_owned)
                .to_vec(),
            turned: Vec::new(),
            placed: Vec::new(),
            warnings: Vec::new(),
            unseen: 0,
            failure: None,
            pace: None,
            dirty: true,
            kept_cycle: 0,
            folder: String::new(),
            arrangement: layout::arrange(Rect::default(), None, false, 1),
            area: Rect::default(),
            unread: None,
            sought: None,
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
        self.trail.take(&frame);
        self.series.take(&mut frame);
        if restarted
            && self
                .frame
                .as_ref()
                .is_none_or(|old| old.preset != frame.preset)
        {
            self.begin();
        }
        // Who goes back to an earlier state has exported no more than that.
        self.kept_cycle = self.kept_cycle.min(frame.cycle);
        let before = self.frame.as_ref().map_or(0, |old| old.fracc.warnings);
        if frame.fracc.warnings > before
            && let Some((cycle, particle, fracc)) = frame.fracc.last
        {
            let more = frame.fracc.warnings - before;
            let text = format!("FRACC {fracc:.3} > 0.3, {more} cycles");
            self.warn(Warning {
                cycle,
                particle: Some(particle),
                text,
            });
        }
        self.stroke = stroke(self.stroke, frame.picture.fastest);
        self.frame = Some(frame);
        self.dirty = true;
    }

    /// A new run: what belonged to the old one goes.
    fn begin(&mut self) {
        self.view = View::default();
        self.stroke = 0.0;
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
            .map(crate::language::Observable::name)
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

    /// Draws everything; answers where the cursor stands.
    pub fn draw(&mut self, area: Rect, buffer: &mut Buffer) -> Option<(u16, u16)> {
        self.arrange(area);
        self.settle_dialogue();
        let a = self.arrangement.clone();
        panes::status::draw(self, a.status, buffer);
        for (number, (id, rect)) in a.panes.iter().enumerate() {
            let number = if self.zoomed.is_some() {
                self.focus
            } else {
                number
            };
            if a.class == Class::Numbers {
                panes::draw_bare(self, *id, *rect, buffer);
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

/// Speed that the longest stroke stands for where it stood for `old` and this is the largest [m/s]: a
/// round number, which stays while the largest varies little about it.
fn stroke(old: f64, fastest: f64) -> f64 {
    if fastest <= old && fastest > 0.2 * old {
        old
    } else {
        round_up(fastest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_keep_their_length_while_the_largest_velocity_varies_a_little() {
        let mut now = 0.0;
        let strokes = [0.3, 0.45, 0.11, 0.09, 0.095, 0.11, 0.0].map(|fastest| {
            now = stroke(now, fastest);
            now
        });
        assert_eq!(strokes, [0.5, 0.5, 0.5, 0.1, 0.1, 0.2, round_up(0.0)]);
    }
}

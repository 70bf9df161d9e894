//! What keys and typed lines do to the screen, and what they ask of the run.

use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use super::{App, Effect, Overlay, Said, words};
use crate::language::Known;
use crate::measure::columns::Partner;
use crate::measure::frame::Touch;
use crate::scene::catalogue::PRESETS;
use crate::session::worker::Order;
use crate::tui::keys::{self, Action};
use crate::tui::look::{Chains, Points, Theme};
use crate::tui::panes::PaneId;
use crate::tui::prompt::Typed;
use crate::tui::view::{self, View};

impl App {
    /// Takes pasted text: every line that it ends is executed, as if typed; what follows waits in the
    /// prompt.
    pub fn paste(&mut self, text: &str) -> Vec<Effect> {
        self.dirty = true;
        let mut effects = Vec::new();
        // Terminals send line ends as Enter would: as carriage returns.
        for piece in text.split_inclusive(['\r', '\n']) {
            if !self.prompt.open {
                self.prompt.open_with("");
            }
            self.prompt.paste(piece);
            let typed = self.prompt.text().trim();
            let says = !typed.is_empty() && !typed.starts_with('#');
            let ends = piece.ends_with(['\r', '\n']);
            if ends && !says {
                self.prompt.open_with("");
                continue;
            }
            if ends && let Typed::Line(line) = self.prompt.enter() {
                effects.push(self.line(&line));
            }
        }
        effects
    }

    /// Takes a key.
    pub fn key(&mut self, event: KeyEvent) -> Effect {
        self.dirty = true;
        if self.prompt.open && matches!(event.code, KeyCode::PageUp | KeyCode::PageDown) {
            let up = event.code == KeyCode::PageUp;
            self.scroll_pages(if up { -1 } else { 1 });
            return Effect::None;
        }
        if self.prompt.open {
            let nothing = Known::default();
            let known = self.frame.as_ref().map(|frame| Arc::clone(&frame.known));
            return match self.prompt.key(event, known.as_deref().unwrap_or(&nothing)) {
                Typed::Editing | Typed::Left => Effect::None,
                Typed::Line(line) => self.line(&line),
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
    fn line(&mut self, line: &str) -> Effect {
        // The prompt stays open after a command; a colon before the next one is habit.
        let line = line.trim_start_matches(':').trim().to_owned();
        match line.as_str() {
            "q!" | "quit!" => return Effect::Quit,
            "q" | "quit" => return self.quit(false),
            _ => {}
        }
        if let Some(page) = words::help(&line) {
            self.say(Said::Line(line));
            self.answer(page.into_iter().map(Said::Answer).collect());
        } else if let Some((word, rest)) = words::find(&line) {
            self.say(Said::Line(line.clone()));
            match self.act_on(word, rest) {
                Ok((answer, effect)) => {
                    if !answer.is_empty() {
                        self.answer(vec![Said::Answer(answer)]);
                    }
                    return effect;
                }
                Err(refusal) => self.answer(vec![Said::Error(refusal)]),
            }
        } else if let Some(mistake) = words::mistaken(&line) {
            self.say(Said::Line(line));
            self.answer(vec![Said::Error(mistake)]);
        } else {
            return Effect::Order(Order::Line(line));
        }
        Effect::None
    }

    pub(super) fn quit(&mut self, anyway: bool) -> Effect {
        let unsaved = self
            .frame
            .as_ref()
            .is_some_and(|frame| frame.cycle > self.kept_cycle);
        if anyway || !unsaved {
            return Effect::Quit;
        }
        // The answer is a key, not a line.
        self.prompt.open = false;
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
                let page = self.overlay_page() as isize;
                Some(Overlay::Help(at.saturating_add_signed((by * page) as i16)))
            }
            (Overlay::Presets(at), Action::Scroll(by)) => {
                let page = self.overlay_page() as isize;
                let at = at.saturating_add_signed(by * page).min(last);
                Some(Overlay::Presets(at))
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
            .map_or([[0.0; 2], [1.0; 2]], |frame| view::fitted(&frame.picture));
        match action {
            Action::Toggle => {
                // A run that still cannot go on says so again.
                self.failure = None;
                return Effect::Order(Order::Toggle);
            }
            Action::Cycle => return Effect::Order(Order::Line("cycle 1".into())),
            Action::Row => return Effect::Order(Order::Row),
            Action::Prompt => self.prompt.open_with(""),
            Action::PromptWith(text) => self.prompt.open_with(text),
            Action::Help => self.overlay = Some(Overlay::Help(0)),
            Action::Presets => self.overlay = Some(Overlay::Presets(0)),
            Action::Interrupt if running => return Effect::Order(Order::Pause),
            Action::Quit | Action::Interrupt => return self.quit(false),
            Action::Focus(by) => self.move_focus(by),
            Action::Pane(number) if self.is_single() => self.show_numbered(number),
            Action::Pane(number) if number < self.arrangement.panes.len() => self.focus = number,
            Action::Zoom if self.is_single() => self.show_other(),
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
            Action::Scroll(by) => self.scroll_pages(by),
            Action::Magnify(factor) => self.view.magnify(factor),
            Action::Fit => self.view = View::default(),
            Action::Turn(by) => self.turn(by),
            Action::Place(by) => self.place_next(by),
            Action::Select(by) => self.select(by),
            Action::Contact(by) => return self.follow(by),
            Action::Chains => {
                self.look.chains = match self.look.chains {
                    Chains::Off => Chains::Force,
                    Chains::Force => Chains::Tangential,
                    Chains::Tangential => Chains::Off,
                };
            }
            Action::Discs => self.look.discs = !self.look.discs,
            Action::Velocities => self.look.velocities = !self.look.velocities,
            Action::Compare => self.look.compared = self.look.compared.next(),
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

    /// Follows another contact: of the selected disc, or any if none is selected.
    fn follow(&mut self, by: isize) -> Effect {
        let Some(frame) = &self.frame else {
            return Effect::None;
        };
        let wall = |touch: &Touch| {
            let wall = frame.picture.walls.get(touch.wall?)?;
            Some(Partner::Wall(wall.name.clone()))
        };
        let of_disc = |touch: &&Touch| match self.selected {
            Some(id) => touch.first == id || touch.second == Some(id),
            None => true,
        };
        let found = frame.picture.touches.iter().filter(of_disc);
        let found = found.filter_map(|touch| {
            let partner = touch
                .second
                .map(Partner::Particle)
                .or_else(|| wall(touch))?;
            Some((touch.first, partner))
        });
        let contacts: Vec<(u32, Partner)> = found.collect();
        if contacts.is_empty() {
            self.say(Said::Error(match self.selected {
                Some(id) => format!("disc {id} touches nothing; n selects another"),
                None => "nothing touches yet".to_owned(),
            }));
            return Effect::None;
        }
        let name = |(i, partner): &(u32, Partner)| match partner {
            Partner::Particle(j) => format!("{i}-{j}"),
            Partner::Wall(wall) => format!("{i}-{wall}"),
        };
        let now = frame.contact.as_ref().map(|contact| &contact.name);
        let at = contacts
            .iter()
            .position(|contact| Some(&name(contact)) == now);
        let next = match at {
            None => 0,
            Some(at) => (at as isize + by).rem_euclid(contacts.len() as isize) as usize,
        };
        let (i, partner) = contacts[next].clone();
        self.seek(PaneId::Contact);
        Effect::Order(Order::Follow(i, partner))
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
}

//! Which pane stands where, and which of its drawings it shows.

use ratatui::layout::Rect;

use super::App;
use crate::language::mistake::{either, shown};
use crate::measure::columns::nearest;
use crate::session::frames::Wants;
use crate::tui::layout::{self, Class};
use crate::tui::panes::{self, PANES, PaneId};

impl App {
    /// The pane in focus.
    pub fn focused(&self) -> Option<PaneId> {
        self.zoomed
            .or_else(|| self.arrangement.panes.get(self.focus).map(|(id, _)| *id))
    }

    /// Where a pane stands, if it is on the screen.
    pub fn place_of(&self, id: PaneId) -> Option<Rect> {
        let mut panes = self.arrangement.panes.iter();
        panes.find(|(known, _)| *known == id).map(|(_, area)| *area)
    }

    pub(super) fn move_focus(&mut self, by: isize) {
        if self.is_single() {
            return self.place_next(by);
        }
        let count = self.arrangement.panes.len().max(1) as isize;
        let zoomed = self.zoomed.is_some();
        self.focus = (self.focus as isize + by).rem_euclid(count) as usize;
        if zoomed {
            self.zoomed = None;
        }
    }

    /// Finds out what stands where on a screen of this size.
    pub(super) fn arrange(&mut self, area: Rect) {
        self.area = area;
        let follows = self.frame.as_ref().is_some_and(|f| f.contact.is_some());
        let mut lines = 1;
        // Whether the dialogue is in sight decides how much has to be said below the panes.
        for _ in 0..2 {
            self.arrangement = layout::arrange(area, self.zoomed, follows, lines);
            self.place();
            lines = self.lines_at_bottom();
        }
        if self.zoomed.is_some() {
            return;
        }
        let panes = &self.arrangement.panes;
        let sought = panes.iter().position(|(id, _)| Some(*id) == self.sought);
        if let Some(place) = sought {
            self.focus = place;
            self.sought = None;
        }
        self.focus = self.focus.min(panes.len().saturating_sub(1));
    }

    /// What the panes on the screen need of a frame. The picture is always needed: keys choose discs
    /// and contacts out of it, of the selected disc too where no pane shows it.
    pub fn wants(&self) -> Wants {
        let mut wants = Wants {
            energies: false,
            velocities: false,
            limit: false,
            selected: self.selected,
            ..Wants::default()
        };
        for (id, _) in &self.arrangement.panes {
            (panes::row(*id).wants)(self, *id, &mut wants);
        }
        wants
    }

    /// Which of its drawings a pane shows.
    pub fn face(&self, id: PaneId) -> usize {
        let count = panes::row(id).faces.len().max(1);
        // Roses beside each other show different weights.
        let first = match id {
            PaneId::Rose(slot) => slot,
            _ => 0,
        };
        let turned = self.turned.iter().find(|(known, _)| *known == id);
        (first + turned.map_or(0, |(_, by)| *by)) % count
    }

    /// The pane in focus shows another of its drawings, a chart another column; where there is no
    /// choice, the first chart does.
    pub(super) fn turn(&mut self, by: isize) {
        let focused = self.focused();
        let faces = focused.map_or(0, |id| panes::row(id).faces.len());
        if let (Some(id), 1..) = (focused, faces) {
            let next = by.rem_euclid(faces as isize) as usize;
            match self.turned.iter_mut().find(|(known, _)| *known == id) {
                Some((_, turned)) => *turned = (*turned + next) % faces,
                None => self.turned.push((id, next)),
            }
            return;
        }
        let slot = match focused {
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

    /// Puts panes where they were sent.
    fn place(&mut self) {
        if self.zoomed.is_some() {
            return;
        }
        let a = &mut self.arrangement;
        for (class, number, id) in &self.placed {
            if let Some(place) = a.panes.get_mut(*number).filter(|_| *class == a.class) {
                place.0 = *id;
            }
        }
    }

    /// Whether the screen has room for one pane only, so that keys choose which.
    pub(super) fn is_single(&self) -> bool {
        self.arrangement.class == Class::Numbers
    }

    /// Where there is room for one pane: the one of this number in the list of panes.
    pub(super) fn show_numbered(&mut self, number: usize) {
        if let Some((id, _)) = PANES.get(number) {
            self.zoomed = None;
            self.put(0, *id);
        }
    }

    /// Where there is room for one pane: the assembly, or the numbers instead of anything else.
    pub(super) fn show_other(&mut self) {
        let id = match self.focused() {
            Some(PaneId::Numbers) => PaneId::Assembly,
            _ => PaneId::Numbers,
        };
        self.zoomed = None;
        self.put(0, id);
    }

    /// The focus goes to a pane as soon as that is on the screen.
    pub(super) fn seek(&mut self, id: PaneId) {
        if self.is_single() {
            self.zoomed = None;
            self.put(0, id);
        } else {
            self.sought = Some(id);
        }
    }

    /// The next pane of the list in the place in focus; the assembly keeps its own.
    pub(super) fn place_next(&mut self, by: isize) {
        let others: Vec<PaneId> = PANES
            .iter()
            .map(|(id, _)| *id)
            .filter(|id| *id != PaneId::Assembly || self.is_single())
            .collect();
        let number = self.place_number();
        let now = self
            .zoomed
            .or_else(|| self.arrangement.panes.get(number).map(|(id, _)| *id));
        let kind = |id: &PaneId| std::mem::discriminant(id);
        let at = others
            .iter()
            .position(|id| now.as_ref().is_some_and(|now| kind(now) == kind(id)));
        let next = at.map_or(0, |at| {
            (at as isize + by).rem_euclid(others.len() as isize) as usize
        });
        if self.is_single() {
            self.zoomed = None;
        }
        self.put(number, others[next]);
    }

    /// A pane by its name or the beginning of it, in the place in focus; or why there is none.
    pub(super) fn place_by_name(&mut self, name: &str) -> Result<(), String> {
        let typed = name.to_lowercase();
        let choice = || {
            PANES
                .iter()
                .filter(|(id, _)| *id != PaneId::Assembly || self.is_single())
        };
        let names: Vec<&str> = choice().map(|(_, pane)| pane.name).collect();
        if typed.is_empty() {
            return Err(format!(
                "`pane` needs a name; there is {}",
                names.join(", ")
            ));
        }
        let mut found: Vec<(PaneId, &str)> = choice()
            .map(|(id, pane)| (*id, pane.name))
            .filter(|(_, name)| name.starts_with(&typed))
            .collect();
        if found.iter().any(|(_, name)| *name == typed) {
            found.retain(|(_, name)| *name == typed);
        }
        match found[..] {
            [(id, _)] => {
                if self.is_single() {
                    self.zoomed = None;
                }
                self.put(self.place_number(), id);
                Ok(())
            }
            [] if "assembly".starts_with(&typed) => {
                Err("the assembly keeps its place; Tab or 1 goes there, z enlarges it".to_owned())
            }
            [] => Err(format!(
                "{} is no pane; {}",
                shown(name),
                nearest(name, names.into_iter())
            )),
            _ => {
                let names: Vec<&str> = found.iter().map(|(_, name)| *name).collect();
                let name = shown(name);
                Err(format!(
                    "{name} could be {}; write more of it",
                    either(&names)
                ))
            }
        }
    }

    /// The place that takes another pane: the one in focus, but that of the assembly.
    fn place_number(&self) -> usize {
        if self.is_single() {
            return 0;
        }
        let is_assembly = self.focused() == Some(PaneId::Assembly);
        if is_assembly && self.focus == 0 {
            1
        } else {
            self.focus
        }
    }

    fn put(&mut self, number: usize, id: PaneId) {
        let class = self.arrangement.class;
        // Of charts and roses there are several: one that is not on the screen.
        let shown = |id: PaneId| {
            let panes = self.arrangement.panes.iter().enumerate();
            let mut others = panes.filter(|(place, _)| *place != number);
            others.any(|(_, (known, _))| *known == id)
        };
        let of_several = |all: &[PaneId]| all.iter().copied().find(|id| !shown(*id));
        let id = match id {
            PaneId::Chart(_) => of_several(&[0, 1, 2, 3].map(PaneId::Chart)).unwrap_or(id),
            PaneId::Rose(_) => of_several(&[0, 1].map(PaneId::Rose)).unwrap_or(id),
            _ => id,
        };
        self.placed
            .retain(|(kind, place, _)| (*kind, *place) != (class, number));
        self.placed.push((class, number, id));
        self.focus = number;
        if self.zoomed.is_some() {
            self.zoomed = Some(id);
        }
    }
}

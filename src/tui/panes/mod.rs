//! What can be looked at: one file per pane, one line here.

pub mod assembly;
pub mod chart;
pub mod contact;
pub mod dialogue;
pub mod energy;
pub mod help;
pub mod histogram;
pub mod mohr;
pub mod monitor;
pub mod numbers;
pub mod path;
pub mod polygon;
pub mod presets;
pub mod profile;
pub mod rose;
pub mod status;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Widget};

use super::app::App;
use super::look::Role;
use super::write;
use crate::session::frames::Wants;

/// Which pane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PaneId {
    /// Discs, forces, walls.
    Assembly,
    /// Chart in a slot.
    Chart(usize),
    /// The contact that is followed.
    Contact,
    /// Rose of contact normals in a slot.
    Rose(usize),
    /// How contacts share out over what they carry.
    Histogram,
    /// Deviator stress over mean stress.
    StressPath,
    /// Circles of Mohr.
    MohrCircle,
    /// Forces on the selected disc, head to tail.
    ForcePolygon,
    /// Porosity by distance.
    Profile,
    /// FRACC, stability bound, warnings.
    Monitor,
    /// Values of the columns.
    Numbers,
    /// Energy ledger.
    Energy,
    /// What was said.
    Dialogue,
}

/// A pane's row in the list.
pub struct Pane {
    /// Word for it.
    pub name: &'static str,
    /// What it shows, one line.
    pub summary: &'static str,
    /// Title of the pane as it is. What follows two blanks is left out where there is no room.
    pub title: fn(&App, PaneId) -> String,
    /// Draws the inside.
    pub draw: fn(&App, PaneId, Rect, &mut Buffer),
    /// Adds what it draws to what frames have to carry.
    pub wants: fn(&App, PaneId, &mut Wants),
    /// Names of the drawings that it can be turned to; none if there is one only.
    pub faces: &'static [&'static str],
}

impl Pane {
    /// A pane with one drawing of what every frame carries; a row overrides what is different.
    pub const PLAIN: Self = Self {
        name: "",
        summary: "",
        title: |_, _| String::new(),
        draw: |_, _, _, _| {},
        wants: |_, _, _| {},
        faces: &[],
    };
}

/// All panes.
pub const PANES: &[(PaneId, Pane)] = &[
    (PaneId::Assembly, assembly::PANE),
    (PaneId::Chart(0), chart::PANE),
    (PaneId::Contact, contact::PANE),
    (PaneId::Rose(0), rose::PANE),
    (PaneId::Histogram, histogram::PANE),
    (PaneId::StressPath, path::PANE),
    (PaneId::MohrCircle, mohr::PANE),
    (PaneId::ForcePolygon, polygon::PANE),
    (PaneId::Profile, profile::PANE),
    (PaneId::Monitor, monitor::PANE),
    (PaneId::Numbers, numbers::PANE),
    (PaneId::Energy, energy::PANE),
    (PaneId::Dialogue, dialogue::PANE),
];

/// The row of a pane.
pub fn row(id: PaneId) -> &'static Pane {
    let kind = |id: PaneId| std::mem::discriminant(&id);
    let found = PANES.iter().find(|(known, _)| kind(*known) == kind(id));
    found
        .map(|(_, pane)| pane)
        .expect("every pane is in the list, a test walks through them")
}

/// Markdown table of the panes.
pub fn reference_table() -> String {
    let mut text = String::from("| pane | what it shows | drawings |\n|---|---|---|\n");
    for (_, pane) in PANES {
        let faces = pane.faces.iter().map(|face| match face.split_once("  ") {
            Some((short, _)) => short,
            None => face,
        });
        let faces: Vec<&str> = faces.collect();
        let (summary, faces) = (pane.summary, faces.join("; "));
        let row = format!("| {} | {summary} | {faces} |\n", pane.name);
        text.push_str(&row.replace("|T|", "\\|T\\|").replace("<N>", "&lt;N&gt;"));
    }
    text
}

/// Draws a pane with its frame.
pub fn draw(app: &App, id: PaneId, number: usize, area: Rect, buffer: &mut Buffer) {
    let pane = row(id);
    let focused = app.focus == number;
    let role = if focused { Role::Focus } else { Role::Frame };
    let room = usize::from(area.width).saturating_sub(6);
    let title = title(app, id, room);
    // Keys choose the first nine.
    let title = match number {
        0..9 => format!(" {} {title} ", number + 1),
        _ => format!(" {title} "),
    };
    let title = write::shown(&app.look, &title);
    let block = Block::bordered()
        .border_set(app.border())
        .border_style(app.look.style(role))
        .title(title);
    let inner = block.inner(area);
    block.render(area, buffer);
    if !inner.is_empty() {
        (pane.draw)(app, id, inner, buffer);
    }
}

/// Least lines of a small screen that a title may take one of.
const TITLED: u16 = 4;

/// Draws the only pane of a small screen: without a frame, and with a title where there is room and
/// the pane is not the usual one.
pub fn draw_bare(app: &App, id: PaneId, area: Rect, buffer: &mut Buffer) {
    let pane = row(id);
    let mut inside = area;
    if id != PaneId::Numbers && area.height >= TITLED {
        let title = title(app, id, usize::from(area.width));
        write::at(&app.look, (area, &mut *buffer), (0, 0), &title, Role::Value);
        inside.y += 1;
        inside.height -= 1;
    }
    (pane.draw)(app, id, inside, buffer);
}

/// Title of a pane in so many columns, with the cycle that it is about if that is not the frame's.
fn title(app: &App, id: PaneId, room: usize) -> String {
    let title = (row(id).title)(app, id);
    let title = match measured_before(app, id) {
        None => title,
        Some(cycle) => write::dated(&title, &status::grouped(cycle), room),
    };
    write::fitting(&title, room).to_owned()
}

/// Cycle that the measures which a pane shows belong to, if it is not that of the frame.
fn measured_before(app: &App, id: PaneId) -> Option<u64> {
    let frame = app.frame.as_ref()?;
    let mut wants = Wants {
        energies: false,
        ..Wants::default()
    };
    (row(id).wants)(app, id, &mut wants);
    (wants.measures() && frame.measures_of != frame.cycle).then_some(frame.measures_of)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pane_has_its_row() {
        for (id, pane) in PANES {
            assert_eq!(row(*id).name, pane.name);
        }
        assert_eq!(row(PaneId::Chart(3)).name, "chart");
    }
}

//! Where the energy is and where it went.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::engine::ledger::{Bookings, Energies};
use crate::tui::app::App;
use crate::tui::look::Role;
use crate::tui::scale::{round_up, short};
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "energy",
    summary: "energies, losses, work, and what the balance fails to close by",
    title: |_, _| "energy [J]".into(),
    draw,
    wants: |_, _, wants| wants.energies = true,
    ..Pane::PLAIN
};

/// Stored now.
fn stored(energies: &Energies) -> [(&'static str, f64); 5] {
    [
        ("kinetic", energies.kinetic),
        ("rotational", energies.rotational),
        ("normal springs", energies.elastic_normal),
        ("shear springs", energies.elastic_tangential),
        ("potential", energies.potential),
    ]
}

/// Gone or come in since the start.
fn flows(bookings: &Bookings) -> Vec<(&'static str, f64)> {
    let mut flows = vec![
        ("boundary work", bookings.boundary_work),
        ("lost: friction", bookings.friction_loss),
        ("lost: dashpots", bookings.damping_loss),
        ("lost: global", bookings.global_loss),
    ];
    if bookings.bond_loss != 0.0 {
        flows.push(("lost: bonds", bookings.bond_loss));
    }
    flows
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let mut lines = Lines::new(&app.look, area, buffer);
    let Some(frame) = &app.frame else {
        return;
    };
    let Some(energies) = &frame.energies else {
        lines.text("energies are not measured for this screen", Role::Label);
        return;
    };
    let mut rows = stored(energies).to_vec();
    if let Some(bookings) = &frame.bookings {
        // The work first: it is what the losses are compared with.
        rows.extend(flows(bookings));
    }
    let largest = rows.iter().map(|(_, value)| value.abs());
    let largest = largest.filter(|v| v.is_finite()).fold(0.0, f64::max);
    let room = usize::from(area.width).saturating_sub(14 + 2 + 11 + 1);
    // A row is kept for what follows if not all fit.
    let most = usize::from(area.height).saturating_sub(1);
    if rows.len() > most {
        rows.retain(|(_, value)| *value != 0.0);
    }
    for (name, value) in rows.iter().take(most) {
        let number = format!("{:>11} ", short(*value));
        let bar = if room >= 5 && largest > 0.0 {
            bar(app, *value / round_up(largest), room.min(40))
        } else {
            String::new()
        };
        lines.parts(&[
            (&format!("{name:14} "), Role::Label),
            (&number, Role::Value),
            (&bar, Role::Curve),
        ]);
    }
    match &frame.bookings {
        Some(bookings) => {
            let error = format!("{:>11}", short(bookings.energy_error));
            let role = if bookings.energy_error.abs() > 0.01 {
                Role::Warning
            } else {
                Role::Value
            };
            lines.parts(&[("relative error ", Role::Label), (&error, role)]);
        }
        None => lines.text(
            "losses and work are not booked: name energy_error in [history] columns of the \
             preset and start it again",
            Role::Label,
        ),
    }
}

/// Filled as far as the share, with the sign of a negative one.
fn bar(app: &App, share: f64, width: usize) -> String {
    let filled = (share.abs().min(1.0) * width as f64).round() as usize;
    let full = write::gauge(&app.look, 1.0, filled);
    if share < 0.0 {
        format!("-{}", full.chars().skip(1).collect::<String>())
    } else {
        full
    }
}

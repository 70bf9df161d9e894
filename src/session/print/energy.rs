//! PRINT ENERGY: what is stored, what was lost, what was put in, and whether it adds up.

use super::super::figure::figure;
use super::layout::listed;
use crate::engine::World;

/// The table.
pub(super) fn lines(world: &World) -> Vec<String> {
    let e = world.energies();
    let joules = |x: f64| format!("{} J", figure(x));
    let mut rows = vec![
        ("kinetic", joules(e.kinetic)),
        ("rotational", joules(e.rotational)),
        ("elastic, normal", joules(e.elastic_normal)),
        ("elastic, tangential", joules(e.elastic_tangential)),
        ("potential", joules(e.potential)),
    ];
    let Some(b) = world.bookings() else {
        let mut lines = listed(&rows);
        lines.push(
            "losses and work are not booked: name energy_error in [history] columns of the preset"
                .into(),
        );
        return lines;
    };
    rows.push(("lost by friction", joules(b.friction_loss)));
    rows.push(if world.model().law.has_bonds() {
        ("lost with broken bonds", joules(b.bond_loss))
    } else {
        ("of it slip in contacts", joules(b.slip_loss))
    });
    rows.extend([
        ("lost in contact dashpots", joules(b.damping_loss)),
        ("lost by global damping", joules(b.global_loss)),
        ("work put in", joules(b.boundary_work)),
        ("energy error", figure(b.energy_error)),
    ]);
    listed(&rows)
}

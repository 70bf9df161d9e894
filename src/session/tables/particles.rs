//! Particles: where they are, how they move, what acts on them, how far they are from where they were
//! at the reference.

use crate::measure::assembly::degrees;
use crate::measure::load::load;
use crate::measure::sample::Sample;
use crate::record::number::Cell;
use crate::record::table::CsvTable;

/// In ascending number. Units: m, rad, m/s, rad/s, N, N m.
const COLUMNS: [&str; 16] = [
    "ball", "material", "radius", "x", "y", "angle", "vx", "vy", "spin", "fx", "fy", "moment",
    "contacts", "ux", "uy", "rotation",
];

/// The table.
pub(super) fn table(sample: &Sample<'_>) -> CsvTable {
    let world = sample.world();
    let (particles, degrees) = (world.particles(), degrees(world));
    let mut table = CsvTable::new(&COLUMNS);
    for (p, &degree) in degrees.iter().enumerate() {
        let (id, row) = (particles.id[p], &particles.row[p]);
        let material = &world.model().materials[usize::from(particles.material[p])];
        let (x, (v, spin), (force, moment)) =
            (world.position(p), world.velocity(p), load(world, p));
        let change = sample.reference().and_then(|then| then.change(world, id));
        let (u, rotation) = change.unwrap_or(([f64::NAN; 2], f64::NAN));
        table.row(&[
            Cell::Count(u64::from(id)),
            Cell::name(&material.name),
            Cell::Real(row.radius),
            Cell::Real(x[0]),
            Cell::Real(x[1]),
            Cell::Real(row.angle),
            Cell::Real(v[0]),
            Cell::Real(v[1]),
            Cell::Real(spin),
            Cell::Real(force[0]),
            Cell::Real(force[1]),
            Cell::Real(moment),
            Cell::Count(u64::from(degree)),
            Cell::Real(u[0]),
            Cell::Real(u[1]),
            Cell::Real(rotation),
        ]);
    }
    table
}

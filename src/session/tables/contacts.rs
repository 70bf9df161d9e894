//! Contacts: those that touch, between which bodies, where, which way they point and what they carry.

use crate::engine::contact_report::Other;
use crate::measure::contact_area::ContactArea;
use crate::measure::link::Link;
use crate::measure::sample::Sample;
use crate::record::number::Cell;
use crate::record::table::CsvTable;

/// In the order of the list. `with` is the number of a particle or the name of a wall, x and y are
/// where the lever arm of the first one ends, n1 and n2 the normal from it. Units: m, N, Pa.
const COLUMNS: [&str; 14] = [
    "ball", "with", "x", "y", "n1", "n2", "n", "t", "overlap", "mu", "sliding", "a", "sigma_n",
    "sigma_t",
];

/// The table.
pub(super) fn table(sample: &Sample<'_>) -> CsvTable {
    let world = sample.world();
    let mut table = CsvTable::new(&COLUMNS);
    let id = |p: usize| world.particles().id[p];
    for link in Link::all(world) {
        let with = match link.other {
            Other::Particle(j) => id(j).to_string(),
            Other::Wall(w) => world.walls()[w].name.clone(),
        };
        let from = world.position(link.first);
        let at = [0, 1].map(|k| from[k] + link.arms[0] * link.e[k]);
        let area = ContactArea::of(world, link.place);
        let [sigma_n, sigma_t] = area.stress(link.normal, link.tangential);
        table.row(&[
            Cell::Count(u64::from(id(link.first))),
            Cell::name(with),
            Cell::Real(at[0]),
            Cell::Real(at[1]),
            Cell::Real(link.e[0]),
            Cell::Real(link.e[1]),
            Cell::Real(link.normal),
            Cell::Real(link.tangential),
            Cell::Real(world.geometry(link.place).overlap),
            Cell::Real(world.pair_of(link.place).friction),
            Cell::Count(u64::from(link.sliding)),
            Cell::Real(area.radius),
            Cell::Real(sigma_n),
            Cell::Real(sigma_t),
        ]);
    }
    table
}

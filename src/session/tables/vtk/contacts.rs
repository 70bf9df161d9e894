//! Contacts for programs that draw in space: lines from centre to centre, or to the foot on a wall.

use crate::engine::contact_report::Other;
use crate::measure::contact_area::obliquity;
use crate::measure::link::Link;
use crate::measure::sample::Sample;
use crate::record::vtk::Polydata;

/// In the order of the list. `with` is the number of a particle, 0 at a wall; obliquity is NaN without
/// friction. SI units.
pub(super) fn lines(sample: &Sample<'_>, title: &str) -> Polydata {
    let world = sample.world();
    let links: Vec<Link> = Link::all(world).collect();
    let ends = links.iter().map(|link| {
        let from = world.position(link.first);
        let reach: f64 = link.arms.iter().sum();
        [from, [0, 1].map(|k| from[k] + reach * link.e[k])]
    });
    let mut data = Polydata::lines(title, ends.collect());
    let id = |p: usize| world.particles().id[p];
    data.whole("ball", links.iter().map(|link| id(link.first)));
    let with = links.iter().map(|link| match link.other {
        Other::Particle(second) => id(second),
        Other::Wall(_) => 0,
    });
    data.whole("with", with);
    data.scalar("n", links.iter().map(|link| link.normal));
    data.scalar("t", links.iter().map(|link| link.tangential));
    data.vector("force", links.iter().map(|link| link.force.into()));
    let overlap = |link: &Link| world.geometry(link.place).overlap;
    data.scalar("overlap", links.iter().map(overlap));
    let used = |link: &Link| obliquity(world, link.place);
    data.scalar("obliquity", links.iter().map(used));
    data.whole("sliding", links.iter().map(|link| u32::from(link.sliding)));
    data
}

//! Particles for programs that draw in space: points with what moves and acts on them.

use crate::measure::assembly::degrees;
use crate::measure::load::load;
use crate::measure::sample::Sample;
use crate::record::vtk::Polydata;

/// In ascending number; what there is no reference for is NaN. SI units.
pub(super) fn points(sample: &Sample<'_>, title: &str) -> Polydata {
    let world = sample.world();
    let particles = world.particles();
    let all = || 0..particles.len();
    let mut data = Polydata::points(title, all().map(|p| world.position(p)).collect());
    let change = |p: usize| sample.reference()?.change(world, particles.id[p]);
    let moved = |p| change(p).unwrap_or(([f64::NAN; 2], f64::NAN));
    data.whole("ball", particles.id.iter().copied());
    data.scalar("radius", particles.row.iter().map(|row| row.radius));
    let material = particles.material.iter().map(|m| u32::from(*m));
    data.whole("material", material);
    data.whole("contacts", degrees(world).into_iter());
    data.vector("velocity", all().map(|p| world.velocity(p).0));
    data.scalar("spin", all().map(|p| world.velocity(p).1));
    data.scalar("angle", particles.row.iter().map(|row| row.angle));
    data.vector("force", all().map(|p| load(world, p).0));
    data.scalar("moment", all().map(|p| load(world, p).1));
    data.vector("displacement", all().map(|p| moved(p).0));
    data.scalar("rotation", all().map(|p| moved(p).1));
    data
}

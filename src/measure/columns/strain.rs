//! Strain and its rate, compression positive. Without a region they are what the boundary imposes;
//! in a region they are what its particles have in common.

use super::card::Row;
use super::read::{Read, either};
use crate::measure::regional::Regional;
use crate::measure::sample::Sample;
use crate::measure::strain::Strain;
use crate::measure::tensor;

fn strain(region: &Regional<'_>, read: impl Fn(&Strain) -> f64) -> f64 {
    region.strain().map_or(f64::NAN, read)
}

const fn component(
    name: &'static str,
    summary: &'static str,
    world: fn(&Sample<'_>) -> f64,
    region: fn(&Regional<'_>) -> f64,
) -> Row<Read> {
    either(name, "-", summary, world, region)
}

const fn rate(
    name: &'static str,
    summary: &'static str,
    world: fn(&Sample<'_>) -> f64,
    region: fn(&Regional<'_>) -> f64,
) -> Row<Read> {
    either(name, "1/s", summary, world, region)
}

pub(super) const ROWS: &[Row<Read>] = &[
    component(
        "strain_11",
        "strain since the reference, imposed or best fit: displacement 1 along 1",
        |s| s.imposed_strain()[(0, 0)],
        |r| strain(r, |s| s.tensor[(0, 0)]),
    ),
    component(
        "strain_12",
        "strain since the reference, imposed or best fit: displacement 1 along 2",
        |s| s.imposed_strain()[(0, 1)],
        |r| strain(r, |s| s.tensor[(0, 1)]),
    ),
    component(
        "strain_21",
        "strain since the reference, imposed or best fit: displacement 2 along 1",
        |s| s.imposed_strain()[(1, 0)],
        |r| strain(r, |s| s.tensor[(1, 0)]),
    ),
    component(
        "strain_22",
        "strain since the reference, imposed or best fit: displacement 2 along 2",
        |s| s.imposed_strain()[(1, 1)],
        |r| strain(r, |s| s.tensor[(1, 1)]),
    ),
    component(
        "deviator_strain",
        "difference of the principal strains since the reference",
        |s| tensor::deviator(&s.imposed_strain()),
        |r| strain(r, Strain::deviator),
    ),
    component(
        "volumetric_strain",
        "sum of the principal strains since the reference",
        |s| s.imposed_strain().trace(),
        |r| strain(r, Strain::volumetric),
    ),
    rate(
        "strain_rate_11",
        "strain rate, imposed or best fit: velocity 1 along 1",
        |s| s.imposed_rate()[(0, 0)],
        |r| r.flow().rate[(0, 0)],
    ),
    rate(
        "strain_rate_12",
        "strain rate, imposed or best fit: velocity 1 along 2",
        |s| s.imposed_rate()[(0, 1)],
        |r| r.flow().rate[(0, 1)],
    ),
    rate(
        "strain_rate_21",
        "strain rate, imposed or best fit: velocity 2 along 1",
        |s| s.imposed_rate()[(1, 0)],
        |r| r.flow().rate[(1, 0)],
    ),
    rate(
        "strain_rate_22",
        "strain rate, imposed or best fit: velocity 2 along 2",
        |s| s.imposed_rate()[(1, 1)],
        |r| r.flow().rate[(1, 1)],
    ),
];

//! Strain of a region and its rate, compression positive: what its particles have in common. The same
//! names without a region belong to the strain that boundaries impose.

use super::card::Row;
use super::read::{Read, named};
use crate::measure::regional::Regional;
use crate::measure::strain::Strain;

fn strain(region: &Regional<'_>, read: impl Fn(&Strain) -> f64) -> f64 {
    region.strain().map_or(f64::NAN, read)
}

pub(super) const ROWS: &[Row<Read>] = &[
    named(
        "strain_11",
        "-",
        "strain since the reference: displacement 1 along 1",
        |r| strain(r, |s| s.tensor[(0, 0)]),
    ),
    named(
        "strain_12",
        "-",
        "strain since the reference: displacement 1 along 2",
        |r| strain(r, |s| s.tensor[(0, 1)]),
    ),
    named(
        "strain_21",
        "-",
        "strain since the reference: displacement 2 along 1",
        |r| strain(r, |s| s.tensor[(1, 0)]),
    ),
    named(
        "strain_22",
        "-",
        "strain since the reference: displacement 2 along 2",
        |r| strain(r, |s| s.tensor[(1, 1)]),
    ),
    named(
        "deviator_strain",
        "-",
        "difference of the principal strains since the reference",
        |r| strain(r, Strain::deviator),
    ),
    named(
        "volumetric_strain",
        "-",
        "sum of the principal strains since the reference",
        |r| strain(r, Strain::volumetric),
    ),
    named(
        "strain_rate_11",
        "1/s",
        "strain rate: velocity 1 along 1",
        |r| r.flow().rate[(0, 0)],
    ),
    named(
        "strain_rate_12",
        "1/s",
        "strain rate: velocity 1 along 2",
        |r| r.flow().rate[(0, 1)],
    ),
    named(
        "strain_rate_21",
        "1/s",
        "strain rate: velocity 2 along 1",
        |r| r.flow().rate[(1, 0)],
    ),
    named(
        "strain_rate_22",
        "1/s",
        "strain rate: velocity 2 along 2",
        |r| r.flow().rate[(1, 1)],
    ),
];

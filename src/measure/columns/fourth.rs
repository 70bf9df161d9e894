//! Which way contacts point, to fourth order; the order of the indices does not matter.

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[
    regional("fabric_1111", "-", "mean of n1 n1 n1 n1", |r| {
        r.fourth().plain.component(0)
    }),
    regional("fabric_1112", "-", "mean of n1 n1 n1 n2", |r| {
        r.fourth().plain.component(1)
    }),
    regional("fabric_1122", "-", "mean of n1 n1 n2 n2", |r| {
        r.fourth().plain.component(2)
    }),
    regional("fabric_1222", "-", "mean of n1 n2 n2 n2", |r| {
        r.fourth().plain.component(3)
    }),
    regional("fabric_2222", "-", "mean of n2 n2 n2 n2", |r| {
        r.fourth().plain.component(4)
    }),
    regional(
        "fabric_n_1111",
        "-",
        "mean of n1 n1 n1 n1 weighted by normal force",
        |r| r.fourth().weighted.component(0),
    ),
    regional(
        "fabric_n_1112",
        "-",
        "mean of n1 n1 n1 n2 weighted by normal force",
        |r| r.fourth().weighted.component(1),
    ),
    regional(
        "fabric_n_1122",
        "-",
        "mean of n1 n1 n2 n2 weighted by normal force",
        |r| r.fourth().weighted.component(2),
    ),
    regional(
        "fabric_n_1222",
        "-",
        "mean of n1 n2 n2 n2 weighted by normal force",
        |r| r.fourth().weighted.component(3),
    ),
    regional(
        "fabric_n_2222",
        "-",
        "mean of n2 n2 n2 n2 weighted by normal force",
        |r| r.fourth().weighted.component(4),
    ),
    regional(
        "fabric_t_1111",
        "-",
        "mean of n1 n1 n1 n1 weighted by the size of the tangential force",
        |r| r.fourth().by_tangential.component(0),
    ),
    regional(
        "fabric_t_1112",
        "-",
        "mean of n1 n1 n1 n2 weighted by the size of the tangential force",
        |r| r.fourth().by_tangential.component(1),
    ),
    regional(
        "fabric_t_1122",
        "-",
        "mean of n1 n1 n2 n2 weighted by the size of the tangential force",
        |r| r.fourth().by_tangential.component(2),
    ),
    regional(
        "fabric_t_1222",
        "-",
        "mean of n1 n2 n2 n2 weighted by the size of the tangential force",
        |r| r.fourth().by_tangential.component(3),
    ),
    regional(
        "fabric_t_2222",
        "-",
        "mean of n2 n2 n2 n2 weighted by the size of the tangential force",
        |r| r.fourth().by_tangential.component(4),
    ),
];

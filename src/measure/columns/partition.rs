//! Where stress comes from: fabric, normal variation and shear make up the whole, and fabric and
//! variation all that normal forces do (Cundall & Strack 1983).

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[
    regional(
        "stress_fabric_11",
        "Pa",
        "part of stress_11 that is due to the mean normal force by the fabric alone",
        |r| r.stress().fabric[(0, 0)],
    ),
    regional(
        "stress_fabric_12",
        "Pa",
        "part of stress_12 that is due to the mean normal force by the fabric alone",
        |r| r.stress().fabric[(0, 1)],
    ),
    regional(
        "stress_fabric_21",
        "Pa",
        "part of stress_21 that is due to the mean normal force by the fabric alone",
        |r| r.stress().fabric[(1, 0)],
    ),
    regional(
        "stress_fabric_22",
        "Pa",
        "part of stress_22 that is due to the mean normal force by the fabric alone",
        |r| r.stress().fabric[(1, 1)],
    ),
    regional(
        "stress_variation_11",
        "Pa",
        "part of stress_11 that is due to normal forces by differing from their mean",
        |r| r.stress().normal_variation[(0, 0)],
    ),
    regional(
        "stress_variation_12",
        "Pa",
        "part of stress_12 that is due to normal forces by differing from their mean",
        |r| r.stress().normal_variation[(0, 1)],
    ),
    regional(
        "stress_variation_21",
        "Pa",
        "part of stress_21 that is due to normal forces by differing from their mean",
        |r| r.stress().normal_variation[(1, 0)],
    ),
    regional(
        "stress_variation_22",
        "Pa",
        "part of stress_22 that is due to normal forces by differing from their mean",
        |r| r.stress().normal_variation[(1, 1)],
    ),
    regional(
        "stress_normal_11",
        "Pa",
        "part of stress_11 that is due to normal forces, fabric and variation together",
        |r| r.stress().normal[(0, 0)],
    ),
    regional(
        "stress_normal_12",
        "Pa",
        "part of stress_12 that is due to normal forces, fabric and variation together",
        |r| r.stress().normal[(0, 1)],
    ),
    regional(
        "stress_normal_21",
        "Pa",
        "part of stress_21 that is due to normal forces, fabric and variation together",
        |r| r.stress().normal[(1, 0)],
    ),
    regional(
        "stress_normal_22",
        "Pa",
        "part of stress_22 that is due to normal forces, fabric and variation together",
        |r| r.stress().normal[(1, 1)],
    ),
    regional(
        "stress_shear_11",
        "Pa",
        "part of stress_11 that is due to tangential forces",
        |r| r.stress().shear[(0, 0)],
    ),
    regional(
        "stress_shear_12",
        "Pa",
        "part of stress_12 that is due to tangential forces",
        |r| r.stress().shear[(0, 1)],
    ),
    regional(
        "stress_shear_21",
        "Pa",
        "part of stress_21 that is due to tangential forces",
        |r| r.stress().shear[(1, 0)],
    ),
    regional(
        "stress_shear_22",
        "Pa",
        "part of stress_22 that is due to tangential forces",
        |r| r.stress().shear[(1, 1)],
    ),
    regional(
        "sin_phi_fabric",
        "-",
        "part of sin_phi that the fabric carries",
        |r| r.stress().sin_phi_of(&r.stress().fabric),
    ),
    regional(
        "sin_phi_variation",
        "-",
        "part of sin_phi that differences of normal forces carry",
        |r| r.stress().sin_phi_of(&r.stress().normal_variation),
    ),
    regional(
        "sin_phi_normal",
        "-",
        "part of sin_phi that normal forces carry",
        |r| r.stress().sin_phi_of(&r.stress().normal),
    ),
    regional(
        "sin_phi_shear",
        "-",
        "part of sin_phi that tangential forces carry",
        |r| r.stress().sin_phi_of(&r.stress().shear),
    )
    .usual(),
];

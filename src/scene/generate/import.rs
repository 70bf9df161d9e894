//! `import`: particles whose places are in a file, such as one that `export particles` has written.

use super::csv_rows::{self, Columns};
use crate::engine::setup::ParticleSetup;
use crate::measure::columns::nearest;
use crate::scene::draft::Draft;
use crate::scene::place::quoted;
use crate::scene::reader::Reader;

/// Units: m, m/s, rad/s, rad.
const COLUMNS: Columns = Columns {
    required: &["x", "y", "radius"],
    optional: &["material", "vx", "vy", "spin", "angle"],
    ignored: &[
        "ball", "fx", "fy", "moment", "contacts", "ux", "uy", "rotation",
    ],
};

/// The place of `material` in [`COLUMNS`].
const MATERIAL: usize = 3;

/// The names of [`COLUMNS`] that hold numbers and may be left out, with their places.
const MOTION: [(&str, usize); 4] = [("vx", 4), ("vy", 5), ("spin", 6), ("angle", 7)];

/// Reads them; without a column for it they have this material and velocity.
pub(super) fn read<'a>(
    reader: &Reader<'a>,
    material: Option<usize>,
    velocity: [f64; 2],
    draft: &mut Draft<'a>,
) -> Option<Vec<ParticleSetup>> {
    let mut particles = Vec::new();
    let present = csv_rows::read(reader, "import", &COLUMNS, draft, |table, row| {
        let (x, y) = (table.number(row, 0, "x"), table.number(row, 1, "y"));
        let radius = table.radius(row, 2);
        let mut motion = [Some(velocity[0]), Some(velocity[1]), Some(0.0), Some(0.0)];
        for (value, (name, k)) in motion.iter_mut().zip(MOTION) {
            if row.text(k).is_some() {
                *value = table.number(row, k, name);
            }
        }
        let named = match row.text(MATERIAL) {
            None => material,
            Some(name) => {
                let materials = &table.draft().setup.materials;
                let found = materials.iter().position(|m| m.name == name && !m.rigid);
                if found.is_none() {
                    let names = materials
                        .iter()
                        .filter(|m| !m.rigid)
                        .map(|m| m.name.as_str());
                    return table.refuse(
                        row.line(),
                        &format!("there is no material {} for particles", quoted(name)),
                        "expected names of [material.NAME] in this column",
                        &nearest(name, names),
                    );
                }
                found
            }
        };
        let (at, radius) = ([x?, y?], radius?);
        if at.iter().any(|x| x.abs() > super::FARTHEST * radius) {
            return table.refuse(
                row.line(),
                "the centre is too far away",
                "expected less than 1e12 radii from the origin",
                "move the scene towards the origin: overlaps would be lost in rounding",
            );
        }
        let [vx, vy, spin, angle] = motion;
        particles.push(ParticleSetup {
            at,
            radius,
            material: named.unwrap_or_default(),
            velocity: [vx?, vy?],
            spin: spin?,
            angle: angle?,
            force: [0.0; 2],
            fixed: [false; 3],
        });
        Some(())
    })?;
    if particles.is_empty() {
        reader.refuse(
            "import",
            "the file has no particles",
            "expected a row for each below the header",
            "is this the right file?",
        );
        return None;
    }
    if material.is_none() && !reader.has("material") && !present.has(MATERIAL) {
        reader.refuse(
            "",
            &format!("{} has no `material`", reader.title),
            "`material` is missing here, and the file has no column for it",
            "add material = \"NAME\", or a column `material` to the file",
        );
        return None;
    }
    Some(particles)
}

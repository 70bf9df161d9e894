//! Straight walls as regions: prisms so thin that nothing notices, which have two sides and ends.

use super::law::Words;
use super::misfit::Fit;
use super::typical::Partners;
use crate::engine::World;
use crate::engine::wall::Wall;
use crate::record::number::real;

/// Thickness of a wall over the smallest radius.
const THIN: f64 = 1e-9;

/// Walls without end are cut this many sizes of the assembly from its middle.
const FAR: f64 = 100.0;

/// Regions, and the fixes that make walls of them in both forms.
#[derive(Debug, Clone, Default)]
pub(super) struct Walls {
    pub(super) regions: String,
    pub(super) granular: String,
    pub(super) classic: String,
}

/// Writes the walls of a world whose assembly has these corners [m].
pub(super) fn walls(
    world: &World,
    words: &Words<'_>,
    kinds: &[usize],
    corners: [[f64; 2]; 2],
    fit: &mut Fit,
) -> Walls {
    let mut text = Walls::default();
    // LAMMPS has one set of numbers for a wall: each material has its own fix.
    let several = kinds.len() > 1;
    if several && !world.walls().is_empty() {
        for k in 1..=kinds.len() {
            text.regions += &format!("group kind{k} type {k}\n");
        }
    }
    for (w, wall) in world.walls().iter().enumerate() {
        let name = format!("wall{}", w + 1);
        text.regions += &region(world, wall, &name, corners);
        for (k, &kind) in kinds.iter().enumerate() {
            let partners = Partners {
                a: kind,
                b: wall.material,
                wall: true,
            };
            let (fix, group) = if several {
                (format!("{name}kind{}", k + 1), format!("kind{}", k + 1))
            } else {
                (name.clone(), "all".to_owned())
            };
            let fix = format!("fix {fix} {group} wall/gran/region");
            let model = words.model(partners, fit);
            text.granular += &format!("{fix} granular {model} region {name}\n");
            if !several {
                let classic = words.classic_wall(partners, fit);
                text.classic += &format!("{fix} {classic} region {name}\n");
            }
        }
    }
    if !world.walls().is_empty() {
        fit.maps("walls, as regions: thin prisms with two sides and two ends");
        fit.differs(
            "a particle in the corner of two walls, or at their joint, touches both; here it touches \
             a face before an end, and a joint once",
        );
    }
    text
}

/// The stretch of a wall that is written [m].
fn stretch(wall: &Wall, corners: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let [low, high] = corners;
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let cut = |h: f64, far: f64| if h.is_finite() { h } else { far };
    let (h1, h2) = (cut(wall.h1, -FAR * size), cut(wall.h2, FAR * size));
    [h1, h2].map(|h| [0, 1].map(|k| wall.point[k] + h * wall.direction[k]))
}

fn region(world: &World, wall: &Wall, name: &str, corners: [[f64; 2]; 2]) -> String {
    let origin = world.origin();
    let mut ends = stretch(wall, corners).map(|x| [x[0] + origin[0], x[1] + origin[1]]);
    let thin = THIN * world.particles().smallest_radius();
    let depth = super::largest(world);
    let [d, z] = [real(-depth), real(depth)];
    let (dx, dy) = (ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
    let shape = if dy.abs() <= 1e-12 * dx.abs() {
        let (a, b) = (ends[0][0].min(ends[1][0]), ends[0][0].max(ends[1][0]));
        let y = ends[0][1];
        let [low, high] = [y - 0.5 * thin, y + 0.5 * thin].map(real);
        format!("block {} {} {low} {high} {d} {z}", real(a), real(b))
    } else {
        if dy < 0.0 {
            ends.swap(0, 1);
        }
        // As thick across a wall as it is steep: measured along x.
        let along = thin * (dx * dx + dy * dy).sqrt() / dy.abs();
        let x = ends[0][0];
        format!(
            "prism {} {} {} {} {d} {z} {} 0 0",
            real(x - 0.5 * along),
            real(x + 0.5 * along),
            real(ends[0][1]),
            real(ends[1][1]),
            real(ends[1][0] - ends[0][0])
        )
    };
    format!(
        "{}region {name} {shape} side out{}\n",
        moving(wall, name),
        motion(world, wall, name)
    )
}

/// Variables of a wall that moves, or nothing.
fn moving(wall: &Wall, name: &str) -> String {
    let mut text = format!("# {}\n", wall.name.replace(char::is_control, " "));
    if wall.velocity != [0.0; 2] {
        for (axis, v) in ["x", "y"].into_iter().zip(wall.velocity) {
            text += &format!("variable {name}{axis} equal {}*step*dt\n", real(v));
        }
    }
    if wall.spin != 0.0 {
        text += &format!("variable {name}turn equal {}*step*dt\n", real(wall.spin));
    }
    text
}

fn motion(world: &World, wall: &Wall, name: &str) -> String {
    let mut text = String::new();
    if wall.velocity != [0.0; 2] {
        text += &format!(" move v_{name}x v_{name}y NULL");
    }
    if wall.spin != 0.0 {
        let origin = world.origin();
        let about = [0, 1].map(|k| real(wall.about[k] + origin[k]));
        text += &format!(" rotate v_{name}turn {} {} 0 0 0 1", about[0], about[1]);
    }
    text
}

//! PRINT CONTACTS: the contacts that touch, and what they carry.

use super::super::figure::{figure, per_cent};
use super::layout::{Table, name, number, optional, words};
use crate::engine::World;
use crate::engine::contact_report::Other;
use crate::engine::neighbours::Status;
use crate::engine::setup::Body;
use crate::language::command::ParticleRange;
use crate::measure::changes::slid;
use crate::measure::contact_area::{ContactArea, obliquity};
use crate::measure::overlap::LARGE_OVERLAP;
use crate::measure::tensor::half_turn;

/// Overlap over the smaller of the two diameters beyond which a contact is marked.
pub(in crate::session) const DEEP: f64 = LARGE_OVERLAP;

/// A touching contact in numbers.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::session) struct Carried {
    /// Number of the first particle.
    pub(in crate::session) first: u32,
    /// Number of the second, or the name of the wall.
    pub(in crate::session) second: String,
    /// Normal force, dashpot included [N].
    pub(in crate::session) normal: f64,
    /// Tangential force, dashpot included [N].
    pub(in crate::session) tangential: f64,
    /// Overlap [m].
    pub(in crate::session) overlap: f64,
    /// Direction of the normal [degrees], 0 to 180.
    pub(in crate::session) angle: f64,
    /// Whether a bond holds it.
    pub(in crate::session) bonded: bool,
    /// Whether the whole contact slid in the last cycle.
    pub(in crate::session) sliding: bool,
    /// Way that it slid since the reference or first touch [m], if that is booked.
    pub(in crate::session) slid: Option<f64>,
    /// |T|/(μ N), `None` without friction or load.
    pub(in crate::session) obliquity: Option<f64>,
    /// Overlap over the smaller diameter.
    pub(in crate::session) depth: f64,
    /// Area the bodies share.
    pub(in crate::session) area: ContactArea,
}

/// a/R of the smaller body beyond which a contact is marked: another threshold than [`DEEP`], and
/// crossed far earlier, by equal spheres at an overlap of 0.49 % (Randall 1989, 4.6).
pub(in crate::session) const WIDE: f64 = 0.07;

impl Carried {
    /// Listed contact k; `None` while it is apart.
    pub(in crate::session) fn of(world: &World, k: usize) -> Option<Self> {
        let list = world.contacts();
        if list.status[k] == Status::Apart {
            return None;
        }
        let (particles, geometry) = (world.particles(), world.geometry(k));
        let reaction = world.reaction(k);
        let (i, other) = world.bodies(k);
        let second = match other {
            Other::Particle(j) => particles.id[j].to_string(),
            Other::Wall(w) => world.walls()[w].name.clone(),
        };
        let (area, obliquity) = (ContactArea::of(world, k), obliquity(world, k));
        Some(Self {
            first: particles.id[i],
            second,
            normal: reaction.normal,
            tangential: reaction.tangential,
            overlap: geometry.overlap,
            angle: direction(geometry.e),
            bonded: world.is_bonded(k),
            sliding: reaction.sliding,
            slid: slid(world, k),
            obliquity: (!obliquity.is_nan()).then_some(obliquity),
            depth: geometry.overlap / (2.0 * area.smaller),
            area,
        })
    }

    /// Mean normal and tangential stress on the contact area [Pa].
    pub(in crate::session) fn stress(&self) -> [f64; 2] {
        self.area.stress(self.normal, self.tangential)
    }

    /// `1-2` or `3-floor`.
    pub(in crate::session) fn bodies(&self) -> String {
        format!("{}-{}", self.first, self.second)
    }
}

/// Direction of a line along e [degrees], 0 to 180.
pub(in crate::session) fn direction(e: [f64; 2]) -> f64 {
    half_turn(libm::atan2(e[1], e[0]).to_degrees())
}

/// The contacts that touch and have a particle in the range, in the order of the list.
pub(super) fn chosen(world: &World, range: Option<ParticleRange>) -> Vec<Carried> {
    let ids = &world.particles().id;
    (0..world.contacts().len())
        .filter(|&k| {
            range.is_none_or(|range| match world.bodies(k) {
                (i, Other::Particle(j)) => range.contains(ids[i]) || range.contains(ids[j]),
                (i, Other::Wall(_)) => range.contains(ids[i]),
            })
        })
        .filter_map(|k| Carried::of(world, k))
        .collect()
}

/// What is said when there are none.
pub(super) fn none(world: &World, range: Option<ParticleRange>) -> Vec<String> {
    if super::balls::chosen(world, range).is_empty() {
        return super::balls::none(range);
    }
    let near = world.contacts().len();
    vec![match range {
        Some(range) => format!("no contact of the particles numbered {range} touches"),
        None if near == 0 => "nothing touches, and there are no pairs within tol".to_owned(),
        None => format!("nothing touches; pairs within tol, but not touching: {near}"),
    }]
}

/// The table.
pub(super) fn lines(world: &World, range: Option<ParticleRange>) -> Vec<String> {
    let chosen = chosen(world, range);
    if chosen.is_empty() {
        return none(world, range);
    }
    let mut columns = vec![
        number("ball", ""),
        words("with"),
        number("n", "N"),
        number("t", "N"),
        number("overlap", "m"),
        number("angle", "deg"),
        number("|t|/mu n", "-"),
        number("overlap/d", "-"),
    ];
    let is_booked = world.ledger().is_some();
    if is_booked {
        columns.push(number("slid", "m"));
    }
    columns.push(words("state"));
    let mut table = Table::new(2, &columns);
    for c in &chosen {
        let mark = if c.depth > DEEP { "*" } else { "" };
        let mut cells = vec![
            c.first.to_string(),
            name(&c.second),
            figure(c.normal),
            figure(c.tangential),
            figure(c.overlap),
            figure(c.angle),
            optional(c.obliquity),
            figure(c.depth) + mark,
        ];
        cells.extend(is_booked.then(|| optional(c.slid)));
        let state = match (c.bonded, c.sliding) {
            (true, _) => "bonded",
            (false, true) => "slides",
            (false, false) => "",
        };
        cells.push(state.to_owned());
        table.row(cells);
    }
    let mut lines = table.lines();
    let deep = chosen.iter().filter(|c| c.depth > DEEP).count();
    if deep > 0 {
        lines.push(format!(
            "* {deep} overlap by more than {} of the smaller diameter d",
            per_cent(DEEP)
        ));
    }
    if has_areas(world) {
        lines.push(String::new());
        lines.extend(areas(&chosen));
    }
    lines
}

/// Whether contact areas are shown: spheres touch in circles.
pub(in crate::session) fn has_areas(world: &World) -> bool {
    world.model().body == Body::Sphere
}

fn areas(chosen: &[Carried]) -> Vec<String> {
    let mut table = Table::new(
        2,
        &[
            number("ball", ""),
            words("with"),
            number("a", "m"),
            number("sigma_n", "Pa"),
            number("sigma_t", "Pa"),
            number("a/R", "-"),
        ],
    );
    for c in chosen {
        let ([normal, tangential], relative) = (c.stress(), c.area.relative());
        let mark = if relative > WIDE { "*" } else { "" };
        table.row(vec![
            c.first.to_string(),
            name(&c.second),
            figure(c.area.radius),
            figure(normal),
            figure(tangential),
            figure(relative) + mark,
        ]);
    }
    let mut lines = table.lines();
    let wide = chosen.iter().filter(|c| c.area.relative() > WIDE).count();
    if wide > 0 {
        lines.push(format!(
            "* {wide} contact areas are wider than {} of the smaller radius R",
            per_cent(WIDE)
        ));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_lie_in_half_a_turn() {
        for (e, degrees) in [
            ([1.0, 0.0], 0.0),
            ([-1.0, 0.0], 0.0),
            ([-1.0, -0.0], 0.0),
            ([1.0, -1e-30], 0.0),
            ([0.0, 1.0], 90.0),
            ([0.0, -1.0], 90.0),
        ] {
            assert_eq!(direction(e), degrees, "{e:?}");
        }
        // One rounding in each of angle and conversion.
        assert!((direction([1.0, 1.0]) - 45.0).abs() < 1e-13);
        assert!((direction([-1.0, 1.0]) - 135.0).abs() < 1e-13);
        assert!((direction([1.0, -1.0]) - 135.0).abs() < 1e-13);
    }
}

//! A followed contact as it is now and as it came there: what panes, pictures and tables draw.
//! Complete in itself, so that whoever draws it needs no world.

use super::follower::{Follower, Moment};
use crate::engine::World;
use crate::engine::contact::inner::{Inner, Value};
use crate::engine::contact::traction::Traction;
use crate::engine::neighbours::Status;
use crate::measure::contact_area::{ContactArea, obliquity, peak_pressure, stick_ratio};
use crate::session::print::{DEEP, WIDE, has_areas};

/// One contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Inspection {
    /// `1-2` or `3-floor`.
    pub name: String,
    /// Law of the scene.
    pub law: &'static str,
    /// Whether it touches, and slides.
    pub state: &'static str,
    /// Friction coefficient; zero where nothing limits the tangential force.
    pub friction: f64,
    /// Cohesion, or what a bond bears in shear [N].
    pub cohesion: f64,
    /// Radius of the contact area, NaN while it is apart [m].
    pub radius: f64,
    /// Largest pressure of Hertz [Pa], NaN where there is none.
    pub peak: f64,
    /// Traction inside, if it touches and its law knows it.
    pub traction: Option<Traction>,
    /// Everything in numbers, most useful first.
    pub numbers: Vec<Inner>,
    /// Cycle since which it is followed, and how many cycles lie between two moments.
    pub since: (u64, u32),
    /// Its path.
    pub trace: Vec<Moment>,
}

impl Inspection {
    pub(super) fn of(world: &World, follower: &Follower) -> Self {
        let mut inspection = Self {
            name: follower.name(),
            law: world.model().law.card().name,
            state: "apart",
            friction: 0.0,
            cohesion: 0.0,
            radius: f64::NAN,
            peak: f64::NAN,
            traction: None,
            numbers: Vec::new(),
            since: (follower.since(), follower.stride()),
            trace: follower.trace(),
        };
        let Some(k) = follower.touching(world) else {
            return inspection;
        };
        let bonded = world.is_bonded(k);
        if bonded {
            inspection.state = "bonded";
        } else if world.contacts().status[k] == Status::Sliding {
            inspection.state = "slides";
        } else {
            inspection.state = "touches";
        }
        if world.pass().is_frictional(k) {
            let pair = world.pair_of(k);
            let own = if bonded {
                pair.bond_shear
            } else {
                pair.cohesion
            };
            (inspection.friction, inspection.cohesion) = (pair.friction, own);
            inspection.traction = world.pass().traction(k);
        }
        inspection.radius = ContactArea::of(world, k).radius;
        inspection.peak = peak_pressure(world, k);
        inspection.numbers = numbers(world, k, inspection.trace.last());
        inspection
    }

    /// Whether the path has a tangential part.
    pub fn shears(&self) -> bool {
        self.friction > 0.0 || self.cohesion > 0.0
    }
}

fn numbers(world: &World, k: usize, now: Option<&Moment>) -> Vec<Inner> {
    let reaction = world.reaction(k);
    let g = world.geometry(k);
    let area = ContactArea::of(world, k);
    let depth = g.overlap / (2.0 * area.smaller);
    let mut rows = vec![
        Inner::number("N", reaction.normal, "N"),
        Inner::number("T", reaction.tangential, "N"),
        Inner::number("|T|/(mu N)", obliquity(world, k), "-"),
        Inner::number("overlap alpha", g.overlap, "m"),
        Inner::number("delta", now.map_or(f64::NAN, |now| now.delta), "m"),
        limited("alpha/D_min", depth, DEEP),
    ];
    if has_areas(world) {
        let [normal, tangential] = area.stress(reaction.normal, reaction.tangential);
        rows.extend([
            Inner::number("radius a", area.radius, "m"),
            limited("a/R_min", area.relative(), WIDE),
            Inner::number("c/a", stick_ratio(world, k), "-"),
            Inner::number("p0", peak_pressure(world, k), "Pa"),
            Inner::number("sigma_n", normal, "Pa"),
            Inner::number("sigma_t", tangential, "Pa"),
        ]);
    }
    rows.extend(world.pass().inner(k, g.overlap));
    let [normal, tangential] = world.pass().energy(k, g.overlap);
    rows.push(Inner::number("stored by N", normal, "J"));
    rows.push(Inner::number("stored by T", tangential, "J"));
    if world.ledger().is_some() {
        let [sliding, slip, dashpots] = world.pass().book(k).lost;
        let within = if world.model().law.has_bonds() {
            "lost: bond"
        } else {
            "lost: slip"
        };
        rows.extend([
            Inner::number("lost: sliding", sliding, "J"),
            Inner::number(within, slip, "J"),
            Inner::number("lost: dashpots", dashpots, "J"),
        ]);
    }
    let stiffness = world.pass().stiffness(k, g.overlap);
    rows.push(Inner::number("k_n", stiffness.k[0], "N/m"));
    rows.push(Inner::number("k_t", stiffness.k[1], "N/m"));
    let effective = world.effective(k);
    rows.push(Inner::number("R*", effective.radius, "m"));
    rows.push(Inner::number("M*", effective.mass, "kg"));
    if effective.young > 0.0 {
        rows.push(Inner::number("E*", effective.young, "Pa"));
        rows.push(Inner::number("G*", effective.shear, "Pa"));
    }
    rows.retain(|row| !matches!(row.value, Value::Number(x, _) if x.is_nan()));
    rows
}

/// A ratio that has to be small, marked where it is not.
fn limited(name: &'static str, ratio: f64, limit: f64) -> Inner {
    let unit = if ratio > limit { "> 7%" } else { "-" };
    Inner::number(name, ratio, unit)
}

//! The answer to INSPECT CONTACT.

use crate::engine::World;
use crate::engine::contact::inner::Value;
use crate::engine::contact_report::Other;
use crate::engine::neighbours::Status;
use crate::measure::columns::Partner;
use crate::measure::contact_area::{peak_pressure, stick_ratio};
use crate::measure::sample::find_contact;
use crate::session::figure::{figure, per_cent, vector};
use crate::session::print::{Carried, DEEP, WIDE, dashpots, has_areas, listed};

/// The lines of the answer. Both bodies exist: the command was checked.
pub(super) fn contact(world: &mut World, i: u32, partner: &Partner) -> Vec<String> {
    world.settle();
    match find_contact(world, i, partner) {
        Some(k) => listed_contact(world, k),
        None => vec![far(world, i, partner)],
    }
}

/// A pair further apart than TOL.
fn far(world: &World, id: u32, partner: &Partner) -> String {
    let particles = world.particles();
    let other = match partner {
        Partner::Particle(j) => particles.index(*j).map(Other::Particle),
        Partner::Wall(name) => {
            let w = world.walls().iter().position(|wall| wall.name == *name);
            w.map(Other::Wall)
        }
    };
    let (Some(i), Some(other)) = (particles.index(id), other) else {
        return format!("ball {id} or its partner does not exist");
    };
    format!(
        "{} are no neighbours: the gap between them is {} m, tol is {} m{}",
        names(world, i, other),
        figure(world.gap(i, other)),
        figure(world.tol()),
        if world.tol_is_mean() {
            " in the mean"
        } else {
            ""
        }
    )
}

fn names(world: &World, i: usize, other: Other) -> String {
    let id = world.particles().id[i];
    match other {
        Other::Particle(j) => format!("balls {id} and {}", world.particles().id[j]),
        Other::Wall(w) => format!("ball {id} and wall {}", world.walls()[w].name),
    }
}

fn listed_contact(world: &World, k: usize) -> Vec<String> {
    let (i, other) = world.bodies(k);
    let g = world.geometry(k);
    let bodies = names(world, i, other);
    if !g.distance.is_finite() {
        // Only at a joint of walls.
        return vec![format!(
            "{bodies}: apart, another wall takes the contact at the shared end"
        )];
    }
    let mut rows = vec![
        ("state", state(world, k)),
        (
            "normal",
            format!("{}, from the ball to its partner", vector(g.e)),
        ),
        ("tangent", vector([g.e[1], -g.e[0]])),
    ];
    if let Some(carried) = Carried::of(world, k) {
        rows.extend(forces(world, k, &carried));
        rows.extend(area(world, k, &carried));
        rows.extend(inner(world, k, g.overlap));
    }
    let meeting = world.meeting(k);
    rows.push((
        "velocity of the ball against it",
        format!(
            "approach {} m/s, along t {} m/s",
            figure(meeting.approach),
            figure(meeting.slide)
        ),
    ));
    let s = world.pass().stiffness(k, g.overlap);
    rows.push((
        "stiffness",
        format!(
            "normal {} N/m, tangential {} N/m",
            figure(s.k[0]),
            figure(s.k[1])
        ),
    ));
    rows.push((
        "dashpots",
        format!(
            "{}: normal {} N s/m, tangential {} N s/m",
            dashpots(world.pair_of(k)),
            figure(s.c[0]),
            figure(s.c[1])
        ),
    ));
    rows.push(("effective", effective(world, k)));
    rows.push(("largest stable step", steps(world, i, other)));
    if world.contacts().status[k] != Status::Apart {
        rows.extend(energies(world, k, g.overlap));
    }
    std::iter::once(bodies).chain(listed(&rows)).collect()
}

fn state(world: &World, k: usize) -> String {
    if world.is_bonded(k) {
        let pair = world.pair_of(k);
        return format!(
            "bonded, until pulled with more than {} N",
            figure(pair.bond_tension)
        );
    }
    match world.contacts().status[k] {
        Status::Apart => format!("apart by {} m", figure(-world.geometry(k).overlap)),
        Status::Touching => "touching".into(),
        Status::Sliding => "touching and sliding".into(),
    }
}

fn forces(world: &World, k: usize, carried: &Carried) -> Vec<(&'static str, String)> {
    let [spring_n, spring_t] = world.springs(k);
    let pair = world.pair_of(k);
    let split = |total: f64, spring: f64| {
        format!(
            "{} N: spring {} N, dashpot {} N",
            figure(total),
            figure(spring),
            figure(dashpot(total, spring))
        )
    };
    let overlap = format!(
        "{} m, {} of the smaller diameter{}",
        figure(carried.overlap),
        per_cent(carried.depth),
        too_large(carried.depth, DEEP)
    );
    let mut rows = vec![
        ("overlap", overlap),
        ("n", split(carried.normal, spring_n)),
        ("t", split(carried.tangential, spring_t)),
    ];
    if world.pass().is_frictional(k) || pair.cohesion > 0.0 {
        let (own, pressed) = if carried.bonded {
            (pair.bond_shear, spring_n.max(0.0))
        } else {
            (pair.cohesion, carried.normal)
        };
        let limit = pair.friction * pressed + own;
        let used = if limit > 0.0 {
            per_cent(spring_t.abs() / limit)
        } else {
            "all".into()
        };
        rows.push((
            "limit mu n + c",
            format!(
                "{} N with mu {} and c {} N, {used} of it used",
                figure(limit),
                figure(pair.friction),
                figure(own)
            ),
        ));
    } else {
        rows.push((
            "limit mu n + c",
            "none: this contact has no friction".into(),
        ));
    }
    rows
}

/// The share of a force [N] that the spring does not carry. The force is a projection, and its
/// rounding is no dashpot.
fn dashpot(total: f64, spring: f64) -> f64 {
    let rest = total - spring;
    if rest.abs() <= 4.0 * f64::EPSILON * total.abs() {
        0.0
    } else {
        rest
    }
}

/// What is said of a ratio above its limit.
fn too_large(ratio: f64, limit: f64) -> String {
    if ratio > limit {
        format!(", more than the {} that count as small", per_cent(limit))
    } else {
        String::new()
    }
}

/// Contact radius and stresses, where bodies touch in circles.
fn area(world: &World, k: usize, carried: &Carried) -> Vec<(&'static str, String)> {
    if !has_areas(world) {
        return Vec::new();
    }
    let radius = format!(
        "{} m, {} of the smaller radius{}",
        figure(carried.area.radius),
        per_cent(carried.area.relative()),
        too_large(carried.area.relative(), WIDE)
    );
    let [normal, tangential] = carried.stress().map(figure);
    let mut stresses = format!("mean normal {normal} Pa, mean shear {tangential} Pa");
    let peak = peak_pressure(world, k);
    if peak.is_finite() {
        stresses += &format!(", largest pressure p0 {} Pa", figure(peak));
    }
    vec![("contact radius a", radius), ("stresses", stresses)]
}

/// What the law remembers, and where the contact sticks.
fn inner(world: &World, k: usize, overlap: f64) -> Vec<(&'static str, String)> {
    let mut parts: Vec<String> = (world.pass().inner(k, overlap).iter())
        .map(|inner| match inner.value {
            Value::Number(value, "-") => format!("{} {}", inner.name, figure(value)),
            Value::Number(value, unit) => format!("{} {} {unit}", inner.name, figure(value)),
            Value::Word(word) => format!("{} {word}", inner.name),
        })
        .collect();
    let law = world.model().law.card().name;
    parts.insert(0, law.to_owned());
    let mut rows = vec![("law", parts.join(", "))];
    let ratio = stick_ratio(world, k);
    if ratio.is_finite() {
        let sticks = if ratio == 0.0 {
            "nothing: all of it is at the friction limit".to_owned()
        } else if ratio == 1.0 {
            "all of it".to_owned()
        } else {
            format!("within c/a {}, outside it slips", figure(ratio))
        };
        rows.push(("sticks", sticks));
    }
    rows
}

/// What the two bodies make of it.
fn effective(world: &World, k: usize) -> String {
    let effective = world.effective(k);
    let mut text = format!(
        "R* {} m, M* {} kg",
        figure(effective.radius),
        figure(effective.mass)
    );
    if effective.young > 0.0 {
        text += &format!(", E* {} Pa", figure(effective.young));
    }
    if effective.shear > 0.0 {
        text += &format!(", G* {} Pa", figure(effective.shear));
    }
    text
}

/// The bound of each of its particles.
fn steps(world: &World, i: usize, other: Other) -> String {
    let one = |p: usize| {
        let (id, step) = (world.particles().id[p], world.stable_step_of(p));
        if step.is_finite() {
            let frac = figure(step / world.base_step());
            format!("ball {id}: {} s, frac {frac}", figure(step))
        } else {
            format!("ball {id}: any")
        }
    };
    match other {
        Other::Particle(j) => format!("{}; {}", one(i), one(j)),
        Other::Wall(_) => one(i),
    }
}

fn energies(world: &World, k: usize, overlap: f64) -> Vec<(&'static str, String)> {
    let [normal, tangential] = world.pass().energy(k, overlap);
    let stored = format!(
        "normal {} J, tangential {} J",
        figure(normal),
        figure(tangential)
    );
    let mut rows = vec![("energy in the springs", stored)];
    if world.ledger().is_some() {
        let book = world.pass().book(k);
        let within = if world.model().law.has_bonds() {
            "bond"
        } else {
            "slip"
        };
        let lost = format!(
            "sliding {} J, {within} {} J, dashpots {} J",
            figure(book.friction_loss[0]),
            figure(book.friction_loss[1]),
            figure(book.damping_loss)
        );
        rows.push(("lost in the last cycle", lost));
        let [sliding, slip, dashpots] = book.lost.map(figure);
        let lost = format!("sliding {sliding} J, {within} {slip} J, dashpots {dashpots} J");
        rows.push(("lost since first touch", lost));
        let delta = format!("{} m since first touch", figure(book.delta));
        rows.push(("tangential displacement", delta));
    } else {
        rows.push((
            "losses",
            "not booked: name energy_error in [history] columns of the preset".into(),
        ));
    }
    rows
}

//! How many of what there are, how deep they overlap, and what memory they take.

use super::{Report, size};
use crate::engine::World;
use crate::engine::bytes::Bytes;
use crate::engine::contact_report::Other;
use crate::scene::Scene;
use crate::session::figure::{figure, per_cent};

/// Overlaps at the start above this share of the smaller radius push particles apart at once.
const LARGE: f64 = 0.05;

/// Counts, start and memory.
pub(super) fn describe(report: &mut Report, scene: &Scene, world: &World) {
    let (particles, list) = (world.particles(), world.contacts());
    report.line(
        "sizes",
        format!(
            "{}, {}, {} within tol = {} m",
            count(particles.len(), "particle"),
            count(world.walls().len(), "wall"),
            count(list.len(), "pair"),
            figure(world.tol())
        ),
    );
    let (start, warning) = start(world);
    report.line("start", start);
    report.warnings.extend(warning);
    let Bytes {
        particle,
        contact,
        law,
    } = world.bytes();
    let world_bytes = (particle * particles.len() + contact * list.len()) as f64;
    let row = 8 * (scene.history.columns.len() + 5);
    report.line(
        "memory",
        format!(
            "about {} ({particle} B per particle, {contact} B per pair, {law} B of them the law's \
             own), and {row} B per row of the history",
            size(world_bytes)
        ),
    );
}

/// How many pairs overlap and how much; and a warning if that is a lot.
fn start(world: &World) -> (String, Option<String>) {
    let particles = world.particles();
    let (mut touching, mut deepest): (usize, Option<(f64, usize)>) = (0, None);
    for k in 0..world.contacts().len() {
        let (i, other) = world.bodies(k);
        let radius = match other {
            Other::Particle(j) => particles.row[i].radius.min(particles.row[j].radius),
            Other::Wall(_) => particles.row[i].radius,
        };
        let share = -world.gap(i, other) / radius;
        if share > 0.0 {
            touching += 1;
            if deepest.is_none_or(|(before, _)| share > before) {
                deepest = Some((share, k));
            }
        }
    }
    let Some((share, k)) = deepest else {
        return ("nothing overlaps".into(), None);
    };
    let (i, other) = world.bodies(k);
    let name = match other {
        Other::Particle(j) => format!("particles {} and {}", particles.id[i], particles.id[j]),
        Other::Wall(w) => format!(
            "particle {} and wall {}",
            particles.id[i],
            world.walls()[w].name
        ),
    };
    let warning = (share > LARGE).then(|| {
        let share = per_cent(share);
        format!("{name} overlap by {share} of the smaller radius: they will be thrown apart")
    });
    let overlap = if touching == 1 { "overlaps" } else { "overlap" };
    let text = format!(
        "{} {overlap}, at most by {} of the smaller radius ({name})",
        count(touching, "pair"),
        per_cent(share)
    );
    (text, warning)
}

fn count(number: usize, what: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {what}{plural}")
}

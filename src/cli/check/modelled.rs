//! What the scene models, and what it leaves out.

use super::Report;
use crate::engine::World;
use crate::engine::boundary::Kind;
use crate::engine::contact::laws::Slip;
use crate::engine::setup::{Body, Dashpot, Gravity, NormalForm};
use crate::language::Command;
use crate::scene::Scene;
use crate::session::boundary_itself;

/// Describes it as it is before the first cycle, and which commands of stages change it.
pub(super) fn describe(report: &mut Report, scene: &Scene, world: &World) {
    let (model, plan) = (world.model(), world.plan());
    let (mut yes, mut no) = (Vec::new(), Vec::new());
    yes.push(match model.body {
        Body::Disc => "discs of unit length",
        Body::Sphere => "spheres in a plane",
    });
    let law = model.law.card();
    let contacts = format!("{} contacts", law.name);
    yes.push(&contacts);
    if plan.normal == NormalForm::Incremental {
        yes.push("normal forces summed from increments");
    }
    let separate = model.damping.wall.is_some_and(|wall| wall != Dashpot::None)
        && model.damping.wall != Some(model.damping.contact);
    let gravity = match model.gravity {
        Some(Gravity::Centripetal { .. }) => "centripetal gravity",
        Some(Gravity::Uniform(_)) | None => "gravity",
    };
    let boundary = match world.boundary().map(|boundary| &boundary.kind) {
        Some(Kind::Cell(_)) => "periodic cell",
        Some(Kind::Walls) => "walls as boundary",
        Some(Kind::Ring(_)) => "ring of boundary particles",
        None => "boundary",
    };
    for (is, what) in [
        (plan.friction, "friction"),
        (
            plan.friction && law.slip == Slip::Partial,
            "slip within contacts",
        ),
        (plan.friction && model.rotation, "rotation"),
        (plan.rolling, "rolling resistance"),
        (plan.dashpots, "contact damping"),
        (
            model.damping.overlap_critical.is_some(),
            "critical damping of large overlaps",
        ),
        (model.damping.global != 0.0, "global damping"),
        (model.damping.local != 0.0, "local damping"),
        (model.damping.con1 != 1.0, "con1 damping"),
        (model.gravity.is_some(), gravity),
        (!world.walls().is_empty(), "walls"),
        (world.boundary().is_some(), boundary),
        (plan.ledger, "energy ledger"),
    ] {
        if is { &mut yes } else { &mut no }.push(what);
    }
    if separate {
        yes.push("walls damped otherwise");
    }
    report.line("modelled", yes.join(", "));
    let left_out = if no.is_empty() {
        "nothing".to_owned()
    } else {
        no.join(", ")
    };
    report.line("not modelled", left_out);
    if plan.ledger {
        let columns = scene.booked_for().join(", ");
        let text = format!("booked for {columns}, which makes cycles two to three times as long");
        report.line("energies", text);
    }
    if let Some(boundary) = world.boundary() {
        report.line("boundary", boundary_itself(world, boundary));
    }
    let changes = scene.stages.iter().filter_map(|stage| {
        let changing = stage.commands.iter().filter(|c| changes_model(c));
        let changing: Vec<String> = changing.map(ToString::to_string).collect();
        (!changing.is_empty()).then(|| format!("{}: {}", stage.name, changing.join(", ")))
    });
    report.lines("later", &changes.collect::<Vec<String>>());
}

fn changes_model(command: &Command) -> bool {
    matches!(
        command,
        Command::Friction(..)
            | Command::Bond(_)
            | Command::Property(..)
            | Command::Frac(_)
            | Command::FracAuto(_)
            | Command::Damp(..)
            | Command::Con1(_)
            | Command::Gravity(_)
            | Command::Boundary(_)
            | Command::Strain(_)
            | Command::Stress(_)
            | Command::Servo(_)
            | Command::Continuum(_)
            | Command::Rotation(_)
            | Command::Create(_)
            | Command::Generate(_)
            | Command::Grow(_)
            | Command::Delete(_)
    )
}

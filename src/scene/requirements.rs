//! What the law and the time step need of the materials that are used.

use super::draft::Draft;
use super::place::Place;
use super::problem::Problem;
use crate::engine::setup::{LawChoice, Material, TimeStepChoice};
use crate::language::Command;
use crate::language::command::{FrictionOf, Property};

/// Reports materials that lack what is asked of them.
pub(crate) fn check(draft: &Draft<'_>) {
    if !draft.model.sound {
        return;
    }
    let setup = &draft.setup;
    let mut by_particle = vec![false; setup.materials.len()];
    let mut by_any = by_particle.clone();
    for (particle, mark) in setup.particles.iter().zip(&draft.particles) {
        if mark.sound {
            by_particle[particle.material] = true;
            by_any[particle.material] = true;
        }
    }
    for (wall, mark) in setup.walls.iter().zip(&draft.walls) {
        if mark.sound {
            by_any[wall.material] = true;
        }
    }
    cohesion(draft);
    for (k, material) in setup.materials.iter().enumerate() {
        let mark = draft.materials[k];
        if !mark.sound || material.rigid {
            continue;
        }
        let lacks = Lacks {
            draft,
            material,
            place: mark.place,
        };
        if by_any[k] {
            if setup.law.has_constant_springs() {
                lacks.linear(k);
            } else {
                lacks.elastic(setup.law);
            }
        }
        // Once is enough.
        if by_particle[k] && setup.law.has_constant_springs() {
            lacks.time_step();
        }
    }
}

/// Reports cohesion that the law of the scene does not know.
fn cohesion(draft: &Draft<'_>) {
    let law = draft.setup.law.card();
    if law.reads("cohesion") {
        return;
    }
    let report = |what: String, place: Place| {
        draft.report.add(
            Problem::new(
                format!("{what} cohesion, which the law {} does not know", law.name),
                place,
            )
            .expected("given here")
            .remedy("leave it out, or write law = \"hertz-mindlin\" or \"linear\" in [model]"),
        );
    };
    let places = draft.materials.iter().map(|mark| mark.place);
    for (material, place) in draft.setup.materials.iter().zip(places) {
        if material.cohesion > 0.0 {
            report(format!("[material.{}] has", material.name), place);
        }
    }
    if draft
        .setup
        .pairs
        .iter()
        .any(|pair| pair.cohesion > Some(0.0))
    {
        report("a [[pair]] has".into(), draft.model.place);
    }
    for (stage, place) in &draft.stages {
        let gives = |command: &Command| matches!(command, Command::Property(_, Property::Cohesion, value) if *value > 0.0);
        if stage.commands.iter().any(gives) {
            report(format!("stage `{}` gives", stage.name), *place);
        }
    }
}

struct Lacks<'d, 'a> {
    draft: &'d Draft<'a>,
    material: &'d Material,
    place: Place,
}

impl Lacks<'_, '_> {
    fn elastic(&self, law: LawChoice) {
        let why = format!("the law {}", law.card().name);
        if self.material.young.is_none() {
            self.report("young", "Pa", &why, None);
        }
        if self.material.poisson.is_none() {
            self.report("poisson", "-", &why, None);
        }
    }

    fn linear(&self, k: usize) {
        let material = self.material;
        if material.normal_stiffness.is_none() {
            self.report("normal_stiffness", "N/m", "the linear law", None);
        }
        // Without a limit above zero there is no shear force, whatever the stiffness.
        let by_pair = self.draft.setup.pairs.iter().any(|pair| {
            pair.materials.contains(&k)
                && pair.shear_stiffness.is_none()
                && (pair.friction > Some(0.0) || pair.cohesion > Some(0.0))
        });
        if material.shear_stiffness.is_some() {
            return;
        }
        if material.friction > 0.0 || material.cohesion > 0.0 || by_pair {
            let why = "the linear law with friction or cohesion";
            self.report("shear_stiffness", "N/m", why, None);
        } else if let Some(stage) = self.rubs_in() {
            let why = format!("friction or cohesion in stage `{stage}`");
            self.report("shear_stiffness", "N/m", &why, None);
        }
    }

    /// The stage whose commands give friction or cohesion to the material, unless commands before
    /// have given it a shear stiffness.
    fn rubs_in(&self) -> Option<&str> {
        let own = &self.material.name;
        for (stage, _) in &self.draft.stages {
            for command in &stage.commands {
                match command {
                    Command::Property(name, Property::ShearStiffness, _) if name == own => {
                        return None;
                    }
                    Command::Property(name, Property::Friction | Property::Cohesion, value)
                        if name == own && *value > 0.0 =>
                    {
                        return Some(&stage.name);
                    }
                    Command::Friction(value, of) if *value > 0.0 => match of {
                        FrictionOf::Everything | FrictionOf::Wall(_) => return Some(&stage.name),
                        FrictionOf::Material(name) if name == own => return Some(&stage.name),
                        FrictionOf::Pair(a, b) if a == own || b == own => return Some(&stage.name),
                        FrictionOf::Material(_) | FrictionOf::Pair(..) => {}
                    },
                    _ => {}
                }
            }
        }
        None
    }

    fn time_step(&self) {
        let name = match self.draft.setup.time_step {
            TimeStepChoice::Rayleigh => "rayleigh",
            TimeStepChoice::RayleighExact => "rayleigh-exact",
            TimeStepChoice::Critical | TimeStepChoice::Seconds(_) => return,
        };
        let why = format!("time_step = \"{name}\"");
        let instead = Some("time_step = \"critical\" in [model]");
        if self.material.young.is_none() {
            self.report("young", "Pa", &why, instead);
        }
        if self.material.poisson.is_none() {
            self.report("poisson", "-", &why, instead);
        }
    }

    fn report(&self, key: &str, unit: &str, why: &str, instead: Option<&str>) {
        let name = &self.material.name;
        let message = format!("material `{name}` has no `{key}`, which {why} needs");
        let add = format!("add {key} = number [{unit}] to [material.{name}]");
        self.draft.report.add(
            Problem::new(message, self.place)
                .expected(format!("`{key}` is missing here"))
                .remedy(match instead {
                    Some(instead) => format!("{add}, or write {instead}"),
                    None => add,
                }),
        );
    }
}

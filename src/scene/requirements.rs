//! What the law and the time step need of the materials that are used.

use super::draft::Draft;
use super::place::Place;
use super::problem::Problem;
use crate::engine::pair::PairTable;
use crate::engine::setup::{LawChoice, Material, PairOverride, TimeStepChoice};
use crate::language::command::{FrictionOf, Property};
use crate::language::{Command, number};

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
    for one in &STRENGTHS {
        strength(draft, one);
    }
    bonds(draft);
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

/// A strength of contacts that not every law knows.
struct Strength {
    /// Its key, which is also the word for it.
    key: &'static str,
    property: Property,
    of: fn(&Material) -> f64,
    of_pair: fn(&PairOverride) -> Option<f64>,
    /// What would know it.
    laws: &'static str,
}

const STRENGTHS: [Strength; 3] = [
    Strength {
        key: "cohesion",
        property: Property::Cohesion,
        of: |material| material.cohesion,
        of_pair: |pair| pair.cohesion,
        laws: "law = \"hertz-mindlin\", \"linear\" or \"bonded\"",
    },
    Strength {
        key: "bond_tension",
        property: Property::BondTension,
        of: |material| material.bond_tension,
        of_pair: |pair| pair.bond_tension,
        laws: BONDED,
    },
    Strength {
        key: "bond_shear",
        property: Property::BondShear,
        of: |material| material.bond_shear,
        of_pair: |pair| pair.bond_shear,
        laws: BONDED,
    },
];

const BONDED: &str = "law = \"bonded\"";

/// Reports a strength that the law of the scene does not know.
fn strength(draft: &Draft<'_>, strength: &Strength) {
    let Strength {
        key,
        property,
        of,
        of_pair,
        laws,
    } = strength;
    let law = draft.setup.law.card();
    if law.reads(key) {
        return;
    }
    let report = |what: String, place: Place| {
        draft.report.add(
            Problem::new(
                format!("{what} {key}, which the law {} does not know", law.name),
                place,
            )
            .expected("given here")
            .remedy(format!("leave it out, or write {laws} in [model]")),
        );
    };
    let places = draft.materials.iter().map(|mark| mark.place);
    for (material, place) in draft.setup.materials.iter().zip(places) {
        if of(material) > 0.0 {
            report(format!("[material.{}] has", material.name), place);
        }
    }
    if draft
        .setup
        .pairs
        .iter()
        .any(|pair| of_pair(pair) > Some(0.0))
    {
        report("a [[pair]] has".into(), draft.model.place);
    }
    for (stage, place) in &draft.stages {
        let gives = |command: &Command| matches!(command, Command::Property(_, given, value) if given == property && *value > 0.0);
        if stage.commands.iter().any(gives) {
            report(format!("stage `{}` gives", stage.name), *place);
        }
    }
}

/// Reports bonds that the law cannot make, or that would hold over a gap as wide as a particle.
fn bonds(draft: &Draft<'_>) {
    let setup = &draft.setup;
    if !setup.law.has_bonds() {
        let bonds = |command: &Command| matches!(command, Command::Bond(_));
        for (stage, place) in &draft.stages {
            if stage.commands.iter().any(bonds) {
                let (name, law) = (&stage.name, setup.law.card().name);
                draft.report.add(
                    Problem::new(
                        format!("stage `{name}` makes bonds, which the law {law} does not know"),
                        *place,
                    )
                    .expected("`bond` in this stage")
                    .remedy(format!("write {BONDED} in [model]")),
                );
            }
        }
        return;
    }
    let radii = setup.particles.iter().map(|particle| particle.radius);
    let smallest = radii.fold(f64::INFINITY, f64::min);
    let reach = PairTable::new(setup).bond_reach();
    if reach > smallest {
        let [reach, smallest] = [reach, smallest].map(number::format);
        draft.report.add(
            Problem::new(
                format!(
                    "a bond would stretch by {reach} m before it breaks, more than the smallest \
                     radius, {smallest} m"
                ),
                draft.model.place,
            )
            .expected("bond_tension / normal_stiffness at most the smallest radius")
            .remedy("lower bond_tension of the material or pair"),
        );
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
                && [pair.friction, pair.cohesion, pair.bond_shear]
                    .iter()
                    .any(|limit| *limit > Some(0.0))
        });
        if material.shear_stiffness.is_some() {
            return;
        }
        let own = [material.friction, material.cohesion, material.bond_shear];
        if own.iter().any(|&limit| limit > 0.0) || by_pair {
            let why = "the linear law with friction, cohesion or bonds";
            self.report("shear_stiffness", "N/m", why, None);
        } else if let Some(stage) = self.rubs_in() {
            let why = format!("friction, cohesion or bonds in stage `{stage}`");
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
                    Command::Property(
                        name,
                        Property::Friction | Property::Cohesion | Property::BondShear,
                        value,
                    ) if name == own && *value > 0.0 => {
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

//! What a study runs: every law, every combination of swept keys, every FRAC.

use super::question::{Asked, questions};
use super::variant::{Variant, base_step, failed, fixed_step, variant};
use crate::engine::World;
use crate::scene::{Rejection, Scene};
use crate::session::RunError;
use crate::session::figure::figure;

/// A study before anything has run.
pub struct Plan {
    /// The preset.
    pub scene: Scene,
    /// One per law and combination of swept keys.
    pub series: Vec<Series>,
    /// All variants: series by series, from large to small FRAC.
    pub variants: Vec<Variant>,
    /// The variant that the others are compared with where no exact answer is known.
    pub reference: usize,
    /// What errors are of.
    pub questions: Vec<Asked>,
    /// What the user should know about it.
    pub notes: Vec<String>,
}

/// Variants that differ in nothing but FRAC.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Contact law.
    pub law: String,
    /// Swept keys, `PATH=VALUE`.
    pub settings: Vec<String>,
}

/// Why there is no plan.
#[derive(Debug)]
pub enum NoPlan {
    /// The preset, or the preset with a swept key, is refused.
    Rejected(Box<Rejection>),
    /// What is asked for cannot be done: what, and what can.
    Refused(String),
    /// No world can be built.
    Failed(RunError),
}

/// A study runs at most so many variants.
const MOST: usize = 200;

/// FRACs of a study that names none, as shares of the preset's own.
const SHARES: [f64; 4] = [1.0, 0.5, 0.25, 0.125];

impl Plan {
    /// Plans the study of a scene as its `[study]` says.
    pub fn of(scene: Scene) -> Result<Self, NoPlan> {
        if scene.stages.is_empty() {
            return Err(NoPlan::Refused(format!(
                "{} has no [[stage]], so its variants would never end; add one with max_cycles or \
                 until",
                scene.name
            )));
        }
        fixed_step(&scene)?;
        let world = World::build(scene.setup.clone(), 1).map_err(failed)?;
        let (preset_frac, preset_dt) = (world.frac(), world.dt());
        drop(world);
        let series = all_series(&scene);
        let mut fracs = scene.study.frac.clone();
        if fracs.is_empty() {
            fracs = SHARES.map(|share| share * preset_frac).to_vec();
        }
        fracs.sort_by(|a, b| b.total_cmp(a));
        fracs.dedup();
        let wanted = reference_of(&scene, &series, &fracs)?;
        let mut cells: Vec<(usize, f64)> = Vec::new();
        for k in 0..series.len() {
            cells.extend(fracs.iter().map(|&frac| (k, frac)));
        }
        if !cells.contains(&wanted) {
            let after = |cell: &(usize, f64)| (cell.0, -cell.1) > (wanted.0, -wanted.1);
            let at = cells.iter().position(after).unwrap_or(cells.len());
            cells.insert(at, wanted);
        }
        if cells.len() > MOST {
            return Err(NoPlan::Refused(format!(
                "{} variants are more than {MOST}; leave out values of frac, law or sweep",
                cells.len()
            )));
        }
        let mut steps: Vec<Option<f64>> = vec![None; series.len()];
        let mut variants = Vec::new();
        for &(k, asked) in &cells {
            let step = match steps[k] {
                Some(step) => step,
                None => base_step(&scene, &series[k])?,
            };
            steps[k] = Some(step);
            let base = [preset_frac, preset_dt, step];
            variants.push(variant(&scene, &series, k, asked, base)?);
        }
        let reference = cells.iter().position(|cell| *cell == wanted);
        let mut plan = Self {
            questions: questions(&scene),
            scene,
            series,
            variants,
            reference: reference.unwrap_or_default(),
            notes: Vec::new(),
        };
        plan.note();
        Ok(plan)
    }

    /// Name of a variant: its law, FRAC and swept keys.
    pub fn name(&self, variant: usize) -> String {
        let Variant { series, asked, .. } = &self.variants[variant];
        let Series { law, settings } = &self.series[*series];
        let mut name = format!("{law}@{}", figure(*asked));
        for setting in settings {
            name = format!("{name} {setting}");
        }
        name
    }

    fn note(&mut self) {
        for k in 0..self.variants.len() {
            let Variant { asked, frac, .. } = self.variants[k];
            if frac != asked {
                self.notes.push(format!(
                    "{} runs with frac = {}, so that whole cycles make up the stages",
                    self.name(k),
                    figure(frac)
                ));
            }
        }
        let reference = &self.variants[self.reference];
        let compared = self.questions.iter().any(|asked| !asked.is_known());
        let finer =
            |variant: &Variant| variant.series == reference.series && variant.frac < reference.frac;
        if compared && self.variants.iter().any(finer) {
            self.notes.push(format!(
                "{} is not the finest run of its law: the errors of finer ones are mostly its own",
                self.name(self.reference)
            ));
        }
        if self.scene.setup.frac_auto.is_some() {
            self.notes.push(
                "cycles of the preset, whose frac is auto, count with its step at the start".into(),
            );
        }
        if self.scene.setup.damping.con1 != 1.0 {
            self.notes.push(
                "con1 acts once per cycle, whatever the step: the variants are damped differently"
                    .into(),
            );
        }
    }
}

impl Series {
    /// Its law and swept keys.
    pub fn name(&self) -> String {
        let mut name = self.law.clone();
        for setting in &self.settings {
            name = format!("{name} {setting}");
        }
        name
    }
}

/// Laws times all combinations of swept keys.
pub(super) fn all_series(scene: &Scene) -> Vec<Series> {
    let mut laws = scene.study.law.clone();
    if laws.is_empty() {
        laws = vec![scene.setup.law.card().name.to_owned()];
    }
    let mut all: Vec<Series> = laws
        .into_iter()
        .map(|law| Series {
            law,
            settings: Vec::new(),
        })
        .collect();
    for sweep in &scene.study.sweep {
        // One more than needed is enough to be refused.
        all.truncate(MOST + 1);
        all = all
            .iter()
            .flat_map(|series| {
                sweep.values.iter().map(|value| {
                    let mut series = series.clone();
                    series.settings.push(format!("{}={value}", sweep.path));
                    series
                })
            })
            .collect();
    }
    all
}

/// The series and FRAC of the run that the others are compared with.
fn reference_of(scene: &Scene, series: &[Series], fracs: &[f64]) -> Result<(usize, f64), NoPlan> {
    let wanted = scene.study.reference.clone().unwrap_or_default();
    let smallest = fracs.iter().copied().fold(f64::INFINITY, f64::min);
    let frac = wanted.frac.unwrap_or(smallest);
    let found = match &wanted.law {
        None => Some(0),
        Some(law) => series.iter().position(|series| series.law == *law),
    };
    let Some(found) = found else {
        let law = wanted.law.unwrap_or_default();
        return Err(NoPlan::Refused(format!(
            "the reference has the law {law}, which is not run; add it to --law"
        )));
    };
    Ok((found, frac))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plan(options: &[&str]) -> Result<Plan, NoPlan> {
        let options: Vec<String> = options.iter().map(|s| (*s).to_owned()).collect();
        let scene = Scene::load("square-lattice", &options).unwrap_or_else(|r| panic!("{r}"));
        Plan::of(scene)
    }

    fn names(options: &[&str]) -> Vec<String> {
        let plan = plan(options).unwrap_or_else(|why| panic!("{why:?}"));
        (0..plan.variants.len()).map(|k| plan.name(k)).collect()
    }

    #[test]
    fn every_combination_is_run() {
        let sweep = "study.sweep=[\"material.disc.friction=0.1,1\", \"damping.contact=0,0.1\"]";
        let names = names(&["study.frac=[0.1,0.2]", sweep]);
        assert_eq!(names.len(), 8);
        assert_eq!(
            names[0],
            "linear@0.2 material.disc.friction=0.1 damping.contact=0"
        );
        assert_eq!(
            names[7],
            "linear@0.1 material.disc.friction=1 damping.contact=0.1"
        );
    }

    #[test]
    fn the_reference_is_the_finest_or_the_one_that_is_named() {
        let reference = |options: &[&str]| {
            let plan = plan(options).unwrap_or_else(|why| panic!("{why:?}"));
            plan.name(plan.reference)
        };
        assert_eq!(reference(&[]), "linear@0.030625");
        let fracs = "study.frac=[0.1,0.2]";
        assert_eq!(reference(&[fracs]), "linear@0.1");
        assert_eq!(reference(&[fracs, "study.reference=\"0.2\""]), "linear@0.2");
        // One that is not among the variants is run too.
        let finer = [fracs, "study.reference=\"linear@0.02\""];
        assert_eq!(reference(&finer), "linear@0.02");
        assert_eq!(names(&finer), ["linear@0.2", "linear@0.1", "linear@0.02"]);
    }

    #[test]
    fn too_much_is_refused() {
        let values: Vec<String> = (1..=201).map(|k| format!("0.{k:03}")).collect();
        let sweep = format!(
            "study.sweep=[\"material.disc.friction={}\"]",
            values.join(",")
        );
        assert!(matches!(plan(&[&sweep]), Err(NoPlan::Refused(why)) if why.contains("200")));
        let law = plan(&["study.sweep=[\"material.disk.friction=1\"]"]);
        assert!(matches!(law, Err(NoPlan::Rejected(why)) if why.to_string().contains("disc")));
    }

    #[test]
    fn variants_cover_the_same_time() {
        let plan = plan(&["study.frac=[0.02,0.05,0.1,0.2,0.4]"]).unwrap_or_else(|_| panic!("fits"));
        let first = &plan.variants[0];
        for variant in &plan.variants {
            for (stage, other) in variant.scene.stages.iter().zip(&first.scene.stages) {
                let lengths = [stage, other].map(|stage| stage.max_cycles.unwrap_or(0) as f64);
                let ratio = lengths[0] * variant.dt / (lengths[1] * first.dt);
                assert!((ratio - 1.0).abs() < 1e-12, "{ratio}");
            }
        }
    }
}

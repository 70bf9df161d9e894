//! The standard scenes: presets with overrides, and where in them the clock starts.

/// A scene whose speed is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Standard {
    /// Name on the command line.
    pub name: &'static str,
    /// One line.
    pub summary: &'static str,
    /// Embedded preset.
    pub preset: &'static str,
    /// Overrides of it.
    pub set: &'static [&'static str],
    /// The stage in which the clock starts, its commands issued.
    pub stage: &'static str,
    /// Whether it takes long to prepare: measured only when it is named.
    pub large: bool,
}

/// FRACC now and then: what other programs do not watch is not timed against them.
const SELDOM: &str = "model.fracc_every=100";

/// All of them, in the order they are measured.
pub const STANDARD: &[Standard] = &[
    Standard {
        name: "shear-600",
        summary: "600 graded spheres at 100 kPa in a periodic cell, sheared; hertz-mindlin",
        preset: "periodic-shear",
        set: &[SELDOM],
        stage: "shear",
        large: false,
    },
    Standard {
        name: "fracc-600",
        summary: "the same with FRACC watched every cycle, which is every hundredth in the others",
        preset: "periodic-shear",
        set: &[],
        stage: "shear",
        large: false,
    },
    Standard {
        name: "linear-600",
        summary: "shear-600 under linear springs",
        preset: "periodic-shear",
        set: &[SELDOM, "model.law=\"linear\""],
        stage: "shear",
        large: false,
    },
    Standard {
        name: "partial-600",
        summary: "the same under Randall's Mindlin-Deresiewicz law",
        preset: "periodic-shear",
        set: &[SELDOM, "model.law=\"mindlin-deresiewicz\""],
        stage: "shear",
        large: false,
    },
    Standard {
        name: "exact-600",
        summary: "the same under the exact law of partial slip",
        preset: "periodic-shear",
        set: &[SELDOM, "model.law=\"mindlin-deresiewicz-exact\""],
        stage: "shear",
        large: false,
    },
    Standard {
        name: "dense-20k",
        summary: "21 600 spheres: the same sample 6 x 6 times, hertz-mindlin",
        preset: "periodic-shear",
        set: &[SELDOM, "start.repeat=[6, 6]"],
        stage: "shear",
        large: false,
    },
    Standard {
        name: "dense-100k",
        summary: "101 400 spheres: the same sample 13 x 13 times, hertz-mindlin",
        preset: "periodic-shear",
        set: &[SELDOM, "start.repeat=[13, 13]"],
        stage: "shear",
        large: false,
    },
    Standard {
        name: "hopper-500",
        summary: "500 spheres that leave a wedge under gravity; hertz-mindlin",
        preset: "hopper-30",
        set: &[SELDOM, "model.law=\"hertz-mindlin\""],
        stage: "discharge",
        large: true,
    },
    Standard {
        name: "dense-million",
        summary: "1 008 600 spheres: the same sample 41 x 41 times, hertz-mindlin",
        preset: "periodic-shear",
        set: &[SELDOM, "start.repeat=[41, 41]"],
        stage: "shear",
        large: true,
    },
];

/// The standard scene of this name.
pub fn find(name: &str) -> Option<&'static Standard> {
    STANDARD.iter().find(|scene| scene.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    #[test]
    fn every_one_is_accepted_and_has_its_stage() {
        for (k, standard) in STANDARD.iter().enumerate() {
            let set: Vec<String> = standard.set.iter().map(|set| (*set).to_owned()).collect();
            let scene = Scene::load(standard.preset, &set).expect(standard.name);
            let found = scene
                .stages
                .iter()
                .any(|stage| stage.name == standard.stage);
            assert!(found, "{}", standard.name);
            assert_eq!(
                STANDARD
                    .iter()
                    .position(|other| other.name == standard.name),
                Some(k)
            );
        }
    }
}

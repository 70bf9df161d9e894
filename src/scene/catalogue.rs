//! The presets that are part of the program.

/// A preset that is part of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Preset {
    /// Name on the command line: the file's name without its ending.
    pub name: &'static str,
    /// The file.
    pub text: &'static str,
}

/// All of them, in the order they are shown.
pub const PRESETS: &[Preset] = &[
    preset(
        "graded-shear",
        include_str!("../../presets/graded-shear.toml"),
    ),
    preset("disc-pile", include_str!("../../presets/disc-pile.toml")),
    preset("two-discs", include_str!("../../presets/two-discs.toml")),
    preset(
        "nine-disc-compression",
        include_str!("../../presets/nine-disc-compression.toml"),
    ),
    preset(
        "nine-disc-speed",
        include_str!("../../presets/nine-disc-speed.toml"),
    ),
    preset(
        "nine-disc-distortion",
        include_str!("../../presets/nine-disc-distortion.toml"),
    ),
    preset(
        "photoelastic",
        include_str!("../../presets/photoelastic.toml"),
    ),
    preset(
        "photoelastic-softer",
        include_str!("../../presets/photoelastic-softer.toml"),
    ),
    preset(
        "photoelastic-smoother",
        include_str!("../../presets/photoelastic-smoother.toml"),
    ),
    preset(
        "rolling-disc",
        include_str!("../../presets/rolling-disc.toml"),
    ),
    preset(
        "square-lattice",
        include_str!("../../presets/square-lattice.toml"),
    ),
    preset(
        "bonded-beam",
        include_str!("../../presets/bonded-beam.toml"),
    ),
    preset(
        "normal-impact",
        include_str!("../../presets/normal-impact.toml"),
    ),
    preset(
        "oblique-impact",
        include_str!("../../presets/oblique-impact.toml"),
    ),
    preset(
        "oblique-loading",
        include_str!("../../presets/oblique-loading.toml"),
    ),
    preset(
        "newtons-cradle",
        include_str!("../../presets/newtons-cradle.toml"),
    ),
    preset(
        "column-impact",
        include_str!("../../presets/column-impact.toml"),
    ),
    preset(
        "pluvial-bed",
        include_str!("../../presets/pluvial-bed.toml"),
    ),
    preset("bed-impact", include_str!("../../presets/bed-impact.toml")),
    preset(
        "restitution-phases",
        include_str!("../../presets/restitution-phases.toml"),
    ),
    preset(
        "graded-compression",
        include_str!("../../presets/graded-compression.toml"),
    ),
    preset(
        "uniform-compression",
        include_str!("../../presets/uniform-compression.toml"),
    ),
    preset(
        "uniform-shear",
        include_str!("../../presets/uniform-shear.toml"),
    ),
    preset(
        "barnes-1000",
        include_str!("../../presets/barnes-1000.toml"),
    ),
    preset(
        "friction-sweep",
        include_str!("../../presets/friction-sweep.toml"),
    ),
    preset(
        "continuum-shear-unstable",
        include_str!("../../presets/continuum-shear-unstable.toml"),
    ),
    preset("con1-sweep", include_str!("../../presets/con1-sweep.toml")),
    preset(
        "centripetal",
        include_str!("../../presets/centripetal.toml"),
    ),
    preset(
        "old-generator",
        include_str!("../../presets/old-generator.toml"),
    ),
    preset(
        "constant-mean-stress",
        include_str!("../../presets/constant-mean-stress.toml"),
    ),
    preset(
        "laws-compared",
        include_str!("../../presets/laws-compared.toml"),
    ),
    preset(
        "load-unload",
        include_str!("../../presets/load-unload.toml"),
    ),
    preset(
        "periodic-compression",
        include_str!("../../presets/periodic-compression.toml"),
    ),
    preset(
        "periodic-shear",
        include_str!("../../presets/periodic-shear.toml"),
    ),
    preset("biaxial", include_str!("../../presets/biaxial.toml")),
    preset(
        "shear-walls",
        include_str!("../../presets/shear-walls.toml"),
    ),
    preset("shear-cell", include_str!("../../presets/shear-cell.toml")),
    preset("hopper-30", include_str!("../../presets/hopper-30.toml")),
    preset("hopper-15", include_str!("../../presets/hopper-15.toml")),
    preset(
        "hopper-30-5mm",
        include_str!("../../presets/hopper-30-5mm.toml"),
    ),
    preset("hopper-45", include_str!("../../presets/hopper-45.toml")),
    preset(
        "hopper-30-10mm",
        include_str!("../../presets/hopper-30-10mm.toml"),
    ),
    preset(
        "hopper-30-14mm",
        include_str!("../../presets/hopper-30-14mm.toml"),
    ),
    preset(
        "pluvial-500",
        include_str!("../../presets/pluvial-500.toml"),
    ),
    preset(
        "janssen-silo",
        include_str!("../../presets/janssen-silo.toml"),
    ),
    preset("sandpile", include_str!("../../presets/sandpile.toml")),
    preset(
        "column-collapse",
        include_str!("../../presets/column-collapse.toml"),
    ),
    preset(
        "rotating-drum",
        include_str!("../../presets/rotating-drum.toml"),
    ),
    preset("chute", include_str!("../../presets/chute.toml")),
    preset("couette", include_str!("../../presets/couette.toml")),
    preset(
        "granular-gas",
        include_str!("../../presets/granular-gas.toml"),
    ),
    preset("brazilian", include_str!("../../presets/brazilian.toml")),
    preset(
        "pluvial-million",
        include_str!("../../presets/pluvial-million.toml"),
    ),
    preset(
        "large-compression",
        include_str!("../../presets/large-compression.toml"),
    ),
    preset(
        "chung-ooi-1",
        include_str!("../../presets/chung-ooi-1.toml"),
    ),
    preset(
        "chung-ooi-2",
        include_str!("../../presets/chung-ooi-2.toml"),
    ),
    preset(
        "chung-ooi-3",
        include_str!("../../presets/chung-ooi-3.toml"),
    ),
    preset(
        "chung-ooi-4",
        include_str!("../../presets/chung-ooi-4.toml"),
    ),
    preset(
        "chung-ooi-5",
        include_str!("../../presets/chung-ooi-5.toml"),
    ),
    preset(
        "chung-ooi-6",
        include_str!("../../presets/chung-ooi-6.toml"),
    ),
    preset(
        "chung-ooi-7",
        include_str!("../../presets/chung-ooi-7.toml"),
    ),
    preset(
        "chung-ooi-8",
        include_str!("../../presets/chung-ooi-8.toml"),
    ),
];

const fn preset(name: &'static str, text: &'static str) -> Preset {
    Preset { name, text }
}

/// The preset of this name.
pub fn find(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_is_listed_once() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/presets");
        let mut files: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|file| file.unwrap().path())
            .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
            .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
            .collect();
        files.sort();
        let mut listed: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
        listed.sort_unstable();
        assert_eq!(files, listed);
    }
}

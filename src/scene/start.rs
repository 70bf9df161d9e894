//! `[start]`: the sample that a scene starts from, instead of particles of its own.
//!
//! Here it is only named. Whoever opens the scene finds or prepares the sample and has the preset read
//! again with it: then its particles and walls are known by number and name, like listed ones.

use super::draft::{Draft, Mark};
use super::key::{Absent, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::boundary::Boundary;
use crate::engine::setup::{ParticleSetup, WallSetup};

/// What a scene starts from.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// Where the sample comes from.
    pub from: Source,
    /// What of it is kept.
    pub keep: Keep,
    /// How often it is repeated along the two edges of its cell.
    pub repeat: [u32; 2],
    /// Hash of the state that the run began with when it was repeated from.
    pub state: Option<u64>,
}

/// Where a sample comes from. Paths are as written: relative to the folder of the preset.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A checkpoint.
    File(String),
    /// A run of another preset.
    Preset {
        /// Embedded name or path.
        name: String,
        /// The stage at whose end it is taken; `None`: the last one.
        stage: Option<String>,
        /// Options `--set` of that run.
        set: Vec<String>,
    },
}

/// What of a sample is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Keep {
    /// Particles and walls where they are, at rest: forces follow anew from the overlaps.
    Particles,
    /// The whole state: velocities, forces and what contacts remember.
    All,
}

/// A sample that was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// Particles at rest with their numbers, ascending; materials by their place in `materials`.
    pub particles: Vec<(u32, ParticleSetup)>,
    /// Walls at rest.
    pub walls: Vec<WallSetup>,
    /// The boundary as it is by then, imposing nothing.
    pub boundary: Option<Boundary>,
    /// Names of the materials.
    pub materials: Vec<String>,
    /// The checkpoint that holds all of it.
    pub state: Vec<u8>,
}

/// Why there is no sample.
#[derive(Debug, Clone)]
pub struct Trouble {
    /// Key of `[start]` that is to blame.
    pub key: &'static str,
    /// What is wrong.
    pub message: String,
    /// What is expected there.
    pub expected: String,
    /// What to do.
    pub remedy: String,
}

/// What is known of the sample when a preset is read.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) enum Given<'a> {
    /// Nothing yet: names of particles and walls cannot be checked.
    #[default]
    Nothing,
    /// All of it.
    Sample(&'a Sample),
    /// That there is none.
    Trouble(&'a Trouble),
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "start",
    shape: Shape::Single,
    required: false,
    summary: "the sample that the scene starts from, instead of listed particles: a checkpoint, or \
              the end of a run of another preset, which is prepared once and kept",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    text(
        "from",
        Absent::Said("required, or preset"),
        "checkpoint of a run; a path is relative to the folder of the preset",
    ),
    text(
        "preset",
        Absent::Said("required, or from"),
        "preset whose run prepares the sample: an embedded name, or a path relative to the folder of \
         this preset; `model.seed` of this preset, if it is given, is the seed of that run",
    ),
    text(
        "stage",
        Absent::Said("the last one"),
        "stage of that preset at whose end the sample is taken",
    ),
    Key {
        form: Form::Texts,
        ..text(
            "set",
            Absent::Said("[]"),
            "list of overrides of that preset, each \"KEY=VALUE\"",
        )
    },
    Key {
        form: Form::Word(&["particles", "all"]),
        ..text(
            "keep",
            Absent::Word("particles"),
            "what is kept: particles and walls, at rest, with forces that follow anew from the \
             overlaps by the law and materials of this preset; or all, velocities and memory of \
             contacts too, for which law and stiffnesses must be those of the sample",
        )
    },
    Key {
        form: Form::Vector,
        ..text(
            "repeat",
            Absent::Said("[1, 1]"),
            "how often a sample in a periodic cell is repeated along its two edges; particles are \
             numbered along a curve through all copies",
        )
    },
    text(
        "state",
        Absent::Said("any"),
        "`state_hash` that the start shall have: another is told; journals note it",
    ),
];

const fn text(name: &'static str, absent: Absent, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Text,
        unit: "-",
        absent,
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    if !draft.wrote.start {
        return;
    }
    let from = source(reader);
    let keep = match reader.word("keep") {
        Some("all") => Keep::All,
        _ => Keep::Particles,
    };
    let state = state(reader);
    let repeat = repeat(reader, keep);
    let Some(from) = from else {
        return;
    };
    let wrote = draft.wrote;
    if keep == Keep::All && (wrote.particles || wrote.walls || wrote.boundary) {
        reader.refuse(
            "keep",
            "keep = \"all\" goes on with a whole state, and this preset lists particles, walls or a \
             boundary",
            "a state holds its own particles, walls and boundary",
            "leave [[particle]], [[wall]], [boundary] and [cell] out and make new ones by commands of a stage, or write \
             keep = \"particles\"",
        );
    }
    draft.start = Some(Start {
        from,
        keep,
        repeat,
        state,
    });
    let known = matches!(draft.given, Given::Sample(_));
    (draft.known.names.open, draft.ever.open) = (!known, !known);
    match draft.given {
        Given::Nothing => {}
        Given::Sample(sample) => take(reader, draft, sample),
        Given::Trouble(trouble) => reader.refuse(
            trouble.key,
            &trouble.message,
            &trouble.expected,
            &trouble.remedy,
        ),
    }
}

fn source(reader: &Reader<'_>) -> Option<Source> {
    let own = |name| reader.text(name).map(|(text, _)| text.to_owned());
    let (from, preset, stage) = (own("from"), own("preset"), own("stage"));
    let set = reader.texts("set");
    let set = set.map_or_else(Vec::new, |set| {
        set.into_iter().map(|(text, _)| text.to_owned()).collect()
    });
    match reader.one_of(&["from", "preset"]) {
        Some("from") => {
            for key in ["stage", "set"].into_iter().filter(|key| reader.has(key)) {
                reader.refuse(
                    key,
                    &format!("`{key}` of [start] belongs to `preset`, not to `from`"),
                    "a checkpoint is as it is",
                    "leave it out, or name the preset that prepares the sample",
                );
            }
            from.map(Source::File)
        }
        Some(_) => preset.map(|name| Source::Preset { name, stage, set }),
        None => {
            reader.refuse(
                "from",
                "[start] does not say what to start from",
                "neither `from` nor `preset`",
                "add from = \"FILE.ballast\", a checkpoint, or preset = \"NAME\"",
            );
            None
        }
    }
}

/// Most copies of a sample along one edge.
const MOST_COPIES: f64 = 1000.0;

fn repeat(reader: &Reader<'_>, keep: Keep) -> [u32; 2] {
    let Some(repeat) = reader.vector("repeat").filter(|_| reader.has("repeat")) else {
        return [1, 1];
    };
    if keep == Keep::All {
        reader.refuse(
            "repeat",
            "`repeat` and keep = \"all\" exclude each other",
            "a whole state cannot be repeated: its contacts and what was booked belong to one cell",
            "write keep = \"particles\"",
        );
    }
    if repeat
        .iter()
        .any(|&n| n.fract() != 0.0 || !(1.0..=MOST_COPIES).contains(&n))
    {
        reader.refuse(
            "repeat",
            "`repeat` of [start] does not say how often",
            "expected two whole numbers from 1 to 1000",
            "write for instance repeat = [5, 4]",
        );
        return [1, 1];
    }
    repeat.map(|n| n as u32)
}

fn state(reader: &Reader<'_>) -> Option<u64> {
    let (text, _) = reader.text("state")?;
    let state = u64::from_str_radix(text, 16).ok();
    if state.is_none() {
        reader.refuse(
            "state",
            "`state` of [start] is no hash of a state",
            "expected sixteen hexadecimal digits",
            "copy it from the column state_hash, or leave it out",
        );
    }
    state
}

/// Takes the particles of the sample, and its walls unless the preset lists its own.
fn take<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>, sample: &Sample) {
    let key = if reader.has("from") { "from" } else { "preset" };
    let mark = Mark {
        place: reader.place_of(key),
        sound: true,
    };
    let materials = &draft.setup.materials;
    let place = |name: &str| materials.iter().position(|m| m.name == name);
    // A wall whose friction a command has set has a material of its own, MATERIAL@WALL.
    let plain = |name: &str| name.split('@').next().and_then(place);
    let places: Vec<Option<usize>> = sample
        .materials
        .iter()
        .map(|name| place(name).or_else(|| plain(name)))
        .collect();
    let walls: &[WallSetup] = if draft.wrote.walls {
        &[]
    } else {
        &sample.walls
    };
    let used = sample.particles.iter().map(|(_, p)| p.material);
    let mut used: Vec<usize> = used.chain(walls.iter().map(|w| w.material)).collect();
    used.sort_unstable();
    used.dedup();
    for lacking in used.into_iter().filter(|&k| places[k].is_none()) {
        let name = &sample.materials[lacking];
        reader.refuse(
            key,
            &format!(
                "the sample has particles or walls of material `{name}`, which this preset lacks"
            ),
            "its materials are those of this preset of the same name",
            &format!("add [material.{name}] with its density and stiffness"),
        );
    }
    let here = |k: usize| places[k].unwrap_or_default();
    for (number, particle) in &sample.particles {
        draft.setup.particles.push(ParticleSetup {
            material: here(particle.material),
            ..particle.clone()
        });
        draft.known.names.particles.push(*number);
        draft.ever.particles.push(*number);
        draft.particles.push(mark);
    }
    for wall in walls {
        draft.setup.walls.push(WallSetup {
            material: here(wall.material),
            ..wall.clone()
        });
        draft.known.names.walls.push(wall.name.clone());
        draft.ever.walls.push(wall.name.clone());
        draft.walls.push(mark);
    }
    if let Some(boundary) = &sample.boundary
        && !draft.wrote.boundary
    {
        draft.set_boundary(boundary.setup());
    }
    draft.sampled = [sample.particles.len(), walls.len()];
}

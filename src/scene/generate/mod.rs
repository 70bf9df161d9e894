//! `[[generate]]`: many particles at once, at random without contacts, on a lattice or from a file.
//!
//! They are numbered after the listed ones, in the order of the tables; within a table what was placed
//! at random along a curve that fills the region, a lattice in its rows or, 5000 sites and more, along
//! the curve, too, and what is imported as in its file.
//! What the seed and the number of the table decide is the same on every machine.

mod boxes;
mod chance;
mod crowd;
mod csv_rows;
mod distribution;
mod fill;
mod grading;
mod import;
mod keys;
mod lattice;
pub(super) mod order;
mod outcome;
mod place;
mod region;
mod typed;

pub use outcome::{Generated, SizeGenerated};
pub use typed::{Around, places};

use super::draft::{Draft, Mark};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::ParticleSetup;
use crate::language::command::MOST_GENERATED;
use chance::Chance;
use crowd::Disc;
use fill::Task;
use region::Region;

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "generate",
    shape: Shape::Listed,
    required: false,
    summary: "many particles at once: on a lattice, from a file, or at random without contacts, each \
              as likely to be anywhere it fits, the largest first, and when a size no longer fits the \
              next smaller one is tried",
    keys: keys::KEYS,
    read,
};

/// Most particles of one table.
const MOST: u64 = MOST_GENERATED;

/// How many radii from the origin a region may reach, as for a listed particle.
const FARTHEST: f64 = 1e12;

/// What is placed: one of these is given.
const SOURCES: [&str; 5] = [
    "grading",
    "grading_file",
    "distribution",
    "lattice",
    "import",
];

/// Keys that mean something with some of the sources only.
const MEANING: [(&str, &[&str]); 9] = [
    (
        "in",
        &["grading", "grading_file", "distribution", "lattice"],
    ),
    (
        "gap",
        &["grading", "grading_file", "distribution", "lattice"],
    ),
    (
        "periodic",
        &["grading", "grading_file", "distribution", "lattice"],
    ),
    ("tries", &["grading", "grading_file", "distribution"]),
    ("when_full", &["grading", "grading_file", "distribution"]),
    ("exact", &["grading", "grading_file", "distribution"]),
    ("radius", &["lattice"]),
    ("spacing", &["lattice"]),
    ("order", &["import"]),
];

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let Some(source) = reader.one_of(&SOURCES) else {
        reader.refuse(
            "",
            &format!("{} places nothing", reader.title),
            "what is placed is missing here",
            "add grading = [{ radius = 1e-3, count = 100 }], or grading_file, distribution, lattice \
             or import",
        );
        return;
    };
    for (key, _) in MEANING.iter().filter(|(_, with)| !with.contains(&source)) {
        if reader.has(key) {
            reader.refuse(
                key,
                &format!("`{key}` of {} means nothing with `{source}`", reader.title),
                "without effect",
                "leave it out",
            );
        }
    }
    let material = material(reader, draft);
    let velocity = reader.vector("velocity");
    if source == "import" {
        let imported = import::read(reader, material, velocity.unwrap_or_default(), draft);
        if let Some(mut particles) = imported {
            if reader.word("order") == Some("curve") {
                order::order(&mut particles, |particle| particle.at);
            }
            let generated = Generated::of(&reader.title, draft, None, &particles);
            draft.generated.push(generated);
            add(draft, reader, particles);
        }
        return;
    }
    for (key, example) in [
        ("in", "{ circle = { centre = [0, 0], radius = 1 } }"),
        ("material", "\"NAME\""),
    ] {
        if !reader.has(key) {
            reader.refuse(
                key,
                &format!("{} has no `{key}`", reader.title),
                &format!("`{key}` is missing here"),
                &format!("add {key} = {example}"),
            );
        }
    }
    let region = place::read(reader);
    let periodic = reader.flag("periodic").unwrap_or_default();
    if periodic && !matches!(region, None | Some(Region::Rectangle { .. })) {
        reader.refuse(
            "periodic",
            &format!("the region of {} cannot be periodic", reader.title),
            "only a rectangle can",
            "leave `periodic` out, or give a rectangle",
        );
    }
    let place = region.zip(reader.number("gap")).map(|(region, gap)| Place {
        region,
        gap,
        periodic,
    });
    let discs = if source == "lattice" {
        place.and_then(|place| arranged(reader, draft, &place))
    } else {
        at_random(reader, draft, source, place.as_ref())
    };
    let discs = discs.map(|mut discs| {
        // What was placed at random is in no order that anybody could mean.
        if source != "lattice" || discs.len() >= order::MANY {
            order::order(&mut discs, |disc| disc.at);
        }
        discs
    });
    let particle = |disc: Disc| ParticleSetup {
        at: disc.at,
        radius: disc.radius,
        material: material.unwrap_or_default(),
        velocity: velocity.unwrap_or_default(),
        spin: 0.0,
        angle: 0.0,
        force: [0.0; 2],
        fixed: [false; 3],
    };
    if let Some(discs) = discs {
        add(draft, reader, discs.into_iter().map(particle).collect());
    }
}

/// Where particles go.
struct Place {
    region: Region,
    gap: f64,
    periodic: bool,
}

fn material(reader: &Reader<'_>, draft: &Draft<'_>) -> Option<usize> {
    let (name, place) = reader.text("material")?;
    let index = draft.material(name, place, reader)?;
    if draft.setup.materials[index].rigid {
        reader.refuse(
            "material",
            &format!("{} cannot be rigid", reader.title),
            "a rigid material is for walls only",
            "choose a material with a stiffness",
        );
    }
    Some(index)
}

fn arranged(reader: &Reader<'_>, draft: &mut Draft<'_>, place: &Place) -> Option<Vec<Disc>> {
    let lattice = lattice::read(reader, &place.region, place.gap, place.periodic)?;
    check_reach(reader, &place.region, lattice.radius());
    if draft.report.count() > 0 {
        return None;
    }
    let discs = lattice.fill(&place.region, place.periodic);
    if discs.is_empty() {
        reader.refuse(
            "in",
            &format!(
                "no site of the lattice lies in the region of {}",
                reader.title
            ),
            "expected room for a circle of the spacing as diameter",
            "lengths are in metres: give a larger region or a smaller spacing",
        );
        return None;
    }
    let generated = Generated::of(&reader.title, draft, Some(place.region.area()), &discs);
    draft.generated.push(generated);
    Some(discs)
}

fn at_random<'a>(
    reader: &Reader<'a>,
    draft: &mut Draft<'a>,
    source: &str,
    place: Option<&Place>,
) -> Option<Vec<Disc>> {
    let number = draft.generated.len() as u64;
    let region = place.map(|place| &place.region);
    let wanted = match source {
        "grading" => grading::read(reader, region),
        "grading_file" => grading::read_file(reader, region, draft),
        _ => distribution::read(reader).and_then(|distribution| {
            // Not the numbers that places come from.
            let mut chance = Chance::new(draft.seed, SIZES | number);
            grading::drawn(reader, region, distribution.draw(&mut chance))
        }),
    };
    let (tries, exact) = (reader.count("tries"), reader.flag("exact"));
    let stops = reader.word("when_full") == Some("stop");
    let (wanted, place) = (wanted?, place?);
    check_reach(reader, &place.region, wanted.smallest());
    // What is wrong elsewhere decides where there is room; columns may still name every particle.
    if draft.report.count() > 0 {
        let count: usize = wanted.asked.iter().flatten().sum();
        for id in (draft.next_number()..).take(count) {
            draft.known.names.particles.push(id);
            draft.ever.particles.push(id);
        }
        return None;
    }
    let there: Vec<Disc> = draft.setup.particles.iter().map(disc).collect();
    let sizes = wanted.sizes(&place.region);
    let task = Task {
        region: &place.region,
        walls: &draft.setup.walls,
        there: &there,
        sizes: &sizes,
        gap: place.gap,
        periodic: place.periodic,
        tries,
        stops,
    };
    let (discs, placed) = fill::fill(&task, &mut Chance::new(draft.seed, number));
    let generated = Generated::new(&reader.title, draft, place.region.area(), &wanted, &placed);
    if exact == Some(true)
        && let Some(short) = generated.shortfall()
    {
        reader.refuse(
            "exact",
            &short,
            "all must fit",
            "ask for fewer or smaller ones, enlarge the region, or leave `exact` out",
        );
    }
    draft.generated.push(generated);
    Some(discs)
}

/// Streams of random numbers that sizes are drawn from.
const SIZES: u64 = 1 << 32;

fn disc(particle: &ParticleSetup) -> Disc {
    Disc {
        at: particle.at,
        radius: particle.radius,
    }
}

fn check_reach(reader: &Reader<'_>, region: &Region, smallest: f64) {
    let corners = region.bounds();
    let far = corners.iter().flatten();
    if far.fold(0.0, |far: f64, x| far.max(x.abs())) > FARTHEST * smallest {
        reader.refuse(
            "in",
            &format!("the region of {} is too far away", reader.title),
            "expected less than 1e12 of the smallest radii from the origin",
            "move the scene towards the origin: overlaps would be lost in rounding",
        );
    }
}

fn add(draft: &mut Draft<'_>, reader: &Reader<'_>, particles: Vec<ParticleSetup>) {
    let mark = Mark {
        place: reader.place,
        sound: true,
    };
    for particle in particles {
        let number = draft.next_number();
        draft.setup.particles.push(particle);
        draft.known.names.particles.push(number);
        draft.ever.particles.push(number);
        draft.particles.push(mark);
    }
}

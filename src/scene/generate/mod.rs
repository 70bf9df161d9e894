//! `[[generate]]`: many particles at once, at random without contacts.
//!
//! They are numbered after the listed ones, in the order of the tables; within a table in the order
//! in which they were placed, largest first. What the seed and the number of the table decide is the
//! same on every machine.

mod boxes;
mod chance;
mod crowd;
mod fill;
mod grading;
mod keys;
mod outcome;
mod place;
mod region;

pub use outcome::{Generated, SizeGenerated};

use super::draft::{Draft, Mark};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::ParticleSetup;
use chance::Chance;
use crowd::Disc;
use fill::Task;
use grading::Wanted;
use region::Region;

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "generate",
    shape: Shape::Listed,
    required: false,
    summary: "many particles at random without contacts: each is as likely to be anywhere it fits, \
              the largest come first, and when a size no longer fits the next smaller one is tried",
    keys: keys::KEYS,
    read,
};

/// Most particles of one table.
const MOST: u64 = 10_000_000;

/// How many radii from the origin a region may reach, as for a listed particle.
const FARTHEST: f64 = 1e12;

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let region = place::read(reader);
    let material = reader
        .text("material")
        .and_then(|(name, place)| draft.material(name, place, reader));
    if let Some(index) = material
        && draft.setup.materials[index].rigid
    {
        reader.refuse(
            "material",
            &format!("{} cannot be rigid", reader.title),
            "a rigid material is for walls only",
            "choose a material with a stiffness",
        );
    }
    let wanted = grading::read(reader, region.as_ref());
    let (gap, tries) = (reader.number("gap"), reader.count("tries"));
    let (exact, periodic) = (reader.flag("exact"), reader.flag("periodic"));
    let velocity = reader.vector("velocity");
    if periodic == Some(true) && !matches!(region, None | Some(Region::Rectangle { .. })) {
        reader.refuse(
            "periodic",
            &format!("the region of {} cannot be periodic", reader.title),
            "only a rectangle can",
            "leave `periodic` out, or give a rectangle",
        );
    }
    if let (Some(region), Some(wanted)) = (&region, &wanted) {
        check_reach(reader, region, wanted);
    }
    let (Some(region), Some(wanted), Some(gap)) = (region, wanted, gap) else {
        return;
    };
    let number = draft.generated.len();
    let sizes = wanted.sizes(&region);
    // What is elsewhere wrong decides where there is room; columns may still name every particle.
    if draft.report.count() > 0 {
        let count: usize = wanted.asked.iter().flatten().sum();
        for id in (draft.next_number()..).take(count) {
            draft.known.names.particles.push(id);
            draft.ever.particles.push(id);
        }
        return;
    }
    let there: Vec<Disc> = draft.setup.particles.iter().map(disc).collect();
    let task = Task {
        region: &region,
        walls: &draft.setup.walls,
        there: &there,
        sizes: &sizes,
        gap,
        periodic: periodic.unwrap_or_default(),
        tries,
    };
    let mut chance = Chance::new(draft.seed, number as u64);
    let (discs, placed) = fill::fill(&task, &mut chance);
    let generated = Generated::new(
        &reader.title,
        draft.next_number(),
        region.area(),
        &sizes,
        &wanted.asked,
        &placed,
    );
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
    add(
        draft,
        reader,
        &discs,
        material.unwrap_or_default(),
        velocity.unwrap_or_default(),
    );
}

fn disc(particle: &ParticleSetup) -> Disc {
    Disc {
        at: particle.at,
        radius: particle.radius,
    }
}

fn check_reach(reader: &Reader<'_>, region: &Region, wanted: &Wanted) {
    let corners = region.bounds();
    let farthest = corners
        .iter()
        .flatten()
        .fold(0.0, |far: f64, x| far.max(x.abs()));
    if farthest > FARTHEST * wanted.smallest() {
        reader.refuse(
            "in",
            &format!("the region of {} is too far away", reader.title),
            "expected less than 1e12 of the smallest radii from the origin",
            "move the scene towards the origin: overlaps would be lost in rounding",
        );
    }
}

fn add(
    draft: &mut Draft<'_>,
    reader: &Reader<'_>,
    discs: &[Disc],
    material: usize,
    velocity: [f64; 2],
) {
    let mark = Mark {
        place: reader.place,
        sound: true,
    };
    for disc in discs {
        let number = draft.next_number();
        draft.setup.particles.push(ParticleSetup {
            at: disc.at,
            radius: disc.radius,
            material,
            velocity,
            spin: 0.0,
            angle: 0.0,
            force: [0.0; 2],
            fixed: [false; 3],
        });
        draft.known.names.particles.push(number);
        draft.ever.particles.push(number);
        draft.particles.push(mark);
    }
}

//! Pictures for papers: what the panes of the workbench draw, as SVG.

mod assembly;
mod histogram;
mod mohr;
mod path;
pub(crate) mod plate;
mod rose;

use std::error::Error;

use super::{Refusal, Session};
use crate::language::command::PictureOf;
use crate::measure::frame::Picture;
use crate::measure::survey::{Part, Parts, Survey};

/// Why a picture cannot be drawn.
type Failure = Box<dyn Error>;

impl Session {
    /// A picture of what there is now, or of the stress path so far.
    pub fn picture(&mut self, of: PictureOf) -> Result<String, Refusal> {
        if of == PictureOf::StressPath {
            let points = path::recorded(self)?;
            return path::svg(&points).map_err(|error| failed(&error));
        }
        let cycle = self.world.cycle_number();
        let sample = self.sample();
        if of == PictureOf::Assembly {
            return Ok(assembly::svg(&Picture::of(sample.world()), cycle));
        }
        let parts = [
            Part::Directions,
            Part::Tensors,
            Part::Obliquity,
            Part::NormalForce,
            Part::ContactStress,
        ];
        let parts = parts.into_iter().fold(Parts::default(), Parts::with);
        let survey = Survey::of(&sample, parts);
        let touches = survey.normal_force.as_ref();
        if touches.is_none_or(|force| force.count() == 0.0) {
            return Err(Refusal::new(
                "nothing touches: there is nothing to draw",
                "run until there are contacts",
            ));
        }
        let drawn = match of {
            PictureOf::Mohr => mohr::svg(&survey, cycle),
            PictureOf::Rose => rose::svg(&survey, cycle),
            _ => histogram::svg(&survey, cycle),
        };
        drawn.map_err(|error| failed(&error))
    }
}

fn failed(error: &Failure) -> Refusal {
    Refusal::new(
        format!("the picture cannot be drawn: {error}"),
        "`print` and `export csv` give the numbers",
    )
}

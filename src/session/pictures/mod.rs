//! Pictures for papers: what the panes of the workbench draw, as SVG.

mod assembly;
mod histogram;
mod mohr;
mod path;
pub(crate) mod plate;
mod polygon;
mod rose;

use std::error::Error;

use super::{Refusal, Session};
use crate::language::command::PictureOf;
use crate::measure::frame::Picture;
use crate::measure::polygon::ForcePolygon;
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
        if let PictureOf::Assembly(layers) = of {
            return Ok(assembly::svg(&Picture::of(sample.world()), cycle, layers));
        }
        if let PictureOf::Polygon(id) = of {
            let world = sample.world();
            let Some(p) = world.particles().index(id) else {
                return Err(Refusal::new(
                    format!("there is no particle {id}"),
                    "`print balls` lists them",
                ));
            };
            let polygon = ForcePolygon::of(world, p);
            if polygon.is_empty() {
                return Err(Refusal::new(
                    format!("nothing acts on particle {id}: there is nothing to draw"),
                    "run until it touches something",
                ));
            }
            return polygon::svg(&polygon, cycle).map_err(|error| failed(&error));
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

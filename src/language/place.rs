//! Parts of the plane as a line names them: a circle, a rectangle, a region of the preset.

use std::fmt;

use super::command::vector;
use super::mistake::Mistake;
use super::number;
use super::words::Words;
use crate::measure::region::Shape;

/// A part of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A circle.
    Circle {
        /// Its centre [m].
        centre: [f64; 2],
        /// Its radius [m].
        radius: f64,
    },
    /// A rectangle along the axes.
    Rectangle {
        /// Lower left corner [m].
        min: [f64; 2],
        /// Upper right corner [m].
        max: [f64; 2],
    },
}

impl Place {
    pub(super) fn parse(words: &mut Words<'_>) -> Result<Self, Mistake> {
        if words.keyword(&["circle", "rectangle"])? == "circle" {
            Ok(Self::Circle {
                centre: words.vector("the centre")?,
                radius: words.positive("the radius of the circle")?,
            })
        } else {
            Self::rectangle(words)
        }
    }

    fn rectangle(words: &mut Words<'_>) -> Result<Self, Mistake> {
        let a = words.vector("one corner")?;
        let begin = words.position();
        let b = words.vector("the opposite corner")?;
        let min = [a[0].min(b[0]), a[1].min(b[1])];
        let max = [a[0].max(b[0]), a[1].max(b[1])];
        if min[0] == max[0] || min[1] == max[1] {
            return Err(Mistake::new(
                "the rectangle has no area",
                "give two opposite corners",
                begin..words.position(),
            ));
        }
        Ok(Self::Rectangle { min, max })
    }

    /// The same as a region that particles are in or not.
    pub fn shape(self) -> Shape {
        match self {
            Self::Circle { centre, radius } => Shape::Circle { centre, radius },
            Self::Rectangle { min, max } => Shape::Rectangle { min, max },
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Circle { centre, radius } => {
                let radius = number::format(radius);
                write!(f, "circle {} {radius}", vector(centre))
            }
            Self::Rectangle { min, max } => {
                write!(f, "rectangle {} {}", vector(min), vector(max))
            }
        }
    }
}

/// Where something is measured.
#[derive(Debug, Clone, PartialEq)]
pub enum Where {
    /// In the first region, or everywhere.
    Default,
    /// In the region of this name.
    Region(String),
    /// Here.
    Here(Place),
}

impl Where {
    pub(super) fn parse(words: &mut Words<'_>) -> Result<Self, Mistake> {
        Ok(match words.region_if_any()? {
            None => Self::Default,
            // A region may be called so, too, and a number of rings follow it.
            Some(name) if name == "in" && !words.is_at_end() && !words.is_at_number() => {
                Self::Here(Place::parse(words)?)
            }
            Some(name) => Self::Region(name),
        })
    }
}

impl fmt::Display for Where {
    /// A blank before it, if there is anything.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Default => Ok(()),
            Self::Region(name) => write!(f, " {name}"),
            Self::Here(place) => write!(f, " in {place}"),
        }
    }
}

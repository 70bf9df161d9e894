//! What a line can refer to: walls, particles, regions and materials.

use super::command::{
    Command, Continuum, Create, Export, FrictionOf, Generate, Goal, HistoryChange, MOST_GENERATED,
    PictureOf, Printout, WallChange, Where,
};
use super::definition::Definitions;
use super::mistake::{Mistake, shown};
use crate::engine::setup::BoundarySetup;
use crate::measure::columns::{Names, Partner, UnknownColumn, nearest};
use std::ops::Range;

/// What exists. Commands are checked against it before anything runs, and completions come from it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Known {
    /// Walls, particles, regions and materials.
    pub names: Names,
    /// Columns that the preset makes.
    pub definitions: Definitions,
    /// What strain and stress are imposed by.
    pub boundary: Option<BoundarySetup>,
}

impl Known {
    /// Whether everything exists that the command of this line refers to.
    pub fn check(&self, command: &Command, line: &str) -> Result<(), Mistake> {
        match command {
            Command::Create(Create { material, .. })
            | Command::Generate(Generate { material, .. }) => {
                self.material(material.as_ref(), line)
            }
            Command::Delete(range) => {
                self.particle(range.first, line)?;
                self.particle(range.last, line)
            }
            Command::Wall(_, WallChange::Create { .. })
                if matches!(self.boundary, Some(BoundarySetup::Cell { .. })) =>
            {
                Err(Mistake::new(
                    "the assembly lies in a periodic cell, whose images repeat no wall that ends",
                    "let the preset have a [[wall]] from h1 = -inf to h2 = inf",
                    0..line.len(),
                ))
            }
            Command::Wall(name, WallChange::Create { material, .. }) => {
                if self.names.walls.contains(name) {
                    return Err(Mistake::new(
                        format!("there is a wall `{name}` already"),
                        "choose another name or delete it first",
                        place(line, name),
                    ));
                }
                self.material(material.as_ref(), line)
            }
            Command::Wall(name, _) => self.wall(name, line),
            Command::Strain(_)
            | Command::Servo(Some(_))
            | Command::Stress(_)
            | Command::Continuum(Continuum::Boundary) => self.a_boundary(command, line),
            Command::Boundary(Some(_)) => match self.boundary {
                Some(BoundarySetup::Cell { .. }) => Err(Mistake::new(
                    "the assembly lies in a periodic cell",
                    "a cell is there from the start to the end: leave [cell] out of the preset",
                    0..line.len(),
                )),
                _ => Ok(()),
            },
            Command::Particle(id, _)
            | Command::Print(Printout::Polygon(id))
            | Command::Export(Export::Picture(PictureOf::Polygon(id)), _) => {
                self.particle(*id, line)
            }
            Command::Property(material, ..) => self.material(Some(material), line),
            Command::Friction(_, of) => match of {
                FrictionOf::Everything => Ok(()),
                FrictionOf::Material(name) => self.material(Some(name), line),
                FrictionOf::Wall(name) => self.wall(name, line),
                FrictionOf::Pair(a, b) => {
                    self.material(Some(a), line)?;
                    self.material(Some(b), line)
                }
            },
            Command::Solve(solve) => match &solve.goal {
                Some(Goal::Until(condition)) => condition.check(&self.names),
                _ => Ok(()),
            },
            Command::InspectContact(id, Partner::Particle(other)) => {
                self.particle(*id, line)?;
                self.particle(*other, line)
            }
            Command::InspectContact(id, Partner::Wall(name)) => {
                self.particle(*id, line)?;
                self.wall(name, line)
            }
            Command::Print(
                Printout::Measure(_, Where::Region(region))
                | Printout::Profile(Where::Region(region), _),
            )
            | Command::Export(Export::Profile(Where::Region(region), _), _) => {
                self.region(region, line)
            }
            Command::History(HistoryChange::Columns(columns)) => columns
                .iter()
                .try_for_each(|column| column.check(&self.names, place(line, &column.name()))),
            _ => Ok(()),
        }
    }

    /// Takes over what the command adds and removes, so that the lines after it can be checked. A
    /// new particle gets the number after the highest.
    pub fn follow(&mut self, command: &Command) {
        match command {
            Command::Create(_) => {
                let highest = self.names.particles.last().copied().unwrap_or(0);
                self.names.particles.extend(highest.checked_add(1));
            }
            // How many will fit is not known yet: as many numbers as there may be.
            Command::Generate(generate) => {
                let highest = self.names.particles.last().copied().unwrap_or(0);
                let most = generate.most().min(MOST_GENERATED) as usize;
                self.names
                    .particles
                    .extend((highest.saturating_add(1)..u32::MAX).take(most));
            }
            Command::Delete(range) => self.names.particles.retain(|id| !range.contains(*id)),
            Command::Boundary(boundary) => self.boundary = *boundary,
            Command::Wall(name, WallChange::Create { .. }) => self.names.walls.push(name.clone()),
            Command::Wall(name, WallChange::Delete) => self.names.walls.retain(|w| w != name),
            _ => {}
        }
    }

    fn a_boundary(&self, command: &Command, line: &str) -> Result<(), Mistake> {
        if self.boundary.is_some() || self.names.open {
            return Ok(());
        }
        Err(Mistake::new(
            format!("there is no boundary for `{}`", command.card().name),
            "add [boundary] or [cell] to the preset, or use the command boundary before",
            0..line.len(),
        ))
    }

    fn material(&self, name: Option<&String>, line: &str) -> Result<(), Mistake> {
        match name {
            Some(name) if !self.names.materials.contains(name) => Err(Mistake::new(
                format!("there is no material {}", shown(name)),
                nearest(name, self.names.materials.iter().map(String::as_str)),
                place(line, name),
            )),
            _ => Ok(()),
        }
    }

    fn wall(&self, name: &str, line: &str) -> Result<(), Mistake> {
        let checked = self.names.wall(name);
        checked.map_err(|unknown| refused(unknown, place(line, name)))
    }

    fn region(&self, name: &str, line: &str) -> Result<(), Mistake> {
        let checked = self.names.region(name);
        checked.map_err(|unknown| refused(unknown, place(line, name)))
    }

    fn particle(&self, id: u32, line: &str) -> Result<(), Mistake> {
        let checked = self.names.particle(id);
        checked.map_err(|unknown| refused(unknown, place(line, &id.to_string())))
    }
}

fn refused(unknown: UnknownColumn, place: Range<usize>) -> Mistake {
    Mistake::new(unknown.message, unknown.remedy, place)
}

/// Where a line names something: the last place, since verbs come first; the whole line if it is
/// written in another way than its canonical one.
fn place(line: &str, name: &str) -> Range<usize> {
    match line.rfind(name) {
        Some(start) => start..start + name.len(),
        None => 0..line.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known() -> Known {
        Known {
            names: Names {
                walls: vec!["left".into(), "floor".into()],
                particles: vec![1, 2, 3],
                regions: vec![],
                materials: vec!["glass".into(), "steel".into()],
                open: false,
            },
            definitions: Definitions::default(),
            boundary: None,
        }
    }

    fn refusal(line: &str) -> String {
        let mistake = known()
            .check(&Command::parse(line).unwrap(), line)
            .unwrap_err();
        format!("{mistake} @ {}", &line[mistake.span.clone()])
    }

    #[test]
    fn what_does_not_exist_is_refused() {
        for (line, text) in [
            (
                "create at 0 0 radius 1 material stel",
                "there is no material `stel`; did you mean `steel`? @ stel",
            ),
            (
                "wall lfet spin 1",
                "there is no wall `lfet`; did you mean `left`? @ lfet",
            ),
            (
                "wall left from 0 0 to 1 1",
                "there is a wall `left` already; choose another name or delete it first @ left",
            ),
            (
                "delete 2-9",
                "there is no particle 9; they are numbered 1 to 3 @ 9",
            ),
            (
                "solve until contact:1-9:n > 0",
                "there is no particle 9; they are numbered 1 to 3 @ contact:1-9:n",
            ),
            (
                "history columns kinetic,wall:roof:f1",
                "there is no wall `roof`; there is left, floor @ wall:roof:f1",
            ),
            (
                "friction 1 pair glass lead",
                "there is no material `lead`; there is glass, steel @ lead",
            ),
            (
                "print stress core",
                "there is no region `core`; the preset has no [[measure]] @ core",
            ),
            (
                "strain rate 1 0 0 1",
                "there is no boundary for `strain`; add [boundary] or [cell] to the preset, or use the command boundary before @ strain rate 1 0 0 1",
            ),
            (
                "print polygon 7",
                "there is no particle 7; they are numbered 1 to 3 @ 7",
            ),
            (
                "inspect contact 1-roof",
                "there is no wall `roof`; there is left, floor @ roof",
            ),
        ] {
            assert_eq!(refusal(line), text);
        }
    }

    #[test]
    fn later_lines_see_what_earlier_ones_did() {
        let mut known = known();
        for line in [
            "wall lid from 0 0 to 1 0 material glass",
            "wall lid velocity 0 -1",
            "wall lid delete",
            "wall lid from 0 0 to 1 0",
            "create at 0 0 radius 1",
            "particle 4 free",
            "boundary circle 2",
            "strain rate 1 0 0 1",
            "generate in circle 0 0 1 radius 0.1 count 2",
            "particle 6 free",
            "delete 1-3",
            "delete 4-6",
        ] {
            let command = Command::parse(line).unwrap();
            assert_eq!(known.check(&command, line), Ok(()), "{line}");
            known.follow(&command);
        }
        assert!(known.names.particles.is_empty());
    }
}

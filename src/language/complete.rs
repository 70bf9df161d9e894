//! What a half-typed line could go on with.
//!
//! The line up to the half-typed word is read by the ordinary rules, which note what they would
//! accept where it ends. There is no second grammar to keep in step.

use super::known::Known;
use super::list::COMMANDS;
use super::name::is_name;
use super::words::{Wanted, Words, quoted};
use crate::measure::columns::{MATERIAL, WALL, assembly};

/// What could replace the end of a line.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Completion {
    /// The byte at which the half-typed word begins.
    pub start: usize,
    /// What it could be, in the order of the lists.
    pub candidates: Vec<String>,
}

/// Completes the last word of a line, given up to the cursor.
pub fn complete(line: &str, known: &Known) -> Completion {
    let start = line
        .char_indices()
        .rev()
        .take_while(|(_, c)| c.is_alphanumeric() || matches!(c, '_' | ':' | '!' | '?'))
        .last()
        .map_or(line.len(), |(at, _)| at);
    let (head, typed) = line.split_at(start);
    let Ok(mut words) = Words::new(head, &known.definitions) else {
        return Completion {
            start,
            candidates: Vec::new(),
        };
    };
    if let Ok(card) = words.card() {
        // What is missing at the end is noted on the way, whether it may be missing or not. A line
        // that is wrong before its end stops the reading, and nothing is noted.
        let read = (card.parse)(&mut words);
        if read.is_ok() && words.end().is_err() {
            return Completion {
                start,
                candidates: Vec::new(),
            };
        }
    }
    let lower = typed.to_lowercase();
    let mut candidates: Vec<String> = Vec::new();
    for wanted in words.wanted() {
        for candidate in all(wanted, known) {
            let fits = candidate.to_lowercase().starts_with(&lower);
            if fits && !candidates.contains(&candidate) {
                candidates.push(candidate);
            }
        }
    }
    Completion { start, candidates }
}

fn all(wanted: Wanted, known: &Known) -> Vec<String> {
    match wanted {
        Wanted::Verb => COMMANDS.iter().map(|card| card.name.to_owned()).collect(),
        Wanted::Keyword(word) => vec![word.to_owned()],
        Wanted::Wall => known.names.walls.clone(),
        Wanted::Region => known.names.regions.clone(),
        Wanted::Material => {
            let names = known.names.materials.iter();
            names.map(|name| quoted(name).into_owned()).collect()
        }
        Wanted::Column => {
            let global = known.definitions.names().map(str::to_owned);
            let walls = known.names.walls.iter().flat_map(|wall| {
                WALL.iter()
                    .map(move |row| format!("wall:{wall}:{}", row.card.name))
            });
            let regions = known.names.regions.iter().flat_map(|region| {
                let regional = assembly().filter(|row| row.is_regional());
                regional.map(move |row| format!("region:{region}:{}", row.card.name))
            });
            let plain = |name: &&String| is_name(name);
            let materials = known.names.materials.iter().filter(plain);
            let materials = materials.flat_map(|material| {
                let rows = MATERIAL.iter();
                rows.map(move |row| format!("material:{material}:{}", row.card.name))
            });
            let bodies = walls.chain(regions).chain(materials);
            global.chain(bodies).collect()
        }
        Wanted::Variable => ["cycle", "time", "stage_cycle"].map(String::from).into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Definitions;
    use crate::measure::columns::Names;

    fn completed(line: &str) -> Vec<String> {
        let known = Known {
            names: Names {
                walls: vec!["left".into(), "floor".into()],
                particles: vec![1],
                regions: vec!["core".into()],
                materials: vec!["glass".into(), "soft clay".into()],
                open: false,
            },
            definitions: Definitions::default(),
            boundary: None,
        };
        complete(line, &known).candidates
    }

    #[test]
    fn every_place_has_its_own_words() {
        for (line, expected) in [
            ("cr", vec!["create"]),
            ("PA", vec!["particle", "pause"]),
            ("wall ", vec!["left", "floor"]),
            ("wall f", vec!["floor"]),
            (
                "wall left ",
                vec!["velocity", "spin", "servo", "force", "from", "delete"],
            ),
            ("wall left from 0 0 to 1 1 m", vec!["material"]),
            ("property g", vec!["glass"]),
            ("friction 0.3 pair glass ", vec!["glass", "\"soft clay\""]),
            (
                "create at 0 0 radius 1 spin 3 ",
                vec!["material", "velocity"],
            ),
            ("gravity to", vec!["towards"]),
            ("help so", vec!["solve", "source"]),
            (
                "history columns kinetic,wall:l",
                vec![
                    "wall:left:f1",
                    "wall:left:f2",
                    "wall:left:moment",
                    "wall:left:eccentricity",
                    "wall:left:x",
                    "wall:left:y",
                    "wall:left:angle",
                    "wall:left:vx",
                    "wall:left:vy",
                    "wall:left:spin",
                ],
            ),
            ("solve until abs(stage", vec!["stage_cycle"]),
            ("solve until cycle > 3 ", vec!["and", "or", "max"]),
            (
                "solve until cycle > 3 and coordination_",
                vec!["coordination_mechanical"],
            ),
            ("print contacts 1-9 ", vec![]),
            ("print mohr ", vec!["core"]),
            ("print histogram ", vec!["obliquity", "stress", "force"]),
            ("print profile c", vec!["core"]),
            ("print profile core ", vec![]),
            ("cycle 1000", vec![]),
            ("nonsense ", vec![]),
            ("wall left sideways ", vec![]),
            ("go now ", vec![]),
            ("save \"half", vec![]),
        ] {
            assert_eq!(completed(line), expected, "{line}");
        }
    }

    #[test]
    fn the_half_typed_word_is_what_gets_replaced() {
        let known = Known::default();
        assert_eq!(complete("solve until (kin", &known).start, 13);
        assert_eq!(complete("", &known).candidates.len(), COMMANDS.len());
    }
}

//! `servo`: holds or follows a stress by steering the strain rate of the boundary.

use std::fmt;

use crate::control::Component;
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number::format as number;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "servo",
    aliases: &[],
    usage: "servo [mean P] [deviator Q] [shear S] [over N] [gain G] | off",
    summary: "steers the boundary to a stress",
    detail: "Mean stress (s11 + s22)/2, s11 - s22 and shear stress (s12 + s21)/2 of the first region, in \
             Pa, are held by what is added to the strain rate of the ring, walls or cell; what is not \
             named is left to `strain rate`. Over N cycles the values are reached linearly from where \
             they are: a stress path. Gain 1 suits most assemblies; more is faster and less stable. \
             With con1 0.99 a servo is several times as fast, and gains up to 4 hold a mean stress to 0.1 % \
             while the assembly is sheared.",
    examples: &[
        "servo mean 1e5",
        "servo mean 1e5 deviator 4e4 over 100000",
        "servo mean 1e5 gain 0.5",
        "servo off",
    ],
    parse,
    changes_world: true,
};

/// What is asked of a servo.
#[derive(Debug, Clone, PartialEq)]
pub struct ServoGoal {
    /// Parts of the stress and their values [Pa].
    pub goals: Vec<(Component, f64)>,
    /// Cycles; 0: at once.
    pub over: u64,
    /// Gain.
    pub gain: f64,
}

const PARTS: [(&str, Component); 3] = [
    ("mean", Component::Mean),
    ("deviator", Component::Deviator),
    ("shear", Component::Shear),
];

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let mut left = vec!["mean", "deviator", "shear", "off"];
    let mut goal = ServoGoal {
        goals: Vec::new(),
        over: 0,
        gain: 1.0,
    };
    let first = words.keyword(&left)?;
    if first == "off" {
        return Ok(Command::Servo(None));
    }
    left.retain(|word| *word != "off" && *word != first);
    left.extend(["over", "gain"]);
    let mut option = Some(first);
    while let Some(word) = option {
        match word {
            "over" => goal.over = words.count("the number of cycles")?,
            "gain" => goal.gain = words.positive("the gain")?,
            part => {
                let (_, component) = PARTS
                    .into_iter()
                    .find(|(name, _)| *name == part)
                    .expect("only these words are offered");
                goal.goals.push((component, words.number("the stress")?));
            }
        }
        option = words.next_option(&mut left)?;
    }
    goal.goals.sort_by_key(|(component, _)| *component as u8);
    Ok(Command::Servo(Some(goal)))
}

impl fmt::Display for ServoGoal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut parts = Vec::new();
        for (component, value) in &self.goals {
            let (name, _) = PARTS[*component as usize];
            parts.push(format!("{name} {}", number(*value)));
        }
        if self.over > 0 {
            parts.push(format!("over {}", self.over));
        }
        if self.gain != 1.0 {
            parts.push(format!("gain {}", number(self.gain)));
        }
        f.write_str(&parts.join(" "))
    }
}

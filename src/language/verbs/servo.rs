//! `servo`: holds or follows a stress by steering the strain rate of the boundary.

use std::fmt;
use std::ops::Range;

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
    usage: "servo [mean P] [deviator Q] [s11 P] [s22 P] [shear S] [over N] [gain G] | off",
    summary: "steers the boundary to a stress",
    detail: "Mean stress (s11 + s22)/2, deviator s11 - s22 and shear stress (s12 + s21)/2 of the first \
             region, in Pa, are held by what is added to the strain rate of the ring, walls or cell; what is \
             not named is left to `strain rate`. `s11` and `s22` hold one direct stress, or both, instead \
             of mean and deviator: s22 while `strain rate` strains direction 1 is a biaxial test. Particles that \
             hardly touch yet are gathered by `strain rate` first: a servo is slow where nothing answers. \
             Over N cycles the values are reached linearly from where they are: a stress path. Gain 1 suits most assemblies; more is faster and less stable. \
             With con1 0.99 a servo is several times as fast, and gains up to 4 hold a mean stress to 0.1 % \
             while the assembly is sheared.",
    examples: &[
        "servo mean 1e5",
        "servo mean 1e5 deviator 4e4 over 100000",
        "servo mean 1e5 gain 0.5",
        "servo s22 1e5 gain 8",
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

/// In the order of [`Component`].
const PARTS: [(&str, Component); 5] = [
    ("mean", Component::Mean),
    ("deviator", Component::Deviator),
    ("shear", Component::Shear),
    ("s11", Component::S11),
    ("s22", Component::S22),
];

fn named(word: &str) -> Option<Component> {
    let found = PARTS.into_iter().find(|(name, _)| *name == word);
    found.map(|(_, component)| component)
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let mut left: Vec<&'static str> = PARTS.map(|(name, _)| name).to_vec();
    let mut goal = ServoGoal {
        goals: Vec::new(),
        over: 0,
        gain: 1.0,
    };
    left.push("off");
    let first = words.keyword(&left)?;
    if first == "off" {
        return Ok(Command::Servo(None));
    }
    left.retain(|word| *word != "off" && *word != first);
    left.extend(["over", "gain"]);
    let mut option = Some(first);
    let mut begin = words.position();
    while let Some(word) = option {
        match (named(word), word) {
            (Some(component), _) => {
                compatible(&goal.goals, (word, component), begin..words.position())?;
                goal.goals.push((component, words.number("the stress")?));
            }
            (None, "over") => goal.over = words.count("the number of cycles")?,
            (None, _) => goal.gain = words.positive("the gain")?,
        }
        begin = words.position();
        if words.is_at_end() {
            // What would be refused is not proposed.
            let given = |part: Component| goal.goals.iter().any(|(other, _)| part.excludes(*other));
            left.retain(|word| !named(word).is_some_and(given));
        }
        option = words.next_option(&mut left)?;
    }
    goal.goals.sort_by_key(|(component, _)| *component as u8);
    Ok(Command::Servo(Some(goal)))
}

/// Refuses a part of the stress that is steered already by others.
fn compatible(
    goals: &[(Component, f64)],
    (word, component): (&str, Component),
    span: Range<usize>,
) -> Result<(), Mistake> {
    let clash = goals.iter().find(|(other, _)| component.excludes(*other));
    let Some((other, _)) = clash else {
        return Ok(());
    };
    let (other, _) = PARTS[*other as usize];
    Err(Mistake::new(
        format!("`{word}` cannot be held together with `{other}`"),
        "a direct stress is part of both mean and deviator: give s11 and s22, or mean and deviator",
        span,
    ))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Known;
    use crate::language::complete::complete;

    #[test]
    fn direct_stresses_stand_for_mean_and_deviator() {
        for line in [
            "servo s22 1e5",
            "servo s11 2e5 s22 1e5 over 100",
            "servo shear 0 s11 1e5 gain 8",
        ] {
            let command: Command = line.parse().expect("they go together");
            let again: Command = command
                .to_string()
                .parse()
                .expect("it is written to be read");
            assert_eq!(command, again, "{line}");
        }
        for (line, at) in [
            ("servo mean 1e5 s22 1e5", 15),
            ("servo s11 1e5 deviator 0", 14),
            ("servo s11 1e5 s22 1e5 mean 1e5", 22),
        ] {
            let mistake = line.parse::<Command>().expect_err("they say too much");
            assert!(mistake.message.contains("together with"), "{mistake}");
            assert!(mistake.remedy.contains("s11 and s22"), "{mistake}");
            assert_eq!(mistake.span.start, at, "{line}");
        }
    }

    #[test]
    fn what_would_be_refused_is_not_proposed() {
        let proposed = |line| complete(line, &Known::default()).candidates;
        assert_eq!(
            proposed("servo "),
            ["mean", "deviator", "shear", "s11", "s22", "off"]
        );
        assert_eq!(proposed("servo s22 1e5 "), ["shear", "s11", "over", "gain"]);
        assert_eq!(
            proposed("servo mean 1e5 "),
            ["deviator", "shear", "over", "gain"]
        );
    }
}

//! The same experiment in another time step.
//!
//! Lengths of stages, rows and limits are numbers of cycles in a preset. A variant of another step
//! takes as many of its own cycles as cover the same time. Lengths come out whole because the plan
//! chose the step so; limits of stages that wait for a condition are rounded up; rows come at the
//! same times wherever the steps allow it.

use crate::language::Command;
use crate::language::command::{Goal, HistoryChange, Solve};
use crate::scene::Scene;

/// So many cycles of a variant take the time of so many of the preset's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pace {
    own: f64,
    preset: f64,
}

/// Ratios that differ by less are the same: they come from a few roundings.
const ROUNDING: f64 = 1e-9;

/// Largest denominator of a ratio that is taken for a fraction.
const DENOMINATOR: f64 = 1000.0;

/// Rows may come at most so many times more seldom than the preset says, to fall on its times.
const SELDOM: u64 = 64;

impl Pace {
    /// `own` cycles take the time of `preset` cycles.
    pub fn new(own: u64, preset: u64) -> Self {
        let common = common_divisor(own, preset).max(1);
        Self {
            own: (own / common) as f64,
            preset: (preset / common) as f64,
        }
    }

    /// So many cycles per cycle of the preset; the fraction it stands for, if it stands for one.
    pub fn of(ratio: f64) -> Self {
        let mut preset = 1.0;
        while preset <= DENOMINATOR {
            let own = (ratio * preset).round();
            if own >= 1.0 && is_near(own, ratio * preset) {
                return Self { own, preset };
            }
            preset += 1.0;
        }
        Self {
            own: ratio,
            preset: 1.0,
        }
    }

    /// Cycles per cycle of the preset.
    pub fn ratio(self) -> f64 {
        self.own / self.preset
    }

    /// Cycles of the preset, in time, that so many own ones are.
    pub fn preset_cycles(self, own: f64) -> f64 {
        let cycles = own * self.preset / self.own;
        if is_near(cycles.round(), cycles) {
            cycles.round()
        } else {
            cycles
        }
    }

    /// The number of own cycles that takes the time of so many of the preset's, if there is one.
    pub fn whole(self, cycles: u64) -> Option<u64> {
        let own = cycles as f64 * self.own / self.preset;
        is_near(own.round(), own).then_some(own.round() as u64)
    }

    /// Own cycles that take at least the time of so many of the preset's.
    pub fn at_least(self, cycles: u64) -> u64 {
        let own = cycles as f64 * self.own / self.preset;
        self.whole(cycles).unwrap_or(own.ceil() as u64)
    }

    /// The nearest number of own cycles, at least one.
    pub fn nearest(self, cycles: u64) -> u64 {
        let own = cycles as f64 * self.own / self.preset;
        (own.round() as u64).max(1)
    }

    /// Own cycles between rows: at times at which the preset has rows too, as often as it can be.
    pub fn rows(self, every: u64) -> u64 {
        let mut multiples = (1..=SELDOM).map(|k| every.saturating_mul(k));
        multiples
            .find_map(|cycles| self.whole(cycles).filter(|own| *own > 0))
            .unwrap_or(self.nearest(every))
    }
}

fn is_near(whole: f64, number: f64) -> bool {
    (whole - number).abs() <= ROUNDING * whole.max(1.0)
}

/// Greatest common divisor; of zero and a number, the number.
fn common_divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { common_divisor(b, a % b) }
}

/// The largest number of cycles of which the length of every stage is a multiple; 0 if no stage has
/// a fixed length.
pub fn unit(scene: &Scene) -> u64 {
    let lengths = scene.stages.iter().flat_map(|stage| {
        let own = stage.max_cycles.filter(|_| stage.until.is_none());
        let commands = stage.commands.iter().filter_map(|command| match command {
            Command::Cycle(cycles) | Command::Step(cycles) => Some(*cycles),
            _ => None,
        });
        own.into_iter().chain(commands)
    });
    lengths.fold(0, common_divisor)
}

/// Turns a scene into the same experiment at another pace. `frac` is by how much FRAC differs from
/// the preset's: commands that set it keep the proportion.
pub fn keep_pace(scene: &mut Scene, pace: Pace, frac: f64) {
    let every = scene.history.every;
    let check = scene.check_every.unwrap_or(every);
    scene.check_every = Some(pace.nearest(check));
    scene.history.every = pace.rows(every);
    for stage in &mut scene.stages {
        stage.max_cycles = stage.max_cycles.map(|cycles| pace.at_least(cycles));
        stage.check_every = stage.check_every.map(|cycles| pace.nearest(cycles));
        stage.until = stage.until.take().map(|until| counting(until, pace));
        for command in &mut stage.commands {
            adapt(command, pace, frac);
        }
    }
}

fn counting(expression: crate::language::Expression, pace: Pace) -> crate::language::Expression {
    if pace.own == pace.preset {
        return expression;
    }
    expression.counting(pace.own, pace.preset)
}

/// Commands that count cycles or name FRAC.
fn adapt(command: &mut Command, pace: Pace, frac: f64) {
    match command {
        Command::Cycle(cycles) | Command::Step(cycles) => *cycles = pace.at_least(*cycles),
        Command::Solve(Solve { goal, max }) => {
            *max = max.map(|cycles| pace.at_least(cycles));
            if let Some(Goal::Until(until)) = goal {
                *until = counting(until.clone(), pace);
            }
        }
        Command::History(HistoryChange::Every(every)) => *every = pace.rows(*every),
        Command::Frac(value) => *value *= frac,
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_recognised() {
        let pace = Pace::of(0.1 / 0.04);
        assert_eq!(pace, Pace::new(5, 2));
        assert_eq!(Pace::of(0.1 / 0.02), Pace::new(5, 1));
        assert_eq!(Pace::of(0.245 / 0.1), Pace::new(49, 20));
        assert_eq!(Pace::of(0.1 / 0.4), Pace::new(1, 4));
        let odd = Pace::of(std::f64::consts::PI);
        assert_eq!(odd.ratio(), std::f64::consts::PI);
    }

    #[test]
    fn cycles_become_those_of_the_same_time() {
        let pace = Pace::of(2.5);
        assert_eq!(pace.whole(40), Some(100));
        assert_eq!(pace.whole(41), None);
        assert_eq!(pace.at_least(41), 103);
        assert_eq!(pace.nearest(1), 3);
        assert_eq!(Pace::of(0.25).nearest(1), 1);
        // Every second row of the preset has a partner.
        assert_eq!(pace.rows(5), 25);
        assert_eq!(Pace::of(0.25).rows(10), 5);
        assert_eq!(pace.preset_cycles(25.0), 10.0);
        assert_eq!(Pace::of(0.1 / 0.3).preset_cycles(1.0), 3.0);
    }

    const SCENE: &str = "[model]\nbody = \"disc\"\n[material.m]\ndensity = 1e3\n\
        normal_stiffness = 1e6\n[[particle]]\nat = [0, 0]\nradius = 1\nmaterial = \"m\"\n\
        [history]\nevery = 10\n\
        [[stage]]\nname = \"a\"\ndo = [\"frac 0.2\", \"cycle 60\", \"history every 20\"]\n\
        max_cycles = 100\n\
        [[stage]]\nname = \"b\"\ndo = [\"solve until cycle > 7 max 9\"]\n\
        until = \"stage_cycle >= 8\"\nmax_cycles = 7\ncheck_every = 4\n";

    #[test]
    fn everything_that_counts_cycles_follows() {
        let mut scene = Scene::parse("s", SCENE, &[]).unwrap();
        assert_eq!(unit(&scene), 20);
        keep_pace(&mut scene, Pace::of(2.5), 0.4);
        let [a, b] = scene.stages.as_slice() else {
            panic!("two stages were written");
        };
        assert_eq!(scene.history.every, 25);
        assert_eq!(scene.check_every, Some(25));
        assert_eq!(a.max_cycles, Some(250));
        let lines = |stage: &crate::scene::Stage| -> Vec<String> {
            stage.commands.iter().map(ToString::to_string).collect()
        };
        assert_eq!(
            lines(a),
            ["frac 0.08000000000000002", "cycle 150", "history every 50"]
        );
        assert_eq!(lines(b), ["solve until cycle * 2 / 5 > 7 max 23"]);
        assert_eq!(b.max_cycles, Some(18));
        assert_eq!(b.check_every, Some(10));
        let until = b.until.as_ref().map(ToString::to_string);
        assert_eq!(until.as_deref(), Some("stage_cycle * 2 / 5 >= 8"));
    }
}

//! What an error is of: the questions that every variant answers.

use crate::language::{Expression, Observable, Quantity};
use crate::measure::columns::Column;
use crate::scene::{Answer, Band, Expect, Question, Scene};

/// A question with what is known about its answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Asked {
    /// What is asked, as written.
    pub text: String,
    /// Rows of this stage are looked at; `None`: all rows.
    pub stage: Option<String>,
    /// Who knows the answer; empty: a run.
    pub source: String,
    /// How it is asked.
    pub kind: Kind,
}

/// How a question is asked.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// A number in every row, compared with a run at the same times.
    Course(Expression),
    /// One number made of the rows, compared with that of a run.
    Number(Quantity),
    /// Numbers whose exact values are known.
    Known(Vec<Answer>),
}

/// An expectation with a wider band says where a number should lie, not what it is.
const NARROW: f64 = 0.01;

/// The questions of a study: those asked for; else what is answered; else narrow expectations; else
/// the columns that the preset names, or the kinetic energy.
pub fn questions(scene: &Scene) -> Vec<Asked> {
    if !scene.study.questions.is_empty() {
        let asked = scene.study.questions.iter();
        return asked
            .flat_map(|question| asked_for(scene, question))
            .collect();
    }
    let mut names: Vec<&str> = Vec::new();
    for answer in &scene.answers {
        if !names.contains(&answer.to.as_str()) {
            names.push(&answer.to);
        }
    }
    let mut all: Vec<Asked> = names.iter().map(|name| answered(scene, name)).collect();
    if all.is_empty() {
        let narrow = scene.expects.iter().filter(|expect| is_narrow(expect));
        all.extend(narrow.map(expected));
    }
    if all.is_empty() {
        let columns = columns(scene);
        all.extend(columns.iter().filter_map(|name| {
            let course = Expression::parse_with(name, &scene.definitions).ok()?;
            Some(by_run(name, Kind::Course(course)))
        }));
    }
    all
}

fn columns(scene: &Scene) -> Vec<String> {
    // What describes the run rather than the material has no error.
    let about_the_run = ["dt", "fracc", "frac_limit", "energy_error", "state_hash"];
    let mut names: Vec<String> = scene.history.columns.iter().map(Observable::name).collect();
    names.retain(|name| !about_the_run.contains(&name.as_str()));
    if !scene.history.named || names.is_empty() {
        names = vec!["kinetic".to_owned()];
    }
    names
}

fn asked_for(scene: &Scene, question: &Question) -> Vec<Asked> {
    match question {
        Question::Answered(name) => vec![answered(scene, name)],
        Question::Course(text, course) => vec![by_run(text, Kind::Course(course.clone()))],
        Question::Number(text, number) => {
            // A number that the source does not reproduce is no reference.
            let expects = scene.expects.iter();
            let known: Vec<Asked> = expects
                .filter(|expect| expect.what == *number && expect.differs.is_none())
                .map(expected)
                .collect();
            if known.is_empty() {
                vec![by_run(text, Kind::Number(number.clone()))]
            } else {
                known
            }
        }
    }
}

fn by_run(text: &str, kind: Kind) -> Asked {
    Asked {
        text: text.to_owned(),
        stage: None,
        source: String::new(),
        kind,
    }
}

fn answered(scene: &Scene, name: &str) -> Asked {
    let answers: Vec<Answer> = scene
        .answers
        .iter()
        .filter(|answer| answer.to == name)
        .cloned()
        .collect();
    let stage = answers.first().and_then(|answer| answer.stage.clone());
    let source = answers.first().map(|answer| answer.source.clone());
    Asked {
        text: name.to_owned(),
        stage,
        source: source.unwrap_or_default(),
        kind: Kind::Known(answers),
    }
}

fn is_narrow(expect: &Expect) -> bool {
    let width = match expect.within {
        Band::Absolute(width) => width,
        Band::Relative(part) => part * expect.value.abs(),
    };
    expect.differs.is_none() && width <= NARROW * expect.value.abs() && expect.value != 0.0
}

fn expected(expect: &Expect) -> Asked {
    let answer = Answer {
        to: expect.text.clone(),
        stage: expect.stage.clone(),
        parts: vec![(expect.what.clone(), expect.value)],
        // Zero has no size of its own: the error is then absolute.
        scale: if expect.value == 0.0 {
            1.0
        } else {
            expect.value.abs()
        },
        source: expect.source.clone(),
    };
    Asked {
        text: expect.text.clone(),
        stage: expect.stage.clone(),
        source: expect.source.clone(),
        kind: Kind::Known(vec![answer]),
    }
}

impl Asked {
    /// The columns that have to be recorded for it.
    pub fn columns(&self) -> Vec<Column> {
        match &self.kind {
            Kind::Course(course) => course.columns(),
            Kind::Number(number) => number.columns(),
            Kind::Known(answers) => {
                let parts = answers.iter().flat_map(|answer| &answer.parts);
                parts.flat_map(|(what, _)| what.columns()).collect()
            }
        }
    }

    /// Whether its answer is known without a run.
    pub fn is_known(&self) -> bool {
        matches!(self.kind, Kind::Known(_))
    }

    /// Whether its error is absolute, in the unit of what is asked, because the exact answer is 0.
    pub fn is_absolute(&self) -> bool {
        match &self.kind {
            Kind::Known(answers) => {
                let zero = |answer: &Answer| answer.parts.iter().all(|(_, exact)| *exact == 0.0);
                answers
                    .iter()
                    .all(|answer| answer.scale == 1.0 && zero(answer))
            }
            _ => false,
        }
    }

    /// What is asked and in which stage.
    pub fn title(&self) -> String {
        match &self.stage {
            Some(stage) => format!("{} in stage {stage}", self.text),
            None => self.text.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(more: &str, set: &[&str]) -> Scene {
        let text = format!(
            "[model]\nbody = \"disc\"\n[material.m]\ndensity = 1e3\nnormal_stiffness = 1e6\n\
             [[particle]]\nat = [0, 0]\nradius = 1\nmaterial = \"m\"\n\
             [[stage]]\nname = \"a\"\nmax_cycles = 1\n{more}"
        );
        let set: Vec<String> = set.iter().map(|s| (*s).to_owned()).collect();
        Scene::parse("s", &text, &set).unwrap_or_else(|rejection| panic!("{rejection}"))
    }

    fn titles(more: &str, set: &[&str]) -> Vec<String> {
        questions(&scene(more, set))
            .iter()
            .map(Asked::title)
            .collect()
    }

    const EXPECTS: &str = "[[expect]]\nwhat = \"last(particle:1:x)\"\nvalue = 2\nwithin = 1e-3\n\
        [[expect]]\nstage = \"a\"\nwhat = \"last(kinetic)\"\nvalue = 2\nwithin = 1\n\
        [[expect]]\nwhat = \"max(kinetic)\"\nvalue = 0\nwithin = 0\n";

    #[test]
    fn without_being_asked_a_study_asks_what_is_answered() {
        assert_eq!(titles("", &[]), ["kinetic"]);
        let columns = "[history]\ncolumns = [\"dt\", \"rotational\", \"particle:1:x\"]\n";
        assert_eq!(titles(columns, &[]), ["rotational", "particle:1:x"]);
        // The wide band and the zero are left out.
        assert_eq!(titles(EXPECTS, &[]), ["last(particle:1:x)"]);
        let answer = format!(
            "{EXPECTS}[[answer]]\nto = \"place\"\nstage = \"a\"\nwhat = [\"last(particle:1:x)\"]\n\
             value = [0]\nscale = 3\n"
        );
        assert_eq!(titles(&answer, &[]), ["place in stage a"]);
    }

    #[test]
    fn what_is_expected_is_known_when_asked() {
        let asked = |what: &str| {
            let option = format!("study.for=[\"{what}\"]");
            questions(&scene(EXPECTS, &[&option]))
        };
        // Blanks and case do not matter.
        let known = asked("LAST( kinetic )");
        assert_eq!(known[0].title(), "last(kinetic) in stage a");
        assert!(known[0].is_known() && !known[0].is_absolute());
        let zero = asked("max(kinetic)");
        assert!(zero[0].is_known() && zero[0].is_absolute());
        assert!(!asked("min(kinetic)")[0].is_known());
        assert!(!asked("kinetic")[0].is_known());
    }
}

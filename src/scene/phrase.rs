//! Commands, conditions and quantities inside a preset: the language's complaint about a word,
//! pointed at that word.

use super::place::Place;
use super::problem::{Problem, Report};
use crate::language::Mistake;

/// What was understood; a mistake goes to the report.
pub(crate) fn accept<T>(
    report: &Report,
    understood: Result<T, Mistake>,
    text: &str,
    place: Place,
) -> Option<T> {
    understood
        .map_err(|mistake| report.add(problem(report, &mistake, text, place)))
        .ok()
}

fn problem(report: &Report, mistake: &Mistake, text: &str, place: Place) -> Problem {
    let place = place.within(text, mistake.span.clone(), &report.sources);
    Problem::new(mistake.message.as_str(), place).remedy(mistake.remedy.as_str())
}

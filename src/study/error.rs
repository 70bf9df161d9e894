//! How far a variant's answers are from the right ones, and how fast that falls with the step.
//!
//! - **Course** of a number over the history: the largest difference from the reference run at times
//!   at which both have a row, over the largest magnitude the number has in the reference run. No
//!   row is interpolated. The differences at the ends of stages stand beside it; stages that end by
//!   a condition end at other times, and their last rows are compared as they are.
//! - **Number** made of the rows: the difference from that of the reference run, over its magnitude.
//! - **Known** answers: the root mean square, over the answers to one question, of the length of the
//!   difference over the scale of the answer.

use super::question::{Asked, Kind};
use super::stability::Stability;
use super::trace::Trace;
use crate::language::{Expression, Quantity};
use crate::scene::Answer;

/// How a variant answers a question.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Judgement {
    /// What it answers, if that is one number; else NaN.
    pub value: f64,
    /// The error: relative, unless the question's is absolute. NaN if there is none.
    pub error: f64,
    /// Largest of the errors it is made of.
    pub largest: f64,
    /// Of a course: error at the end of each stage, NaN where there is none.
    pub ends: Vec<f64>,
    /// Why there is no error; else empty.
    pub why: String,
}

/// Said instead of an error of the run that the others are compared with.
pub const REFERENCE: &str = "reference";

impl Judgement {
    /// Of the run that the others are compared with: it has no error that is known.
    pub(super) fn of_reference(self) -> Self {
        Self {
            value: self.value,
            ends: vec![f64::NAN; self.ends.len()],
            ..Self::none(REFERENCE)
        }
    }

    pub(super) fn none(why: impl Into<String>) -> Self {
        Self {
            value: f64::NAN,
            error: f64::NAN,
            largest: f64::NAN,
            ends: Vec::new(),
            why: why.into(),
        }
    }
}

/// Times closer than this share of a step are the same.
const SAME_TIME: f64 = 1e-3;

/// Judges how a run answers a question. `reference` is the run to compare with, if there is one; an
/// unfinished run answers nothing.
pub fn judge(asked: &Asked, run: &Trace, reference: Option<&Trace>) -> Judgement {
    if !run.complete {
        return Judgement::none(match run.stability {
            Stability::Failed(_) => "the run failed",
            _ => "the run was not finished",
        });
    }
    match (&asked.kind, reference) {
        (Kind::Known(answers), _) => known(answers, run),
        (_, None) => Judgement::none("the reference run was not finished"),
        (Kind::Number(number), Some(reference)) => compared(number, asked, run, reference),
        (Kind::Course(course), Some(reference)) => followed(course, run, reference),
    }
}

fn measured(what: &Quantity, stage: Option<&str>, run: &Trace) -> Result<f64, String> {
    let rows = run.rows_of(stage);
    what.value(rows.len(), &mut |row, term| run.term(rows[row], term))
}

fn known(answers: &[Answer], run: &Trace) -> Judgement {
    let mut judgement = Judgement::default();
    let mut sum = 0.0;
    for answer in answers {
        let mut square = 0.0;
        for (what, exact) in &answer.parts {
            match measured(what, answer.stage.as_deref(), run) {
                Ok(value) => {
                    square += (value - exact) * (value - exact);
                    judgement.value = value;
                }
                Err(why) => return Judgement::none(why),
            }
        }
        let error = square.sqrt() / answer.scale;
        judgement.largest = judgement.largest.max(error);
        sum += error * error;
    }
    judgement.error = (sum / answers.len() as f64).sqrt();
    if answers.len() != 1 || answers[0].parts.len() != 1 {
        judgement.value = f64::NAN;
    }
    if judgement.error.is_nan() {
        judgement.why = "it is not defined".into();
    }
    judgement
}

fn compared(number: &Quantity, asked: &Asked, run: &Trace, reference: &Trace) -> Judgement {
    let stage = asked.stage.as_deref();
    let pair = measured(number, stage, run)
        .and_then(|value| Ok((value, measured(number, stage, reference)?)));
    match pair {
        Err(why) => Judgement::none(why),
        Ok((value, right)) => {
            let error = relative(value - right, right);
            Judgement {
                value,
                error,
                largest: error,
                ends: Vec::new(),
                why: if error.is_nan() {
                    "it is not defined".into()
                } else {
                    String::new()
                },
            }
        }
    }
}

/// A difference over a scale; over 1 if the scale is nothing.
fn relative(difference: f64, scale: f64) -> f64 {
    difference.abs() / if scale == 0.0 { 1.0 } else { scale.abs() }
}

fn followed(course: &Expression, run: &Trace, reference: &Trace) -> Judgement {
    let value = |of: &Trace, row: usize| course.number(&mut |term| of.term(row, term));
    let scale = scale_of(course, reference);
    let step = (run.time / run.cycles as f64).min(reference.time / reference.cycles as f64);
    let mut judgement = Judgement {
        value: value(run, run.rows() - 1),
        ..Judgement::none("no row is at a time of the reference run")
    };
    let mut other = 0;
    for row in 0..run.rows() {
        let time = run.time_of(row);
        let near = |other: usize| reference.time_of(other) - time;
        while other < reference.rows() && near(other) < -SAME_TIME * step {
            other += 1;
        }
        if other == reference.rows() || near(other) > SAME_TIME * step {
            continue;
        }
        let error = relative(value(run, row) - value(reference, other), scale);
        // What is not defined in both has no difference.
        if !error.is_nan() {
            judgement.error = error.max(judgement.error);
            judgement.why.clear();
        }
    }
    judgement.largest = judgement.error;
    for stage in run.stages() {
        let last = |of: &Trace| of.rows_of(Some(stage)).last().copied();
        judgement.ends.push(match (last(run), last(reference)) {
            (Some(a), Some(b)) => relative(value(run, a) - value(reference, b), scale),
            _ => f64::NAN,
        });
    }
    judgement
}

/// Largest magnitude of a number over the rows of a run.
pub fn scale_of(course: &Expression, run: &Trace) -> f64 {
    let rows = 0..run.rows();
    rows.map(|row| course.number(&mut |term| run.term(row, term)).abs())
        .fold(0.0, f64::max)
}

/// Errors below this are rounding, and have no order.
const ROUNDING: f64 = 1e-12;

/// Order of convergence p between two errors at two steps, if error = C (step^p - own^p), where
/// `own` is the step of the run they were measured against, 0 for an exact answer. NaN if there is
/// none: the error does not fall with the step, or is nothing but rounding.
pub fn order(errors: [f64; 2], steps: [f64; 2], own: f64) -> f64 {
    let ratio = errors[0] / errors[1];
    let sizes = steps[0] / steps[1];
    if !(ratio.is_finite() && ratio > 0.0 && sizes > 1.0 && errors[1] > ROUNDING) {
        return f64::NAN;
    }
    if own == 0.0 {
        return libm::log(ratio) / libm::log(sizes);
    }
    let fall = |p: f64| {
        let power = |step: f64| libm::expm1(p * libm::log(step / own));
        power(steps[0]) / power(steps[1])
    };
    let (mut low, mut high) = (1e-3, 20.0);
    if !(fall(low)..=fall(high)).contains(&ratio) {
        return f64::NAN;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if fall(middle) < ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// The error that the reference run itself has, by the error at another step and the order.
pub fn own_error(error: f64, step: f64, own: f64, order: f64) -> f64 {
    error / libm::expm1(order * libm::log(step / own))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_are_those_of_powers() {
        let error = |p: f64, step: f64, own: f64| step.powf(p) - own.powf(p);
        for p in [0.5, 1.0, 2.0, 3.0, 4.0] {
            for own in [0.0, 0.01, 0.019] {
                let steps = [0.05, 0.02];
                let errors = steps.map(|step| 7.0 * error(p, step, own));
                let found = order(errors, steps, own);
                assert!((found - p).abs() < 1e-9, "{p} {own}: {found}");
                if own > 0.0 {
                    let left = own_error(errors[1], steps[1], own, found);
                    assert!((left / (7.0 * own.powf(p)) - 1.0).abs() < 1e-6);
                    // Taking the reference for exact would give another order.
                    assert!((order(errors, steps, 0.0) - p).abs() > 0.05);
                }
            }
        }
    }

    #[test]
    fn errors_that_do_not_fall_have_no_order_or_a_poor_one() {
        assert_eq!(order([1e-3, 1e-3], [0.2, 0.1], 0.0), 0.0);
        assert!(order([1e-4, 1e-3], [0.2, 0.1], 0.0) < 0.0);
        assert!(order([1e-4, 1e-3], [0.2, 0.1], 0.05).is_nan());
        assert!(order([1e-4, 0.0], [0.2, 0.1], 0.0).is_nan());
        assert!(order([1e-4, 1e-13], [0.2, 0.1], 0.0).is_nan());
        assert!(order([f64::NAN, 1.0], [0.2, 0.1], 0.0).is_nan());
        assert!(order([1.0, 0.5], [0.1, 0.1], 0.0).is_nan());
    }
}

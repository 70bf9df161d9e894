//! How all variants answer a question, and how that changes with the step.

use super::error::{Judgement, judge, order, own_error, scale_of};
use super::plan::Plan;
use super::question::{Asked, Kind};
use super::trace::Trace;

/// How all variants answer a question.
#[derive(Debug, Clone, PartialEq)]
pub struct Replies {
    /// The right answer, if it is one number; else NaN.
    pub right: f64,
    /// What errors are relative to.
    pub scale: f64,
    /// Error of the reference run, extrapolated from those of the others; NaN if that is not known
    /// or nothing is compared with it.
    pub reference_error: f64,
    /// One per variant.
    pub judgements: Vec<Judgement>,
    /// Order of convergence between the next larger FRAC of the series and this one; NaN if none.
    pub orders: Vec<f64>,
}

impl Replies {
    /// Judges what the variants gave. `reference` is the run to compare with, if it was finished.
    pub(super) fn of(
        plan: &Plan,
        asked: &Asked,
        traces: &[Option<Trace>],
        reference: Option<&Trace>,
    ) -> Self {
        let judgements: Vec<Judgement> = traces
            .iter()
            .enumerate()
            .map(|(k, trace)| match trace {
                None => Judgement::none("not run"),
                Some(trace) => {
                    let judgement = judge(asked, trace, reference);
                    if k == plan.reference && !asked.is_known() && judgement.why.is_empty() {
                        judgement.of_reference()
                    } else {
                        judgement
                    }
                }
            })
            .collect();
        let (right, scale) = right(asked, &judgements[plan.reference], reference);
        let mut replies = Self {
            right,
            scale,
            reference_error: f64::NAN,
            orders: vec![f64::NAN; judgements.len()],
            judgements,
        };
        replies.compare_steps(plan, asked);
        replies
    }

    /// Orders of convergence, and from them the error of the reference.
    fn compare_steps(&mut self, plan: &Plan, asked: &Asked) {
        let own = &plan.variants[plan.reference];
        for (k, pair) in plan.variants.windows(2).enumerate() {
            let [before, this] = pair else { continue };
            if before.series != this.series {
                continue;
            }
            // The error of the reference shows only in runs that approach the same limit.
            let compared = !asked.is_known() && own.series == this.series;
            let step = if compared { own.dt } else { 0.0 };
            let errors = [k, k + 1].map(|k| self.judgements[k].error);
            let found = order(errors, [before.dt, this.dt], step);
            self.orders[k + 1] = found;
            if compared && found > 0.0 {
                self.reference_error = own_error(errors[1], this.dt, own.dt, found);
            }
        }
    }
}

/// The right answer if it is one number, and what errors are relative to.
fn right(asked: &Asked, own: &Judgement, reference: Option<&Trace>) -> (f64, f64) {
    match &asked.kind {
        Kind::Known(answers) => match answers.as_slice() {
            [one] if one.parts.len() == 1 => (one.parts[0].1, one.scale),
            [one] => (f64::NAN, one.scale),
            many => {
                let first = many.first().map_or(f64::NAN, |answer| answer.scale);
                let same = many.iter().all(|answer| answer.scale == first);
                (f64::NAN, if same { first } else { f64::NAN })
            }
        },
        Kind::Number(_) => (own.value, own.value.abs()),
        Kind::Course(course) => {
            let scale = reference.map_or(f64::NAN, |reference| scale_of(course, reference));
            (f64::NAN, scale)
        }
    }
}

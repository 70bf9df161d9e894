//! What a study prints.

use std::fmt::Write;

use crate::cli::aligned::aligned;
use crate::session::figure::{figure, per_cent, rough};
use crate::study::error::REFERENCE;
use crate::study::outcome::{Outcome, Run};
use crate::study::plan::Plan;
use crate::study::question::{Asked, Kind};
use crate::study::replies::Replies;
use crate::study::stability::Stability;

/// More stages than this are not shown one by one.
const STAGES: usize = 4;

/// The tables.
pub(super) fn report(outcome: &Outcome) -> String {
    let plan = &outcome.plan;
    let title = match plan.scene.about.title.as_str() {
        "" => String::new(),
        title => format!(": {title}"),
    };
    let mut text = format!("{}{title}\n\n", plan.scene.name);
    runs(&mut text, outcome);
    marks(&mut text, outcome);
    for (asked, replies) in plan.questions.iter().zip(&outcome.replies) {
        text.push('\n');
        question(&mut text, outcome, asked, replies);
    }
    let left_out = outcome.runs.iter().filter(|run| !run.was_run()).count();
    if left_out > 0 || !outcome.notes.is_empty() {
        text.push('\n');
    }
    if left_out > 0 {
        let all = outcome.runs.len();
        // A String takes every line.
        let _ = writeln!(text, "note: {left_out} of {all} variants not run");
    }
    for note in &outcome.notes {
        let _ = writeln!(text, "note: {note}");
    }
    text
}

/// What tells the variants apart: law, swept keys, FRAC.
struct Labels<'a> {
    plan: &'a Plan,
    runs: &'a [Run],
}

impl Labels<'_> {
    fn head(&self) -> Vec<String> {
        let sweeps = self.plan.scene.study.sweep.iter();
        let paths = sweeps.map(|sweep| sweep.path.clone());
        let law = std::iter::once("law".to_owned());
        law.chain(paths).chain(["frac".to_owned()]).collect()
    }

    fn of(&self, k: usize) -> Vec<String> {
        let variant = &self.plan.variants[k];
        let series = &self.plan.series[variant.series];
        let mut cells = vec![series.law.clone()];
        for setting in &series.settings {
            let (_, value) = setting.split_once('=').unwrap_or_default();
            cells.push(value.to_owned());
        }
        cells.push(figure(variant.frac));
        cells
    }

    /// Columns that are set to the left.
    fn left(&self) -> usize {
        self.head().len() - 1
    }

    /// A table with these labels in front; the cells of a row beyond the head follow as they are. What
    /// was not run has no row: there may be hundreds.
    fn table(&self, text: &mut String, indent: &str, head: &[&str], rows: Vec<Vec<String>>) {
        let mut all = vec![self.head()];
        all[0].extend(head.iter().map(|cell| (*cell).to_owned()));
        let rows = rows.into_iter().enumerate();
        for (k, row) in rows.filter(|(k, _)| self.runs[*k].was_run()) {
            let mut cells = self.of(k);
            cells.extend(row);
            all.push(cells);
        }
        let columns = all[0].len();
        for line in aligned(&all, self.left(), columns) {
            let _ = writeln!(text, "{indent}{line}");
        }
    }
}

fn runs(text: &mut String, outcome: &Outcome) {
    let head = [
        "cycles",
        "wall [s]",
        "spread",
        "particle-steps/s",
        "contact updates/s",
        "frac limit",
        "stable",
        "energy error",
        "error",
    ];
    let compared = outcome.plan.questions.iter().any(|asked| !asked.is_known());
    let rows = outcome.runs.iter().enumerate().map(|(k, run)| {
        let mut cells = row(run);
        if compared && k == outcome.plan.reference && outcome.has_reference {
            cells.pop();
            cells.push("reference".into());
        }
        let mut mark = String::new();
        if run.on_front {
            mark.push('*');
        }
        if outcome.fastest == Some(k) {
            mark.push('<');
        }
        cells.push(mark);
        cells
    });
    let labels = Labels {
        plan: &outcome.plan,
        runs: &outcome.runs,
    };
    labels.table(text, "", &head, rows.collect());
}

fn row(run: &Run) -> Vec<String> {
    let stable = match run.stability {
        Stability::Stable => "yes",
        Stability::Gained(_) => "no",
        Stability::Failed(_) => "failed",
        Stability::Unfinished => "not finished",
        Stability::NotRun => "not run",
    };
    vec![
        run.cycles.to_string(),
        known(run.timing.median()),
        match run.timing.spread() {
            spread if spread.is_nan() => "-".into(),
            spread => per_cent((100.0 * spread).round() / 100.0),
        },
        known(run.particle_steps),
        known(run.contact_updates),
        rough(run.frac_limit),
        stable.into(),
        known(run.energy_error),
        known(run.error),
    ]
}

/// Three digits, or a dash for what is not known.
fn known(number: f64) -> String {
    if number.is_nan() {
        "-".into()
    } else {
        rough(number)
    }
}

fn marks(text: &mut String, outcome: &Outcome) {
    if outcome.runs.iter().any(|run| run.on_front) {
        text.push_str(
            "*  on the Pareto front: no other stable variant is both faster and more exact\n",
        );
    }
    if let (Some(bound), Some(_)) = (outcome.plan.scene.study.within, outcome.fastest) {
        let bound = figure(bound);
        let _ = writeln!(text, "<  the fastest with an error within {bound}");
    }
}

fn question(text: &mut String, outcome: &Outcome, asked: &Asked, replies: &Replies) {
    let _ = writeln!(text, "{}", heading(outcome, asked, replies));
    let stages = &outcome.plan.scene.stages;
    let ends: Vec<String> = match asked.kind {
        Kind::Course(_) if stages.len() <= STAGES => {
            let names = stages.iter().map(|stage| format!("end of {}", stage.name));
            names.collect()
        }
        _ => Vec::new(),
    };
    let one = replies.judgements.iter().any(|found| !found.value.is_nan());
    let many = matches!(&asked.kind, Kind::Known(answers) if answers.len() > 1);
    let mut head = Vec::new();
    match asked.kind {
        Kind::Course(_) => head.push("at the end"),
        _ if one => head.push("answer"),
        _ => {}
    }
    head.extend(["error", "order"]);
    if many {
        head.push("largest");
    }
    head.extend(ends.iter().map(String::as_str));
    let rows = replies.judgements.iter().enumerate().map(|(k, found)| {
        let mut cells = Vec::new();
        if one || matches!(asked.kind, Kind::Course(_)) {
            cells.push(match found.value {
                value if value.is_nan() => "-".into(),
                value => figure(value),
            });
        }
        let is_reference = found.why == REFERENCE;
        cells.push(if is_reference {
            "reference".into()
        } else {
            known(found.error)
        });
        cells.push(match replies.orders[k] {
            order if order.is_nan() => String::new(),
            // Not -0.00.
            order => format!("{:.2}", (100.0 * order).round() / 100.0 + 0.0),
        });
        if many {
            cells.push(known(found.largest));
        }
        for at in 0..ends.len() {
            cells.push(match found.ends.get(at) {
                Some(error) if !is_reference => known(*error),
                _ => String::new(),
            });
        }
        cells.push(match found.why.as_str() {
            REFERENCE => String::new(),
            why => why.to_owned(),
        });
        cells
    });
    let labels = Labels {
        plan: &outcome.plan,
        runs: &outcome.runs,
    };
    labels.table(text, "  ", &head, rows.collect());
}

/// What is asked, what is right, and who says so.
fn heading(outcome: &Outcome, asked: &Asked, replies: &Replies) -> String {
    let mut line = asked.title();
    if replies.right.is_finite() {
        line = format!("{line} = {}", figure(replies.right));
    }
    line = match (&asked.kind, asked.is_absolute()) {
        (_, true) => format!("{line}; the error is absolute"),
        (Kind::Known(answers), _) if answers.len() > 1 => {
            format!("{line}; root mean square over {} answers", answers.len())
        }
        (Kind::Course(_), _) => format!(
            "{line}; largest difference over the largest magnitude, {}",
            figure(replies.scale)
        ),
        _ => line,
    };
    if asked.is_known() {
        return match asked.source.as_str() {
            "" => line,
            source => format!("{line}; {source}"),
        };
    }
    let reference = &outcome.runs[outcome.plan.reference].name;
    let own = match replies.reference_error {
        error if error.is_finite() => {
            format!(", whose own error should be about {}", rough(error))
        }
        _ => String::new(),
    };
    format!("{line}; against {reference}{own}")
}

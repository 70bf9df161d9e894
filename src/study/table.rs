//! The numbers of a study as CSV: a row for each variant and question, so that any program can pick
//! what it wants.

use super::outcome::Outcome;
use crate::record::number::Cell;

/// Names of the columns; units stand in their names, those without are ratios or counts.
pub const HEADER: [&str; 31] = [
    "variant",
    "law",
    "settings",
    "frac_asked",
    "frac",
    "dt_s",
    "cycles",
    "simulated_s",
    "wall_s",
    "wall_spread",
    "wall_runs",
    "particle_steps_per_s",
    "contact_updates_per_s",
    "frac_limit",
    "stability",
    "energy_error",
    "largest_error",
    "pareto",
    "fastest_within",
    "question",
    "stage",
    "compared_with",
    "right_answer",
    "scale",
    "absolute",
    "answer",
    "error",
    "error_largest",
    "error_at_end",
    "order",
    "remark",
];

/// The table.
pub fn csv(outcome: &Outcome) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut write = |cells: &[String]| {
        // A Vec takes every row.
        drop(writer.write_record(cells));
    };
    write(&HEADER.map(str::to_owned));
    for k in 0..outcome.runs.len() {
        for question in 0..outcome.replies.len() {
            write(&row(outcome, k, question));
        }
    }
    writer.into_inner().unwrap_or_default()
}

fn row(outcome: &Outcome, k: usize, question: usize) -> Vec<String> {
    let run = &outcome.runs[k];
    let plan = &outcome.plan;
    let variant = &plan.variants[k];
    let series = &plan.series[variant.series];
    let asked = &plan.questions[question];
    let replies = &outcome.replies[question];
    let judgement = &replies.judgements[k];
    let compared_with = if asked.is_known() {
        match asked.source.as_str() {
            "" => "the preset",
            source => source,
        }
    } else {
        &outcome.runs[plan.reference].name
    };
    let stability = match run.stability.reason() {
        "" => "stable",
        reason => reason,
    };
    let text = |text: &str| text.to_owned();
    let real = |number: f64| Cell::Real(number).text().into_owned();
    let flag = |flag: bool| text(if flag { "1" } else { "0" });
    vec![
        run.name.clone(),
        series.law.clone(),
        series.settings.join(" "),
        real(variant.asked),
        real(variant.frac),
        real(variant.dt),
        run.cycles.to_string(),
        real(run.time),
        real(run.timing.median()),
        real(run.timing.spread()),
        run.timing.runs().to_string(),
        real(run.particle_steps),
        real(run.contact_updates),
        real(run.frac_limit),
        text(stability),
        real(run.energy_error),
        real(run.error),
        flag(run.on_front),
        flag(outcome.fastest == Some(k)),
        asked.text.clone(),
        asked.stage.clone().unwrap_or_default(),
        text(compared_with),
        real(replies.right),
        real(replies.scale),
        flag(asked.is_absolute()),
        real(judgement.value),
        real(judgement.error),
        real(judgement.largest),
        real(judgement.ends.last().copied().unwrap_or(f64::NAN)),
        real(replies.orders[k]),
        judgement.why.clone(),
    ]
}

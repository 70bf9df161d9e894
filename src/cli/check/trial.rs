//! The first cycles of the run: how its step stands, and how long it will take.

use super::{Report, duration};
use crate::scene::{Scene, Stage};
use crate::session::figure::figure;
use crate::study::trial::Trial;

/// Limit, stages and length.
pub(super) fn describe(report: &mut Report, scene: &Scene, trial: &Trial) {
    let world = trial.session.world();
    let done = world.cycle_number();
    let (cycle, frac, limit) = trial.nearest;
    let first = if trial.first.is_finite() {
        format!("{} at the start", figure(trial.first))
    } else {
        "not known at the start, nothing touches".into()
    };
    let later = if limit.is_finite() {
        format!("lowest {} at cycle {cycle}", figure(limit))
    } else {
        "nothing touches".into()
    };
    let text = format!("{first}; in the first {} {later}", cycles(done));
    report.line("frac limit", text);
    if frac > limit {
        report.warnings.push(format!(
            "frac = {} is above the limit {} at cycle {cycle}: expect instability, reduce \
                 model.frac",
            figure(frac),
            figure(limit)
        ));
    }
    if let Some((cycle, particle, fracc)) = world.fracc_monitor().worst {
        report.warnings.push(format!(
            "fracc = {} at cycle {cycle} by particle {particle} (above 0.3 in {} of the first \
                 {}): its forces changed faster than the step resolves, or it hardly moved",
            figure(fracc),
            world.fracc_monitor().warnings,
            cycles(done)
        ));
    }
    if let Some(failure) = &trial.failure {
        report.warnings.push(format!("the run fails: {failure}"));
    }
    report.lines("stages", &stages(scene));
    report.line("length", length(scene, trial));
}

fn length(scene: &Scene, trial: &Trial) -> String {
    let rate = trial.rate();
    match trial.most() {
        Some(most) if most > 0 => {
            let open = scene.stages.iter().any(|stage| stage.until.is_some());
            format!(
                "{}{} = {} s, {} here ({} cycles/s)",
                if open { "at most " } else { "" },
                cycles(most),
                figure(most as f64 * trial.session.world().dt()),
                duration(most as f64 / rate),
                figure(rate.round())
            )
        }
        _ => format!("no end given; {} cycles/s here", figure(rate.round())),
    }
}

fn cycles(number: u64) -> String {
    match number {
        1 => "cycle".into(),
        _ => format!("{number} cycles"),
    }
}

/// One line for each.
fn stages(scene: &Scene) -> Vec<String> {
    if scene.stages.is_empty() {
        return vec!["none".into()];
    }
    let stage = |stage: &Stage| match (&stage.until, stage.max_cycles) {
        (None, None) => stage.name.clone(),
        (None, Some(cycles)) => format!("{}: {cycles} cycles", stage.name),
        (Some(until), None) => format!("{}: until {until}", stage.name),
        (Some(until), Some(cycles)) => {
            format!("{}: until {until}, at most {cycles} cycles", stage.name)
        }
    };
    scene.stages.iter().map(stage).collect()
}

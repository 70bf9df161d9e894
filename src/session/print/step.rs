//! PRINT STEP: the time step, its limits and what came near them.

use super::super::figure::figure;
use super::layout::listed;
use crate::engine::World;
use crate::engine::setup::TimeStepChoice;
use crate::engine::time_step::FRACC_WARNING;

/// The table.
pub(super) fn lines(world: &World) -> Vec<String> {
    let model = world.model();
    let seconds = |x: f64| format!("{} s", figure(x));
    let base = match model.time_step {
        TimeStepChoice::Rayleigh => "Rayleigh wave across the mean particle",
        TimeStepChoice::RayleighExact => {
            "Rayleigh wave across the mean particle, root of the wave equation"
        }
        TimeStepChoice::Critical => "critical, 2 sqrt(smallest mass/largest stiffness)",
        TimeStepChoice::Seconds(_) => "given in the preset",
    };
    let monitor = world.fracc_monitor();
    let seen = |seen: Option<(u64, u32, f64)>| match seen {
        Some((cycle, id, fracc)) => format!("{} at cycle {cycle}, ball {id}", figure(fracc)),
        None => "none".into(),
    };
    let largest = monitor
        .largest
        .map_or_else(|| "not evaluated since".into(), figure);
    listed(&[
        ("cycle", world.cycle_number().to_string()),
        ("time", seconds(world.time())),
        ("dt", seconds(world.dt())),
        (
            "base step",
            format!("{}: {base}", seconds(world.base_step())),
        ),
        ("frac", frac(world)),
        ("frac limit", limit(world)),
        ("largest FRACC since the last row", largest),
        (
            "cycles with FRACC above the warning",
            format!(
                "{}, the warning is at {}",
                monitor.warnings,
                figure(FRACC_WARNING)
            ),
        ),
        ("last of them", seen(monitor.last)),
        ("worst of them", seen(monitor.worst)),
        (
            "tol",
            format!(
                "{} m{}",
                figure(world.tol()),
                if world.tol_is_mean() {
                    " in the mean"
                } else {
                    ""
                }
            ),
        ),
        (
            "neighbour lists made",
            world.contacts().rebuilds.to_string(),
        ),
    ])
}

/// The multiple of the base step, and whether it follows the bound.
fn frac(world: &World) -> String {
    let now = figure(world.frac());
    let Some(share) = world.model().frac_auto else {
        return now;
    };
    let changes = world.step_changes();
    let last = changes
        .last
        .map_or_else(String::new, |(cycle, before, after)| {
            format!(
                ", last at cycle {cycle} from {} s to {} s",
                figure(before),
                figure(after)
            )
        });
    let count = changes.count;
    format!(
        "{now}, auto: {} of the bound; {count} changes{last}",
        figure(share)
    )
}

/// The stability bound and the particle that sets it.
fn limit(world: &World) -> String {
    let particles = world.particles();
    let steps = (0..particles.len()).map(|p| (particles.id[p], world.stable_step_of(p)));
    match steps.min_by(|a, b| a.1.total_cmp(&b.1)) {
        Some((id, step)) if step.is_finite() => format!(
            "{} by the stiffness bound, set by ball {id}",
            figure(step / world.base_step())
        ),
        _ => "none: nothing that moves freely touches".into(),
    }
}

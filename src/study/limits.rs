//! The largest FRAC with which an experiment stays stable, by bisection.

use super::Beat;
use super::plan::{NoPlan, Series, all_series};
use super::trace::opened;
use super::variant::unfitted;
use super::watch::{Teller, Watch};
use crate::scene::Scene;
use crate::session::Session;
use crate::session::figure::figure;

/// The largest FRAC with which a series runs through and stays stable.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// What was run.
    pub series: Series,
    /// Largest FRAC that was seen to be stable; 0 if none was.
    pub stable: f64,
    /// Smallest FRAC above it that was not; `None` if none was found.
    pub unstable: Option<f64>,
    /// What happened there; or why none was found.
    pub reason: String,
    /// Smallest `frac_limit` seen in the run at `stable`.
    pub frac_limit: f64,
    /// Number of runs it took.
    pub runs: usize,
}

/// The two are at most this factor apart.
const CLOSE: f64 = 1.01;

/// So many doublings or halvings of the preset's FRAC are tried.
const DOUBLINGS: usize = 12;

/// Finds the limit of every series of a study by bisection. Ends early when the listener wants no
/// more: then the last limit is as close as it came, and later ones are missing.
pub fn limits(
    scene: &Scene,
    threads: usize,
    listen: &mut dyn FnMut(Beat<'_>) -> bool,
) -> Result<Vec<Limit>, NoPlan> {
    let mut teller = Teller {
        done: 0,
        of: 0,
        listen,
        stopped: false,
    };
    let mut found = Vec::new();
    for series in all_series(scene) {
        found.push(limit(scene, series, threads, &mut teller)?);
        if teller.stopped {
            break;
        }
    }
    Ok(found)
}

/// A run of the search.
struct Tried {
    /// Why it was not stable, if it was not.
    reason: Option<String>,
    frac_limit: f64,
    cycles: u64,
}

/// What runs away multiplies from cycle to cycle; a run of fewer cycles shows nothing.
const TELLING: u64 = 50;

fn limit(
    scene: &Scene,
    series: Series,
    threads: usize,
    teller: &mut Teller<'_>,
) -> Result<Limit, NoPlan> {
    let mut limit = Limit {
        series,
        stable: 0.0,
        unstable: None,
        reason: String::new(),
        frac_limit: f64::NAN,
        runs: 0,
    };
    let mut frac = scene.setup.frac;
    loop {
        let tried = attempt(scene, &limit.series, frac, threads, teller)?;
        if teller.stopped {
            return Ok(limit);
        }
        limit.runs += 1;
        teller.done += 1;
        match tried.reason {
            None if tried.cycles < TELLING => {
                limit.reason = format!(
                    "with frac = {} the run has {} cycles, too few to tell",
                    figure(frac),
                    tried.cycles
                );
                return Ok(limit);
            }
            None => {
                limit.stable = frac;
                limit.frac_limit = tried.frac_limit;
            }
            Some(reason) => {
                limit.unstable = Some(frac);
                limit.reason = reason;
            }
        }
        frac = match limit.unstable {
            _ if limit.runs > DOUBLINGS && (limit.stable == 0.0 || limit.unstable.is_none()) => {
                return Ok(limit);
            }
            Some(unstable) if limit.stable == 0.0 => 0.5 * unstable,
            Some(unstable) if unstable <= CLOSE * limit.stable => return Ok(limit),
            Some(unstable) => (unstable * limit.stable).sqrt(),
            None => 2.0 * limit.stable,
        };
    }
}

/// Runs until the end, or until energy has come from nothing.
fn attempt(
    scene: &Scene,
    series: &Series,
    frac: f64,
    threads: usize,
    teller: &mut Teller<'_>,
) -> Result<Tried, NoPlan> {
    let variant = unfitted(scene, series, frac)?;
    let name = format!("{} with frac = {}", series.name(), figure(frac));
    let mut session = opened(&variant, Vec::new(), threads).map_err(NoPlan::Failed)?;
    let mut watch = Watch::default();
    let mut beat =
        |watch: &Watch, session: &Session| !watch.has_gained() && teller.tell(&name, session);
    watch.run(&mut session, &mut beat).map_err(NoPlan::Failed)?;
    let verdict = watch.verdict();
    Ok(Tried {
        reason: (!verdict.is_stable()).then(|| verdict.reason().to_owned()),
        frac_limit: watch.frac_limit(),
        cycles: session.world().cycle_number(),
    })
}

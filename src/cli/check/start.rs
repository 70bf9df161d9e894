//! What a scene starts from; and what can be said of it before that is there.

use super::{Report, duration};
use crate::cli::output::unopened;
use crate::scene::{Keep, Scene, Source};
use crate::session::start::{is_ready, preparation};
use crate::session::{Options, Session};
use crate::study::trial::Trial;

/// A sample that takes longer to prepare is not prepared only to be looked at [s].
const PATIENCE: f64 = 10.0;

/// Says what it starts from, and whether the rest can be told too; or the exit status.
pub(super) fn describe(report: &mut Report, scene: &Scene) -> Result<bool, u8> {
    let Some(start) = &scene.start else {
        return Ok(true);
    };
    let kept = match start.keep {
        Keep::Particles => "particles and walls, at rest; forces follow from the overlaps",
        Keep::All => "the whole state",
    };
    let from = match &start.from {
        Source::File(file) => file.clone(),
        Source::Preset { name, stage, set } => {
            let stage = stage.as_ref().map(|stage| format!("stage {stage} of "));
            let with = if set.is_empty() {
                String::new()
            } else {
                format!(" with {}", set.join(", "))
            };
            format!("the end of {}{name}{with}", stage.unwrap_or_default())
        }
    };
    report.line("starts from", format!("{from}: {kept}"));
    let options = Options::default();
    if is_ready(scene, &options) {
        return Ok(true);
    }
    let run = preparation(scene).map_err(|error| unopened(&error))?;
    let Some(run) = run.filter(|run| is_ready(run, &options)) else {
        report.line(
            "sample",
            "prepared when it is first run; nothing else can be told before",
        );
        return Ok(false);
    };
    let opened = Session::open(run, options).map_err(|error| unopened(&error))?;
    let estimate = Trial::of(opened).estimate();
    if estimate.is_some_and(|seconds| seconds <= PATIENCE) {
        return Ok(true);
    }
    let long = estimate.map_or("nobody knows how long".into(), |seconds| {
        format!("at most {}", duration(seconds))
    });
    report.line(
        "sample",
        format!(
            "prepared when it is first run, which takes {long}, and kept for later runs; sizes, step \
             and length can be told then"
        ),
    );
    Ok(false)
}
